// See compare_faces.hpp.
#include "host/harness/compare_faces.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "host/algorithms/oracle/sight_oracle.hpp"
#include "host/geometry/predicates.hpp"
#include "host/harness/compare_projection.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/aim_camera.hpp"

namespace sightline::harness {
namespace {

using picture::PixelGrid;
using scene::PolyCamera;
using scene::PolyScene;

constexpr int side = 256;
constexpr std::size_t most_faces = 1000;

std::size_t faces_of(const PolyScene& scene) {
  std::size_t faces = 0;
  for (const scene::PolyBody& body : scene.bodies) faces += body.faces.size();
  return faces;
}

// A point of the image as a direction of whole numbers, to less than a thousandth of a point.
geometry::Vector3 direction_at(const PolyCamera& camera, double x, double y) {
  constexpr double length = 1 << 18;  // of its part ahead; directions are below 2^20
  const auto part = [](const scene::PolyPoint& axis, double times, std::size_t a) {
    const geometry::Vector3 v = geometry::vector_of(axis);
    return times * static_cast<double>(v[a]) / std::sqrt(static_cast<double>(geometry::dot(v, v)));
  };
  geometry::Vector3 direction{};
  for (std::size_t a = 0; a < 3; ++a)
    direction[a] = std::llround(
        length * (part(camera.forward, 1, a) + part(camera.right, x, a) + part(camera.up, y, a)));
  return direction;
}

PixelGrid nearest_faces(const PolyScene& scene, const PolyCamera& camera, const FaceWindow& window) {
  std::vector<std::uint32_t> faces_before;
  std::uint32_t count = 1;
  for (const scene::PolyBody& body : scene.bodies) {
    faces_before.push_back(count);
    count += static_cast<std::uint32_t>(body.faces.size());
  }
  PixelGrid grid(window.width, window.height);
  for (int row = 0; row < window.height; ++row) {
    const double y = (window.top - (window.height - row - 0.5)) / window.scale;
    for (int column = 0; column < window.width; ++column) {
      const double x = (column + 0.5 - window.left) / window.scale;
      const auto met = algorithms::oracle::nearest_face(scene, camera.eye, direction_at(camera, x, y));
      if (met) grid.set(column, row, faces_before[met->body] + static_cast<std::uint32_t>(met->face));
    }
  }
  return grid;
}

// In points of the grid, whose middles are whole numbers, rows from the bottom.
std::vector<picture::PixelSegment> image_of_edges(const PolyScene& scene, const PolyCamera& camera,
                                                  const FaceWindow& window) {
  ScreenFrame frame;
  frame.scale = window.scale;
  frame.centre = {window.left - 0.5, window.height - window.top - 0.5};
  frame.low = -1;
  frame.high = side;
  frame.near = 1e-6;
  std::vector<picture::PixelSegment> segments;
  for (const picture::LineEdge& edge : picture::edges_of(scene)) {
    const SeenEdge seen(scene.vertices[edge.from], scene.vertices[edge.to], camera);
    if (const auto part = seen.part_in(frame)) segments.push_back(seen.pixels_of(*part, frame));
  }
  return segments;
}

}  // namespace

FaceTruth::FaceTruth(const PolyScene& scene, const PolyCamera& camera)
    : scene_(&scene),
      camera_(camera),
      window_(face_window(scene, camera, side, side, std::nullopt)),
      faces_(nearest_faces(scene, camera, window_)),
      edges_(image_of_edges(scene, camera, window_)) {}

std::variant<FaceTruth, std::string> FaceTruth::of(const PolyScene& scene, const PolyCamera& camera) {
  if (!camera.perspective) return std::string("the oracle of sight lines knows views in perspective only");
  if (const std::size_t faces = faces_of(scene); faces > most_faces)
    return fmt::format("{} faces are too many for the oracle of sight lines, which takes {}", faces,
                       most_faces);
  return FaceTruth(scene, camera);
}

std::variant<ComparedFaces, scene::SceneError> FaceTruth::compared(const FaceAlgorithm& algorithm) const {
  FaceOptions options;
  options.vertical = scene::frame_of(camera_).vertical;
  auto prepared = algorithm.prepare(*scene_, options);
  if (auto* error = std::get_if<scene::SceneError>(&prepared)) return std::move(*error);
  const auto& faces = std::get<PreparedFaces>(prepared);
  auto view = faces.view(camera_, window_);
  if (auto* error = std::get_if<scene::SceneError>(&view)) return std::move(*error);
  PixelGrid& drawn = std::get<FaceView>(view).faces;
  const auto metrics = picture::pixel_metrics(faces_, drawn, edges_);
  return ComparedFaces{std::string(algorithm.name), metrics, faces_, std::move(drawn),
                       faces.not_solved.size()};
}

}  // namespace sightline::harness
