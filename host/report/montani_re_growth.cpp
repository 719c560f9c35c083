#include "host/report/montani_re_growth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::montani_re;

constexpr std::int32_t raster = 1024;
constexpr std::size_t long_scene = 10000;  // one view of it takes seconds

// All of the faces.
native::StripeFrame frame_of(const native::FaceSet& set, const scene::PolyCamera& camera) {
  std::array<double, 2> low{1e300, 1e300};
  std::array<double, 2> high{-1e300, -1e300};
  for (const native::Face& face : set.faces) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], face.low[axis].approximate);
      high[axis] = std::max(high[axis], face.high[axis].approximate);
    }
  }
  native::StripeFrame frame{{}, {}, raster, raster};
  const auto unit = native::pixels_a_unit(camera, 1);
  const double size = std::max((high[0] - low[0]) * unit[0], (high[1] - low[1]) * unit[1]);
  frame.scale = native::pixels_a_unit(camera, raster / size);
  for (std::size_t axis = 0; axis < 2; ++axis) frame.centre[axis] = -low[axis] * frame.scale[axis];
  return frame;
}

// Relations and list, then the raster.
native::StripeRaster stripes_of(const scene::PolyScene& scene, MontaniReSize* measured) {
  const auto faces = native::faces_of(scene, scene.camera);
  const auto& set = *faces;
  const native::ListedFaces listed = native::listed_faces(set);
  auto picture =
      native::raster_by_difference(set.image, listed.list, listed.faces, frame_of(set, scene.camera), 16);
  if (measured != nullptr) {
    measured->faces = set.faces.size();
    for (std::size_t test = 2; test < listed.counts.decided_by.size(); ++test)
      measured->pairs += listed.counts.decided_by[test];
    measured->relations = listed.counts.relations;
    measured->sides_seen = picture.sides;
    measured->silhouette_sides = picture.silhouette_sides;
  }
  return picture;
}

}  // namespace

MontaniReGrowth montani_re_growth(std::string_view family, std::span<const std::size_t> sizes, int rounds,
                                  const std::function<void(std::string_view)>& progress) {
  MontaniReGrowth growth{family, {}};
  for (const std::size_t size : sizes) {
    progress(fmt::format("views of {} {}", family, size));
    const auto scene = *scene::generate_scene(family, size);
    MontaniReSize& measured = growth.sizes.emplace_back();
    measured.size = size;
    (void)stripes_of(scene, &measured);
    if (rounds == 0) continue;
    const std::array<std::function<void()>, 3> jobs{
        [&scene] { (void)native::visible_edges(scene, scene.camera); },
        [&scene] { (void)stripes_of(scene, nullptr); },
        [&scene] { (void)algorithms::exact::visible_edges(scene, scene.camera); }};
    const auto times = sightline::report::median_nanoseconds(jobs, size < long_scene ? rounds : 1);
    measured.native_ns = times[0];
    measured.stripes_ns = times[1];
    measured.exact_ns = times[2];
  }
  return growth;
}

double growth_exponent(const std::vector<std::pair<double, double>>& points) {
  if (points.size() < 2) return 0;
  double x_mean = 0;
  double y_mean = 0;
  const auto count = static_cast<double>(points.size());
  for (const auto& [x, y] : points) {
    x_mean += std::log(x) / count;
    y_mean += std::log(y) / count;
  }
  double covariance = 0;
  double variance = 0;
  for (const auto& [x, y] : points) {
    covariance += (std::log(x) - x_mean) * (std::log(y) - y_mean);
    variance += (std::log(x) - x_mean) * (std::log(x) - x_mean);
  }
  return variance > 0 ? covariance / variance : 0;
}

}  // namespace sightline::harness::report
