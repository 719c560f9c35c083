// Cases whose visible parts are computed by hand, for `exact` and for the oracle. The eye is at the origin and looks along z.
#include <gtest/gtest.h>

#include "tests/host/algorithms/exact/edge_scenes.hpp"

namespace sightline::algorithms {
namespace {

using geometry::Interval;
using Intervals = std::vector<Interval>;
using scene::PolyCamera;
using scene::PolyScene;

Interval between(std::int64_t low, std::int64_t high, std::int64_t over) {
  return {{low, over}, {high, over}};
}

const Interval all = between(0, 1, 1);

class EdgeCases : public testing::TestWithParam<Maker> {
 protected:
  Intervals seen(scene::VertexIndex from, scene::VertexIndex to) const {
    return seen_of(GetParam().draw(scene_, camera_), from, to);
  }

  PolyScene scene_;
  PolyCamera camera_;
};

INSTANTIATE_TEST_SUITE_P(, EdgeCases, testing::Values(exact_maker, oracle_maker),
                         [](const auto& maker) { return maker.param.name; });

TEST_P(EdgeCases, ASquareHidesTheMiddleOfALineBehind) {
  add_sheet(scene_, square(10, 100));
  const auto line = add_sheet(scene_, {{-40, 0, 200}, {40, 0, 200}, {0, 60, 200}});
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(0, 1, 4), between(3, 4, 4)}));
  EXPECT_EQ(seen(0, 1), Intervals{all});
  camera_.perspective = false;
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(0, 3, 8), between(5, 8, 8)}));
}

TEST_P(EdgeCases, InOrthographicViewsAFaceBehindTheEyeHidesToo) {
  add_sheet(scene_, square(10, -100));
  const auto line = add_sheet(scene_, {{-40, 0, 200}, {40, 0, 200}, {0, 60, 200}});
  EXPECT_EQ(seen(line, line + 1), Intervals{all});
  camera_.perspective = false;
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(0, 3, 8), between(5, 8, 8)}));
}

TEST_P(EdgeCases, ALineIsSeenThroughAHole) {
  add_sheet(scene_, square(30, 100), square(10, 100));
  const auto line = add_sheet(scene_, {{-100, 0, 200}, {100, 0, 200}, {0, 60, 200}});
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(0, 1, 5), between(2, 3, 5), between(4, 5, 5)}));
}

TEST_P(EdgeCases, ALineThroughAFaceIsHiddenBeyondIt) {
  add_sheet(scene_, square(50, 100));
  const auto line = add_sheet(scene_, {{0, 1, 50}, {20, 1, 150}, {0, 200, 50}});
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(0, 1, 2)}));
}

TEST_P(EdgeCases, ALineInTheFaceItselfIsSeen) {
  add_sheet(scene_, square(50, 100));
  const auto line = add_sheet(scene_, {{-20, 0, 100}, {20, 0, 100}, {0, 20, 90}});
  EXPECT_EQ(seen(line, line + 1), Intervals{all});
}

TEST_P(EdgeCases, NothingIsVisibleExactlyBehindTheCommonEdgeOfTwoFaces) {
  add_sheet(scene_, {{0, -10, 100}, {0, 10, 100}, {-20, 10, 120}, {-20, -10, 120}});
  const auto line = add_sheet(scene_, {{0, -5, 200}, {0, 5, 200}, {1, 0, 300}});
  EXPECT_EQ(seen(line, line + 1), Intervals{all}) << "hidden by the left face only";
  add_sheet(scene_, {{0, -10, 100}, {0, 10, 100}, {20, 10, 120}, {20, -10, 120}});
  EXPECT_EQ(seen(line, line + 1), Intervals{});
}

TEST_P(EdgeCases, HiddenFromBothSidesOnlyWhereTheFacesOverlap) {
  add_sheet(scene_, {{0, -20, 100}, {0, 2, 100}, {-20, 2, 100}, {-20, -20, 100}});
  add_sheet(scene_, {{0, -1, 100}, {0, 20, 100}, {20, 20, 100}, {20, -1, 100}});
  const auto line = add_sheet(scene_, {{0, -10, 200}, {0, 10, 200}, {1, 0, 300}});
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(0, 8, 20), between(14, 20, 20)}));
}

