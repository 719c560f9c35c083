// Generated scenes compared with their published counts, and with coordinates from another program.
#include "host/scene/generate/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "tests/host/scene/generate/generated_set.hpp"
#include "tests/host/scene/scene_support.hpp"
#include "tests/support/effort.hpp"

namespace sightline::scene {
namespace {

struct Counts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts_of(const PolyScene& scene) {
  std::set<std::pair<VertexIndex, VertexIndex>> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.insert(std::minmax(ring[i], ring[(i + 1) % ring.size()]));
  };
  Counts counts{scene.vertices.size(), 0, 0};
  for (const PolyBody& body : scene.bodies) {
    counts.faces += body.faces.size();
    for (const PolyFace& face : body.faces) {
      add(face.outline);
      for (const auto& hole : face.holes) add(hole);
    }
  }
  counts.edges = edges.size();
  return counts;
}

std::size_t convex_pieces(const PolyScene& rooms) {
  std::size_t count = 0;
  for (const PolyFace& face : rooms.bodies[0].faces)
    count += !face.holes.empty() ? 4 : face.outline.size() == 8 ? 3 : 1;
  return count;
}

std::pair<PolyPoint, PolyPoint> extent(const PolyScene& scene, const PolyBody& body) {
  PolyPoint low = scene.vertices[body.faces[0].outline[0]];
  PolyPoint high = low;
  for (const PolyFace& face : body.faces) {
    for (const VertexIndex v : face.outline) {
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], scene.vertices[v][a]);
        high[a] = std::max(high[a], scene.vertices[v][a]);
      }
    }
  }
  return {low, high};
}

TEST(GenerateScene, BoxesHaveThePublishedCounts) {
  EXPECT_EQ(counts_of(generate_boxes(10)), (Counts{80, 120, 60}));
  EXPECT_EQ(counts_of(generate_boxes(100)), (Counts{800, 1200, 600}));
  EXPECT_EQ(counts_of(generate_boxes(1000)), (Counts{8000, 12000, 6000}));
}

TEST(GenerateScene, RoomsHaveThePublishedCounts) {
  EXPECT_EQ(counts_of(generate_rooms(4)).edges, 185U);
  EXPECT_EQ(convex_pieces(generate_rooms(4)), 85U);
  EXPECT_EQ(counts_of(generate_rooms(10)).edges, 1169U);
  EXPECT_EQ(convex_pieces(generate_rooms(10)), 572U);
}

TEST(GenerateScene, CoordinatesMatchTheDefinition) {
  const PolyScene boxes = generate_boxes(10);
  EXPECT_EQ(extent(boxes, boxes.bodies[0]),
            (std::pair<PolyPoint, PolyPoint>{{2054, 371, 1257}, {2426, 839, 1695}}));
  EXPECT_EQ(extent(boxes, boxes.bodies[9]),
            (std::pair<PolyPoint, PolyPoint>{{2211, 2249, 2292}, {2658, 2527, 2649}}));
  const PolyScene town = generate_town(9);
  EXPECT_EQ(extent(town, town.bodies[0]),
            (std::pair<PolyPoint, PolyPoint>{{139, 0, 2173}, {585, 652, 2275}}));
  const PolyScene bricks = generate_bricks(1);
  EXPECT_EQ(extent(bricks, bricks.bodies[0]), (std::pair<PolyPoint, PolyPoint>{{2, 0, 0}, {3, 1, 3}}));
}

TEST(GenerateScene, CubesShareVerticesWhereTheyTouch) {
  EXPECT_EQ(counts_of(generate_touch(3)), (Counts{64, 3 * 3 * 16, 27 * 6}));
  EXPECT_EQ(counts_of(generate_aligned(4)), (Counts{64 * 8, 64 * 12, 64 * 6}));
}

TEST(GenerateScene, EdgeonLooksFromThePlaneOfAFace) {
  const PolyScene scene = generate_edgeon(100);
  EXPECT_EQ(scene.camera.eye[0], extent(scene, scene.bodies[50]).second[0]);
  EXPECT_EQ(scene.vertices, generate_boxes(100).vertices);
}

TEST(GenerateScene, CamerasAreOrthogonal) {
  for (const std::string_view family : generator_names()) {
    const auto result = generate_scene(family, 2);
    const PolyCamera& camera = result->camera;
    const auto f = geometry::vector_of(camera.forward);
    const auto r = geometry::vector_of(camera.right);
    const auto u = geometry::vector_of(camera.up);
    EXPECT_EQ(geometry::dot(f, r), 0) << family;
    EXPECT_EQ(geometry::dot(f, u), 0) << family;
    EXPECT_EQ(geometry::dot(r, u), 0) << family;
  }
}

