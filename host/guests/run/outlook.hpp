// What a monitor's marks and conditions leave of the boundaries between instructions: the same for every machine, which is named by
// a type of traits
//   using Address, View, Instant        of its bus; next boundaries are asked about with an Address or what stands for one
//   static constexpr std::size_t addresses;
//   static constexpr std::uint8_t anything;              all that an instruction can change: `change` of its isa.hpp
//   static constexpr std::array<std::uint8_t, n> parts;  those of it that are compared
//   template <std::uint8_t part> static std::uint32_t value(const View&);
//   static Part part_of(register number, pair);          where a register lies
//   static std::size_t program_counter;                  its number
//   static std::int64_t register_value(number, Address next, const View&);
//   static std::optional<std::int64_t> word(address, const View&);
//   static std::int64_t ticks(Instant);
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "emulators/core/inline.hpp"
#include "host/guests/run/condition.hpp"
#include "host/guests/run/probe.hpp"

namespace sightline::guests::run {

// Where a register lies: in the part `change` of the processor, so many bits up.
struct Part {
  std::uint8_t change = 0;  // 0: nowhere that an instruction changes
  unsigned shift = 0;
  std::uint32_t mask = 0;  // of the register, not shifted
};

// A range of one part.
struct PartRange {
  std::uint32_t mask = 0;
  std::uint32_t first = 1;  // nothing is in it
  std::uint32_t span = 0;

  [[nodiscard]] SIGHTLINE_INLINE bool has(std::uint32_t value) const { return (value & mask) - first <= span; }
  static constexpr PartRange all() { return {0, 0, 0}; }
  // Where it differs from `value` in the bits of the mask.
  static constexpr PartRange other_than(std::uint32_t value, std::uint32_t mask) { return {mask, (value & mask) + 1, ~std::uint32_t{0} - 1}; }
  friend bool operator==(const PartRange& a, const PartRange& b) { return a.mask == b.mask && a.first == b.first && a.span == b.span; }
};

// When an instruction that may have changed a part is followed by a question.
struct PartWatch {
  enum class Kind : std::uint8_t {
    never,
    in_range,
    related,  // in a range that follows another register; the left one of the relation is in the part
    changed,  // in a bit of range.mask, since the last question
    always
  };
  Kind kind = Kind::never;
  PartRange range;
  Relation relation = {};
};

// The range of a register as one of its part; all of it where it cannot be said so.
[[nodiscard]] inline PartRange range_of_part(const Condition::Range& range, const Part& part) {
  const auto [first, span] = range.values;
  const std::uint32_t mask = part.mask & range.of.mask;
  if (mask == 0) return PartRange::all();
  if (part.shift == 0) return {mask, first, span};
  // What is compared lies higher up, and only values of the register do. What is left out lies between these.
  const std::uint32_t left_out = first + span + 1, up_to = first - 1;
  const bool around = left_out <= up_to;
  if (first > part.mask || (around && left_out > part.mask)) return PartRange::all();
  const std::uint32_t last = around ? (left_out << part.shift) - 1 : std::min(part.mask, first + span) << part.shift;
  return {mask << part.shift, first << part.shift, last - (first << part.shift)};
}

// The sets of all addresses: bit 0 where the run is to ask in any case, the others what an instruction before it may have changed.
template <class Machine>
class OutlookTable {
 public:
  static constexpr std::size_t parts = Machine::parts.size();

  explicit OutlookTable(const Probe& probe) : places_(Machine::addresses) {
    std::uint8_t everywhere = 0;
    for (const Condition& condition : probe.conditions()) everywhere |= add(condition);
    const std::uint8_t* const marks = probe.marks();
    // Eight at a time.
    constexpr std::uint64_t ones = 0x0101'0101'0101'0101U;
    static_assert(Machine::addresses % sizeof ones == 0);
    for (std::size_t n = 0; n < Machine::addresses; n += sizeof ones) {
      std::uint64_t marked = 0, found = 0;
      std::memcpy(&marked, marks + n, sizeof marked);
      std::memcpy(&found, &places_[n], sizeof found);
      found |= (marked & (ones * Probe::executed)) | ones * everywhere;
      std::memcpy(&places_[n], &found, sizeof found);
    }
    everywhere_ = everywhere;
  }
  // What is in the sets of all addresses.
  [[nodiscard]] std::uint8_t everywhere() const { return everywhere_; }
  [[nodiscard]] const std::uint8_t* places() const { return places_.data(); }
  [[nodiscard]] const std::array<PartWatch, parts>& watches() const { return watches_; }

