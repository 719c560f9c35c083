// Breakpoints, watchpoints and conditions of the PDP-7 on random programs: a watched run must stop where the oracle stops, which
// runs
// single instructions and evaluates each cycle by an independent rule without marks. Programs overwrite their own instructions,
// count
// up in 10-17, follow chains of XCT, are interrupted, and have words written by the clock, the display (Type 347) and the disk; a
// third
// of the watched words are among those that they execute.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host/machines/pdp7.hpp"
#include "host/machines/probe.hpp"
#include "tests/support/effort.hpp"

namespace sightline::test {
namespace {

using machines::Machine;
using machines::Pdp7Setup;
using machines::Probe;

constexpr std::uint32_t address_mask = 077777, word_mask = 0777777;
constexpr std::size_t pc = 0, ac = 1, link = 2, mq = 3, ion = 6;

enum class Sign : std::uint8_t { equal, unequal, less, at_most, more, at_least };

// REGISTER sign CONSTANT, or REGISTER sign REGISTER.
struct Question {
  std::size_t left = ac;
  std::uint32_t mask = word_mask;
  Sign sign = Sign::equal;
  std::int64_t constant = 0;
  std::optional<std::size_t> right;  // then `constant` is added to it

  [[nodiscard]] bool holds(const Machine& machine) const {
    const std::int64_t a = machine.get(left) & mask;
    const std::int64_t b = right ? machine.get(*right) + constant : constant;
    switch (sign) {
      case Sign::equal: return a == b;
      case Sign::unequal: return a != b;
      case Sign::less: return a < b;
      case Sign::at_most: return a <= b;
      case Sign::more: return a > b;
      case Sign::at_least: return a >= b;
    }
    return false;
  }
};

struct Watched {
  std::vector<std::pair<std::uint32_t, std::uint8_t>> marks;
  std::vector<std::uint32_t> ports;
  bool interrupts = false;
  std::optional<Question> question;

