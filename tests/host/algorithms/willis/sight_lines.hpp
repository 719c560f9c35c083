// Exact sight lines through a model: what is hit, what is nearest, and whether it has the highest priority.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <span>
#include <vector>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/eye_place.hpp"
#include "host/scene/poly_bounds.hpp"

namespace sightline::algorithms::willis {

// The corners of a piece in space; of a wall in plan the rectangle that stands on it.
inline std::vector<Point> corners_of(const Model& model, const Surface& s) {
  if (!model.plan) return s.points;
  std::vector<Point> corners{s.points[0], s.points[1], s.points[1], s.points[0]};
  for (std::size_t i = 0; i < 4; ++i) corners[i][model.vertical] = (i < 2 ? s.low : s.high) * lattice_unit;
  return corners;
}

// The line from the eye along d (components below 2^12) passes the inside of the polygon.
inline bool passes(const std::vector<Point>& corners, const Point& eye, const Vector3& d) {
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3 a = between(corners[i], eye);
    const Vector3 b = between(corners[(i + 1) % corners.size()], eye);
    const Int128 volume = (Int128{a[1]} * b[2] - Int128{a[2]} * b[1]) * d[0] +
                          (Int128{a[2]} * b[0] - Int128{a[0]} * b[2]) * d[1] +
                          (Int128{a[0]} * b[1] - Int128{a[1]} * b[0]) * d[2];
    if (volume == 0) return false;
    (volume > 0 ? left : right) = true;
  }
  return left != right;
}

struct SightLines {
  std::uint64_t with_two = 0;  // lines that hit two or more pieces turned to the eye
  std::uint64_t wrong = 0;     // of them, those on which not the nearest has the highest priority
};

// Lines from one eye; the pieces in ascending priority.
inline void count_lines(const Model& model, const scene::PolyPoint& eye, std::span<const std::uint32_t> order,
                        int lines, std::mt19937& random, SightLines& count) {
  std::vector<std::vector<Point>> corners;
  for (const std::uint32_t piece : order) corners.push_back(corners_of(model, model.pieces[piece]));
  const Point from = on_lattice(eye);
  for (int i = 0; i < lines; ++i) {
    // Towards a point of some piece, so that most lines hit something.
    if (order.empty()) return;
    const Surface& target = model.pieces[order[random() % order.size()]];
    const Vector3 to = between(corners_of(model, target)[random() % target.points.size()], from);
    Vector3 d{};
    const std::int64_t size = std::max({std::abs(to[0]), std::abs(to[1]), std::abs(to[2])}) / 1000 + 1;
    for (std::size_t a = 0; a < 3; ++a) d[a] = to[a] / size + static_cast<std::int64_t>(random() % 41) - 20;
    bool any = false;
    Int128 nearest_num = 0;
    Int128 nearest_den = 1;
    std::size_t nearest = 0;
    std::size_t highest = 0;
    int hits = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const SurfacePlane& plane = model.pieces[order[k]].plane;
      const Int128 den = -geometry::wide_dot(plane.normal, d);
      if (den <= 0 || !passes(corners[k], from, d)) continue;
      const Int128 num = geometry::wide_dot(plane.normal, geometry::vector_of(eye)) - plane.offset;
      ++hits;
      highest = k;
      if (any && num * nearest_den >= nearest_num * den) continue;
      any = true;
      nearest = k;
      nearest_num = num;
      nearest_den = den;
    }
    if (hits < 2) continue;
    ++count.with_two;
    count.wrong += model.pieces[order[nearest]].face != model.pieces[order[highest]].face;
  }
}

// From random places in free space within and around the scene; of a model in plan from among the walls.
inline SightLines count_lines(const Model& model, const scene::PolyScene& scene, std::uint64_t wanted,
                              std::uint32_t seed) {
  std::mt19937 random(seed);
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  Frames frames(model);
  SightLines count;
  for (int views = 0; count.with_two < wanted && views < 100'000; ++views) {
    scene::PolyCamera camera = scene.camera;
    camera.perspective = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto size = static_cast<std::int32_t>(bounds.high[a] - bounds.low[a]);
      const bool level = model.plan && a == model.vertical;
      const std::int32_t margin = level ? 0 : size / 4 + 2;
      camera.eye[a] = bounds.low[a] - margin +
                      static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(size + 2 * margin + 1));
    }
    if (scene::eye_place(scene, camera.eye).kind != scene::EyePlace::Kind::free) continue;
    std::vector<std::uint32_t> representatives;
    for (const Surface& s : model.pieces)
      representatives.push_back(static_cast<std::uint32_t>(random() % s.points.size()));
    count_lines(model, camera.eye, frames.order(camera, representatives), 60, random, count);
  }
  return count;
}

}  // namespace sightline::algorithms::willis
