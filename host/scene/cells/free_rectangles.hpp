// Subtracts rectangles from a rectangle; the difference is a list of rectangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/scene/cells/builder.hpp"

namespace sightline::scene {

// Keeps its memory between calls.
class FreeRectangles {
 public:
  // Finds the part of `whole` that `covers` leave free, as disjoint rectangles: from the lowest and leftmost
  // on, each as wide as possible, then as high. All are in the same plane. Returns false if the sides of
  // `covers` cut `whole` into more than `most_parts` parts. rectangles() is valid until the next call.
  [[nodiscard]] bool find(const geometry::Rectangle& whole, std::span<const geometry::Rectangle> covers,
                          std::size_t most_parts);
  [[nodiscard]] std::span<const geometry::Rectangle> rectangles() const { return free_; }

 private:
  [[nodiscard]] bool lay_out(const geometry::Rectangle& whole, std::span<const geometry::Rectangle> covers,
                             std::size_t most_parts);
  void cover(const geometry::Rectangle& rectangle);
  void take_rectangles(const geometry::Rectangle& whole);

  std::array<std::vector<std::int32_t>, 2> borders_;  // of the whole and its parts, on each axis
  std::vector<char> covered_;                         // by part between borders, the first axis fastest
  std::vector<geometry::Rectangle> free_;
};

// Box cells, rectangular openings and axis-parallel lines as rows of a CellComplex.

// Returns the cell's number. Its bounds are low x, high x, low y, high y, low z, high z.
CellNumber add_box_cell(CellComplexBuilder& builder, const geometry::Box& box);

// `below` is on the low side of the rectangle's axis, `above` on the high side; one may be `outside`.
void add_rectangle_opening(CellComplexBuilder& builder, const geometry::Rectangle& opening, CellNumber below,
                           CellNumber above);

// Adds each face of `box` that lies on the outer box as an opening from `cell` to `outside`.
void add_openings_outside(CellComplexBuilder& builder, CellNumber cell, const geometry::Box& box);

// Adds the part low..high on `axis` of an edge parallel to it.
void add_axis_line(CellComplexBuilder& builder, std::uint32_t edge, std::size_t axis, CellNumber cell,
                   std::int32_t low, std::int32_t high);

}  // namespace sightline::scene
