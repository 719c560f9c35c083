// All devices on an 8080: their ports, absent devices, and the priority of interrupts.
#include "emulators/machines/i8080_devices.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <random>
#include <span>

#include "emulators/machines/i8080.hpp"
#include "emulators/machines/i8080_ports.hpp"
#include "tests/emulators/devices/device_test.hpp"

namespace {

using namespace sightline;
using core::at_t_state;
using core::never_t;

constexpr std::array<std::uint8_t, 2> host_bytes{0x12, 0x34};

// All devices except those that need a host.
struct Board {
  explicit Board(core::StrokeTaker& sink) { strokes.hand_to(&sink); }
  void attach_all() {
    static constexpr std::array<core::Setting, 2> start{{{"start-x", 100}, {"start-y", 100}}};
    for (const i8080::KnownDevice& known : i8080::known_devices) {
      if (known.info->kind == core::PortDeviceKind::special) continue;
      const bool plotter = known.info == &devices::CalComp565::info;
      EXPECT_EQ(ports.attach(*known.info, known.make({core::ClockRate{}, strokes, plotter ? start : std::span<const core::Setting>()})), "");
    }
    for (const auto& [info, device] : ports.devices()) {
      if (device->link_host() != nullptr) device->link_host()->send(host_bytes);
    }
  }
  template <class Device>
  Device* find() const {
    return static_cast<Device*>(ports.device(Device::info.name));
  }

  core::StrokeBuffer strokes;
  i8080::Ports ports{false};
};

class I8080Devices : public testing::Test {
 protected:
  void out(int port, int value) {
    ports.out(static_cast<std::uint8_t>(port), static_cast<std::uint8_t>(value), at_t_state(t += 1000));
  }
  int in(int port) { return ports.in(static_cast<std::uint8_t>(port), at_t_state(t += 1000)); }
  void wire(std::string_view line, std::uint8_t restart) { EXPECT_EQ(ports.wire(line, restart), ""); }

