// Models: clusters are cut until there are none; residual pairs; order cells; and the specification's figures for the error of a
// wrong
// order at each depth.
#include "host/algorithms/willis/model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/sight_lines.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/willis/walls.hpp"

namespace sightline::algorithms::willis {
namespace {

Model plan_model(std::vector<Surface> walls, ModelOptions options = {}) {
  options.plan = true;
  return make_model(std::move(walls), options);
}

Model model_of(const scene::PolyScene& scene, const ModelOptions& options = {}) {
  auto made = make_model(scene, options);
  return std::move(*made);
}

scene::PolyCamera eye_at(std::int32_t x, std::int32_t z) {
  scene::PolyCamera camera;
  camera.eye = {x, 0, z};
  return camera;
}

TEST(WillisModel, TouchingWallsOfDifferentSolids) {
  const Surface s = wall({0, 0}, {10, 0}, 0);
  const Surface t = wall({10, 0}, {20, 5}, 1);
  // In a corner seen from its inside or outside, neither wall can occlude the other.
  EXPECT_TRUE(plan_model({s, t}).residual.empty());
  EXPECT_TRUE(plan_model({flip(s), flip(t)}).residual.empty());
  // If one is seen from below and the other from above, one can hide the other, and no number of cuts helps.
  ModelOptions cuts_only;
  cuts_only.order_cells = false;
  const Model cut = plan_model({flip(s), t}, cuts_only);
  EXPECT_FALSE(cut.residual.empty());
  for (const Residual& pair : cut.residual) EXPECT_EQ(pair.reason, ResidualReason::touching);
  EXPECT_LE(cut.pieces.size(), 32U);
  // An order cell helps.
  const Model ordered = plan_model({flip(s), t});
  EXPECT_TRUE(ordered.residual.empty());
  EXPECT_EQ(ordered.cells.nodes.size(), 1U);
}

TEST(WillisModel, CubesThatShareFaces) {
  scene::PolyBuilder builder;
  builder.add_box("left", {0, 0, 0}, {100, 100, 100});
  builder.add_box("right", {100, 0, 0}, {200, 100, 100});
  builder.add_box("on top of left", {0, 100, 0}, {100, 200, 100});
  const scene::PolyScene scene = builder.take();
  for (const bool rule90 : {false, true}) {
    const Model model = model_of(scene, {.rules = {BoundaryShape::ball, rule90}});
    EXPECT_TRUE(model.residual.empty());
    EXPECT_EQ(count_lines(model, scene, 500, 1).wrong, 0U);
  }
}

TEST(WillisModel, AnyRepresentativeGivesTheOrder) {
  const scene::PolyScene scene = scene::generate_prisms(6, 5, 150);
  const Model model = model_of(scene, {.plan = true});
  ASSERT_TRUE(model.residual.empty());
  // Eyes on circles of three radii around the middle, one per degree.
  for (const double radius : {1500.0, 12500.0, 200000.0}) {
    for (int degree = 0; degree < 360; ++degree) {
      const double angle = degree * std::numbers::pi / 180;
      const Point eye = on_lattice({static_cast<std::int32_t>(10000 + radius * std::cos(angle)), 0,
                                    static_cast<std::int32_t>(10000 + radius * std::sin(angle))});
      for (std::size_t i = 0; i < model.pieces.size(); i += 3) {
        const Surface& s = model.pieces[i];
        if (s.plane.side(eye) <= 0) continue;
        for (const Surface& t : model.pieces) {
          if (t.body == s.body || t.plane.side(eye) <= 0) continue;
          // s hides a point of t: a corner of t on a line through the inside of s, and beyond its plane.
          for (const Point& b : t.points) {
            if (s.plane.at(b) >= 0) continue;
            const auto side = [&](const Point& p) {
              const Vector3 u = between(b, eye);
              const Vector3 v = between(p, eye);
              return geometry::sign(Int128{u[0]} * v[2] - Int128{u[2]} * v[0]);
            };
            if (side(s.points[0]) * side(s.points[1]) >= 0) continue;
            for (const Point& p : s.points)
              for (const Point& q : t.points) EXPECT_LT(squared_distance(eye, p), squared_distance(eye, q));
          }
        }
      }
    }
  }
}

// Willis's figures for the prism town (cross-check, section 5): each further depth has fewer wrong lines and fewer residual
// pairs;
// without residual pairs no line is wrong.
TEST(WillisModel, ResidualAndErrorFallWithDepth) {
  const scene::PolyScene scene = scene::generate_prisms(35);
  std::size_t last = ~std::size_t{0};
  std::uint64_t wrong_uncut = 0;
  for (const int depth : {0, 1, 2, 4, 6, 12}) {
    const Model model = model_of(scene, {.plan = true, .limits = {.depth = depth}});
    EXPECT_TRUE(model.residual.size() < last || model.residual.empty()) << depth;
    last = model.residual.size();
    const SightLines lines = count_lines(model, scene, 3000, 9);
    if (depth == 0) wrong_uncut = lines.wrong;
    if (depth >= 4) {
      EXPECT_EQ(lines.wrong, 0U) << depth;
    }
    for (const Residual& pair : model.residual) EXPECT_EQ(pair.reason, ResidualReason::depth);
    RecordProperty("depth_" + std::to_string(depth),
                   std::to_string(model.pieces.size()) + " pieces, " + std::to_string(last) + " left, " +
                       std::to_string(lines.wrong) + " of " + std::to_string(lines.with_two) + " wrong");
  }
  EXPECT_EQ(last, 0U);
  EXPECT_GT(wrong_uncut, 0U);
}

// From (150, -300) the first wall hides the beginning of the second; their normals are 160 degrees apart.
TEST(WillisModel, Rule90GivesTheWrongOrder) {
  const std::vector<Surface> walls{flip(wall({170, 0}, {0, 980}, 0)), wall({100, 500}, {270, 1480}, 1)};
  ASSERT_TRUE(can_obscure(walls[0], walls[1]));
  const scene::PolyCamera eye = eye_at(150, -300);
  const Model paper = plan_model(walls, {.rules = {BoundaryShape::ball, true}});
  EXPECT_EQ(paper.clusters, 0U);
  ASSERT_EQ(paper.pieces.size(), 2U);
  // The hidden wall's beginning is nearer than the far end of the wall in front of it.
  Frames wrong(paper);
  const std::vector<std::uint32_t> ends{0, 0};
  EXPECT_EQ(paper.pieces[wrong.order(eye, ends).back()].face, 1U);
  // Without the rule they are cut until the pieces on that sight line are in order for every choice of representatives.
  const Model model = plan_model(walls);
  EXPECT_GT(model.clusters, 0U);
  EXPECT_TRUE(model.residual.empty());
  const Point at = on_lattice(eye.eye);
  for (const Surface& s : model.pieces) {
    for (const Surface& t : model.pieces) {
      if (s.face != 0 || t.face != 1) continue;
      const Vector3 d = between(on_lattice({100, 0, 500}), at);
      const auto side = [&](const Point& p) {
        const Vector3 v = between(p, at);
        return geometry::sign(Int128{d[0]} * v[2] - Int128{d[2]} * v[0]);
      };
      const bool s_hit = side(s.points[0]) * side(s.points[1]) <= 0;
      if (!s_hit || t.points[0] != on_lattice({100, 0, 500})) continue;
      for (const Point& p : s.points)
        for (const Point& q : t.points) EXPECT_LT(squared_distance(at, p), squared_distance(at, q));
    }
  }
}

TEST(WillisModel, LimitsAreNamed) {
  const std::vector<Surface> walls{wall({0, 0}, {1000, 0}, 0), wall({500, 1}, {501, 1}, 1)};
  const auto reasons = [&](Limits limits) {
    const Model model = plan_model(walls, {.limits = limits});
    EXPECT_FALSE(model.residual.empty());
    return model.residual.empty() ? ResidualReason::touching : model.residual[0].reason;
  };
  EXPECT_EQ(reasons({.depth = 3}), ResidualReason::depth);
  EXPECT_EQ(reasons({.smallest = 40}), ResidualReason::size);
  EXPECT_EQ(reasons({.pieces = 6}), ResidualReason::pieces);
}

// The limit is the number that a model without it counts.
TEST(WillisModel, MoreTestsThanTheLimitAreAnError) {
  const scene::PolyScene scene = scene::generate_boxes(20);
  ModelOptions options;
  const auto whole = make_model(scene, options);
  ASSERT_TRUE(whole);
  options.limits.tests = whole->tests;
  const auto at_limit = make_model(scene, options);
  ASSERT_TRUE(at_limit);
  EXPECT_EQ(at_limit->pieces.size(), whole->pieces.size());
  options.limits.tests = 5;
  const auto beyond = make_model(scene, options);
  ASSERT_FALSE(beyond);
  EXPECT_NE(beyond.error().message().find(" pieces to be separated by cuts, expected at most 5 pairs"), std::string::npos)
      << beyond.error().message();
}

TEST(WillisModel, ResidualNamesTheFaces) {
  scene::PolyBuilder builder;
  builder.add_box("left", {0, 0, 0}, {100, 100, 100});
  builder.add_box("right", {120, 0, 0}, {220, 100, 100});
  const scene::PolyScene scene = builder.take();
  const Model model = model_of(scene, {.limits = {.depth = 0}});
  const auto lines = residual_lines(model, scene);
  ASSERT_FALSE(lines.empty());
  EXPECT_NE(lines[0].find("body 0 (left) face "), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("and body 1 (right) face "), std::string::npos) << lines[0];
  EXPECT_NE(lines[0].find("the limit of depth"), std::string::npos) << lines[0];
}

void expect_right(const scene::PolyScene& scene, const ModelOptions& options = {}) {
  const Model model = model_of(scene, options);
  EXPECT_TRUE(model.residual.empty()) << scene.name << ' ' << model.residual.size();
  const SightLines lines = count_lines(model, scene, 1000, 4);
  EXPECT_GE(lines.with_two, 1000U) << scene.name;
  EXPECT_EQ(lines.wrong, 0U) << scene.name;
}

TEST(WillisModel, OrderCells) {
  expect_right(scene::generate_touch(2));
  expect_right(scene::generate_rooms(2));
  for (const std::uint64_t seed : {1U, 2U, 3U}) expect_right(scene::generate_bricks(8, seed));
  // A non-convex solid: a U.
  scene::PolyBuilder builder;
  const std::vector<PlanPoint> u{{0, 0},     {300, 0},   {300, 300}, {200, 300},
                                 {200, 100}, {100, 100}, {100, 300}, {0, 300}};
  add_prism(builder, "U", u, 100);
  expect_right(builder.take());
}

TEST(WillisModel, SmallSeparatedScenes) {
  expect_right(scene::generate_boxes(4));
  expect_right(scene::generate_triangles(6, 2));
  expect_right(scene::generate_prisms(5, 1, 150), {.rules = {BoundaryShape::oval, false}});
}

TEST(WillisModel, PlanAcceptsOnlyWalls) {
  EXPECT_FALSE(make_model(scene::generate_triangles(3), {.plan = true}));
  const Model model = model_of(scene::generate_town(4), {.plan = true});
  scene::PolyCamera camera = scene::generate_town(4).camera;
  camera.eye[1] = 5000;
  EXPECT_TRUE(plan_error(model, camera));
  camera.eye[1] = 50;
  EXPECT_FALSE(plan_error(model, camera));
}

}  // namespace
}  // namespace sightline::algorithms::willis
