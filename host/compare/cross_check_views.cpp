// Windows and places of pixels. See cross_check_scenes.hpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "host/compare/cross_check_scenes.hpp"

namespace sightline::compare {
namespace {

using scene::PolyPoint;
using scene::PolyScene;

std::int64_t dot(const PolyPoint& a, const PolyPoint& b) {
  return geometry::dot(geometry::vector_of(a), geometry::vector_of(b));
}

}  // namespace

harness::FaceWindow AgreementView::window() const {
  const double half = size / 2.0;
  const double length = std::sqrt(static_cast<double>(dot(camera.right, camera.right)));
  return {size, size, camera.perspective ? unit / 2.0 : 1 / (2.0 * unit * length), half, half};
}

// A point in lengths of right, up and forward from the eye.
std::array<double, 3> AgreementView::in_camera(const PolyPoint& point) const {
  const auto d = geometry::difference(point, camera.eye);
  const double length = std::sqrt(static_cast<double>(dot(camera.right, camera.right)));
  std::array<double, 3> coordinates{};
  for (std::size_t a = 0; const PolyPoint& axis : {camera.right, camera.up, camera.forward})
    coordinates[a++] = static_cast<double>(geometry::dot(geometry::vector_of(axis), d)) / length;
  return coordinates;
}

picture::PixelPoint AgreementView::project(const std::array<double, 3>& p) const {
  const double scale = window().scale / (camera.perspective ? p[2] : 1);
  const double middle = size / 2.0 - 0.5;
  return {middle + scale * p[0], middle + scale * p[1]};
}

bool AgreementView::has_place(const PolyPoint& point) const {
  return !camera.perspective || in_camera(point)[2] >= nearest;
}

picture::PixelPoint AgreementView::place(const PolyPoint& point) const {
  return project(in_camera(point));
}

std::optional<picture::PixelSegment> AgreementView::place(const PolyPoint& from, const PolyPoint& to,
                                                          const picture::LinePart& piece) const {
  const auto a = in_camera(from);
  const auto b = in_camera(to);
  auto [low, high] = piece;
  if (camera.perspective) {
    if (std::max(a[2], b[2]) < nearest) return std::nullopt;
    const double at_nearest = (nearest - a[2]) / (b[2] - a[2]);
    if (a[2] < nearest) low = std::max(low, at_nearest);
    if (b[2] < nearest) high = std::min(high, at_nearest);
    if (low >= high) return std::nullopt;
  }
  const auto at = [&](double s) {
    return project({a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2])});
  };
  return picture::PixelSegment{at(low), at(high)};
}

AgreementView parallel_view(const PolyScene& scene, std::int32_t p, std::int32_t q, std::int32_t h,
                            int size) {
  AgreementView view;
  view.size = size;
  view.camera = {false, {}, {p, 0, q}, {q, 0, -p}, {0, h, 0}};
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  std::array<std::int64_t, 3> low{most, most, most};
  std::array<std::int64_t, 3> high{-most, -most, -most};
  const std::array<PolyPoint, 3> axes{view.camera.right, view.camera.up, view.camera.forward};
  for (const PolyPoint& v : scene.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], dot(axes[a], v));
      high[a] = std::max(high[a], dot(axes[a], v));
    }
  }
  // Before everything in the middle of it, in lengths of the vectors.
  const std::int64_t square = std::int64_t{h} * h;
  const std::array<std::int64_t, 3> eye{(low[0] + high[0]) / 2 / square, (low[1] + high[1]) / 2 / square,
                                        low[2] / square - 2};
  for (std::size_t a = 0; a < 3; ++a)
    view.camera.eye[a] =
        static_cast<std::int32_t>(eye[0] * axes[0][a] + eye[1] * axes[1][a] + eye[2] * axes[2][a]);
  const std::int64_t extent = std::max(high[0] - low[0], high[1] - low[1]) / square;
  constexpr std::int64_t border = 4;  // pixels, on both sides
  view.unit = static_cast<std::int32_t>(extent / (2 * (size - 2 * border)) + 1);
  return view;
}

}  // namespace sightline::compare
