// For programs on the PDP-7: the marks that are reported, the strokes that are kept, and the boundary at which a run stops.
#include "host/machines/pdp7_watch.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "emulators/type340/display.hpp"
#include "host/machines/stroke_keeper.hpp"

namespace sightline::machines {
namespace {

class Watch final : public machines::ProgramWatch {
 public:
  using Told = std::pair<pdp7::Verb, pdp7::Address>;

  explicit Watch(bool stops_when_told = false) : stops_(stops_when_told) {
    mark(0101, pdp7::mark::fetched);
    mark(0110, pdp7::mark::read);
    mark(0111, pdp7::mark::written);
  }
  [[nodiscard]] const std::vector<Told>& told() const { return told_; }

  void cycle(const pdp7::Cycle& cycle) override {
    if (cycle.verb == pdp7::Verb::iot || cycle.verb == pdp7::Verb::interrupt) return;
    told_.emplace_back(cycle.verb, cycle.address);
    if (stops_) request_stop();
  }

 private:
  bool stops_;
  std::vector<Told> told_;
};

enum class At : std::uint8_t { nothing, begin, end };

// Keeps the first pass and stops the run where it begins or ends.
class FirstPass final : public machines::StrokeKeeper {
 public:
  FirstPass(pdp7::Machine& machine, At stop) : machine_(machine), stop_(stop) {}
  void begin_pass(core::Instant) override {
    keep_strokes(!ended());
    if (stop_ == At::begin) machine_.request_stop();
  }
  void end_pass(core::Instant t) override {
    keep_strokes(false);
    if (!ended()) end_ = t;
    if (stop_ == At::end) machine_.request_stop();
  }
  [[nodiscard]] bool ended() const { return end_ != core::never; }
  [[nodiscard]] core::Instant end() const { return end_; }
  [[nodiscard]] std::vector<core::Stroke> take() { return take_strokes(); }

 private:
  pdp7::Machine& machine_;
  At stop_;
  core::Instant end_ = core::never;
};

struct Rig {
  explicit Rig(At stop = At::nothing, bool stops_when_told = false)
      : watch(stops_when_told), pass(machine, stop) {
    EXPECT_EQ(machine.attach("display"), "");
    machine.strokes().hand_to(&pass);
  }

  void load(pdp7::Address at, std::initializer_list<std::uint32_t> words) { machine.load(at, words); }
  pdp7::StopReason run(const pdp7::Limits& limits) { return machine.run(limits, watch); }
  // Starts the display at 200 and waits; a point, a vector of 15 flashes, a stop with its interrupt.
  void load_display(bool interrupts) {
    load(0, {0, 0600001});
    load(0100, {0200120, 0740000, 0700606, interrupts ? 0700042U : 0740000U, 0740000, 0600104});
    load(0120, {0200});
    load(0200, {0020117, 0220400, 0102400, 0600017, 0003000});
    machine.start(0100);
  }

  pdp7::Machine machine;
  Watch watch;
  FirstPass pass;
};

constexpr pdp7::Limits a_second{~std::uint64_t{0}, core::at_nanoseconds(1'000'000'000)};

TEST(ProgramWatch, ReportsMarkedCycles) {
  Rig rig;
  // LAC 110, DAC 111, ISZ 110, DAC 110, LAC 111, HLT
  rig.load(0100, {0200110, 0040111, 0440110, 0040110, 0200111, 0740040});
  rig.machine.start(0100);
  EXPECT_EQ(rig.run(a_second), pdp7::StopReason::halt);
  EXPECT_EQ(rig.watch.told(), (std::vector<Watch::Told>{{pdp7::Verb::read, 0110},
                                                         {pdp7::Verb::fetch, 0101},
                                                         {pdp7::Verb::write, 0111},
                                                         {pdp7::Verb::modify, 0110}}));
}

TEST(ProgramWatch, StopsAfterTheInstruction) {
  Rig rig(At::nothing, true);
  rig.load(0100, {0740000, 0740000, 0740000, 0740040});
  rig.machine.start(0100);
  EXPECT_EQ(rig.run(a_second), pdp7::StopReason::observer);
  EXPECT_EQ(rig.machine.registers().pc, 0102U);
  EXPECT_EQ(rig.machine.counts().instructions, 2U);
  EXPECT_EQ(rig.run(a_second), pdp7::StopReason::halt);
}

// The last instruction of a run is reported, too, although no boundary follows it.
TEST(ProgramWatch, ReportsAHalt) {
  Rig rig(At::nothing, true);
  rig.load(0101, {0740040});
  rig.machine.start(0101);
  EXPECT_EQ(rig.run(a_second), pdp7::StopReason::halt);
  EXPECT_EQ(rig.watch.told().size(), 1U);
}

TEST(ProgramWatch, StopsWhereAPassBegins) {
  Rig rig(At::begin);
  rig.load_display(false);
  EXPECT_EQ(rig.run(a_second), pdp7::StopReason::observer);
  EXPECT_EQ(rig.machine.registers().pc, 0103U);
}

// The display catches up at the first boundary at or after the end of its pass, where the taker of strokes is told of the end;
// the run
// stops one instruction later, or after the interrupt.
TEST(ProgramWatch, StopsAfterTheBoundaryAtWhichAPassEnds) {
  for (const bool interrupts : {false, true}) {
    Rig free;
    free.load_display(interrupts);
    EXPECT_EQ(free.run(a_second), pdp7::StopReason::time_limit);
    ASSERT_TRUE(free.pass.ended());

    Rig rig(At::end);
    rig.load_display(interrupts);
    pdp7::Limits until_end;
    until_end.until = free.pass.end();
    Rig first;
    first.load_display(interrupts);
    EXPECT_EQ(first.run(until_end), pdp7::StopReason::time_limit);

    EXPECT_EQ(rig.run(a_second), pdp7::StopReason::observer);
    EXPECT_EQ(rig.machine.now(), first.machine.now() + pdp7::machine_cycle);
    EXPECT_EQ(rig.machine.registers().pc == 1, interrupts);
    // Requested once.
    EXPECT_EQ(rig.run(a_second), pdp7::StopReason::time_limit);
  }
}

TEST(ProgramWatch, KeepsStrokesOnRequest) {
  Rig rig;
  rig.load_display(false);
  EXPECT_EQ(rig.run(a_second), pdp7::StopReason::time_limit);
  const auto strokes = rig.pass.take();
  ASSERT_EQ(strokes.size(), 16U);
  for (std::size_t n = 1; n < strokes.size(); ++n) {
    EXPECT_GT(strokes[n].time, strokes[n - 1].time);
    EXPECT_EQ(strokes[n].x, strokes[n - 1].x + 1);
  }
  EXPECT_TRUE(rig.pass.take().empty());
  // The next pass is not kept.
  rig.machine.start(0100);
  const auto passes = rig.machine.find<type340::Display>()->counters().passes_started;
  pdp7::Limits more = a_second;
  more.until += core::seconds(1);
  EXPECT_EQ(rig.run(more), pdp7::StopReason::time_limit);
  EXPECT_GT(rig.machine.find<type340::Display>()->counters().passes_started, passes);
  EXPECT_TRUE(rig.pass.take().empty());
}

}  // namespace
}  // namespace sightline::machines
