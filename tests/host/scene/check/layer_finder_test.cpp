// Layers of triangles, compared with a test of every pair.
#include "host/scene/check/layer_finder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "host/scene/check/crossings.hpp"

namespace sightline::scene {
namespace {

using Flat = std::array<std::int64_t, 2>;

std::int64_t turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Two triangles, turned to the left, overlap unless all of one is beyond a side of the other.
bool overlap(const std::array<Flat, 3>& a, const std::array<Flat, 3>& b) {
  const auto parts = [](const std::array<Flat, 3>& of, const std::array<Flat, 3>& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      bool all = true;
      for (const Flat& p : other) all = all && turn(of[i], of[(i + 1) % 3], p) <= 0;
      if (all) return true;
    }
    return false;
  };
  return !parts(a, b) && !parts(b, a);
}

// For a viewer at +axis or -axis.
bool is_layer_for(const std::vector<PolyPoint>& vertices, const std::vector<Triangle>& triangles, std::size_t axis, bool minus) {
  std::vector<std::array<Flat, 3>> seen;
  for (const Triangle& triangle : triangles) {
    auto& flat = seen.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      flat[i] = {vertices[triangle[i]][(axis + 1) % 3], vertices[triangle[i]][(axis + 2) % 3]};
      if (minus) std::swap(flat[i][0], flat[i][1]);
    }
    if (turn(flat[0], flat[1], flat[2]) <= 0) return false;
  }
  for (std::size_t a = 0; a < seen.size(); ++a)
    for (std::size_t b = a + 1; b < seen.size(); ++b)
      if (overlap(seen[a], seen[b])) return false;
  return true;
}

bool is_layer_for_somebody(const std::vector<PolyPoint>& vertices, const std::vector<Triangle>& triangles) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool minus : {false, true})
      if (is_layer_for(vertices, triangles, axis, minus)) return true;
  return false;
}

std::size_t sides_of(const std::vector<Triangle>& triangles) {
  std::map<std::pair<VertexIndex, VertexIndex>, int> surplus;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++surplus[{t[i], t[(i + 1) % 3]}];
      --surplus[{t[(i + 1) % 3], t[i]}];
    }
  }
  std::size_t sides = 0;
  for (const auto& [edge, count] : surplus) sides += count > 0 ? 1 : 0;
  return sides;
}

// Parts of a surface of random heights, seen from each side: layers, with holes, parts that touch in a corner, and parts that do not.
TEST(LayerFinder, FindsEachPartOfASurfaceThatRisesOverAPlane) {
  std::mt19937 generator(3);
  const auto below = [&generator](std::uint32_t limit) { return static_cast<std::uint32_t>(generator() % limit); };
  std::size_t found = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::size_t axis = below(3);
    const bool minus = below(2) == 0;
    const std::uint32_t size = 2 + below(6);
    std::vector<PolyPoint> vertices;
    for (std::uint32_t y = 0; y <= size; ++y) {
      for (std::uint32_t x = 0; x <= size; ++x) {
        PolyPoint p{};
        p[axis] = static_cast<std::int32_t>(below(1000));
        p[(axis + 1) % 3] = static_cast<std::int32_t>(100 * x + below(40));
        p[(axis + 2) % 3] = static_cast<std::int32_t>(100 * y + below(40));
        if (minus) p[axis] = -p[axis];
        vertices.push_back(p);
      }
    }
    const std::uint32_t percent = 20 + below(81);
    std::vector<Triangle> triangles;
    for (std::uint32_t y = 0; y < size; ++y) {
      for (std::uint32_t x = 0; x < size; ++x) {
        const std::uint32_t at = y * (size + 1) + x;
        for (Triangle t : {Triangle{at, at + 1, at + size + 2}, Triangle{at, at + size + 2, at + size + 1}}) {
          if (below(100) >= percent) continue;
          if (minus) std::swap(t[1], t[2]);
          triangles.push_back(t);
        }
      }
    }
    if (triangles.empty()) continue;
    ASSERT_TRUE(is_layer_for(vertices, triangles, axis, minus)) << round;
    if (sides_of(triangles) > triangles.size() + 2) continue;
    LayerFinder finder(vertices);
    // If another viewer sees all fronts, too, the parts may overlap for that one.
    const bool layer = finder.is_layer(triangles);
    bool only = true;
    for (std::size_t other = 0; other < 3; ++other) {
      for (const bool other_minus : {false, true}) {
        if (other == axis && other_minus == minus) continue;
        bool fronts = true;
        for (const Triangle& t : triangles) fronts = fronts && is_layer_for(vertices, {t}, other, other_minus);
        only = only && !fronts;
      }
    }
    if (only) {
      EXPECT_TRUE(layer) << round;
      found += layer ? 1 : 0;
    }
  }
  EXPECT_GT(found, 1000U);
}

