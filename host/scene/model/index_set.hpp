// A hash table of indices, and the equal points of a scene by it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// The bits of a key over all bits of a word (Steele's SplitMix).
[[nodiscard]] constexpr std::uint64_t spread(std::uint64_t key) {
  key = (key ^ key >> 30U) * 0xbf58476d1ce4e5b9U;
  key = (key ^ key >> 27U) * 0x94d049bb133111ebU;
  return key ^ key >> 31U;
}

// Indices are found by a key of what they stand for. The table has room for `most` of them.
class IndexSet {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  explicit IndexSet(std::size_t most) {
    std::size_t size = 16;
    while (size < 2 * most) size *= 2;
    places_.resize(size);
  }

  // The index in the table for which `same` holds, else `number`, which is added. `same` is asked about equal keys alone, or nearly.
  template <class Same>
  std::uint32_t find_or_add(std::uint64_t key, std::uint32_t number, Same same) {
    const std::uint64_t bits = spread(key);
    const auto tag = static_cast<std::uint32_t>(bits >> 32U);
    for (std::size_t at = bits & (places_.size() - 1);; at = (at + 1) & (places_.size() - 1)) {
      Place& place = places_[at];
      if (place.index == none) place = {tag, number};
      if (place.index == number || (place.tag == tag && same(place.index))) return place.index;
    }
  }

 private:
  struct Place {
    std::uint32_t tag = 0;  // half of the spread key
    std::uint32_t index = none;
  };
  std::vector<Place> places_;
};

// For each point the first one that is equal to it, which may be itself.
[[nodiscard]] inline std::vector<VertexIndex> equal_points(const std::vector<PolyPoint>& points) {
  const auto key_of = [&points](VertexIndex v) {
    std::uint64_t key = 0;
    for (const std::int32_t c : points[v]) key = key << 20U | static_cast<std::uint32_t>(c + poly_coordinate_limit);
    return key;
  };
  IndexSet numbers(points.size());
  std::vector<VertexIndex> target(points.size());
  for (VertexIndex v = 0; v < points.size(); ++v)
    target[v] = numbers.find_or_add(key_of(v), v, [&](VertexIndex w) { return points[w] == points[v]; });
  return target;
}

}  // namespace sightline::scene
