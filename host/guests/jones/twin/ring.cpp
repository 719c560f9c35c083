#include "host/guests/jones/twin/ring.hpp"

#include <algorithm>
#include <cstdlib>

namespace sightline::guests::jones {

RingBound::RingBound(Axis plane, std::int32_t plane_coordinate, std::int32_t bound_factor,
                     std::int32_t largest)
    : plane_(plane),
      bound_factor_(bound_factor),
      largest_(largest),
      nearest_(plane == Axis::z ? near_z : depth_inside(std::abs(plane_coordinate), bound_factor)) {}

SpacePoint RingBound::into_bound(SpacePoint corner) const {
  corner.z = std::max(corner.z, nearest_);
  const std::int32_t limit = bound(bound_factor_, corner.z, largest_);
  corner.x = std::clamp(corner.x, -limit, limit);
  corner.y = std::clamp(corner.y, -limit, limit);
  return corner;
}

std::optional<SpacePoint> RingBound::bend(const SpaceSegment& vector) const {
  const std::int32_t along = plane_ == Axis::x ? vector.p.y : vector.p.x;
  const std::int32_t depth = depth_inside(std::abs(along), bound_factor_);
  const std::int32_t from = into_bound(vector.p).z;
  const std::int32_t to = into_bound(vector.q).z;
  if (depth <= std::min(from, to) || depth >= std::max(from, to)) return std::nullopt;
  return SpacePoint{vector.p.x, vector.p.y, depth};
}

}  // namespace sightline::guests::jones
