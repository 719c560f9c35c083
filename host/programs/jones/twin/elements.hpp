// The data of Jones's program in core: the data elements of a scene with the outline of an opening,
// and the display file. Source: Jones (1971) Fig. 6; firmware/pdp7/jones/SPECIFICATION.md sections 2, 4, 5
// and 7.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "emulators/core/word.hpp"
#include "host/programs/jones/twin/arithmetic.hpp"
#include "host/programs/jones/twin/twin.hpp"

namespace sightline::programs::jones {

inline constexpr std::uint32_t address_mask = core_words - 1;

// A sum as 18-bit two's complement.
[[nodiscard]] inline std::int32_t wrapped(std::int64_t value) {
  return core::Word18(static_cast<std::uint32_t>(value)).twos_complement();
}

// Core words by address; addresses wrap at 13 bits, and words outside the image are zero.
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
  std::uint32_t axis_code;  // A: 1, 2, 3 for i, j, k; 0 does not occur in this program
  bool negative;
  std::int32_t magnitude;  // object units, -16384..16383
};

// X Y Z n and the words after it: the lines of a cell, or the ring of an opening.
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

// Pulls the outline of an opening into the visible bound, corner by corner.
//
// Clipping its sides one by one, as lines are clipped, would lose the corners of the bound: an opening all around the bound
// has no side inside it. Moving each corner to the nearest point of the bound keeps exactly the part of the opening inside
// the bound; the parts moved onto the bound lie outside every window. Source: firmware/pdp7/jones/SPECIFICATION.md section
// 4.
class RingBound {
 public:
  // plane: the axis normal to the opening; plane_coordinate: of the opening on that axis, relative to the eye; largest: of
  // a word.
  RingBound(Axis plane, std::int32_t plane_coordinate, std::int32_t bound_factor,
            std::int32_t largest = largest_word);

  // corner (rho in the specification): a corner of the ring. Returns it moved into the bound.
  [[nodiscard]] SpacePoint into_bound(SpacePoint corner) const;
  // The point where a vector along k, between the moved positions of its ends, leaves the side of the bound; nullopt if it
  // does not.
  [[nodiscard]] std::optional<SpacePoint> bend(const SpaceSegment& vector) const;

 private:
  Axis plane_;
  std::int32_t bound_factor_;
  std::int32_t largest_;
  std::int32_t nearest_;  // least z at which the plane is inside the bound
};

// The display file of Jones's program: Type 340 words for line pieces.
// Source: firmware/pdp7/jones/SPECIFICATION.md section 5; word formats, Type 340 manual.
class DisplayFile {
 public:
  enum class Outcome : std::uint8_t { drawn, no_length, full };

  // capacity: in words, the stop included; joining: pieces that continue each other share their set-up words; truncate: a
  // long line is divided into vectors by truncated instead of rounded quotients.
  DisplayFile(std::size_t capacity, bool joining, bool truncate = false);
  // A line from a to b, points of the screen.
  [[nodiscard]] Outcome add(ScreenPoint a, ScreenPoint b, Operations& operations);
  // Adds the stop and ends the file.
  [[nodiscard]] std::vector<core::Word18> finish() &&;

 private:
  void add_vectors(std::int32_t dx, std::int32_t dy, std::int32_t count, Operations& operations);

  std::size_t capacity_;
  bool joining_;
  ShortWords number_;
  std::vector<core::Word18> words_;
  std::optional<ScreenPoint> beam_;  // end of the last piece, in points of the screen
};

}  // namespace sightline::programs::jones
