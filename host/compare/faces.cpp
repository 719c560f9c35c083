// See faces.hpp.
#include "host/compare/faces.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "host/algorithms/oracle/face_raster.hpp"
#include "host/base/result.hpp"
#include "emulators/core/tstates.hpp"
#include "host/compare/host_time.hpp"
#include "host/compare/lines.hpp"
#include "host/compare/work_bounds.hpp"
#include "host/geometry/predicates.hpp"
#include "host/geometry/vector.hpp"
#include "host/picture/camera_view.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {
namespace {

namespace oracle = algorithms::oracle;
using picture::PixelGrid;
using scene::PolyCamera;
using scene::PolyPoint;
using scene::PolyScene;

constexpr int points_a_side = 256;
constexpr std::size_t most_faces = 1000;
constexpr double least_steps = 16;  // per pixel, of the starting points of sight lines

// The position of a pixel's centre in the image plane (PolyCamera).
picture::PixelPoint image_point(const registry::FaceWindow& window, int column, int row) {
  return {(column + 0.5 - window.left) / window.scale,
          (window.top - (window.height - row - 0.5)) / window.scale};
}

// The camera's vectors, of length 1.
struct CameraAxes {
  explicit CameraAxes(const PolyCamera& camera)
      : CameraAxes(picture::CameraView(camera)) {}

  geometry::RealVector right;
  geometry::RealVector up;
  geometry::RealVector forward;

 private:
  explicit CameraAxes(const picture::CameraView& view) : right(view.axis(0)), up(view.axis(1)), forward(view.axis(2)) {}
};

// A point of the image as an integer direction, accurate to less than a thousandth of a pixel.
oracle::PixelSight sight_in_perspective(const PolyCamera& camera, const registry::FaceWindow& window) {
  constexpr double length = 1 << 18;  // of its forward component; directions are below 2^20
  return [eye = camera.eye, axes = CameraAxes(camera), window](int column, int row) {
    const auto [x, y] = image_point(window, column, row);
    oracle::SightLine line{eye, {}};
    for (std::size_t a = 0; a < 3; ++a)
      line.along[a] = std::llround(length * (axes.forward[a] + x * axes.right[a] + y * axes.up[a]));
    return line;
  };
}

// Sight lines without perspective start at integer points. The scene is enlarged to the limit of coordinates, to make
// these points dense.
std::int32_t enlargement(const PolyScene& scene) {
  return static_cast<std::int32_t>((scene::poly_coordinate_limit - 1) / scene::bounds_of(scene).half_size());
}

// The scene for sight_in_parallel, enlarged about its centre.
PolyScene enlarge(PolyScene scene) {
  const PolyPoint middle = scene::bounds_of(scene).middle();
  const std::int32_t times = enlargement(scene);
  for (PolyPoint& v : scene.vertices)
    for (std::size_t a = 0; a < 3; ++a) v[a] = times * (v[a] - middle[a]);
  return scene;
}

// A sight line that starts 2 half sizes before the centre is in front of the whole scene.
oracle::PixelSight sight_in_parallel(const PolyScene& scene, const PolyCamera& camera, const registry::FaceWindow& window) {
  const CameraAxes axes(camera);
  std::array<double, 3> from{};  // of the centre of the image
  double ahead = -2.0 * static_cast<double>(scene::bounds_of(scene).half_size());
  for (std::size_t a = 0; a < 3; ++a) {
    from[a] = camera.eye[a] - scene::bounds_of(scene).middle()[a];
    ahead -= axes.forward[a] * from[a];
  }
  return [along = geometry::vector_of(camera.forward), times = enlargement(scene), from, ahead, axes, window](int column, int row) {
    const auto [x, y] = image_point(window, column, row);
    oracle::SightLine line{{}, along};
    for (std::size_t a = 0; a < 3; ++a)
      line.from[a] = static_cast<std::int32_t>(
          std::lround(times * (from[a] + x * axes.right[a] + y * axes.up[a] + ahead * axes.forward[a])));
    return line;
  };
}

// In points of the grid, whose centres are integers, rows from the bottom.
std::vector<picture::PixelSegment> image_of_edges(const PolyScene& scene, const PolyCamera& camera,
                                                  const registry::FaceWindow& window) {
  ScreenFrame frame;
  frame.scale = window.scale;
  frame.centre = {window.left - 0.5, window.height - window.top - 0.5};
  frame.low = -1;
  frame.high = points_a_side;
  frame.near = 1e-6;
  std::vector<picture::PixelSegment> segments;
  for (const picture::LineEdge& edge : picture::edges_of(scene)) {
    const SeenEdge seen(scene.vertices[edge.from], scene.vertices[edge.to], camera);
    if (const auto part = seen.part_in(frame)) segments.push_back(seen.pixels_of(*part, frame));
  }
  return segments;
}

}  // namespace

