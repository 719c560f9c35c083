// The 8080 beside the machine of an earlier version (../reference), on random programs that modify themselves, with random
// INT and READY, ports, halts and jammed instructions: the same bus cycles, registers, times and memory, in the same pieces.
// Four ways through the machine take part: the fast engine, the plain one by itself, with every cycle reported, and asked at every
// boundary.
//
// How to run more than a few: lockstep.hpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <random>

#include "emulators/machines/i8080.hpp"
#include "tests/emulators/machines/lockstep.hpp"
#include "tests/emulators/reference/i8080/i8080_machine.hpp"

namespace sightline {
namespace {

using reference_8080::I8080StopReason;
using tests::CycleSum;

// INT that changes at instants drawn beforehand, and READY that is low for some memory and port cycles.
template <bool may_wait>
struct RandomPorts {
  static constexpr bool waits = may_wait;
  std::uint64_t seed = 0;
  std::int64_t period = 100;
  std::array<std::uint8_t, 3> supplied{0xFF, 0, 0};
  std::size_t given = 0;
  std::int64_t now = 0;
  CycleSum accesses;

  [[nodiscard]] std::uint64_t hash(std::int64_t n) const {
    std::uint64_t z = seed + static_cast<std::uint64_t>(n) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    return z ^ (z >> 27);
  }
  // INT is one of random levels in each period, and in some of them a pulse of one T-state.
  [[nodiscard]] bool level(std::int64_t t) const {
    const std::uint64_t h = hash(t / period);
    if ((h & 7U) == 0) return t % period == static_cast<std::int64_t>(h >> 8) % period;
    return (h & 7U) < 3;
  }
  std::uint8_t in(std::uint8_t port, core::TStateInstant at) {
    advance(at);
    accesses.add(port, now, 1);
    return static_cast<std::uint8_t>(hash(now) >> 7);
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    advance(at);
    accesses.add(port, now, value);
  }
  std::uint8_t acknowledge(core::TStateInstant at) {
    advance(at);
    return supplied[given++ % supplied.size()];
  }
  void advance(core::TStateInstant at) { now = core::t_states_of(at); }
  [[nodiscard]] core::TStateInstant deadline() const {
    const bool found = level(now);
    std::int64_t t = now + 1;
    // From one T-state at which it may change to the next.
    while (level(t) == found) {
      const std::uint64_t h = hash(t / period);
      const std::int64_t begun = t - t % period;
      const std::int64_t pulse = begun + static_cast<std::int64_t>(h >> 8) % period;
      if ((h & 7U) != 0 || t > pulse) t = begun + period;
      else t = t == pulse ? pulse + 1 : pulse;
    }
    return core::at_t_state(t);
  }
  [[nodiscard]] bool interrupt() const { return level(now); }
  [[nodiscard]] bool stopped() const { return false; }
  [[nodiscard]] int wait_states(i8080::CycleKind, i8080::Address address, core::TStateInstant at) const {
    const std::uint64_t h = hash(core::t_states_of(at) ^ address);
    return (h & 15U) == 0 ? static_cast<int>(h >> 5 & 3U) : 0;
  }
};

// The same as a device.
template <bool may_wait>
class RandomDevice final : public core::PortDevice {
 public:
  static constexpr std::array all_ports{core::PortRange{0x00, 0xFF}};
  static constexpr core::PortDeviceInfo info{.name = "random", .help = "", .choice = "", .reads = all_ports, .writes = all_ports};

  explicit RandomDevice(const RandomPorts<may_wait>& of) : ports(of) {}
  RandomPorts<may_wait> ports;

  std::uint8_t in(std::uint8_t port, core::TStateInstant at) override { return ports.in(port, at); }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) override { ports.out(port, value, at); }
  void advance(core::TStateInstant at) override { ports.advance(at); }
  [[nodiscard]] core::TStateInstant deadline() const override { return ports.deadline(); }
  [[nodiscard]] bool drives_interrupt() const override { return true; }
  [[nodiscard]] unsigned requests() const override { return ports.interrupt() ? 1 : 0; }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant at) override { return ports.acknowledge(at); }
  [[nodiscard]] bool drives_ready() const override { return may_wait; }
  [[nodiscard]] int wait_states(std::uint8_t, std::uint16_t address, core::TStateInstant at) const override {
    return ports.wait_states({}, address, at);
  }
};

