#include "host/compare/hard_cases/montani_re_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "host/algorithms/oracle/face_raster.hpp"
#include "host/geometry/vector.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

namespace {

namespace montani_re = algorithms::montani_re;
namespace oracle = algorithms::oracle;
using picture::PixelGrid;
using scene::PolyPoint;
using scene::PolyScene;

constexpr std::int32_t before_all = -(1 << 17);

double dot(const PolyPoint& a, const geometry::RealVector& b) { return geometry::dot(geometry::real_vector(a), b); }

double squared(const PolyPoint& v) { return dot(v, geometry::real_vector(v)); }

std::vector<picture::PixelSegment> edges_of(const PolyScene& scene, const montani_re::StripeFrame& frame) {
  const PixelPlane plane(scene.camera, frame);
  std::vector<picture::PixelSegment> segments;
  for (const picture::LineEdge& edge : picture::edges_of(scene))
    segments.push_back(plane.segment(scene.vertices[edge.from], scene.vertices[edge.to]));
  return segments;
}

}  // namespace

picture::PixelPoint PixelPlane::at(const std::array<double, 3>& point) const {
  const geometry::RealVector d = geometry::difference(point, geometry::real_vector(camera_.eye));
  const double depth = camera_.perspective ? dot(camera_.forward, d) : 1;
  return {frame_.centre[0] + frame_.scale[0] * dot(camera_.right, d) / depth - 0.5,
          frame_.centre[1] + frame_.scale[1] * dot(camera_.up, d) / depth - 0.5};
}

picture::PixelSegment PixelPlane::segment(const PolyPoint& from, const PolyPoint& to, double low,
                                          double high) const {
  const auto place = [&](double s) {
    std::array<double, 3> p{};
    for (std::size_t a = 0; a < 3; ++a) p[a] = from[a] + s * (to[a] - from[a]);
    return at(p);
  };
  return {place(low), place(high)};
}

PixelView pixels_along_z(const PolyScene& scene, const PixelParts& parts) {
  PolyScene fine = scene;
  std::array<std::int32_t, 2> low{std::numeric_limits<std::int32_t>::max(),
                                  std::numeric_limits<std::int32_t>::max()};
  std::array<std::int32_t, 2> high{std::numeric_limits<std::int32_t>::min(),
                                   std::numeric_limits<std::int32_t>::min()};
  for (PolyPoint& v : fine.vertices) {
    for (std::int32_t& c : v) c *= parts.times;
    for (std::size_t a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], v[a]);
      high[a] = std::max(high[a], v[a]);
    }
  }
  const auto pixel_of = [&](std::int32_t place, std::size_t a) {
    return static_cast<std::int32_t>(std::floor(static_cast<double>(place - parts.offset[a]) / parts.pixel));
  };
  // Leaves room for whole stripes of eight pixels below the scene.
  std::array<std::int32_t, 2> first{};
  for (std::size_t a = 0; a < 2; ++a)
    first[a] = 8 * static_cast<std::int32_t>(std::floor((pixel_of(low[a], a) - 1) / 8.0));
  PixelView view;
  view.frame.width = pixel_of(high[0], 0) + 8 - first[0];
  view.frame.height = pixel_of(high[1], 1) + 8 - first[1];
  for (std::size_t a = 0; a < 2; ++a) {
    view.frame.scale[a] = static_cast<double>(parts.times) / parts.pixel;
    // The image's origin is the camera's eye.
    view.frame.centre[a] =
        (static_cast<double>(parts.times) * scene.camera.eye[a] - parts.offset[a]) / parts.pixel - first[a];
  }
  view.truth = oracle::nearest_faces(fine, view.frame.width, view.frame.height, [&](int column, int row) {
    const PolyPoint eye{parts.pixel * (column + first[0]) + parts.pixel / 2 + parts.offset[0],
                        parts.pixel * (row + first[1]) + parts.pixel / 2 + parts.offset[1], before_all};
    return oracle::SightLine{eye, {0, 0, 1}};
  });
  view.edges = edges_of(scene, view.frame);
  return view;
}

PixelView pixels_in_perspective(const PolyScene& scene, const montani_re::FaceSet& set, std::int32_t size) {
  const scene::PolyCamera& camera = scene.camera;
  const double right = squared(camera.right);
  const double up = squared(camera.up);
  // Steps of a pixel along right and up, in halves.
  const auto steps = [](double mine, double other) {
    return std::max<std::int32_t>(1, static_cast<std::int32_t>(std::lround(std::sqrt(other / mine))));
  };
  const std::array<std::int32_t, 2> step{steps(right, up), steps(up, right)};
  const std::array<double, 2> unit{squared(camera.forward) / (2 * step[0] * right),
                                   squared(camera.forward) / (2 * step[1] * up)};
  std::array<double, 2> low{1e300, 1e300};
  std::array<double, 2> high{-1e300, -1e300};
  for (const montani_re::Face& face : set.faces) {
    for (std::size_t a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], face.low[a].approximate);
      high[a] = std::max(high[a], face.high[a].approximate);
    }
  }
  double across = 0;
  for (std::size_t a = 0; a < 2; ++a) across = std::max(across, (high[a] - low[a]) * unit[a]);
  const auto focal = static_cast<std::int32_t>((size - 24) / across);
  PixelView view;
  view.frame.width = view.frame.height = size;
  std::array<std::int32_t, 2> shift{};
  for (std::size_t a = 0; a < 2; ++a) {
    view.frame.scale[a] = focal * unit[a];
    shift[a] = static_cast<std::int32_t>(std::lround((low[a] + high[a]) / 2 * view.frame.scale[a]));
    view.frame.centre[a] = size / 2.0 - shift[a];
  }
  view.truth = oracle::nearest_faces(scene, view.frame.width, view.frame.height, [&](int column, int row) {
    const std::int64_t x = std::int64_t{step[0]} * (2 * (column + shift[0]) + 1 - size);
    const std::int64_t y = std::int64_t{step[1]} * (2 * (row + shift[1]) + 1 - size);
    oracle::SightLine line{camera.eye, {}};
    for (std::size_t a = 0; a < 3; ++a)
      line.along[a] = focal * std::int64_t{camera.forward[a]} + x * camera.right[a] + y * camera.up[a];
    return line;
  });
  view.edges = edges_of(scene, view.frame);
  return view;
}

PixelGrid grid_of(const PolyScene& scene, const montani_re::FaceSet& set, const montani_re::StripeRaster& raster) {
  const auto firsts = scene::first_face_numbers(scene);
  PixelGrid grid(raster.width, raster.height);
  for (std::size_t i = 0; i < raster.faces.size(); ++i) {
    if (raster.faces[i] == montani_re::none) continue;
    const montani_re::Face& face = set.faces[raster.faces[i]];
    grid.values[i] = firsts[face.body] + face.index;
  }
  return grid;
}

double square_pixels(const montani_re::StripePcs& pcs, std::int32_t units) {
  double sixteenths = 0;
  for (const auto& stripe : pcs.stripes) {
    for (const montani_re::StripeBand& band : stripe) {
      for (std::size_t k = 0; k + 1 < band.sides.size(); k += 2) {
        const auto across = [&](std::int32_t at) {
          return static_cast<double>(band.sides[k + 1].at(at) - band.sides[k].at(at)) / (16 * 65536);
        };
        sixteenths += (band.high - band.low) * (across(band.low) + across(band.high)) / 2;
      }
    }
  }
  return sixteenths / units;
}

}  // namespace sightline::compare
