// The small scenes used to compare algorithms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/scene/generate/scene.hpp"

namespace sightline::scene {

struct GeneratedSceneName {
  std::string_view family;
  std::size_t size = 0;
  std::uint64_t seed = 0;
};

// Boxes and triangles are convex; in `rooms` a door leaves three rectangles of its wall, a hatch four.
inline std::size_t convex_faces(const PolyScene& scene) {
  std::size_t count = 0;
  for (const PolyBody& body : scene.bodies)
    for (const PolyFace& face : body.faces)
      count += !face.holes.empty() ? 4 : face.outline.size() == 8 ? 3 : 1;
  return count;
}

// The 500 small scenes used to compare algorithms: of boxes, town, triangles, bricks and rooms the first 100 seeds from 1 whose
// scene has
// at most 60 convex faces (a wall with a door counts as 3, with a hatch as 4).
inline std::vector<GeneratedSceneName> generated_set() {
  struct Range {
    std::string_view family;
    std::size_t sizes;
  };
  constexpr std::array<Range, 5> ranges{
      {{"boxes", 10}, {"town", 9}, {"triangles", 16}, {"bricks", 10}, {"rooms", 3}}};
  constexpr std::size_t scenes_a_family = 100;
  constexpr std::size_t most_convex_faces = 60;
  std::vector<GeneratedSceneName> set;
  for (const Range& range : ranges) {
    std::size_t taken = 0;
    for (std::uint64_t seed = 1; taken < scenes_a_family; ++seed) {
      const GeneratedSceneName name{range.family, static_cast<std::size_t>(1 + seed % range.sizes), seed};
      if (convex_faces(generate_scene(name.family, name.size, seed).value()) > most_convex_faces) continue;
      set.push_back(name);
      ++taken;
    }
  }
  return set;
}

}  // namespace sightline::scene
