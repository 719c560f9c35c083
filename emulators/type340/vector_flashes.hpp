// The flashes of a vector that flashes at every pulse, put into memory one after the other: a few host instructions each,
// because a page takes a hundred million of them a second.
//
// x and y lie in one host word with what is the same in all flashes, so that a pulse is one addition. Their sum is exact although
// fields may borrow from each other on the way: a vector that stays on the screen ends every pulse with each in its range.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "../core/inline.hpp"
#include "../core/stroke.hpp"
#include "../core/time.hpp"
#include "delays.hpp"

namespace sightline::type340 {

class VectorFlashes {
 public:
  // Each stage that carries something moves the beam by `right` and `up` points, modulo 2^16, where its bit of `steps_x` and
  // `steps_y` is 1 (steps_by_stage()). `from`: the time of the first flash, and the place before it.
  VectorFlashes(const core::Stroke& from, unsigned steps_x, unsigned steps_y, std::int32_t right, std::int32_t up) {
    std::memcpy(&flash_, &from, sizeof flash_);
    const std::uint64_t move_x = static_cast<std::uint64_t>(std::int64_t{right}) * unit_x;
    const std::uint64_t move_y = static_cast<std::uint64_t>(std::int64_t{up}) * unit_y;
    for (unsigned stage = 0; stage < moves_.size(); ++stage)
      moves_[stage] = (move_x & (0U - std::uint64_t{steps_x >> stage & 1U})) + (move_y & (0U - std::uint64_t{steps_y >> stage & 1U}));
  }

  // All 7, 15, 31, 63 or 127 of them.
  void put(core::Stroke* to, int count) {
    // Pulse n turns on the stage with the number of zeros at the end of n: 0 1 0 2 0 1 0, one of the others, and so on.
    std::array<std::uint64_t, 8> sums{};
    for (unsigned n = 1; n < 8; ++n) sums[n] = sums[n - 1] + moves_[static_cast<unsigned>(std::countr_zero(n))];
    for (unsigned eight = 8;; eight += 8, to += 8) {
      for (unsigned n = 1; n < 8; ++n) put_one(to + (n - 1), {flash_.time + (n - 1) * pulse, flash_.place + sums[n]});
      if (eight > static_cast<unsigned>(count)) return;
      flash_.time += 8 * pulse;
      flash_.place += sums[7] + moves_[static_cast<unsigned>(std::countr_zero(eight))];
      put_one(to + 7, {flash_.time - pulse, flash_.place});
    }
  }

 private:
  // A stroke.
  struct Words {
    std::int64_t time;
    std::uint64_t place;
  };
  static_assert(sizeof(core::Stroke) == sizeof(Words) && std::is_trivially_copyable_v<core::Stroke>);
  static constexpr std::int64_t pulse = timing::pulse.count();
  static constexpr bool little = std::endian::native == std::endian::little;
  static constexpr std::uint64_t unit_x = std::uint64_t{1} << (little ? 0 : 48), unit_y = std::uint64_t{1} << (little ? 16 : 32);

  SIGHTLINE_INLINE static void put_one(core::Stroke* to, Words words) { std::memcpy(static_cast<void*>(to), &words, sizeof words); }

  Words flash_;
  std::array<std::uint64_t, 7> moves_;
};

}  // namespace sightline::type340
