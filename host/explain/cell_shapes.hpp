// The shapes of cells and portals in doubles, and an oblique projection in which they are drawn. Nothing is decided by
// them: a cell complex has only planes, and its corners are computed here for pictures.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/explain/stage.hpp"
#include "host/scene/model/cell_complex.hpp"

namespace sightline::explain {

// In order around the portal. A corner where its planes are nearly parallel is left out.
[[nodiscard]] std::vector<Space> corners_of(const scene::CellComplex& complex, std::uint32_t opening);

// An edge of a cell and the outward normals of the two sides that meet in it.
struct CellEdge {
  Space from{};
  Space to{};
  std::array<Space, 2> sides{};
};
[[nodiscard]] std::vector<CellEdge> edges_of(const scene::CellComplex& complex, scene::CellNumber cell);
// The mean of the ends of its edges, which is inside the cell.
[[nodiscard]] Space middle_of(const std::vector<CellEdge>& edges);

// Space as a draughtsman draws it: what lies across the direction of view has its true shape, what is farther away is
// shifted to the right and up. Its axes are the axes of the scene nearest to those of the camera.
class ObliqueView {
 public:
  explicit ObliqueView(const scene::PolyCamera& camera);

  [[nodiscard]] Point at(const Space& p) const;
  // Whether a side with this outward normal faces the viewer.
  [[nodiscard]] bool faces_viewer(const Space& normal) const;

 private:
  Space right_{};
  Space up_{};
  Space forward_{};
};

}  // namespace sightline::explain