// The largest size is within the coordinate limit; tested where that is cheap.
TEST(GenerateScene, TheLargestSizeFits) {
  NEEDS_OPTIMISED_CODE();
  for (const std::string_view family : {"rooms", "town", "prisms"}) {
    const auto result = generate_scene(family, largest_generated_size(family));
    const PolyScene& scene = *result;
    for (const PolyPoint& p : scene.vertices)
      for (const std::int32_t c : p) ASSERT_LT(std::abs(c), poly_coordinate_limit);
    for (const std::int32_t c : scene.camera.eye) EXPECT_LT(std::abs(c), poly_coordinate_limit);
  }
}

TEST(GenerateScene, BigRoomsAreRoomsDividedByFive) {
  const PolyScene rooms = generate_rooms(5);
  const PolyScene small = generate_big_rooms(5);
  ASSERT_EQ(small.vertices.size(), rooms.vertices.size());
  for (std::size_t v = 0; v < small.vertices.size(); ++v) {
    for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(small.vertices[v][a], rooms.vertices[v][a] / 5);
  }
  EXPECT_EQ(small.bodies, rooms.bodies);
}

TEST(GenerateScene, CorridorsEqualTheBuiltInOnes) {
  EXPECT_EQ(generate_corridors(8), poly_scene_of(builtin_scene("corridor8")));
  EXPECT_EQ(generate_corridors(32), poly_scene_of(builtin_scene("corridor32")));
}

// A footprint is a rectangle, and no corner of one is within the gap of a wall of another.
TEST(GenerateScene, PrismsAreRectanglesApart) {
  const PolyScene scene = generate_prisms(40);
  EXPECT_EQ(counts_of(scene), (Counts{40 * 8, 40 * 12, 40 * 6}));
  EXPECT_TRUE(check_poly_scene(scene).empty());
  const auto footprint = [&](const PolyBody& body) {
    std::vector<PolyPoint> corners;
    for (const VertexIndex v : body.faces[4].outline) corners.push_back(scene.vertices[v]);
    return corners;
  };
  const auto minus = [](const PolyPoint& a, const PolyPoint& b) {
    return std::array{static_cast<double>(a[0] - b[0]), static_cast<double>(a[2] - b[2])};
  };
  for (const PolyBody& body : scene.bodies) {
    const auto ring = footprint(body);
    ASSERT_EQ(ring.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(ring[i][1], 0);
      const auto a = minus(ring[i], ring[(i + 1) % 4]);
      const auto b = minus(ring[(i + 2) % 4], ring[(i + 1) % 4]);
      EXPECT_EQ(a[0] * b[0] + a[1] * b[1], 0);
      for (const PolyBody& other : scene.bodies) {
        if (&other == &body) continue;
        for (const PolyPoint& p : footprint(other)) {
          const auto d = minus(p, ring[(i + 1) % 4]);
          const double s = std::clamp((d[0] * a[0] + d[1] * a[1]) / (a[0] * a[0] + a[1] * a[1]), 0.0, 1.0);
          EXPECT_GT(std::hypot(d[0] - s * a[0], d[1] - s * a[1]), 50) << body.name << ", " << other.name;
        }
      }
    }
  }
}

TEST(GenerateScene, BricksDoNotOverlapAndAreOmittedWithoutRoom) {
  const PolyScene scene = generate_bricks(200, 3);
  EXPECT_LT(scene.bodies.size(), 200U);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto [a_low, a_high] = extent(scene, scene.bodies[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const auto [b_low, b_high] = extent(scene, scene.bodies[j]);
      bool apart = false;
      for (std::size_t a = 0; a < 3; ++a) apart = apart || a_high[a] <= b_low[a] || b_high[a] <= a_low[a];
      EXPECT_TRUE(apart) << i << " and " << j;
    }
  }
}

TEST(GenerateScene, TheGeneratedSetHas500DifferentScenes) {
  const auto set = generated_set();
  EXPECT_EQ(set.size(), 500U);
  std::set<std::pair<std::string_view, std::uint64_t>> names;
  for (const GeneratedSceneName& name : set) {
    names.insert({name.family, name.seed});
    EXPECT_GE(name.size, 1U);
  }
  EXPECT_EQ(names.size(), 500U);
}

TEST(GenerateScene, ErrorsNameWhatCannotBeGenerated) {
  EXPECT_EQ(generate_scene("castles", 1).error().message(),
            "castles: no such family of scenes, expected one of boxes, edgeon, touch, aligned, town, triangles, "
            "bricks, rooms, big_rooms, corridors, prisms");
  EXPECT_EQ(generate_scene("rooms", 0).error().message(), "rooms: size: found 0, expected 1..262");
  EXPECT_EQ(generate_scene("rooms", 263).error().message(), "rooms: size: found 263, expected 1..262");
  EXPECT_EQ(generate_scene("corridors", 1).error().message(), "corridors: size: found 1, expected 2..655");
}

}  // namespace
}  // namespace sightline::scene
