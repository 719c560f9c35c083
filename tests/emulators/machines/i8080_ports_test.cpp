// This test's own devices on the ports of an 8080: the ports that reach them, the effect of an absent one, their requests, their
// priority, and the errors of attach() and wire().
#include "emulators/machines/i8080_ports.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/machines/i8080.hpp"
#include "emulators/machines/i8080_devices.hpp"

namespace {

using namespace sightline;
using core::at_t_state;
using core::never_t;
using core::PortDeviceInfo;
using core::PortRange;
using core::TStateInstant;

// One byte, readable and writable.
struct Latch : core::PortDevice {
  static constexpr std::array reads{PortRange{0x10, 0x11}};
  static constexpr std::array writes{PortRange{0x10, 0x10}};
  static constexpr PortDeviceInfo info{.name = "latch", .help = "", .choice = "", .reads = reads, .writes = writes};

  std::uint8_t value = 0;
  int written = 0;

  std::uint8_t in(std::uint8_t port, TStateInstant) override { return port == 0x10 ? value : static_cast<std::uint8_t>(~value); }
  void out(std::uint8_t, std::uint8_t byte, TStateInstant) override {
    value = byte;
    ++written;
  }
  std::vector<core::Count> counts() const override { return {{"written", static_cast<std::uint64_t>(written)}}; }
};

// Counts down in T-states from a write and then requests an interrupt, on one line until it is read, on the other until it is
// written.
struct Timer : core::PortDevice {
  static constexpr std::array reads{PortRange{0x20, 0x20}, PortRange{0xFF, 0xFF}};
  static constexpr std::array writes{PortRange{0x20, 0x20}};
  static constexpr std::array<std::string_view, 2> lines{"rung", "unread"};
  static constexpr PortDeviceInfo info{
      .name = "timer", .help = "", .choice = "", .reads = reads, .writes = writes, .lines = lines};

  TStateInstant due = never_t;
  bool rung = false;
  bool unread = false;
  int asked = 0;  // calls for lines and deadline

  void advance(TStateInstant now) override {
    if (due > now) return;
    due = never_t;
    rung = unread = true;
  }
  TStateInstant deadline() const override { return due; }
  std::uint8_t in(std::uint8_t port, TStateInstant at) override {
    advance(at);
    unread = false;
    return port;
  }
  void out(std::uint8_t, std::uint8_t value, TStateInstant at) override {
    rung = false;
    due = at + core::TStates(value);
  }
  unsigned requests() const override { return (rung ? 1U : 0U) | (unread ? 2U : 0U); }
  std::vector<core::Count> counts() const override { return {{"rung", rung ? 1U : 0U}}; }
};

struct Both {
  i8080::Ports ports{false};
  Latch* latch = nullptr;
  Timer* timer = nullptr;

