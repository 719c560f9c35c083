// The PDP-7 beside the machine of an earlier version (../reference), on random programs that modify themselves, chain XCTs,
// count pointers up, change banks, multiply, and drive a refreshing display, a clock, a teletype, tapes and interrupts: the same
// bus cycles, registers, times, strokes and core, in the same pieces. Five ways through the machine take part: with every cycle
// told, with nothing told, with a filter, by the portable loop, and asked at every boundary.
//
// How to run more than a few: lockstep.hpp.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "emulators/machines/pdp7.hpp"
#include "tests/emulators/machines/lockstep.hpp"
#include "tests/emulators/reference/pdp7/basic_pdp7.hpp"
#include "tests/emulators/reference/type340/display.hpp"

namespace sightline {
namespace {

using tests::CycleSum;

struct SumStrokes final : core::StrokeTaker {
  static constexpr bool consumes = true;
  CycleSum all;
  void begin_pass(core::Instant t) override { all.add(1, core::nanoseconds_of(t)); }
  void stroke(const core::Stroke& s) { all.add(core::nanoseconds_of(s.time), s.x, s.y, s.intensity, s.address); }
  void strokes(std::span<const core::Stroke> strokes) override {
    for (const core::Stroke& s : strokes) stroke(s);
  }
  void end_pass(core::Instant t) override { all.add(2, core::nanoseconds_of(t)); }
};

struct SumCycles {
  static constexpr bool instructions = false;
  static constexpr bool cycles = true;
  static constexpr bool stops = false;
  CycleSum all;
  void cycle(const pdp7::Cycle& c) {
    all.add_cycle(static_cast<std::uint64_t>(core::nanoseconds_of(c.time)),
                  static_cast<std::uint64_t>(c.length.count()) << 40 | static_cast<std::uint64_t>(c.verb) << 36 |
                      std::uint64_t{c.address} << 18 | c.data.value());
  }
};
// The same of the reference, and what programs do.
struct WatchedCycles : SumCycles {
  tests::WrittenWords words{32768};
  std::uint64_t interrupts = 0;
  std::uint64_t breaks = 0;
  void cycle(const pdp7::Cycle& c) {
    SumCycles::cycle(c);
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
struct SumCyclesInALoop : SumCycles {
  static constexpr bool plain_loop = true;
};
// Looks for one address, which it stops at.
struct Breakpoint {
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = true;
  struct Filter {
    pdp7::Address address;
    [[nodiscard]] constexpr bool arrives(pdp7::Address next) const { return next == address; }
  };
  pdp7::Address address = 0;
  bool armed = true;
  [[nodiscard]] Filter filter() const { return {address}; }
  bool stop(core::Instant, pdp7::Address next) {
    if (next != address) return false;
    armed = !armed;
    return !armed;
  }
};

// Is asked at every boundary, as a monitor that waits for a condition; stops at some.
struct Follower {
  static constexpr bool instructions = false;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;
  std::uint64_t boundaries = 0;
  std::uint64_t every = 97;
  void cycle(const pdp7::Cycle&) {}
  [[nodiscard]] static bool reads_machine() { return true; }
  bool stop(core::Instant, pdp7::Address) { return ++boundaries % every == 0; }
};

std::uint32_t random_word(std::mt19937_64& random, std::uint32_t core_words) {
  const auto below = [&](unsigned n) { return static_cast<std::uint32_t>(random() % n); };
  constexpr std::array<std::uint32_t, 34> iots{
      0700002, 0700042, 0700062, 0703302, 0703341, 0700314, 0700001, 0700044, 0700004, 0700101, 0700104, 0700144,
      0700112, 0700201, 0700206, 0700301, 0700312, 0700401, 0700406, 0700501, 0700504, 0700512, 0700601, 0700606,
      0700614, 0700701, 0700704, 0700712, 0701001, 0707701, 0707702, 0707742, 0707704, 0703301};
  // Nearly all references go to a page or to the first words, so that programs meet their own words.
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

// A line of a display file: a parameter word, a point, and vectors, of which the last escapes.
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

struct Machines {
  Machines(const machines::Configuration& configuration, const type340::Options& display, pdp7::Address stop_at) {
    breakpoint.address = stop_at;
    reference = std::make_unique<Reference>(configuration, of_reference);
    reference->attach_display(display, reference_strokes);
    told = std::make_unique<Told>(machines::Pdp7Options{configuration, display}, cycles);
    told->strokes().hand_to(&strokes);
    looped = std::make_unique<Looped>(machines::Pdp7Options{configuration, display}, cycles_in_a_loop);
    looped->strokes().hand_to(&looped_strokes);
    untold = std::make_unique<Untold>(machines::Pdp7Options{configuration, display}, no_observer);
  }

  using Reference = reference::BasicPdp7<reference_display::Display<SumStrokes>, WatchedCycles>;
  using Told = machines::Pdp7<SumCycles>;
  using Looped = machines::Pdp7<SumCyclesInALoop>;
  using Untold = machines::Pdp7<>;

  template <class Do>
  void each(Do what) {
    what(*reference);
    what(*told);
    what(*looped);
    what(*untold);
  }

  WatchedCycles of_reference;
  SumCycles cycles;
  SumCyclesInALoop cycles_in_a_loop;
  machines::NoObserver no_observer;
  Breakpoint breakpoint;
  Follower follower;
  SumStrokes reference_strokes;
  SumStrokes strokes;
  SumStrokes looped_strokes;
  std::unique_ptr<Reference> reference;
  std::unique_ptr<Told> told;
  std::unique_ptr<Looped> looped;
  std::unique_ptr<Untold> untold;
};

machines::Configuration random_configuration(std::mt19937_64& random) {
  machines::Configuration configuration;
  configuration.core_words = 4096U << (random() % 4);
  configuration.model.eae = random() % 8 != 0;
  configuration.model.extend = random() % 3 == 0;
  configuration.model.trap_mode = random() % 4 == 0;
  configuration.model.strict = random() % 8 == 0;
  configuration.timing.interrupt_cycles = random() % 4 == 0 ? 2 : 1;
  configuration.timing.clock_hertz = random() % 2 == 0 ? 50 : 5000;
  configuration.timing.eae_setup = core::Duration(static_cast<std::int64_t>(random() % 2 * 77));
  if (random() % 4 == 0) configuration.timing.iot_stretch.fill(core::Duration(static_cast<std::int64_t>(random() % 3000)));
  return configuration;
}

struct Done {
  std::uint64_t programs = 0;
  std::uint64_t instructions = 0;
  std::uint64_t cycles = 0;
  std::uint64_t interrupts = 0;
  std::uint64_t breaks = 0;
  std::uint64_t flashes = 0;
  std::uint64_t modified = 0;
};

// One random program on all machines; one that `draws` has a display file of lines, started again and again. False: they differ.
bool run_one(std::mt19937_64& random, bool draws, Done& done) {
  const machines::Configuration configuration = random_configuration(random);
  type340::Options display;
  display.subroutines_347 = random() % 2 == 0;
  display.characters_342 = random() % 2 == 0;
  display.flash_again = random() % 4 != 0;
  Machines all(configuration, display, static_cast<pdp7::Address>(0200 + random() % 0600));
  // A page of program, repeated with changes, and a random display file that may also be run.
  for (pdp7::Address a = 0; a < configuration.core_words; ++a) {
    const core::Word18 word(random_word(random, configuration.core_words));
    all.each([&](auto& machine) { machine.deposit(a, word); });
  }
  pdp7::State state;
  state.pc = static_cast<pdp7::Address>(0200 + random() % 0600);
  state.ac = core::Word18(static_cast<std::uint32_t>(random()));
  state.mq = core::Word18(static_cast<std::uint32_t>(random()));
  state.interrupts_on = random() % 2 == 0;
  state.extend = configuration.core_words > 8192 && random() % 2 == 0;
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
  all.each([&](auto& machine) {
    put_lines(machine);
    machine.registers() = state;
    if (refreshes) machine.display()->load_address_and_start(machine.now(), file);
  });
  for (int piece = 0; piece < 24; ++piece) {
    machines::Limits limits{random() % 3 == 0 ? random() % 40 : random() % 3000, core::never};
    if (random() % 3 == 0) {
      limits.until = all.told->now() + core::Duration(static_cast<std::int64_t>(random() % 2'000'000));
    }
    const machines::StopReason reason = all.reference->run(limits);
    const bool same_reasons =
        all.told->run(limits) == reason && all.looped->run(limits) == reason;
    // With a breakpoint the run has to be taken up again where it stopped.
    machines::Limits rest = limits;
    machines::StopReason last{};
    do {
      const std::uint64_t before = all.untold->counts().instructions;
      switch (random() % 3) {
        case 0: last = all.untold->run(rest, all.breakpoint); break;
        case 1: last = all.untold->run(rest, all.follower); break;
        default: last = all.untold->run(rest); break;
      }
      rest.instructions -= all.untold->counts().instructions - before;
    } while (last == machines::StopReason::observer);
    const auto alike = [&](const auto& machine) {
      return machine.registers() == all.reference->registers() && machine.now() == all.reference->now() &&
             machine.counts().instructions == all.reference->counts().instructions &&
             machine.counts().machine_cycles == all.reference->counts().machine_cycles &&
             machine.counts().stolen_cycles == all.reference->counts().stolen_cycles &&
             machine.display()->registers() == all.reference->display()->registers() &&
             machine.display()->counters().words == all.reference->display()->counters().words &&
             machine.unanswered().size() == all.reference->unanswered().size();
    };
    if (!same_reasons || last != reason || !alike(*all.told) || !alike(*all.looped) || !alike(*all.untold)) {
      ADD_FAILURE() << "piece " << piece << ": " << same_reasons << (last == reason) << alike(*all.told)
                    << alike(*all.looped) << alike(*all.untold);
      return false;
    }
    if (draws && random() % 2 == 0) {
      all.each([&](auto& machine) {
        put_lines(machine);
        machine.display()->load_address_and_start(machine.now(), core::Word18(010000));
      });
    }
    if (random() % 2 == 0 || reason == machines::StopReason::halt) {
      const auto pc = static_cast<pdp7::Address>(0200 + random() % 0600);
      const bool on = random() % 2 == 0;
      const auto at = static_cast<pdp7::Address>(random() % configuration.core_words);
      const core::Word18 word(random_word(random, configuration.core_words));
      all.each([&](auto& machine) {
        machine.registers().pc = pc;
        machine.registers().interrupts_on = on;
        machine.deposit(at, word);
      });
    }
  }
  if (!(all.of_reference.all == all.cycles.all) || !(all.of_reference.all == all.cycles_in_a_loop.all)) {
    ADD_FAILURE() << "bus cycles";
    return false;
  }
  if (!(all.reference_strokes.all == all.strokes.all) || !(all.reference_strokes.all == all.looped_strokes.all)) {
    ADD_FAILURE() << "strokes";
    return false;
  }
  for (pdp7::Address a = 0; a <= pdp7::address_mask; ++a) {
    const core::Word18 word = all.reference->peek(a);
    if (all.told->peek(a) != word || all.looped->peek(a) != word || all.untold->peek(a) != word) {
      ADD_FAILURE() << "core at " << std::oct << a;
      return false;
    }
  }
  ++done.programs;
  done.instructions += all.reference->counts().instructions;
  done.cycles += all.of_reference.all.count;
  done.interrupts += all.of_reference.interrupts;
  done.breaks += all.of_reference.breaks;
  done.flashes += all.reference_strokes.all.count;
  done.modified += all.of_reference.words.fetched();
  return true;
}

// IDRS in the deflection of a point: its request rises while the next vector is counting, and stops it. A display without a
// consumer of strokes went on counting; with one, a dark vector did in the display of the reference, before that lost its
// shortcuts.
TEST(Pdp7Lockstep, ARequestStopsAVectorThatCounts) {
  for (const unsigned seed : {18490U, 12446U}) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Done done;
    EXPECT_TRUE(run_one(random, false, done));
  }
}

TEST(Pdp7Lockstep, RandomProgramsRunAsOnTheReference) {
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
