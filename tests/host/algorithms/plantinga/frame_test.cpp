// Frames: the lines of a turning scene end where exact hidden-line removal ends them.
#include "host/algorithms/plantinga/frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/algorithms/plantinga/visible_edges.hpp"
#include "tests/host/algorithms/plantinga/turning_scenes.hpp"

namespace sightline::algorithms::plantinga {
namespace {

using Line = std::array<double, 4>;

double real(const geometry::Rational& r) {
  return static_cast<double>(r.numerator()) / static_cast<double>(r.denominator());
}

std::array<double, 3> point_on(const RotationModel& model, const picture::LineEdge& edge, double at) {
  std::array<double, 3> p{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto from = static_cast<double>(model.vertices()[edge.from][axis]);
    const auto to = static_cast<double>(model.vertices()[edge.to][axis]);
    p[axis] = from + at * (to - from);
  }
  return p;
}

Line rotate_line(const std::array<double, 3>& from, const std::array<double, 3>& to, double angle) {
  const auto u = [angle](const auto& p) { return p[0] * std::cos(angle) - p[2] * std::sin(angle); };
  return {u(from), from[1], u(to), to[1]};
}

std::vector<Line> exact_lines(const RotationModel& model, const Sight& sight, double angle) {
  std::vector<Line> lines;
  for (const picture::LinePiece& piece : visible_edges(model, sight).pieces) {
    lines.push_back(rotate_line(point_on(model, piece.edge, real(piece.low)),
                           point_on(model, piece.edge, real(piece.high)), angle));
  }
  return lines;
}

void expect_same(std::vector<Line> found, std::vector<Line> expected) {
  ASSERT_EQ(found.size(), expected.size());
  // Each line has one counterpart; ends differ by rounding.
  for (const Line& line : expected) {
    const auto near = std::find_if(found.begin(), found.end(), [&](const Line& other) {
      double difference = 0;
      for (std::size_t i = 0; i < 4; ++i) difference = std::max(difference, std::abs(line[i] - other[i]));
      return difference < 1e-9;
    });
    ASSERT_NE(near, found.end()) << line[0] << ' ' << line[1] << ' ' << line[2] << ' ' << line[3];
    found.erase(near);
  }
}

class Frames : public ::testing::TestWithParam<scene::PolyScene (*)()> {};

TEST_P(Frames, EndWhereTheExactPictureDoes) {
  const RotationModel model(GetParam()());
  const auto built = build_event_list(model);
  const auto& list = *built;
  EdgeStructureGraph graph(list);
  FrameMaker frames(model);
  std::vector<ImageLine> lines;
  std::vector<SpaceLine> space_lines;
  for (const Sight& sight :
       {Sight{7, 31}, Sight{-1000, 577}, Sight{311, -97}, Sight{-13, -29}, Sight{29999, 1}}) {
    const double angle = std::atan2(static_cast<double>(sight.x), static_cast<double>(sight.z));
    ASSERT_TRUE(graph.turn_to(angle));
    const std::vector<Line> expected = exact_lines(model, sight, angle);
    frames.visible(graph, angle, lines);
    std::vector<Line> found;
    for (const ImageLine& line : lines) found.push_back({line.u0, line.v0, line.u1, line.v1});
    expect_same(found, expected);
    frames.visible_in_space(graph, angle, space_lines);
    found.clear();
    for (const SpaceLine& line : space_lines) found.push_back(rotate_line(line.from, line.to, angle));
    expect_same(found, expected);
    EXPECT_EQ(lines.size(), graph.piece_count());
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Frames, ::testing::Values(&two_boxes, &three_boxes, &boxes_on_the_ground));

TEST(WireFrame, HasEveryEdgeWhole) {
  const RotationModel model(two_boxes());
  FrameMaker frames(model);
  std::vector<ImageLine> lines;
  frames.wire(std::numbers::pi / 2, lines);
  ASSERT_EQ(lines.size(), 24U);
  const Segment first = model.segment(0);
  EXPECT_NEAR(lines[0].u0, -static_cast<double>(first.from[2]), 1e-9);
  EXPECT_NEAR(lines[0].v1, static_cast<double>(first.to[1]), 1e-9);
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
