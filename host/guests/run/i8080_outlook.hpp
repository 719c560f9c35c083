// What a run of the 8080 asks of its registers while a monitor waits for conditions: the traits by which outlook.hpp knows the machine,
// and the tests that follow an instruction. A test is compiled for the registers that it reads; which one a run has follows from
// the conditions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "emulators/core/inline.hpp"
#include "emulators/core/tstates.hpp"
#include "emulators/i8080/isa.hpp"
#include "emulators/i8080/state.hpp"
#include "emulators/machines/i8080_bus.hpp"
#include "emulators/machines/i8080_observer.hpp"
#include "host/guests/run/condition.hpp"
#include "host/guests/run/outlook.hpp"
#include "host/guests/run/probe.hpp"

namespace sightline::guests::run {

// Where Outlook finds the registers of the 8080. The number of a register is its place in the description.
struct I8080Outlook {
  using Address = i8080::Address;
  using View = machines::I8080View;
  using Instant = core::TStateInstant;
  static constexpr std::size_t addresses = 0x10000;
  static constexpr std::uint8_t memory = i8080::change::memory;
  static constexpr std::array parts{i8080::change::a,  i8080::change::hl, i8080::change::bc,
                                    i8080::change::de, i8080::change::sp, i8080::change::f};
  static constexpr std::size_t program_counter = 9;

  template <std::uint8_t part>
  [[nodiscard]] SIGHTLINE_INLINE static std::uint32_t value(const View& view) {
    if constexpr (part == i8080::change::a) return view.a;
    else if constexpr (part == i8080::change::f) return view.others->f;
    else if constexpr (part == i8080::change::bc) return by_halves(view.others->bc);
    else if constexpr (part == i8080::change::de) return by_halves(view.others->de);
    else if constexpr (part == i8080::change::hl) return view.hl;
    else return view.others->sp;
  }
  // An instruction that has just written a half would delay a load of both.
  [[nodiscard]] SIGHTLINE_INLINE static std::uint32_t by_halves(const i8080::Address& pair) {
    const auto* const bytes = reinterpret_cast<const volatile std::uint8_t*>(&pair);
    constexpr std::size_t low = std::endian::native == std::endian::little ? 0 : 1;
    return bytes[low] | static_cast<std::uint32_t>(bytes[1 - low]) << 8;
  }
  [[nodiscard]] static Part part_of(std::size_t number, bool pair) {
    constexpr std::uint32_t byte = 0xFF, word = 0xFFFF;
    constexpr std::array pairs{i8080::change::bc, i8080::change::de, i8080::change::hl};
    switch (number) {
      case 0: return {i8080::change::a, 0, byte};
      case 1: return {i8080::change::f, 0, byte};
      case 8: return {i8080::change::sp, 0, word};
      case 9: return {};
      case 10: return {i8080::change::sp, 0, 0};  // INTE is not compared
      default: break;
    }
    const std::uint8_t change = pairs[(number - 2) / 2];
    if (pair) return {change, 0, word};
    return {change, number % 2 == 0 ? 8U : 0U, byte};
  }
  [[nodiscard]] static std::int64_t register_value(std::size_t number, Address next, const View& view) {
    switch (number) {
      case 0: return view.a;
      case 1: return view.others->f;
      case 2: return i8080::high(view.others->bc);
      case 3: return i8080::low(view.others->bc);
      case 4: return i8080::high(view.others->de);
      case 5: return i8080::low(view.others->de);
      case 6: return view.hl >> 8;
      case 7: return view.hl & 0xFFU;
      case 8: return view.others->sp;
      case 9: return next;
      default: return view.control->interrupts_on ? 1 : 0;
    }
  }
  [[nodiscard]] static std::optional<std::int64_t> word(std::int64_t address, const View& view) {
    if (address < 0 || address >= std::int64_t{addresses}) return std::nullopt;
    return view.store->bytes[static_cast<std::size_t>(address)];
  }
  [[nodiscard]] static std::int64_t ticks(Instant at) { return core::t_states_of(at); }
};

// Tests that a run can have behind an instruction. Registers have their numbers in the description, A F B C D E H L; above them are the
// pairs and SP.
struct I8080Test {
  enum class Kind : std::uint8_t {
    known,      // whether the values of one or two registers, sixteen bits together, are known to be others than those waited for
    related,    // the difference of two registers is in a range
    ranges      // of the parts in the set `left`
  };
  static constexpr std::uint8_t bytes = 8, bc = 8, de = 9, hl = 10, sp = 11, registers = 12, none = 255;
  Kind kind = Kind::known;
  std::uint8_t left = 0;
  std::uint8_t right = none;