// Triangles between few points of few places, all turned to the viewer at +z: many share edges, corners and places.
TEST(LayerFinder, IsNeverWrong) {
  std::mt19937 generator(5);
  const auto below = [&generator](std::uint32_t limit) { return static_cast<std::uint32_t>(generator() % limit); };
  std::array<std::size_t, 2> counts{};
  for (int round = 0; round < 20000; ++round) {
    std::vector<PolyPoint> vertices;
    const std::uint32_t points = 4 + below(7);
    const std::uint32_t places = 3 + below(5);
    for (std::uint32_t i = 0; i < points; ++i)
      vertices.push_back({static_cast<std::int32_t>(below(places)), static_cast<std::int32_t>(below(places)),
                          static_cast<std::int32_t>(below(50))});
    std::vector<Triangle> triangles;
    const std::uint32_t wanted = 2 + below(6);
    for (int i = 0; i < 100 && triangles.size() < wanted; ++i) {
      const Triangle t{below(points), below(points), below(points)};
      if (!is_layer_for(vertices, {t}, 2, false)) continue;
      // Half of the time only triangles that fit the ones before, so that there are layers.
      triangles.push_back(t);
      if (round % 2 == 0 && !is_layer_for(vertices, triangles, 2, false)) triangles.pop_back();
    }
    if (triangles.size() < 2) continue;
    LayerFinder finder(vertices);
    const bool layer = finder.is_layer(triangles);
    ++counts[layer ? 1 : 0];
    if (layer) { ASSERT_TRUE(is_layer_for_somebody(vertices, triangles)) << round; }
  }
  EXPECT_GT(counts[0], 3000U);
  EXPECT_GT(counts[1], 3000U);
}

// A ramp that goes around more than once: each two neighbours are a layer, but the whole is not.
TEST(LayerFinder, ASpiralStairIsNone) {
  std::vector<PolyPoint> vertices;
  std::vector<Triangle> triangles;
  const std::vector<std::array<std::int32_t, 2>> ring{{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}};
  for (std::uint32_t step = 0; step < 9; ++step) {
    for (const std::int32_t times : {10, 20}) vertices.push_back({times * ring[step % 6][0], times * ring[step % 6][1], static_cast<std::int32_t>(5 * step)});
    if (step == 0) continue;
    const std::uint32_t at = 2 * step;
    triangles.push_back({at - 2, at - 1, at + 1});
    triangles.push_back({at - 2, at + 1, at});
    LayerFinder finder(vertices);
    // After six steps both ends are in the same place of the picture, which counts as a meeting of two sides.
    EXPECT_EQ(finder.is_layer(triangles), step < 6) << step;
  }
}

__extension__ using Wide = __int128;

