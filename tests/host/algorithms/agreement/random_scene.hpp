// Random scenes and cameras, degenerate about half of the time: bodies that touch, overlap, are coplanar or nested, with few
// different coordinates; eyes in planes of faces and in line with edges.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_builder.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms {

// The same numbers on every platform: library distributions are not used.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}

  // Including both ends.
  std::int32_t between(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(random_() % static_cast<std::uint32_t>(high - low + 1));
  }
  bool one_in(std::int32_t n) { return between(1, n) == 1; }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  scene::PolyPoint point(std::int32_t low, std::int32_t high) {
    scene::PolyPoint p{};
    for (std::int32_t& c : p) c = between(low, high);
    return p;
  }

 private:
  std::mt19937 random_;
};

class RandomScene {
 public:
  explicit RandomScene(std::uint32_t seed) : dice_(seed) {
    // Few coordinates make coincidences, many make general position.
    const std::int32_t sizes[] = {4, 6, 10, 40, 3000};
    size_ = sizes[dice_.below(std::size(sizes))];
    const std::int32_t bodies = dice_.between(1, 8);
    for (std::int32_t b = 0; b < bodies; ++b) {
      const scene::PolyBuilder before = builder_;
      add_body();
      if (!scene::check_poly_scene(builder_.scene()).empty()) builder_ = before;
    }
    if (builder_.scene().bodies.empty()) builder_.add_box("", {0, 0, 0}, {1, 2, 3});
  }

  // Chooses another view of the scene; false if no position for the eye was found.
  bool look() {
    for (int tries = 0; tries < 50; ++tries) {
      const scene::PolyCamera camera = some_camera();
      if (scene::eye_error(builder_.scene(), camera)) continue;
      builder_.scene().camera = camera;
      return true;
    }
    return false;
  }

  const scene::PolyScene& scene() { return builder_.scene(); }

 private:
  using Point = scene::PolyPoint;
  using Ring = scene::Ring;

  void add_body() {
    switch (dice_.below(8)) {
      case 0:
      case 1: add_box(); break;
      case 2: add_tetrahedron(); break;
      case 3: add_prism(); break;
      case 4: add_frame(); break;
      case 5: add_hollow_box(); break;
      case 6: add_rectangle(); break;
      default: add_triangle(); break;
    }
  }

