// The data of a complex that all views of it share.
//
// The planes in lowest terms and their greatest coefficients; the openings to the outside; the edges in the surface of
// the outer box, which are visible from outside without passing an opening; the index of cells; and the index of lines
// and openings in crowded cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/algorithms/jones/cell_index.hpp"
#include "host/algorithms/jones/crowded_cells.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::algorithms::jones {

// A face of the outer box: its plane with the outward normal, and the edges in it.
struct OuterFace {
  geometry::Plane plane;
  std::vector<std::uint32_t> edges;
};

class PreparedComplex {
 public:
  // The complex must outlive this object. Linear time and memory.
  explicit PreparedComplex(const scene::CellComplex& complex);

  [[nodiscard]] const scene::CellComplex& complex() const { return *complex_; }
  [[nodiscard]] const std::vector<geometry::Plane>& planes() const { return planes_; }
  [[nodiscard]] const std::vector<std::uint32_t>& entrances() const { return entrances_; }
  [[nodiscard]] const std::array<OuterFace, 6>& outer_faces() const { return outer_faces_; }
  [[nodiscard]] std::vector<scene::CellNumber> cells_at(const geometry::Point3& point) const {
    return index_.cells_at(*complex_, planes_, point);
  }
  // Null if the cell is not crowded.
  [[nodiscard]] const CrowdedCell* find_crowded(scene::CellNumber cell) const {
    return crowded_.find(*complex_, cell);
  }
  // The greatest magnitude of a component of a normal, and of a plane's value at a point within the coordinate limit.
  [[nodiscard]] double greatest_component() const { return greatest_component_; }
  [[nodiscard]] double greatest_value() const { return greatest_value_; }

 private:
  void measure();
  void find_entrances();

  const scene::CellComplex* complex_;
  std::vector<geometry::Plane> planes_;
  std::vector<std::uint32_t> entrances_;  // numbers of the openings to the outside
  std::array<OuterFace, 6> outer_faces_;
  CellIndex index_;
  CrowdedCells crowded_;
  double greatest_component_ = 0;
  double greatest_value_ = 0;
};

}  // namespace sightline::algorithms::jones
