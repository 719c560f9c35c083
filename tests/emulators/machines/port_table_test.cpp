// A table of two devices of this test: which ports reach them, what an absent one leaves, what they may do by
// themselves, and the order of their reports.
#include "emulators/machines/port_table.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace sightline;
using core::at_t_state;
using core::never_t;
using machines::InterruptLine;
using machines::PortRange;
using machines::Restart;

struct NoSink {};

// A byte that can be written and read.
struct Latch {
  std::uint8_t value = 0;
  int written = 0;
};

struct LatchRow {
  struct Configuration {
    bool latch = false;
    std::uint8_t latch_value = 0;
  };
  template <class>
  using Device = Latch;
  static constexpr std::string_view name = "latch";
  static constexpr std::array reads{PortRange{0x10, 0x11}};
  static constexpr std::array writes{PortRange{0x10, 0x10}};
  static constexpr std::array<InterruptLine<Configuration>, 0> lines{};
  static void make(std::optional<Latch>& latch, const Configuration& wanted, core::ClockRate, NoSink&) {
    if (wanted.latch) latch.emplace().value = wanted.latch_value;
  }
  static std::uint8_t read(Latch& latch, std::uint8_t port, core::TStateInstant) {
    return port == 0x10 ? latch.value : static_cast<std::uint8_t>(~latch.value);
  }
  static void write(Latch& latch, std::uint8_t, std::uint8_t value, core::TStateInstant) {
    latch.value = value;
    ++latch.written;
  }
  template <class Take>
  static void count(const Latch& latch, Take take) {
    take("written", static_cast<std::uint64_t>(latch.written));
  }
};

// Counts down in T-states from a write and then asks for an interrupt, on one line until it is read, on the
// other until it is written.
struct Timer {
  core::TStateInstant due = never_t;
  bool rung = false;
  bool unread = false;
  void advance(core::TStateInstant now) {
    if (due > now) return;
    due = never_t;
    rung = unread = true;
  }
  [[nodiscard]] core::TStateInstant deadline() const { return due; }
};

struct TimerRow {
  struct Configuration {
    bool timer = false;
    Restart timer_rung;
    Restart timer_unread;
  };
  template <class>
  using Device = Timer;
  static constexpr std::string_view name = "timer";
  static constexpr std::array reads{PortRange{0x20, 0x20}, PortRange{0xFF, 0xFF}};
  static constexpr std::array writes{PortRange{0x20, 0x20}};
  static constexpr std::array lines{InterruptLine<Configuration>{"rung", &Configuration::timer_rung},
                                    InterruptLine<Configuration>{"unread", &Configuration::timer_unread}};
  static void make(std::optional<Timer>& timer, const Configuration& wanted, core::ClockRate, NoSink&) {
    if (wanted.timer) timer.emplace();
  }
  static std::uint8_t read(Timer& timer, std::uint8_t port, core::TStateInstant at) {
    timer.advance(at);
    timer.unread = false;
    return port;
  }
  static void write(Timer& timer, std::uint8_t, std::uint8_t value, core::TStateInstant at) {
    timer.rung = false;
    timer.due = at + core::TStates(value);
  }
  static bool requests(const Timer& timer, std::size_t line) { return line == 0 ? timer.rung : timer.unread; }
  template <class Take>
  static void count(const Timer& timer, Take take) {
    take("rung", timer.rung ? 1U : 0U);
  }
};

using Rows = machines::PortRows<LatchRow, TimerRow>;
using Ports = machines::PortTable<NoSink, Rows>;

Rows::Configuration both() {
  Rows::Configuration configuration;
  configuration.latch = configuration.timer = true;
  return configuration;
}

