// The exact direction of sight of an event: a point (X : Z) of the circle, with the viewer far away on the side of (X, 0,
// Z). Its angle is theta, in (-pi, pi], with X = sin theta and Z = cos theta up to a positive factor. The tangent is
// never used, so 90 degrees needs no special case (hard cases P4, P5).
//
// Two edges, or an edge and a vertex, give directions of degree 1 in products of coordinates (rational); three edges give
// the roots of a quadratic form. A direction is kept in a canonical form, so that equal directions have equal parts and
// == is exact: coprime integers, or a primitive irreducible form with the number of its root. Directions are ordered by
// angle, compared in doubles first, and exactly if the angles are too close (Plantinga, Seales and Dyer 1990, section 3;
// D: the paper does not say how equal events are recognised).
//
// Sizes: coordinates are below 2^23, so linear forms are below 2^52, quadratic forms and the parts of a rational
// direction below 2^104.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/geometry/integer.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::plantinga {

using geometry::Int128;

// x X + z Z
struct LinearForm {
  std::int64_t x = 0;
  std::int64_t z = 0;
};

// xx X^2 + xz X Z + zz Z^2
struct QuadraticForm {
  Int128 xx = 0;
  Int128 xz = 0;
  Int128 zz = 0;

  friend bool operator==(const QuadraticForm&, const QuadraticForm&) = default;
};

// Bound of the difference between the angle of a Direction and the true angle.
inline constexpr double angle_error = 0x1p-48;

struct Direction {
  // Rational: form.xx and form.zz are X and Z, coprime. Otherwise: form is primitive and irreducible, form.xx
  // is positive, and X : Z = -xz + root sqrt(xz^2 - 4 xx zz) : 2 xx, times `side`.
  bool rational = true;
  std::int8_t root = 0;  // +1 or -1; 0 for a rational
  std::int8_t side = 1;  // +1 or -1; 1 for a rational
  QuadraticForm form{0, 0, 1};
  double angle = 0;  // radians, within angle_error

  friend bool operator==(const Direction& a, const Direction& b) {
    return a.rational == b.rational && a.root == b.root && a.side == b.side && a.form == b.form;
  }
};

// Negative, zero or positive: the angle of a is less than, equal to, greater than that of b.
[[nodiscard]] int compare(const Direction& a, const Direction& b);
[[nodiscard]] inline bool less(const Direction& a, const Direction& b) {
  return compare(a, b) < 0;
}

inline constexpr unsigned coefficient_bits = 104;  // of quadratic forms and rational directions

// Precondition: x and z are not both 0 and are below 2^104 in lowest terms.
[[nodiscard]] Direction rational_direction(Int128 x, Int128 z);
[[nodiscard]] Direction opposite(const Direction& direction);

// The directions at which a form is 0: two opposite ones, or none if it is 0 everywhere.
[[nodiscard]] std::vector<Direction> roots_of(const LinearForm& form);
// The directions at which a form changes its sign: none, or two and their opposites. A double root, where the form
// touches 0, is not included: edges that meet there separate again in the same order (hard cases P1 to P1d).
[[nodiscard]] std::vector<Direction> roots_of(const QuadraticForm& form);

// The exact sign of a linear form at a direction.
[[nodiscard]] int sign_at(const Direction& direction, const LinearForm& form);

// A direction of sight in small integers, for exact computation in 64 and 128 bits.
struct Sight {
  std::int64_t x = 0;
  std::int64_t z = 1;

  friend bool operator==(const Sight&, const Sight&) = default;
};
inline constexpr std::int64_t sight_limit = std::int64_t{1} << 21;  // |x| and |z| are below this

// A direction strictly between a and b, going from a in the direction of increasing angle (through pi if b's angle is not
// greater). nullopt if none was found whose parts are below sight_limit.
[[nodiscard]] std::optional<Sight> sight_between(const Direction& a, const Direction& b);

// A direction of sight in integers long enough that there is one between any two directions (proof in direction.cpp). Its
// parts together are below 2^wide_sight_bits.
inline constexpr unsigned wide_sight_bits = 956;
struct WideSight {
  geometry::WideInteger<wide_sight_bits> x;
  geometry::WideInteger<wide_sight_bits> z;
};
// A direction strictly between the two. Precondition: b is ahead of a by more than 0 and less than pi.
[[nodiscard]] WideSight wide_sight_between(const Direction& a, const Direction& b);

}  // namespace sightline::algorithms::plantinga
