#include "host/scene/model/locate.hpp"

#include <algorithm>

#include "host/base/result.hpp"
#include "host/scene/check/problems.hpp"

namespace sightline::scene {

base::Result<std::size_t> locate(const CellScene& scene, const geometry::Point& point) {
  std::vector<std::size_t> around;
  for (std::size_t c = 0; c < scene.cells.size(); ++c) {
    if (scene.cells[c].box.contains(point)) around.push_back(c);
  }
  if (around.size() == 1) return around[0];
  if (around.empty()) {
    const std::string place = "point " + text_of(point);
    for (std::size_t s = 0; s < scene.solids.size(); ++s) {
      if (scene.solids[s].contains(point))
        return base::Error{"", place, "is inside solid " + std::to_string(s)};
    }
    const bool inside = scene.outer.contains(point);
    return base::Error{"", place, inside ? "is in no cell" : "is outside the outer box"};
  }
  for (const Opening& opening : scene.openings) {
    if (opening.place.bounds().contains(point)) return std::min(opening.cells[0], opening.cells[1]);
  }
  const auto looked_into = std::find_if(around.begin(), around.end(),
                                        [&](std::size_t c) { return point[2] < scene.cells[c].box.high[2]; });
  return looked_into == around.end() ? around[0] : *looked_into;
}

}  // namespace sightline::scene
