// Lines in which solids pass through each other: they must equal those found by testing every side with every triangle, and
// `exact`
// and the oracle must see the same parts of them, with ends that are fractions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/geometry/wide_integer.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/eye_place.hpp"
#include "tests/host/algorithms/exact/turned_solids.hpp"
#include "tests/support/effort.hpp"

namespace sightline::algorithms {
namespace {

using namespace turned_solids;

// Two or three turned prisms through each other.
Solid crossing_prisms(Dice& dice) {
  Solid solid;
  add_prism(solid, dice, {0, 0, 0}, 5);
  for (int i = dice(1, 2); i > 0; --i) {
    const Matrix turn = random_turn(dice);
    const auto first = solid.vertices.size();
    add_prism(solid, dice, {dice(-20, 20) / 10.0, dice(-20, 20) / 10.0, dice(-30, 10) / 10.0}, 5);
    for (std::size_t v = first; v < solid.vertices.size(); ++v) solid.vertices[v] = rotate(turn, solid.vertices[v]);
  }
  return solid;
}

struct PiercedPoint {
  std::uint32_t face_a = 0;  // below face_b
  std::uint32_t face_b = 0;
  std::array<geometry::Int128, 3> at{};  // over the weight
  geometry::Int128 weight = 1;

  [[nodiscard]] bool is(const scene::PolyScene& scene, const scene::CutPoint& cut) const {
    using Long = geometry::WideInteger<82>;
    for (std::size_t k = 0; k < 3; ++k) {
      const geometry::Int128 numerator =
          geometry::Int128{scene.vertices[cut.q][k]} * cut.a - geometry::Int128{scene.vertices[cut.p][k]} * cut.b;
      if (geometry::sign(Long(at[k]) * Long(geometry::Int128{cut.a} - cut.b) - Long(numerator) * Long(weight)) != 0) return false;
    }
    return true;
  }
};

// Where sides of triangles pass through the inside of others, for each side of each triangle; empty if corners or sides touch.
std::optional<std::vector<PiercedPoint>> pierced_points(const scene::PolyScene& scene) {
  std::vector<const scene::PolyFace*> faces;
  for (const scene::PolyBody& body : scene.bodies)
    for (const scene::PolyFace& face : body.faces) faces.push_back(&face);
  std::vector<PiercedPoint> points;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint32_t g = 0; g < faces.size(); ++g) {
      const auto& side = faces[f]->outline;
      const auto& triangle = faces[g]->outline;
      if (f == g || std::any_of(side.begin(), side.end(), [&](auto v) { return std::count(triangle.begin(), triangle.end(), v) > 0; }))
        continue;
      const auto at = [&](std::size_t i) -> const scene::PolyPoint& { return scene.vertices[triangle[i % 3]]; };
      for (std::size_t i = 0; i < 3; ++i) {
        const scene::PolyPoint& p = scene.vertices[side[i]];
        const scene::PolyPoint& q = scene.vertices[side[(i + 1) % 3]];
        const std::int64_t a = geometry::orientation(at(0), at(1), at(2), p);
        const std::int64_t b = geometry::orientation(at(0), at(1), at(2), q);
        int turns = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::int64_t turn = geometry::orientation(p, q, at(k), at(k + 1));
          if (turn == 0 || a == 0 || b == 0) return std::nullopt;
          turns += geometry::sign(turn);
        }
        if ((a > 0) == (b > 0) || (turns != 3 && turns != -3)) continue;
        PiercedPoint point{std::min(f, g), std::max(f, g)};
        for (std::size_t k = 0; k < 3; ++k) point.at[k] = geometry::Int128{q[k]} * a - geometry::Int128{p[k]} * b;
        point.weight = geometry::Int128{a} - b;
        points.push_back(point);
      }
    }
  }
  return points;
}

