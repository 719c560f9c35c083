// One run of a PDP-7 program: polling during a run changes nothing; and the strokes that a run keeps.
#include "host/machines/pdp7.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include "tests/host/machines/machine_run.hpp"
#include "tests/support/effort.hpp"

namespace sightline::test {
namespace {

constexpr const char* everywhere = "512 512 1023";

// An octal core image.
std::string words_at(unsigned address, std::initializer_list<unsigned> words) {
  std::string text = fmt::format("{:05o}:", address);
  for (const unsigned word : words) text += fmt::format(" {:06o}", word);
  return text + "\n";
}

std::string seconds(std::int64_t nanoseconds) {
  return fmt::format("{}.{:09}", nanoseconds / 1'000'000'000, nanoseconds % 1'000'000'000);
}

MachineRun run_of(const std::string& core) {
  return MachineRun(machines::pdp7()).set_file("--load", "core", core);
}

// Counts at 200 for ever, with the clock interrupting every 20 ms. Each interrupt starts the display again, whose data breaks
// fall between
// the counts. The program counts `interrupts` (a negative number) of them; the last one halts.
std::string busy_core(unsigned interrupts = 0777766) {
  return words_at(0, {0, 0600300}) +  // 0: what the interrupt stores; 1: JMP 300
         words_at(7, {0777777}) +     // the clock's counter: the next tick interrupts
         // LAC 203, IDLA, CLON, ION, ISZ 200, NOP, JMP 104
         words_at(0100, {0200203, 0700606, 0700044, 0700042, 0440200, 0740000, 0600104}) +
         // The count; interrupts still to come; AC kept during one; where the display file is.
         words_at(0200, {0, interrupts, 0, 0000400}) +
         // DAC 202, CLC, DAC 7, CLON, LAC 203, IDLA, ISZ 201, SKP, HLT, LAC 202, ION, JMP I 0
         words_at(0300, {0040202, 0750001, 0040007, 0700044, 0200203, 0700606, 0440201, 0741000, 0740040,
                         0200202, 0700042, 0620000}) +
         // Scale 0, intensity 7; y 400; x 400, lit; a vector of 100 to the right, lit; stop, without
         // interrupt.
         words_at(0400, {0020117, 0220400, 0102400, 0600100, 0002000});
}

MachineRun busy_run(unsigned interrupts = 0777766) {
  return run_of(busy_core(interrupts)).set("--start", "100").set("--display");
}

// Device 55 twice, then JMP 102 for ever.
TEST(RunPdp7, WarnsOnceWhileItRuns) {
  auto ready = run_of(words_at(0100, {0705512, 0705512, 0600102})).set("--start", "100").prepared();
  ASSERT_TRUE(ready.has_value());
  machines::Machine& machine = *ready->machine;
  EXPECT_TRUE(machine.take_early_warnings().empty());
  EXPECT_FALSE(machine.run({}, true).has_value());
  EXPECT_EQ(machine.take_early_warnings(),
            std::vector<std::string>{"PC 00100: 705512 does nothing, no device 55 in this machine obeys it (2 times so far)"});
  EXPECT_FALSE(machine.run({}, true).has_value());
  EXPECT_TRUE(machine.take_early_warnings().empty());
  EXPECT_TRUE(machine.warnings().empty());
}

// 0 is CAL, which continues at 21; nothing was loaded there, and no start address is given.
// LAW 106; `start`; IDSI; JMP .-1; JMP 100, and a display file with that stop word.
MachineRun waits_for_stop(unsigned start, unsigned stop) {
  return run_of(words_at(0100, {0760106, start, 0700601, 0600102, 0600100}) +
                words_at(0106, {0020117, 0221000, 0121000, 0200177, 0400000, stop}))
      .set("--start", "100");
}

std::string warnings_after_a_second(const MachineRun& run) {
  auto ready = run.prepared();
  EXPECT_TRUE(ready.has_value());
  static_cast<void>(ready->machine->run({.until = 1'000'000'000}, false));
  std::string text;
  for (const std::string& warning : ready->machine->warnings()) text += warning + "\n";
  return text;
}

// The first pass begins at 106 because the counter is 0, and ends without an interrupt.
TEST(RunPdp7, WarnsOfAWaitForAStopThatCannotCome) {
  const std::string text = warnings_after_a_second(waits_for_stop(0700604, 02000));
  EXPECT_NE(text.find("the program waits with IDSI (700601) for a stop interrupt that cannot come"), std::string::npos) << text;
  EXPECT_EQ(text.find("ORs AC"), std::string::npos) << text;
  // With the interrupt bit, and with the pulse that clears the counter, there is nothing to say.
  EXPECT_EQ(warnings_after_a_second(waits_for_stop(0700606, 03000)), "");
}

// The first pass ends behind the stop word, at 114; 106 ORed into that is 116.
TEST(RunPdp7, WarnsOfAnAddressThatIsOred) {
  const std::string text = warnings_after_a_second(waits_for_stop(0700604, 03000));
  EXPECT_NE(text.find("700604 has started the display at another address than that in AC"), std::string::npos) << text;
  EXPECT_EQ(text.find("cannot come"), std::string::npos) << text;
  // IDRD (700614) clears AC and goes on at the counter on purpose.
  EXPECT_EQ(warnings_after_a_second(run_of(words_at(0100, {0760110, 0700606, 0700601, 0600102, 0700614, 0600102}) +
                                           words_at(0110, {0020117, 0003000, 0003000, 0003000}))
                                        .set("--start", "100")
                                        .set("--display"))
                .find("700604"),
            std::string::npos);
}

TEST(RunPdp7, WarnsOnceOfMemoryThatIsEmpty) {
  const auto warnings = [](const std::string& core, std::string_view start) {
    MachineRun setup = run_of(core);
    if (!start.empty()) setup.set("--start", start);
    auto ready = setup.prepared();
    if (!ready) return std::vector<std::string>{ready.error().message()};
    std::vector<std::string> texts;
    for (int slice = 0; slice < 3; ++slice) {
      EXPECT_FALSE(ready->machine->run({}, true).has_value());
      for (const std::string& text : ready->machine->take_early_warnings()) texts.push_back(text);
    }
    EXPECT_TRUE(ready->machine->warnings().empty());
    return texts;
  };
  const std::string empty = "PC 00021: executes memory that is empty: nothing was loaded there";
  EXPECT_EQ(warnings(words_at(0100, {0600100}), ""), std::vector<std::string>{empty + "; --start names where the program begins"});
  EXPECT_EQ(warnings(words_at(0100, {0740000}), "100"), std::vector<std::string>{empty});
  // LAC 103, DAC 200, JMP 200: the program has stored JMP 200 there.
  EXPECT_EQ(warnings(words_at(0100, {0200103, 0040200, 0600200, 0600200}), "100"), std::vector<std::string>{});
  // A loaded 0: CAL, and CAL again at 21.
  EXPECT_EQ(warnings(words_at(020, {0, 0}), "20"), std::vector<std::string>{});
}

// A failed restore leaves a machine without display as it was.
TEST(RunPdp7, AFailedRestoreConnectsNoDisplay) {
  const Left used = run_of(busy_core()).set("--start", "100").set("--max-instructions", "100").go();
  machines::MachineState damaged = used.machine->save();
  const auto display = std::find_if(damaged.begin(), damaged.end(), [](const auto& section) { return section.name == "display"; });
  ASSERT_NE(display, damaged.end());
  auto fresh = run_of(busy_core()).set("--start", "100").prepared();
  const machines::MachineState before = fresh->machine->save();
  const auto same = [](const machines::MachineState& a, const machines::MachineState& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return x.name == y.name && x.bytes == y.bytes; });
  };
  EXPECT_TRUE(fresh->machine->restore(used.machine->save()).has_value());
  EXPECT_TRUE(same(fresh->machine->save(), used.machine->save()));
  EXPECT_TRUE(fresh->machine->restore(before).has_value());
  EXPECT_TRUE(same(fresh->machine->save(), before));
  display->bytes.pop_back();
  EXPECT_FALSE(fresh->machine->restore(damaged).has_value());
  EXPECT_TRUE(same(fresh->machine->save(), before));
}

TEST(RunPdp7, PollingDuringARunChangesNothing) {
  NEEDS_OPTIMISED_CODE();
  const Left alone = busy_run().set("--max-instructions", "20000000").go();
  EXPECT_EQ(alone.stop.name, "halt");
  EXPECT_EQ(alone.machine->word(0201), 0U);
  EXPECT_EQ(alone.number("passes_started"), 11);
  EXPECT_EQ(alone.number("passes"), 10);  // HLT ends the last pass early
  // A counter that never reaches zero keeps the run going through several polls.
  const Left long_alone = busy_run(0).set("--max-instructions", "20000000").go();
  EXPECT_EQ(long_alone.stop.name, "instruction_limit");
  int asked = 0;
  const Left in_between = busy_run(0)
                              .set("--max-instructions", "20000000")
                              .ask([&asked](const machines::Progress&) { return ++asked > 0; })
                              .go();
  EXPECT_GE(asked, 3);
  expect_same(in_between, long_alone);
}

TEST(RunPdp7, MovingADisabledPenChangesNothing) {
  const MachineRun watched = busy_run().set("--trace").set("--strokes");
  const Left alone = MachineRun(watched).go();
  ASSERT_EQ(alone.stop.name, "halt");
  // The display file never enables the pen, so even a pen that sees the whole screen has no effect.
  std::string script;
  for (std::int64_t i = 0; i < 3000; ++i)
    script += seconds(i * 97'003) + " " + (i % 3 == 0 ? everywhere : "off") + "\n";
  ASSERT_GT(2999 * 97'003, alone.number("emulated_ns"));
  const MachineRun with_pen = MachineRun(watched).set_file("--light-pen", "pen", script);
  const Left moved = with_pen.go();
  expect_same(moved, alone);
  EXPECT_EQ(moved.streams, alone.streams);
  EXPECT_FALSE(alone.streams.at("--strokes").empty());
  Left cut = MachineRun(with_pen).set("--max-time", "0.05").go();
  EXPECT_EQ(cut.stop.name, "time_limit");
  Left counted =
      MachineRun(with_pen).set("--max-instructions", std::to_string(cut.number("instructions"))).go();
  EXPECT_EQ(counted.stop.name, "instruction_limit");
  cut.report["stop_reason"] = counted.report["stop_reason"] = nullptr;
  expect_same(counted, cut);
  EXPECT_EQ(counted.streams.at("--trace"), cut.streams.at("--trace"));
}

// The numbers at the beginning of lines.
std::vector<std::int64_t> first_fields(const std::string& text) {
  std::vector<std::int64_t> fields;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) fields.push_back(std::stoll(line));
  return fields;
}

// A single lit point, polled with IDSP: the pen finds it if the pen was moved there at a boundary before the flash.
TEST(RunPdp7, ThePenMovesAtTheFirstBoundaryAtOrAfterItsTime) {
  const MachineRun point = run_of(words_at(0100, {0200107, 0700606, 0700701, 0600102, 0740040}) +
                                  words_at(0107, {0000110, 0034117, 0220400, 0002600, 0003000}))
                               .set("--start", "100")
                               .set("--max-instructions", "200")
                               .set("--display");
  const Left alone = MachineRun(point).set("--trace").set("--strokes").go();
  ASSERT_EQ(alone.stop.name, "instruction_limit");
  const std::vector<std::int64_t> boundaries = first_fields(alone.streams.at("--trace"));
  const std::vector<std::int64_t> flashes = first_fields(alone.streams.at("--strokes"));
  ASSERT_EQ(flashes.size(), 1U);
  const std::int64_t flash = flashes[0];
  int found = 0;
  for (std::int64_t t = flash - 5000; t <= flash + 3000; t += 50) {
    const std::int64_t moved = *std::lower_bound(boundaries.begin(), boundaries.end(), t);
    const Left left =
        MachineRun(point).set_file("--light-pen", "pen", seconds(t) + " " + everywhere + "\n").go();
    const bool halted = left.stop.name == "halt";
    EXPECT_EQ(halted, moved < flash) << t << " " << moved << " " << flash;
    found += halted ? 1 : 0;
  }
  EXPECT_GT(found, 0);
  EXPECT_LT(found, 161);
}

TEST(RunPdp7, APenWithoutADisplayHasNoEffect) {
  machines::Pdp7Setup setup;
  setup.pen_script = {{core::at_nanoseconds(0), type340::LightPen{}}};
  const auto machine = make_pdp7(setup).value();
  machine->put(0, 0600000);  // JMP 0
  EXPECT_EQ(run_to_stop(*machine, {.instructions = 1000}).name, "instruction_limit");
}

TEST(RunPdp7, ATraceOrAScreenChangesNothing) {
  const Left alone = busy_run().go();
  const Left watched = busy_run().set("--trace").set("--strokes").go();
  expect_same(watched, alone);
  const std::string& trace = watched.streams.at("--trace");
  EXPECT_EQ(std::count(trace.begin(), trace.end(), '\n'), alone.number("instructions"));
  EXPECT_FALSE(watched.streams.at("--strokes").empty());
}

TEST(RunPdp7, CanBeStopped) {
  int asked = 0;
  const Left left = run_of(words_at(0, {0600000}))
                        .ask([&asked](const machines::Progress& progress) {
                          EXPECT_GT(progress.instructions, 0U);
                          return ++asked < 3;
                        })
                        .go();
  EXPECT_EQ(left.stop.name, machines::interrupted);
  EXPECT_EQ(asked, 3);
}

TEST(RunPdp7, DumpOfFourThousandWords) {
  const Left left = run_of(words_at(0, {0740040}) + words_at(07777, {0123456}))
                        .set("--memory", "4k")
                        .set("--set", "ac=777777")
                        .set("--set", "L=1")
                        .go();
  EXPECT_TRUE(left.dump.starts_with("00001 777777 1 000000 00\n740040 000000 ")) << left.dump.substr(0, 60);
  EXPECT_TRUE(left.dump.ends_with(" 000000 123456\n"));
  EXPECT_EQ(left.dump.size(), 25U + 4096U * 7U);
}

TEST(Screen, KeepsTheLastCompletePassOrTheNewestStrokes) {
  const auto stroke = [](std::uint16_t x) { return core::Stroke{core::at_nanoseconds(x), x, 0, 7, 0}; };
  machines::Screen screen({.picture = true});
  screen.begin_pass(core::at_nanoseconds(0));
  screen.strokes(std::array{stroke(1)});
  screen.begin_pass(core::at_nanoseconds(2));
  screen.strokes(std::array{stroke(2)});
  EXPECT_FALSE(screen.has_complete_pass());
  EXPECT_EQ(screen.picture_strokes(core::Instant{}), (std::vector{stroke(1), stroke(2)}));
  screen.end_pass(core::at_nanoseconds(3));
  screen.strokes(std::array{stroke(3)});
  EXPECT_TRUE(screen.has_complete_pass());
  EXPECT_EQ(screen.picture_strokes(core::Instant{}), std::vector{stroke(2)});
}

}  // namespace
}  // namespace sightline::test
