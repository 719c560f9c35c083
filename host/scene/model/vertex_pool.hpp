// Vertices without repetition, for generators and for formats that write each face's corners as points.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Points are equal if their coordinates, std::int32_t or double, are; 0 equals -0.
template <class Number>
class VertexPool {
 public:
  using Point = std::array<Number, 3>;

  explicit VertexPool(std::vector<Point>& vertices) : vertices_(vertices), places_(1024, none) {}

  VertexIndex add(Point point) {
    for (Number& c : point) c += Number{0};  // no -0
    const std::size_t at = place_of(point);
    if (places_[at] != none) return places_[at];
    const auto number = static_cast<VertexIndex>(vertices_.size());
    places_[at] = number;
    vertices_.push_back(point);
    if (2 * vertices_.size() > places_.size()) grow();
    return number;
  }

  // Reserves space for this many vertices.
  void reserve(std::size_t vertices) {
    vertices_.reserve(vertices);
    while (2 * vertices > places_.size()) grow();
  }
  // Prefetches the table entry of a point that will be added soon.
  void fetch(Point point) const {
    for (Number& c : point) c += Number{0};
    __builtin_prefetch(&places_[hash(point) & (places_.size() - 1)]);
  }

  // For a copy of another pool's vertices: takes over its table.
  void copy_table_of(const VertexPool& other) { places_ = other.places_; }

  [[nodiscard]] std::optional<VertexIndex> find(Point point) const {
    for (Number& c : point) c += Number{0};
    const VertexIndex found = places_[place_of(point)];
    return found == none ? std::nullopt : std::optional(found);
  }

 private:
  static constexpr VertexIndex none = 0xffffffff;
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;

  static bool are_same(const Point& a, const Point& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

  static std::size_t hash(const Point& point) {
    std::uint64_t h = 0;
    for (const Number c : point) {
      h = (h ^ std::bit_cast<Bits>(c)) * 0x9e3779b97f4a7c15U;
      h ^= h >> 32U;
    }
    return static_cast<std::size_t>(h);
  }

  // The slot where the point is, or where it would be added.
  [[nodiscard]] std::size_t place_of(const Point& point) const {
    std::size_t at = hash(point) & (places_.size() - 1);
    while (places_[at] != none && !are_same(vertices_[places_[at]], point)) at = (at + 1) & (places_.size() - 1);
    return at;
  }

  void grow() {
    places_.assign(2 * places_.size(), none);
    for (VertexIndex v = 0; v < vertices_.size(); ++v) {
      std::size_t at = hash(vertices_[v]) & (places_.size() - 1);
      while (places_[at] != none) at = (at + 1) & (places_.size() - 1);
      places_[at] = v;
    }
  }

  std::vector<Point>& vertices_;
  std::vector<VertexIndex> places_;  // a power of two in size, at most half full
};

}  // namespace sightline::scene
