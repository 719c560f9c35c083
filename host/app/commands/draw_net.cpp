// A net of curves, which need not be a function of x and y, as `sightline draw skala` draws it: its lines with their hidden parts
// removed, by the exact method for polyhedra, because Skala's needs a surface over a grid.
#include "host/app/commands/draw.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/app/command.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/scene/model/aim_camera.hpp"

namespace sightline::app {
namespace {

// x to the right, the height upwards, y away, as the surfaces of algorithms/skala/surface.hpp are turned.
scene::PolyCamera camera_of(const scene::PolyScene& scene, const NetView& view) {
  const double a = view.rotation * std::numbers::pi / 180;
  const double e = view.elevation * std::numbers::pi / 180;
  const std::array<double, 3> forward{-std::sin(a) * std::cos(e), -std::sin(e), std::cos(a) * std::cos(e)};
  const std::array<double, 3> up{-std::sin(a) * std::sin(e), std::cos(e), std::cos(a) * std::sin(e)};
  const scene::SceneFrame frame{.vertical = 1, .forward_is_z = true};
  const scene::PolyPoint eye = scene::camera_outside(frame, scene, forward, false).eye;
  return scene::turned_camera(frame, eye, forward, up, false);
}

}  // namespace

picture::VectorDrawing draw_net(const scene::SurfaceNet& net, const NetView& view, const std::string& name) {
  const auto scene =
      value_of(hidden_lines::load(scene::mesh_of(net, {view.sides.x, view.sides.z, view.sides.height}, name)), name);
  hidden_lines::ViewOptions options;
  // No edge is a crease: a line of the net is a wire however its cells bend there, and a diagonal of a cell is no line.
  options.edges.kinds = "silhouette,boundary,junction,wire";
  options.edges.crease = 180;
  options.field = view.field;
  auto drawing = value_of(hidden_lines::view(scene, camera_of(scene.scene, view), options), name);
  return std::move(drawing.picture);
}

}  // namespace sightline::app
