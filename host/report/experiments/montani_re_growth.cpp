//   views      a generated scene each, from its own camera, in perspective, on 1024 x 1024 pixels: faces that
//              take part (not turned away, not edge-on), pairs of them that overlap in X (tests 2 to 6 are
//              for these), relations, sides in stripes of a pixel of all that is seen and of the last
//              silhouette, times of this computer
//   exponents  a family each: of growth over its faces, and of times over pairs
#include "host/report/experiments/montani_re_growth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {

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

struct StripesView {
  std::size_t faces = 0;
  native::RegionCounts counts;
  native::StripeRaster picture;
};

// Relations and list, then the raster.
StripesView stripes_of(const scene::PolyScene& scene) {
  const auto faces = native::faces_of(scene, scene.camera);
  const native::ListedFaces listed = native::listed_faces(*faces);
  return {faces->faces.size(), listed.counts,
          native::raster_by_difference(faces->image, listed.list, listed.faces,
                                       frame_of(*faces, scene.camera), 16)};
}

NamedValues view_of(std::string_view family, std::size_t size, const scene::PolyScene& scene, int rounds) {
  const StripesView view = stripes_of(scene);
  std::uint64_t pairs = 0;
  for (std::size_t test = 2; test < view.counts.decided_by.size(); ++test)
    pairs += view.counts.decided_by[test];
  NamedValues row{{"family", family},
                  {"size", size},
                  {"faces", view.faces},
                  {"y_complexity", 2 * static_cast<double>(pairs) / static_cast<double>(view.faces)},
                  {"pairs", pairs},
                  {"relations", view.counts.relations},
                  {"sides_seen", view.picture.sides},
                  {"silhouette_sides", view.picture.silhouette_sides}};
  const std::array<std::function<void()>, 3> jobs{
      [&scene] { (void)native::visible_edges(scene, scene.camera); }, [&scene] { (void)stripes_of(scene); },
      [&scene] { (void)algorithms::exact::visible_edges(scene, scene.camera); }};
  std::vector<double> times;
  if (rounds > 0) times = median_nanoseconds(jobs, size < long_scene ? rounds : 1);
  constexpr std::array<std::string_view, 3> keys{"exact_build_ms", "stripes_ms", "exact_ms"};
  for (std::size_t i = 0; i < keys.size(); ++i)
    row.emplace_back(keys[i], times.empty() ? Value() : Value(times[i] / 1e6));
  return row;
}

}  // namespace

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

Value growth_exponent(const RowSet& rows, std::size_t from, std::size_t to, std::string_view key,
                      std::string_view over, std::size_t fewest) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t row = from; row < to; ++row) {
    const auto x = rows.at(row, over).number();
    const auto y = rows.at(row, key).number();
    if (x && y && *y > 0) points.emplace_back(*x, *y);
  }
  return points.size() >= fewest ? Value(growth_exponent(points)) : Value();
}

void add_montani_re_growth(Records& records, std::string_view family, std::span<const std::size_t> sizes,
                           int rounds, const std::function<void(std::string_view)>& progress) {
  RowSet& views = records["views"];
  const std::size_t first = views.size();
  for (const std::size_t size : sizes) {
    progress(fmt::format("views of {} {}", family, size));
    views.add(view_of(family, size, *scene::generate_scene(family, size), rounds));
  }
  const auto exponent = [&](std::string_view key, std::string_view over = "faces") {
    return growth_exponent(views, first, views.size(), key, over, 2);
  };
  records["exponents"].add({{"family", family},
                            {"from_faces", views.at(first, "faces")},
                            {"to_faces", views.at(views.size() - 1, "faces")},
                            {"pairs", exponent("pairs")},
                            {"relations", exponent("relations")},
                            {"exact_build", exponent("exact_build_ms")},
                            {"stripes", exponent("stripes_ms")},
                            {"exact", exponent("exact_ms")},
                            {"exact_build_over_pairs", exponent("exact_build_ms", "pairs")}});
}

Records montani_re_growth(const Context& context) {
  std::vector<std::size_t> sizes{100, 300, 1000};
  if (context.full) sizes.push_back(long_scene);
  Records records;
  for (const std::string_view family : {"boxes", "town"})
    add_montani_re_growth(records, family, sizes,
                          !context.host_times ? 0
                          : context.full      ? 5
                                              : 3,
                          context.progress);
  return records;
}

}  // namespace sightline::report
