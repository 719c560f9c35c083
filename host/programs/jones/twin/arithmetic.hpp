// The arithmetic of Jones's program on the PDP-7, routine by routine: MULDIV, perspective, the clip of a vector to the
// visible bound.
//
// Each function is the twin of one routine of firmware/pdp7/jones and gives the same numbers, so that a test can call the
// machine's routine through its label and compare. Source: firmware/pdp7/jones/SPECIFICATION.md sections 1 and 2. Space is
// in object units relative to the eye, the screen in units relative to the centre of the window, 2^fraction_bits to a point
// (number.hpp). Functions without a number type have the machine's arithmetic. Masks and clipping are in mask.hpp.
#pragma once

#include <cstdint>
#include <optional>

#include "host/programs/jones/specification.hpp"
#include "host/programs/jones/twin/number.hpp"

namespace sightline::programs::jones {

// Whether the bound contains the window and every difference of two coordinates in it fits a word. Always true for 18 bits
// and at most 3 fraction bits.
[[nodiscard]] bool fits(const Window& window, int fraction_bits, int word_bits);

// The operations of one kind of work.
struct Work {
  std::uint64_t muldivs = 0;
  std::uint64_t products = 0;  // plain products with a double word for a result
};
struct Operations {
  Work projection, line_box, line_sloped, mask_box, mask_sloped, mask_area, display;
};

// floor((a b + floor(c/2)) / c) for a, b in 0..2^18-1, c in 1..2^18-1; nullopt if the quotient does not fit 18 bits (the
// divide overflow of the machine).
[[nodiscard]] std::optional<std::int32_t> muldiv(std::int32_t a, std::int32_t b, std::int32_t c);

inline constexpr std::int32_t largest_word = 131071;

// B(z) = min(K z, largest), z >= 0.
[[nodiscard]] std::int32_t bound(std::int32_t bound_factor, std::int32_t z,
                                 std::int32_t largest = largest_word);

// The least z, at or beyond the near plane, at which a coordinate of this magnitude is inside the bound.
[[nodiscard]] std::int32_t depth_inside(std::int32_t magnitude, std::int32_t bound_factor);

// The part of the axis-parallel vector p-q inside z >= near_z, |x| <= B(z), |y| <= B(z); nullopt if no length is left.
[[nodiscard]] std::optional<SpaceSegment> seg3(const SpaceSegment& vector, Axis axis,
                                               std::int32_t bound_factor,
                                               std::int32_t largest = largest_word);

// Perspective of a point with z >= near_z; nullopt on divide overflow.
template <class Number>
[[nodiscard]] std::optional<BasicScreenPoint<typename Number::Coordinate>> project(const Number& number,
                                                                                   const SpacePoint& point,
                                                                                   std::int32_t width_scale,
                                                                                   Operations& operations) {
  using Coordinate = typename Number::Coordinate;
  operations.projection.muldivs += 2;
  const auto along = [&](std::int32_t place) {
    return number.muldiv(static_cast<Coordinate>(place < 0 ? -place : place),
                         static_cast<Coordinate>(width_scale), static_cast<Coordinate>(point.z));
  };
  const auto x = along(point.x);
  const auto y = along(point.y);
  if (!x || !y) return std::nullopt;
  return BasicScreenPoint<Coordinate>{point.x < 0 ? -*x : *x, point.y < 0 ? -*y : *y};
}
[[nodiscard]] std::optional<ScreenPoint> project(const SpacePoint& point, std::int32_t width_scale,
                                                 Operations& operations);

}  // namespace sightline::programs::jones
