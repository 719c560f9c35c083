// See willis_views.hpp.
#include "host/compare/hard_cases/willis_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <span>
#include <utility>

#include "host/algorithms/oracle/face_raster.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/geometry/vector.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

namespace {

namespace willis = algorithms::willis;
using picture::PixelGrid;
using picture::PixelSegment;
using scene::PolyCamera;
using scene::PolyPoint;
using scene::PolyScene;

// Coordinates along right, up and forward. In an image 90 degrees wide, visible points have |x|, |y| <= z.
std::array<double, 3> before_camera(const PolyCamera& camera, const PolyPoint& p) {
  const geometry::RealVector d = geometry::difference(geometry::real_vector(p), geometry::real_vector(camera.eye));
  const auto along = [&d](const PolyPoint& axis) { return geometry::dot(geometry::real_vector(axis), d); };
  return {along(camera.right), along(camera.up), along(camera.forward)};
}

// The part of an edge before the camera, on the raster, clipped slightly outside the image.
std::optional<PixelSegment> image_of(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                     int size) {
  constexpr double wider = 1.1;
  double low = 0;
  double high = 1;
  const auto keep = [&](double at_p, double at_q) {
    if (at_p < 0 && at_q < 0) high = -1;
    if (at_p < 0 && at_q >= 0) low = std::max(low, at_p / (at_p - at_q));
    if (at_p >= 0 && at_q < 0) high = std::min(high, at_p / (at_p - at_q));
  };
  for (const std::size_t a : {0U, 1U}) {
    keep(wider * p[2] - p[a], wider * q[2] - q[a]);
    keep(wider * p[2] + p[a], wider * q[2] + q[a]);
  }
  if (low >= high) return std::nullopt;
  const auto at = [&](double part) -> std::optional<picture::PixelPoint> {
    const double z = p[2] + part * (q[2] - p[2]);
    if (!(z > 0)) return std::nullopt;
    const auto on_raster = [&](std::size_t a) {
      return size / 2.0 * (1 + (p[a] + part * (q[a] - p[a])) / z) - 0.5;
    };
    return picture::PixelPoint{on_raster(0), on_raster(1)};
  };
  const auto a = at(low);
  const auto b = at(high);
  if (!a || !b) return std::nullopt;
  return PixelSegment{*a, *b};
}

std::vector<PixelSegment> edges_of(const PolyScene& scene, const PolyCamera& camera, int size) {
  std::vector<PixelSegment> edges;
  const auto add = [&](std::span<const scene::VertexIndex> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto edge = image_of(before_camera(camera, scene.vertices[ring[i]]),
                                 before_camera(camera, scene.vertices[ring[(i + 1) % ring.size()]]), size);
      if (edge) edges.push_back(*edge);
    }
  };
  for (const scene::PolyBody& body : scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      add(face.outline);
      for (const auto& hole : face.holes) add(hole);
    }
  }
  return edges;
}

constexpr std::array<PolyPoint, 4> level_directions{{{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}}};

// right x up = forward, with up along y.
PolyCamera level_camera(const PolyPoint& eye, const PolyPoint& forward) {
  return {true, eye, forward, {forward[2], 0, -forward[0]}, {0, 1, 0}};
}

}  // namespace

PixelGrid ordered_faces(const willis::Model& model, const PolyCamera& camera, int size,
                        willis::Representatives representatives) {
  const willis::ImageWindow window{size, size, size / 2.0, size / 2.0, size / 2.0};
  willis::Frames frames(model);
  willis::FrameSpans spans;
  willis::make_spans(model, frames.order(camera, representatives), camera, window, spans);
  return willis::resolve_priorities(spans, window);
}

std::vector<std::uint32_t> random_corners(const willis::Model& model, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> corners;
  for (const willis::Surface& s : model.pieces)
    corners.push_back(static_cast<std::uint32_t>(random() % s.points.size()));
  return corners;
}

void FaceErrors::add(const FaceErrors& other) {
  points += other.points;
  inside += other.inside;
  wrong_inside += other.wrong_inside;
  wrong_on_edges += other.wrong_on_edges;
}

double FaceErrors::inside_per_cent() const {
  return inside > 0 ? 100 * static_cast<double>(wrong_inside) / static_cast<double>(inside) : 0;
}

TrueFaces::TrueFaces(const PolyScene& scene, std::vector<PolyCamera> cameras, int size)
    : cameras_(std::move(cameras)), size_(size) {
  for (const PolyCamera& camera : cameras_) {
    truths_.push_back(algorithms::oracle::nearest_faces(scene, {camera, size, size}));
    edges_.push_back(edges_of(scene, camera, size));
  }
}

FaceErrors TrueFaces::errors_of(const PixelGrid& drawn, std::size_t view) const {
  const picture::PixelMetrics metrics = picture::pixel_metrics(truths_[view], drawn, edges_[view]);
  return {metrics.pixels, metrics.pixels - metrics.boundary_pixels, metrics.different_inside,
          metrics.different_on_boundary};
}

FaceErrors TrueFaces::errors_of(const willis::Model& model) const {
  FaceErrors errors;
  for (std::size_t view = 0; view < cameras_.size(); ++view) errors.add(errors_of(draw(model, view), view));
  return errors;
}

PixelGrid TrueFaces::draw(const willis::Model& model, std::size_t view) const {
  const auto corners = random_corners(model, static_cast<std::uint32_t>(view) + 1);
  return ordered_faces(model, cameras_[view], size_, corners);
}

std::vector<PolyCamera> cameras_within(const PolyScene& scene, std::size_t count) {
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  std::mt19937 random(1);
  std::vector<PolyCamera> cameras;
  for (int tries = 0; cameras.size() < count && tries < 10'000; ++tries) {
    PolyPoint eye{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto size = static_cast<std::uint32_t>(bounds.high[a] - bounds.low[a]) + 1;
      eye[a] = bounds.low[a] + static_cast<std::int32_t>(random() % size);
    }
    if (scene::eye_place(scene, eye).kind == scene::EyePlace::Kind::free)
      cameras.push_back(level_camera(eye, level_directions[cameras.size() % level_directions.size()]));
  }
  return cameras;
}

std::vector<PolyCamera> cameras_around(const PolyScene& scene, std::int32_t height) {
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  const PolyPoint middle = bounds.middle();
  std::vector<PolyCamera> cameras;
  for (const PolyPoint& forward : level_directions) {
    PolyCamera camera = level_camera({middle[0], height, middle[2]}, forward);
    std::int64_t away = 0;
    for (const std::size_t a : {0U, 2U})
      away = std::max(away, (bounds.high[a] - bounds.low[a]) * std::int64_t{5} / 7 + 3);
    bool there = true;
    for (const std::size_t a : {0U, 2U}) {
      const std::int64_t at = camera.eye[a] - away * forward[a] + away / 11 * camera.right[a];
      there = there && std::abs(at) < scene::poly_coordinate_limit;
      camera.eye[a] = static_cast<std::int32_t>(there ? at : 0);
    }
    if (there && scene::eye_place(scene, camera.eye).kind == scene::EyePlace::Kind::free)
      cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace sightline::compare
