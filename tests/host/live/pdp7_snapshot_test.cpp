// The law of snapshots on the PDP-7: Jones's program, random words as programs, and a program that keeps every device busy.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "host/machines/pdp7.hpp"
#include "tests/firmware/jones_core.hpp"
#include "tests/host/live/snapshot_law.hpp"
#include "tests/support/dice.hpp"
#include "tests/support/effort.hpp"

namespace sightline::test {
namespace {

namespace jones = programs::jones;
using jones::Dice;

// A PDP-7 with all options, and times so short that flags rise within a short run.
machines::Pdp7Setup busy_setup(std::uint32_t core_words = 8192) {
  machines::Pdp7Setup setup;
  setup.machine.core_words = core_words;
  setup.machine.timing.clock_hertz = 400;
  setup.machine.timing.reader_line = core::Duration(33'333);
  setup.machine.timing.punch_line = core::Duration(157'979);
  setup.machine.timing.teletype_character = core::Duration(200'000);
  setup.display = type340::Options{true, true, true};
  for (int line = 0; line < 3000; ++line) setup.reader_tape.push_back(static_cast<std::uint8_t>(line * 37));
  for (int key = 0; key < 60; ++key)
    setup.keys.push_back({core::at_nanoseconds(key * 700'000), static_cast<std::uint8_t>('A' + key % 26)});
  for (int move = 0; move < 40; ++move) {
    setup.switch_script.push_back(
        {core::at_nanoseconds(move * 900'000), core::Word18(static_cast<unsigned>(move))});
    if (move % 3 == 2) {
      setup.pen_script.push_back({core::at_nanoseconds(move * 600'000), std::nullopt});
    } else {
      setup.pen_script.push_back(
          {core::at_nanoseconds(move * 600'000),
           type340::LightPen{0, 0, static_cast<std::uint16_t>(200 + 20 * move), 1023}});
    }
  }
  setup.trace = true;
  setup.screen = machines::Screen::Outputs{true, true};
  return setup;
}

LawProgram program_of(std::function<std::unique_ptr<machines::Machine>()> make) {
  return {"pdp7", std::move(make), {"--trace", "--strokes"}, {"--punch", "--teletype"}, {}, {"--svg"}};
}

class JonesSnapshots : public testing::TestWithParam<const char*> {};

TEST_P(JonesSnapshots, ContinueBitForBit) {
  const jones::Program jones = jones::assemble_jones(GetParam(), true);
  const LawProgram program = program_of([&jones] {
    machines::Pdp7Setup setup;
    setup.display = type340::Options{};
    setup.trace = true;
    setup.screen = machines::Screen::Outputs{true, false};
    auto machine = machines::make_pdp7(std::move(setup)).value();
    for (std::uint32_t a = 0; a < jones.core.size(); ++a) machine->put(a, jones.core[a].value());
    machine->start(jones.labels.start);
    return machine;
  });
  Dice dice(1971);
  for (int n = 0; n < tests::effort(2, 1); ++n) {
    const auto first = static_cast<std::uint64_t>(dice(0, tests::effort(80'000, 5'000)));
    const auto then = static_cast<std::uint64_t>(dice(1, tests::effort(30'000, 5'000)));
    SCOPED_TRACE(testing::Message() << first << " and " << then);
    expect_law(program, first, then);
  }
}
INSTANTIATE_TEST_SUITE_P(Scenes, JonesSnapshots, testing::ValuesIn(jones::scene_names));

TEST(Pdp7Snapshots, RandomWordsContinueBitForBit) {
  for (std::uint32_t seed = 1; seed <= tests::effort(60U, 6U); ++seed) {
    Dice dice(seed);
    const std::uint32_t core_words = 4096U << (seed % 4);
    const LawProgram program = program_of([seed, core_words] {
      auto machine = machines::make_pdp7(busy_setup(core_words)).value();
      Dice words(seed);
      for (std::uint32_t a = 0; a < core_words; ++a) {
        auto word = static_cast<std::uint32_t>(words(0, 0777777));
        // A third of the words are IOTs of existing devices, and there is no HLT among the others.
        constexpr std::uint32_t iots[] = {0700044, 0700104, 0700144, 0700112, 0700206, 0700244,
                                          0700312, 0700406, 0700606, 0700042, 0703302, 0700712,
                                          0701012, 0700601, 0700706, 0701006};
        if (word % 3 == 0) word = iots[(word >> 4) % 16];
        if ((word & 0740040U) == 0740040) word &= ~040U;
        machine->put(a, word);
      }
      machine->start(0100);
      machine->set(6, 1);  // interrupts on
      return machine;
    });
    const auto first = static_cast<std::uint64_t>(dice(0, 3000));
    const auto then = static_cast<std::uint64_t>(dice(1, 3000));
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << first << " and " << then);
    expect_law(program, first, then);
  }
}

// Reads words from the tape and the keyboard, punches and types them, multiplies and divides, and counts clock ticks; the display
// draws
// points, vectors, increments and characters under a light pen, and is restarted at its stop.
// clang-format off
constexpr std::pair<std::uint32_t, std::uint32_t> busy_words[] = {
    // 1: JMP 300, the interrupt. 7: the clock's counter.
    {1, 0600300}, {7, 0777774},
    // LAC 201, IDLA, CLON, ION, RSB, PLS
    {0100, 0200201}, {0101, 0700606}, {0102, 0700044}, {0103, 0700042}, {0104, 0700144}, {0105, 0700206},
    // 106: LAC 202, TAD 203, DAC 202, MUL, DIV, LLS 6, ALSS 11, JMP 106
    {0106, 0200202}, {0107, 0340203}, {0110, 0040202}, {0111, 0653122}, {0112, 0000123}, {0113, 0640323},
    {0114, 0017777}, {0115, 0640606}, {0116, 0660711}, {0117, 0600106},
    {0201, 0000400}, {0203, 0012345}, {0206, 0000101},
    // 300: DAC 210; KSF, SKP, KRB; IDSI, SKP, JMP 330; IDSP, SKP, IDRS; TCF; CLSF, SKP, JMP 340
    {0300, 0040210}, {0301, 0700301}, {0302, 0741000}, {0303, 0700312}, {0304, 0700601}, {0305, 0741000},
    {0306, 0600330}, {0307, 0700701}, {0310, 0741000}, {0311, 0700504}, {0312, 0700402}, {0313, 0700001},
    {0314, 0741000}, {0315, 0600340},
    // 316: PSF, SKP, PLS; RSF, SKP, JMP 350; LAC 210, ION, JMP I 0
    {0316, 0700201}, {0317, 0741000}, {0320, 0700206}, {0321, 0700101}, {0322, 0741000}, {0323, 0600350},
    {0324, 0200210}, {0325, 0700042}, {0326, 0620000},
    // 330: LAC 201, IDLA, JMP 312; 340: LAW 17774, DAC 7, CLON, JMP 316; 350: RRB, RSB, TLS, JMP 324
    {0330, 0200201}, {0331, 0700606}, {0332, 0600312},
    {0340, 0777774}, {0341, 0040007}, {0342, 0700044}, {0343, 0600316},
    {0350, 0700112}, {0351, 0700144}, {0352, 0700406}, {0353, 0600324},
    // The display file: scale 0, intensity 7, pen on; y 400; x 400, lit; two lit vectors, the second with an escape;
    // increments; characters; stop with an interrupt.
    {0400, 0034117}, {0401, 0220400}, {0402, 0102400}, {0403, 0224074}, {0404, 0604236}, {0405, 0140000},
    {0406, 0271234}, {0407, 0652525}, {0410, 0060000}, {0411, 0010203}, {0412, 0401405}, {0413, 0373700},
    {0414, 0003400}};
// clang-format on

LawProgram busy_program() {
  return program_of([] {
    auto machine = machines::make_pdp7(busy_setup()).value();
    for (const auto& [address, word] : busy_words) machine->put(address, word);
    machine->start(0100);
    return machine;
  });
}

// A field of a section, little-endian.
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

// All positions of a run of some thousand instructions: the snapshots cover every state of the devices.
TEST(Pdp7Snapshots, ContinueFromEveryStateOfTheDevices) {
  const LawProgram program = busy_program();
  constexpr std::uint64_t never = 0x7FFF'FFFF'FFFF'FFFF;
  int reading = 0, punching = 0, typing = 0, interrupt_pending = 0, clock_on = 0, in_word = 0, pen_stop = 0,
      lit_pen = 0;
  LawRun alone(program);
  for (int n = 0; n < tests::effort(150, 8); ++n) {
    const auto first = static_cast<std::uint64_t>(n * tests::effort(47, 601));
    SCOPED_TRACE(first);
    ASSERT_TRUE(expect_law(program, first, 400)) << "the program stopped";
    alone.go(first - alone.machine().instructions());
    const machines::Bytes now = alone.save();
    reading += field(now, "reader", 36, 8) != never ? 1 : 0;
    punching += field(now, "punch", 0, 8) != never ? 1 : 0;
    typing += field(now, "printer", 0, 8) != never ? 1 : 0;
    clock_on += static_cast<int>(field(now, "clock", 8, 1));
    interrupt_pending += static_cast<int>(field(now, "clock", 9, 1));
    // Registers of the display: br 4, mode 1, x y 4, scale intensity brm part 4, halt move stop request 4,
    // edges 2, pen_enable pen_find pen_flag; then addresses 4, save shift_out 2; then the delays.
    pen_stop += static_cast<int>(field(now, "display", 21, 1));
    lit_pen += static_cast<int>(field(now, "display", 20, 1));
    for (std::size_t delay = 0; delay < 10; ++delay) {
      if (field(now, "display", 28 + 8 * delay, 8) == never) continue;
      ++in_word;
      break;
    }
  }
  if (!tests::is_optimised()) return;
  for (const int times : {reading, punching, typing, clock_on, in_word}) EXPECT_GT(times, 20);
  for (const int times : {pen_stop, lit_pen, interrupt_pending}) EXPECT_GT(times, 0);
}

TEST(Pdp7Snapshots, ASnapshotIsTheSameWithAndWithoutAnObserver) {
  machines::Pdp7Setup setup = busy_setup();
  setup.trace = false;
  setup.screen.reset();
  auto unseen = machines::make_pdp7(std::move(setup)).value();
  for (const auto& [address, word] : busy_words) unseen->put(address, word);
  unseen->start(0100);
  const LawProgram program = busy_program();
  LawRun seen(program);
  for (int n = 0; n < 50; ++n) {
    seen.go(97);
    const machines::Limits limits{unseen->instructions() + 97};
    while (!unseen->run(limits, false)) {
    }
    ASSERT_EQ(difference(seen.save(), live::save_snapshot("pdp7", *unseen)), "") << n;
  }
}

TEST(Pdp7Snapshots, AreSmall) {
  const LawProgram program = busy_program();
  EXPECT_LT(LawRun(program).save().size(), 65536U);
}

}  // namespace
}  // namespace sightline::test
