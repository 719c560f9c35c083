// The law of snapshots on the 8080: Skala's program with every board, plotter and link, and random programs that access all
// devices and
// receive their interrupts.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/machines/i8080.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/programs/skala/program.hpp"
#include "tests/firmware/skala_streams.hpp"
#include "tests/host/machines/i8080_setup.hpp"
#include "tests/host/live/snapshot_law.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::test {
namespace {

namespace skala = programs::skala;
using programs::jones::Dice;

LawProgram program_of(std::function<std::unique_ptr<machines::Machine>()> make) {
  return {"i8080",   std::move(make), {"--trace", "--bus", "--strokes"}, {"--parallel-out", "--serial-out"},
          {"--png"}, {"--svg"}};
}

struct SkalaCase {
  const char* name;
  skala::Device device;
  bool serial;
};

class SkalaSnapshots : public testing::TestWithParam<SkalaCase> {};

TEST_P(SkalaSnapshots, ContinueBitForBit) {
  const SkalaCase& chosen = GetParam();
  const skala::Program skala = skala::assemble_program();
  skala_test::StreamKind kind;
  kind.device = static_cast<int>(chosen.device);
  kind.surfaces = true;
  const machines::Bytes stream = skala_test::StreamMaker(kind, 1986).make(60);
  const LawProgram program = program_of([&] {
    machines::I8080Setup setup;
    attach(setup, std::array{"ef9365", "alt256", "calcomp565", "minigraf0507"}[static_cast<std::size_t>(chosen.device)]);
    attach_link(setup, chosen.serial ? "serial" : "parallel", stream);
    setup.observed = true;
    setup.drawing = true;
    auto machine = machines::make_i8080(std::move(setup));
    for (std::uint32_t a = 0; a < skala.memory.size(); ++a) machine->put(a, skala.memory[a]);
    machine->put(skala.labels.link_switch, chosen.serial ? 1 : 0);
    machine->start(skala.labels.start);
    return machine;
  });
  Dice dice(1986);
  for (int n = 0; n < tests::effort(3, 1); ++n) {
    const auto first = static_cast<std::uint64_t>(dice(0, tests::effort(40'000, 4'000)));
    const auto then = static_cast<std::uint64_t>(dice(1, tests::effort(15'000, 4'000)));
    SCOPED_TRACE(testing::Message() << first << " and " << then);
    expect_law(program, first, then);
  }
}
INSTANTIATE_TEST_SUITE_P(Devices, SkalaSnapshots,
                         testing::Values(SkalaCase{"ef9365", skala::Device::ef9365, false},
                                         SkalaCase{"alt256", skala::Device::alt256, false},
                                         SkalaCase{"calcomp", skala::Device::calcomp, false},
                                         SkalaCase{"minigraf", skala::Device::minigraf, false},
                                         SkalaCase{"serial", skala::Device::ef9365, true}),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

// All devices, each request on a separate restart.
machines::I8080Setup everything() {
  machines::I8080Setup setup;
  for (const char* device : {"ef9365", "alt256", "calcomp565", "minigraf0507", "sio", "2sio"}) attach(setup, device);
  machines::Bytes bytes;
  for (int n = 0; n < 500; ++n) bytes.push_back(static_cast<std::uint8_t>(n * 41));
  attach_link(setup, "parallel", bytes);
  attach_link(setup, "serial", bytes);
  wire(setup, "ef9365", 1);
  wire(setup, "calcomp", 2);
  wire(setup, "parallel", 3);
  wire(setup, "serial-receive", 4);
  wire(setup, "serial-transmit", 5);
  wire(setup, "2sio", 6);
  setup.observed = true;
  setup.drawing = true;
  return setup;
}

// A program without loops for 64K of memory: it sets up the 8251 and 8255, then executes random arithmetic and accesses to all
// devices,
// sometimes EI, and HLT, which the next request ends. A request jumps to its restart, which returns.
void put_random_program(machines::Machine& machine, std::uint32_t seed) {
  Dice dice(seed);
  std::uint32_t at = 0x40;
  const auto put = [&](std::initializer_list<int> bytes) {
    for (const int byte : bytes) machine.put(at++ & 0xFFFF, static_cast<std::uint32_t>(byte));
  };
  const auto out = [&](int port, int value) { put({0x3E, value, 0xD3, port}); };
  for (std::uint32_t restart = 0; restart < 8; ++restart) {
    at = 8 * restart;
    put({0xC9});  // RET: the next EI of the program takes the next request
  }
  at = 0x40;
  put({0x31, 0x00, 0x00});  // LXI SP
  // The 8251 at x1: 153,600 baud, so that characters end within a short run; the 8255 in modes 1; CTRL1 of the EF9365.
  out(0xED, 0x4D);
  out(0xED, 0x37);
  out(0xE7, 0xB4);
  out(0xE7, 0x09);
  out(0xE7, 0x05);
  out(0x41, 0x73);
  put({0xFB});
  constexpr int ports[] = {0x30, 0x31, 0x32, 0x33, 0x40, 0x40, 0x41, 0x42, 0x43, 0x45, 0x47, 0x48, 0x49,
                           0x4A, 0x4B, 0x50, 0x60, 0x60, 0xE4, 0xE5, 0xE6, 0xEC, 0xEC, 0xED, 0xF0, 0x99};
  while (at < 0xFF00) {
    switch (dice(0, 9)) {
      case 0: put({0xFB}); break;
      case 1: put({0xFB, dice(0, 3) == 0 ? 0x76 : 0x00}); break;
      case 2:
      case 3: put({0xDB, ports[dice(0, 25)]}); break;
      case 4: put({0x80 + dice(0, 63)}); break;
      case 5: put({0xC5, 0xE3, 0xD1}); break;
      default: {
        const int port = ports[dice(0, 25)];
        if (port == 0xED) break;  // another control word could reset the chip
        out(port, port == 0x60 ? dice(0, 9) : port == 0x41 ? 0x70 + dice(0, 3) : dice(0, 255));
      }
    }
  }
  at = 0xFF00;
  put({0xC3, 0x61, 0x00});
}

LawProgram random_program(std::uint32_t seed) {
  return program_of([seed] {
    auto machine = machines::make_i8080(everything());
    put_random_program(*machine, seed);
    machine->start(0x40);
    return machine;
  });
}

std::uint64_t field(const machines::Bytes& snapshot, std::string_view section, std::size_t at, unsigned bytes) {
  const auto decoded = live::decode_snapshot(snapshot, "test.snap");
  for (const machines::StateSection& each : decoded->state) {
    if (each.name != section) continue;
    std::uint64_t number = 0;
    for (unsigned i = 0; i < bytes; ++i) number |= std::uint64_t{each.bytes.at(at + i)} << (8 * i);
    return number;
  }
  ADD_FAILURE() << "no section " << section;
  return 0;
}

TEST(I8080Snapshots, RandomProgramsContinueBitForBit) {
  int drawing = 0, plotting = 0, sending = 0, strobing = 0, deferred = 0;
  for (std::uint32_t seed = 1; seed <= tests::effort(60U, 5U); ++seed) {
    Dice dice(seed);
    const LawProgram program = random_program(seed);
    const auto first = static_cast<std::uint64_t>(dice(0, 4000));
    const auto then = static_cast<std::uint64_t>(dice(1, 3000));
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << first << " and " << then);
    expect_law(program, first, then);
    LawRun alone(program);
    alone.go(first);

    const machines::Bytes now = alone.save();
    constexpr std::size_t raster = 65536;
    drawing += static_cast<int>(field(now, "ef9365", 24 + raster + 4, 1));
    plotting += static_cast<int>(field(now, "calcomp565", 9, 1));
    // Chip: expects 1, format 10, factor 4, command 1, synchronous ready holding released shifting.
    sending += static_cast<int>(field(now, "serial", 20, 1));
    strobing += field(now, "parallel", 47, 8) != 0x7FFF'FFFF'FFFF'FFFF ? 1 : 0;
    deferred +=
        static_cast<int>(field(now, "processor", 13, 1)) & static_cast<int>(field(now, "processor", 12, 1));
  }
  if (!tests::is_optimised()) return;
  EXPECT_GT(drawing, 0);
  EXPECT_GT(plotting, 0);
  EXPECT_GT(sending, 0);
  EXPECT_GT(strobing, 0);
  EXPECT_GT(deferred, 0);
}

// The run ends in HLT by its time limit, and the request that ends the HLT comes after the snapshot.
TEST(I8080Snapshots, ContinueFromAHalt) {
  const LawProgram program = program_of([] {
    machines::I8080Setup setup = everything();
    auto machine = machines::make_i8080(std::move(setup));
    std::uint32_t at = 0;
    // 0000 JMP 40; RST 2 (CalComp): POP PSW (its return), JMP 50. 40: LXI SP, MVI A 2, OUT 60, EI, HLT; 50:
    // LXI H, HLT
    for (const int byte : {0xC3, 0x40, 0x00}) machine->put(at++, static_cast<std::uint32_t>(byte));
    at = 0x10;
    for (const int byte : {0xF1, 0xC3, 0x50, 0x00}) machine->put(at++, static_cast<std::uint32_t>(byte));
    at = 0x40;
    for (const int byte : {0x31, 0x00, 0x80, 0x3E, 0x02, 0xD3, 0x60, 0xFB, 0x76})
      machine->put(at++, static_cast<std::uint32_t>(byte));
    at = 0x50;
    for (const int byte : {0x21, 0x34, 0x12, 0x76}) machine->put(at++, static_cast<std::uint32_t>(byte));
    machine->start(0);
    return machine;
  });
  LawRun whole(program);
  EXPECT_EQ(whole.go(100), "halt");
  EXPECT_EQ(whole.machine().get(9), 0x54U);
  for (std::int64_t until = 1; until < 10'100; until += until < tests::effort(200, 60) ? 1 : tests::effort(97, 997)) {
    LawRun first(program);
    static_cast<void>(first.machine().run({100, until}, false));
    first.machine().finish();
    LawRun second(program);
    second.restore(first.save());
    second.go(100);
    ASSERT_EQ(difference(whole.save(), second.save()), "") << until;
    for (auto& [option, text] : whole.streams())
      ASSERT_EQ(text, first.streams()[option] + second.streams()[option]) << option << " " << until;
  }
}

// HOLD for 40 of every 97 T-states, among interrupts and halts: a run that stops within a HOLD between two instructions, or in a
// halt,
// continues as if it had not stopped.
TEST(I8080Snapshots, ContinueFromAHold) {
  constexpr std::uint64_t instructions = 400;
  int standing = 0;
  for (std::uint32_t seed = 1; seed <= tests::effort(4U, 1U); ++seed) {
    const LawProgram program = program_of([seed] {
      machines::I8080Setup setup = everything();
      attach(setup, "bus-master", {{"first", 50 + seed}, {"length", 40}, {"period", 97}});
      auto machine = machines::make_i8080(std::move(setup));
      put_random_program(*machine, seed);
      machine->start(0x40);
      return machine;
    });
    LawRun whole(program);
    whole.go(instructions);
    const std::int64_t end = whole.machine().ticks();
    for (std::int64_t until = 1; until < end; until += tests::effort(37, 331)) {
      LawRun first(program);
      static_cast<void>(first.machine().run({instructions, until}, false));
      first.machine().finish();
      const machines::Bytes snapshot = first.save();
      LawRun second(program);
      second.restore(snapshot);
      second.go(instructions - second.machine().instructions());
      ASSERT_EQ(difference(whole.save(), second.save(), "drawing"), "") << seed << ": " << until;
      for (auto& [option, text] : whole.streams())
        ASSERT_EQ(text, first.streams()[option] + second.streams()[option]) << option << " " << seed << ": " << until;
      standing += field(snapshot, "pins", 1, 1) != 0 && field(snapshot, "pins", 4, 1) != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(standing, tests::effort(50, 0));
}

TEST(I8080Snapshots, KeepTheOutputOfACpmProgram) {
  const LawProgram program{"i8080",
                           [] {
                             machines::I8080Setup setup;
                             setup.cpm.emplace();
                             auto machine = machines::make_i8080(std::move(setup));
                             std::uint32_t at = 0x100;
                             // MVI C 2; INR E; CALL 5; JMP 102
                             for (const int byte : {0x0E, 0x02, 0x1C, 0xCD, 0x05, 0x00, 0xC3, 0x02, 0x01})
                               machine->put(at++, static_cast<std::uint32_t>(byte));
                             EXPECT_TRUE(machine->ready().has_value());
                             machine->start(0x100);
                             return machine;
                           },
                           {"--console-out"},
                           {},
                           {},
                           {}};
  for (std::uint64_t first = 0; first < 60; ++first) {
    SCOPED_TRACE(first);
    expect_law(program, first, 300);
  }
}

TEST(I8080Snapshots, AreSmall) {
  EXPECT_LT(live::save_snapshot("i8080", *machines::make_i8080({})).size(), 131072U);
  const LawProgram program = random_program(1);
  EXPECT_LT(LawRun(program).save().size(), 131072U + 2 * 65536U);
}

}  // namespace
}  // namespace sightline::test
