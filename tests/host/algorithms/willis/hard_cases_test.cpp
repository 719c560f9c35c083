// The hard cases W1 to W16 of Willis (1977) at the level of the algorithm: boundaries, pair tests, cuts, orders. The report has
// pictures and counts of the same files (host/compare/hard_cases/manifest.json).
//
// Walls are sheets, visible from both sides: sides 2 i and 2 i + 1 belong to wall i, and a cluster of two of the paper's
// one-sided
// walls counts twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "host/algorithms/oracle/face_raster.hpp"
#include "host/algorithms/willis/boundary.hpp"
#include "host/algorithms/willis/cut.hpp"
#include "host/algorithms/willis/distance.hpp"
#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/algorithms/willis/spans.hpp"
#include "host/algorithms/willis/surfaces.hpp"
#include "tests/host/scene/hard_case_files.hpp"

namespace sightline::algorithms::willis {
namespace {

using scene::hard_case_scene;
using scene::PolyScene;

constexpr std::array shapes{BoundaryShape::oval, BoundaryShape::ball};

std::vector<Surface> sides_of(const std::string& file) {
  auto walls = walls_of(hard_case_scene(file), 1);
  return std::move(*walls);
}

Model model_of(const PolyScene& scene, ModelOptions options = {}) {
  options.plan = true;
  auto made = make_model(scene, options);
  return std::move(*made);
}

Model model_of(std::vector<Surface> sides, bool rule90 = false) {
  return make_model(std::move(sides), {.rules = {BoundaryShape::ball, rule90}, .plan = true});
}

picture::PixelGrid drawn(const Model& model, const scene::PolyCamera& camera, int size,
                         Representatives corners) {
  const ImageWindow window{size, size, size / 2.0, size / 2.0, size / 2.0};
  Frames frames(model);
  FrameSpans spans;
  make_spans(model, frames.order(camera, corners), camera, window, spans);
  return resolve_priorities(spans, window);
}

void expect_at_the_length(const std::string& file, bool inside) {
  const auto sides = sides_of(file);
  for (const BoundaryShape shape : shapes) {
    EXPECT_EQ(reaches(sides[2], sides[0], shape), inside);
    EXPECT_EQ(form_cluster(sides[0], sides[2], {shape, false}), inside);
  }
}

TEST(WillisHardCases, W1ExactlyAtTheLengthIsACluster) {
  expect_at_the_length("W1.json", true);
}
TEST(WillisHardCases, W1ApartIsNone) {
  expect_at_the_length("W1-apart.json", false);
}

TEST(WillisHardCases, W2OneWayIsEnough) {
  const auto sides = sides_of("W2.json");
  EXPECT_TRUE(reaches(sides[2], sides[0], BoundaryShape::oval));
  EXPECT_FALSE(reaches(sides[0], sides[2], BoundaryShape::oval));
  for (const BoundaryShape shape : shapes) {
    EXPECT_TRUE(form_cluster(sides[0], sides[2], {shape, false}));
    EXPECT_TRUE(form_cluster(sides[2], sides[0], {shape, false}));
  }
}

TEST(WillisHardCases, W3NeighboursInAChainOnly) {
  const auto sides = sides_of("W3.json");
  for (const BoundaryShape shape : shapes) {
    EXPECT_TRUE(form_cluster(sides[0], sides[2], {shape, false}));
    EXPECT_TRUE(form_cluster(sides[2], sides[4], {shape, false}));
    EXPECT_FALSE(form_cluster(sides[0], sides[4], {shape, false}));
  }
}

TEST(WillisHardCases, W4InTheOvalOnly) {
  const auto sides = sides_of("W4.json");
  EXPECT_TRUE(reach_each_other(sides[0], sides[2], BoundaryShape::oval));
  EXPECT_FALSE(reach_each_other(sides[0], sides[2], BoundaryShape::ball));
  EXPECT_NEAR(two_circles_area() / oval_area(), 0.98312, 5e-6);  // "about 2 %" less
}

// In units of the wall's length squared: the part of a square of three lengths around it that its boundaries cover.
double covered_area(const std::vector<Surface>& walls, const Surface& whole, BoundaryShape shape) {
  constexpr int steps = 600;
  const std::int32_t from = std::min(whole.points[0][0], whole.points[1][0]);
  const std::int32_t length = std::abs(whole.points[1][0] - whole.points[0][0]);
  int inside = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const auto at = [&](int step) {
        return static_cast<std::int32_t>(std::int64_t{3} * length * (2 * step + 1) / (2 * steps));
      };
      const Point p{from - length + at(i), 0, whole.points[0][2] - 3 * (length / 2) + at(j)};
      inside += std::any_of(walls.begin(), walls.end(),
                            [&](const Surface& wall) { return in_boundary(wall, p, shape); });
    }
  }
  return 9.0 * inside / (steps * steps);
}

