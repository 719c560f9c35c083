// The outline of an opening drawn back into the visible bound, corner by corner.
//
// Cutting its sides one by one, as lines are cut, would lose the corners of the bound: an opening all around
// the bound has no side inside it. Moving each corner to the nearest place of the bound keeps exactly what of
// the opening lies inside; what folds onto the bound lies outside every window. Source:
// firmware/pdp7/jones/SPECIFICATION.md section 4.
#pragma once

#include <cstdint>
#include <optional>

#include "host/guests/jones/twin/arithmetic.hpp"

namespace sightline::guests::jones {

class RingBound {
 public:
  // plane: the axis normal to the opening; plane_coordinate: of the opening on it, relative to the eye;
  // largest: of a word.
  RingBound(Axis plane, std::int32_t plane_coordinate, std::int32_t bound_factor,
            std::int32_t largest = largest_word);

  // rho: a corner of the ring, moved into the bound.
  [[nodiscard]] SpacePoint into_bound(SpacePoint corner) const;
  // Where a vector along k, between its ends' moved places, leaves the side of the bound; nothing if it does
  // not.
  [[nodiscard]] std::optional<SpacePoint> bend(const SpaceSegment& vector) const;

 private:
  Axis plane_;
  std::int32_t bound_factor_;
  std::int32_t largest_;
  std::int32_t nearest_;  // least z at which the plane is inside the bound
};

}  // namespace sightline::guests::jones
