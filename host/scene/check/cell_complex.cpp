#include "host/scene/check/cell_complex.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/geometry/box_tree.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/cells/bsp/predicates.hpp"
#include "host/scene/cells/builder.hpp"
#include "host/scene/check/cell_complex_places.hpp"
#include "host/scene/check/problems.hpp"

namespace sightline::scene {

namespace {

bool within(std::uint32_t first, std::uint32_t count, std::size_t size) {
  return std::size_t{first} + count <= size;
}

bool has_planes(const CellComplex& complex, const std::vector<HalfSpace>& halves) {
  return std::all_of(halves.begin(), halves.end(),
                     [&](const HalfSpace& half) { return half.plane < complex.planes.size(); });
}

void check_rows(const CellComplex& complex, Problems& problems) {
  for (std::size_t c = 0; c < complex.cells.size() && !problems.full(); ++c) {
    const ComplexCell& cell = complex.cells[c];
    if (!within(cell.first_bound, cell.bound_count, complex.bounds.size()) ||
        !within(cell.first_line, cell.line_count, complex.lines.size()) ||
        !within(cell.first_opening, cell.opening_count, complex.opening_numbers.size())) {
      problems.add("cell", c, "its rows go beyond the end of bounds, lines or openings");
    }
  }
  for (std::size_t o = 0; o < complex.openings.size() && !problems.full(); ++o) {
    const ComplexOpening& opening = complex.openings[o];
    if (opening.plane >= complex.planes.size() ||
        !within(opening.first_side, opening.side_count, complex.sides.size())) {
      problems.add("opening", o, "its plane or sides are beyond the end of planes or sides");
    }
    for (const CellNumber cell : opening.cells)
      if (cell != outside && cell >= complex.cells.size())
        problems.add("opening", o, "found cell " + std::to_string(cell) + ", which is not there");
    if (opening.cells[0] == opening.cells[1]) problems.add("opening", o, "has the same cell on both sides");
  }
}

void check_lists(const CellComplex& complex, Problems& problems) {
  std::size_t listed = 0;
  for (std::size_t c = 0; c < complex.cells.size() && !problems.full(); ++c) {
    const auto openings = complex.openings_of(complex.cells[c]);
    listed += openings.size();
    for (std::size_t i = 0; i < openings.size(); ++i) {
      const auto& sides = complex.openings[openings[i]].cells;
      if (i > 0 && openings[i - 1] >= openings[i]) problems.add("cell", c, "its openings do not ascend");
      if (sides[0] != c && sides[1] != c)
        problems.add("cell", c, "lists opening " + std::to_string(openings[i]) + " of other cells");
    }
  }
  std::size_t expected = 0;
  for (const ComplexOpening& opening : complex.openings)
    for (const CellNumber cell : opening.cells) expected += cell != outside ? 1U : 0U;
  if (listed < expected)
    problems.add("openings",
                 "found " + std::to_string(listed) + " by cell, expected " + std::to_string(expected));
}

using geometry::Plane;

// Where three planes meet; as a point of integers if it is one, which most are.
class Corner {
 public:
  // Normals independent.
  Corner(const CellComplex& complex, std::uint32_t a, std::uint32_t b, std::uint32_t c)
      : complex_(&complex),
        planes_{a, b, c},
        point_(integer_meeting(complex.planes[a], complex.planes[b], complex.planes[c])) {}

  // Negative inside the half-space, 0 on its plane.
  [[nodiscard]] int at(const HalfSpace& half) const {
    if (std::find(planes_.begin(), planes_.end(), half.plane) != planes_.end()) return 0;
    const auto& planes = complex_->planes;
    const int side = point_ ? planes[half.plane].side(*point_)
                            : side_of_meeting(planes[half.plane], planes[planes_[0]], planes[planes_[1]],
                                              planes[planes_[2]]);
    return half.turned ? -side : side;
  }

