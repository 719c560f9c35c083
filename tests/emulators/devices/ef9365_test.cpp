// The EF9365 board register by register. Dots are written out by hand from the command table; times are the
// data in ef9365_timing.hpp worked out in T-states at 3 MHz (12/7 T a clock).
#include "emulators/devices/ef9365.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tests/emulators/devices/device_test.hpp"

namespace {

using sightline::core::at_t_state;
using sightline::devices::Ef9365;
using sightline::tests::three_megahertz;

// The board, given an instruction every thousand T-states, which is longer than any vector.
class Board : public testing::Test {
 protected:
  void out(int number, int value) {
    board->write(static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(value), at_t_state(t += 1000));
  }
  void command(int code) { out(0, code); }
  int in(int number) { return board->read(static_cast<std::uint8_t>(number), at_t_state(t += 1000)); }
  void place(int x, int y) {
    out(0x8, x >> 8);
    out(0x9, x & 0xFF);
    out(0xA, y >> 8);
    out(0xB, y & 0xFF);
  }
  int x() { return (in(0x8) << 8) | in(0x9); }
  int y() { return (in(0xA) << 8) | in(0xB); }
  void pen_of_colour(int colour) {
    board->set_colour(static_cast<std::uint8_t>(colour), at_t_state(t));
    command(0x00);
    command(0x02);
  }
  // T-states from a command until the board is ready again.
  std::int64_t busy_after(int code) {
    command(code);
    return sightline::core::t_states_of(board->busy_until()) - t;
  }
  // The rectangle from (x, y) upwards, top row first, '.' for 0.
  std::string shown(int left, int bottom, int width, int height) const {
    std::string text;
    for (int row = bottom + height - 1; row >= bottom; --row) {
      for (int column = left; column < left + width; ++column) {
        const int value =
            board->raster()->at(static_cast<std::uint8_t>(column), static_cast<std::uint8_t>(row));
        text += value == 0 ? '.' : static_cast<char>('0' + value);
      }
      text += '\n';
    }
    return text;
  }