struct FaceTruth::Sights {
  PolyScene scene;  // as used by the sight lines
  oracle::PixelSight at;
  std::vector<oracle::FaceHit> faces;  // by number, less 1
};

FaceTruth::FaceTruth(const PolyScene& scene, const PolyCamera& camera, const registry::FaceWindow& window)
    : scene_(&scene),
      camera_(camera),
      window_(window),
      edges_(image_of_edges(scene, camera, window)) {
  Sights sights{camera.perspective ? scene : enlarge(scene),
                camera.perspective ? sight_in_perspective(camera, window) : sight_in_parallel(scene, camera, window),
                {}};
  for (std::size_t body = 0; body < scene.bodies.size(); ++body)
    for (std::size_t face = 0; face < scene.bodies[body].faces.size(); ++face) sights.faces.push_back({body, face});
  faces_ = oracle::nearest_faces(sights.scene, window.width, window.height, sights.at);
  sights_ = std::make_shared<const Sights>(std::move(sights));
}

base::Result<FaceTruth> FaceTruth::of(const PolyScene& scene, const PolyCamera& camera) {
  if (const std::size_t faces = scene::face_count(scene); faces > most_faces)
    return base::bad_input(fmt::format("found {} faces, expected at most {} for the oracle of sight lines",
                                  faces, most_faces));
  const registry::FaceWindow window =
      registry::face_window(scene, camera, points_a_side, points_a_side, std::nullopt);
  if (!camera.perspective && enlargement(scene) / window.scale < least_steps)
    return base::bad_input("the scene is too deep, compared with its image, for the oracle of sight lines");
  return FaceTruth(scene, camera, window);
}

base::Result<ComparedFaces> FaceTruth::compare(const registry::FaceAlgorithm& algorithm, bool host_times) const {
  registry::FaceOptions options;
  options.vertical = scene::frame_of(camera_).vertical;
  options.most_pairs = most_willis_pairs;
  auto prepared = algorithm.prepare(*scene_, options);
  if (!prepared) return std::move(prepared.error());
  const auto& faces = *prepared;
  auto view = faces.view(camera_, window_);
  if (!view) return std::move(view.error());
  ComparedFaces result = compare(std::string(algorithm.name), std::move(view->faces), faces.not_solved.size());
  result.counts = faces.counts;
  result.counts.insert(result.counts.end(), view->counts.begin(), view->counts.end());
  for (const registry::FaceCount& count : result.counts)
    if (count.name == wrong_orders_name) result.not_solved += static_cast<std::size_t>(count.value);
  const auto machine = std::find_if(result.counts.begin(), result.counts.end(), [](const auto& count) { return count.name == t_states_name; });
  if (machine != result.counts.end())
    result.emulated_seconds = core::in_seconds(core::TStates(static_cast<std::int64_t>(machine->value)));
  else if (host_times)
    result.host_seconds = median_seconds([&] { static_cast<void>(faces.view(camera_, window_)); });
  return result;
}

ComparedFaces FaceTruth::compare(std::string name, PixelGrid drawn, std::size_t not_solved) const {
  PixelGrid truth = faces_;
  for (int row = 0; row < window_.height; ++row) {
    for (int column = 0; column < window_.width; ++column) {
      const std::uint32_t right = faces_.at(column, row);
      const std::uint32_t shown = drawn.at(column, row);
      if (right == shown || right == 0 || shown == 0) continue;
      if (oracle::hit_at_same_point(sights_->scene, sights_->at(column, row), sights_->faces[right - 1], sights_->faces[shown - 1]))
        truth.set(column, row, shown);
    }
  }
  const auto metrics = picture::pixel_metrics(truth, drawn, edges_);
  return ComparedFaces{std::move(name), metrics, std::move(truth), std::move(drawn), not_solved, {}, {}, {}};
}

}  // namespace sightline::compare
