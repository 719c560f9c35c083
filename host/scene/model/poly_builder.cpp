// See poly_builder.hpp.
#include "host/scene/model/poly_builder.hpp"

#include <array>
#include <utility>

namespace sightline::scene {

void PolyBuilder::add_box(std::string name, const PolyPoint& low, const PolyPoint& high) {
  PolyBody body;
  body.name = std::move(name);
  body.faces.reserve(6);
  // Each corner is added once: bit a of its number says whether it is high on axis a.
  constexpr VertexIndex unknown = ~VertexIndex{0};
  std::array<VertexIndex, 8> corners{};
  corners.fill(unknown);
  const auto corner_at = [&](const std::array<bool, 3>& upper) {
    VertexIndex& corner = corners[std::size_t{upper[0]} | std::size_t{upper[1]} << 1U | std::size_t{upper[2]} << 2U];
    if (corner == unknown)
      corner = vertex({upper[0] ? high[0] : low[0], upper[1] ? high[1] : low[1], upper[2] ? high[2] : low[2]});
    return corner;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const bool upper : {false, true}) {
      std::array<bool, 3> corner{};
      corner[axis] = upper;
      PolyFace& face = body.faces.emplace_back();
      face.outline.reserve(4);
      // Counterclockwise as seen from the high side, clockwise on the low side.
      constexpr bool along_u[] = {false, true, true, false};
      constexpr bool along_v[] = {false, false, true, true};
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t k = upper ? i : 3 - i;
        corner[u] = along_u[k];
        corner[v] = along_v[k];
        face.outline.push_back(corner_at(corner));
      }
    }
  }
  scene_.bodies.push_back(std::move(body));
}

void PolyBuilder::add_sheet(std::string name, std::span<const PolyPoint> outline) {
  PolyBody body;
  body.name = std::move(name);
  body.sheet = true;
  body.faces.emplace_back();
  body.faces.back().outline.reserve(outline.size());
  for (const PolyPoint& p : outline) body.faces.back().outline.push_back(vertex(p));
  scene_.bodies.push_back(std::move(body));
}

}  // namespace sightline::scene