TEST(WillisHardCases, W5HalvesCoverALittleOverAThird) {
  const Surface wall = sides_of("W5.json")[0];
  const auto halves = halve(wall);
  ASSERT_TRUE(halves);
  const double whole = covered_area({wall}, wall, BoundaryShape::oval);
  const double parts = covered_area({(*halves)[0], (*halves)[1]}, wall, BoundaryShape::oval);
  EXPECT_NEAR(whole, oval_area(), 0.002 * whole);
  EXPECT_NEAR(covered_area({wall}, wall, BoundaryShape::ball), two_circles_area(), 0.002 * whole);
  EXPECT_NEAR(parts, halves_ovals_area(), 0.002 * parts);
  EXPECT_NEAR(halves_ovals_area() / oval_area(), 0.34725, 5e-6);  // "about 65 %" less
}

// Neither of two faces in one plane can hide the other.
TEST(WillisHardCases, W7TheCommonFacesNeedNoOrder) {
  auto made = surfaces_of(hard_case_scene("W7.json"));
  std::vector<Surface> common;
  for (const Surface& s : *made)
    if (std::all_of(s.points.begin(), s.points.end(),
                    [](const Point& p) { return p[0] == 100 * lattice_unit; }))
      common.push_back(s);
  ASSERT_EQ(common.size(), 2U);
  EXPECT_FALSE(can_obscure(common[0], common[1]));
  EXPECT_FALSE(can_obscure(common[1], common[0]));
}

void expect_only_the_second_wall(const std::string& file) {
  const PolyScene scene = hard_case_scene(file);
  const Model model = model_of(scene);
  Frames frames(model);
  const auto order = frames.order(scene.camera);
  EXPECT_FALSE(order.empty());
  for (const std::uint32_t piece : order) EXPECT_EQ(model.pieces[piece].face, 1U);
}

TEST(WillisHardCases, W8EdgeOnIsNotShown) {
  expect_only_the_second_wall("W8.json");
}
TEST(WillisHardCases, W13AWallThatBeginsAtTheEyeIsNotShown) {
  expect_only_the_second_wall("W13.json");
}

// Walls whose points are at equal distances from the eye: the result does not depend on the order in the scene.
TEST(WillisHardCases, W9EqualDistances) {
  const PolyScene scene = hard_case_scene("W9.json");
  std::vector<Surface> sides = sides_of("W9.json");
  std::reverse(sides.begin(), sides.end());
  const std::uint64_t far = std::uint64_t{500} * lattice_unit;
  const auto picture = [&](const Model& model) {
    std::vector<std::uint32_t> corners;
    for (const Surface& s : model.pieces) {
      corners.push_back(squared_distance(s.points[0], {}) == far * far ? 0U : 1U);
      EXPECT_EQ(squared_distance(s.points[corners.back()], {}), far * far);
    }
    return drawn(model, scene.camera, 256, corners);
  };
  EXPECT_EQ(picture(model_of(scene)), picture(model_of(std::move(sides))));
}

