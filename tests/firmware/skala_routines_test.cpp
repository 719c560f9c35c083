// The resident Skala program, command by command: hand-worked cases, lines in all octants, and random streams compared with a
// plain implementation of the specification, on every device.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "tests/firmware/skala_machine.hpp"
#include "tests/firmware/skala_reference.hpp"
#include "tests/firmware/skala_streams.hpp"
#include "tests/support/effort.hpp"

namespace sightline::skala_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Dots = std::set<std::pair<int, int>>;

const std::vector<Attachment> raster_only{{"ef9365"}, {"parallel"}};

// Dots of a colour other than 0 after a run that must succeed.
Dots dots(const Bytes& commands) {
  SkalaMachine machine(commands, raster_only);
  EXPECT_EQ(machine.run(), 1);
  Dots lit;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      if (machine.ef9365().raster()->at(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)) !=
          0)
        lit.insert({x, y});
  return lit;
}

TEST(SkalaProgram, FitsBelowItsMasks) {
  EXPECT_LE(label("CODEND"), label("MT"));
  for (const char* page : {"MT", "MB", "MP", "IP", "LOWT", "HIGHB", "BUFFER"})
    EXPECT_EQ(label(page) & 0xFFU, 0U) << page;
  EXPECT_EQ(label("BUFFER"), 0x2000);
  EXPECT_EQ(label("START"), program().image.start.value_or(0));
}

// Worked by hand from section 3: e = -3 at first, then -1, 1-5, -2, 0-5, -3. Backwards it lights the same dots.
TEST(SkalaLines, LightTheSameDotsInBothDirections) {
  const Dots expected{{10, 20}, {11, 20}, {12, 21}, {13, 21}, {14, 22}, {15, 22}};
  for (const int device : {0x00, 0x80}) {
    const auto d = static_cast<std::uint8_t>(device);
    EXPECT_EQ(dots({10, d, 1, 10, 20, 2, 15, 22, 0}), expected) << device;
    EXPECT_EQ(dots({10, d, 1, 15, 22, 2, 10, 20, 0}), expected) << device;
  }
}

TEST(SkalaLines, AreHiddenBetweenTheMasks) {
  // A bar from row 50 to 60 in columns 10 to 12, then a column-wise zigzag through it.
  const Dots lit = dots({1, 10, 60, 2, 12, 60, 6, 1, 10, 50, 2, 12, 50, 6, 1, 11, 40, 2, 11, 70, 0});
  for (int y = 40; y <= 70; ++y) EXPECT_EQ(lit.contains({11, y}), y <= 50 || y >= 60) << y;
}

TEST(SkalaLines, InAllDirections) {
  NEEDS_OPTIMISED_CODE();
  std::vector<std::pair<int, int>> deltas;
  const int step = tests::effort(1, 4);
  for (int dx = -13; dx <= 13; dx += step)
    for (int dy = -13; dy <= 13; dy += step) deltas.emplace_back(dx, dy);
  for (const int a : {-127, -126, -64, -1, 0, 1, 63, 126, 127})
    for (const int b : {-127, -100, -2, 0, 1, 99, 127}) {
      deltas.emplace_back(a, b);
      deltas.emplace_back(b, a);
    }
  for (const bool visible : {true, false}) {
    for (const auto& [dx, dy] : deltas) {
      const Bytes commands{10,
                           static_cast<std::uint8_t>(visible ? 0 : 0x80),
                           1,
                           127,
                           127,
                           2,
                           static_cast<std::uint8_t>(127 + dx),
                           static_cast<std::uint8_t>(127 + dy),
                           0};
      Reference reference;
      reference.run(commands);
      Dots expected;
      for (int i = 0; i < 65536; ++i)
        if (reference.picture[static_cast<std::size_t>(i)] != 0) expected.insert({i & 255, i >> 8});
      ASSERT_EQ(dots(commands), expected) << dx << ' ' << dy;
    }
  }
  // The longest: 255 steps.
  EXPECT_EQ(dots({1, 0, 0, 2, 255, 255, 0}).size(), 256U);
  EXPECT_EQ(dots({1, 255, 0, 2, 0, 255, 0}).size(), 256U);
  EXPECT_EQ(dots({2, 255, 1, 0}).size(), 256U);
}

TEST(SkalaMasks, AreFoldedAfterTheColumn) {
  SkalaMachine machine({1, 30, 100, 2, 30, 110, 2, 31, 110, 4, 32, 90, 6, 0});
  ASSERT_EQ(machine.run(), 1);
  EXPECT_EQ(machine.page("MT")[30], 110);
  EXPECT_EQ(machine.page("MB")[30], 100);
  EXPECT_EQ(machine.page("MT")[33], 0);
  EXPECT_EQ(machine.page("MB")[33], 255);
  EXPECT_EQ(machine.page("MB")[32], 90);
}

