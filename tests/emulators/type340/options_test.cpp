// The Type 347 subroutine option and the Type 342 character generator.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "emulators/type340/display.hpp"

namespace sightline::type340 {
namespace {

using core::at_nanoseconds;
using core::Word18;

struct LitPoints final : core::StrokeTaker {
  std::set<std::pair<int, int>> points;
  void strokes(std::span<const core::Stroke> strokes) override {
    for (const core::Stroke& s : strokes) points.insert({s.x, s.y});
  }
};

// A memory whose breaks take no time; `log` records every break as address and time in octal and ns.
class DisplayOptions : public ::testing::Test {
 protected:
  void put(std::uint32_t address, const std::vector<std::uint32_t>& words) {
    for (const std::uint32_t word : words) memory_[address++] = Word18(word);
  }

  void run(std::uint32_t start, std::int64_t until = 2'000'000) {
    display_.load_address_and_start(at_nanoseconds(0), Word18(start));
    for (;;) {
      const core::DataBreak* request = display_.data_break();
      if (request == nullptr) {
        const core::Instant next = display_.deadline();
        if (next > at_nanoseconds(until)) return strokes_.flush();
        display_.advance(next);
        continue;
      }
      const core::Instant at = display_.requested_at();
      log_.push_back({request->address, core::nanoseconds_of(at)});
      if (request->direction == core::DataBreak::Direction::to_core) memory_[request->address] = request->word;
      display_.end_break(at, memory_[request->address]);
    }
  }

  std::array<Word18, 8192> memory_{};
  DisplayOptions() { strokes_.hand_to(&flashes_); }

