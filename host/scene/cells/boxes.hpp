// Cells that are boxes, openings that are rectangles and lines parallel to an axis, as rows of a CellComplex.
#pragma once

#include <cstdint>

#include "host/geometry/box.hpp"
#include "host/scene/cells/builder.hpp"

namespace sightline::scene {

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
