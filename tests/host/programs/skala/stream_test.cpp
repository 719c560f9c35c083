// Command streams: their bytes for pictures computed by hand, and laws that hold for all of them.
#include "host/programs/skala/stream.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "host/programs/skala/stream_chain.hpp"
#include "host/programs/skala/twin/twin.hpp"
#include "tests/host/programs/skala/stream_support.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::skala {
namespace {

using stream_test::decode;
using stream_test::grid_of;
using stream_test::Line;
using stream_test::lines_of;
using stream_test::named;
using stream_test::Place;
using stream_test::SentCommand;
using Bytes = std::vector<std::uint8_t>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A flat square seen without rotation: near edge and right rim, far edge, left rim.
TEST(SkalaStream, OfAFlatSquare) {
  const Bytes expected{0x0A, 0,   0x07, 0x05, 7,               //
                       0x02, 255, 0,    0x02, 255, 255, 0x06,  // MOVE 0 0 is not needed
                       0x01, 0,   255,  0x02, 255, 255, 0x06, 0x01, 0, 0, 0x02, 0, 255, 0x06, 0x00};
  EXPECT_EQ(stream_of(named("flat", {2, 2}), {}), expected);
  Bytes alone = expected;
  alone[1] = 0x81;
  EXPECT_EQ(stream_of(named("flat", {2, 2}), {.visibility = false}, {Device::alt256}), alone);
}

// Rotated by 45 degrees the square stands on a corner, the right rim continues the near edge, and the left rim comes last. With
// -45
// degrees the left rim comes first.
TEST(SkalaStream, LeadingRimGoesWithTheNearSlice) {
  const Bytes right{0x0A, 0,   0x07, 0x05, 7,                                //
                    0x01, 0,   128,  0x02, 128, 0,   0x02, 255,  128, 0x06,  //
                    0x01, 128, 255,  0x02, 255, 128, 0x06, 0x01, 0,   128,  0x02, 128, 255, 0x06, 0x00};
  Bytes stream = stream_of(named("flat", {2, 2}), {.rotation = -45});
  std::vector<Line> lines = lines_of(stream);
  ASSERT_EQ(lines.size(), 4U);
  // -45: the corner x = -1, z = -1 is in front.
  EXPECT_EQ(lines[0].from, (Place{0, 128}));
  EXPECT_EQ(lines[0].to, (Place{128, 0}));
  EXPECT_EQ(lines[1].to, (Place{255, 128}));
  EXPECT_EQ(lines[0].chain, lines[1].chain);
  EXPECT_EQ(lines[2].from, (Place{0, 128}));
  EXPECT_EQ(lines[2].to, (Place{128, 255}));
  EXPECT_EQ(lines[3].from, (Place{128, 255}));
  EXPECT_EQ(lines[3].to, (Place{255, 128}));
  EXPECT_EQ(stream_of(named("flat", {2, 2}), {.rotation = 45}), right);
}

TEST(SkalaStream, ConsecutiveColumnsAreACurve) {
  const auto commands = decode(stream_of(named("flat", {256, 2}), {}));
  std::vector<SentCommand> curves;
  for (const SentCommand& c : commands)
    if (c.what == Command::curve) curves.push_back(c);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].arguments.size(), 258U);
  EXPECT_EQ(curves[0].arguments[0], 0);
  EXPECT_EQ(curves[0].arguments[1], 0);  // 256
  // More points than columns: points on the same dot are sent once.
  EXPECT_EQ(stream_of(named("flat", {511, 2}), {}), stream_of(named("flat", {256, 2}), {}));
}

TEST(SkalaStream, AHoleBreaksTheSliceAndItsRims) {
  const scene::HeightGrid grid = grid_of({{0, 0, nan, 0, 0}, {nan, 0, 0, nan, 0}, {0, 0, 0, 0, 0}});
  const auto lines = lines_of(stream_of(grid, {}));
  std::vector<std::pair<Place, Place>> expected{
      {{0, 0}, {64, 0}},       {{191, 0}, {255, 0}},     {{255, 0}, {255, 128}},   {{255, 128}, {255, 255}},
      {{64, 128}, {128, 128}}, {{255, 128}, {255, 128}},  // the dot next to the second hole
      {{0, 255}, {64, 255}},   {{64, 255}, {128, 255}},  {{128, 255}, {191, 255}}, {{191, 255}, {255, 255}}};
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].from, expected[i].first) << i;
    EXPECT_EQ(lines[i].to, expected[i].second) << i;
  }
}

TEST(SkalaStream, HolesOfASurfaceAreGaps) {
  const scene::HeightGrid grid = grid_of({{0, 0, 0, 0, 0}, {0, 0, nan, 0, 0}, {nan, 0, 0, 0, nan}});
  std::vector<std::vector<int>> gaps;
  for (const SentCommand& c : decode(stream_of(grid, {.subject = Subject::surface})))
    if (c.what == Command::gap) gaps.push_back(c.arguments);
  // Columns 0, 64, 128, 191, 255: between 64 and 191; before 64; after 191.
  EXPECT_EQ(gaps, (std::vector<std::vector<int>>{{65, 126}, {0, 64}, {192, 64}}));
}

