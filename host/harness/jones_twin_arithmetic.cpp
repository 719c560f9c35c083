#include "host/harness/jones_twin_arithmetic.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace sightline::harness::jones {
namespace {

constexpr std::int32_t word_max = 131071;

// The vector moves along `along`; `across` is the other of x and y.
std::optional<SpaceSegment> seg3_at_depth(SpaceSegment s, std::int32_t SpacePoint::*along,
                                          std::int32_t SpacePoint::*across, std::int32_t bound_factor) {
  if (s.p.z < near_z) return std::nullopt;
  const std::int32_t limit = bound(bound_factor, s.p.z);
  if (std::abs(s.p.*across) > limit) return std::nullopt;
  s.p.*along = std::clamp(s.p.*along, -limit, limit);
  s.q.*along = std::clamp(s.q.*along, -limit, limit);
  if (s.p.*along == s.q.*along) return std::nullopt;
  return s;
}

}  // namespace

Window window_of(Pass pass, std::int32_t scale) {
  Window window;
  if (pass == Pass::mono) {
    window.width_scale = 2 * scale;
  } else {
    window.width_scale = 2 * (scale >> 1);
    window.xlo = -512;
    window.xhi = 510;
    window.centre_x = pass == Pass::left ? 256 : 768;
  }
  while (window.bound_factor * window.width_scale < 2048) window.bound_factor *= 2;
  return window;
}

std::optional<std::int32_t> muldiv(std::int32_t a, std::int32_t b, std::int32_t c) {
  assert(a >= 0 && b >= 0 && c > 0);
  const std::int64_t dividend = std::int64_t{a} * b + c / 2;
  if ((dividend >> 18) >= c) return std::nullopt;
  return static_cast<std::int32_t>(dividend / c);
}

std::int32_t bound(std::int32_t bound_factor, std::int32_t z) {
  return static_cast<std::int32_t>(std::min<std::int64_t>(std::int64_t{bound_factor} * z, word_max));
}

std::int32_t depth_inside(std::int32_t magnitude, std::int32_t bound_factor) {
  return std::max(near_z, (magnitude + bound_factor - 1) / bound_factor);
}

std::optional<SpaceSegment> seg3(const SpaceSegment& vector, Axis axis, std::int32_t bound_factor) {
  if (axis == Axis::x) return seg3_at_depth(vector, &SpacePoint::x, &SpacePoint::y, bound_factor);
  if (axis == Axis::y) return seg3_at_depth(vector, &SpacePoint::y, &SpacePoint::x, bound_factor);
  const std::int32_t widest = std::max(std::abs(vector.p.x), std::abs(vector.p.y));
  const std::int32_t zmin = depth_inside(widest, bound_factor);
  if (vector.p.z < zmin && vector.q.z < zmin) return std::nullopt;
  SpaceSegment s = vector;
  s.p.z = std::max(s.p.z, zmin);
  s.q.z = std::max(s.q.z, zmin);
  if (s.p.z == s.q.z) return std::nullopt;
  return s;
}

std::optional<ScreenPoint> project(const SpacePoint& point, std::int32_t width_scale,
                                   Operations& operations) {
  operations.projection.muldivs += 2;
  const auto x = muldiv(std::abs(point.x), width_scale, point.z);
  const auto y = muldiv(std::abs(point.y), width_scale, point.z);
  if (!x || !y) return std::nullopt;
  return ScreenPoint{point.x < 0 ? -*x : *x, point.y < 0 ? -*y : *y};
}

}  // namespace sightline::harness::jones