  friend constexpr bool operator==(const I8080Test& a, const I8080Test& b) { return a.kind == b.kind && a.left == b.left && a.right == b.right; }
};

namespace i8080_tests {

inline constexpr unsigned ones = I8080Test::registers, twos = 8 * 7 / 2, relations = 8 + 9 + 10 + 11, sets = (1U << I8080Outlook::parts.size()) - 1;

consteval auto make_tests() {
  std::array<I8080Test, ones + twos + relations + sets> tests{};
  std::size_t n = 0;
  for (std::uint8_t left = 0; left < I8080Test::registers; ++left) tests[n++] = {I8080Test::Kind::known, left};
  for (std::uint8_t left = 0; left < I8080Test::bytes; ++left)
    for (std::uint8_t right = left + 1; right < I8080Test::bytes; ++right) tests[n++] = {I8080Test::Kind::known, left, right};
  for (std::uint8_t left = I8080Test::bytes; left < I8080Test::registers; ++left)
    for (std::uint8_t right = 0; right < left; ++right) tests[n++] = {I8080Test::Kind::related, left, right};
  for (std::uint8_t set = 1; set <= sets; ++set) tests[n++] = {I8080Test::Kind::ranges, set};
  return tests;
}
inline constexpr auto all = make_tests();

[[nodiscard]] inline std::optional<unsigned> number_of(const I8080Test& test) {
  for (unsigned n = 0; n < all.size(); ++n)
    if (all[n] == test) return n;
  return std::nullopt;
}

template <std::uint8_t number>
[[nodiscard]] SIGHTLINE_INLINE inline std::uint32_t value(const machines::I8080View& view) {
  using i8080::change::bc, i8080::change::de, i8080::change::hl, i8080::change::sp;
  if constexpr (number == 0) return view.a;
  else if constexpr (number == 1) return view.others->f;
  else if constexpr (number == 2) return i8080::high(view.others->bc);
  else if constexpr (number == 3) return i8080::low(view.others->bc);
  else if constexpr (number == 4) return i8080::high(view.others->de);
  else if constexpr (number == 5) return i8080::low(view.others->de);
  else if constexpr (number == 6) return view.hl >> 8;
  else if constexpr (number == 7) return view.hl & 0xFFU;
  else if constexpr (number == I8080Test::bc) return I8080Outlook::value<bc>(view);
  else if constexpr (number == I8080Test::de) return I8080Outlook::value<de>(view);
  else if constexpr (number == I8080Test::hl) return I8080Outlook::value<hl>(view);
  else return I8080Outlook::value<sp>(view);
}

// Where what is known of the registers of a test is kept.
template <unsigned test>
[[nodiscard]] SIGHTLINE_INLINE inline std::uint32_t place(const machines::I8080View& view) {
  constexpr I8080Test of = all[test];
  if constexpr (of.right == I8080Test::none) return value<of.left>(view);
  else return value<of.left>(view) << 8 | value<of.right>(view);
}

using Place = std::uint32_t (*)(const machines::I8080View&);
template <std::size_t... test>
constexpr std::array<Place, sizeof...(test)> make_places(std::index_sequence<test...>) {
  return {&place<test>...};
}
inline constexpr auto places = make_places(std::make_index_sequence<ones + twos>{});

}  // namespace i8080_tests

// Which test a run has.
struct I8080Plan {
  std::uint16_t tested = 0;       // see machines::I8080Wanted
  std::optional<unsigned> test;
  i8080_tests::Place place = nullptr;  // of a test by what is known
  PartRange difference;                // of a test of two registers

