// See poly_builder.hpp.
#include "host/scene/model/poly_builder.hpp"

#include <utility>

namespace sightline::scene {

VertexIndex PolyBuilder::vertex(const PolyPoint& p) {
  std::uint64_t key = 0;
  for (const std::int32_t c : p) key = key << 21 | static_cast<std::uint64_t>(c + (1 << 20));
  const auto [place, added] = indices_.try_emplace(key, static_cast<VertexIndex>(scene_.vertices.size()));
  if (added) scene_.vertices.push_back(p);
  return place->second;
}

void PolyBuilder::add_box(std::string name, const PolyPoint& low, const PolyPoint& high) {
  PolyBody body;
  body.name = std::move(name);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const bool upper : {false, true}) {
      PolyPoint corner{};
      corner[axis] = upper ? high[axis] : low[axis];
      PolyFace face;
      // Counterclockwise seen from the high side, the other way round on the low side.
      constexpr bool along_u[] = {false, true, true, false};
      constexpr bool along_v[] = {false, false, true, true};
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t k = upper ? i : 3 - i;
        corner[u] = along_u[k] ? high[u] : low[u];
        corner[v] = along_v[k] ? high[v] : low[v];
        face.outline.push_back(vertex(corner));
      }
      body.faces.push_back(std::move(face));
    }
  }
  scene_.bodies.push_back(std::move(body));
}

void PolyBuilder::add_sheet(std::string name, std::span<const PolyPoint> outline) {
  PolyBody body;
  body.name = std::move(name);
  body.sheet = true;
  body.faces.emplace_back();
  for (const PolyPoint& p : outline) body.faces.back().outline.push_back(vertex(p));
  scene_.bodies.push_back(std::move(body));
}

}  // namespace sightline::scene