template <class Cycle>
void add_cycle(CycleSum& sum, const Cycle& c) {
  sum.add_cycle(static_cast<std::uint64_t>(core::t_states_of(c.time)),
                std::uint64_t{c.status} << 32 | std::uint64_t{c.address} << 16 | std::uint64_t{c.data} << 8 | (c.operand ? 1U : 0U));
}

struct SumCycles : i8080::Observer {
  CycleSum all;
  void cycle(const i8080::BusCycle& c) override { add_cycle(all, c); }
};
// The same of the reference, and what programs do.
struct WatchedCycles {
  static constexpr bool instructions = false;
  static constexpr bool cycles = true;
  static constexpr bool stops = false;
  CycleSum all;
  tests::WrittenWords words{65536};
  std::uint64_t waking_fetches = 0;
  void cycle(const reference_8080::I8080Cycle& c) {
    add_cycle(all, c);
    if ((c.status & (i8080::status::read | i8080::status::output)) == 0) words.write(c.address);
    if ((c.status & i8080::status::first) != 0) words.fetch(c.address);
    if (c.status == 0xAA) ++waking_fetches;
  }
};

// Is asked at every boundary, as a monitor that waits for a condition; stops at some.
struct Follower : i8080::Observer {
  std::uint64_t boundaries = 0;
  std::uint64_t every = 97;
  bool stop(core::TStateInstant, i8080::Address) override { return ++boundaries % every == 0; }
};

// What a reason of the machine is called by the reference.
I8080StopReason earlier(i8080::StopReason reason) {
  switch (reason) {
    case i8080::StopReason::halt: return I8080StopReason::halt;
    case i8080::StopReason::instruction_limit: return I8080StopReason::instruction_limit;
    case i8080::StopReason::time_limit: return I8080StopReason::time_limit;
    case i8080::StopReason::observer: return I8080StopReason::observer;
    default: return I8080StopReason::ports;
  }
}

std::uint8_t random_byte(std::mt19937_64& random) {
  const std::uint64_t r = random();
  switch (r & 31U) {
    case 0: return 0xFB;                                                      // EI
    case 1: return (r >> 5 & 7U) == 0 ? 0x76 : 0x00;                          // HLT
    case 2: return (r >> 5 & 1U) == 0 ? 0xDB : 0xD3;                          // IN, OUT
    case 3: return static_cast<std::uint8_t>(0xC2U | (r >> 5 & 7U) << 3);     // conditional jumps
    case 4: return static_cast<std::uint8_t>(0x80U | (r >> 5 & 0x3FU));       // arithmetic
    default: return static_cast<std::uint8_t>(r >> 8);
  }
}

struct Done {
  std::uint64_t programs = 0;
  std::uint64_t instructions = 0;
  std::uint64_t cycles = 0;
  std::uint64_t supplied = 0;  // bytes given in acknowledge cycles
  std::uint64_t waking_fetches = 0;
  std::uint64_t modified = 0;
};