TEST(PortTable, APortReachesTheDeviceOfItsRow) {
  NoSink sink;
  Ports ports(both(), sink);
  ports.out(0x10, 0x5A, at_t_state(10));
  EXPECT_EQ(ports.in(0x10, at_t_state(20)), 0x5A);
  EXPECT_EQ(ports.in(0x11, at_t_state(30)), 0xA5);
  EXPECT_EQ(ports.in(0x20, at_t_state(40)), 0x20);
  EXPECT_EQ(ports.in(0xFF, at_t_state(50)), 0xFF);
  ports.out(0x20, 7, at_t_state(60));
  EXPECT_EQ(ports.device<TimerRow>()->due, at_t_state(67));
  for (const auto& entry : ports.unanswered()) EXPECT_EQ(entry.reads + entry.writes, 0U);
}

TEST(PortTable, DirectionsAreApart) {
  NoSink sink;
  Ports ports(both(), sink);
  ports.out(0x11, 1, at_t_state(10));
  ports.out(0xFF, 1, at_t_state(20));
  EXPECT_EQ(ports.device<LatchRow>()->written, 0);
  EXPECT_EQ(ports.unanswered()[0x11].writes, 1U);
  EXPECT_EQ(ports.unanswered()[0xFF].writes, 1U);
  EXPECT_EQ(ports.unanswered()[0x11].reads, 0U);
}

TEST(PortTable, AnAbsentDeviceLeavesItsPortsUnanswered) {
  NoSink sink;
  Rows::Configuration configuration;
  configuration.timer = true;
  configuration.timer_rung = 3;
  Ports ports(configuration, sink);
  EXPECT_EQ(ports.device<LatchRow>(), nullptr);
  EXPECT_EQ(ports.in(0x10, at_t_state(10)), 0xFF);
  ports.out(0x10, 1, at_t_state(20));
  EXPECT_EQ(ports.unanswered()[0x10].reads, 1U);
  EXPECT_EQ(ports.unanswered()[0x10].writes, 1U);
  EXPECT_EQ(ports.in(0x20, at_t_state(30)), 0x20);
}

TEST(PortTable, LinesRequestTheRestartsTheyAreWiredTo) {
  NoSink sink;
  Rows::Configuration configuration = both();
  configuration.timer_rung = 2;
  configuration.timer_unread = 5;
  Ports ports(configuration, sink);
  ports.out(0x20, 100, at_t_state(10));
  EXPECT_EQ(ports.deadline(), at_t_state(110));
  ports.advance(at_t_state(109));
  EXPECT_FALSE(ports.interrupt());
  ports.advance(at_t_state(110));
  EXPECT_TRUE(ports.interrupt());
  EXPECT_EQ(ports.deadline(), never_t);
  EXPECT_EQ(ports.acknowledge(at_t_state(111)), 0xC7 | 5 << 3);
  EXPECT_EQ(ports.in(0x20, at_t_state(120)), 0x20);
  EXPECT_EQ(ports.acknowledge(at_t_state(121)), 0xC7 | 2 << 3);
  ports.out(0x20, 100, at_t_state(130));
  EXPECT_FALSE(ports.interrupt());
  EXPECT_EQ(ports.acknowledge(at_t_state(131)), 0xFF);
}

TEST(PortTable, DevicesWithoutAConnectedLineAreNeverLookedAt) {
  NoSink sink;
  Ports ports(both(), sink);
  ports.out(0x20, 1, at_t_state(10));
  EXPECT_EQ(ports.deadline(), never_t);
  ports.advance(at_t_state(100));
  EXPECT_FALSE(ports.interrupt());
}

TEST(PortTable, DevicesAreVisitedInTheOrderOfTheTable) {
  NoSink sink;
  Ports ports(both(), sink);
  ports.out(0x10, 1, at_t_state(10));
  std::vector<std::string> counts;
  ports.each_device([&counts](auto row, const auto& device) {
    row.count(device, [&counts, row](std::string_view name, std::uint64_t n) {
      counts.push_back(std::string(row.name) + " " + std::string(name) + " " + std::to_string(n));
    });
  });
  EXPECT_EQ(counts, (std::vector<std::string>{"latch written 1", "timer rung 0"}));
}

TEST(PortTable, TwoDevicesOnOnePortAreFoundByTheCompiler) {
  static_assert(Rows::disjoint());
  static_assert(!machines::PortRows<LatchRow, TimerRow, LatchRow>::disjoint());
}

}  // namespace
