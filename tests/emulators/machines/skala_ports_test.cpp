// Which port reaches which device, what happens where there is none, and whose interrupt comes first.
#include "emulators/machines/skala_ports.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <random>

#include "emulators/machines/i8080_machine.hpp"
#include "tests/emulators/devices/device_test.hpp"

namespace {

using namespace sightline;
using core::at_t_state;
using core::never_t;
using machines::SkalaConfiguration;
using Ports = machines::SkalaPorts<tests::KeptStrokes>;

constexpr std::array<std::uint8_t, 2> host_bytes{0x12, 0x34};

SkalaConfiguration everything() {
  SkalaConfiguration configuration;
  configuration.ef9365 = configuration.alt256 = configuration.calcomp565 = configuration.minigraf0507 = true;
  configuration.calcomp565_start = {100, 100};
  configuration.parallel = host_bytes;
  configuration.serial = host_bytes;
  configuration.sio = configuration.two_sio = true;
  return configuration;
}

class SkalaPorts : public testing::Test {
 protected:
  void make(const SkalaConfiguration& configuration) { ports = std::make_unique<Ports>(configuration, sink); }
  void out(int port, int value) {
    ports->out(static_cast<std::uint8_t>(port), static_cast<std::uint8_t>(value), at_t_state(t += 1000));
  }
  int in(int port) { return ports->in(static_cast<std::uint8_t>(port), at_t_state(t += 1000)); }

