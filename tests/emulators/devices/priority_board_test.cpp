// The priority display on an 8-bit bus: registers, the handshake of a frame, and the displayed picture.
#include "emulators/devices/priority_board.hpp"

#include <gtest/gtest.h>

#include <array>

namespace sightline::devices {
namespace {

using Register = PriorityBoard::Register;

constexpr std::int64_t frame = 120'000;  // T-states of 3 MHz in 40 ms

core::TStateInstant at(std::int64_t t) { return core::at_t_state(t); }

// Two surfaces, one line high, that overlap in columns 10 to 19.
void write_two_surfaces(PriorityBoard& board) {
  const std::array<PriorityBoard::HostSurface, 2> surfaces{{{3, 0x111111, 0, 0, 1}, {200, 0x222222, 0, 1, 1}}};
  const std::array<PriorityBoard::HostSpan, 2> spans{{{0, 20}, {10, 30}}};
  board.give(surfaces, spans);
}

void set(PriorityBoard& board, std::uint8_t number, std::uint8_t priority, std::int64_t t) {
  board.write(Register::number, number, at(t));
  board.write(Register::priority, priority, at(t + 10));
}

TEST(PriorityBoard, TheHigherPriorityIsInFront) {
  for (const bool first_in_front : {true, false}) {
    PriorityBoard board(core::ClockRate{});
    write_two_surfaces(board);
    set(board, 3, first_in_front ? 9 : 1, 100);
    set(board, 200, 5, 200);
    board.write(Register::control, 1, at(300));
    board.advance(at(2 * frame));
    const auto picture = board.display().picture();
    EXPECT_EQ(picture[5], 0x111111U);
    EXPECT_EQ(picture[15], first_in_front ? 0x111111U : 0x222222U);
    EXPECT_EQ(picture[25], 0x222222U);
    EXPECT_EQ(picture[30], 0U);
    EXPECT_EQ(board.totals().priorities, 2U);
    EXPECT_EQ(board.totals().shows, 1U);
  }
}

TEST(PriorityBoard, NothingCanBeWrittenWhileAFrameWaits) {
  PriorityBoard board(core::ClockRate{});
  write_two_surfaces(board);
  set(board, 3, 9, 100);
  EXPECT_EQ(board.read(Register::status, at(290)) & 2U, 0U);
  board.write(Register::control, 1, at(300));
  EXPECT_EQ(board.read(Register::status, at(310)) & 2U, 2U);
  set(board, 3, 77, 400);
  EXPECT_EQ(board.totals().writes_lost, 2U);
  EXPECT_EQ(board.priorities()[3], 9);
  // Until the display's next frame begins.
  EXPECT_EQ(board.read(Register::status, at(frame - 1)) & 2U, 2U);
  EXPECT_EQ(board.read(Register::status, at(frame)) & 2U, 0U);
  set(board, 3, 77, frame + 10);
  EXPECT_EQ(board.priorities()[3], 77);
}

TEST(PriorityBoard, KeepsPrioritiesAndShowsWithoutBit0Nothing) {
  PriorityBoard board(core::ClockRate{});
  set(board, 1, 4, 0);
  board.write(Register::control, 0xFE, at(50));
  EXPECT_EQ(board.read(Register::status, at(60)) & 2U, 0U);
  EXPECT_EQ(board.totals().shows, 0U);
  board.write(Register::control, 1, at(70));
  EXPECT_EQ(board.read(Register::status, at(frame)) & 2U, 0U);
  EXPECT_EQ(board.priorities()[1], 4);
  EXPECT_EQ(board.priorities()[0], 0);
}

TEST(PriorityBoard, BlankingAndRegistersThatAreNotThere) {
  PriorityBoard board(core::ClockRate{});
  EXPECT_EQ(board.read(Register::status, at(1000)) & 1U, 0U);
  EXPECT_EQ(board.read(Register::status, at(frame - 100)) & 1U, 1U);
  EXPECT_EQ(board.read(Register::number, at(frame)), 0xFF);
  EXPECT_EQ(board.read(3, at(frame)), 0xFF);
  board.write(3, 1, at(frame));
  EXPECT_EQ(board.totals().unanswered, 3U);
}

}  // namespace
}  // namespace sightline::devices
