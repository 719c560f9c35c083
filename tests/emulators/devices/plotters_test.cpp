// CalComp 565 and Minigraf 0507: every direction, the timed handshake, and every error. At 3 MHz a CalComp step of 3.333333 ms
// is 10,000 T-states (9,999.999 rounded up) and a pen command 300,000.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "emulators/devices/calcomp565.hpp"
#include "emulators/devices/minigraf0507.hpp"
#include "tests/emulators/devices/device_test.hpp"

namespace {

using namespace sightline::devices;
using sightline::core::at_nanoseconds;
using sightline::core::at_t_state;
using sightline::core::never_t;
using sightline::core::Stroke;
using sightline::core::StrokeBuffer;
using sightline::tests::Access;
using sightline::tests::KeptStrokes;
using sightline::tests::three_megahertz;

// The strokes of a plotter.
struct Paper {
  Paper() { strokes.hand_to(&taker); }
  const std::vector<Stroke>& marks() {
    strokes.flush();
    return taker.kept;
  }
  StrokeBuffer strokes;
  KeptStrokes taker;
};

TEST(CalComp565, HandshakeTranscript) {
  Paper paper;
  CalComp565 plotter(three_megahertz, paper.strokes, {100, 50});
  constexpr bool reads = true;
  const std::vector<Access> transcript{
      {0, reads, 0x00},        {10, !reads, 0x09},      {20, reads, 0x05},  // pen down, busy
      {300'009, reads, 0x05},  {300'010, reads, 0x06},                      // done
      {300'020, !reads, 0x01}, {300'030, reads, 0x05},                      // step +x+y clears DONE
      {300'040, !reads, 0x02}, {300'050, reads, 0x85},                      // while busy: ERROR
      {310'020, reads, 0x86},  {310'030, !reads, 0x05},                     // step -x-y clears ERROR
      {310'040, reads, 0x05},  {320'030, reads, 0x06},  {320'040, !reads, 0x55},
      {320'050, reads, 0x86},  // unknown code: ERROR, not busy
      {320'060, !reads, 0x08}, {320'070, reads, 0x01},  {620'060, reads, 0x02},
  };
  for (const Access& access : transcript) {
    if (access.reads)
      EXPECT_EQ(int{plotter.read_status(at_t_state(access.t))}, int{access.value}) << "T " << access.t;
    else
      plotter.write(access.value, at_t_state(access.t));
  }
  const std::vector<Stroke> expected{{at_nanoseconds(100'003'333), 100, 50, 7, 0},
                                     {at_nanoseconds(103'340'000), 101, 51, 7, 0},
                                     {at_nanoseconds(106'676'666), 100, 50, 7, 0}};
  EXPECT_EQ(paper.marks(), expected);
  EXPECT_EQ(plotter.totals().commands_while_busy, 1U);
  EXPECT_EQ(plotter.totals().unknown_codes, 1U);
  EXPECT_EQ(plotter.totals().steps, 2U);
  EXPECT_EQ(plotter.totals().pen_lifts, 1U);
  EXPECT_EQ(plotter.totals().busy.count(), 620'000);
}

TEST(CalComp565, TheDrumPositionWraps) {
  constexpr std::int32_t last = std::numeric_limits<std::int32_t>::max();
  Paper paper;
  CalComp565 plotter(three_megahertz, paper.strokes, {last, 0});
  plotter.write(2, at_t_state(0));
  EXPECT_EQ(plotter.place(), (PlotterPlace{last, 0}));
  CalComp565 back(three_megahertz, paper.strokes, {-last - 1, 0});
  back.write(6, at_t_state(0));
  EXPECT_EQ(back.place(), (PlotterPlace{-last - 1, 0}));
}

TEST(Minigraf0507, AMotorPositionWraps) {
  constexpr std::int32_t last = std::numeric_limits<std::int32_t>::max();
  Paper paper;
  Minigraf0507 plotter(three_megahertz, paper.strokes, {}, {last, -last - 1});
  plotter.write(0x39, at_t_state(0));  // +x, -y
  EXPECT_EQ(plotter.place(), (PlotterPlace{last, -last - 1}));
  EXPECT_EQ(plotter.totals().steps, 1U);
}

TEST(CalComp565, EightDirectionsClockwiseFromPlusY) {
  constexpr std::array<PlotterPlace, 8> expected{
      {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};
  Paper paper;
  for (std::uint8_t code = 0; code < 8; ++code) {
    CalComp565 plotter(three_megahertz, paper.strokes, {500, 500});
    plotter.write(code, at_t_state(0));
    EXPECT_EQ(plotter.place(), (PlotterPlace{500 + expected[code].x, 500 + expected[code].y})) << int{code};
    EXPECT_EQ(plotter.totals().steps_pen_up, 1U);
  }
  EXPECT_TRUE(paper.marks().empty());
}

TEST(CalComp565, TheCarriageEndsAtElevenInchesTheDrumNever) {
  Paper paper;
  CalComp565 plotter(three_megahertz, paper.strokes, {0, 1099});
  plotter.write(0, at_t_state(0));
  EXPECT_EQ(plotter.read_status(at_t_state(10'000)) & 0x80, 0);
  plotter.write(1, at_t_state(20'000));
  EXPECT_EQ(plotter.place(), (PlotterPlace{1, 1100}));
  EXPECT_EQ(int{plotter.read_status(at_t_state(20'010))}, 0x81);
  plotter.write(6, at_t_state(30'000));
  plotter.write(6, at_t_state(40'000));
  EXPECT_EQ(plotter.place(), (PlotterPlace{-1, 1100}));
  EXPECT_EQ(int{plotter.read_status(at_t_state(50'000))}, 0x02);
  EXPECT_EQ(plotter.totals().off_carriage, 1U);
  plotter.write(9, at_t_state(60'000));
  EXPECT_EQ(plotter.totals().off_paper, 1U);
  EXPECT_TRUE(paper.marks().empty());
}

TEST(CalComp565, PenCommandsTakeTheirTimeEvenWhenNothingMoves) {
  Paper paper;
  CalComp565 plotter(three_megahertz, paper.strokes);
  EXPECT_EQ(plotter.deadline(), never_t);
  plotter.write(8, at_t_state(0));
  EXPECT_EQ(plotter.deadline(), at_t_state(300'000));
  plotter.write(9, at_t_state(300'000));
  plotter.write(9, at_t_state(600'000));
  EXPECT_EQ(paper.marks().size(), 1U);
  plotter.advance(at_t_state(899'999));
  EXPECT_FALSE(plotter.done());
  plotter.advance(at_t_state(900'000));
  EXPECT_TRUE(plotter.done());
  EXPECT_EQ(plotter.deadline(), never_t);
  EXPECT_EQ(plotter.totals().pen_lifts, 0U);
  EXPECT_EQ(plotter.totals().pen_commands, 3U);
}

TEST(Minigraf0507, PhasesStepBothMotorsForwardAndBack) {
  Paper paper;
  Minigraf0507 plotter(three_megahertz, paper.strokes, {}, {10, 10});
  std::int64_t t = 0;
  const auto out = [&](int x_phase, int y_phase, int pen) {
    plotter.write(static_cast<std::uint8_t>(x_phase | y_phase << 3 | pen << 7), at_t_state(t));
    t += 10'000;
  };
  out(0, 0, 1);  // touches where it is
  out(1, 0, 1);
  out(2, 1, 1);  // diagonal
  out(1, 1, 1);
  out(0, 0, 1);
  out(7, 7, 1);  // 0 - 1 modulo 8
  out(7, 7, 0);
  out(7, 0, 0);
  const std::vector<Stroke> expected{
      {at_nanoseconds(0), 10, 10, 7, 0},          {at_nanoseconds(3'333'333), 11, 10, 7, 0},
      {at_nanoseconds(6'666'666), 12, 11, 7, 0},  {at_nanoseconds(10'000'000), 11, 11, 7, 0},
      {at_nanoseconds(13'333'333), 10, 10, 7, 0}, {at_nanoseconds(16'666'666), 9, 9, 7, 0}};
  EXPECT_EQ(paper.marks(), expected);
  EXPECT_EQ(plotter.place(), (PlotterPlace{9, 10}));
  EXPECT_EQ(plotter.totals().steps, 6U);
  EXPECT_EQ(plotter.totals().steps_pen_up, 1U);
  EXPECT_EQ(plotter.totals().pen_lifts, 1U);
  EXPECT_EQ(plotter.totals().missed_fast + plotter.totals().missed_jump, 0U);
}

TEST(Minigraf0507, StepsTooSoonAndJumpsOfPhaseAreMissed) {
  Paper paper;
  Minigraf0507 plotter(three_megahertz, paper.strokes, {sightline::core::Duration(5'000'000), {}},
                                    {10, 10});
  plotter.write(0x01, at_t_state(0));
  plotter.write(0x02, at_t_state(14'999));
  EXPECT_EQ(plotter.place(), (PlotterPlace{11, 10}));
  EXPECT_EQ(plotter.totals().missed_fast, 1U);
  plotter.write(0x0A, at_t_state(14'999));  // the Y motor has been at rest long enough
  EXPECT_EQ(plotter.place(), (PlotterPlace{11, 11}));
  plotter.write(0x0B, at_t_state(15'000));
  EXPECT_EQ(plotter.place(), (PlotterPlace{12, 11}));
  plotter.write(0x0F, at_t_state(100'000));
  EXPECT_EQ(plotter.place(), (PlotterPlace{12, 11}));
  EXPECT_EQ(plotter.totals().missed_jump, 1U);
}

TEST(Minigraf0507, ThePenNeedsItsTimeAndTheFieldHasNoStops) {
  Paper paper;
  Minigraf0507 plotter(three_megahertz, paper.strokes, {{}, sightline::core::Duration(10'000'000)},
                                    {1500, 0});
  plotter.write(0x80, at_t_state(0));
  plotter.write(0x81, at_t_state(29'999));
  EXPECT_EQ(plotter.totals().steps_early, 1U);
  plotter.write(0x80, at_t_state(30'000));
  EXPECT_EQ(paper.marks().size(), 2U);
  EXPECT_EQ(paper.marks()[0], (Stroke{at_nanoseconds(10'000'000), 1500, 0, 7, 0}));
  plotter.write(0xB8, at_t_state(40'000));
  EXPECT_EQ(plotter.place(), (PlotterPlace{1500, -1}));
  EXPECT_EQ(plotter.totals().off_field, 2U);
  EXPECT_EQ(paper.marks().size(), 2U);
}

}  // namespace