int side_of(const PolyPoint& a, const PolyPoint& b, const PolyPoint& c, const PolyPoint& d) {
  const auto minus = [&a](const PolyPoint& p) { return std::array<Wide, 3>{p[0] - a[0], p[1] - a[1], p[2] - a[2]}; };
  const auto u = minus(b);
  const auto v = minus(c);
  const auto w = minus(d);
  const Wide volume = u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
  return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

// Bumpy spheres, some with spikes and folds and some two through each other: pairs of triangles without a common corner cross if and only
// if a side of one passes through the inside of the other.
TEST(LayerFinder, SpheresCrossWhereTheSidesOfTheirTrianglesPassThroughOthers) {
  std::mt19937 generator(9);
  const auto below = [&generator](std::uint32_t limit) { return static_cast<std::uint32_t>(generator() % limit); };
  std::size_t pairs = 0;
  for (int round = 0; round < 9; ++round) {
    PolyScene scene;
    std::vector<Triangle> triangles;
    for (int sphere = 0; sphere < 1 + round % 2; ++sphere) {
      constexpr std::uint32_t rings = 8;
      constexpr std::uint32_t columns = 14;
      const auto first = static_cast<VertexIndex>(scene.vertices.size());
      for (std::uint32_t i = 0; i <= rings; ++i) {
        for (std::uint32_t j = 0; j < (i % rings == 0 ? 1 : columns); ++j) {
          const double theta = 3.14159265358979 * i / rings;
          const double phi = 2 * 3.14159265358979 * j / columns;
          double radius = 1e5 * (1 + 0.1 * std::sin(3 * phi) * std::sin(theta));
          if (round % 3 != 0 && below(20) == 0) radius *= below(2) == 0 ? 0.3 : -0.2;
          const auto near = [&](double value) { return static_cast<std::int32_t>(value) + static_cast<std::int32_t>(below(100)); };
          scene.vertices.push_back({near(radius * std::sin(theta) * std::cos(phi)) + 70000 * sphere,
                                    near(radius * std::sin(theta) * std::sin(phi)), near(radius * std::cos(theta))});
        }
      }
      PolyBody body;
      const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return i == 0 ? first : first + 1 + (i - 1) * columns + (i == rings ? 0 : j % columns);
      };
      const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        triangles.push_back({a, b, c});
        body.faces.push_back({{a, b, c}, {}});
      };
      for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < columns; ++j) {
          if (i + 1 < rings) add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
          if (i > 0) add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
      }
      scene.bodies.push_back(body);
    }
    std::set<std::array<std::uint32_t, 2>> expected;
    std::set<std::array<std::uint32_t, 2>> unclear;  // with a common corner or points in one plane
    for (std::uint32_t a = 0; a < triangles.size(); ++a) {
      for (std::uint32_t b = a + 1; b < triangles.size(); ++b) {
        bool clear = true;
        bool cross = false;
        for (const VertexIndex v : triangles[a])
          for (const VertexIndex w : triangles[b]) clear = clear && v != w;
        for (const auto& [of, other] : {std::pair{a, b}, std::pair{b, a}}) {
          for (std::size_t i = 0; i < 3 && clear; ++i) {
            const auto corner = [&](std::uint32_t t, std::size_t k) { return scene.vertices[triangles[t][k % 3]]; };
            const PolyPoint p = corner(of, i);
            const PolyPoint q = corner(of, i + 1);
            const int from = side_of(corner(other, 0), corner(other, 1), corner(other, 2), p);
            const int to = side_of(corner(other, 0), corner(other, 1), corner(other, 2), q);
            int around = 0;
            for (std::size_t k = 0; k < 3; ++k) {
              const int side = side_of(p, q, corner(other, k), corner(other, k + 1));
              clear = clear && side != 0;
              around += side;
            }
            clear = clear && from != 0 && to != 0;
            cross = cross || (from != to && std::abs(around) == 3);
          }
        }
        if (!clear) unclear.insert({a, b});
        else if (cross) expected.insert({a, b});
      }
    }
    for (const unsigned jobs : {1U, 2U}) {
      std::set<std::array<std::uint32_t, 2>> found;
      for (const Crossing& crossing : crossings_of(scene, std::size_t{1} << 20, jobs))
        if (unclear.count({crossing.face_a, crossing.face_b}) == 0) found.insert({crossing.face_a, crossing.face_b});
      EXPECT_EQ(found, expected) << round;
    }
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 200U);
}

}  // namespace
}  // namespace sightline::scene
