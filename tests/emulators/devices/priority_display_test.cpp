// The Sussex display: the priority rule at every point compared with a simple search; exchange of lists, the scan in time,
// and overflow.
#include "emulators/devices/priority_display.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using sightline::core::at_nanoseconds;
using sightline::core::Instant;
using sightline::devices::PriorityDisplay;
using Register = PriorityDisplay::Register;

constexpr std::int64_t line = 64'000;
constexpr std::int64_t frame = 40'000'000;

std::uint32_t span(std::uint32_t from, std::uint32_t to) {
  return to << 16 | from;
}

struct Host {
  PriorityDisplay& display;
  Instant at;

  void surface(std::uint32_t priority, std::uint32_t colour, std::uint32_t first, std::uint32_t count,
               std::uint32_t columns) const {
    display.write(Register::priority, priority, at);
    display.write(Register::colour, colour, at);
    display.write(Register::line, first, at);
    for (std::uint32_t i = 0; i < count; ++i) display.write(Register::span, columns, at);
  }
  void show() const { display.write(Register::control, PriorityDisplay::show, at); }
};

std::uint32_t point(const PriorityDisplay& display, std::size_t column, std::size_t row) {
  return display.picture()[row * 512 + column];
}

TEST(PriorityDisplay, TheHighestPriorityWinsWhateverTheOrder) {
  for (const bool reversed : {false, true}) {
    PriorityDisplay display;
    const Host host{display, at_nanoseconds(0)};
    const std::array<std::uint32_t, 2> priorities{5, 9};
    for (const std::uint32_t i : reversed ? std::array{1U, 0U} : std::array{0U, 1U})
      host.surface(priorities[i], 0x110000U << i, 10 + i, 4, span(100 + 10 * i, 120 + 10 * i));
    host.show();
    display.advance(at_nanoseconds(2 * frame - 1));
    EXPECT_EQ(point(display, 100, 10), 0x110000U);
    EXPECT_EQ(point(display, 119, 10), 0x110000U);  // the other one begins a line lower
    EXPECT_EQ(point(display, 119, 11), 0x220000U);
    EXPECT_EQ(point(display, 109, 11), 0x110000U);
    EXPECT_EQ(point(display, 129, 11), 0x220000U);
    EXPECT_EQ(point(display, 130, 11), 0U);
    EXPECT_EQ(point(display, 119, 14), 0x220000U);
    EXPECT_EQ(point(display, 119, 15), 0U);
  }
}

TEST(PriorityDisplay, OfEqualPrioritiesTheFirstBegunIsShown) {
  PriorityDisplay display;
  const Host host{display, at_nanoseconds(0)};
  host.surface(7, 1, 5, 1, span(0, 2));
  host.surface(7, 2, 4, 2, span(0, 2));  // begins higher up, but was written later
  host.surface(0xFFFF'FFFF, 3, 5, 1, span(1, 2));
  host.show();
  display.advance(at_nanoseconds(2 * frame - 1));
  EXPECT_EQ(point(display, 0, 4), 2U);
  EXPECT_EQ(point(display, 0, 5), 1U);
  EXPECT_EQ(point(display, 1, 5), 3U);
}

TEST(PriorityDisplay, RandomSurfacesMatchASearch) {
  std::mt19937 random(5);
  PriorityDisplay display;
  struct Surface {
    std::uint32_t priority, colour, first;
    std::vector<std::array<std::uint32_t, 2>> spans;
  };
  std::vector<Surface> surfaces;
  for (std::uint32_t i = 0; i < 150; ++i) {
    Surface s{static_cast<std::uint32_t>(random() % 40), i + 1, static_cast<std::uint32_t>(random() % 512), {}};
    const auto count = std::min(static_cast<std::uint32_t>(random() % 200), 512 - s.first);
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto from = static_cast<std::uint32_t>(random() % 513);
      s.spans.push_back({from, std::min<std::uint32_t>(512, from + static_cast<std::uint32_t>(random() % 60))});
    }
    display.write(Register::priority, s.priority, {});
    display.write(Register::colour, s.colour, {});
    display.write(Register::line, s.first, {});
    for (const auto& [from, to] : s.spans) display.write(Register::span, span(from, to), {});
    surfaces.push_back(std::move(s));
  }
  display.write(Register::control, PriorityDisplay::show, {});
  display.advance(at_nanoseconds(2 * frame - 1));
  for (std::uint32_t row = 0; row < 512; ++row) {
    for (std::uint32_t column = 0; column < 512; ++column) {
      const Surface* best = nullptr;
      for (const Surface& s : surfaces) {
        if (row < s.first || row - s.first >= s.spans.size()) continue;
        const auto& [from, to] = s.spans[row - s.first];
        if (column >= from && column < to && (best == nullptr || s.priority > best->priority)) best = &s;
      }
      ASSERT_EQ(point(display, column, row), best != nullptr ? best->colour : 0U) << column << ' ' << row;
    }
  }
}