  I8080Plan(const OutlookTable<I8080Outlook>& table, const Probe& probe) {
    const std::uint8_t parts = table.places()[0] & i8080::change::anything;
    if (parts == 0) return;
    for (const Condition& condition : probe.conditions()) {
      for (const std::size_t number : condition.registers) tested |= change_of(number);
      if (condition.words) tested |= i8080::changed::memory;
    }
    const I8080Test chosen = test_of(parts, table, probe);
    test = i8080_tests::number_of(chosen);
    if (test && chosen.kind == I8080Test::Kind::known) place = i8080_tests::places.at(*test);
  }

 private:
  static std::uint16_t change_of(std::size_t number) {
    constexpr std::size_t b = 2, l = 7;
    if (number == 0) return i8080::changed::a;
    if (number == 1) return i8080::changed::f;
    return number <= l ? i8080::changed::by_code(static_cast<unsigned>(number - b)) : i8080::changed::sp;
  }
  I8080Test test_of(std::uint8_t parts, const OutlookTable<I8080Outlook>& table, const Probe& probe) {
    std::uint8_t set = 0;
    for (std::size_t n = 0; n < I8080Outlook::parts.size(); ++n)
      if ((parts & I8080Outlook::parts[n]) != 0) set |= static_cast<std::uint8_t>(1U << n);
    const I8080Test by_ranges{I8080Test::Kind::ranges, set};
    const std::optional<std::uint32_t> named = registers_of(probe.conditions());
    if (!named) return by_ranges;
    if (const auto known = known_by(*named)) {
      // All values of a pair are more than a host's first cache holds.
      const bool one_range = known->left >= I8080Test::bytes && std::popcount(set) == 1 &&
                             table.watches()[static_cast<std::size_t>(std::countr_zero(set))].kind == PartWatch::Kind::in_range;
      return one_range ? by_ranges : *known;
    }
    const std::vector<Condition>& conditions = probe.conditions();
    const auto related = conditions.size() == 1 && conditions[0].relation ? related_by(*conditions[0].relation, conditions[0].is_true) : std::nullopt;
    return related ? *related : by_ranges;
  }

