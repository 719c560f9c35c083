// All operate words compared with a rule that works on one bit at a time and shares nothing with the processor's.
#include "emulators/pdp7/operate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "tests/emulators/pdp7/array_bus.hpp"

namespace sightline {
namespace {

// L and AC as nineteen bits; [0] is L, [1] is AC0.
using Bits = std::array<bool, 19>;

Bits bits_of(std::uint32_t ac, bool link) {
  Bits bits{};
  bits[0] = link;
  for (unsigned i = 0; i < 18; ++i) bits[i + 1] = ((ac >> (17 - i)) & 1U) != 0;
  return bits;
}

bool microbit(std::uint32_t word, unsigned dec_bit) {
  return ((word >> (17 - dec_bit)) & 1U) != 0;
}

std::pair<Bits, bool> rule(std::uint32_t word, Bits b, std::uint32_t switches) {
  bool zero = true;
  for (std::size_t i = 1; i < 19; ++i) zero = zero && !b[i];
  bool condition = false;
  if (microbit(word, 9)) condition = condition || b[0];
  if (microbit(word, 10)) condition = condition || zero;
  if (microbit(word, 11)) condition = condition || b[1];
  const bool skip = microbit(word, 8) ? !condition : condition;
  for (std::size_t i = 1; i < 19; ++i) {
    bool bit = b[i];
    if (microbit(word, 5)) bit = false;
    if (microbit(word, 17)) bit = !bit;
    if (microbit(word, 15)) bit = bit || ((switches >> (18 - i)) & 1U) != 0;
    b[i] = bit;
  }
  if (microbit(word, 6)) b[0] = false;
  if (microbit(word, 16)) b[0] = !b[0];
  const bool left = microbit(word, 14);
  const bool right = microbit(word, 13);
  for (int place = 0; place < (microbit(word, 7) ? 2 : 1); ++place) {
    const Bits from = b;
    for (std::size_t i = 0; i < 19; ++i) {
      if (left && !right) b[i] = from[(i + 1) % 19];
      if (right && !left) b[(i + 1) % 19] = from[i];
    }
  }
  return {b, skip};
}

TEST(Pdp7Operate, EveryWordObeysTheOrderOfEvents) {
  constexpr std::uint32_t switches = 0141516;
  tests::ArrayMachine machine;
  machine.switches = core::Word18(switches);
  for (std::uint32_t word = 0740000; word < 0760000; ++word) {
    machine.core[0100] = core::Word18(word);
    for (const std::uint32_t ac : {0U, 0777777U, 0400000U, 1U, 0252525U, 0313377U}) {
      for (const bool link : {false, true}) {
        pdp7::State state;
        state.pc = 0100;
        state.ac = core::Word18(ac);
        state.link = link;
        const pdp7::State after = tests::run_on_array(machine, state);
        const auto [bits, skip] = rule(word, bits_of(ac, link), switches);
        ASSERT_EQ(bits_of(after.ac.value(), after.link), bits)
            << std::oct << word << " AC=" << ac << " L=" << link;
        ASSERT_EQ(after.pc, skip ? 0102U : 0101U) << std::oct << word << " AC=" << ac << " L=" << link;
      }
    }
  }
}

TEST(Pdp7Operate, HaltIsReportedAfterTheActions) {
  tests::ArrayMachine machine;
  const pdp7::Timing timing;
  const pdp7::Model model;
  for (std::uint32_t word = 0740000; word < 0760000; ++word) {
    machine.core[0] = core::Word18(word);
    pdp7::Cpu<tests::ArrayBus> cpu(tests::ArrayBus(machine), model, timing, {});
    ASSERT_EQ(cpu.step() == pdp7::Outcome::halted, microbit(word, 12)) << std::oct << word;
  }
}

}  // namespace
}  // namespace sightline
