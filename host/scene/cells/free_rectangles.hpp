// The difference of a rectangle and others, as rectangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/scene/cells/builder.hpp"

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

// Cells that are boxes, openings that are rectangles and lines parallel to an axis, as rows of a CellComplex.

// Bounds low x, high x, low y, high y, low z, high z. The cell's number.
CellNumber add_box_cell(CellComplexBuilder& builder, const geometry::Box& box);

// `below` on the low side of the rectangle's axis, `above` on the high side; one may be `outside`.
void add_rectangle_opening(CellComplexBuilder& builder, const geometry::Rectangle& opening, CellNumber below,
                           CellNumber above);

// Each whole face of `box`, which is cell number `cell`, that lies on the outer box, as an opening to
// `outside`.
void add_openings_outside(CellComplexBuilder& builder, CellNumber cell, const geometry::Box& box);

// The part low .. high on `axis` of an edge parallel to it.
void add_axis_line(CellComplexBuilder& builder, std::uint32_t edge, std::size_t axis, CellNumber cell,
                   std::int32_t low, std::int32_t high);

}  // namespace sightline::scene
