// A rectangle without others, as rectangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"

namespace sightline::scene {

// Keeps its memory from one use to the next.
class FreeRectangles {
 public:
  // What `covers`, each with its plane the same as `whole`'s, leave of `whole`: disjoint rectangles, from the
  // lowest and leftmost on each as wide as can be, then as high. False if the sides of `covers` cut `whole`
  // into more than `most_parts` parts. rectangles() is valid until the next call.
  [[nodiscard]] bool find(const geometry::Rectangle& whole, std::span<const geometry::Rectangle> covers,
                          std::size_t most_parts);
  [[nodiscard]] std::span<const geometry::Rectangle> rectangles() const { return free_; }

 private:
  [[nodiscard]] bool lay_out(const geometry::Rectangle& whole, std::span<const geometry::Rectangle> covers,
                             std::size_t most_parts);
  void cover(const geometry::Rectangle& rectangle);
  void take_rectangles(const geometry::Rectangle& whole);

  std::array<std::vector<std::int32_t>, 2> borders_;  // the whole, cut where something ends
  std::vector<char> covered_;                         // the parts between them, the first axis fastest
  std::vector<geometry::Rectangle> free_;
};

}  // namespace sightline::scene