TEST(PriorityDisplay, ListsAreExchangedAtTheBeginningOfAFrame) {
  PriorityDisplay display;
  Host host{display, at_nanoseconds(3 * line)};
  host.surface(1, 0xABCDEF, 0, 512, span(0, 512));
  host.show();
  EXPECT_EQ(display.read(Register::status, at_nanoseconds(frame - 1)),
            PriorityDisplay::status_blanking | PriorityDisplay::status_waiting);
  host.at = at_nanoseconds(frame - 1);
  host.surface(9, 0x123456, 0, 1, span(0, 1));  // all lost: the list is waiting
  EXPECT_EQ(display.counts().writes_lost, 4U);
  EXPECT_EQ(point(display, 0, 0), 0U);
  EXPECT_EQ(display.read(Register::status, at_nanoseconds(frame)), 0U);
  EXPECT_EQ(point(display, 0, 0), 0xABCDEFU);
  EXPECT_EQ(point(display, 0, 1), 0U);  // not displayed yet
  EXPECT_EQ(display.read(Register::line, at_nanoseconds(frame + line - 1)), 0U);
  EXPECT_EQ(display.read(Register::line, at_nanoseconds(frame + line)), 1U);
  EXPECT_EQ(point(display, 511, 1), 0xABCDEFU);
  // The displayed list stays until there is another; a new one begins empty.
  display.advance(at_nanoseconds(5 * frame));
  EXPECT_EQ(point(display, 511, 511), 0xABCDEFU);
  host.at = at_nanoseconds(5 * frame);
  host.show();
  display.advance(at_nanoseconds(7 * frame - 1));
  EXPECT_EQ(point(display, 511, 511), 0U);
  EXPECT_EQ(display.counts().exchanges, 2U);
  EXPECT_EQ(display.counts().frames, 7U);
}

TEST(PriorityDisplay, BlankingBeginsAfter512Lines) {
  PriorityDisplay display;
  EXPECT_EQ(display.read(Register::status, at_nanoseconds(512 * line - 1)), 0U);
  EXPECT_EQ(display.read(Register::status, at_nanoseconds(512 * line)), PriorityDisplay::status_blanking);
  EXPECT_EQ(display.read(Register::line, at_nanoseconds(frame - 1)), 624U);
}

TEST(PriorityDisplay, OverflowIsOmittedAndCounted) {
  PriorityDisplay display(2, 3);
  const Host host{display, at_nanoseconds(0)};
  display.write(Register::span, span(0, 5), {});  // belongs to no surface
  display.write(7, 1, {});
  EXPECT_EQ(display.counts().unanswered, 2U);
  display.write(Register::line, 512, {});
  display.write(Register::span, span(0, 5), {});
  EXPECT_EQ(display.counts().writes_off_screen, 1U);
  EXPECT_EQ(display.counts().unanswered, 3U);
  host.surface(1, 1, 511, 2, span(0, 5));    // the second line does not exist
  host.surface(2, 2, 0, 1, span(0, 513));    // nor does the column
  EXPECT_EQ(display.counts().writes_off_screen, 3U);
  EXPECT_EQ(display.read(Register::status, {}), PriorityDisplay::status_full);
  host.surface(3, 3, 0, 0, 0);
  EXPECT_EQ(display.counts().writes_no_room, 1U);
  host.show();
  display.advance(at_nanoseconds(2 * frame - 1));
  EXPECT_EQ(point(display, 4, 511), 1U);
  EXPECT_EQ(point(display, 0, 0), 0U);
}

TEST(PriorityDisplay, EmptyingTheListBeginsAnew) {
  PriorityDisplay display;
  const Host host{display, at_nanoseconds(0)};
  host.surface(1, 1, 0, 1, span(0, 512));
  display.write(Register::control, PriorityDisplay::empty | PriorityDisplay::show, {});
  display.advance(at_nanoseconds(2 * frame - 1));
  EXPECT_EQ(point(display, 0, 0), 0U);
  EXPECT_EQ(display.counts().exchanges, 1U);
}

}  // namespace