  LitPoints flashes_;
  core::StrokeBuffer strokes_;
  Display display_{{.subroutines_347 = true, .characters_342 = true}, strokes_};
  std::vector<std::pair<int, std::int64_t>> log_;
};

using Log = std::vector<std::pair<int, std::int64_t>>;

// To 5312, where an escaping vector of seven pulses returns to the word after the call; a jump takes 3.3 us.
TEST_F(DisplayOptions, JumpAndSaveReturnsOnEscape) {
  put(0, {0160117, 0705312, 0003000});
  put(05312, {0600003});
  run(0);
  EXPECT_EQ(log_, (Log{{0, 0}, {1, 3300}, {05312, 6600}, {2, 20'400}}));
  EXPECT_TRUE(display_.stop_interrupt(at_nanoseconds(2'000'000)));
  EXPECT_EQ(display_.return_address(at_nanoseconds(2'000'000)), Word18(2));
  EXPECT_FALSE(display_.registers().save);
}

TEST_F(DisplayOptions, JumpContinuesInTheModeItNames) {
  put(0, {0160000, 0420100});  // DJP 100, mode point
  put(0100, {0000321, 0003000});
  run(0);
  EXPECT_EQ(log_, (Log{{0, 0}, {1, 3300}, {0100, 6600}, {0101, 45'400}}));
  EXPECT_EQ(display_.registers().x, 0321);
}

// The subroutine stores its return jump at its own end: DDS writes DJP to the saved address. The escape before it does not
// return,
// because DDS has cleared SAVE.
TEST_F(DisplayOptions, DepositStoresTheReturnJump) {
  put(0, {0160117, 0760200, 0003000});      // DJS 200, mode 7
  put(0200, {0300210, 0600003, 0160000});   // DDS 210, mode 4; a vector that escapes; to mode 7
  put(0203, {0560210});                     // DJP 210, mode 7
  run(0);
  EXPECT_EQ(memory_[0210], Word18(0400002));
  EXPECT_EQ(log_, (Log{{0, 0}, {1, 3300}, {0200, 6600}, {0210, 9900}, {0201, 9900}, {0202, 23'700}, {0203, 27'000},
                       {0210, 30'300}, {2, 33'600}}));
  EXPECT_TRUE(display_.stop_interrupt(at_nanoseconds(2'000'000)));
}

// IDRS during the deflection of a lit Y point that names mode 7 executes its word again as DDS 2100. The point's own request, at
// 42.1 us, then replaces the write.
TEST_F(DisplayOptions, ARequestReplacesADeposit) {
  using Direction = core::DataBreak::Direction;
  for (const std::int64_t served : {42'500, 50'000}) {
    Display display({.subroutines_347 = true}, strokes_);
    display.load_address_and_start(at_nanoseconds(0), Word18(0));
    display.end_break(at_nanoseconds(0), Word18(0020000));
    display.advance(at_nanoseconds(3300));
    display.end_break(at_nanoseconds(3300), Word18(0362100));
    display.resume(at_nanoseconds(10'000));
    display.advance(at_nanoseconds(11'500));
    ASSERT_NE(display.data_break(), nullptr);
    EXPECT_EQ(display.data_break()->direction, Direction::to_core);
    EXPECT_EQ(display.data_break()->address, 02100);
    // A break that begins before the request writes, and the next one takes the display word. A break that begins later belongs
    // to
    // the request.
    const bool writes = served < 45'000;
    if (!writes) display.advance(at_nanoseconds(42'100));
    display.end_break(at_nanoseconds(served), Word18(0003000));
    EXPECT_EQ(display.counters().words, writes ? 2U : 3U);
    EXPECT_EQ(display.data_break() != nullptr, writes);
    if (!writes) continue;
    EXPECT_EQ(display.data_break()->direction, Direction::from_core);
    EXPECT_EQ(display.data_break()->address, 2);
    EXPECT_EQ(display.requested_at(), at_nanoseconds(42'100));
  }
}

TEST_F(DisplayOptions, EdgeEscapesFromASubroutineToo) {
  put(0, {0160117, 0720100, 0003000});  // DJS 100, mode vector continue
  put(0100, {0000377});                 // left from x = 0
  run(0);
  EXPECT_EQ(log_, (Log{{0, 0}, {1, 3300}, {0100, 6600}, {2, 6600 + 4300}}));
}

// A start cancels a pending return.
TEST_F(DisplayOptions, StartClearsSave) {
  put(0, {0160117, 0740100});
  run(0, 7000);
  display_.load_address_and_start(at_nanoseconds(8000), Word18(0300));
  ASSERT_NE(display_.data_break(), nullptr);
  EXPECT_EQ(display_.data_break()->address, 0300);
}

// A space is six dark steps: 0.5 + 9 us; three of them 2.8 + 28.5.
TEST_F(DisplayOptions, SpacesMoveDark) {
  put(0, {0060137, 0404040, 0373737, 0003000});
  run(0);
  EXPECT_EQ(log_, (Log{{0, 0}, {1, 3300}, {2, 34'600}, {3, 37'900}}));
  EXPECT_EQ(display_.registers().x, 36);  // scale 1 (x2)
  EXPECT_EQ(display_.registers().y, 0);
  EXPECT_TRUE(flashes_.points.empty());
}

// I is a stem between two bars; the beam ends at the start of the next character on the base line.
TEST_F(DisplayOptions, LettersAreDrawnInTheirCell) {
  put(0, {0060117, 0113700, 0003000});
  run(0);
  const std::set<std::pair<int, int>> expected{{1, 0}, {2, 0}, {3, 0}, {2, 1}, {2, 2}, {2, 3},
                                               {2, 4}, {2, 5}, {1, 6}, {2, 6}, {3, 6}};
  EXPECT_EQ(flashes_.points, expected);
  EXPECT_EQ(display_.registers().x, 6);
  EXPECT_EQ(display_.registers().y, 0);
  EXPECT_EQ(display_.registers().mode, Mode::parameter);
}

// Line feed moves down eleven, carriage return clears X, shift-out selects the second set until shift-in.
TEST_F(DisplayOptions, ControlCodes) {
  put(0, {0020117, 0220144, 060144, 0404033, 0343637, 0003000});
  run(0);
  EXPECT_EQ(display_.registers().x, 0);
  EXPECT_EQ(display_.registers().y, 100 - 11);
  EXPECT_TRUE(display_.registers().shift_out);
  display_.load_address_and_start(at_nanoseconds(2'000'000), Word18(5));
  EXPECT_FALSE(display_.registers().shift_out);
}

// The flag rises when a character crosses the edge. The character is drawn to its end, and the next request clears the flag.
TEST_F(DisplayOptions, CharactersOverAnEdgeWrap) {
  put(0, {0020117, 0061777, 0404040, 0373737, 0003000});
  run(0);
  EXPECT_EQ(display_.registers().x, 17);
  EXPECT_TRUE(display_.stop_interrupt(at_nanoseconds(2'000'000)));
  EXPECT_FALSE(display_.horizontal_edge(at_nanoseconds(2'000'000)));
}

TEST(CharacterPaths, LightEveryDotOnceAndEndOnTheBaseLine) {
  for (unsigned set = 0; set < 2; ++set) {
    for (std::uint8_t c = 1; c < 0100; ++c) {
      if (c >= code::line_feed && c <= code::escape) continue;
      const CharacterPath path = path_of(c, set == 1);
      std::set<std::pair<int, int>> lit;
      int x = 0;
      int y = 0;
      for (std::size_t i = 0; i < path.size(); ++i) {
        x += path[i].direction.x;
        y += path[i].direction.y;
        EXPECT_TRUE(!path[i].lit || lit.insert({x, y}).second) << unsigned{c};
        EXPECT_TRUE(!path[i].lit || (x >= 0 && x < 5 && y >= 0 && y < 7)) << unsigned{c};
      }
      EXPECT_EQ(std::pair(x, y), std::pair(6, 0)) << unsigned{c};
      EXPECT_EQ(lit.empty(), c == code::space) << unsigned{c};
      EXPECT_LE(path.size(), 40U) << unsigned{c};
    }
  }
  EXPECT_EQ(path_of(code::line_feed, false).size(), 11U);
  for (const std::uint8_t c : {code::carriage_return, code::shift_in, code::shift_out, code::escape}) {
    EXPECT_EQ(path_of(c, false).size(), 0U);
  }
}

}  // namespace
}  // namespace sightline::type340