TEST(SkalaStream, ASurfaceBeginsWithTheLeadingRim) {
  const auto left_first =
      decode(stream_of(named("flat", {3, 3}), {.subject = Subject::surface, .rotation = -30}));
  EXPECT_EQ(left_first[4].what, Command::rim);
  const auto right_after =
      decode(stream_of(named("flat", {3, 3}), {.subject = Subject::surface, .rotation = 30}));
  EXPECT_EQ(right_after[3].what, Command::surface);
  EXPECT_EQ(right_after[4].what, Command::rim);
  EXPECT_EQ(right_after[5].what, Command::rim);
  EXPECT_EQ(right_after[6].what, Command::commit);
}

// A plane rising to the right: slope 0.6, normal x component -0.6 / sqrt(1.36) = -0.5145.
TEST(SkalaShades, OfPlanes) {
  EXPECT_EQ(shades(grid_of({{0, 1, 2}, {0, 1, 2}})), std::vector<int>(6, 2));
  EXPECT_EQ(shades(grid_of({{2, 1, 0}, {2, 1, 0}})), std::vector<int>(6, 6));
  EXPECT_EQ(shades(grid_of({{0, 0}, {1, 1}})), std::vector<int>(4, 4));
  EXPECT_EQ(shades(grid_of({{5, 5}, {5, 5}})), std::vector<int>(4, 4));
  // One-sided next to a hole; an isolated point as if level.
  EXPECT_EQ(shades(grid_of({{0, 1, nan, 0, nan}})), (std::vector<int>{1, 1, 0, 4, 0}));
  for (const scene::HeightFunction& f : scene::height_functions()) {
    for (const int shade : shades(scene::sample(f, {33, 30}))) {
      EXPECT_GE(shade, 1);
      EXPECT_LE(shade, 7);
    }
  }
}

// The slope exceeds the largest double, or is 0 divided by 0.
TEST(SkalaShades, OfCliffsAndCoincidentPoints) {
  scene::HeightGrid grid = grid_of({{0, 1, 0}, {0, 1, 0}});
  for (const std::vector<double>& x : {std::vector<double>{-1, -1, 1}, std::vector<double>{0, 1e-320, 1},
                                       std::vector<double>{0, 1e-200, 1}}) {
    grid.x = x;
    for (const int shade : shades(grid)) EXPECT_TRUE(shade >= 1 && shade <= 7) << shade;
  }
  EXPECT_EQ(shades(grid).front(), 1) << "steeply up along x";
}

TEST(SkalaChain, ClipsAtTheBorder) {
  const auto vertex = [](double x, double y) {
    return Vertex{x, y, raster_coordinate(x), raster_coordinate(y), 0, true};
  };
  const Vertex left = vertex(-100, 0);
  const Vertex inside = vertex(100, 200);
  const Vertex above = vertex(200, 400);
  const Vertex right = vertex(300, 100);
  RasterChain chain;
  chain.segment(left, inside, ChainStep::draw);
  chain.segment(inside, above, ChainStep::draw);
  chain.segment(above, right, ChainStep::draw);
  const std::vector<ChainNode> expected{
      {0, 100, 0, ChainStep::draw, true},    {100, 200, 0, ChainStep::draw, false},
      {128, 255, 0, ChainStep::draw, false},  // x = 127.5
      {200, 255, 0, ChainStep::mask, false}, {248, 255, 0, ChainStep::mask, false},
      {255, 235, 0, ChainStep::draw, false},
  };
  EXPECT_EQ(chain.nodes(), expected);
  RasterChain test_only;
  test_only.segment(inside, above, ChainStep::test);
  test_only.segment(above, right, ChainStep::test);
  EXPECT_EQ(test_only.nodes().size(), 4U);
  EXPECT_TRUE(test_only.nodes()[2].fresh);
  const RasterChain back = chain.reversed();
  EXPECT_EQ(back.nodes().front(), (ChainNode{255, 235, 0, ChainStep::draw, true}));
  EXPECT_EQ(back.nodes()[1], (ChainNode{248, 255, 0, ChainStep::draw, false}));
  EXPECT_EQ(back.nodes()[2].step, ChainStep::mask);
  EXPECT_EQ(back.reversed().nodes(), chain.nodes());
}

std::vector<View> views() {
  std::vector<View> result;
  for (int turn = 0; turn < 24; turn += tests::effort(1, 5)) {
    for (const double elevation : {-25.0, 0.0, 35.0}) {
      View view{.rotation = 15.0 * turn, .elevation = elevation};
      for (const Family family : {Family::along_x, Family::along_z, Family::both}) {
        view.family = family;
        result.push_back(view);
      }
      for (const Subject picture : {Subject::surface, Subject::contours}) {
        view.subject = picture;
        view.silhouette = picture == Subject::contours;
        result.push_back(view);
      }
    }
  }
  return result;
}

