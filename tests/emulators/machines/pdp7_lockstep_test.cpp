// The engines of the PDP-7 compared on random programs that modify themselves, chain XCTs, count pointers up, change banks,
// multiply, and drive a refreshing display, a clock, a teletype, tapes and interrupts: registers, times, strokes, core and states
// must agree after each piece. There are four machines: one on the fast engine, one whose observer gets every cycle, one whose
// observer gets the marked cycles, and one that alternates between all ways to run, without a taker of strokes.
//
// lockstep.hpp says how to run more programs.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/machines/pdp7.hpp"
#include "emulators/type340/display.hpp"
#include "tests/emulators/machines/lockstep.hpp"

namespace sightline {
namespace {

using tests::CycleSum;

struct SumStrokes final : core::StrokeTaker {
  CycleSum all;
  void begin_pass(core::Instant t) override { all.add(1, core::nanoseconds_of(t)); }
  void strokes(std::span<const core::Stroke> strokes) override {
    for (const core::Stroke& s : strokes) all.add(core::nanoseconds_of(s.time), s.x, s.y, s.intensity, s.address);
  }
  void end_pass(core::Instant t) override { all.add(2, core::nanoseconds_of(t)); }
};

// A checksum of the state that a snapshot would save.
class SumState final : public core::StateVisitor {
 public:
  CycleSum all;
  void words(std::string_view name, std::span<core::Word18> words) override {
    add_name(name);
    for (const core::Word18 word : words) all.add(word.value());
  }
  void bytes(std::string_view name, std::span<std::uint8_t> bytes, std::uint8_t) override {
    add_name(name);
    for (const std::uint8_t byte : bytes) all.add(byte);
  }
  void input(std::string_view name, std::span<const std::uint8_t> bytes) override {
    add_name(name);
    all.add(bytes.size());
  }
  void require(bool holds, std::string_view name, std::string_view) override { EXPECT_TRUE(holds) << name; }

