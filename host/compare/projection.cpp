// See projection.hpp.
#include "host/compare/projection.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/predicates.hpp"

namespace sightline::compare {
namespace {

SeenPoint seen(const scene::PolyPoint& vertex, const scene::PolyCamera& camera) {
  const geometry::Vector3 p = geometry::difference(vertex, camera.eye);
  const auto along = [&](const scene::PolyPoint& axis) {
    const geometry::Vector3 a = geometry::vector_of(axis);
    return static_cast<double>(geometry::dot(a, p)) / std::sqrt(static_cast<double>(geometry::dot(a, a)));
  };
  return {along(camera.right), along(camera.up), camera.perspective ? along(camera.forward) : 1};
}

}  // namespace

SeenEdge::SeenEdge(const scene::PolyPoint& from, const scene::PolyPoint& to, const scene::PolyCamera& camera)
    : from_(seen(from, camera)), to_(seen(to, camera)) {}

SeenPoint SeenEdge::at(double s) const {
  SeenPoint point{};
  for (std::size_t a = 0; a < 3; ++a) point[a] = from_[a] * (1 - s) + to_[a] * s;
  return point;
}

std::optional<picture::LinePart> SeenEdge::part_in(const ScreenFrame& frame) const {
  picture::LinePart part{0, 1};
  // Keeps where a quantity that is linear along the edge is not negative.
  const auto keep = [&](double at_from, double at_to) {
    if (at_from < 0 && at_to < 0) {
      part = {1, 0};
    } else if (at_from < 0) {
      part.low = std::max(part.low, at_from / (at_from - at_to));
    } else if (at_to < 0) {
      part.high = std::min(part.high, at_from / (at_from - at_to));
    }
  };
  if (frame.near > 0) keep(from_[2] - frame.near, to_[2] - frame.near);
  for (std::size_t a = 0; a < 2; ++a) {
    const double centre = a == 0 ? frame.centre.x : frame.centre.y;
    const auto above = [&](const SeenPoint& p) { return frame.scale * p[a] - (frame.low - centre) * p[2]; };
    const auto below = [&](const SeenPoint& p) { return (frame.high - centre) * p[2] - frame.scale * p[a]; };
    keep(above(from_), above(to_));
    keep(below(from_), below(to_));
  }
  if (!(part.low < part.high)) return std::nullopt;
  return part;
}

picture::PixelPoint SeenEdge::pixel_at(double s, const ScreenFrame& frame) const {
  const SeenPoint point = at(s);
  return {frame.scale * point[0] / point[2] + frame.centre.x,
          frame.scale * point[1] / point[2] + frame.centre.y};
}

}  // namespace sightline::compare
