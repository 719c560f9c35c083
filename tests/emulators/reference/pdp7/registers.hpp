// The registers of the processor in the form its common instructions need: few host words, PC beside its
// bank, the carry of an addition taken into L without a test. state.hpp has them in the form that other code
// uses.
#pragma once

#include <cstdint>

#include "emulators/core/inline.hpp"
#include "emulators/core/word.hpp"
#include "emulators/pdp7/state.hpp"

namespace sightline::reference {
using namespace pdp7;


// The flip-flops of State that are not part of L, AC, MQ, SC or PC.
namespace mode {
inline constexpr std::uint32_t extend = 01, extend_restore = 02, trap = 04, interrupts_on = 010,
                               interrupts_deferred = 020;
}

class Registers {
 public:
  SIGHTLINE_INLINE constexpr explicit Registers(const State& state) : ac(state.ac), mq(state.mq), sc(state.sc) {
    set_pc(state.pc);
    set_link(state.link);
    modes_ = (state.interrupts_on ? mode::interrupts_on : 0U) |
             (state.interrupts_deferred ? mode::interrupts_deferred : 0U) |
             (state.extend ? mode::extend : 0U) | (state.extend_restore ? mode::extend_restore : 0U) |
             (state.trap_mode ? mode::trap : 0U);
  }

  [[nodiscard]] SIGHTLINE_INLINE constexpr State state() const {
    return {.ac = ac,
            .mq = mq,
            .sc = sc,
            .pc = pc_,
            .link = link(),
            .interrupts_on = is(mode::interrupts_on),
            .interrupts_deferred = is(mode::interrupts_deferred),
            .extend = is(mode::extend),
            .extend_restore = is(mode::extend_restore),
            .trap_mode = is(mode::trap)};
  }
  [[nodiscard]] SIGHTLINE_INLINE constexpr core::Word18 saved_word() const { return pdp7::saved_word(state()); }

  [[nodiscard]] SIGHTLINE_INLINE constexpr bool is(std::uint32_t modes) const { return (modes_ & modes) != 0; }
  SIGHTLINE_INLINE constexpr void set(std::uint32_t modes) { modes_ |= modes; }
  SIGHTLINE_INLINE constexpr void clear(std::uint32_t modes) { modes_ &= ~modes; }

  [[nodiscard]] SIGHTLINE_INLINE constexpr Address pc() const { return pc_; }
  [[nodiscard]] SIGHTLINE_INLINE constexpr Address bank() const { return bank_; }
  SIGHTLINE_INLINE constexpr void set_pc(Address address) {
    pc_ = address & address_mask;
    bank_ = address & bank_mask;
  }
  // To `place` (13 bits) in `bank`, which spares the common jump the masks.
  SIGHTLINE_INLINE constexpr void set_pc(Address bank, Address place) {
    pc_ = bank | place;
    bank_ = bank;
  }
  // To the next word of the same bank: 17777 is followed by 00000.
  SIGHTLINE_INLINE constexpr void skip() { pc_ = bank_ | ((pc_ + 1) & in_bank_mask); }
  // The value of PC before it stepped to here.
  [[nodiscard]] SIGHTLINE_INLINE constexpr Address before() const { return bank_ | ((pc_ - 1) & in_bank_mask); }

  [[nodiscard]] SIGHTLINE_INLINE constexpr bool link() const { return (link_ & carry) != 0; }
  SIGHTLINE_INLINE constexpr void set_link(bool link) { link_ = link ? carry : 0; }
  // A carry out of bit 0 of `sum`, the 19-bit sum of two words, complements L.
  SIGHTLINE_INLINE constexpr void add_carry(std::uint32_t sum) { link_ ^= sum; }

  core::Word18 ac;
  core::Word18 mq;
  core::Word<6> sc;

 private:
  static constexpr std::uint32_t carry = core::Word18::mask + 1;

  Address pc_ = 0;
  Address bank_ = 0;        // that of pc_
  std::uint32_t link_ = 0;  // only the bit `carry` counts
  std::uint32_t modes_ = 0;
};

}  // namespace sightline::reference