 private:
  const CellComplex* complex_;
  std::array<std::uint32_t, 3> planes_;
  std::optional<geometry::Point3> point_;
};

geometry::Vector3 outward(const CellComplex& complex, const HalfSpace& half) {
  const geometry::Vector3& normal = complex.planes[half.plane].normal;
  return half.turned ? geometry::negated(normal) : normal;
}

// Corner i is where sides i and i + 1 meet. Empty if the sides do not turn counterclockwise.
std::optional<std::vector<Corner>> corners_of(const CellComplex& complex, const ComplexOpening& opening) {
  const auto sides = complex.sides_of(opening);
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const HalfSpace& next = sides[i + 1 == sides.size() ? 0 : i + 1];
    if (geometry::determinant(complex.planes[opening.plane].normal, outward(complex, sides[i]),
                              outward(complex, next)) <= 0) {
      return std::nullopt;
    }
    corners.emplace_back(complex, opening.plane, sides[i].plane, next.plane);
  }
  return corners;
}

// Every corner in every side, and strictly within the one after its two: then each side has a length.
bool is_polygon(const CellComplex& complex, const ComplexOpening& opening,
                const std::vector<Corner>& corners) {
  const auto sides = complex.sides_of(opening);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const HalfSpace& side : sides)
      if (corners[i].at(side) > 0) return false;
    if (corners[i].at(sides[(i + 2) % sides.size()]) >= 0) return false;
  }
  return true;
}

bool on_outer_box(const CellComplex& complex, const ComplexOpening& opening) {
  const Plane& plane = complex.planes[opening.plane];
  const bool above = opening.cells[1] == outside;
  for (std::size_t a = 0; a < 3; ++a) {
    Plane expected;
    expected.normal[a] = 1;
    expected.offset = above ? complex.outer.high[a] : complex.outer.low[a];
    if (plane == expected) return true;
  }
  return false;
}

void check_opening_cell(const CellComplex& complex, std::size_t number, bool above,
                        const std::vector<Corner>& corners, Problems& problems) {
  const ComplexOpening& opening = complex.openings[number];
  const CellNumber cell = opening.cells[above ? 1 : 0];
  if (cell == outside) {
    if (!on_outer_box(complex, opening))
      problems.add("opening", number, "leads outside within the outer box");
    return;
  }
  const std::string name = "cell " + std::to_string(cell);
  const auto bounds = complex.bounds_of(complex.cells[cell]);
  if (std::find(bounds.begin(), bounds.end(), HalfSpace{opening.plane, above}) == bounds.end())
    problems.add("opening", number, name + " does not end at its plane on that side");
  const bool inside = std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
    return std::all_of(bounds.begin(), bounds.end(), [&](const HalfSpace& b) { return corner.at(b) <= 0; });
  });
  if (!inside) problems.add("opening", number, "goes beyond " + name);
}

// The cell as a box if its bounds are two for each axis.
std::optional<geometry::Box> box_of(const CellComplex& complex, const ComplexCell& cell) {
  if (cell.bound_count != 6) return std::nullopt;
  geometry::Box box;
  std::array<int, 3> lows{};
  std::array<int, 3> highs{};
  for (const HalfSpace& half : complex.bounds_of(cell)) {
    const Plane& plane = complex.planes[half.plane];
    const std::size_t axis = geometry::dominant_axis(plane.normal);
    Plane expected;
    expected.normal[axis] = 1;
    expected.offset = plane.offset;
    if (plane != expected) return std::nullopt;
    (half.turned ? box.low : box.high)[axis] = static_cast<std::int32_t>(plane.offset);
    ++(half.turned ? lows : highs)[axis];
  }
  const std::array<int, 3> one{1, 1, 1};
  if (lows != one || highs != one) return std::nullopt;
  return box;
}

