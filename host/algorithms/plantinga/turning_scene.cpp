#include "host/algorithms/plantinga/turning_scene.hpp"

#include <algorithm>
#include <utility>

namespace sightline::algorithms::plantinga {
namespace {

// Whether the image of the edge is a point. Its visible part is then the same before and after, so no event records it.
bool seen_end_on(const Segment& edge, const Sight& sight) {
  const Vector3& a = edge.from;
  const Vector3& b = edge.to;
  return a[1] == b[1] && (b[0] - a[0]) * sight.z == (b[2] - a[2]) * sight.x;
}

}  // namespace

std::optional<std::string> why_not(const scene::PolyScene& scene) {
  const std::size_t count = picture::edges_of(scene).size();
  if (count <= most_edges) return std::nullopt;
  return "more than " + std::to_string(most_edges) + " edges";
}

std::optional<std::string> why_not_view(const scene::PolyScene&, const scene::PolyCamera& camera) {
  if (camera.perspective) return "it draws parallel projections only";
  if (!sight_of(camera)) return "it turns scenes about the y axis only, so the line of sight must be parallel to y = 0";
  return std::nullopt;
}

picture::LinePicture TurningScene::view(const Sight& sight) {
  {
    const base::Lock lock(mutex_);
    if (std::exchange(asked_, true) && model_.edges().size() <= most_turned_edges) {
      if (auto picture = turned_view(sight)) return std::move(*picture);
    }
  }
  return visible_edges(model_, sight);
}

std::optional<picture::LinePicture> TurningScene::turned_view(const Sight& sight) {
  if (!std::exchange(studied_, true)) {
    auto built = build_event_list(model_);
    if (built) {
      list_ = std::move(*built);
      graph_ = std::make_unique<EdgeStructureGraph>(list_);
    }
  }
  if (!graph_) return std::nullopt;
  const Direction here = rational_direction(sight.x, sight.z);
  const auto after =
      std::lower_bound(list_.events.begin(), list_.events.end(), here,
                       [](const Event& event, const Direction& d) { return less(event.direction, d); });
  if (after != list_.events.end() && after->direction == here) return std::nullopt;
  if (!graph_->turn_to_place(static_cast<std::size_t>(after - list_.events.begin()))) return std::nullopt;
  picture::LinePicture picture;
  for (EdgeIndex edge = 0; edge < model_.edges().size(); ++edge) {
    if (seen_end_on(model_.segment(edge), sight)) continue;
    append_pieces(model_, edge, graph_->structure_of(edge), sight, picture.pieces);
  }
  return picture;
}

}  // namespace sightline::algorithms::plantinga