  // By their numbers, if the conditions are about these alone and can be evaluated inside the run.
  static std::optional<std::uint32_t> registers_of(const std::vector<Condition>& conditions) {
    constexpr std::size_t number_of_sp = 8;
    std::uint32_t named = 0;
    for (const Condition& condition : conditions) {
      if (condition.steps.empty() || condition.words || condition.devices || condition.time) return std::nullopt;
      for (const std::size_t number : condition.registers) {
        if (number > number_of_sp) return std::nullopt;
        named |= 1U << number;
      }
    }
    return named;
  }
  static std::optional<I8080Test> known_by(std::uint32_t named) {
    constexpr std::uint32_t sp = 1U << 8;
    if (named == sp) return I8080Test{I8080Test::Kind::known, I8080Test::sp};
    if ((named & sp) != 0 || std::popcount(named) > 2) return std::nullopt;
    const auto first = static_cast<std::uint8_t>(std::countr_zero(named));
    if (std::popcount(named) == 1) return I8080Test{I8080Test::Kind::known, first};
    const auto second = static_cast<std::uint8_t>(std::bit_width(named) - 1);
    if (first % 2 == 0 && first != 0 && second == first + 1)
      return I8080Test{I8080Test::Kind::known, static_cast<std::uint8_t>(I8080Test::bc + (first - 2) / 2)};
    return I8080Test{I8080Test::Kind::known, first, second};
  }
  // One of them is a pair or SP.
  std::optional<I8080Test> related_by(Relation relation, bool is_true) {
    if (is_true) relation.sign = opposite(relation.sign);
    auto left = whole(relation.left), right = whole(relation.right);
    if (!left || !right || *left == *right) return std::nullopt;
    if (*left < *right) {
      std::swap(left, right);
      relation.sign = turned(relation.sign);
      relation.offset = -relation.offset;
    }
    difference = range_of_difference(relation.sign, relation.offset);
    return I8080Test{I8080Test::Kind::related, *left, *right};
  }
  static std::optional<std::uint8_t> whole(const MaskedRegister& of) {
    const bool word = of.pair || of.number == 8;
    const std::uint32_t all = word ? 0xFFFF : 0xFF;
    if ((of.mask & all) != all || of.number > 8) return std::nullopt;
    if (of.number == 8) return I8080Test::sp;
    if (of.pair) return static_cast<std::uint8_t>(I8080Test::bc + (of.number - 2) / 2);
    return static_cast<std::uint8_t>(of.number);
  }
  // Of 32 bits, as the difference is; it is at least -0xFFFF and at most 0xFFFF.
  static PartRange range_of_difference(Sign sign, std::int64_t offset) {
    constexpr std::int64_t most = 0x10000;
    const std::int64_t at = std::clamp(offset, -most, most);
    const auto from_to = [](std::int64_t first, std::int64_t last) {
      if (first > last) return PartRange{};
      return PartRange{~std::uint32_t{0}, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last - first)};
    };
    switch (sign) {
      case Sign::equal: return from_to(at, at);
      case Sign::unequal: return PartRange::other_than(static_cast<std::uint32_t>(at), ~std::uint32_t{0});
      case Sign::less: return from_to(-most, at - 1);
      case Sign::at_most: return from_to(-most, at);
      case Sign::more: return from_to(at + 1, most);
      case Sign::at_least: return from_to(at, most);
      default: return PartRange::all();
    }
  }
};

// The value that a run keeps.
class I8080Look : public Outlook<I8080Outlook> {
 public:
  static constexpr unsigned tests = i8080_tests::all.size();

  I8080Look(const OutlookTable<I8080Outlook>& table, const Probe& probe, const I8080Plan& plan)
      : Outlook(table, probe), nothing_(probe.conditions().empty()), difference_(plan.difference), place_(plan.place), tested_(plan.tested) {}

  [[nodiscard]] std::uint16_t tested() const { return tested_; }
  template <unsigned test>
  [[nodiscard]] SIGHTLINE_INLINE bool hits(const View& view) const {
    constexpr I8080Test of = i8080_tests::all[test];
    if constexpr (of.kind == I8080Test::Kind::known) {
      return view.store->doubts[i8080_tests::place<test>(view)] != 0;
    } else if constexpr (of.kind == I8080Test::Kind::related) {
      const std::uint32_t apart = i8080_tests::value<of.left>(view) - i8080_tests::value<of.right>(view);
      return apart - difference_.first <= difference_.span;
    } else {
      return in_ranges<of.left>(view);
    }
  }
  // Programs that talk to ports all the time come here often.
  [[nodiscard]] SIGHTLINE_INLINE bool asks(i8080::Address next, const View& view) {
    if (view.store->places[next] == 0 && (nothing_ || (place_ != nullptr && view.store->doubts[place_(view)] == 0))) return false;
    return asks_all(next, view);
  }

 private:
  // What the registers are not to be is known from then on.
  [[nodiscard, gnu::noinline]] bool asks_all(i8080::Address next, const View& view) {
    if (Outlook::asks(next, view)) return true;
    if (place_ != nullptr) view.store->doubts[place_(view)] = 0;
    return false;
  }

  bool nothing_;  // is waited for but marked places
  PartRange difference_;
  i8080_tests::Place place_;
  std::uint16_t tested_;
};

}  // namespace sightline::guests::run