// For every bound a corner of the cell strictly within it: then the middle of these corners is within all.
bool has_inside(const CellComplex& complex, const ComplexCell& cell) {
  if (const auto box = box_of(complex, cell)) return !box->empty();
  const auto bounds = complex.bounds_of(cell);
  std::vector<bool> cleared(bounds.size(), false);
  std::size_t left = bounds.size();
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    for (std::size_t j = i + 1; j < bounds.size(); ++j) {
      for (std::size_t k = j + 1; k < bounds.size(); ++k) {
        const auto normal = [&](std::size_t b) { return complex.planes[bounds[b].plane].normal; };
        if (geometry::determinant(normal(i), normal(j), normal(k)) == 0) continue;
        const Corner corner(complex, bounds[i].plane, bounds[j].plane, bounds[k].plane);
        if (std::any_of(bounds.begin(), bounds.end(), [&](const HalfSpace& b) { return corner.at(b) > 0; }))
          continue;
        for (std::size_t b = 0; b < bounds.size(); ++b) {
          if (cleared[b] || corner.at(bounds[b]) == 0) continue;
          cleared[b] = true;
          --left;
        }
        if (left == 0) return true;
      }
    }
  }
  return false;
}

// Six times the volume of a closed body.
geometry::Int128 volume6(const PolyScene& scene, const PolyBody& body) {
  geometry::Int128 volume = 0;
  const auto add = [&](std::span<const VertexIndex> ring, const PolyPoint& apex) {
    for (std::size_t i = 2; i < ring.size(); ++i) {
      volume -= geometry::orientation(scene.vertices[ring[0]], scene.vertices[ring[i - 1]],
                                      scene.vertices[ring[i]], apex);
    }
  };
  const PolyPoint apex = scene.vertices[body.faces[0].outline[0]];
  for (const PolyFace& face : body.faces) {
    add(face.outline, apex);
    for (const auto& hole : face.holes) add(hole, apex);
  }
  return volume;
}

geometry::Box box_of(const PolyScene& scene, const PolyBody& body) {
  const PolyPoint& first = scene.vertices[body.faces[0].outline[0]];
  geometry::Box box{first, first};
  for (const PolyFace& face : body.faces) {
    for (const VertexIndex v : face.outline) {
      for (std::size_t a = 0; a < 3; ++a) {
        box.low[a] = std::min(box.low[a], scene.vertices[v][a]);
        box.high[a] = std::max(box.high[a], scene.vertices[v][a]);
      }
    }
  }
  return box;
}

// Bodies whose boxes overlap may overlap themselves; then the sum of volumes says less.
bool may_overlap(const std::vector<geometry::Box>& boxes) {
  const geometry::BoxTree tree(boxes);
  bool found = false;
  for (std::size_t b = 0; b < boxes.size() && !found; ++b) {
    tree.for_each_touching(boxes[b], [&](std::uint32_t other) {
      found = found || (other != b && boxes[other].overlaps(boxes[b]));
    });
  }
  return found;
}

void check_numbers(const CellComplex& complex, const PolyScene& scene, Problems& problems) {
  if (complex.vertices != scene.vertices) problems.add("vertices", "are not those of the scene");
  if (complex.edges != complex_edges_of(scene)) problems.add("edges", "are not those of the scene");
  if (!has_planes(complex, complex.bounds)) problems.add("bounds", "name a plane that is not there");
  if (!has_planes(complex, complex.sides)) problems.add("sides", "name a plane that is not there");
  for (std::size_t p = 0; p < complex.planes.size(); ++p)
    if (geometry::is_zero(complex.planes[p].normal)) problems.add("plane", p, "has no normal");
  for (const std::uint32_t number : complex.opening_numbers)
    if (number >= complex.openings.size())
      problems.add("opening_numbers", "found " + std::to_string(number) + ", which is not there");
  for (const ComplexLine line : complex.lines)
    if (line.edge >= complex.edges.size())
      problems.add("lines", "found edge " + std::to_string(line.edge) + ", which is not there");
  check_rows(complex, problems);
  if (problems.none()) check_lists(complex, problems);
}

