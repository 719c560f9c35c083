// A net of curves, which need not be a function of x and y, as `sightline draw skala` draws it: its lines with their hidden parts
// removed, by the exact method for polyhedra, because Skala's needs a surface over a grid.
#pragma once

#include <string>

#include "host/algorithms/skala/view.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/surface_net.hpp"

namespace sightline::app {

struct NetView {
  algorithms::skala::BoxSides sides;  // of the box around the net
  double rotation = 0;                // degrees, as of a surface over a grid
  double elevation = 0;
  picture::DrawingField field;
};

// The curves, the border and the silhouette of the net. `name` is its name in errors. Error bad_input: nothing can be drawn of it.
[[nodiscard]] picture::VectorDrawing draw_net(const scene::SurfaceNet& net, const NetView& view, const std::string& name);

}  // namespace sightline::app
