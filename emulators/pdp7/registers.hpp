// The registers of the processor in the form that its instructions use: L and AC side by side in one host word, PC as an
// offset in its bank. state.hpp has them in the form that other code uses.
#pragma once

#include <cstdint>

#include "../core/word.hpp"
#include "state.hpp"

namespace sightline::pdp7 {

// The flip-flops of State outside L, AC, MQ, SC and PC; those of the saved word have the same bits as in it.
namespace mode {
inline constexpr std::uint32_t extend = 0200000, trap = 0100000, extend_restore = 01, interrupts_on = 02,
                               interrupts_deferred = 04;
}

// L in bit 18 above AC. Bits above L are undefined: carries of additions remain there.
class Accumulator {
 public:
  constexpr Accumulator() = default;
  constexpr Accumulator(core::Word18 ac, bool link) : bits_(ac.value() | (link ? carry : 0)) {}
  explicit constexpr Accumulator(std::uint32_t bits) : bits_(bits) {}
  [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }

  [[nodiscard]] constexpr core::Word18 ac() const { return core::Word18(bits_); }
  [[nodiscard]] constexpr bool link() const { return (bits_ & carry) != 0; }
  constexpr void set_ac(core::Word18 word) { bits_ = (bits_ & carry) | word.value(); }
  constexpr void set_link(bool link) { bits_ = (bits_ & core::Word18::mask) | (link ? carry : 0); }

  // The carry out of bit 0 complements L.
  constexpr void add(core::Word18 word) { bits_ += word.value(); }
  constexpr void exclusive_or(core::Word18 word) { bits_ ^= word.value(); }
  constexpr void and_(core::Word18 word) { bits_ &= word.value() | ~core::Word18::mask; }

  static constexpr std::uint32_t carry = core::Word18::mask + 1;

 private:
  std::uint32_t bits_ = 0;
};

struct Registers {
  constexpr Registers() = default;
  explicit constexpr Registers(const State& state)
      : accumulator(state.ac, state.link),
        place(state.pc & in_bank_mask),
        bank(state.pc & bank_mask),
        mq(state.mq),
        sc(state.sc),
        modes((state.interrupts_on ? mode::interrupts_on : 0U) |
              (state.interrupts_deferred ? mode::interrupts_deferred : 0U) |
              (state.extend ? mode::extend : 0U) | (state.extend_restore ? mode::extend_restore : 0U) |
              (state.trap_mode ? mode::trap : 0U)) {}

  [[nodiscard]] constexpr bool is(std::uint32_t flip_flops) const { return (modes & flip_flops) != 0; }
  [[nodiscard]] constexpr Address pc() const { return bank | place; }
  [[nodiscard]] constexpr State state() const {
    return {.ac = accumulator.ac(),
            .mq = mq,
            .sc = sc,
            .pc = pc(),
            .link = accumulator.link(),
            .interrupts_on = is(mode::interrupts_on),
            .interrupts_deferred = is(mode::interrupts_deferred),
            .extend = is(mode::extend),
            .extend_restore = is(mode::extend_restore),
            .trap_mode = is(mode::trap)};
  }

  Accumulator accumulator;
  Address place = 0;  // PC without its bank
  Address bank = 0;
  core::Word18 mq;
  core::Word<6> sc;
  std::uint32_t modes = 0;
};

}  // namespace sightline::pdp7