  tests::KeptStrokes sink;
  std::unique_ptr<Ports> ports;
  std::int64_t t = 0;
};

TEST_F(SkalaPorts, RasterBoards) {
  make(everything());
  out(0x50, 6);
  EXPECT_EQ(in(0x50), 6);
  out(0x40, 0x00);
  out(0x40, 0x02);
  out(0x49, 33);
  out(0x4B, 44);
  out(0x40, 0x80);
  EXPECT_EQ(ports->ef9365()->raster().at(33, 44), 6);
  EXPECT_EQ(in(0x49), 33);
  EXPECT_EQ(in(0x40) & 0x04, 0x04);
  out(0x31, 7);
  out(0x32, 8);
  out(0x30, 5);
  EXPECT_EQ(ports->alt256()->raster().at(7, 8), 5);
  EXPECT_EQ(in(0x30) & 0x80, 0x80);
  out(0x33, 1);
  EXPECT_EQ(ports->alt256()->raster().at(0, 0), 1);
}

TEST_F(SkalaPorts, Plotters) {
  make(everything());
  out(0x60, 0x01);
  EXPECT_EQ(in(0x60), 0x01);
  EXPECT_EQ(ports->calcomp565()->place(), (devices::PlotterPlace{101, 101}));
  out(0xF0, 0x81);
  EXPECT_EQ(ports->minigraf0507()->place(), (devices::PlotterPlace{1, 0}));
  ASSERT_EQ(sink.strokes.size(), 1U);
  EXPECT_EQ(sink.strokes[0].x, 1);
}

TEST_F(SkalaPorts, Links) {
  make(everything());
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

TEST_F(SkalaPorts, WithoutDevicesEverythingReadsAsOnesAndIsCounted) {
  make({});
  for (int port = 0; port < 256; ++port) {
    EXPECT_EQ(in(port), 0xFF) << port;
    out(port, 0);
  }
  for (const auto& entry : ports->unanswered()) {
    EXPECT_EQ(entry.reads, 1U);
    EXPECT_EQ(entry.writes, 1U);
  }
  EXPECT_EQ(ports->ef9365(), nullptr);
  EXPECT_EQ(ports->serial(), nullptr);
  EXPECT_EQ(ports->deadline(), never_t);
  EXPECT_FALSE(ports->interrupt());
}

TEST_F(SkalaPorts, WithAllDevicesOnlyTheirPortsAnswer) {
  make(everything());
  int answered = 0;
  for (int port = 0; port < 256; ++port) {
    in(port);
    answered += ports->unanswered()[static_cast<std::size_t>(port)].reads == 0;
  }
  // 0, 1, 10, 11, 30, 40-4F, 50, 60, E4-E7, EC-EF; the Minigraf cannot be read.
  EXPECT_EQ(answered, 4 + 1 + 16 + 1 + 1 + 4 + 4);
  answered = 0;
  for (int port = 0; port < 256; ++port) {
    out(port, 0);
    answered += ports->unanswered()[static_cast<std::size_t>(port)].writes == 0;
  }
  EXPECT_EQ(answered, 4 + 4 + 16 + 1 + 1 + 4 + 4 + 1);
}

TEST_F(SkalaPorts, UnconnectedDevicesNeverInterrupt) {
  make(everything());
  out(0x41, 0x70);
  out(0x60, 0);
  out(0xE7, 0xB0);
  out(0xE7, 0x09);
  ports->advance(at_t_state(10'000'000));
  EXPECT_FALSE(ports->interrupt());
  EXPECT_EQ(ports->deadline(), never_t);
}

TEST_F(SkalaPorts, PlotterDoneDrivesRestartSeven) {
  SkalaConfiguration configuration = everything();
  configuration.calcomp565_restart = 7;
  make(configuration);
  out(0x60, 2);  // at T 1000
  EXPECT_EQ(ports->deadline(), at_t_state(11'000));
  ports->advance(at_t_state(10'999));
  EXPECT_FALSE(ports->interrupt());
  ports->advance(at_t_state(11'000));
  EXPECT_TRUE(ports->interrupt());
  EXPECT_EQ(ports->acknowledge(at_t_state(11'010)), 0xFF);
  t = 12'000;
  out(0x60, 2);
  EXPECT_FALSE(ports->interrupt());
}

TEST_F(SkalaPorts, TheHighestRestartIsAcknowledgedFirst) {
  SkalaConfiguration configuration = everything();
  configuration.ef9365_restart = 3;
  configuration.parallel_restart = 5;
  configuration.serial_receive_restart = 4;
  make(configuration);
  out(0x41, 0x20);
  ports->advance(at_t_state(49'152));
  EXPECT_EQ(ports->acknowledge(at_t_state(49'152)), 0xDF);
  t = 50'000;
  out(0xE7, 0xB0);
  out(0xE7, 0x09);
  EXPECT_TRUE(ports->interrupt());
  EXPECT_EQ(ports->acknowledge(at_t_state(t)), 0xEF);
  in(0xE4);
  in(0xE4);
  EXPECT_EQ(ports->acknowledge(at_t_state(t)), 0xDF);
  in(0x40);
  EXPECT_FALSE(ports->interrupt());
  out(0xED, 0x4E);
  out(0xED, 0x27);
  EXPECT_EQ(ports->deadline(), at_t_state(t + 2969));
  ports->advance(at_t_state(t + 2969));
  EXPECT_EQ(ports->acknowledge(at_t_state(t + 3000)), 0xE7);
}

// Devices are caught up with when touched: looking in between must change nothing. Whatever a program writes,
// the boards keep their limits.
TEST_F(SkalaPorts, LookingInBetweenChangesNothing) {
  SkalaConfiguration configuration = everything();
  std::array<std::uint8_t, 200> bytes{};
  for (std::size_t n = 0; n < bytes.size(); ++n) bytes[n] = static_cast<std::uint8_t>(n * 7);
  configuration.parallel = bytes;
  configuration.serial = bytes;
  configuration.calcomp565_restart = 7;
  configuration.ef9365_restart = 2;
  tests::KeptStrokes other_sink;
  const auto lazy = std::make_unique<Ports>(configuration, sink);
  const auto eager = std::make_unique<Ports>(configuration, other_sink);
  constexpr std::array<std::uint8_t, 5> pages{0x30, 0x40, 0x50, 0x60, 0xE0};
  std::mt19937_64 random(19850101);
  std::int64_t now = 0;
  for (int n = 0; n < 100'000; ++n) {
    const std::uint64_t dice = random();
    const std::int64_t next = now + static_cast<std::int64_t>(10 + (dice >> 40 & 0x7FF));
    for (std::int64_t between = now; between < next; between += 61) eager->advance(at_t_state(between));
    now = next;
    const auto port = static_cast<std::uint8_t>(dice % 16 == 0 ? 0xF0 : pages[dice % 5] | (dice >> 8 & 0x0F));
    auto value = static_cast<std::uint8_t>(dice >> 16);
    // Mostly what draws: few clears, few places off the screen, known plotter codes.
    if (port == 0x40 && value < 0x10 && n % 64 != 0) value |= 0x80;
    if ((port == 0x48 || port == 0x4A) && n % 8 != 0) value = 0;
    if (port == 0x60) value &= 0x0F;
    if ((dice >> 32 & 3U) == 0) {
      ASSERT_EQ(lazy->in(port, at_t_state(now)), eager->in(port, at_t_state(now)))
          << n << " port " << int{port};
    } else {
      lazy->out(port, value, at_t_state(now));
      eager->out(port, value, at_t_state(now));
    }
    for (Ports* either : {lazy.get(), eager.get()})  // as the machine does at the next instruction
      if (either->deadline() <= at_t_state(now)) either->advance(at_t_state(now));
    ASSERT_EQ(lazy->interrupt(), eager->interrupt()) << n;
    ASSERT_EQ(lazy->deadline(), eager->deadline()) << n;
  }
  EXPECT_EQ(lazy->ef9365()->raster(), eager->ef9365()->raster());
  EXPECT_EQ(lazy->alt256()->raster(), eager->alt256()->raster());
  EXPECT_EQ(sink.strokes, other_sink.strokes);
  EXPECT_EQ(lazy->serial()->chip().sent().bytes(), eager->serial()->chip().sent().bytes());
  EXPECT_GT(lazy->ef9365()->counts().dots, 1000U);
  EXPECT_GT(lazy->calcomp565()->counts().steps, 10U);
  for (const std::uint8_t point : lazy->ef9365()->raster().points()) ASSERT_LE(point, 7);
  for (const std::uint8_t point : lazy->alt256()->raster().points()) ASSERT_LE(point, 7);
}

// The devices under a program. Runs `program` from 0 until it halts for good and returns the time.
std::int64_t run(Ports& ports, std::initializer_list<int> program,
                 std::initializer_list<int> at_restart_7 = {}) {
  machines::NoI8080Observer nobody;
  machines::I8080Machine<Ports> machine(ports, nobody);
  std::uint16_t address = 0;
  for (const int byte : program) machine.deposit(address++, static_cast<std::uint8_t>(byte));
  address = 0x38;
  for (const int byte : at_restart_7) machine.deposit(address++, static_cast<std::uint8_t>(byte));
  machine.registers().sp = 0x1000;
  EXPECT_EQ(machine.run({100'000, at_t_state(1'000'000)}), machines::I8080StopReason::halt);
  return core::t_states_of(machine.now());
}

TEST_F(SkalaPorts, AProgramClearsWaitsAndDraws) {
  make(everything());
  const std::int64_t end = run(*ports, {0x3E, 0x07, 0xD3, 0x50,  // MVI A,7; OUT 50H   colour
                                        0x3E, 0x07, 0xD3, 0x40,  // MVI A,7; OUT 40H   clear, at T 17 + 7 + 9
                                        0xDB, 0x40, 0xE6, 0x04,  // IN 40H; ANI 4
                                        0xCA, 0x08, 0x00,        // JZ 8
                                        0xAF, 0xD3, 0x40,        // XRA A; OUT 40H     pen
                                        0x3E, 0x02, 0xD3, 0x40,  // MVI A,2; OUT 40H   down
                                        0x3E, 0x80, 0xD3, 0x40, 0x76});  // dot; HLT
  EXPECT_EQ(ports->ef9365()->raster().at(0, 0), 7);
  EXPECT_EQ(ports->ef9365()->counts().commands_while_busy, 0U);
  EXPECT_EQ(ports->ef9365()->counts().commands, 4U);
  // 40 ms = 120,000 T of clearing, at most one round of the loop (27 T) late, and 55 T before and after.
  EXPECT_GT(end, 120'000);
  EXPECT_LT(end, 120'000 + 200);
}

TEST_F(SkalaPorts, TheEndOfAPlotterStepWakesAHaltedProcessor) {
  SkalaConfiguration configuration = everything();
  configuration.calcomp565_restart = 7;
  make(configuration);
  const std::int64_t end =
      run(*ports, {0xFB, 0x3E, 0x02, 0xD3, 0x60, 0x76},  // EI; MVI A,2; OUT 60H; HLT
          {0xDB, 0x60, 0x32, 0x00, 0x20, 0x76});         // IN 60H; STA 2000H; HLT, interrupts off
  EXPECT_EQ(ports->calcomp565()->place(), (devices::PlotterPlace{101, 100}));
  // The write is sampled 9 T after OUT begins at T 11: DONE at T 10,020. Then 3 T until RST 7 begins, 11 for
  // it, 10 for IN, 13 for STA, 7 for HLT.
  EXPECT_EQ(end, 10'020 + 3 + 11 + 10 + 13 + 7);
}

}  // namespace