TEST(CrossingLines, OfTurnedSolidsMatchAnExhaustiveSearch) {
  Dice dice(162);
  int compared = 0;
  std::size_t ends = 0;
  std::size_t seen = 0;
  const int rounds = tests::effort(200, 40);
  while (compared < rounds) {
    const Solid solid = crossing_prisms(dice);
    scene::PolyScene scene = scene_of(solid, random_turn(dice), {0, 0, 0});
    const bool mesh = compared % 4 == 0;
    if (!mesh) {
      scene.surfaces.clear();
      scene.surface_of.clear();
      const auto pierced = pierced_points(scene);
      if (!pierced) continue;
      const auto crossings = scene::crossings_of(scene);
      EXPECT_EQ(2 * crossings.size(), pierced->size()) << compared;
      for (const scene::Crossing& crossing : crossings) {
        for (const scene::CutPoint& end : crossing.ends) {
          EXPECT_EQ(std::count_if(pierced->begin(), pierced->end(),
                                  [&](const PiercedPoint& point) {
                                    return point.face_a == crossing.face_a && point.face_b == crossing.face_b &&
                                           point.is(scene, end);
                                  }),
                    1)
              << compared;
        }
      }
      ends += pierced->size();
    }
    const scene::PolyScene crossed = scene::with_crossings(scene);
    const scene::PolyCamera camera = scene::camera_outside({}, scene, random_direction(dice), compared % 2 == 0);
    if (scene::eye_error(scene, camera)) continue;
    ++compared;
    const picture::ChosenEdges chosen = picture::EdgeChooser(crossed, {}).at(camera);
    const picture::LinePicture fast = exact::visible_edges(exact::make_edge_mesh(crossed), camera, &chosen);
    EXPECT_TRUE(fast == oracle::visible_edges(crossed, camera, chosen)) << compared;
    seen += static_cast<std::size_t>(std::count_if(fast.pieces.begin(), fast.pieces.end(), [&](const picture::LinePiece& piece) {
      return !crossed.crossings.empty() && piece.edge.from >= crossed.crossings.front().from;
    }));
  }
  EXPECT_GT(ends, 10U * static_cast<std::size_t>(rounds));
  EXPECT_GT(seen, 3U * static_cast<std::size_t>(rounds));
}

// The eye is among sheets that pass through each other, so that much is behind it, at the limits of coordinates.
TEST(CrossingLines, FromAmongThemExactAndOracleAgree) {
  Dice dice(61);
  std::size_t pieces = 0;
  for (int round = 0; round < 60; ++round) {
    scene::PolyScene scene;
    const std::int32_t reach = round % 2 == 0 ? scene::poly_coordinate_limit - 1 : 40;
    for (int i = 0; i < 12; ++i) {
      scene::PolyBody& sheet = scene.bodies.emplace_back();
      sheet.sheet = true;
      scene::PolyFace& face = sheet.faces.emplace_back();
      for (int k = 0; k < 3; ++k) {
        face.outline.push_back(static_cast<scene::VertexIndex>(scene.vertices.size()));
        scene.vertices.push_back({dice(-reach, reach), dice(-reach, reach), dice(-reach, reach)});
      }
      if (geometry::is_zero(geometry::normal_of(scene.vertices[face.outline[0]], scene.vertices[face.outline[1]],
                                                scene.vertices[face.outline[2]])))
        scene.bodies.pop_back();
    }
    scene::PolyCamera camera =
        scene::turned_camera({}, {dice(-20, 20), dice(-20, 20), dice(-20, 20)}, random_direction(dice), {0.3, 1, 0.2}, round % 3 != 0);
    if (scene::eye_error(scene, camera)) continue;
    const scene::PolyScene crossed = scene::with_crossings(scene);
    const picture::ChosenEdges chosen = picture::EdgeChooser(crossed, *picture::edge_choice_named("intersection")).at(camera);
    const picture::LinePicture fast = exact::visible_edges(exact::make_edge_mesh(crossed), camera, &chosen);
    EXPECT_TRUE(fast == oracle::visible_edges(crossed, camera, chosen)) << round;
    pieces += fast.pieces.size();
  }
  EXPECT_GT(pieces, 300U);
}

}  // namespace
}  // namespace sightline::algorithms