  std::unique_ptr<Ef9365> board = std::make_unique<Ef9365>(three_megahertz);
  std::int64_t t = 0;
};

TEST_F(Board, RegistersKeepTheBitsTheyHave) {
  const std::vector<std::vector<int>> kept{{0x1, 0x73}, {0x2, 0x0F}, {0x3, 0xFF}, {0x5, 0xFF}, {0x7, 0xFF},
                                           {0x8, 0x0F}, {0x9, 0xFF}, {0xA, 0x0F}, {0xB, 0xFF}};
  for (const auto& pair : kept) {
    out(pair[0], 0xFF);
    EXPECT_EQ(in(pair[0]), pair[1]) << pair[0];
    out(pair[0], 0);
    EXPECT_EQ(in(pair[0]), 0) << pair[0];
  }
}

TEST_F(Board, RegistersThatDoNotExistReadAsOnesAndTheLightPenAsZero) {
  for (const int number : {0x4, 0x6, 0xE, 0xF}) {
    out(number, 0x55);
    EXPECT_EQ(in(number), 0xFF);
  }
  EXPECT_EQ(in(0xC), 0);
  EXPECT_EQ(in(0xD), 0);
  EXPECT_EQ(board->totals().unanswered, 4U);
}

TEST_F(Board, AbsoluteDotsAreThreeWrites) {
  pen_of_colour(5);
  out(0x9, 200);
  out(0xB, 3);
  command(0x80);
  EXPECT_EQ(board->raster()->at(200, 3), 5);
  EXPECT_EQ(board->totals().dots, 1U);
  EXPECT_EQ(x(), 200);
  EXPECT_EQ(y(), 3);
}

TEST_F(Board, PenUpMovesOnlyAndTheEraserClearsAllPlanes) {
  pen_of_colour(7);
  place(10, 10);
  command(0x80);
  command(0x03);
  command(0xE0);  // three to the right
  EXPECT_EQ(x(), 13);
  EXPECT_EQ(board->totals().dots, 1U);
  command(0x01);
  command(0x02);
  command(0xE6);  // and back
  EXPECT_EQ(shown(9, 10, 6, 1), "......\n");
  EXPECT_EQ(board->totals().dots, 5U);
}

TEST_F(Board, TheLatchReplacesAllThreePlanes) {
  pen_of_colour(5);
  command(0x80);
  board->set_colour(2, at_t_state(t));
  command(0x80);
  EXPECT_EQ(board->raster()->at(0, 0), 2);
  board->set_colour(0xF8, at_t_state(t));
  EXPECT_EQ(board->colour(), 0);
  command(0x80);
  EXPECT_EQ(board->raster()->at(0, 0), 0);
}

struct DirectionRow {
  int code;
  int dx;
  int dy;
};
// Bits 2-0 of the command, with |dx| = 3 and |dy| = 2.
constexpr DirectionRow directions[]{{0, 3, 0},  {1, 3, 2},  {2, 0, 2},  {3, -3, 2},
                                    {4, 0, -2}, {5, 3, -2}, {6, -3, 0}, {7, -3, -2}};

TEST_F(Board, SmallVectorsHaveTwoBitsAnAxisAndADirection) {
  for (const DirectionRow& row : directions) {
    place(100, 100);
    command(0x80 | 3 << 5 | 2 << 3 | row.code);
    EXPECT_EQ(x(), 100 + row.dx) << row.code;
    EXPECT_EQ(y(), 100 + row.dy) << row.code;
  }
}

TEST_F(Board, VectorsTakeTheirLengthsFromTheDeltas) {
  out(0x5, 30);
  out(0x7, 200);
  for (const DirectionRow& row : directions) {
    place(1000, 1000);
    command(0x10 | row.code);
    EXPECT_EQ(x(), 1000 + (row.dx > 0) * 30 - (row.dx < 0) * 30) << row.code;
    EXPECT_EQ(y(), 1000 + (row.dy > 0) * 200 - (row.dy < 0) * 200) << row.code;
  }
}

TEST_F(Board, SpecialVectorsRunByTheLargerDelta) {
  out(0x5, 30);
  out(0x7, 200);
  for (const DirectionRow& row : directions) {
    place(1000, 1000);
    command(0x18 | row.code);
    EXPECT_EQ(x(), 1000 + (row.dx > 0) * 200 - (row.dx < 0) * 200) << row.code;
    EXPECT_EQ(y(), 1000 + (row.dy > 0) * 200 - (row.dy < 0) * 200) << row.code;
  }
}

TEST_F(Board, BothEndDotsAreDrawnAndTheMiddleIsRounded) {
  pen_of_colour(1);
  place(4, 4);
  out(0x5, 5);
  out(0x7, 2);
  command(0x11);
  EXPECT_EQ(shown(4, 4, 6, 3),
            "....11\n"
            "..11..\n"
            "11....\n");
}

TEST_F(Board, AnExactTieStaysOnTheStartingSide) {
  pen_of_colour(1);
  place(10, 10);
  command(0x80 | 2 << 5 | 1 << 3 | 1);
  place(32, 11);
  command(0x80 | 2 << 5 | 1 << 3 | 7);
  EXPECT_EQ(shown(10, 10, 3, 2), "..1\n11.\n");
  EXPECT_EQ(shown(30, 10, 3, 2), ".11\n1..\n");
}

TEST_F(Board, LineStyles) {
  pen_of_colour(1);
  out(0x5, 20);
  const std::string_view lines[]{"111111111111111111111\n", "11..11..11..11..11..1\n",
                                 "1111....1111....1111.\n", "1111111111..11..11111\n"};
  for (int style = 0; style < 4; ++style) {
    place(0, style);
    out(0x2, style);
    command(0x10);
    EXPECT_EQ(shown(0, style, 21, 1), lines[style]) << style;
  }
}

TEST_F(Board, DotsOutsideAreClippedAndStatusSaysSo) {
  pen_of_colour(1);
  place(254, 7);
  EXPECT_EQ(in(0) & 0x08, 0);
  command(0xE0);
  EXPECT_EQ(x(), 257);
  EXPECT_EQ(board->totals().dots_outside, 2U);
  EXPECT_EQ(shown(250, 7, 6, 1), "....11\n");
  EXPECT_EQ(shown(0, 7, 4, 1), "....\n");
  EXPECT_EQ(in(0) & 0x08, 0x08);
  place(0, 0);
  command(0xE6);
  EXPECT_EQ(x(), 0xFFD);
}

TEST_F(Board, ClearResetAndOriginCommands) {
  pen_of_colour(3);
  const auto dirty = [&] {
    t += 200'000;
    place(50, 60);
    command(0x80);
    out(0x5, 9);
  };
  dirty();
  command(0x0D);
  EXPECT_EQ(x(), 0);
  EXPECT_EQ(y(), 60);
  command(0x0E);
  EXPECT_EQ(y(), 0);
  dirty();
  command(0x05);
  EXPECT_EQ(x() + y(), 0);
  EXPECT_EQ(board->raster()->at(50, 60), 3);
  dirty();
  command(0x04);
  EXPECT_EQ(board->raster()->at(50, 60), 0);
  EXPECT_EQ(x(), 50);
  dirty();
  command(0x06);
  EXPECT_EQ(board->raster()->at(50, 60), 0);
  EXPECT_EQ(x() + y(), 0);
  dirty();
  command(0x07);
  EXPECT_EQ(board->raster()->at(50, 60), 0);
  EXPECT_EQ(in(0x3), 0x11);
  for (const int number : {0x1, 0x2, 0x5, 0x7, 0x9, 0xB}) EXPECT_EQ(in(number), 0) << number;
  EXPECT_EQ(board->colour(), 3);
}

TEST_F(Board, ScreenScanningFillsWithPenOrEraser) {
  pen_of_colour(6);
  command(0x03);
  command(0x0C);
  EXPECT_EQ(board->raster()->at(0, 255), 6);
  EXPECT_EQ(board->raster()->at(255, 0), 6);
  t += 200'000;
  command(0x01);
  command(0x0C);
  EXPECT_EQ(board->raster()->at(0, 255), 0);
}

TEST_F(Board, CharactersAreFiveByEightAndAdvanceSix) {
  pen_of_colour(1);
  out(0x3, 0x11);
  place(20, 20);
  command('F');
  command('g');
  EXPECT_EQ(x(), 32);
  EXPECT_EQ(shown(20, 20, 11, 8),
            "11111......\n"
            "1..........\n"
            "1......1111\n"
            "1111..1...1\n"
            "1.....1...1\n"
            "1......1111\n"
            "1.........1\n"
            ".......111.\n");
}

TEST_F(Board, SizesScaleBothWaysAndZeroIsSixteen) {
  pen_of_colour(1);
  out(0x3, 0x23);
  place(0, 0);
  command(0x0A);
  EXPECT_EQ(board->totals().dots, 10U * 24U);
  EXPECT_EQ(x(), 12);
  EXPECT_EQ(board->raster()->at(9, 23), 1);
  EXPECT_EQ(board->raster()->at(10, 0), 0);
  EXPECT_EQ(board->raster()->at(0, 24), 0);
  out(0x3, 0x00);
  place(0, 100);
  command(0x0B);
  EXPECT_EQ(board->totals().dots, 240U + 64U * 64U);
  EXPECT_EQ(x(), 80);
}

TEST_F(Board, VerticalAndLeaningWriting) {
  pen_of_colour(1);
  out(0x3, 0x11);
  place(40, 40);
  out(0x2, 0x08);
  command('L');  // turned left: the foot of the L stands upright to the left of the origin
  EXPECT_EQ(shown(33, 40, 8, 5),
            "......1.\n"
            "......1.\n"
            "......1.\n"
            "......1.\n"
            "1111111.\n");
  EXPECT_EQ(y(), 46);
  EXPECT_EQ(x(), 40);
  place(60, 60);
  out(0x2, 0x04);
  command('|');
  EXPECT_EQ(shown(60, 60, 10, 8),
            ".........1\n"
            "........1.\n"
            ".......1..\n"
            "......1...\n"
            ".....1....\n"
            "....1.....\n"
            "...1......\n"
            "..........\n");
}

TEST_F(Board, BusyTimes) {
  // Clocks at 1.75 MHz, in T-states of 1/3 us, rounded up: n clocks are 12 n / 7.
  EXPECT_EQ(busy_after(0x02), 7);  // 4 clocks
  EXPECT_EQ(busy_after(0x80), 4);  // 1 dot: 2 clocks
  EXPECT_EQ(busy_after(0xA0), 6);  // 2 dots: 3 clocks
  EXPECT_EQ(busy_after(0xE0), 9);  // 4 dots: 5 clocks
  out(0x5, 255);
  EXPECT_EQ(busy_after(0x10), 441);  // 256 dots: 257 clocks, 440.57
  out(0x3, 0x11);
  EXPECT_EQ(busy_after('A'), 84);    // 48 dots: 49 clocks
  EXPECT_EQ(busy_after(0x0F), 110);  // 64 clocks, 109.7
  EXPECT_EQ(busy_after(0x04), 120'000);
}

TEST_F(Board, CommandsWhileBusyAreIgnoredAndCounted) {
  pen_of_colour(1);
  command(0x04);
  const std::int64_t begun = t;
  board->write(0, 0x80, at_t_state(begun + 119'999));
  EXPECT_EQ(board->totals().commands_while_busy, 1U);
  EXPECT_EQ(board->raster()->at(0, 0), 0);
  EXPECT_EQ(board->read(0, at_t_state(begun + 119'999)) & 0x04, 0);
  EXPECT_EQ(board->read(0, at_t_state(begun + 120'000)) & 0x04, 0x04);
  board->write(0, 0x80, at_t_state(begun + 120'000));
  EXPECT_EQ(board->raster()->at(0, 0), 1);
  EXPECT_EQ(board->totals().commands_while_busy, 1U);
}

TEST_F(Board, RegistersWrittenWhileBusyAreStoredAndCounted) {
  command(0x04);
  board->write(0x9, 77, at_t_state(t + 10));
  board->set_colour(2, at_t_state(t + 20));
  EXPECT_EQ(board->totals().writes_while_busy, 2U);
  EXPECT_EQ(x(), 77);
}

// Field of 19.968 ms = 59,904 T; blanking begins 16.384 ms = 49,152 T after its start.
TEST_F(Board, BlankingIsSeenFiftyTimesASecond) {
  const auto blank = [&](std::int64_t at) { return (board->read(0, at_t_state(at)) & 0x02) != 0; };
  EXPECT_FALSE(blank(49'151));
  EXPECT_TRUE(blank(49'152));
  EXPECT_TRUE(blank(59'903));
  EXPECT_FALSE(blank(59'904));
  EXPECT_TRUE(blank(59'904 * 50 + 49'152));
}

TEST_F(Board, BlankingInterrupt) {
  board->write(1, 0x20, at_t_state(100));
  EXPECT_EQ(board->deadline(), at_t_state(49'152));
  board->advance(at_t_state(49'151));
  EXPECT_FALSE(board->interrupt());
  board->advance(at_t_state(49'152));
  EXPECT_TRUE(board->interrupt());
  EXPECT_EQ(board->read(0, at_t_state(49'200)) & 0xF0, 0xA0);
  EXPECT_FALSE(board->interrupt());
  EXPECT_EQ(board->read(0, at_t_state(49'300)) & 0xF0, 0x00);
  EXPECT_EQ(board->deadline(), at_t_state(49'152 + 59'904));
  board->write(1, 0, at_t_state(60'000));
  EXPECT_EQ(board->deadline(), sightline::core::never_t);
  board->advance(at_t_state(1'000'000));
  EXPECT_FALSE(board->interrupt());
}

TEST_F(Board, NoBlankingBeyondTheNanosecondRange) {
  board = std::make_unique<Ef9365>(sightline::core::ClockRate{1});
  board->write(1, 0x20, at_t_state(9'300'000'000));
  EXPECT_EQ(board->deadline(), sightline::core::never_t);
}

TEST_F(Board, ReadyInterruptComesAtTheEndOfACommandOnly) {
  board->write(1, 0x40, at_t_state(100));
  EXPECT_EQ(board->deadline(), sightline::core::never_t);
  board->write(0, 0x04, at_t_state(200));
  EXPECT_EQ(board->deadline(), at_t_state(120'200));
  board->advance(at_t_state(120'200));
  EXPECT_TRUE(board->interrupt());
  EXPECT_EQ(board->read(0, at_t_state(120'300)) & 0xF4, 0xC4);
  EXPECT_FALSE(board->interrupt());
  EXPECT_EQ(board->deadline(), sightline::core::never_t);
}

}  // namespace
