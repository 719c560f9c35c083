// The BSP tree of faces: its counts by hand, and the order in which it paints compared with single sight lines.
#include "host/report/experiments/face_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "host/scene/generate/scene.hpp"

namespace sightline::report {
namespace {

using Point = std::array<double, 3>;

double at(const geometry::Plane& plane, const Point& p) {
  return static_cast<double>(plane.normal[0]) * p[0] + static_cast<double>(plane.normal[1]) * p[1] + static_cast<double>(plane.normal[2]) * p[2] -
         static_cast<double>(plane.offset);
}

// The place where a line meets a polygon: eye + t (towards - eye).
std::optional<double> meeting(const FaceTree& tree, const scene::PlanePolygon& polygon, const Point& eye, const Point& towards) {
  const geometry::Plane& plane = tree.planes()[polygon.plane];
  const double from = at(plane, eye);
  const double to = at(plane, towards);
  if (from == to) return std::nullopt;
  const double t = from / (from - to);
  if (t <= 0) return std::nullopt;
  Point p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = eye[i] + t * (towards[i] - eye[i]);
  const bool inside = std::all_of(polygon.sides.begin(), polygon.sides.end(), [&](const scene::PlanePolygon::Side& side) {
    const double value = at(tree.planes()[side.half.plane], p);
    return side.half.turned ? value > 0 : value < 0;
  });
  return inside ? std::optional(t) : std::nullopt;
}

scene::PolyScene cubes(std::int32_t count) {
  scene::PolyScene scene;
  for (std::int32_t i = 0; i < count; ++i) {
    const auto first = static_cast<scene::VertexIndex>(scene.vertices.size());
    for (const std::int32_t z : {0, 10})
      for (const auto& [x, y] : {std::pair{0, 0}, {10, 0}, {10, 10}, {0, 10}}) scene.vertices.push_back({x + 25 * i, y, z});
    scene::PolyBody body;
    for (const std::array<scene::VertexIndex, 4>& face : std::array<std::array<scene::VertexIndex, 4>, 6>{
             {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}})
      body.faces.push_back({{first + face[0], first + face[1], first + face[2], first + face[3]}, {}});
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

TEST(FaceTree, ACubeIsPaintedByItsFacesTurnedToTheEye) {
  const FaceTree tree(cubes(1));
  EXPECT_EQ(tree.nodes(), 6U);
  EXPECT_EQ(tree.polygons().size(), 6U);
  std::vector<std::uint32_t> order;
  tree.paint({5, 5, -100, 1}, order);
  EXPECT_EQ(order.size(), 1U) << "straight ahead";
  tree.paint({100, 100, 100, 1}, order);
  EXPECT_EQ(order.size(), 3U) << "from a corner";
  tree.paint({5, 5, 5, 1}, order);
  EXPECT_EQ(order.size(), 0U) << "from inside";
  tree.paint({1, 2, 0, 0}, order);
  EXPECT_EQ(order.size(), 2U) << "parallel to the faces across z";
}

// The planes of the faces between them separate three cubes in a row; four planes are common to all.
TEST(FaceTree, CubesInARowAreNotCut) {
  const FaceTree tree(cubes(3));
  EXPECT_EQ(tree.polygons().size(), 18U);
}

TEST(FaceTree, TheLastPaintedOnASightLineIsTheNearest) {
  std::mt19937 random(1980);
  std::size_t with_two = 0;
  for (const scene::PolyScene& scene : {scene::generate_boxes(12), scene::generate_triangles(25), scene::generate_touch(3), scene::generate_town(9)}) {
    const FaceTree tree(scene);
    std::size_t faces = 0;
    for (const scene::PolyBody& body : scene.bodies) faces += body.faces.size();
    EXPECT_GE(tree.polygons().size(), faces);
    const auto corner = [&] { return scene.vertices[random() % scene.vertices.size()]; };
    std::vector<std::uint32_t> order;
    for (int view = 0; view < 60; ++view) {
      const scene::PolyPoint from = corner();
      const Point eye{from[0] + 137.31 * (view % 7 - 3), from[1] + 211.17 * (view % 5 - 1), from[2] + 91.73 * (view % 11 - 5)};
      tree.paint({eye[0], eye[1], eye[2], 1}, order);
      for (int line = 0; line < 40; ++line) {
        const scene::PolyPoint to = corner();
        const Point towards{to[0] + 0.37, to[1] + 0.61, to[2] - 0.43};
        std::optional<double> last;
        double nearest = INFINITY;
        std::size_t met = 0;
        for (const std::uint32_t number : order) {
          const auto t = meeting(tree, tree.polygons()[number].polygon, eye, towards);
          if (!t) continue;
          last = t;
          nearest = std::min(nearest, *t);
          ++met;
        }
        if (met > 1) ++with_two;
        EXPECT_LE(last.value_or(0), nearest + 1e-9) << "view " << view << ", line " << line;
      }
    }
  }
  EXPECT_GT(with_two, 1000U);
}

}  // namespace
}  // namespace sightline::report
