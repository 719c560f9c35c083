// Builds a CellComplex: stores each plane once and orders rows by cell, whatever order they are added in.
//
// The parts that all decompositions need (grid, BSP, by hand): the plane table, the edges of the scene and
// the outer box. Time is linear in what is added.
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

// The smallest box around all vertices, grown by 1 on every side: the outer box of a scene that gives none.
// The scene has a vertex (precondition).
[[nodiscard]] geometry::Box outer_box_of(const PolyScene& scene);

// Every side of every face once, ascending by (from, to), without sides from a vertex to itself.
[[nodiscard]] std::vector<ComplexEdge> complex_edges_of(const PolyScene& scene);

// The half-space on the other side of the same plane.
[[nodiscard]] constexpr HalfSpace opposite(const HalfSpace& half) {
  return {half.plane, !half.turned};
}

class CellComplexBuilder {
 public:
  // Vertices and edges are the scene's. Planes parallel to the axes lie within `outer`.
  CellComplexBuilder(const PolyScene& scene, const geometry::Box& outer);

  // The half-space in which `plane` is not positive. Two planes are the same if the normal and offset of one
  // are a multiple, negative or not, of the other's. The normal is not zero (precondition).
  HalfSpace behind(const geometry::Plane& plane);
  // The half-spaces of the points whose coordinate `axis` is at most, and at least, `at`.
  HalfSpace at_most(std::size_t axis, std::int32_t at) { return {axis_plane(axis, at), false}; }
  HalfSpace at_least(std::size_t axis, std::int32_t at) { return {axis_plane(axis, at), true}; }

  // Returns the new cell's number; cells are numbered from 0.
  CellNumber add_cell(std::span<const HalfSpace> bounds);
  // Adds an opening in the plane of `near`, between `within`, which lies in that half-space, and `beyond`,
  // which lies in the opposite one. One of them may be `outside`. Sides are counterclockwise as seen from
  // `beyond`. The cells may be added later.
  void add_opening(const HalfSpace& near, CellNumber within, CellNumber beyond,
                   std::span<const HalfSpace> sides);
  // Adds the part low..high of edge number `edge` on a cell's closure; low < high. A cell's lines stay in the
  // order added. After expect_lines, they are in the order of edges, with at most one part of each edge in a
  // cell.
  void add_line(CellNumber cell, std::uint32_t edge, const geometry::Rational& low,
                const geometry::Rational& high);

  // Gives the number of lines of each cell before any is added. Each line is then stored at its place at
  // once, without a sort at the end.
  void expect_lines(const std::vector<std::uint32_t>& count_by_cell);
  // Reserves memory, so that a large complex is not moved while it grows.
  void reserve(std::size_t cells, std::size_t bounds);
  void reserve_openings(std::size_t openings, std::size_t sides);

  // The complex so far, for callers that need its planes, edges or cells while they add.
  [[nodiscard]] const CellComplex& complex() const { return complex_; }
  // Finishes the complex and returns it. To be called once.
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
  std::vector<CellNumber> line_cells_;     // the cell of each line, if lines were not expected
  std::vector<std::uint32_t> next_lines_;  // if they were: by cell, where its next line goes
  std::unordered_map<geometry::Plane, std::uint32_t, PlaneHash> slanted_planes_;
  std::array<std::vector<std::uint32_t>, 3> axis_planes_;  // by coordinate from outer.low
};

}  // namespace sightline::scene