// In lines that mask or are masked, columns only increase or only decrease between two COMMITs, including moves.
void expect_monotone(const std::vector<Line>& lines, const std::string& what) {
  std::size_t chain = 0;
  int direction = 0;
  int column = -1;
  for (const Line& line : lines) {
    if (line.by == Command::test_draw) continue;
    if (line.chain != chain || column < 0) {
      chain = line.chain;
      direction = 0;
      column = line.from.x;
    }
    for (const int next : {line.from.x, line.to.x}) {
      const int step = (next > column) - (next < column);
      if (direction == 0) direction = step;
      ASSERT_TRUE(step == 0 || step == direction) << what << " chain " << chain;
      column = next;
    }
  }
}

TEST(SkalaStream, ChainsAreMonotoneAndAccepted) {
  for (const scene::HeightFunction& f : scene::height_functions()) {
    const scene::HeightGrid grid = scene::sample(f, {13, 12});
    for (const View& view : views()) {
      const Bytes stream = stream_of(grid, view);
      expect_monotone(lines_of(stream), std::string(f.name) + " rotated " + std::to_string(view.rotation));
      ASSERT_EQ(run_twin(stream).status, Status::complete);
    }
  }
}

TEST(SkalaStream, HolesAndZoomsAreMonotone) {
  scene::HeightGrid grid = named("peaks", {13, 12});
  for (std::size_t i = 0; i < grid.heights.size(); i += 7) grid.heights[i] = nan;
  for (View view : views()) {
    view.zoom = 1 + view.rotation / 60;
    const Bytes stream = stream_of(grid, view, {Device::calcomp});
    expect_monotone(lines_of(stream), "rotated " + std::to_string(view.rotation));
    ASSERT_EQ(run_twin(stream).status, Status::complete);
  }
}

TEST(SkalaStream, SmallAndUndefinedGridsGiveAPicture) {
  for (const scene::HeightGrid& grid : {grid_of({{1.0}}), grid_of({{nan}}), grid_of({{1, 2, 3}}),
                                        grid_of({{1.0}, {2.0}}), grid_of({{nan, nan}, {nan, 1}})}) {
    for (const View& view : views()) ASSERT_EQ(run_twin(stream_of(grid, view)).status, Status::complete);
  }
}

bool same_dots(const Bytes& one, const Bytes& two) {
  return run_twin(one).raster(Device::ef9365) == run_twin(two).raster(Device::ef9365);
}

TEST(SkalaStream, TurningTheDataAndTheEyeTogetherGivesTheSameBytes) {
  const scene::HeightGrid grid = named("peaks", {11, 9});
  const scene::HeightGrid turned = stream_test::rotate_grid(grid);
  for (int turn = 0; turn < 24; ++turn) {
    View view{.family = Family::along_x, .rotation = 15.0 * turn};
    View other{.family = Family::along_z, .rotation = 15.0 * turn - 90};
    EXPECT_TRUE(same_dots(stream_of(grid, view), stream_of(turned, other))) << view.rotation;
    // Slices seen end-on may come in either order, and so may cells next to each other.
    EXPECT_TRUE(turn % 12 == 6 || stream_of(grid, view) == stream_of(turned, other)) << view.rotation;
    if (turn % 6 == 0) continue;
    view.subject = other.subject = Subject::contours;
    view.silhouette = other.silhouette = true;
    const auto one = lines_of(stream_of(grid, view));
    const auto two = lines_of(stream_of(turned, other));
    const auto key = [](const Line& l) {
      return std::tuple{l.by, l.by == Command::mask ? 0 : l.colour, std::min(l.from, l.to),
                        std::max(l.from, l.to)};
    };
    std::multiset<decltype(key(one[0]))> a;
    std::multiset<decltype(key(one[0]))> b;
    for (const Line& l : one) a.insert(key(l));
    for (const Line& l : two) b.insert(key(l));
    EXPECT_TRUE(a == b) << view.rotation;
  }
}

// The same lines with less travel.
TEST(SkalaStream, PlottersDrawInBothDirections) {
  const scene::HeightGrid grid = named("sinc", {33, 30});
  for (const Subject picture : {Subject::lines, Subject::surface, Subject::contours}) {
    const View view{.subject = picture, .rotation = 30, .silhouette = picture == Subject::contours};
    const Bytes turning = stream_of(grid, view, {Device::calcomp});
    const Bytes straight = stream_of(grid, view, {Device::calcomp, false});
    const TwinPicture there_and_back = run_twin(turning);
    const auto serpentine = lines_of(turning);
    const TwinPicture one_way = run_twin(straight);
    const auto plain = lines_of(straight);
    const auto ends = [](const std::vector<Line>& lines) {
      std::multiset<std::pair<Place, Place>> set;
      for (const Line& l : lines)
        if (l.from != l.to) set.insert(std::minmax(l.from, l.to));
      return set;
    };
    EXPECT_TRUE(ends(serpentine) == ends(plain));
    EXPECT_LT(there_and_back.counts.steps_pen_up, one_way.counts.steps_pen_up);
  }
}

}  // namespace
}  // namespace sightline::programs::skala
