// A hash table of indices, and equal items by it, such as the points of a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/base/radix_sort.hpp"
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
// With `jobs` threads. Items are divided by their keys into classes of so few that the table of a class is in the cache.
template <class KeyOf, class Same>
[[nodiscard]] std::vector<std::uint32_t> first_of_same(std::size_t count, KeyOf key_of, Same same, unsigned jobs) {
  struct Item {
    std::uint64_t key = 0;
    std::uint32_t number = 0;
  };
  std::vector<Item> items(count);
  std::vector<std::uint32_t> first(count);
  base::for_parts(jobs, count, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      first[i] = static_cast<std::uint32_t>(i);
      items[i] = {spread(key_of(first[i])), first[i]};
    }
  });
  constexpr unsigned class_bit = 56;
  base::radix_sort(items, class_bit, 64, [](const Item& item) { return item.key; }, jobs);
  const auto class_of = [&items](std::size_t i) { return items[i].key >> class_bit; };
  base::for_parts(jobs, count, [&](std::size_t, std::size_t begin, std::size_t end) {
    std::size_t i = begin;
    while (i > 0 && i < end && class_of(i) == class_of(i - 1)) ++i;  // of a class that the part before has
    while (i < end) {
      std::size_t last = i;
      while (last < count && class_of(last) == class_of(i)) ++last;
      IndexSet numbers(last - i);
      for (; i < last; ++i) {
        const auto& [key, number] = items[i];
        const std::uint32_t found = numbers.find_or_add(key, number, [&, mine = number](std::uint32_t other) { return same(mine, other); });
        if (found != number) first[number] = found;
      }
    }
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

}  // namespace sightline::scene