  void mark(Probe& probe) const {
    for (const auto& [at, what] : marks) probe.mark(at, what);
    for (const std::uint32_t port : ports) probe.mark_port(port, Probe::executed);
    if (interrupts) probe.mark_interrupts();
  }
};

// Where a run has stopped, and the reason.
struct Met {
  std::int64_t time = 0;
  std::uint32_t next = 0;
  std::vector<Probe::Event> events;
  bool holds = false;
  friend bool operator==(const Met&, const Met&) = default;
};

std::string text_of(const Met& met) {
  std::string text = "at " + std::to_string(met.time) + " PC " + std::to_string(met.next) + (met.holds ? " holds" : "");
  for (const Probe::Event& event : met.events) {
    text += " (" + std::to_string(static_cast<int>(event.kind)) + " " + std::to_string(event.time) + " " + std::to_string(event.address) + " " +
            std::to_string(event.value) + ")";
  }
  return text;
}

struct Run {
  std::vector<Met> met;
  std::vector<std::uint64_t> state;  // at the end: time, count, registers and core
};

std::vector<std::uint64_t> state_of(const Machine& machine) {
  std::vector<std::uint64_t> state{static_cast<std::uint64_t>(machine.ticks()), machine.instructions()};
  for (const std::size_t number : {pc, ac, link, mq, std::size_t{4}, ion}) state.push_back(machine.get(number));
  for (std::uint32_t at = 0; at < machine.words(); ++at) state.push_back(machine.word(at));
  return state;
}

// The run under test: runs that are as long as possible, in pieces of any length.
Run run_observed(Machine& machine, const Watched& watched, std::uint64_t instructions, std::mt19937_64& random) {
  Run done;
  Probe& probe = *machine.probe();
  bool held = watched.question && watched.question->holds(machine);
  if (watched.question) probe.condition_changed = [&] { return watched.question->holds(machine) != held; };
  watched.mark(probe);
  while (machine.instructions() < instructions) {
    machines::Limits limits;
    limits.instructions = std::min(instructions, machine.instructions() + 1 + random() % 700);
    const auto stop = machine.run(limits, false);
    std::vector<Probe::Event> events = probe.events();
    std::erase_if(events, [](const Probe::Event& event) { return event.kind == Probe::Kind::condition; });
    probe.resume();
    const bool holds = watched.question && watched.question->holds(machine);
    if (!events.empty() || holds != held) done.met.push_back({machine.ticks(), machine.get(pc), events, holds});
    held = holds;
    if (stop && stop->name != machines::stopped_by_probe && stop->name != "instruction_limit") break;
  }
  probe.clear_marks();
  probe.condition_changed = nullptr;
  done.state = state_of(machine);
  return done;
}

// The oracle: single instructions, with all their cycles reported.
Run run_stepped(Machine& machine, const Watched& watched, std::uint64_t instructions) {
  Run done;
  Probe& probe = *machine.probe();
  std::vector<std::uint8_t> marks(std::size_t{address_mask} + 1);
  for (const auto& [at, what] : watched.marks) marks[at] |= what;
  bool held = watched.question && watched.question->holds(machine);
  Met met;
  // After an interrupt the processor is at 1, before the instruction there.
  const auto boundary = [&](std::int64_t time, std::uint32_t next, bool holds) {
    if ((marks[next] & Probe::executed) != 0) met.events.push_back({Probe::Kind::execution, time, next, 0});
    if (met.events.empty() && holds == held) return;
    met.time = time;
    met.next = next;
    met.holds = holds;
    held = holds;
    done.met.push_back(met);
    met = {};
  };
  probe.on_instruction = [](const Probe::Entry&) {};
  probe.on_cycle = [&](const Probe::Cycle& cycle) {
    const std::uint8_t here = cycle.has_address ? marks[cycle.address] : 0;
    const bool reads = (here & Probe::is_read) != 0, writes = (here & Probe::is_written) != 0;
    const auto add = [&](bool wanted, Probe::Kind kind, std::uint32_t value) {
      if (wanted && met.events.size() < 64) met.events.push_back({kind, cycle.time, cycle.address, value});
    };
    if (cycle.name == "read") add(reads, Probe::Kind::read, cycle.value);
    if (cycle.name == "write") add(writes, Probe::Kind::write, cycle.value);
    if (cycle.name == "break, write" || cycle.name == "clock tick") add(writes, Probe::Kind::break_write, cycle.value);
    if (cycle.name == "read and write") {
      add(reads, Probe::Kind::read, (cycle.value - 1) & word_mask);
      add(writes, Probe::Kind::write, cycle.value);
    }
    if (cycle.name == "interrupt") {
      if (watched.interrupts) met.events.push_back({Probe::Kind::interrupt, cycle.time, cycle.value & address_mask, 0});
      add(writes, Probe::Kind::interrupt_write, cycle.value);
      boundary(cycle.time + cycle.length, 1, held);
    }
  };
  while (machine.instructions() < instructions) {
    machines::Limits limits;
    limits.instructions = machine.instructions() + 1;
    // IOTs are reported by their marks alone, which the oracle leaves to the machine: only their positions in the run are
    // compared.
    for (const std::uint32_t port : watched.ports) probe.mark_port(port, Probe::executed);
    const auto stop = machine.run(limits, false);
    for (const Probe::Event& event : probe.events())
      if (event.kind == Probe::Kind::port_write) met.events.push_back(event);
    probe.resume();
    if (stop && stop->name != machines::stopped_by_probe && stop->name != "instruction_limit") {
      // The last boundary was not reached, but the cycles before it are reported.
      const bool holds = watched.question && watched.question->holds(machine);
      if (!met.events.empty() || holds != held) done.met.push_back({machine.ticks(), machine.get(pc), met.events, holds});
      break;
    }
    boundary(machine.ticks(), machine.get(pc), watched.question && watched.question->holds(machine));
  }
  probe.on_instruction = nullptr;
  probe.on_cycle = nullptr;
  probe.clear_marks();
  done.state = state_of(machine);
  return done;
}

// --- Random programs ---

struct Random {
  explicit Random(std::uint64_t seed) : engine(seed) {}
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine() % n); }
  std::mt19937_64 engine;
};

// Nearly all references go to one page or to the first words, so that programs reach their own words.
std::uint32_t random_place(Random& random, std::uint32_t words) {
  switch (random.below(8)) {
    case 0: return random.below(words);
    case 1:
    case 2: return random.below(040);
    default: return 0200 + random.below(0200);
  }
}

std::uint32_t random_word(Random& random, std::uint32_t words) {
  constexpr std::array<std::uint32_t, 22> iots{0700002, 0700042, 0700042, 0700314, 0700001, 0700044, 0700044, 0700401, 0700406, 0700104, 0700501,
                                               0700601, 0700606, 0700614, 0700704, 0707702, 0707742, 0707704, 0707121, 0707141, 0707104, 0707144};
  const std::uint32_t place = random_place(random, words) & 017777;
  const std::uint32_t indirect = random.below(3) == 0 ? 0020000 : 0;
  switch (random.below(16)) {
    case 0: return iots[random.below(iots.size())];
    case 1: return 0640000 | random.below(040000);
    case 2: return 0740000 | (random.below(020000) & ~040U);
    case 3: return 0760000 | random.below(020000);
    case 4: return 0600000 | indirect | place;
    case 5: return random.below(3) == 0 ? 0400000 | indirect | place : 0740000 | (random.below(4) << 7);
    case 6: return random.below(4) == 0 ? random.below(words) | (random.below(8) << 15) : 0440000 | indirect | place;
    case 7: return 0100000 | indirect | place;
    default: return (1 + random.below(14)) << 14 == 0640000 ? 0200000 | place : (1 + random.below(12)) << 14 | indirect | place;
  }
}

