// Puts a CellComplex together: each plane once, rows by cell, whatever order they come in.
//
// What the ways of cutting space share (by grid, by BSP, by hand): the plane table, the edges of the scene
// and the box around it. Everything is linear in what is added.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "host/geometry/box.hpp"
#include "host/geometry/predicates.hpp"
#include "host/geometry/rational.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// The smallest box around all vertices, grown by 1 on every side: the outer box of a scene that names none.
// Of at least one vertex.
[[nodiscard]] geometry::Box outer_box_of(const PolyScene& scene);

// Every side of every face once, ascending by (from, to); steps from a vertex to itself are left out.
[[nodiscard]] std::vector<ComplexEdge> complex_edges_of(const PolyScene& scene);

// The same plane from its other side.
[[nodiscard]] constexpr HalfSpace opposite(const HalfSpace& half) {
  return {half.plane, !half.turned};
}

class CellComplexBuilder {
 public:
  // Vertices and edges are the scene's; planes parallel to the axes lie within `outer`.
  CellComplexBuilder(const PolyScene& scene, const geometry::Box& outer);

  // The half-space in which `plane` is not positive. Planes are the same if one's normal and offset are a
  // multiple, negative or not, of the other's. The normal is not zero.
  HalfSpace behind(const geometry::Plane& plane);
  // The half-spaces of the points whose coordinate `axis` is at most, and at least, `at`.
  HalfSpace at_most(std::size_t axis, std::int32_t at) { return {axis_plane(axis, at), false}; }
  HalfSpace at_least(std::size_t axis, std::int32_t at) { return {axis_plane(axis, at), true}; }

  // The next cell's number; cells are numbered from 0.
  CellNumber add_cell(std::span<const HalfSpace> bounds);
  // An opening in the plane of `near`, between `within`, which lies in that half-space, and `beyond`, which
  // lies in the opposite one; either, not both, may be `outside`. Sides go counterclockwise as seen from
  // `beyond`. Cells may be added later.
  void add_opening(const HalfSpace& near, CellNumber within, CellNumber beyond,
                   std::span<const HalfSpace> sides);
  // Part of edge number `edge` on a cell's closure; low < high. A cell keeps its lines in the order given,
  // or, if they are expected, by edge, of which it then has one part each.
  void add_line(CellNumber cell, std::uint32_t edge, const geometry::Rational& low,
                const geometry::Rational& high);

  // How many lines each cell will have, told before any is added: they are then put in their places at once,
  // and none need be sorted.
  void expect_lines(const std::vector<std::uint32_t>& count_by_cell);
  // Room for this many, so that nothing is moved while a large complex grows.
  void reserve(std::size_t cells, std::size_t bounds);
  void reserve_openings(std::size_t openings, std::size_t sides);

  // So far: for what needs the planes, the edges or the cells while it adds.
  [[nodiscard]] const CellComplex& complex() const { return complex_; }
  // Once.
  [[nodiscard]] CellComplex take();

 private:
  struct PlaneHash {
    std::size_t operator()(const geometry::Plane& plane) const;
  };

  std::uint32_t axis_plane(std::size_t axis, std::int32_t at);
  std::uint32_t new_plane(const geometry::Plane& plane);
  void find_expected_lines();
  void sort_lines();
  void list_openings();

  CellComplex complex_;
  std::vector<CellNumber> line_cells_;     // of lines that wait to be sorted
  std::vector<std::uint32_t> next_lines_;  // if they were expected: by cell, where its next one goes
  std::unordered_map<geometry::Plane, std::uint32_t, PlaneHash> slanted_planes_;
  std::array<std::vector<std::uint32_t>, 3> axis_planes_;  // by coordinate from outer.low
};

}  // namespace sightline::scene
