// The registers that a PDP-7 program can see, and the word that saves them.
//
// MA, MB and IR are used only within one instruction and are not stored. Source: PDP-4 manual page 17; the extend and trap
// bits follow the Type 148 and the trap option of the PDP-7.
#pragma once

#include <cstdint>

#include "../core/state_visitor.hpp"
#include "../core/word.hpp"

namespace sightline::pdp7 {

// A 15-bit core address; without the Type 148 only the low 13 bits are ever non-zero.
using Address = std::uint32_t;

inline constexpr Address bank_mask = 060000;     // which 8K bank
inline constexpr Address in_bank_mask = 017777;  // offset in the bank
inline constexpr Address address_mask = 077777;

struct State {
  core::Word18 ac;
  core::Word18 mq;
  core::Word<6> sc;  // step counter of the EAE, counting down to 0
  Address pc = 0;    // 15 bits
  bool link = false;
  bool interrupts_on = false;
  bool interrupts_deferred = false;  // ION was the last instruction: one more runs before a break
  bool extend = false;               // Type 148: indirect addresses have 15 bits
  bool extend_restore = false;       // EMIR was executed: the next JMP I restores extend mode
  bool trap_mode = false;            // IOT, HLT and XCT of XCT trap

  void visit_state(core::StateVisitor& visit) {
    visit("ac", ac);
    visit("mq", mq);
    visit("sc", sc);
    visit("pc", pc, address_mask);
    visit("link", link);
    visit("interrupts_on", interrupts_on);
    visit("interrupts_deferred", interrupts_deferred);
    visit("extend", extend);
    visit("extend_restore", extend_restore);
    visit("trap_mode", trap_mode);
  }

  friend constexpr bool operator==(const State&, const State&) = default;
};

}  // namespace sightline::pdp7
