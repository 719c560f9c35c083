// On which side of a plane do three others meet: the one question that cutting space by planes asks.
//
// Limits: components of normals below 2^40, offsets below 2^61 in magnitude, so that determinants of normals
// stay below 2^123 and the answer below 2^187. Nothing rounds: 0 means exactly on.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "host/geometry/integer.hpp"
#include "host/geometry/predicates.hpp"

namespace sightline::scene {

// A sum of products of 127-bit by 63-bit numbers, in 191 bits and a sign.
class ProductSum {
 public:
  // |a| below 2^124, |b| below 2^62; at most 8 products.
  constexpr void add(geometry::Int128 a, std::int64_t b) {
    const auto low_half = static_cast<std::uint64_t>(a);
    const geometry::Int128 low_product = geometry::Int128{low_half} * b;
    const auto low_word = static_cast<std::uint64_t>(low_product);
    low_ += low_word;
    const int carry = low_ < low_word ? 1 : 0;
    high_ += (a >> 64) * b + (low_product >> 64) + carry;
  }
  [[nodiscard]] constexpr int sign() const {
    if (high_ != 0) return geometry::sign(high_);
    return low_ != 0 ? 1 : 0;
  }

 private:
  geometry::Int128 high_ = 0;  // the value is high 2^64 + low
  std::uint64_t low_ = 0;
};

// The side of `plane` on which the meeting point of a, b and c is. Their normals are independent.
[[nodiscard]] constexpr int side_of_meeting(const geometry::Plane& plane, const geometry::Plane& a,
                                            const geometry::Plane& b, const geometry::Plane& c) {
  const geometry::Int128 all = geometry::determinant(a.normal, b.normal, c.normal);
  ProductSum sum;
  sum.add(geometry::determinant(plane.normal, b.normal, c.normal), a.offset);
  sum.add(geometry::determinant(plane.normal, c.normal, a.normal), b.offset);
  sum.add(geometry::determinant(plane.normal, a.normal, b.normal), c.offset);
  sum.add(-all, plane.offset);
  return sum.sign() * geometry::sign(all);
}

// The meeting point of a, b and c, if it is a point of integers not above 2^18 in magnitude. Their normals
// are independent. A point that can hardly be told in floating point may be missed, never wrongly named.
[[nodiscard]] std::optional<geometry::Point3> integer_meeting(const geometry::Plane& a,
                                                              const geometry::Plane& b,
                                                              const geometry::Plane& c);

}  // namespace sightline::scene
