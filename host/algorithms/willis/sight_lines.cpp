#include "host/algorithms/willis/sight_lines.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <vector>

#include "host/algorithms/willis/frame.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::willis {

namespace {

// The corners of a piece in space; for a wall in plan, of the rectangle that stands on it.
std::vector<Point> corners_of(const Model& model, const Surface& s) {
  if (!model.plan) return s.points;
  std::vector<Point> corners{s.points[0], s.points[1], s.points[1], s.points[0]};
  for (std::size_t i = 0; i < 4; ++i) corners[i][model.vertical] = (i < 2 ? s.low : s.high) * lattice_unit;
  return corners;
}

// A piece prepared for many lines from one eye.
struct SeenPiece {
  Vector3 normal;
  Int128 distance;                           // of the eye from the plane, times the length of the normal
  std::vector<std::array<Int128, 3>> sides;  // of the pyramid over the polygon: normals, below 2^68
};

SeenPiece seen_from(const scene::PolyPoint& eye, const SurfacePlane& plane, const std::vector<Point>& corners) {
  const Point from = on_lattice(eye);
  SeenPiece seen{plane.normal, geometry::wide_dot(plane.normal, geometry::vector_of(eye)) - plane.offset, {}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3 a = between(corners[i], from);
    const Vector3 b = between(corners[(i + 1) % corners.size()], from);
    seen.sides.push_back({Int128{a[1]} * b[2] - Int128{a[2]} * b[1], Int128{a[2]} * b[0] - Int128{a[0]} * b[2],
                          Int128{a[0]} * b[1] - Int128{a[1]} * b[0]});
  }
  return seen;
}

// Whether the line from the eye along d (components below 2^12) passes through the inside of the polygon.
bool passes(const SeenPiece& piece, const Vector3& d) {
  bool left = false;
  bool right = false;
  for (const auto& side : piece.sides) {
    const Int128 volume = side[0] * d[0] + side[1] * d[1] + side[2] * d[2];
    if (volume == 0) return false;
    (volume > 0 ? left : right) = true;
    if (left && right) return false;
  }
  return left || right;
}

// One line: the number of pieces it hits, and the positions in the order of the nearest and of the highest.
struct Hits {
  int count = 0;
  std::size_t nearest = 0;
  std::size_t highest = 0;
};

// The pieces are given in ascending priority.
Hits hits_of(const std::vector<SeenPiece>& pieces, const Vector3& d) {
  Hits hits;
  Int128 nearest_num = 0;
  Int128 nearest_den = 1;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const SeenPiece& piece = pieces[k];
    const Int128 den = -geometry::wide_dot(piece.normal, d);
    if (den <= 0 || !passes(piece, d)) continue;
    const Int128 num = piece.distance;
    hits.highest = k;
    if (hits.count++ > 0 && num * nearest_den >= nearest_num * den) continue;
    hits.nearest = k;
    nearest_num = num;
    nearest_den = den;
  }
  return hits;
}

Vector3 level_direction(std::size_t vertical, std::mt19937& random) {
  Vector3 d{};
  for (std::size_t a = 0; a < 3; ++a)
    d[a] = a == vertical ? 0 : static_cast<std::int64_t>(random() % 2001) - 1000;
  return d;
}

// A direction past a corner of the polygon.
Vector3 direction_near(const std::vector<Point>& corners, const Point& from, std::mt19937& random) {
  const Vector3 to = between(corners[random() % corners.size()], from);
  const std::int64_t size = std::max({std::abs(to[0]), std::abs(to[1]), std::abs(to[2])}) / 1000 + 1;
  Vector3 d{};
  for (std::size_t a = 0; a < 3; ++a) d[a] = to[a] / size + static_cast<std::int64_t>(random() % 41) - 20;
  return d;
}

std::optional<scene::PolyPoint> random_eye(const Model& model, const scene::PolyScene& scene,
                                           const scene::PolyBounds& bounds, std::mt19937& random) {
  scene::PolyPoint eye{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto size = static_cast<std::int32_t>(bounds.high[a] - bounds.low[a]);
    const bool level = model.plan && a == model.vertical;
    const std::int32_t margin = level ? 0 : size / 4 + 2;
    eye[a] = bounds.low[a] - margin +
             static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(size + 2 * margin + 1));
  }
  if (scene::eye_place(scene, eye).kind != scene::EyePlace::Kind::free) return std::nullopt;
  return eye;
}

}  // namespace

void count_lines(const Model& model, const scene::PolyPoint& eye, std::span<const std::uint32_t> order,
                 int lines, std::mt19937& random, SightLines& count) {
  if (order.empty()) return;
  std::vector<std::vector<Point>> corners;
  std::vector<SeenPiece> pieces;
  for (const std::uint32_t piece : order) {
    corners.push_back(corners_of(model, model.pieces[piece]));
    pieces.push_back(seen_from(eye, model.pieces[piece].plane, corners.back()));
  }
  for (int i = 0; i < lines; ++i) {
    const Vector3 d = model.plan
                          ? level_direction(model.vertical, random)
                          : direction_near(corners[random() % corners.size()], on_lattice(eye), random);
    const Hits hits = hits_of(pieces, d);
    if (hits.count < 2) continue;
    ++count.with_two;
    count.wrong += model.pieces[order[hits.nearest]].face != model.pieces[order[hits.highest]].face;
  }
}

SightLines count_lines(const Model& model, const scene::PolyScene& scene, std::uint64_t wanted,
                       std::uint32_t seed) {
  std::mt19937 random(seed);
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  Frames frames(model);
  SightLines count;
  for (int views = 0; count.with_two < wanted && views < 100'000; ++views) {
    const auto eye = random_eye(model, scene, bounds, random);
    if (!eye) continue;
    scene::PolyCamera camera = scene.camera;
    camera.perspective = true;
    camera.eye = *eye;
    std::vector<std::uint32_t> representatives;
    for (const Surface& s : model.pieces)
      representatives.push_back(static_cast<std::uint32_t>(random() % s.points.size()));
    count_lines(model, camera.eye, frames.order(camera, representatives), 60, random, count);
  }
  return count;
}

}  // namespace sightline::algorithms::willis