// Bisection makes about two pieces per halving on the way down, not a thousand. The short wall is exactly at its own length, so
// it
// is cut, too.
TEST(WillisHardCases, W10PiecesByTheLogarithmOfTheLength) {
  std::array<std::size_t, 2> pieces{};
  for (const Surface& s : model_of(hard_case_scene("W10.json")).pieces) ++pieces[s.face];
  EXPECT_GE(pieces[0], 24U);
  EXPECT_LE(pieces[0], 80U);
  EXPECT_GE(pieces[1], 4U);
}

void expect_few_pieces_and_touching_ones(const std::string& file) {
  const Model model = model_of(hard_case_scene(file), {.order_cells = false});
  EXPECT_LE(model.pieces.size(), 64U);
  EXPECT_FALSE(model.residual.empty());
  for (const Residual& pair : model.residual) EXPECT_EQ(pair.reason, ResidualReason::touching);
}

TEST(WillisHardCases, W6NoNumberOfCutsSeparatesWallsThatTouch) {
  expect_few_pieces_and_touching_ones("W6.json");
}
TEST(WillisHardCases, W11NoNumberOfCutsSeparatesWallsThatCross) {
  expect_few_pieces_and_touching_ones("W11.json");
}

TEST(WillisHardCases, W11CutWhereTheyCross) {
  const Model model = model_of(hard_case_scene("W11.json"));
  EXPECT_TRUE(model.residual.empty());
  const auto straddles = [](const Surface& s, const Surface& t) {
    return t.plane.side(s.points[0]) * t.plane.side(s.points[1]) < 0;
  };
  for (const Surface& s : model.pieces)
    for (const Surface& t : model.pieces) EXPECT_FALSE(straddles(s, t) && straddles(t, s));
}

// Whether s hides the end b of another wall from the eye: b is beyond s, on a line through the inside of s.
bool hides_end(const Surface& s, const Point& b, const Point& eye) {
  if (s.plane.side(b) >= 0) return false;
  const auto side = [&](const Point& p) {
    const auto u = between(b, eye);
    const auto v = between(p, eye);
    return geometry::sign(Int128{u[0]} * v[2] - Int128{u[2]} * v[0]);
  };
  return side(s.points[0]) * side(s.points[1]) < 0;
}

// Of every two pieces of which one hides an end of the other, the nearer piece's corners must be nearer.
std::size_t expect_in_order(const Model& model, const Point& eye) {
  std::size_t pairs = 0;
  std::size_t wrong = 0;
  for (const Surface& s : model.pieces) {
    if (s.plane.side(eye) <= 0) continue;
    for (const Surface& t : model.pieces) {
      if (t.body == s.body || t.plane.side(eye) <= 0) continue;
      if (std::none_of(t.points.begin(), t.points.end(),
                       [&](const Point& b) { return hides_end(s, b, eye); }))
        continue;
      for (const Point& p : s.points) {
        for (const Point& q : t.points) {
          ++pairs;
          wrong += squared_distance(eye, p) >= squared_distance(eye, q);
        }
      }
    }
  }
  EXPECT_EQ(wrong, 0U);
  return pairs;
}

// Eyes on circles of three radii, one per degree.
TEST(WillisHardCases, W12AnyCornerMayRepresentAPiece) {
  const Model model = model_of(hard_case_scene("W12.json"));
  std::size_t pairs = 0;
  for (const double radius : {300.0, 1500.0, 40000.0}) {
    for (int degree = 0; degree < 360; ++degree) {
      const double angle = degree * std::numbers::pi / 180;
      pairs +=
          expect_in_order(model, on_lattice({static_cast<std::int32_t>(1700 + radius * std::cos(angle)), 0,
                                             static_cast<std::int32_t>(1700 + radius * std::sin(angle))}));
    }
  }
  EXPECT_GT(pairs, 1000U);
}

