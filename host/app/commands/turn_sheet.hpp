// The paper of the frames of a turn, of one size for all of them.
#pragma once

#include <vector>

#include "host/algorithms/registry/turns.hpp"
#include "host/picture/image.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

class TurnSheet {
 public:
  // About the y axis, level and in parallel projection: what all frames need is the largest distance of a vertex from the axis, and
  // the range of heights. `size`: the width and height in pixels.
  TurnSheet(const scene::PolyScene& scene, int size);
  // On a circle of the eye: the image of a sphere about the middle.
  TurnSheet(const scene::PolyScene& scene, int size, const registry::EyeCircle& circle);

  [[nodiscard]] picture::Image image_of(const std::vector<registry::TurnLine>& lines) const;

 private:
  [[nodiscard]] picture::DrawingPoint point(double u, double v) const;

  int size_;
  double middle_ = 0;
  double scale_ = 1;
};

}  // namespace sightline::app
