// The data elements of Jones's program as they lie in core: vectors, chains, addresses.
// Source: Jones (1971) Fig. 6; firmware/pdp7/jones/SPECIFICATION.md sections 2 and 7.
#pragma once

#include <cstdint>
#include <span>

#include "emulators/core/word.hpp"
#include "host/guests/jones/twin/twin.hpp"

namespace sightline::guests::jones {

inline constexpr std::uint32_t address_mask = core_words - 1;

// A sum as 18-bit two's complement.
[[nodiscard]] inline std::int32_t wrapped(std::int64_t value) {
  return core::Word18(static_cast<std::uint32_t>(value)).twos_complement();
}

// Core words by address; addresses wrap at 13 bits, and what the image does not hold is zero.
class CoreImage {
 public:
  explicit CoreImage(std::span<const core::Word18> words) : words_(words) {}
  [[nodiscard]] core::Word18 operator[](std::uint32_t address) const {
    const std::uint32_t at = address & address_mask;
    return at < words_.size() ? words_[at] : core::Word18();
  }
  [[nodiscard]] std::int32_t number(std::uint32_t address) const {
    return (*this)[address].twos_complement();
  }

 private:
  std::span<const core::Word18> words_;
};

struct Vector {
  explicit Vector(core::Word18 word)
      : actual_line(word.bit(0)),
        axis_code(word.field(1, 2)),
        negative(word.bit(3)),
        magnitude(static_cast<std::int32_t>(word.field(4, 17)) - (negative ? 040000 : 0)) {}
  bool actual_line;         // F
  std::uint32_t axis_code;  // A: 1, 2, 3 for i, j, k; 0 is no vector of this program
  bool negative;
  std::int32_t magnitude;  // object units, -16384..16383
};

// X Y Z n and what follows: the lines of a cell, or the ring of an opening.
struct Chain {
  std::uint32_t element;  // address of X
  SpacePoint origin;      // relative to the eye
  std::uint32_t count;    // n, 0..2^18-1
  [[nodiscard]] std::uint32_t first() const { return element + 4; }
};

// axis_code: 1..3.
[[nodiscard]] inline std::int32_t SpacePoint::*coordinate(std::uint32_t axis_code) {
  return axis_code == 1 ? &SpacePoint::x : axis_code == 2 ? &SpacePoint::y : &SpacePoint::z;
}

// vector: axis_code 1..3.
[[nodiscard]] inline Axis axis_of(const Vector& vector) {
  return Axis{static_cast<std::uint8_t>(vector.axis_code)};
}

}  // namespace sightline::guests::jones
