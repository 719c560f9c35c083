// Vertices without repetition, for generators and for formats that write each face's corners as points.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "host/base/threads.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Points are equal if their coordinates, std::int32_t or double, are; 0 equals -0.
template <class Number>
class VertexPool {
 public:
  using Point = std::array<Number, 3>;

  explicit VertexPool(std::vector<Point>& vertices) : vertices_(vertices), places_(1024) {}

  VertexIndex add(Point point) {
    for (Number& c : point) c += Number{0};  // no -0
    const std::uint64_t bits = hash(point);
    Place& place = places_[place_of(bits, point)];
    if (place.number != none) return place.number;
    const auto number = static_cast<VertexIndex>(vertices_.size());
    place = {tag_of(bits), number};
    vertices_.push_back(point);
    if (2 * vertices_.size() > places_.size()) grow();
    return number;
  }

  // Reserves space for this many vertices.
  void reserve(std::size_t vertices) {
    vertices_.reserve(vertices);
    while (2 * vertices > places_.size()) grow();
  }

  // For a copy of another pool's vertices: takes over its table.
  void copy_table_of(const VertexPool& other) { places_ = other.places_; }

  [[nodiscard]] std::optional<VertexIndex> find(Point point) const {
    for (Number& c : point) c += Number{0};
    const VertexIndex found = places_[place_of(hash(point), point)].number;
    return found == none ? std::nullopt : std::optional(found);
  }

  // Equal for equal points without -0.
  static std::uint64_t hash(const Point& point) {
    std::uint64_t h = 0;
    for (const Number c : point) {
      h = (h ^ std::bit_cast<Bits>(c)) * 0x9e3779b97f4a7c15U;
      h ^= h >> 32U;
    }
    return h;
  }

 private:
  static constexpr VertexIndex none = 0xffffffff;
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;

  // By their bits: NaN equals itself, and there is no -0.
  static bool are_same(const Point& a, const Point& b) {
    return std::bit_cast<std::array<Bits, 3>>(a) == std::bit_cast<std::array<Bits, 3>>(b);
  }

  // Half of the hash is stored with each vertex, so that most other vertices are rejected without reading their points.
  struct Place {
    std::uint32_t tag = 0;
    VertexIndex number = none;
  };
  static std::uint32_t tag_of(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32U); }

  // The slot where the point is, or where it would be added.
  [[nodiscard]] std::size_t place_of(std::uint64_t bits, const Point& point) const {
    std::size_t at = bits & (places_.size() - 1);
    while (places_[at].number != none && !(places_[at].tag == tag_of(bits) && are_same(vertices_[places_[at].number], point)))
      at = (at + 1) & (places_.size() - 1);
    return at;
  }

  void grow() {
    places_.assign(2 * places_.size(), {});
    for (VertexIndex v = 0; v < vertices_.size(); ++v) {
      const std::uint64_t bits = hash(vertices_[v]);
      std::size_t at = bits & (places_.size() - 1);
      while (places_[at].number != none) at = (at + 1) & (places_.size() - 1);
      places_[at] = {tag_of(bits), v};
    }
  }

  std::vector<Point>& vertices_;
  std::vector<Place> places_;  // a power of two of them, at most half full
};

// Appends the points 0 to `count` - 1 without repetition to `vertices`, which is empty, in the order in which they first come, and calls
// take(i, vertex) with the number of each. `likely`: how many different ones there probably are. With several threads, each first
// numbers the points of one class, which is a part of all hashes; `take` is called from all threads.
template <class Number, class PointOf, class Take>
void pool_points(std::size_t count, PointOf point_of, std::size_t likely, unsigned jobs, std::vector<std::array<Number, 3>>& vertices,
                 Take take) {
  using Point = std::array<Number, 3>;
  if (jobs == 1) {
    VertexPool<Number> pool(vertices);
    pool.reserve(likely);
    for (std::size_t i = 0; i < count; ++i) take(i, pool.add(point_of(i)));
    return;
  }
  std::vector<std::uint8_t> class_of(count);
  const std::size_t class_count = std::min(jobs, 256U);
  base::for_parts(jobs, count, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Point point = point_of(i);
      for (Number& c : point) c += Number{0};  // no -0
      class_of[i] = static_cast<std::uint8_t>((VertexPool<Number>::hash(point) >> 40U) % class_count);
    }
  });
  struct Class {
    std::vector<Point> vertices;
    std::vector<std::size_t> first;      // of each vertex: the first point that is equal to it
    std::vector<VertexIndex> vertex_of;  // of each point of the class
    std::vector<VertexIndex> numbers;    // of the vertices, among those of all classes
  };
  std::vector<Class> classes(class_count);
  base::for_parts(static_cast<unsigned>(class_count), class_count, [&](std::size_t number, std::size_t, std::size_t) {
    Class& mine = classes[number];
    VertexPool<Number> pool(mine.vertices);
    pool.reserve(likely / class_count);
    mine.vertex_of.reserve(count / class_count);
    for (std::size_t i = 0; i < count; ++i) {
      if (class_of[i] != number) continue;
      mine.vertex_of.push_back(pool.add(point_of(i)));
      if (mine.vertices.size() > mine.first.size()) mine.first.push_back(i);
    }
    mine.first.push_back(count);
  });
  std::size_t all = 0;
  for (const Class& one : classes) all += one.vertices.size();
  vertices.reserve(all);
  while (vertices.size() < all) {
    const auto next_of = [](const Class& one) { return one.first[one.numbers.size()]; };
    Class& next = *std::min_element(classes.begin(), classes.end(), [&](const Class& a, const Class& b) { return next_of(a) < next_of(b); });
    vertices.push_back(next.vertices[next.numbers.size()]);
    next.numbers.push_back(static_cast<VertexIndex>(vertices.size() - 1));
  }
  base::for_parts(jobs, count, [&](std::size_t, std::size_t begin, std::size_t end) {
    std::vector<std::size_t> next(class_count);  // point of each class
    for (std::size_t i = 0; i < begin; ++i) ++next[class_of[i]];
    for (std::size_t i = begin; i < end; ++i) {
      const Class& mine = classes[class_of[i]];
      take(i, mine.numbers[mine.vertex_of[next[class_of[i]]++]]);
    }
  });
}

}  // namespace sightline::scene