TEST_P(EdgeCases, ALineTowardsTheEyeIsAPointAndAFaceEdgeOnHidesNothing) {
  const auto blade = add_sheet(scene_, {{0, 10, 50}, {0, 10, 100}, {0, 40, 100}, {0, 20, 50}});
  const auto line = add_sheet(scene_, {{0, 30, 200}, {0, 90, 200}, {50, 0, 200}});
  EXPECT_EQ(seen(blade + 2, blade + 3), Intervals{}) << "40/100 and 20/50: one line of sight";
  EXPECT_EQ(seen(blade, blade + 1), Intervals{all});
  EXPECT_EQ(seen(line, line + 1), Intervals{all});
}

TEST_P(EdgeCases, OnlyLinesInFrontOfTheEyeAreSeen) {
  const auto line = add_sheet(scene_, {{-10, 5, -100}, {-10, 5, 100}, {-10, 50, -100}});
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(1, 2, 2)}));
  EXPECT_EQ(seen(line, line + 2), Intervals{});
  EXPECT_EQ(seen(line + 1, line + 2), (Intervals{between(0, 1, 2)}));
}

TEST_P(EdgeCases, AFloorThatReachesBehindTheEyeHidesLinesUnderIt) {
  add_sheet(scene_, {{-50, -10, -100}, {50, -10, -100}, {50, -10, 50}, {-50, -10, 50}});
  const auto line = add_sheet(scene_, {{0, -20, -50}, {0, -20, 150}, {0, -30, 150}});
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(3, 4, 4)}));
}

TEST_P(EdgeCases, ASideBehindTheEyeExactlyOppositeTheEndOfALine) {
  add_sheet(scene_, {{-50, 20, -100}, {50, 20, -100}, {50, -25, 200}, {-50, -25, 200}});
  const auto line = add_sheet(scene_, {{0, -40, 200}, {0, -40, 400}, {0, -90, 400}});
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(0, 3, 5)}));
}

TEST_P(EdgeCases, AFaceWithAnArmOnEachSideHidesTwoParts) {
  add_sheet(scene_, {{-30, -10, 100},
                     {30, -10, 100},
                     {30, 10, 100},
                     {10, 10, 100},
                     {10, -5, 100},
                     {-10, -5, 100},
                     {-10, 10, 100},
                     {-30, 10, 100}});
  const auto line = add_sheet(scene_, {{-100, 0, 200}, {100, 0, 200}, {0, 60, 200}});
  EXPECT_EQ(seen(line, line + 1), (Intervals{between(0, 1, 5), between(2, 3, 5), between(4, 5, 5)}));
}

TEST_P(EdgeCases, AtTheLimitOfCoordinatesNothingOverflows) {
  constexpr std::int32_t most = scene::poly_coordinate_limit - 1;
  camera_.eye = {-most, -most, -most};
  camera_.forward = {1, 1, 1};
  camera_.right = {-1, 1, 0};
  camera_.up = {-1, -1, 2};
  add_sheet(scene_, {{most, -most, 0}, {-most, most, 0}, {-most, most, -1}});
  const auto line = add_sheet(scene_, {{most, most - 2, most}, {most - 2, most, most}, {most, most, -most}});
  const Intervals got = seen(line, line + 1);
  ASSERT_FALSE(got.empty());
  EXPECT_EQ(got.front().low, geometry::Rational(0));
}

TEST_P(EdgeCases, EmptyScenesAreEmptyPictures) {
  EXPECT_TRUE(GetParam().draw(scene_, camera_).pieces.empty());
  scene_.vertices.push_back({1, 2, 3});
  scene_.bodies.push_back({"", true, {scene::PolyFace{}}});
  EXPECT_TRUE(GetParam().draw(scene_, camera_).pieces.empty());
}

}  // namespace
}  // namespace sightline::algorithms
