// A hash table of indices, and equal items by it, such as the points of a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/base/threads.hpp"
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

// For each of the items 0 to `count` - 1 the first one that is the same, which may be itself. Items that are the same have the same key.
// Each of `jobs` threads has the items of some keys.
template <class KeyOf, class Same>
[[nodiscard]] std::vector<std::uint32_t> first_of_same(std::size_t count, KeyOf key_of, Same same, unsigned jobs) {
  std::vector<std::uint32_t> first(count);
  base::for_parts(jobs, jobs, [&](std::size_t part, std::size_t, std::size_t) {
    const auto is_mine = [&](std::uint64_t key) { return jobs == 1 || (spread(key) >> 40U) % jobs == part; };
    std::size_t mine = 0;
    for (std::uint32_t i = 0; i < count; ++i) mine += is_mine(key_of(i)) ? 1U : 0U;
    IndexSet indices(mine);
    for (std::uint32_t i = 0; i < count; ++i)
      if (const std::uint64_t key = key_of(i); is_mine(key)) first[i] = indices.find_or_add(key, i, [&](std::uint32_t other) { return same(i, other); });
  });
  return first;
}

// For each point the first one that is equal to it, which may be itself.
[[nodiscard]] inline std::vector<VertexIndex> equal_points(const std::vector<PolyPoint>& points, unsigned jobs = 1) {
  const auto key_of = [&points](VertexIndex v) {
    std::uint64_t key = 0;
    for (const std::int32_t c : points[v]) key = key << 20U | static_cast<std::uint32_t>(c + poly_coordinate_limit);
    return key;
  };
  return first_of_same(points.size(), key_of, [&points](VertexIndex v, VertexIndex w) { return points[v] == points[w]; }, jobs);
}

[[nodiscard]] inline bool all_differ(const std::vector<PolyPoint>& points) {
  const std::vector<VertexIndex> first = equal_points(points);
  for (VertexIndex v = 0; v < first.size(); ++v)
    if (first[v] != v) return false;
  return true;
}

}  // namespace sightline::scene
