#include "host/programs/jones/twin/arithmetic.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace sightline::programs::jones {
namespace {

// The vector moves along `along`; `across` is the other of x and y.
std::optional<SpaceSegment> seg3_at_depth(SpaceSegment s, std::int32_t SpacePoint::*along,
                                          std::int32_t SpacePoint::*across, std::int32_t bound_factor,
                                          std::int32_t largest) {
  if (s.p.z < near_z) return std::nullopt;
  const std::int32_t limit = bound(bound_factor, s.p.z, largest);
  if (std::abs(s.p.*across) > limit) return std::nullopt;
  s.p.*along = std::clamp(s.p.*along, -limit, limit);
  s.q.*along = std::clamp(s.q.*along, -limit, limit);
  if (s.p.*along == s.q.*along) return std::nullopt;
  return s;
}

}  // namespace

bool fits(const Window& window, int fraction_bits, int word_bits) {
  const std::int64_t farthest = std::int64_t{window.bound_factor} * window.width_scale;
  return farthest >= std::int64_t{512} << fraction_bits && farthest <= std::int64_t{1} << (word_bits - 3);
}

std::optional<std::int32_t> muldiv(std::int32_t a, std::int32_t b, std::int32_t c) {
  assert(a >= 0 && b >= 0 && c > 0);
  return ShortWords().muldiv(a, b, c);
}

std::int32_t bound(std::int32_t bound_factor, std::int32_t z, std::int32_t largest) {
  return static_cast<std::int32_t>(std::min<std::int64_t>(std::int64_t{bound_factor} * z, largest));
}

std::int32_t depth_inside(std::int32_t magnitude, std::int32_t bound_factor) {
  return std::max(near_z, (magnitude + bound_factor - 1) / bound_factor);
}

std::optional<SpaceSegment> seg3(const SpaceSegment& vector, Axis axis, std::int32_t bound_factor,
                                 std::int32_t largest) {
  if (axis == Axis::x) return seg3_at_depth(vector, &SpacePoint::x, &SpacePoint::y, bound_factor, largest);
  if (axis == Axis::y) return seg3_at_depth(vector, &SpacePoint::y, &SpacePoint::x, bound_factor, largest);
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
  return project(ShortWords(), point, width_scale, operations);
}

}  // namespace sightline::programs::jones
