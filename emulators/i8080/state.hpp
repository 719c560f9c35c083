// The registers of the 8080, and its state between instructions.
//
// The 8080 keeps its registers in pairs, and so does this; a single register is half of a pair. Bits 3 and 5 of F read 0
// and bit 1 reads 1 (measured: POP PSW cannot change them).
#pragma once

#include <cstdint>

#include "../core/state_visitor.hpp"
#include "isa.hpp"

namespace sightline::i8080 {

using Byte = std::uint8_t;
using Address = std::uint16_t;

[[nodiscard]] constexpr Byte high(Address pair) { return static_cast<Byte>(pair >> 8); }
[[nodiscard]] constexpr Byte low(Address pair) { return static_cast<Byte>(pair); }
[[nodiscard]] constexpr Address joined(Byte high_byte, Byte low_byte) {
  return static_cast<Address>(high_byte << 8 | low_byte);
}

// F with its constant bits as the machine has them.
[[nodiscard]] constexpr Byte as_flags(Byte value) {
  return static_cast<Byte>((value & flag::all) | flag::always_one);
}

struct Registers {
  Byte a = 0;
  Byte f = flag::always_one;
  Address bc = 0;
  Address de = 0;
  Address hl = 0;
  Address sp = 0;
  Address pc = 0;

  friend constexpr bool operator==(const Registers&, const Registers&) = default;
};

// The state that decides after an instruction what comes next.
struct Control {
  bool interrupts_on = false;  // INTE
  bool deferred = false;       // the last instruction was EI: INT is not sampled after it
  bool halted = false;         // HLT was executed and has not been ended

  friend constexpr bool operator==(const Control&, const Control&) = default;
};

struct State : Registers, Control {
  void visit_state(core::StateVisitor& visit) {
    visit("a", a);
    visit("f", f);
    visit("bc", bc);
    visit("de", de);
    visit("hl", hl);
    visit("sp", sp);
    visit("pc", pc);
    visit("interrupts_on", interrupts_on);
    visit("deferred", deferred);
    visit("halted", halted);
    visit.require(f == as_flags(f), "f", "flags with bits 3 and 5 clear and bit 1 set");
  }

  friend constexpr bool operator==(const State&, const State&) = default;
};

}  // namespace sightline::i8080
