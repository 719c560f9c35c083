// Lines of a scene that lie on each other in the image taken as one: the reference for algorithms that draw
// the nearest of them only (LineAlgorithm::same_by_image), whose pictures are right as sets of points.
#pragma once

#include <vector>

#include "host/picture/line_metrics.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

class ImageLines {
 public:
  // `lines` are those of reference_lines (lines.hpp) for this scene and camera.
  ImageLines(const std::vector<picture::ReferenceLine>& lines, const scene::PolyScene& scene,
             const scene::PolyCamera& camera);

  [[nodiscard]] const std::vector<picture::ReferenceLine>& lines() const { return lines_; }
  // Pieces of edges as pieces of these lines.
  [[nodiscard]] std::vector<picture::DrawnPiece> pieces(std::vector<picture::DrawnPiece> of_edges) const;

 private:
  std::vector<picture::LineId> line_of_edge_;
  std::vector<picture::ReferenceLine> lines_;
};

}  // namespace sightline::compare
