// See choice.hpp.
#include "host/scene/cells/bsp/choice.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace sightline::scene {
namespace {

// The cost of a plane: this much for each face that it splits, plus the difference between the numbers of
// faces on its two sides.
constexpr std::int64_t split_weight = 8;
constexpr std::size_t most_tried = 24;

std::vector<std::uint32_t> candidates(std::span<const FacePiece> faces) {
  const std::size_t step = (faces.size() + most_tried - 1) / most_tried;
  std::vector<std::uint32_t> planes;
  for (std::size_t i = 0; i < faces.size(); i += step) planes.push_back(faces[i].polygon.plane);
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  return planes;
}

// Stops counting once the cost exceeds `most`.
std::int64_t cost_of(const Planes& planes, std::span<const FacePiece> faces, std::uint32_t plane,
                     std::int64_t most) {
  std::int64_t split = 0;
  std::int64_t excess = 0;
  for (const FacePiece& face : faces) {
    const PolygonSides sides = sides_of(planes, face.polygon, plane);
    if (sides.both()) {
      if (++split * split_weight > most) break;
    } else {
      excess += (sides.in_front ? 1 : 0) - (sides.behind ? 1 : 0);
    }
  }
  return split * split_weight + (excess < 0 ? -excess : excess);
}

}  // namespace

std::uint32_t splitting_plane(const Planes& planes, std::span<const FacePiece> faces) {
  std::uint32_t best = 0;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const std::uint32_t plane : candidates(faces)) {
    const std::int64_t cost = cost_of(planes, faces, plane, least);
    if (cost < least) {
      least = cost;
      best = plane;
    }
  }
  return best;
}

}  // namespace sightline::scene