// Section 6: the column is filled down to the slice before, while the level falls from 6 to 2.
TEST(SkalaSurface, FillsDownToTheSliceBefore) {
  SkalaMachine machine({9, 2, 50, 100, 2, 52, 100, 2, 6, 9, 2, 50, 108, 6, 52, 108, 6, 6, 0}, raster_only);
  ASSERT_EQ(machine.run(), 1);
  const auto& raster = *machine.ef9365().raster();
  // N = 8, D = 4: g = -4, 0 (level 5, -8), -4, 0 (level 4, -8), ...
  const std::vector<int> expected{6, 5, 5, 4, 4, 3, 3, 2};
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(raster.at(51, static_cast<std::uint8_t>(108 - i)), expected[static_cast<std::size_t>(i)]) << i;
  EXPECT_EQ(raster.at(51, 100), 2);
  EXPECT_EQ(raster.at(51, 99), 0);
}

// Compares every pen stroke, and every dot and mask of a board, with the specification.
void compare(const StreamKind& kind, std::uint32_t seed) {
  StreamMaker maker(kind, seed);
  const Bytes commands = maker.make(1 + static_cast<int>(seed * 37 % 120));
  Reference reference;
  reference.run(commands);
  SkalaMachine machine(commands);
  ASSERT_EQ(machine.run(), 1) << "seed " << seed;
  for (std::size_t x = 0; x < 256; ++x) {
    ASSERT_EQ(machine.page("MT")[x], reference.top[x]) << "seed " << seed << " column " << x;
    ASSERT_EQ(machine.page("MB")[x], reference.bottom[x]) << "seed " << seed << " column " << x;
  }
  if (kind.device < 2) {
    const auto points =
        (kind.device == 0 ? machine.ef9365().raster() : machine.alt256().raster())->points();
    const std::size_t shown = kind.device == 0 ? 65536 : 240 * 256;  // the ALT-256 has no rows beyond
    for (std::size_t i = 0; i < shown; ++i)
      ASSERT_EQ(points[i], reference.picture[i]) << "seed " << seed << " at " << i % 256 << ' ' << i / 256;
    EXPECT_EQ(machine.ef9365().totals().commands_while_busy, 0U);
    EXPECT_EQ(machine.ef9365().totals().writes_while_busy, 0U);
    return;
  }
  std::vector<std::pair<int, int>> inked, expected;
  bool down = false;
  for (const PlotterStep& step : reference.steps) {
    if (step.kind != PenMove::step) down = step.kind == PenMove::down;
    if (down) expected.emplace_back(step.x, step.y);
  }
  for (const core::Stroke& stroke : machine.strokes()) inked.emplace_back(stroke.x, stroke.y);
  ASSERT_EQ(inked, expected) << "seed " << seed;
}

TEST(SkalaStreams, OnTheEf9365) {
  for (std::uint32_t seed = 0; seed < tests::effort(400U, 20U); ++seed) {
    compare({0, seed % 5 != 0, false, seed % 2 == 0}, seed);
    if (HasFatalFailure()) return;
  }
}

TEST(SkalaStreams, WithSilhouettes) {
  NEEDS_OPTIMISED_CODE();
  for (std::uint32_t seed = 0; seed < tests::effort(200U, 10U); ++seed) {
    compare({0, true, true, seed % 4 == 0}, 1000 + seed);
    if (HasFatalFailure()) return;
  }
}

TEST(SkalaStreams, OnTheAlt256) {
  for (std::uint32_t seed = 0; seed < tests::effort(60U, 4U); ++seed) {
    compare({1, seed % 4 != 0, seed % 3 == 0, seed % 2 == 0}, 2000 + seed);
    if (HasFatalFailure()) return;
  }
}

TEST(SkalaStreams, OnThePlotters) {
  for (std::uint32_t seed = 0; seed < tests::effort(16U, 2U); ++seed) {
    compare({2 + static_cast<int>(seed % 2), seed % 8 > 1, seed % 3 == 0, seed % 4 < 2}, 3000 + seed);
    if (HasFatalFailure()) return;
  }
}

// The cost of a step of the inner loops, which NOTES.md states: the difference that one more step makes.
std::int64_t t_states(const Bytes& commands) {
  SkalaMachine machine(commands, raster_only);
  EXPECT_TRUE(machine.run_to("DRAWIT", 1'000'000));
  const auto begun = machine.machine().now();
  EXPECT_EQ(machine.run(), 1);
  return (machine.machine().now() - begun).count();
}

TEST(SkalaLoops, CostWhatTheNotesSay) {
  auto flat = [](std::uint8_t device, std::uint8_t length, std::uint8_t row) {
    // Two slices first, so that no column is new; then the line to measure.
    return Bytes{10, device, 8, 0,   1,  90, 1, 0, 100, 2, 255,    100, 6, 1,
                 0,  80,     2, 255, 80, 6,  1, 0, row, 2, length, row, 0};
  };
  const auto per_step = [&](std::uint8_t device, std::uint8_t row) {
    return t_states(flat(device, 101, row)) - t_states(flat(device, 100, row));
  };
  EXPECT_EQ(per_step(0x80, 90), 74);    // without the test
  EXPECT_EQ(per_step(0x00, 90), 97);    // hidden
  EXPECT_EQ(per_step(0x00, 120), 118);  // above
  EXPECT_EQ(per_step(0x00, 60), 136);   // below
}

}  // namespace
}  // namespace sightline::skala_test
