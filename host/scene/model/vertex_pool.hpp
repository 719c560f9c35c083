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

 private:
  static constexpr VertexIndex none = 0xffffffff;
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;

  // By their bits: NaN equals itself, and there is no -0.
  static bool are_same(const Point& a, const Point& b) {
    return std::bit_cast<std::array<Bits, 3>>(a) == std::bit_cast<std::array<Bits, 3>>(b);
  }

  static std::uint64_t hash(const Point& point) {
    std::uint64_t h = 0;
    for (const Number c : point) {
      h = (h ^ std::bit_cast<Bits>(c)) * 0x9e3779b97f4a7c15U;
      h ^= h >> 32U;
    }
    return h;
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

}  // namespace sightline::scene
