// Vertices without repetition: of a format that writes the corners of each face as points.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Points are the same if their coordinates are; 0 and -0 are.
class VertexPool {
 public:
  explicit VertexPool(std::vector<std::array<double, 3>>& vertices) : vertices_(vertices), places_(1024, none) {}

  VertexIndex add(std::array<double, 3> point) {
    for (double& c : point) c += 0.0;  // no -0
    std::size_t at = hash(point) & (places_.size() - 1);
    for (; places_[at] != none; at = (at + 1) & (places_.size() - 1))
      if (vertices_[places_[at]] == point) return places_[at];
    const auto number = static_cast<VertexIndex>(vertices_.size());
    places_[at] = number;
    vertices_.push_back(point);
    if (2 * vertices_.size() > places_.size()) grow();
    return number;
  }

 private:
  static constexpr VertexIndex none = 0xffffffff;

  static std::size_t hash(const std::array<double, 3>& point) {
    std::uint64_t h = 0;
    for (const double c : point) {
      h = (h ^ std::bit_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15U;
      h ^= h >> 32U;
    }
    return static_cast<std::size_t>(h);
  }

  void grow() {
    places_.assign(2 * places_.size(), none);
    for (VertexIndex v = 0; v < vertices_.size(); ++v) {
      std::size_t at = hash(vertices_[v]) & (places_.size() - 1);
      while (places_[at] != none) at = (at + 1) & (places_.size() - 1);
      places_[at] = v;
    }
  }

  std::vector<std::array<double, 3>>& vertices_;
  std::vector<VertexIndex> places_;  // a power of two of them, at most half full
};

}  // namespace sightline::scene