 private:
  void number(std::string_view name, core::StoredNumber& number) override {
    add_name(name);
    all.add(number.value);
  }
  std::size_t begin(Group, std::string_view name, std::size_t elements) override {
    add_name(name);
    all.add(elements);
    return elements;
  }
  void end() override {}
  void add_name(std::string_view name) {
    for (const char c : name) all.add(static_cast<unsigned char>(c));
  }
};

CycleSum state_of(pdp7::Machine& machine) {
  SumState sum;
  machine.visit_state(sum);
  return sum.all;
}

void add_cycle(CycleSum& sum, const pdp7::Cycle& c) {
  sum.add_cycle(static_cast<std::uint64_t>(core::nanoseconds_of(c.time)),
                static_cast<std::uint64_t>(c.length.count()) << 40 | static_cast<std::uint64_t>(c.verb) << 36 |
                    std::uint64_t{c.address} << 18 | c.data.value());
}

// Counts what the programs do.
struct Deeds {
  std::uint64_t cycles = 0;
  tests::WrittenWords words{32768};
  std::uint64_t interrupts = 0;
  std::uint64_t breaks = 0;
  void add(const pdp7::Cycle& c) {
    ++cycles;
    switch (c.verb) {
      case pdp7::Verb::fetch: words.fetch(c.address); break;
      case pdp7::Verb::write:
      case pdp7::Verb::modify: words.write(c.address); break;
      case pdp7::Verb::interrupt: ++interrupts; break;
      case pdp7::Verb::break_read:
      case pdp7::Verb::break_write:
      case pdp7::Verb::break_modify: ++breaks; break;
      default: break;
    }
  }
};

using Marks = std::vector<std::uint8_t>;

// The cycles reported to an observer with marks, and the boundaries at which its stop() is called.
struct Asked {
  CycleSum cycles;
  CycleSum boundaries;
  void stop(const pdp7::Machine& machine, core::Instant now, pdp7::Address next) {
    EXPECT_EQ(machine.now(), now);
    EXPECT_EQ(machine.registers().pc, next);
    boundaries.add(core::nanoseconds_of(now), next, machine.registers().ac.value(), machine.counts().instructions);
  }
  friend bool operator==(const Asked&, const Asked&) = default;
};

// Gets every cycle and every boundary, and computes which of them an observer with marks would get.
struct EveryCycle final : pdp7::Observer {
  explicit EveryCycle(const Marks& of_other) : others(of_other) {}
  void cycle(const pdp7::Cycle& c) override {
    deeds.add(c);
    if (!is_marked(c)) return;
    add_cycle(expected.cycles, c);
    reported = true;
  }
  bool stop(core::Instant now, pdp7::Address next) override {
    if (reported || (others[next] & pdp7::mark::stop) != 0) expected.stop(*machine, now, next);
    reported = false;
    return false;
  }
  [[nodiscard]] bool is_marked(const pdp7::Cycle& c) const {
    const std::uint8_t here = others[c.address & pdp7::address_mask];
    switch (c.verb) {
      case pdp7::Verb::fetch: return (here & pdp7::mark::fetched) != 0;
      case pdp7::Verb::read:
      case pdp7::Verb::break_read: return (here & pdp7::mark::read) != 0;
      case pdp7::Verb::write:
      case pdp7::Verb::break_write: return (here & pdp7::mark::written) != 0;
      case pdp7::Verb::modify:
      case pdp7::Verb::break_modify: return (here & (pdp7::mark::read | pdp7::mark::written)) != 0;
      case pdp7::Verb::interrupt:
      case pdp7::Verb::iot: return true;
      case pdp7::Verb::idle: return false;
    }
    return false;
  }
  const Marks& others;
  const pdp7::Machine* machine = nullptr;
  Deeds deeds;
  Asked expected;
  bool reported = false;
};

struct MarkedCycles final : pdp7::Observer {
  explicit MarkedCycles(const Marks& of_it) { marks = of_it.data(); }
  void cycle(const pdp7::Cycle& c) override { add_cycle(asked.cycles, c); }
  bool stop(core::Instant now, pdp7::Address next) override { return asked.stop(*machine, now, next), false; }
  const pdp7::Machine* machine = nullptr;
  Asked asked;
};

// Stops at one address.
struct Breakpoint final : pdp7::Observer {
  explicit Breakpoint(pdp7::Address at) : address(at) {
    marked[address] = pdp7::mark::stop;
    marks = marked.data();
  }
  bool stop(core::Instant, pdp7::Address next) override {
    if (next != address) return false;
    armed = !armed;
    return !armed;
  }
  pdp7::Address address;
  Marks marked = Marks(32768);
  bool armed = true;
};

// Gets every boundary, as a monitor that waits for a condition does, and stops at some; gets instructions, too.
struct Follower final : pdp7::Observer {
  Follower() {
    marks = marked.data();
    every_boundary = instructions = true;
  }
  void instruction(const pdp7::InstructionRecord& record) override {
    EXPECT_GT(record.end, record.time);
    ++followed;
  }
  bool stop(core::Instant, pdp7::Address) override { return ++boundaries % 97 == 0; }
  Marks marked = Marks(32768);
  std::uint64_t boundaries = 0;
  std::uint64_t followed = 0;
};

std::uint32_t random_word(std::mt19937_64& random, std::uint32_t core_words) {
  const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
  constexpr std::array<std::uint32_t, 34> iots{
      0700002, 0700042, 0700062, 0703302, 0703341, 0700314, 0700001, 0700044, 0700004, 0700101, 0700104, 0700144,
      0700112, 0700201, 0700206, 0700301, 0700312, 0700401, 0700406, 0700501, 0700504, 0700512, 0700601, 0700606,
      0700614, 0700701, 0700704, 0700712, 0701001, 0707701, 0707702, 0707742, 0707704, 0703301};
  // Nearly all references go to one page or to the first words, so that programs reach their own words.
  const std::uint32_t place = below(8) == 0 ? below(8192) : (below(3) == 0 ? below(040) : 0200 + below(0600));
  const std::uint32_t indirect = below(4) == 0 ? 0020000 : 0;
  switch (below(16)) {
    case 0: return iots[below(iots.size())];
    case 1: return 0640000 | below(040000);
    case 2: return 0740000 | (below(020000) & ~040U);
    case 3: return 0760000 | below(020000);
    case 4: return below(6) != 0 ? 0600000 | indirect | place : below(01000000);
    case 5: return below(4) == 0 ? 0000000 | indirect | place : 0740000 | (below(4) << 7);
    case 6: return below(8) == 0 ? below(core_words) | (below(8) << 15) : 0400000 | indirect | place;
    case 7: return 0100000 | indirect | place;
    default: return (1 + below(14)) << 14 == 0640000 ? 0200000 | place : ((1 + below(12)) << 14 | indirect | place);
  }
}

// A line of a display file: a parameter word, a point, and vectors; the last one escapes.
void append_line(std::mt19937_64& random, std::vector<core::Word18>& words) {
  const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
  words.emplace_back(0020100U | below(0100));
  words.emplace_back(0200000U | (below(2) << 16) | below(02000));
  words.emplace_back(0100000U | below(02000));
  const unsigned longest = 1U << (1 + below(7));
  for (std::uint32_t left = 1 + below(6); left > 0; --left) {
    const std::uint32_t lit = below(8) != 0 ? 0200000 : 0;
    const std::uint32_t escapes = left == 1 ? 0400000 : 0;
    words.emplace_back(escapes | lit | (below(2) << 15) | (below(longest) << 8) | (below(2) << 7) | below(longest));
  }
}

struct Options {
  pdp7::Options machine;
  type340::Options display;
};

Options random_options(std::mt19937_64& random) {
  Options options;
  pdp7::Options& machine = options.machine;
  machine.core_words = 4096U << (random() % 4);
  machine.model.eae = random() % 8 != 0;
  machine.model.extend = random() % 3 == 0;
  machine.model.trap_mode = random() % 4 == 0;
  machine.model.strict = random() % 8 == 0;
  machine.timing.interrupt_cycles = random() % 4 == 0 ? 2 : 1;
  machine.timing.clock_hertz = random() % 2 == 0 ? 50 : 5000;
  machine.timing.eae_setup = core::Duration(static_cast<std::int64_t>(random() % 2 * 77));
  if (random() % 4 == 0) machine.timing.iot_stretch.fill(core::Duration(static_cast<std::int64_t>(random() % 3000)));
  options.display.subroutines_347 = random() % 2 == 0;
  options.display.characters_342 = random() % 2 == 0;
  options.display.flash_again = random() % 4 != 0;
  return options;
}

Marks random_marks(std::mt19937_64& random) {
  Marks marks(32768);
  for (std::uint8_t& each : marks) {
    if (random() % 32 == 0) each = static_cast<std::uint8_t>(random() % 16);
  }
  return marks;
}

type340::Display& display_of(pdp7::Machine& machine) {
  return *machine.find<type340::Display>();
}

struct Machines {
  Machines(const Options& options, Marks marks_of_watched, pdp7::Address stop_at)
      : marks(std::move(marks_of_watched)),
        breakpoint(stop_at),
        fast(options.machine),
        every(options.machine),
        watched(options.machine),
        mixed(options.machine) {
    const auto attach = [&options](pdp7::Machine& machine, core::StrokeTaker* strokes) {
      const std::array<core::Setting, 3> settings{core::Setting{"342", options.display.characters_342 ? 1 : 0},
                                                  core::Setting{"347", options.display.subroutines_347 ? 1 : 0},
                                                  core::Setting{"flash-again", options.display.flash_again ? 1 : 0}};
      EXPECT_EQ(machine.attach("display", settings), "");
      machine.strokes().hand_to(strokes);
    };
    attach(fast, &fast_strokes);
    attach(every, &every_strokes);
    attach(watched, &watched_strokes);
    attach(mixed, nullptr);
    of_every.machine = &every;
    of_watched.machine = &watched;
  }

