// A complex prepared for views from any position: the data that all its views share.
//
// Planes in lowest terms, and how long their numbers are; the entrance from outside; the edges that lie in the
// surface of the outer box, which is viewed from outside without passing an opening; the index of cells;
// what is where in crowded ones.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/algorithms/jones/cell_index.hpp"
#include "host/algorithms/jones/crowded_cells.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::algorithms::jones {

// A face of the outer box: its plane, the normal outwards, and the edges that lie in it.
struct OuterFace {
  geometry::Plane plane;
  std::vector<std::uint32_t> edges;
};

class PreparedComplex {
 public:
  // The complex must outlive this. Time and memory linear in the complex.
  explicit PreparedComplex(const scene::CellComplex& complex);

  [[nodiscard]] const scene::CellComplex& complex() const { return *complex_; }
  [[nodiscard]] const std::vector<geometry::Plane>& planes() const { return planes_; }
  [[nodiscard]] const std::vector<std::uint32_t>& entrances() const { return entrances_; }
  [[nodiscard]] const std::array<OuterFace, 6>& outer_faces() const { return outer_faces_; }
  [[nodiscard]] std::vector<scene::CellNumber> cells_at(const geometry::Point3& point) const {
    return index_.cells_at(*complex_, planes_, point);
  }
  // Null for a cell with few lines and openings.
  [[nodiscard]] const CrowdedCell* crowded(scene::CellNumber cell) const {
    return crowded_.find(*complex_, cell);
  }
  // No component of a normal is greater, nor the value of a plane at a point within the coordinate limit.
  [[nodiscard]] double greatest_component() const { return greatest_component_; }
  [[nodiscard]] double greatest_value() const { return greatest_value_; }

 private:
  void measure();
  void find_ways_in();

  const scene::CellComplex* complex_;
  std::vector<geometry::Plane> planes_;
  std::vector<std::uint32_t> entrances_;  // numbers of the openings one of whose cells is outside
  std::array<OuterFace, 6> outer_faces_;
  CellIndex index_;
  CrowdedCells crowded_;
  double greatest_component_ = 0;
  double greatest_value_ = 0;
};

}  // namespace sightline::algorithms::jones