// An end of a line is on the side of a plane of q a + p (b - a), where the end is from + p/q (to - from): 60
// bits over 60 at most.
void check_lines(const CellComplex& complex, Problems& problems) {
  const auto beyond = [&](const HalfSpace& half, const ComplexEdge& edge, const geometry::Rational& end) {
    const geometry::Plane& plane = complex.planes[half.plane];
    const PolyPoint& from = complex.vertices[edge.from];
    const std::int64_t slope =
        geometry::dot(plane.normal, geometry::difference(complex.vertices[edge.to], from));
    const geometry::Int128 at =
        geometry::Int128{plane.at(from)} * end.denominator() + geometry::Int128{slope} * end.numerator();
    return half.turned ? at < 0 : at > 0;
  };
  for (std::size_t c = 0; c < complex.cells.size() && !problems.full(); ++c) {
    for (const ComplexLine line : complex.lines_of(complex.cells[c])) {
      const std::string name = "its line on edge " + std::to_string(line.edge);
      if (!(geometry::Rational(0) <= line.low && line.low < line.high &&
            line.high <= geometry::Rational(1))) {
        problems.add("cell", c, name + " is no part of the edge");
        continue;
      }
      for (const HalfSpace& half : complex.bounds_of(complex.cells[c])) {
        const ComplexEdge& edge = complex.edges[line.edge];
        if (beyond(half, edge, line.low) || beyond(half, edge, line.high))
          problems.add("cell", c, name + " leaves the cell");
      }
    }
  }
}

void check_openings(const CellComplex& complex, Problems& problems) {
  for (std::size_t o = 0; o < complex.openings.size() && !problems.full(); ++o) {
    const ComplexOpening& opening = complex.openings[o];
    if (opening.side_count < 3) {
      problems.add("opening", o,
                   "found " + std::to_string(opening.side_count) + " sides, expected 3 or more");
      continue;
    }
    const auto corners = corners_of(complex, opening);
    if (!corners || !is_polygon(complex, opening, *corners)) {
      problems.add("opening", o, "its sides are not the sides of a convex polygon, counterclockwise");
      continue;
    }
    for (const bool above : {false, true}) check_opening_cell(complex, o, above, *corners, problems);
  }
}

void check_cells(const CellComplex& complex, Problems& problems) {
  for (std::size_t c = 0; c < complex.cells.size() && !problems.full(); ++c)
    if (!has_inside(complex, complex.cells[c])) problems.add("cell", c, "has no inside");
}

void check_volume(const CellComplex& complex, const PolyScene& scene, Problems& problems) {
  geometry::Int128 filled = 0;
  for (const ComplexCell& cell : complex.cells) {
    const auto box = box_of(complex, cell);
    if (!box) return;
    filled += box->volume();
  }
  std::vector<geometry::Box> solids;
  geometry::Int128 solid = 0;
  for (const PolyBody& body : scene.bodies) {
    if (body.sheet) continue;
    solids.push_back(box_of(scene, body));
    solid += volume6(scene, body);
  }
  filled += solid / 6;
  const geometry::Int128 all = complex.outer.volume();
  if (filled == all || (filled > all && may_overlap(solids))) return;
  problems.add("cells", "cells and solids fill " + std::to_string(static_cast<double>(filled)) +
                            ", expected the outer box's " + std::to_string(static_cast<double>(all)));
}

}  // namespace

std::vector<base::Error> check_complex(const CellComplex& complex, const PolyScene& scene,
                                       std::uint64_t seed) {
  Problems problems;
  check_numbers(complex, scene, problems);
  if (!problems.none()) return problems.take();
  check_openings(complex, problems);
  check_cells(complex, problems);
  check_lines(complex, problems);
  if (!problems.none()) return problems.take();
  check_volume(complex, scene, problems);
  check_complex_places(complex, scene, seed, problems);
  return problems.take();
}

}  // namespace sightline::scene