  template <class Do>
  void each(Do what) {
    for (pdp7::Machine* const machine : {&fast, &every, &watched, &mixed}) what(*machine, display_of(*machine));
  }

  Marks marks;
  EveryCycle of_every{marks};
  MarkedCycles of_watched{marks};
  Breakpoint breakpoint;
  Follower follower;
  SumStrokes fast_strokes;
  SumStrokes every_strokes;
  SumStrokes watched_strokes;
  pdp7::Machine fast;
  pdp7::Machine every;
  pdp7::Machine watched;
  pdp7::Machine mixed;
};

struct Done {
  std::uint64_t programs = 0;
  std::uint64_t instructions = 0;
  std::uint64_t cycles = 0;
  std::uint64_t interrupts = 0;
  std::uint64_t breaks = 0;
  std::uint64_t flashes = 0;
  std::uint64_t marked = 0;    // cycles that an observer with marks got
  std::uint64_t followed = 0;  // instructions that an observer got
  std::uint64_t modified = 0;
};

// Runs one random program on all machines. If it `draws`, a display file of lines is started repeatedly. False if the machines
// differ.
bool run_one(std::mt19937_64& random, bool draws, Done& done) {
  const Options options = random_options(random);
  const std::uint32_t core_words = options.machine.core_words;
  std::mt19937_64 random_of_marks = random;  // a separate sequence, so that the marks do not change the program
  Machines all(options, random_marks(random_of_marks), static_cast<pdp7::Address>(0200 + random() % 0600));
  // A page of program, repeated with changes, and a random display file that may also be run.
  for (pdp7::Address a = 0; a < core_words; ++a) {
    const core::Word18 word(random_word(random, core_words));
    all.each([&](auto& machine, auto&) { machine.deposit(a, word); });
  }
  pdp7::State state;
  state.pc = static_cast<pdp7::Address>(0200 + random() % 0600);
  state.ac = core::Word18(static_cast<std::uint32_t>(random()));
  state.mq = core::Word18(static_cast<std::uint32_t>(random()));
  state.interrupts_on = random() % 2 == 0;
  state.extend = core_words > 8192 && random() % 2 == 0;
  const core::Word18 file(static_cast<std::uint32_t>(random() % 4096));
  const bool refreshes = random() % 4 != 0;
  std::vector<core::Word18> lines;
  if (draws) {
    while (lines.size() < 300) append_line(random, lines);
    lines.emplace_back(0003000U);
  }
  const auto put_lines = [&](auto& machine) {
    for (std::size_t i = 0; i < lines.size(); ++i) machine.deposit(static_cast<pdp7::Address>(010000 + i), lines[i]);
  };
  all.each([&](auto& machine, auto& display) {
    put_lines(machine);
    machine.registers() = state;
    if (refreshes) display.load_address_and_start(machine.now(), file);
  });
  for (int piece = 0; piece < 24; ++piece) {
    pdp7::Limits limits{random() % 3 == 0 ? random() % 40 : random() % 3000, core::never};
    if (random() % 3 == 0) {
      limits.until = all.fast.now() + core::Duration(static_cast<std::int64_t>(random() % 2'000'000));
    }
    const pdp7::StopReason reason = all.fast.run(limits);
    all.of_every.reported = true;  // at the start of a run the other gets a boundary, too
    const bool same_reasons = all.every.run(limits, all.of_every) == reason &&
                              all.watched.run(limits, all.of_watched) == reason;
    // After a breakpoint the run must be resumed where it stopped.
    pdp7::Limits rest = limits;
    pdp7::StopReason last{};
    do {
      const std::uint64_t before = all.mixed.counts().instructions;
      switch (random() % 3) {
        case 0: last = all.mixed.run(rest, all.breakpoint); break;
        case 1: last = all.mixed.run(rest, all.follower); break;
        default: last = piece % 2 == 0 ? all.mixed.run(rest) : all.mixed.run_plainly(rest); break;
      }
      rest.instructions -= all.mixed.counts().instructions - before;
    } while (last == pdp7::StopReason::observer);
    const auto alike = [&](pdp7::Machine& machine) {
      return machine.registers() == all.fast.registers() && machine.now() == all.fast.now() &&
             machine.counts().instructions == all.fast.counts().instructions &&
             machine.counts().machine_cycles == all.fast.counts().machine_cycles &&
             machine.counts().stolen_cycles == all.fast.counts().stolen_cycles &&
             display_of(machine).registers() == display_of(all.fast).registers() &&
             display_of(machine).counters().words == display_of(all.fast).counters().words &&
             machine.unanswered().size() == all.fast.unanswered().size();
    };
    if (!same_reasons || last != reason || !alike(all.every) || !alike(all.watched) || !alike(all.mixed)) {
      ADD_FAILURE() << "piece " << piece << ": " << same_reasons << (last == reason) << alike(all.every) << alike(all.watched)
                    << alike(all.mixed);
      return false;
    }
    if (draws && random() % 2 == 0) {
      all.each([&](auto& machine, auto& display) {
        put_lines(machine);
        display.load_address_and_start(machine.now(), core::Word18(010000));
      });
    }
    if (random() % 2 == 0 || reason == pdp7::StopReason::halt) {
      const auto pc = static_cast<pdp7::Address>(0200 + random() % 0600);
      const bool on = random() % 2 == 0;
      const auto at = static_cast<pdp7::Address>(random() % core_words);
      const core::Word18 word(random_word(random, core_words));
      all.each([&](auto& machine, auto&) {
        machine.registers().pc = pc;
        machine.registers().interrupts_on = on;
        machine.deposit(at, word);
      });
    }
  }
  const CycleSum saved = state_of(all.fast);
  if (!(state_of(all.every) == saved) || !(state_of(all.watched) == saved) || !(state_of(all.mixed) == saved)) {
    ADD_FAILURE() << "states";
    return false;
  }
  if (!(all.of_every.expected == all.of_watched.asked)) {
    ADD_FAILURE() << "marked cycles or boundaries differ";
    return false;
  }
  const CycleSum& drawn = all.fast_strokes.all;
  if (!(drawn == all.every_strokes.all) || !(drawn == all.watched_strokes.all)) {
    ADD_FAILURE() << "strokes";
    return false;
  }
  for (pdp7::Address a = 0; a <= pdp7::address_mask; ++a) {
    const core::Word18 word = all.fast.peek(a);
    if (all.every.peek(a) != word || all.watched.peek(a) != word || all.mixed.peek(a) != word) {
      ADD_FAILURE() << "core differs at " << std::oct << a;
      return false;
    }
  }
  ++done.programs;
  done.instructions += all.fast.counts().instructions;
  done.cycles += all.of_every.deeds.cycles;
  done.interrupts += all.of_every.deeds.interrupts;
  done.breaks += all.of_every.deeds.breaks;
  done.flashes += drawn.count;
  done.marked += all.of_watched.asked.cycles.count;
  done.followed += all.follower.followed;
  done.modified += all.of_every.deeds.words.fetched();
  return true;
}

// IDRS during the deflection of a point: its request rises while the next vector is counting and stops it, with or without a
// taker of strokes.
TEST(Pdp7Lockstep, ARequestStopsAVectorThatCounts) {
  for (const unsigned seed : {18490U, 12446U}) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Done done;
    EXPECT_TRUE(run_one(random, false, done));
  }
}

TEST(Pdp7Lockstep, RandomProgramsRunAlikeOnAllEngines) {
  const std::uint64_t wanted = tests::lockstep_instructions(1'500'000);
  Done done;
  for (std::uint64_t seed = tests::lockstep_seed(1); done.instructions < wanted; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    if (!run_one(random, seed % 2 == 0, done)) return;
  }
  EXPECT_GT(done.interrupts, wanted / 1000);
  EXPECT_GT(done.breaks, wanted / 200);
  EXPECT_GT(done.flashes, wanted / 100);
  EXPECT_GT(done.marked, wanted / 50);
  EXPECT_GT(done.followed, wanted / 50);
  EXPECT_GT(done.modified, wanted / 200);
  std::printf("%llu programs, %llu instructions on each machine, %llu bus cycles, %llu interrupts, %llu breaks, "
              "%llu flashes and passes, %llu fetches of words that the program had written\n",
              static_cast<unsigned long long>(done.programs), static_cast<unsigned long long>(done.instructions),
              static_cast<unsigned long long>(done.cycles), static_cast<unsigned long long>(done.interrupts),
              static_cast<unsigned long long>(done.breaks), static_cast<unsigned long long>(done.flashes),
              static_cast<unsigned long long>(done.modified));
}

}  // namespace
}  // namespace sightline
