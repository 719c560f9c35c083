#include "host/algorithms/plantinga/eye_circle.hpp"

#include <algorithm>
#include <cmath>

#include "host/algorithms/plantinga/near_vector.hpp"

namespace sightline::algorithms::plantinga {
namespace {

using geometry::Int128;

constexpr double largest_part = 0x1p30;  // of a place

Int128 wide_dot(const Vector3& a, const std::array<Int128, 3>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

std::optional<std::string> why_not(const RotationModel& model, const EyeCircle& circle) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(circle.axis[i]) > most_axis_part) return "a part of the axis is above " + std::to_string(most_axis_part);
    if (std::abs(circle.eye[i]) > most_eye_part) return "the eye is more than " + std::to_string(most_eye_part) + " away along an axis";
  }
  if (circle.axis == Vector3{}) return "the axis has no length";
  if (circle.eye == Vector3{}) return "the eye is on the point that it looks at";
  if (!circle.perspective) return std::nullopt;
  const std::int64_t far = geometry::dot(circle.eye, circle.eye);
  for (const Vector3& v : model.vertices()) {
    const Vector3 d = minus(v, circle.about);
    if (geometry::dot(d, d) >= far) return "the eye is not farther from the middle of the scene than every vertex";
  }
  return std::nullopt;
}

double angle_of(const EyeCircle& circle, const CirclePlace& place) {
  return 2 * std::atan2(static_cast<double>(place.p) * length_of(near_of(circle.axis)), static_cast<double>(place.q));
}

CirclePlace place_at(const EyeCircle& circle, double angle) {
  const double half = std::remainder(angle, 2 * half_turn) / 2;
  const double length = length_of(near_of(circle.axis));
  const double sine = std::sin(half);
  const double p = std::trunc(largest_part * sine / length);
  if (p == 0) return {0, 1};
  // p is at most largest_part sin, so q is at most largest_part, too.
  const double q = std::round(p * length * std::cos(half) / sine);
  return {static_cast<std::int64_t>(p), static_cast<std::int64_t>(std::max(q, 0.0))};
}

ExactEye eye_at(const EyeCircle& circle, const CirclePlace& place) {
  const Vector3& w = circle.axis;
  const std::int64_t n = geometry::dot(w, w);
  const std::int64_t pp = place.p * place.p;
  const std::int64_t qq = place.q * place.q;
  const std::int64_t pq = place.p * place.q;
  const std::int64_t along = geometry::dot(w, circle.eye);
  const Vector3 across = geometry::cross(w, circle.eye);
  ExactEye eye;
  for (std::size_t i = 0; i < 3; ++i) {
    eye.turned[i] = (Int128{qq} - Int128{pp} * n) * circle.eye[i] + 2 * Int128{pp} * along * w[i] + 2 * Int128{pq} * across[i];
  }
  eye.weight = circle.perspective ? qq + pp * n : 0;
  return eye;
}

NearEye near_eye_at(const EyeCircle& circle, double angle) {
  const Vector3& w = circle.axis;
  const auto n = static_cast<double>(geometry::dot(w, w));
  const double along = static_cast<double>(geometry::dot(w, circle.eye)) / n;
  const Vector3 across = geometry::cross(w, circle.eye);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle) / std::sqrt(n);
  NearEye eye;
  for (std::size_t i = 0; i < 3; ++i) {
    const double level = along * static_cast<double>(w[i]);
    eye.turned[i] = level + cosine * (static_cast<double>(circle.eye[i]) - level) + sine * static_cast<double>(across[i]);
    eye.about[i] = static_cast<double>(circle.about[i]);
  }
  eye.weight = circle.perspective ? 1 : 0;
  return eye;
}

double CircleForm::size() const { return std::abs(a) + std::abs(b) + std::abs(c); }

CircleForm form_of(const EyeCircle& circle, const Vector3& normal, const Vector3& p) {
  const Vector3& w = circle.axis;
  const std::int64_t n = geometry::dot(w, w);
  const std::int64_t along = geometry::dot(w, circle.eye);
  std::array<Int128, 3> level{};  // what does not turn, times n
  std::array<Int128, 3> turning{};
  for (std::size_t i = 0; i < 3; ++i) {
    level[i] = Int128{along} * w[i];
    turning[i] = Int128{n} * circle.eye[i] - level[i];
    if (circle.perspective) level[i] += Int128{n} * (circle.about[i] - p[i]);
  }
  const Int128 across = geometry::wide_dot(normal, geometry::cross(w, circle.eye));
  return {static_cast<double>(wide_dot(normal, level)), static_cast<double>(wide_dot(normal, turning)),
          static_cast<double>(across) * std::sqrt(static_cast<double>(n))};
}

Enclosure in_range(Enclosure enclosure) {
  while (enclosure.low <= -half_turn) enclosure = {enclosure.low + 2 * half_turn, enclosure.high + 2 * half_turn};
  while (enclosure.low > half_turn) enclosure = {enclosure.low - 2 * half_turn, enclosure.high - 2 * half_turn};
  return enclosure;
}

// cos(t - phase) = -a / |(b, c)|.
std::vector<Enclosure> roots_of(const CircleForm& form) {
  const double reach = std::hypot(form.b, form.c);
  if (reach == 0) return {};
  constexpr double off = 0x1p-48;
  const double level = -form.a / reach;
  const double low = level - off * (1 + std::abs(level));
  const double high = level + off * (1 + std::abs(level));
  if (low > 1 || high < -1) return {};
  const double nearest = std::acos(std::min(high, 1.0)) - 0x1p-49;
  const double farthest = std::acos(std::max(low, -1.0)) + 0x1p-49;
  const double phase = std::atan2(form.c, form.b);
  constexpr double rounding = 0x1p-49;
  return {in_range({phase + nearest - rounding, phase + farthest + rounding}),
          in_range({phase - farthest - rounding, phase - nearest + rounding})};
}

void sort_and_join(std::vector<Enclosure>& enclosures, double apart) {
  std::sort(enclosures.begin(), enclosures.end(), [](const Enclosure& a, const Enclosure& b) { return a.low < b.low; });
  std::size_t kept = 0;
  for (const Enclosure& next : enclosures) {
    if (kept > 0 && next.low - enclosures[kept - 1].high < apart) {
      enclosures[kept - 1].high = std::max(enclosures[kept - 1].high, next.high);
    } else {
      enclosures[kept++] = next;
    }
  }
  enclosures.resize(kept);
  // The last may reach the first ones through pi.
  while (enclosures.size() > 1 && enclosures.front().low + 2 * half_turn - enclosures.back().high < apart) {
    enclosures.back().high = std::max(enclosures.back().high, enclosures.front().high + 2 * half_turn);
    enclosures.erase(enclosures.begin());
  }
}

}  // namespace sightline::algorithms::plantinga
