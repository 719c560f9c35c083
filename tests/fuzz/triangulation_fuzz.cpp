// Any bytes as points of the plane: triangles that turn counterclockwise and have no point within their circles, and heights sampled on
// them that are within those of the points.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "host/scene/heights/delaunay.hpp"
#include "host/scene/heights/interpolate.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  if (size < 1) return 0;
  // Small coordinates, with many points on one line and one circle, or large ones.
  const std::int32_t scale = data[0] % 2 == 0 ? 1 : 2040;
  std::vector<geometry::Point2> points;
  std::vector<scene::ScatteredPoint> scattered;
  for (std::size_t i = 1; i + 1 < size && points.size() < 100; i += 2) {
    points.push_back({(data[i] - 128) * scale, (data[i + 1] - 128) * scale});
    scattered.push_back({1e3 * data[i], 1e-3 * data[i + 1], static_cast<double>(data[i] ^ data[i + 1])});
  }
  for (const auto& t : scene::delaunay(points)) {
    if (geometry::turn(points[t[0]], points[t[1]], points[t[2]]) <= 0) std::abort();
    for (const auto& p : points)
      if (scene::in_circle(points[t[0]], points[t[1]], points[t[2]], p) > 0) std::abort();
  }
  const auto grid = scene::interpolated(scattered, {2 + size % 30, 2 + size % 7}, "fuzz");
  if (!grid) return 0;
  for (const double height : grid->heights)
    if (height < -1e-6 || height > 255 + 1e-6) std::abort();
  return 0;
}