TEST(WillisHardCases, W14RightAnglesAreWithin90) {
  const auto sides = sides_of("W14.json");
  EXPECT_EQ(geometry::dot(sides[0].plane.normal, sides[2].plane.normal), 0);
  int can = 0;
  for (const std::size_t s : {0U, 1U}) {
    for (const std::size_t t : {2U, 3U}) {
      EXPECT_EQ(can_obscure(sides[s], sides[t], true), can_obscure(sides[s], sides[t]));
      can += can_obscure(sides[s], sides[t]) ? 1 : 0;
    }
  }
  EXPECT_GT(can, 0);
}

// The number of wrong points, without those next to other faces, in the worst of the pictures in which the first or the second
// corner represents each piece.
int most_wrong(const Model& model, const PolyScene& scene, int size) {
  const picture::PixelGrid truth = oracle::nearest_faces(scene, {scene.camera, size, size});
  const auto inside = [&](int column, int row) {
    for (int y = row - 1; y <= row + 1; ++y)
      for (int x = column - 1; x <= column + 1; ++x)
        if (truth.at(x, y) != truth.at(column, row)) return false;
    return true;
  };
  int most = 0;
  for (const unsigned corner : {0U, 1U, 2U, 3U}) {
    std::vector<std::uint32_t> corners;
    for (const Surface& s : model.pieces) corners.push_back(s.face == 0 ? corner / 2 : corner % 2);
    const picture::PixelGrid picture = drawn(model, scene.camera, size, corners);
    int wrong = 0;
    for (int y = 1; y + 1 < size; ++y)
      for (int x = 1; x + 1 < size; ++x) wrong += inside(x, y) && picture.at(x, y) != truth.at(x, y);
    most = std::max(most, wrong);
  }
  return most;
}

// With the rule there is no cluster, and the order is wrong; without it the walls are cut until the order is correct.
TEST(WillisHardCases, W14Beyond90DegreesTheRuleIsWrong) {
  const PolyScene scene = hard_case_scene("W14-beyond.json");
  std::vector<Surface> seen;
  for (const Surface& s : sides_of("W14-beyond.json"))
    if (s.plane.side(on_lattice(scene.camera.eye)) > 0) seen.push_back(s);
  const Model paper = model_of(seen, true);
  EXPECT_EQ(paper.clusters, 0U);
  EXPECT_GT(most_wrong(paper, scene, 128), 0);
  const Model model = model_of(seen);
  EXPECT_GT(model.clusters, 0U);
  EXPECT_TRUE(model.residual.empty());
  EXPECT_EQ(most_wrong(model, scene, 128), 0);
}

// Side 0 of the first wall is visible from in front of z = 0, from where the second wall's other end is not.
TEST(WillisHardCases, W15OnThePlaneIsNotBehindIt) {
  const auto sides = sides_of("W15.json");
  const auto hidden = [&](std::size_t by, std::size_t wall) {
    return can_obscure(sides[by], sides[2 * wall]) || can_obscure(sides[by], sides[2 * wall + 1]);
  };
  EXPECT_TRUE(hidden(0, 1));
  EXPECT_FALSE(hidden(1, 1));
  EXPECT_FALSE(hidden(0, 2));
  EXPECT_FALSE(hidden(1, 2));
}

TEST(WillisHardCases, W16FarFromTheOriginIsTheSame) {
  expect_at_the_length("W16.json", true);
}

TEST(WillisHardCases, W16NoNumberWraps) {
  const auto sides = sides_of("W16-limit.json");
  const std::uint64_t side = std::uint64_t{2} * (scene::poly_coordinate_limit - 1) * lattice_unit;
  const Surface& t = sides[2];
  EXPECT_EQ(squared_diameter(sides[0].points), side * side);
  EXPECT_TRUE(within(sides[0].points[0], t.points, t.plane.normal, side * side));
  EXPECT_FALSE(within(sides[0].points[0], t.points, t.plane.normal, side * side - 1));
}

}  // namespace
}  // namespace sightline::algorithms::willis
