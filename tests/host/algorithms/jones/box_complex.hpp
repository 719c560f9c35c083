// Cell complexes of boxes, made by hand for tests: independent of automatic decomposition.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/geometry/rational.hpp"
#include "host/scene/cells/builder.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms {

struct BoxOpening {
  geometry::Rectangle place;
  scene::CellNumber below = 0;  // on the low side of the rectangle's axis
  scene::CellNumber above = 0;
};

// The part of a segment in a closed box; empty if it is at most a point.
inline std::optional<std::pair<geometry::Rational, geometry::Rational>> part_in_box(
    const scene::PolyPoint& from, const scene::PolyPoint& to, const geometry::Box& box) {
  geometry::Rational low = 0;
  geometry::Rational high = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t step = std::int64_t{to[a]} - from[a];
    if (step == 0) {
      if (!box.span(a).contains(from[a])) return std::nullopt;
      continue;
    }
    geometry::Rational enters(std::int64_t{box.low[a]} - from[a], step);
    geometry::Rational leaves(std::int64_t{box.high[a]} - from[a], step);
    if (step < 0) std::swap(enters, leaves);
    low = std::max(low, enters);
    high = std::min(high, leaves);
  }
  if (!(low < high)) return std::nullopt;
  return std::pair(low, high);
}

// The sides of a rectangle, counterclockwise as seen from the high side of its axis.
inline std::array<scene::HalfSpace, 4> sides_of(scene::CellComplexBuilder& builder,
                                                const geometry::Rectangle& r) {
  const std::size_t u = (r.axis + 1) % 3;
  const std::size_t v = (r.axis + 2) % 3;
  const geometry::Box bounds = r.bounds();
  return {builder.at_most(u, bounds.high[u]), builder.at_most(v, bounds.high[v]),
          builder.at_least(u, bounds.low[u]), builder.at_least(v, bounds.low[v])};
}

// Cells and openings; as lines, the parts of the scene's edges on the closures of cells. Faces of cells in the outer box are
// openings to the outside.
inline scene::CellComplex complex_of_boxes(const scene::PolyScene& scene, const geometry::Box& outer,
                                           const std::vector<geometry::Box>& cells,
                                           const std::vector<BoxOpening>& openings) {
  scene::CellComplexBuilder builder(scene, outer);
  const std::vector<scene::ComplexEdge> edges = scene::complex_edges_of(scene);
  const auto add_opening = [&builder](const BoxOpening& opening) {
    builder.add_opening(builder.at_most(opening.place.axis, opening.place.at), opening.below, opening.above,
                        sides_of(builder, opening.place));
  };
  for (const geometry::Box& box : cells) {
    std::vector<scene::HalfSpace> bounds;
    for (std::size_t a = 0; a < 3; ++a) {
      bounds.push_back(builder.at_most(a, box.high[a]));
      bounds.push_back(builder.at_least(a, box.low[a]));
    }
    const scene::CellNumber cell = builder.add_cell(bounds);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      const auto part = part_in_box(scene.vertices[edges[e].from], scene.vertices[edges[e].to], box);
      if (part) builder.add_line(cell, e, part->first, part->second);
    }
    for (std::size_t a = 0; a < 3; ++a) {
      if (box.low[a] == outer.low[a]) add_opening({face_of(box, a, false), scene::outside, cell});
      if (box.high[a] == outer.high[a]) add_opening({face_of(box, a, true), cell, scene::outside});
    }
  }
  for (const BoxOpening& opening : openings) add_opening(opening);
  return builder.take();
}

// A cell scene with its own cells and openings.
inline scene::CellComplex complex_by_hand(const scene::CellScene& cells, const scene::PolyScene& scene) {
  std::vector<geometry::Box> boxes;
  for (const scene::Cell& cell : cells.cells) boxes.push_back(cell.box);
  std::vector<BoxOpening> openings;
  for (const scene::Opening& opening : cells.openings) {
    openings.push_back({opening.place, static_cast<scene::CellNumber>(opening.cells[0]),
                        static_cast<scene::CellNumber>(opening.cells[1])});
  }
  return complex_of_boxes(scene, cells.outer, boxes, openings);
}

}  // namespace sightline::algorithms