 private:
  // What is asked for at every address.
  std::uint8_t add(const Condition& condition) {
    if (condition.time) return Probe::executed;
    const auto& range = condition.range;
    if (range && range->of.number == Machine::program_counter) {
      for (std::uint32_t n = 0; n < Machine::addresses; ++n)
        if ((n & range->of.mask) - range->values.first <= range->values.span) places_[n] |= Probe::executed;
      return 0;
    }
    std::uint8_t everywhere = condition.words ? Machine::memory : 0;
    for (const std::size_t number : condition.registers) {
      if (number == Machine::program_counter) return Probe::executed;
      everywhere |= Machine::part_of(number, false).change;
    }
    // Whatever changes in the part of the register that has a range, it is compared then.
    const Part compared = range ? Machine::part_of(range->of.number, range->of.pair) : Part{};
    const auto relation = relation_of(condition);
    for (std::size_t n = 0; n < parts; ++n) {
      if ((everywhere & Machine::parts[n]) == 0) continue;
      PartWatch watch = change_of(condition, n);
      if (Machine::parts[n] == compared.change) watch = {PartWatch::Kind::in_range, range_of_part(*range, compared)};
      if (relation && part_number(relation->left) == n) {
        watch.kind = PartWatch::Kind::related;
        watch.relation = *relation;
      }
      add(watches_[n], watch);
    }
    return everywhere;
  }
  static std::size_t part_number(const MaskedRegister& of) {
    const auto* const at = std::find(Machine::parts.begin(), Machine::parts.end(), Machine::part_of(of.number, of.pair).change);
    return static_cast<std::size_t>(at - Machine::parts.begin());
  }
  // The part that comes first is compared with a range that follows the register in the other.
  static std::optional<Relation> relation_of(const Condition& condition) {
    if (!condition.relation) return std::nullopt;
    Relation relation = *condition.relation;
    if (condition.is_true) relation.sign = opposite(relation.sign);
    const std::size_t left = part_number(relation.left), right = part_number(relation.right);
    if (left == right || left == parts || right == parts) return std::nullopt;
    if (left > right) relation = {relation.right, turned(relation.sign), relation.left, -relation.offset};
    return relation;
  }
  static PartWatch change_of(const Condition& condition, std::size_t n) {
    PartWatch watch{PartWatch::Kind::changed, {}};
    watch.range.mask = 0;
    for (const std::size_t number : condition.registers) {
      const Part part = Machine::part_of(number, false);
      if (part.change != Machine::parts[n]) continue;
      if (part.mask == 0) watch.kind = PartWatch::Kind::always;
      watch.range.mask |= part.mask << part.shift;
    }
    return watch;
  }
  static void add(PartWatch& watch, const PartWatch& by) {
    using Kind = PartWatch::Kind;
    if (watch.kind == Kind::never) {
      watch = by;
    } else if (watch.kind == Kind::always || by.kind == Kind::always) {
      watch.kind = Kind::always;
    } else if (watch.kind != Kind::in_range || by.kind != Kind::in_range || !(watch.range == by.range)) {
      watch.kind = Kind::changed;
      watch.range.mask |= by.range.mask;
    }
  }

  std::vector<std::uint8_t> places_;
  std::uint8_t everywhere_ = 0;
  std::array<PartWatch, parts> watches_{};
};

// The value that a run keeps beside its registers.
template <class Machine>
class Outlook {
 public:
  using View = typename Machine::View;

  // Both outlive it.
  Outlook(const OutlookTable<Machine>& table, const Probe& probe)
      : table_(&table), marks_(probe.marks()), conditions_(&probe.conditions()) {
    for (const Condition& condition : probe.conditions()) by_look_ = by_look_ || condition.steps.empty();
    for (std::size_t n = 0; n < parts; ++n) {
      const PartWatch& watch = table.watches()[n];
      if (watch.kind == PartWatch::Kind::in_range) ranges_[n] = watch.range;
      else if (watch.kind != PartWatch::Kind::never) ranges_[n] = PartRange::all();
    }
  }

  [[nodiscard, gnu::noinline]] bool asks(typename Machine::Address next, const View& view) {
    if (by_look_ || (marks_[next] & Probe::executed) != 0) return true;
    const Values values{next, view};
    for (const Condition& condition : *conditions_)
      if (is_true(condition, values) != condition.is_true) return true;
    follow(values);
    return false;
  }
  // Whether one of those parts is where the run is to ask.
  template <unsigned changes>
  [[nodiscard]] SIGHTLINE_INLINE bool in_range(const View& view) const {
    return in_range<changes>(view, std::make_index_sequence<parts>());
  }

 protected:
  // Of the parts in a set, by their places in Machine::parts.
  template <unsigned set>
  [[nodiscard]] SIGHTLINE_INLINE bool in_ranges(const View& view) const {
    return any_in_range<set>(view, std::make_index_sequence<parts>());
  }

