// Contours: levels, crossings of triangles, the frame of the stream, and that the pieces join.
#include "host/programs/skala/contours.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "host/programs/skala/stream_writer.hpp"
#include "tests/host/programs/skala/stream_support.hpp"

namespace sightline::programs::skala {
namespace {

using stream_test::decode;
using stream_test::grid_of;
using stream_test::Line;
using stream_test::lines_of;
using stream_test::named;
using stream_test::Place;
using stream_test::SentCommand;

const View contours{.subject = Subject::contours, .silhouette = true};

TEST(ContourLevels, DivideTheRange) {
  EXPECT_EQ(contour_levels({0, 9}, 8), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(contour_levels({-1, 1}, 1), (std::vector<double>{0}));
  EXPECT_TRUE(contour_levels({3, 3}, 8).empty());
  for (const double level : contour_levels({-1.7e308, 1.7e308}, 255)) EXPECT_TRUE(std::isfinite(level));
}

// Heights whose difference would be lost by scaling, and heights whose difference exceeds the largest double.
TEST(ContourCrossing, IsOnItsEdgeForAnyMagnitudeOfHeights) {
  const std::array<GridIndex, 3> triangle{{{0, 0}, {1, 0}, {0, 1}}};
  const auto inside = [](const Vertex& v) { return v.x >= 0 && v.x <= 255 && v.y >= 0 && v.y <= 255; };
  for (const auto& [low, high, level] : {std::array{-5e-324, 0.0, 0.0}, std::array{0.0, 5e-324, 5e-324},
                                         std::array{-1.7e308, 1.7e308, 0.0}, std::array{-5e-324, 1.0, 0.0}}) {
    const scene::HeightGrid grid = grid_of({{low, high}, {high, 1}});
    const Projection projection(grid, {.elevation = 90});
    const ContourCrossing crossing = contour_crossing(grid, projection, triangle, level);
    ASSERT_TRUE(crossing.crossed) << low;
    EXPECT_TRUE(inside(crossing.piece.from) && inside(crossing.piece.to)) << low << ' ' << high;
  }
  EXPECT_EQ(raster_coordinate(std::nan("")), 0);
}

// MASK leaves the pen of a plotter at the end of the last ink; from there the nearest line comes next, starting at its nearer
// end. On a
// raster the last of two colours stays, so lines keep their order.
TEST(SkalaStreamWriter, TestLinesNearestToAPlottersPenFirst) {
  const auto vertex = [](int x, int y) { return Vertex{1.0 * x, 1.0 * y, x, y, 0, true}; };
  const auto chain = [&](Place from, Place to, ChainStep step) {
    const Vertex a = vertex(from.x, from.y);
    const Vertex b = vertex(to.x, to.y);
    RasterChain result;
    result.segment(a, b, step);
    return result;
  };
  const auto tested = [&](const Output& output) {
    StreamWriter writer(contours, output, 7);
    writer.chain(chain({10, 10}, {20, 10}, ChainStep::test));
    writer.chain_and_commit(chain({100, 100}, {120, 100}, ChainStep::mask));
    writer.test_chains({{1, chain({118, 100}, {80, 90}, ChainStep::test)},
                        {2, chain({60, 30}, {40, 20}, ChainStep::test)},
                        {3, chain({21, 10}, {22, 19}, ChainStep::test)}});
    std::vector<Place> ends;
    for (const Line& line : lines_of(writer.finish()))
      if (line.by == Command::test_draw) ends.push_back(line.to);
    return ends;
  };
  EXPECT_EQ(tested({}), (std::vector<Place>{{20, 10}, {80, 90}, {40, 20}, {22, 19}}));
  EXPECT_EQ(tested({Device::minigraf}), (std::vector<Place>{{20, 10}, {22, 19}, {60, 30}, {118, 100}}));
  EXPECT_EQ(tested({Device::minigraf, false}), (std::vector<Place>{{20, 10}, {80, 90}, {40, 20}, {22, 19}}));
}

TEST(SkalaContours, OfHeightsThatHardlyDiffer) {
  scene::HeightGrid grid =
      grid_of({{-1, 0, 0, 0, 1}, {0, 0, 0, 0, 0}, {0, 0, -5e-324, 0, 0}, {0, 0, 0, 0, 0}, {1, 0, 0, 0, -1}});
  View view = contours;
  view.levels = 7;
  decode(contour_stream(grid, view));
}

// Unrotated from straight above, screen x and y are x and z.
TEST(ContourCrossing, LiesOnTheEdgesAtTheLevel) {
  const scene::HeightGrid grid = grid_of({{0, 4}, {8, 2}});
  const Projection projection(grid, {.elevation = 90});
  const std::array<GridIndex, 3> triangle{{{0, 0}, {1, 0}, {0, 1}}};
  const ContourCrossing crossing = contour_crossing(grid, projection, triangle, 2);
  ASSERT_TRUE(crossing.crossed);
  // Half along the near edge, a quarter along the left one.
  const auto& [from, to] = crossing.piece;
  const Vertex& on_edge = from.row == 0 ? from : to;
  const Vertex& on_side = from.row == 0 ? to : from;
  EXPECT_EQ(on_edge.column, 128);
  EXPECT_EQ(on_edge.row, 0);
  EXPECT_EQ(on_side.column, 0);
  EXPECT_EQ(on_side.row, 64);
  EXPECT_FALSE(contour_crossing(grid, projection, triangle, 8.5).crossed);
}

TEST(ContourCrossing, AHeightEqualToTheLevelIsAbove) {
  const scene::HeightGrid grid = grid_of({{0, 4}, {4, 8}});
  const Projection projection(grid, {.elevation = 90});
  // 0 is below. 1 is above: the side corners, on whose line the contour is.
  const ContourCrossing near = contour_crossing(grid, projection, {{{0, 0}, {1, 0}, {0, 1}}}, 4);
  ASSERT_TRUE(near.crossed);
  EXPECT_EQ(std::abs(near.piece.from.column - near.piece.to.column), 255);
  EXPECT_FALSE(contour_crossing(grid, projection, {{{1, 0}, {1, 1}, {0, 1}}}, 4).crossed);
  EXPECT_FALSE(contour_crossing(grid, projection, {{{0, 0}, {1, 0}, {0, 1}}}, 0).crossed);
}

TEST(SkalaContours, FrameOfTheStream) {
  const auto commands = decode(contour_stream(named("gauss", {9, 9}), contours));
  ASSERT_GT(commands.size(), 8U);
  EXPECT_EQ(commands[0].what, Command::device);
  EXPECT_EQ(commands[1].what, Command::reset);
  EXPECT_EQ(commands[2].what, Command::silhouette);
  EXPECT_EQ(commands[3].what, Command::colour);
  EXPECT_EQ(commands[commands.size() - 2].what, Command::outline);
}

// One cell, heights 0 at N, 3 at F: near margins, near pieces, diagonal, far pieces, far margins.
TEST(SkalaContours, OrderInACell) {
  View view = contours;
  view.levels = 2;  // at 1 and 2, through both triangles
  const auto lines = lines_of(contour_stream(grid_of({{0, 1.5}, {1.5, 3}}), view));
  std::vector<Command> order;
  std::vector<std::size_t> chains;
  for (const Line& line : lines) {
    order.push_back(line.by);
    chains.push_back(line.chain);
  }
  using enum Command;
  EXPECT_EQ(order, (std::vector<Command>{draw, draw, test_draw, mask, test_draw, draw, draw}));
  EXPECT_EQ(chains, (std::vector<std::size_t>{0, 0, 1, 1, 2, 2, 2}));
  EXPECT_EQ(lines[2].colour, contour_colours[0]);
  EXPECT_EQ(lines[4].colour, contour_colours[1]);
  EXPECT_EQ(lines[5].colour, margin_colour);
}

TEST(SkalaContours, OnlyTheDomainsMarginsHaveInkUnlessANetIsWanted) {
  const auto inked = [](const std::vector<Line>& lines) {
    return std::count_if(lines.begin(), lines.end(), [](const Line& l) { return l.by == Command::draw; });
  };
  const scene::HeightGrid grid = named("flat", {4, 3});
  View view = contours;
  view.rotation = 20;
  EXPECT_EQ(inked(lines_of(contour_stream(grid, view))), 2 * (3 + 2));
  view.net = true;
  EXPECT_EQ(inked(lines_of(contour_stream(grid, view))), 3 * 3 + 4 * 2);
}

// A bell's contours above its border are closed: an even number of pieces of a colour ends at every dot.
TEST(SkalaContours, PiecesJoin) {
  const scene::HeightGrid grid = named("gauss", {24, 23});
  for (const double rotation : {0.0, 30.0, 100.0, 213.0}) {
    View view = contours;
    view.rotation = rotation;
    view.levels = 6;  // as many as there are colours
    std::map<std::pair<int, Place>, int> ends;
    std::size_t pieces = 0;
    for (const Line& line : lines_of(contour_stream(grid, view))) {
      if (line.by != Command::test_draw) continue;
      ++pieces;
      EXPECT_NE(line.from, line.to);
      ++ends[{line.colour, line.from}];
      ++ends[{line.colour, line.to}];
    }
    EXPECT_GT(pieces, 200U);
    for (const auto& [end, count] : ends)
      EXPECT_EQ(count % 2, 0) << "colour " << end.first << " at " << end.second.x << " " << end.second.y;
  }
}

// In each triangle colours come in the order of the levels.
TEST(SkalaContours, LevelsAscendBetweenCommits) {
  View view = contours;
  view.levels = 6;
  view.rotation = 50;
  std::size_t chain = 0;
  std::ptrdiff_t level = -1;
  for (const Line& line : lines_of(contour_stream(named("peaks", {12, 12}), view))) {
    if (line.chain != chain) level = -1;
    chain = line.chain;
    if (line.by != Command::test_draw) continue;
    const auto* found = std::find(contour_colours.begin(), contour_colours.end(), line.colour);
    ASSERT_NE(found, contour_colours.end());
    EXPECT_GT(found - contour_colours.begin(), level);
    level = found - contour_colours.begin();
  }
}

TEST(SkalaContours, ACellWithAHoleHasNoPieces) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  // Only the far right corner is undefined: near margins and two edges of the far margins remain.
  const auto lines = lines_of(contour_stream(grid_of({{0, 1}, {1, nan}}), contours));
  for (const Line& line : lines) EXPECT_EQ(line.by, Command::draw);
  EXPECT_EQ(lines.size(), 2U);
}

}  // namespace
}  // namespace sightline::programs::skala