  // A box with low < high on every axis, at least `least` apart.
  std::pair<Point, Point> some_box(std::int32_t least) {
    Point low{};
    Point high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = dice_.between(0, std::max(0, size_ - least));
      high[a] = low[a] + dice_.between(least, std::max(least, size_ / 2));
    }
    return {low, high};
  }

  Ring ring(std::initializer_list<Point> points) {
    Ring vertices;
    for (const Point& p : points) vertices.push_back(builder_.vertex(p));
    return vertices;
  }

  void add_box() {
    const auto [low, high] = some_box(1);
    builder_.add_box("", low, high);
  }

  void add_tetrahedron() {
    Point p[4];
    for (Point& corner : p) corner = dice_.point(0, size_);
    const auto normal = geometry::normal_of(p[0], p[1], p[2]);
    if (geometry::dot(normal, geometry::difference(p[3], p[0])) > 0) std::swap(p[1], p[2]);
    scene::PolyBody body;
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}})
      body.faces.push_back({ring({p[a], p[b], p[c]}), {}});
    builder_.scene().bodies.push_back(std::move(body));
  }

  // A leaning prism over a non-convex L: its sides are parallelograms.
  void add_prism() {
    const auto [low, high] = some_box(2);
    const std::int32_t x = dice_.between(low[0] + 1, high[0] - 1);
    const std::int32_t y = dice_.between(low[1] + 1, high[1] - 1);
    const std::int32_t lean = dice_.one_in(2) ? 0 : dice_.between(-2, 2);
    const std::vector<std::array<std::int32_t, 2>> corners = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], y}, {x, y}, {x, high[1]}, {low[0], high[1]}};
    scene::PolyBody body;
    body.faces.resize(2);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& [ax, ay] = corners[i];
      const auto& [bx, by] = corners[(i + 1) % corners.size()];
      const Point a{ax, ay, low[2]};
      const Point b{bx, by, low[2]};
      const Point c{bx + lean, by, high[2]};
      const Point d{ax + lean, ay, high[2]};
      body.faces.push_back({ring({a, b, c, d}), {}});
      body.faces[0].outline.insert(body.faces[0].outline.begin(), builder_.vertex(a));
      body.faces[1].outline.push_back(builder_.vertex(d));
    }
    builder_.scene().bodies.push_back(std::move(body));
  }

  // A box with a square hole through it: two of its faces have holes.
  void add_frame() {
    const auto [low, high] = some_box(3);
    const std::size_t bodies = builder_.scene().bodies.size();
    builder_.add_box("", low, high);
    Point from = low;
    Point to = high;
    for (const std::size_t a : {0U, 1U}) {
      from[a] = dice_.between(low[a] + 1, high[a] - 2);
      to[a] = dice_.between(from[a] + 1, high[a] - 1);
    }
    auto tunnel = inside_out(from, to);
    std::vector<scene::PolyFace>& faces = builder_.scene().bodies[bodies].faces;
    for (const std::int32_t z : {low[2], high[2]}) {
      const auto in_plane = [&](const scene::PolyFace& face) {
        return std::all_of(face.outline.begin(), face.outline.end(),
                           [&](scene::VertexIndex v) { return builder_.scene().vertices[v][2] == z; });
      };
      const auto lid = std::find_if(tunnel.begin(), tunnel.end(), in_plane);
      std::find_if(faces.begin(), faces.end(), in_plane)->holes.push_back(lid->outline);
      tunnel.erase(lid);
    }
    faces.insert(faces.end(), tunnel.begin(), tunnel.end());
  }

  void add_hollow_box() {
    const auto [low, high] = some_box(3);
    const std::size_t bodies = builder_.scene().bodies.size();
    builder_.add_box("", low, high);
    Point from{};
    Point to{};
    for (std::size_t a = 0; a < 3; ++a) {
      from[a] = dice_.between(low[a] + 1, high[a] - 2);
      to[a] = dice_.between(from[a] + 1, high[a] - 1);
    }
    const auto cavity = inside_out(from, to);
    std::vector<scene::PolyFace>& faces = builder_.scene().bodies[bodies].faces;
    faces.insert(faces.end(), cavity.begin(), cavity.end());
  }

  // The faces of a box, turned inwards.
  std::vector<scene::PolyFace> inside_out(const Point& low, const Point& high) {
    builder_.add_box("", low, high);
    auto faces = std::move(builder_.scene().bodies.back().faces);
    builder_.scene().bodies.pop_back();
    for (scene::PolyFace& face : faces) std::reverse(face.outline.begin(), face.outline.end());
    return faces;
  }

  // A rectangle perpendicular to an axis, perhaps with a door that is a hole or reaches its border.
  void add_rectangle() {
    const auto [low, high] = some_box(3);
    const std::size_t axis = dice_.below(3);
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    const auto at = [&, at_low = low](std::int32_t on_u, std::int32_t on_v) {
      Point p = at_low;
      p[u] = on_u;
      p[v] = on_v;
      return p;
    };
    const std::int32_t u0 = dice_.between(low[u] + 1, high[u] - 2);
    const std::int32_t u1 = dice_.between(u0 + 1, high[u] - 1);
    const std::int32_t v0 = dice_.between(low[v] + 1, high[v] - 2);
    const std::int32_t v1 = dice_.between(v0 + 1, high[v] - 1);
    scene::PolyFace face{
        ring({at(low[u], low[v]), at(high[u], low[v]), at(high[u], high[v]), at(low[u], high[v])}), {}};
    switch (dice_.below(3)) {
      case 0: break;
      case 1: face.holes.push_back(ring({at(u0, v0), at(u0, v1), at(u1, v1), at(u1, v0)})); break;
      default:
        face.outline = ring({at(low[u], low[v]), at(u0, low[v]), at(u0, v1), at(u1, v1), at(u1, low[v]),
                             at(high[u], low[v]), at(high[u], high[v]), at(low[u], high[v])});
    }
    builder_.scene().bodies.push_back({"", true, {std::move(face)}});
  }

  void add_triangle() {
    const Point corners[] = {dice_.point(0, size_), dice_.point(0, size_), dice_.point(0, size_)};
    builder_.add_sheet("", corners);
  }

  const Point& some_vertex() {
    const auto& vertices = builder_.scene().vertices;
    return vertices[dice_.below(vertices.size())];
  }

  scene::PolyCamera some_camera() {
    scene::PolyCamera camera;
    camera.perspective = !dice_.one_in(4);
    camera.eye = some_eye();
    do {
      camera.forward = dice_.one_in(4) ? difference(some_vertex(), camera.eye) : dice_.point(-3, 3);
      // Level directions belong to a turn about y.
      if (!camera.perspective && dice_.one_in(2)) camera.forward[1] = 0;
      camera.forward = short_vector(camera.forward);
      // The other vectors must stay below 2^15: the direction of a long one is approximated.
      while (std::any_of(camera.forward.begin(), camera.forward.end(),
                         [](std::int32_t c) { return std::abs(c) >= 1 << 6; }))
        for (std::int32_t& c : camera.forward) c /= 2;
      camera.right = short_vector(across(camera.forward, dice_.point(-1, 1)));
      camera.up = short_vector(across(camera.right, camera.forward));
    } while (camera.right == Point{});
    return camera;
  }

  Point some_eye() {
    Point eye = dice_.point(-size_, 2 * size_);
    switch (dice_.below(4)) {
      case 0: break;
      case 1:  // in planes of faces across the axes
        for (std::int32_t& c : eye)
          if (dice_.one_in(2)) c = some_vertex()[static_cast<std::size_t>(&c - eye.data())];
        break;
      case 2: eye = beyond(some_vertex(), some_vertex()); break;
      default: {  // in line with an edge
        const auto& bodies = builder_.scene().bodies;
        const auto& faces = bodies[dice_.below(bodies.size())].faces;
        const Ring& outline = faces[dice_.below(faces.size())].outline;
        const std::size_t i = dice_.below(outline.size());
        const auto& vertices = builder_.scene().vertices;
        eye = beyond(vertices[outline[i]], vertices[outline[(i + 1) % outline.size()]]);
      }
    }
    return eye;
  }

  Point beyond(const Point& a, const Point& b) {
    Point p = b;
    const std::int32_t times = dice_.between(1, 3);
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += times * (b[axis] - a[axis]);
    return p;
  }

  static Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static Point across(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Point short_vector(Point p) {
    const std::int32_t common = std::gcd(std::gcd(p[0], p[1]), p[2]);
    for (std::int32_t& c : p) c /= std::max(common, 1);
    return p;
  }

  Dice dice_;
  std::int32_t size_ = 0;
  scene::PolyBuilder builder_;
};

}  // namespace sightline::algorithms
