#include "host/algorithms/montani_re/edges_behind_sheets.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/box_tree.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/poly_triangulate.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using geometry::Box;
using geometry::Point2;

using Rings = std::vector<std::vector<Point2>>;

// A face of a sheet, in its own plane; coordinates doubled, so that middles of edges are integers.
struct SheetFace {
  std::size_t body = 0;
  std::size_t face = 0;
  geometry::Plane plane;
  int eye_side = 0;
  std::size_t dropped = 0;  // axis
  Rings rings;
};

Point2 doubled(const scene::PolyPoint& p, std::size_t dropped) {
  const Point2 flat = geometry::flattened(p, dropped);
  return {2 * flat[0], 2 * flat[1]};
}

int eye_side_of(const geometry::Plane& plane, const scene::PolyCamera& camera) {
  return camera.perspective
             ? plane.side(camera.eye)
             : -geometry::sign(geometry::dot(plane.normal, geometry::vector_of(camera.forward)));
}

Box box_of(const scene::PolyScene& scene, const std::vector<scene::VertexIndex>& corners) {
  Box box{scene.vertices[corners[0]], scene.vertices[corners[0]]};
  for (const scene::VertexIndex v : corners) {
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], scene.vertices[v][a]);
      box.high[a] = std::max(box.high[a], scene.vertices[v][a]);
    }
  }
  return box;
}

std::vector<SheetFace> sheet_faces(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  std::vector<SheetFace> faces;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!scene.bodies[b].sheet) continue;
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f) {
      const scene::PolyFace& face = scene.bodies[b].faces[f];
      SheetFace flat{b, f, {}, 0, 0, {}};
      flat.plane.normal = scene::ring_normal(scene.vertices, face.outline);
      flat.plane.offset =
          geometry::dot(flat.plane.normal, geometry::vector_of(scene.vertices[face.outline[0]]));
      flat.eye_side = eye_side_of(flat.plane, camera);
      flat.dropped = geometry::dominant_axis(flat.plane.normal);
      const auto add = [&](const std::vector<scene::VertexIndex>& ring) {
        auto& points = flat.rings.emplace_back();
        for (const scene::VertexIndex v : ring) points.push_back(doubled(scene.vertices[v], flat.dropped));
      };
      add(face.outline);
      for (const auto& hole : face.holes) add(hole);
      faces.push_back(std::move(flat));
    }
  }
  return faces;
}

bool inside(const Rings& rings, const Point2& p) {
  if (geometry::locate_in_ring(rings[0], p) <= 0) return false;
  return std::all_of(rings.begin() + 1, rings.end(),
                     [&p](const auto& hole) { return geometry::locate_in_ring(hole, p) < 0; });
}

bool crosses(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return geometry::sign(geometry::turn(a, b, c)) * geometry::sign(geometry::turn(a, b, d)) < 0 &&
         geometry::sign(geometry::turn(c, d, a)) * geometry::sign(geometry::turn(c, d, b)) < 0;
}

// Some of the segment is in the inside of the face: an end or the middle, or it crosses the outline.
bool runs_inside(const SheetFace& face, const scene::PolyPoint& from, const scene::PolyPoint& to) {
  const Point2 a = doubled(from, face.dropped);
  const Point2 b = doubled(to, face.dropped);
  const Point2 middle{a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2};
  if (inside(face.rings, a) || inside(face.rings, b) || inside(face.rings, middle)) return true;
  for (const auto& ring : face.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (crosses(a, b, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1])) return true;
  }
  return false;
}

// The corners lie in the sheet's plane or beyond it, and some beyond it.
bool stands_behind(const scene::PolyScene& scene, const SheetFace& sheet,
                   const std::vector<scene::VertexIndex>& corners) {
  bool beyond = false;
  for (const scene::VertexIndex v : corners) {
    const int side = sheet.plane.side(scene.vertices[v]) * sheet.eye_side;
    if (side > 0) return false;
    beyond = beyond || side < 0;
  }
  return beyond;
}

bool touches(const scene::PolyScene& scene, const SheetFace& sheet,
             const std::vector<scene::VertexIndex>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const scene::PolyPoint& from = scene.vertices[ring[i]];
    const scene::PolyPoint& to = scene.vertices[ring[i + 1 == ring.size() ? 0 : i + 1]];
    if (sheet.plane.side(from) == 0 && sheet.plane.side(to) == 0 && runs_inside(sheet, from, to)) return true;
  }
  return false;
}

}  // namespace

std::optional<std::string> edge_behind_sheet(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  const std::vector<SheetFace> sheets = sheet_faces(scene, camera);
  if (sheets.empty()) return std::nullopt;
  std::vector<Box> boxes;
  for (const SheetFace& sheet : sheets)
    boxes.push_back(box_of(scene, scene.bodies[sheet.body].faces[sheet.face].outline));
  const geometry::BoxTree tree(boxes);
  std::optional<std::string> found;
  for (std::size_t b = 0; b < scene.bodies.size() && !found; ++b) {
    for (std::size_t f = 0; f < scene.bodies[b].faces.size() && !found; ++f) {
      const scene::PolyFace& face = scene.bodies[b].faces[f];
      tree.for_each_touching(box_of(scene, face.outline), [&](std::uint32_t number) {
        const SheetFace& sheet = sheets[number];
        if (found || sheet.eye_side == 0 || !stands_behind(scene, sheet, face.outline)) return;
        bool touched = touches(scene, sheet, face.outline);
        for (const auto& hole : face.holes) touched = touched || touches(scene, sheet, hole);
        if (!touched) return;
        found = "face " + std::to_string(f) + " of body " + std::to_string(b) + " ends on the back of face " +
                std::to_string(sheet.face) + " of body " + std::to_string(sheet.body) +
                ", where others draw a line through the sheet and regions have none";
      });
    }
  }
  return found;
}

}  // namespace sightline::algorithms::montani_re
