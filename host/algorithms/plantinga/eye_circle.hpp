// The way of the eye about a scene that turns about any axis, in parallel projection or in perspective.
//
// Plantinga, Seales and Dyer (1990) turn the scene about the y axis under parallel projection; other rotations "are handled by
// a coordinate transformation", and perspective "with relatively minor modifications" (section 2). Here the eye goes round
// instead of the scene: a point of a circle about the axis, or, in parallel projection, a direction to the viewer that goes
// round a cone (a plane, if it is perpendicular to the axis).
//
// With the axis w, n = w . w and the angle t = 2 atan2(p sqrt(n), q), the rotation times D = q q + p p n has integer entries
// for integers p and q: v -> (q q - p p n) v + 2 p p (w . v) w + 2 p q (w x v). Such places are dense on every circle, and
// views from them are computed exactly. Whatever changes the picture is a plane, through a vertex and an edge, through which
// the eye passes: a form a + b cos t + c sin t whose coefficients are exact integers (c but for a factor sqrt(n)), of degree 2
// in (p : q). Three edges meet where a product of two such forms less another is 0, of degree 4.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/geometry/integer.hpp"

namespace sightline::algorithms::plantinga {

inline constexpr std::int64_t most_axis_part = 1000;
inline constexpr std::int64_t most_eye_part = std::int64_t{1} << 22;

struct EyeCircle {
  Vector3 about{};         // a point of the axis, below 2^18
  Vector3 axis{0, 1, 0};   // at most most_axis_part; not zero
  Vector3 eye{0, 0, 1};    // at angle 0, relative to `about`; in parallel projection the direction to the viewer. At most most_eye_part
  bool perspective = false;
};

// Why the scene cannot be turned before this eye: a number is too large, or, in perspective, a vertex is as far from `about`
// as the eye, so that the eye may come too near to it.
[[nodiscard]] std::optional<std::string> why_not(const RotationModel& model, const EyeCircle& circle);

// The angle 2 atan2(p |axis|, q). |p axis| and |q| are at most 2^30, q is not negative, and not both are 0.
struct CirclePlace {
  std::int64_t p = 0;
  std::int64_t q = 1;
};
// Radians, in (-pi, pi], within place_error.
[[nodiscard]] double angle_of(const EyeCircle& circle, const CirclePlace& place);
inline constexpr double half_turn = std::numbers::pi;
inline constexpr double place_error = 0x1p-48;
// The place nearest to an angle, within 2^-29, or near 0 within 2^-29 |axis|.
[[nodiscard]] CirclePlace place_at(const EyeCircle& circle, double angle);

// The eye at a place, exactly, times D: the vector from P to it is turned + weight (about - P). |turned| < D 2^23, D < 2^62.
struct ExactEye {
  std::array<geometry::Int128, 3> turned{};
  std::int64_t weight = 0;  // D, or 0 in parallel projection
};
[[nodiscard]] ExactEye eye_at(const EyeCircle& circle, const CirclePlace& place);

// The vector from P to the eye, in doubles.
struct NearEye {
  std::array<double, 3> turned{};
  std::array<double, 3> about{};
  double weight = 0;  // 1, or 0 in parallel projection

  [[nodiscard]] std::array<double, 3> from(const std::array<double, 3>& p) const {
    return {turned[0] + weight * (about[0] - p[0]), turned[1] + weight * (about[1] - p[1]),
            turned[2] + weight * (about[2] - p[2])};
  }
};
[[nodiscard]] NearEye near_eye_at(const EyeCircle& circle, double angle);

// a + b cos t + c sin t, each coefficient rounded to a double and therefore certain but for 2^-50 of it.
struct CircleForm {
  double a = 0, b = 0, c = 0;

  [[nodiscard]] double at(double cosine, double sine) const { return a + b * cosine + c * sine; }
  [[nodiscard]] double size() const;  // |a| + |b| + |c|; 0 only if the form is exactly 0 everywhere
};
// (the vector from P to the eye) . normal, times n. Precondition: the normal is below 2^40.
[[nodiscard]] CircleForm form_of(const EyeCircle& circle, const Vector3& normal, const Vector3& p);

// A range of angles that surely contains something. low is in (-pi, pi]; high is at least low, and may exceed pi.
struct Enclosure {
  double low = 0;
  double high = 0;

  [[nodiscard]] double middle() const { return (low + high) / 2; }
  [[nodiscard]] double width() const { return high - low; }
};
// Every root of the form is in one of them; none if the form is 0 everywhere or has no root.
[[nodiscard]] std::vector<Enclosure> roots_of(const CircleForm& form);
// The same angles with low in (-pi, pi].
[[nodiscard]] Enclosure in_range(Enclosure enclosure);
// Sorted by low; enclosures nearer than `apart` are joined, also through pi.
void sort_and_join(std::vector<Enclosure>& enclosures, double apart);

}  // namespace sightline::algorithms::plantinga