std::unique_ptr<Machine> random_machine(std::uint64_t seed) {
  Random random(seed);
  Pdp7Setup setup;
  setup.monitored = true;
  pdp7::Options& configuration = setup.machine;
  configuration.core_words = 4096U << random.below(3);
  configuration.model.extend = random.below(3) == 0;
  configuration.model.trap_mode = random.below(6) == 0;
  configuration.timing.interrupt_cycles = random.below(4) == 0 ? 2 : 1;
  configuration.timing.clock_hertz = random.below(2) == 0 ? 50 : 5000;
  Pdp7Setup::Disk disk;
  for (int n = 0; n < 1000; ++n) disk.image.emplace_back(random_word(random, 4096));
  setup.disk = std::move(disk);
  setup.display = type340::Options{};
  setup.display->subroutines_347 = random.below(2) == 0;
  setup.keys = {{core::at_nanoseconds(0), 'A'}, {core::at_nanoseconds(3'000'000), 'B'}};
  auto machine = machines::make_pdp7(std::move(setup)).value();
  for (std::uint32_t at = 0; at < machine->words(); ++at) machine->put(at, random_word(random, machine->words()));
  machine->start(0200 + random.below(0200));
  machine->set(ac, random.below(01000000));
  machine->set(mq, random.below(01000000));
  machine->set(ion, random.below(2));
  return machine;
}

Question random_question(Random& random) {
  constexpr std::array signs{Sign::equal, Sign::unequal, Sign::less, Sign::at_most, Sign::more, Sign::at_least};
  constexpr std::array<std::size_t, 4> registers{ac, ac, link, mq};
  Question question;
  question.left = registers[random.below(4)];
  question.sign = signs[random.below(6)];
  if (random.below(3) == 0) {
    question.right = registers[random.below(4)];
    question.constant = random.below(2) == 0 ? 0 : static_cast<std::int64_t>(random.below(4000)) - 2000;
  } else {
    constexpr std::array<std::uint32_t, 4> constants{0, 1, 0777777, 0400000};
    question.constant = question.left == link ? random.below(2) : random.below(2) == 0 ? constants[random.below(4)] : random.below(01000000);
    if (question.left != link && random.below(2) == 0) {
      question.mask = 1U << random.below(18) | 1U << random.below(18);
      question.constant &= question.mask;
    }
  }
  return question;
}

Watched random_watch(Random& random, std::uint32_t words) {
  Watched watched;
  constexpr std::array<std::uint8_t, 6> what{Probe::executed, Probe::executed, Probe::is_read, Probe::is_written,
                                             Probe::is_read | Probe::is_written, Probe::executed | Probe::is_written};
  const unsigned kind = random.below(8);
  const std::uint32_t places = kind == 0 ? 0 : 1 + random.below(random.below(2) == 0 ? 3 : 60);
  for (std::uint32_t n = 0; n < places; ++n) {
    const std::uint32_t at = random.below(8) == 0 ? 7 : random_place(random, words);
    watched.marks.emplace_back(at, kind < 3 ? std::uint8_t{Probe::executed} : what[random.below(6)]);
  }
  if (random.below(6) == 0) watched.ports.push_back(random.below(8));
  watched.interrupts = random.below(6) == 0;
  if (kind == 0 || random.below(3) == 0) watched.question = random_question(random);
  return watched;
}

void expect_same_stops(std::uint64_t seed, std::uint64_t instructions, std::size_t& stops) {
  Random random(~seed);
  const auto machine = random_machine(seed);
  const auto oracle = random_machine(seed);
  const Watched watched = random_watch(random, machine->words());
  const Run found = run_observed(*machine, watched, instructions, random.engine);
  const Run expected = run_stepped(*oracle, watched, instructions);
  for (std::size_t n = 0; n < std::min(found.met.size(), expected.met.size()); ++n)
    ASSERT_EQ(found.met[n], expected.met[n]) << "seed " << seed << ", stop " << n << ":\n" << text_of(found.met[n]) << "\n" << text_of(expected.met[n]);
  ASSERT_EQ(found.met.size(), expected.met.size()) << "seed " << seed;
  ASSERT_EQ(found.state == expected.state, true) << "seed " << seed;
  stops += found.met.size();
  // Removes what was watched.
  const auto state_later = [](Machine& unwatched) {
    machines::Limits limits;
    limits.instructions = unwatched.instructions() + 500;
    static_cast<void>(unwatched.run(limits, false));
    return state_of(unwatched);
  };
  ASSERT_EQ(state_later(*machine) == state_later(*oracle), true) << "seed " << seed << ", unwatched";
}

TEST(Pdp7Watch, RandomProgramsStopLikeTheOracle) {
  std::size_t stops = 0;
  const std::uint64_t programs = tests::effort(100U, 10U);
  for (std::uint64_t seed = 1; seed <= programs && !::testing::Test::HasFatalFailure(); ++seed) expect_same_stops(seed, 2000, stops);
  EXPECT_GT(stops, programs * 10);
}

}  // namespace
}  // namespace sightline::test