  Both() {
    auto new_latch = std::make_unique<Latch>();
    auto new_timer = std::make_unique<Timer>();
    latch = new_latch.get();
    timer = new_timer.get();
    EXPECT_EQ(ports.attach(Latch::info, std::move(new_latch)), "");
    EXPECT_EQ(ports.attach(Timer::info, std::move(new_timer)), "");
  }
};

TEST(I8080Ports, APortReachesTheDeviceThatHasIt) {
  Both both;
  i8080::Ports& ports = both.ports;
  ports.out(0x10, 0x5A, at_t_state(10));
  EXPECT_EQ(ports.in(0x10, at_t_state(20)), 0x5A);
  EXPECT_EQ(ports.in(0x11, at_t_state(30)), 0xA5);
  EXPECT_EQ(ports.in(0x20, at_t_state(40)), 0x20);
  EXPECT_EQ(ports.in(0xFF, at_t_state(50)), 0xFF);
  ports.out(0x20, 7, at_t_state(60));
  EXPECT_EQ(both.timer->due, at_t_state(67));
  for (const auto& entry : ports.unanswered()) EXPECT_EQ(entry.reads + entry.writes, 0U);
}

TEST(I8080Ports, DirectionsAreSeparate) {
  Both both;
  both.ports.out(0x11, 1, at_t_state(10));
  both.ports.out(0xFF, 1, at_t_state(20));
  EXPECT_EQ(both.latch->written, 0);
  EXPECT_EQ(both.ports.unanswered()[0x11].writes, 1U);
  EXPECT_EQ(both.ports.unanswered()[0xFF].writes, 1U);
  EXPECT_EQ(both.ports.unanswered()[0x11].reads, 0U);
}

TEST(I8080Ports, AnAbsentDeviceLeavesItsPortsUnanswered) {
  i8080::Ports ports(false);
  ASSERT_EQ(ports.attach(Timer::info, std::make_unique<Timer>()), "");
  ASSERT_EQ(ports.wire("rung", 3), "");
  EXPECT_EQ(ports.device("latch"), nullptr);
  EXPECT_EQ(ports.in(0x10, at_t_state(10)), 0xFF);
  ports.out(0x10, 1, at_t_state(20));
  EXPECT_EQ(ports.unanswered()[0x10].reads, 1U);
  EXPECT_EQ(ports.unanswered()[0x10].writes, 1U);
  EXPECT_EQ(ports.in(0x20, at_t_state(30)), 0x20);
  EXPECT_FALSE(ports.stops());
}

TEST(I8080Ports, LinesRequestTheRestartsTheyAreWiredTo) {
  Both both;
  i8080::Ports& ports = both.ports;
  ASSERT_EQ(ports.wire("rung", 2), "");
  ASSERT_EQ(ports.wire("unread", 5), "");
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

TEST(I8080Ports, ALineMayBeRewired) {
  Both both;
  ASSERT_EQ(both.ports.wire("rung", 2), "");
  ASSERT_EQ(both.ports.wire("rung", 0), "");
  both.ports.out(0x20, 100, at_t_state(10));
  both.ports.advance(at_t_state(110));
  EXPECT_EQ(both.ports.acknowledge(at_t_state(111)), 0xC7);
}

TEST(I8080Ports, DevicesWithoutAConnectedLineAreNeverPolled) {
  Both both;
  both.ports.out(0x20, 1, at_t_state(10));
  EXPECT_EQ(both.ports.deadline(), never_t);
  both.ports.advance(at_t_state(100));
  EXPECT_FALSE(both.ports.interrupt());
  EXPECT_FALSE(both.timer->rung);
  both.ports.advance_all(at_t_state(100));
  EXPECT_TRUE(both.timer->rung);
  EXPECT_FALSE(both.ports.interrupt());
}

TEST(I8080Ports, ListedDevicesComeFirst) {
  i8080::Machine machine;
  ASSERT_EQ(machine.attach(Latch::info, std::make_unique<Latch>()), "");
  ASSERT_EQ(machine.attach(Timer::info, std::make_unique<Timer>()), "");
  ASSERT_EQ(machine.attach("sio"), "");
  ASSERT_EQ(machine.attach("ef9365"), "");
  machine.forward_out(0x10, 1, at_t_state(10));
  std::vector<std::string> names;
  for (const auto& [info, device] : machine.devices()) names.emplace_back(info->name);
  EXPECT_EQ(names, (std::vector<std::string>{"ef9365", "sio", "latch", "timer"}));
  const std::vector<core::Count> counts = machine.device("latch")->counts();
  ASSERT_EQ(counts.size(), 1U);
  EXPECT_EQ(counts[0].name, "written");
  EXPECT_EQ(counts[0].value, 1U);
}

TEST(I8080Ports, TwoDevicesOnOnePortAreAnErrorWithBothNames) {
  // Write-only and read-only devices on ports that others use in both directions.
  static constexpr std::array writes{PortRange{0x0F, 0x12}};
  static constexpr PortDeviceInfo writer{.name = "writer", .help = "", .choice = "", .writes = writes};
  static constexpr std::array reads{PortRange{0xFF, 0xFF}};
  static constexpr PortDeviceInfo reader{.name = "reader", .help = "", .choice = "", .reads = reads};
  Both both;
  EXPECT_EQ(both.ports.attach(writer, std::make_unique<Latch>()), "port 10 is written by \"latch\" and by \"writer\"");
  EXPECT_EQ(both.ports.attach(reader, std::make_unique<Latch>()), "port FF is read by \"timer\" and by \"reader\"");
  EXPECT_EQ(both.ports.devices().size(), 2U);
  both.ports.out(0x0F, 1, at_t_state(10));
  EXPECT_EQ(both.ports.unanswered()[0x0F].writes, 1U) << "a rejected device has no ports";
  i8080::Machine machine;
  ASSERT_EQ(machine.attach("2sio"), "");
  EXPECT_EQ(machine.attach(Latch::info, std::make_unique<Latch>()), "port 10 is read by \"2sio\" and by \"latch\"");
  EXPECT_EQ(machine.attach("2sio"), "\"2sio\" is already attached");
}

TEST(I8080Ports, KnownDevicesDoNotDisturbEachOther) {
  i8080::Machine machine;
  for (const i8080::KnownDevice& known : i8080::known_devices) EXPECT_EQ(machine.attach(known.info->name), "");
  std::size_t place = 0;
  for (const auto& [info, device] : machine.devices()) EXPECT_EQ(info, i8080::known_devices[place++].info);
  EXPECT_EQ(place, i8080::known_devices.size());
}

TEST(I8080Ports, AnUnknownNameIsAnErrorWithTheNearestName) {
  i8080::Machine machine;
  const std::string ef9356 = machine.attach("ef9356");
  EXPECT_EQ(ef9356.find("found device \"ef9356\", expected one of: ef9365, alt256, "), 0U) << ef9356;
  EXPECT_TRUE(ef9356.ends_with("; did you mean \"ef9365\"?")) << ef9356;
  const std::array<core::Setting, 1> bauds{{{"bauds", 300}}};
  EXPECT_EQ(machine.attach("sio", bauds), "found option of the sio \"bauds\", expected one of: baud, terminal, tape; did you mean \"baud\"?");
  const std::array<core::Setting, 1> baud{{{"baud", 5}}};
  EXPECT_EQ(machine.attach("sio", baud), "found 5 for the option baud of the sio, expected 50 to 1000000");
  EXPECT_EQ(machine.attach("ef9365", baud), "found option of the ef9365 \"baud\", expected none");
  EXPECT_TRUE(machine.devices().empty());
  EXPECT_EQ(machine.wire("calcomp", 7), "interrupt line \"calcomp\": \"calcomp565\" is not attached");
  ASSERT_EQ(machine.attach("calcomp565"), "");
  ASSERT_EQ(machine.attach("serial"), "");
  EXPECT_EQ(machine.wire("calcomp", 8), "interrupt line \"calcomp\": found RST 8, expected 0 to 7");
  EXPECT_EQ(machine.wire("serial_receive", 7),
            "found interrupt line \"serial_receive\", expected one of: calcomp, serial-receive, serial-transmit; did you mean \"serial-receive\"?");
}

// OUT 10, OUT 30, HLT
constexpr std::array<std::uint8_t, 5> two_outs{0xD3, 0x10, 0xD3, 0x30, 0x76};

TEST(I8080Ports, AStrictMachineEndsARunAtAnUnansweredAccess) {
  i8080::Machine machine({.clock = {}, .strict = true});
  ASSERT_EQ(machine.attach(Latch::info, std::make_unique<Latch>()), "");
  machine.load(0, two_outs);
  EXPECT_EQ(machine.run(), i8080::StopReason::unanswered);
  EXPECT_EQ(machine.registers().pc, 4);
  EXPECT_EQ(machine.unanswered()[0x30].writes, 1U);
  EXPECT_EQ(machine.run(), i8080::StopReason::halt);
}

// Records each access, and passes it on complemented.
struct Front : core::PortDevice {
  explicit Front(i8080::Machine& of) : machine(of) {}
  i8080::Machine& machine;
  std::vector<std::int64_t> times;

  std::uint8_t in(std::uint8_t port, TStateInstant at) override {
    times.push_back(core::t_states_of(at));
    return machine.forward_in(port, at);
  }
  void out(std::uint8_t port, std::uint8_t value, TStateInstant at) override {
    times.push_back(core::t_states_of(at));
    machine.forward_out(port, static_cast<std::uint8_t>(~value), at);
  }
};

TEST(I8080Ports, AFrontInterceptsADevice) {
  i8080::Machine machine;
  ASSERT_EQ(machine.attach(Latch::info, std::make_unique<Latch>()), "");
  Front front(machine);
  machine.put_before({0x10, 0x30}, front);
  machine.load(0, two_outs);
  EXPECT_EQ(machine.run(), i8080::StopReason::halt);
  EXPECT_EQ(front.times, (std::vector<std::int64_t>{9, 19}));
  EXPECT_EQ(machine.find<Latch>()->value, 0xFF);
  EXPECT_EQ(machine.unanswered()[0x30].writes, 1U);
}

TEST(I8080Ports, AStopRequestedBetweenTwoRunsEndsTheNext) {
  i8080::Machine machine;
  machine.request_stop();
  EXPECT_EQ(machine.run({.instructions = 3}), i8080::StopReason::device);
  EXPECT_EQ(machine.instructions(), 0U);
  EXPECT_EQ(machine.run({.instructions = 3}), i8080::StopReason::instruction_limit);
}

}  // namespace
