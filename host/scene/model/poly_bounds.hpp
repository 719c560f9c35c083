// The box around all vertices of a scene of polyhedra.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct PolyBounds {
  PolyPoint low{};
  PolyPoint high{};

  // Rounded towards zero.
  [[nodiscard]] PolyPoint middle() const {
    PolyPoint p{};
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = static_cast<std::int32_t>((std::int64_t{low[a]} + high[a]) / 2);
    return p;
  }
  // Half of the longest side, rounded up, at least 1.
  [[nodiscard]] std::int64_t half_size() const {
    std::int64_t half = 1;
    for (std::size_t a = 0; a < 3; ++a) half = std::max(half, (std::int64_t{high[a]} - low[a] + 1) / 2);
    return half;
  }
  [[nodiscard]] bool contain(const PolyPoint& p) const {
    bool inside = true;
    for (std::size_t a = 0; a < 3; ++a) inside = inside && low[a] <= p[a] && p[a] <= high[a];
    return inside;
  }
};

// The point 0, 0, 0 for a scene without vertices.
[[nodiscard]] inline PolyBounds bounds_of(const PolyScene& scene) {
  if (scene.vertices.empty()) return {};
  PolyBounds bounds{scene.vertices[0], scene.vertices[0]};
  for (const PolyPoint& p : scene.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      bounds.low[a] = std::min(bounds.low[a], p[a]);
      bounds.high[a] = std::max(bounds.high[a], p[a]);
    }
  }
  return bounds;
}

}  // namespace sightline::scene