template <bool may_wait>
bool run_one(std::mt19937_64& random, Done& done) {
  using Ports = RandomPorts<may_wait>;
  Ports ports;
  ports.seed = random();
  ports.period = static_cast<std::int64_t>(5 + random() % 300);
  for (auto& byte : ports.supplied) byte = random() % 3 == 0 ? random_byte(random) : std::uint8_t{0xE7};
  WatchedCycles of_reference;
  SumCycles cycles;
  Follower follower;
  i8080::Machine reported;
  i8080::Machine plain;
  i8080::Machine fast;
  for (i8080::Machine* const machine : {&reported, &plain, &fast}) {
    EXPECT_EQ(machine->attach(RandomDevice<may_wait>::info, std::make_unique<RandomDevice<may_wait>>(ports)), "");
  }
  const auto reference = std::make_unique<reference_8080::I8080Machine<Ports, WatchedCycles>>(ports, of_reference);
  for (auto& byte : reference->memory()) byte = random_byte(random);
  i8080::State state;
  state.pc = static_cast<i8080::Address>(random());
  state.sp = static_cast<i8080::Address>(random());
  state.hl = static_cast<i8080::Address>(random());
  state.a = static_cast<i8080::Byte>(random());
  state.interrupts_on = random() % 2 == 0;
  const auto each = [&](auto what) {
    what(*reference);
    what(reported);
    what(plain);
    what(fast);
  };
  each([&](auto& machine) {
    machine.registers() = state;
    std::copy(reference->memory().begin(), reference->memory().end(), machine.memory().begin());
  });
  for (int piece = 0; piece < 100; ++piece) {
    i8080::Limits limits{random() % 2 == 0 ? random() % 30 + 1 : random() % 6000, core::never_t};
    if (random() % 3 == 0) limits.until = reported.now() + core::TStates(static_cast<std::int64_t>(random() % 3000));
    const auto reason = reference->run({limits.instructions, limits.until});
    // Where the follower has stopped it the run is taken up again.
    i8080::Limits rest = limits;
    auto last = i8080::StopReason::observer;
    do {
      const std::uint64_t before = fast.instructions();
      last = random() % 2 == 0 ? fast.run(rest, follower) : fast.run(rest);
      rest.instructions -= fast.instructions() - before;
    } while (last == i8080::StopReason::observer && rest.instructions != 0);
    if (last == i8080::StopReason::observer) last = i8080::StopReason::instruction_limit;
    const bool same = earlier(reported.run(limits, cycles)) == reason && earlier(plain.run_plainly(limits)) == reason &&
                      earlier(last) == reason;
    const auto alike = [&](const i8080::Machine& machine) {
      return machine.registers() == reference->registers() && machine.now() == reference->now() &&
             machine.instructions() == reference->instructions();
    };
    if (!same || !alike(reported) || !alike(plain) || !alike(fast)) {
      ADD_FAILURE() << "piece " << piece << ": " << same << alike(reported) << alike(plain) << alike(fast);
      return false;
    }
    if (random() % 4 == 0) {
      const auto pc = static_cast<i8080::Address>(random());
      each([&](auto& machine) { machine.registers().pc = pc; });
    }
  }
  const bool same_cycles = of_reference.all == cycles.all;
  bool same_ports = true;
  for (const i8080::Machine* const machine : {&reported, &plain, &fast})
    same_ports = same_ports && machine->find<RandomDevice<may_wait>>()->ports.accesses == ports.accesses;
  bool same_memory = true;
  each([&](auto& machine) {
    same_memory = same_memory && std::equal(reference->memory().begin(), reference->memory().end(), machine.memory().begin());
  });
  EXPECT_TRUE(same_cycles && same_ports && same_memory) << same_cycles << same_ports << same_memory;
  ++done.programs;
  done.instructions += reference->instructions();
  done.cycles += of_reference.all.count;
  done.supplied += ports.given;
  done.waking_fetches += of_reference.waking_fetches;
  done.modified += of_reference.words.fetched();
  return same_cycles && same_ports && same_memory;
}

TEST(I8080Reference, RandomProgramsRunAsOnTheReference) {
  const std::uint64_t wanted = tests::lockstep_instructions(1'000'000);
  Done done;
  for (std::uint64_t seed = tests::lockstep_seed(1); done.instructions < wanted; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const bool good = seed % 2 == 0 ? run_one<true>(random, done) : run_one<false>(random, done);
    if (!good) return;
  }
  EXPECT_GT(done.supplied, wanted / 1000);
  EXPECT_GT(done.modified, wanted / 1000);
  std::printf("%llu programs, %llu instructions on each machine, %llu bus cycles, %llu bytes given in acknowledge cycles, "
              "%llu ends of halts, %llu fetches of bytes that the program had written\n",
              static_cast<unsigned long long>(done.programs), static_cast<unsigned long long>(done.instructions),
              static_cast<unsigned long long>(done.cycles), static_cast<unsigned long long>(done.supplied),
              static_cast<unsigned long long>(done.waking_fetches), static_cast<unsigned long long>(done.modified));
}

}  // namespace
}  // namespace sightline