 private:
  struct Values {
    typename Machine::Address next;
    const View& view;
    static std::int64_t name(std::size_t) { return 0; }
    [[nodiscard]] std::int64_t register_value(std::size_t number) const { return Machine::register_value(number, next, view); }
    [[nodiscard]] std::int64_t register_pair(std::size_t number) const {
      return Machine::register_value(number, next, view) << 8 | Machine::register_value(number + 1, next, view);
    }
    [[nodiscard]] std::int64_t time() const { return Machine::ticks(view.now); }
    [[nodiscard]] std::optional<std::int64_t> word(std::int64_t address) const { return Machine::word(address, view); }
  };

  static constexpr std::size_t parts = Machine::parts.size();

  [[nodiscard]] static std::int64_t value(const MaskedRegister& of, const Values& values) {
    return (of.pair ? values.register_pair(of.number) : values.register_value(of.number)) & std::int64_t{of.mask};
  }
  [[nodiscard]] static bool is_true(const Condition& condition, const Values& values) {
    if (condition.relation) {
      const Relation& relation = *condition.relation;
      return *applied(relation.sign, value(relation.left, values), value(relation.right, values) + relation.offset) != 0;
    }
    const auto found = value_of(condition.steps, values);
    return !found || *found != 0;
  }
  void follow(const Values& values) { follow_parts(values, std::make_index_sequence<parts>()); }
  template <std::size_t... n>
  void follow_parts(const Values& values, std::index_sequence<n...>) {
    (follow_part(ranges_[n], table_->watches()[n], Machine::template value<Machine::parts[n]>(values.view), values), ...);
  }
  static void follow_part(PartRange& range, const PartWatch& watch, std::uint32_t now, const Values& values) {
    if (watch.kind == PartWatch::Kind::changed) range = PartRange::other_than(now, watch.range.mask);
    if (watch.kind != PartWatch::Kind::related) return;
    const Relation& relation = watch.relation;
    const MaskedRegister& left = relation.left;
    const std::int64_t constant = value(relation.right, values) + relation.offset;
    const auto where = range_where(relation.sign, constant);
    // Registers are not negative.
    const bool never = constant < 0 ? relation.sign == Sign::equal || relation.sign == Sign::less || relation.sign == Sign::at_most
                                    : constant == 0 && relation.sign == Sign::less;
    if (never) range = PartRange{};
    else range = where ? range_of_part({left, *where}, Machine::part_of(left.number, left.pair)) : PartRange::all();
  }

  template <unsigned changes, std::size_t... n>
  [[nodiscard]] SIGHTLINE_INLINE bool in_range(const View& view, std::index_sequence<n...>) const {
    return (part_in_range<changes, n>(view) || ...);
  }
  template <unsigned set, std::size_t... n>
  [[nodiscard]] SIGHTLINE_INLINE bool any_in_range(const View& view, std::index_sequence<n...>) const {
    return ((((set >> n) & 1U) != 0 && ranges_[n].has(Machine::template value<Machine::parts[n]>(view))) || ...);
  }
  // Nothing is in the range of a part that is not asked for.
  template <unsigned changes, std::size_t n>
  [[nodiscard]] SIGHTLINE_INLINE bool part_in_range([[maybe_unused]] const View& view) const {
    constexpr std::uint8_t part = Machine::parts[n];
    if constexpr ((changes & part) != 0) return ranges_[n].has(Machine::template value<part>(view));
    else return false;
  }

  std::array<PartRange, parts> ranges_{};
  const OutlookTable<Machine>* table_;
  const std::uint8_t* marks_;
  const std::vector<Condition>* conditions_;
  bool by_look_ = false;
};

// The observer of a monitor that has marked instructions or waits for conditions: it is asked between instructions.
template <class Machine>
class Looker {
 public:
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = true;
  using Look = Outlook<Machine>;
  using Instant = typename Machine::Instant;

  explicit Looker(Probe& probe) : probe_(probe), table_(probe) {}
  [[nodiscard]] Look look() const { return Look(table_, probe_); }

  // A run begins here: an instruction at this place is passed over.
  void begin(Instant now) {
    begun_ = now;
    told_ = !probe_.events().empty();
  }
  [[gnu::noinline]] bool stop(Instant now, typename Machine::Address next) {
    if (now == begun_) return told_;
    if ((probe_.marks()[next] & Probe::executed) != 0) add(Probe::Kind::execution, now, next, 0);
    if (probe_.look && probe_.look()) add(Probe::Kind::look, now, next, 0);
    return told_;
  }
  [[nodiscard]] bool told() const { return told_; }

 protected:
  void add(Probe::Kind kind, Instant time, std::uint32_t address, std::uint32_t value) {
    probe_.add({kind, Machine::ticks(time), address, value});
    told_ = true;
  }
  [[nodiscard]] Probe& probe() const { return probe_; }
  [[nodiscard]] const OutlookTable<Machine>& table() const { return table_; }

 private:
  Probe& probe_;
  OutlookTable<Machine> table_;
  Instant begun_{};
  bool told_ = false;
};

}  // namespace sightline::guests::run
