// See poly_from_cells.hpp.
#include "host/scene/model/poly_from_cells.hpp"

#include <utility>

#include "host/scene/model/poly_builder.hpp"

namespace sightline::scene {

PolyScene poly_scene_of(const CellScene& cells) {
  PolyBuilder builder;
  builder.scene().name = cells.name;
  for (std::size_t s = 0; s < cells.solids.size(); ++s)
    builder.add_box("solid " + std::to_string(s), cells.solids[s].low, cells.solids[s].high);
  PolyBody walls;
  walls.name = "walls";
  walls.sheet = true;
  for (const geometry::Rectangle& wall : cells.walls) {
    const auto [u, v] = geometry::other_axes(wall.axis);
    const geometry::Span& along_u = wall.sides[0];
    const geometry::Span& along_v = wall.sides[1];
    PolyFace face;
    for (const auto& [cu, cv] :
         {std::pair{along_u.low, along_v.low}, std::pair{along_u.high, along_v.low},
          std::pair{along_u.high, along_v.high}, std::pair{along_u.low, along_v.high}}) {
      PolyPoint corner{};
      corner[wall.axis] = wall.at;
      corner[u] = cu;
      corner[v] = cv;
      face.outline.push_back(builder.vertex(corner));
    }
    walls.faces.push_back(std::move(face));
  }
  if (!walls.faces.empty()) builder.scene().bodies.push_back(std::move(walls));
  builder.scene().camera = {true, cells.default_view, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  return builder.take();
}

}  // namespace sightline::scene