  tests::KeptStrokes sink;
  std::unique_ptr<Board> board = std::make_unique<Board>(sink);
  i8080::Ports& ports = board->ports;
  std::int64_t t = 0;
};

TEST_F(I8080Devices, RasterBoards) {
  board->attach_all();
  out(0x50, 6);
  EXPECT_EQ(in(0x50), 6);
  out(0x40, 0x00);
  out(0x40, 0x02);
  out(0x49, 33);
  out(0x4B, 44);
  out(0x40, 0x80);
  EXPECT_EQ(board->find<devices::Ef9365>()->raster()->at(33, 44), 6);
  EXPECT_EQ(in(0x49), 33);
  EXPECT_EQ(in(0x40) & 0x04, 0x04);
  out(0x31, 7);
  out(0x32, 8);
  out(0x30, 5);
  EXPECT_EQ(board->find<devices::Alt256>()->raster()->at(7, 8), 5);
  EXPECT_EQ(in(0x30) & 0x80, 0x80);
  out(0x33, 1);
  EXPECT_EQ(board->find<devices::Alt256>()->raster()->at(0, 0), 1);
}

TEST_F(I8080Devices, Plotters) {
  board->attach_all();
  out(0x60, 0x01);
  EXPECT_EQ(in(0x60), 0x01);
  EXPECT_EQ(board->find<devices::CalComp565>()->place(), (devices::PlotterPlace{101, 101}));
  out(0xF0, 0x81);
  EXPECT_EQ(board->find<devices::Minigraf0507>()->place(), (devices::PlotterPlace{1, 0}));
  board->strokes.flush();
  ASSERT_EQ(sink.kept.size(), 1U);
  EXPECT_EQ(sink.kept[0].x, 1);
}

TEST_F(I8080Devices, Links) {
  board->attach_all();
  out(0xE7, 0xB0);
  EXPECT_EQ(in(0xE6) & 0x20, 0x20);
  EXPECT_EQ(in(0xE4), 0x12);
  EXPECT_EQ(in(0xE4), 0x34);
  out(0xEF, 0x4E);
  out(0xED, 0x27);
  t += 2000;
  EXPECT_EQ(in(0xEF) & 0x02, 0x02);
  EXPECT_EQ(in(0xEC), 0x12);
  t += 2000;
  EXPECT_EQ(in(0xEE), 0x34);
}

TEST_F(I8080Devices, WithoutDevicesEverythingReadsAsOnesAndIsCounted) {
  for (int port = 0; port < 256; ++port) {
    EXPECT_EQ(in(port), 0xFF) << port;
    out(port, 0);
  }
  for (const auto& entry : ports.unanswered()) {
    EXPECT_EQ(entry.reads, 1U);
    EXPECT_EQ(entry.writes, 1U);
  }
  EXPECT_EQ(board->find<devices::Ef9365>(), nullptr);
  EXPECT_EQ(board->find<devices::SerialLink>(), nullptr);
  EXPECT_EQ(ports.deadline(), never_t);
  EXPECT_FALSE(ports.interrupt());
}

TEST_F(I8080Devices, WithAllDevicesOnlyTheirPortsAnswer) {
  board->attach_all();
  int answered = 0;
  for (int port = 0; port < 256; ++port) {
    in(port);
    answered += ports.unanswered()[static_cast<std::size_t>(port)].reads == 0;
  }
  int reads = 0;
  int writes = 0;
  const auto ports_in = [](std::span<const core::PortRange> ranges) {
    int count = 0;
    for (const core::PortRange range : ranges) count += range.last - range.first + 1;
    return count;
  };
  for (const auto& [info, device] : ports.devices()) {
    reads += ports_in(info->reads);
    writes += ports_in(info->writes);
  }
  // Among them 0, 1, 10, 11, 30, 40-4F, 50, 60, E4-E7, EC-EF; the Minigraf cannot be read.
  EXPECT_GE(reads, 4 + 1 + 16 + 1 + 1 + 4 + 4);
  EXPECT_EQ(answered, reads);
  answered = 0;
  for (int port = 0; port < 256; ++port) {
    out(port, 0);
    answered += ports.unanswered()[static_cast<std::size_t>(port)].writes == 0;
  }
  EXPECT_GE(writes, 4 + 4 + 16 + 1 + 1 + 4 + 4 + 1);
  EXPECT_EQ(answered, writes);
}

TEST_F(I8080Devices, UnconnectedDevicesNeverInterrupt) {
  board->attach_all();
  out(0x41, 0x70);
  out(0x60, 0);
  out(0xE7, 0xB0);
  out(0xE7, 0x09);
  ports.advance(at_t_state(10'000'000));
  EXPECT_FALSE(ports.interrupt());
  EXPECT_EQ(ports.deadline(), never_t);
}

TEST_F(I8080Devices, PlotterDoneDrivesRestartSeven) {
  board->attach_all();
  wire("calcomp", 7);
  out(0x60, 2);  // at T 1000
  EXPECT_EQ(ports.deadline(), at_t_state(11'000));
  ports.advance(at_t_state(10'999));
  EXPECT_FALSE(ports.interrupt());
  ports.advance(at_t_state(11'000));
  EXPECT_TRUE(ports.interrupt());
  EXPECT_EQ(ports.acknowledge(at_t_state(11'010)), 0xFF);
  t = 12'000;
  out(0x60, 2);
  EXPECT_FALSE(ports.interrupt());
}

TEST_F(I8080Devices, TheHighestRestartIsAcknowledgedFirst) {
  board->attach_all();
  wire("ef9365", 3);
  wire("parallel", 5);
  wire("serial-receive", 4);
  out(0x41, 0x20);
  ports.advance(at_t_state(49'152));
  EXPECT_EQ(ports.acknowledge(at_t_state(49'152)), 0xDF);
  t = 50'000;
  out(0xE7, 0xB0);
  out(0xE7, 0x09);
  EXPECT_TRUE(ports.interrupt());
  EXPECT_EQ(ports.acknowledge(at_t_state(t)), 0xEF);
  in(0xE4);
  in(0xE4);
  EXPECT_EQ(ports.acknowledge(at_t_state(t)), 0xDF);
  in(0x40);
  EXPECT_FALSE(ports.interrupt());
  out(0xED, 0x4E);
  out(0xED, 0x27);
  EXPECT_EQ(ports.deadline(), at_t_state(t + 2969));
  ports.advance(at_t_state(t + 2969));
  EXPECT_EQ(ports.acknowledge(at_t_state(t + 3000)), 0xE7);
}

// Devices catch up only when accessed: advancing them in between must change nothing. Whatever a program writes, the boards keep
// their limits.
TEST_F(I8080Devices, AdvancingInBetweenChangesNothing) {
  std::array<std::uint8_t, 200> bytes{};
  for (std::size_t n = 0; n < bytes.size(); ++n) bytes[n] = static_cast<std::uint8_t>(n * 7);
  tests::KeptStrokes other_sink;
  const auto lazy = std::make_unique<Board>(sink);
  const auto eager = std::make_unique<Board>(other_sink);
  for (Board* either : {lazy.get(), eager.get()}) {
    either->attach_all();
    either->find<devices::ParallelLink>()->send(bytes);
    either->find<devices::SerialLink>()->send(bytes);
    EXPECT_EQ(either->ports.wire("calcomp", 7), "");
    EXPECT_EQ(either->ports.wire("ef9365", 2), "");
  }
  constexpr std::array<std::uint8_t, 5> pages{0x30, 0x40, 0x50, 0x60, 0xE0};
  std::mt19937_64 random(19850101);
  std::int64_t now = 0;
  for (int n = 0; n < 100'000; ++n) {
    const std::uint64_t dice = random();
    const std::int64_t next = now + static_cast<std::int64_t>(10 + (dice >> 40 & 0x7FF));
    for (std::int64_t between = now; between < next; between += 61) eager->ports.advance_all(at_t_state(between));
    now = next;
    const auto port = static_cast<std::uint8_t>(dice % 16 == 0 ? 0xF0 : pages[dice % 5] | (dice >> 8 & 0x0F));
    auto value = static_cast<std::uint8_t>(dice >> 16);
    // Mostly drawing: few clears, few positions off the screen, known plotter codes.
    if (port == 0x40 && value < 0x10 && n % 64 != 0) value |= 0x80;
    if ((port == 0x48 || port == 0x4A) && n % 8 != 0) value = 0;
    if (port == 0x60) value &= 0x0F;
    if ((dice >> 32 & 3U) == 0) {
      ASSERT_EQ(lazy->ports.in(port, at_t_state(now)), eager->ports.in(port, at_t_state(now)))
          << n << " port " << int{port};
    } else {
      lazy->ports.out(port, value, at_t_state(now));
      eager->ports.out(port, value, at_t_state(now));
    }
    for (Board* either : {lazy.get(), eager.get()}) either->ports.advance(at_t_state(now));  // as the machine does at the next instruction
    ASSERT_EQ(lazy->ports.interrupt(), eager->ports.interrupt()) << n;
    ASSERT_EQ(lazy->ports.deadline(), eager->ports.deadline()) << n;
  }
  EXPECT_EQ(*lazy->find<devices::Ef9365>()->raster(), *eager->find<devices::Ef9365>()->raster());
  EXPECT_EQ(*lazy->find<devices::Alt256>()->raster(), *eager->find<devices::Alt256>()->raster());
  lazy->strokes.flush();
  eager->strokes.flush();
  EXPECT_EQ(sink.kept, other_sink.kept);
  EXPECT_EQ(lazy->find<devices::SerialLink>()->chip().sent().bytes(), eager->find<devices::SerialLink>()->chip().sent().bytes());
  EXPECT_GT(lazy->find<devices::Ef9365>()->totals().dots, 1000U);
  EXPECT_GT(lazy->find<devices::CalComp565>()->totals().steps, 10U);
  for (const std::uint8_t point : lazy->find<devices::Ef9365>()->raster()->points()) ASSERT_LE(point, 7);
  for (const std::uint8_t point : lazy->find<devices::Alt256>()->raster()->points()) ASSERT_LE(point, 7);
}

// Runs `program` from 0 until it halts for good and returns the time.
std::int64_t run(i8080::Machine& machine, std::initializer_list<int> program, std::initializer_list<int> at_restart_7 = {}) {
  std::uint16_t address = 0;
  for (const int byte : program) machine.deposit(address++, static_cast<std::uint8_t>(byte));
  address = 0x38;
  for (const int byte : at_restart_7) machine.deposit(address++, static_cast<std::uint8_t>(byte));
  machine.registers().sp = 0x1000;
  EXPECT_EQ(machine.run({100'000, at_t_state(1'000'000)}), i8080::StopReason::halt);
  return core::t_states_of(machine.now());
}

TEST(I8080DevicesAtWork, AProgramClearsWaitsAndDraws) {
  i8080::Machine machine;
  ASSERT_EQ(machine.attach("ef9365"), "");
  const std::int64_t end = run(machine, {0x3E, 0x07, 0xD3, 0x50,  // MVI A,7; OUT 50H   colour
                                        0x3E, 0x07, 0xD3, 0x40,  // MVI A,7; OUT 40H   clear, at T 17 + 7 + 9
                                        0xDB, 0x40, 0xE6, 0x04,  // IN 40H; ANI 4
                                        0xCA, 0x08, 0x00,        // JZ 8
                                        0xAF, 0xD3, 0x40,        // XRA A; OUT 40H     pen
                                        0x3E, 0x02, 0xD3, 0x40,  // MVI A,2; OUT 40H   down
                                        0x3E, 0x80, 0xD3, 0x40, 0x76});  // dot; HLT
  EXPECT_EQ(machine.find<devices::Ef9365>()->raster()->at(0, 0), 7);
  EXPECT_EQ(machine.find<devices::Ef9365>()->totals().commands_while_busy, 0U);
  EXPECT_EQ(machine.find<devices::Ef9365>()->totals().commands, 4U);
  // 40 ms = 120,000 T of clearing, at most one round of the loop (27 T) late, and 55 T before and after.
  EXPECT_GT(end, 120'000);
  EXPECT_LT(end, 120'000 + 200);
}

TEST(I8080DevicesAtWork, TheEndOfAPlotterStepWakesAHaltedProcessor) {
  i8080::Machine machine;
  const std::array<core::Setting, 2> start{{{"start-x", 100}, {"start-y", 100}}};
  ASSERT_EQ(machine.attach("calcomp565", start), "");
  ASSERT_EQ(machine.wire("calcomp", 7), "");
  const std::int64_t end =
      run(machine, {0xFB, 0x3E, 0x02, 0xD3, 0x60, 0x76},  // EI; MVI A,2; OUT 60H; HLT
          {0xDB, 0x60, 0x32, 0x00, 0x20, 0x76});         // IN 60H; STA 2000H; HLT, interrupts off
  EXPECT_EQ(machine.find<devices::CalComp565>()->place(), (devices::PlotterPlace{101, 100}));
  // The write is sampled 9 T after OUT begins at T 11: DONE at T 10,020. RST 7 begins 3 T later and takes 11, IN 10, STA 13, HLT
  // 7.
  EXPECT_EQ(end, 10'020 + 3 + 11 + 10 + 13 + 7);
}

}  // namespace
