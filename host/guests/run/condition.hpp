// Conditions of a monitor as programs for a small stack machine, which a run evaluates between two instructions without being left.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sightline::guests::run {

enum class Sign : std::uint8_t {
  either, both, equal, unequal, shift_left, shift_right, at_most, at_least, bit_or, bit_xor, bit_and, less, more, plus, minus, times, divide, remainder
};

// Arithmetic is that of 64 bits, without overflow (it wraps around). Nothing: a division by 0.
[[nodiscard]] constexpr std::optional<std::int64_t> applied(Sign sign, std::int64_t a, std::int64_t b) {
  const auto x = static_cast<std::uint64_t>(a);
  const auto y = static_cast<std::uint64_t>(b);
  const auto wrapped = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
  switch (sign) {
    case Sign::either: return a != 0 || b != 0 ? 1 : 0;
    case Sign::both: return a != 0 && b != 0 ? 1 : 0;
    case Sign::bit_or: return a | b;
    case Sign::bit_xor: return a ^ b;
    case Sign::bit_and: return a & b;
    case Sign::equal: return a == b ? 1 : 0;
    case Sign::unequal: return a != b ? 1 : 0;
    case Sign::at_most: return a <= b ? 1 : 0;
    case Sign::at_least: return a >= b ? 1 : 0;
    case Sign::less: return a < b ? 1 : 0;
    case Sign::more: return a > b ? 1 : 0;
    case Sign::shift_left: return b < 0 || b > 63 ? 0 : wrapped(x << y);
    case Sign::shift_right: return b < 0 || b > 63 ? 0 : wrapped(x >> y);
    case Sign::plus: return wrapped(x + y);
    case Sign::minus: return wrapped(x - y);
    case Sign::times: return wrapped(x * y);
    case Sign::divide:
    case Sign::remainder: break;
  }
  if (b == 0) return std::nullopt;
  if (b == -1) return sign == Sign::divide ? wrapped(std::uint64_t{0} - x) : 0;
  return sign == Sign::divide ? a / b : a % b;
}

struct ConditionStep {
  enum class Kind : std::uint8_t {
    number,
    name,  // of something that changes, by its number among those of the expression
    register_value,
    register_pair,  // of the 8080, by the number of the high half
    time,           // in the machine's unit
    word,           // of memory, whose address is on the stack
    negative,
    complement,
    no,
    binary
  };
  // The right operand of a binary step: on the stack, or `number`, or the register of that number.
  enum class Operand : std::uint8_t { stack, number, register_value };
  Kind kind = Kind::number;
  Sign sign = Sign::either;
  std::int64_t number = 0;
  Operand operand = Operand::stack;

  friend bool operator==(const ConditionStep&, const ConditionStep&) = default;
};

// The same program with constants and registers as operands of the steps behind them.
[[nodiscard]] inline std::vector<ConditionStep> fused(std::span<const ConditionStep> steps) {
  using Kind = ConditionStep::Kind;
  using Operand = ConditionStep::Operand;
  std::vector<ConditionStep> made;
  for (const ConditionStep& step : steps) {
    const bool by_number = step.kind == Kind::binary && made.back().kind == Kind::number;
    const bool by_register = step.kind == Kind::binary && made.back().kind == Kind::register_value;
    if (by_number || by_register) {
      made.back() = {Kind::binary, step.sign, made.back().number, by_number ? Operand::number : Operand::register_value};
    } else {
      made.push_back(step);
    }
  }
  return made;
}

// Operands come before their operator. `values` has name(n), register_value(n), register_pair(n), time() and word(address), which gives
// nothing where there is no such word. Nothing: a division by 0, or no such word.
template <class Values>
[[nodiscard]] std::optional<std::int64_t> value_of(std::span<const ConditionStep> steps, const Values& values) {
  constexpr std::size_t usual = 64;
  std::array<std::int64_t, usual> small;
  std::vector<std::int64_t> large;
  if (steps.size() > usual) large.resize(steps.size());
  std::int64_t* const stack = large.empty() ? small.data() : large.data();
  std::size_t top = 0;
  for (const ConditionStep& step : steps) {
    switch (step.kind) {
      case ConditionStep::Kind::number: stack[top++] = step.number; break;
      case ConditionStep::Kind::name: stack[top++] = values.name(static_cast<std::size_t>(step.number)); break;
      case ConditionStep::Kind::register_value: stack[top++] = values.register_value(static_cast<std::size_t>(step.number)); break;
      case ConditionStep::Kind::register_pair: stack[top++] = values.register_pair(static_cast<std::size_t>(step.number)); break;
      case ConditionStep::Kind::time: stack[top++] = values.time(); break;
      case ConditionStep::Kind::word: {
        const auto word = values.word(stack[top - 1]);
        if (!word) return std::nullopt;
        stack[top - 1] = *word;
        break;
      }
      case ConditionStep::Kind::negative:
        stack[top - 1] = static_cast<std::int64_t>(std::uint64_t{0} - static_cast<std::uint64_t>(stack[top - 1]));
        break;
      case ConditionStep::Kind::complement: stack[top - 1] = ~stack[top - 1]; break;
      case ConditionStep::Kind::no: stack[top - 1] = stack[top - 1] == 0 ? 1 : 0; break;
      case ConditionStep::Kind::binary: {
        std::int64_t right = step.number;
        if (step.operand == ConditionStep::Operand::stack) right = stack[--top];
        else if (step.operand == ConditionStep::Operand::register_value) right = values.register_value(static_cast<std::size_t>(right));
        const auto result = applied(step.sign, stack[top - 1], right);
        if (!result) return std::nullopt;
        stack[top - 1] = *result;
        break;
      }
    }
  }
  return stack[0];
}

// value - first <= span in 32 bits, where the value is one of a register.
struct ValueRange {
  std::uint32_t first = 0;
  std::uint32_t span = ~std::uint32_t{0};

  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

// Where VALUE sign CONSTANT is true; nothing: it cannot be said so.
[[nodiscard]] constexpr std::optional<ValueRange> range_where(Sign sign, std::int64_t constant) {
  constexpr std::uint32_t all_ones = ~std::uint32_t{0};
  if (constant < 0 || constant > std::int64_t{all_ones} - 1) return std::nullopt;
  const auto c = static_cast<std::uint32_t>(constant);
  switch (sign) {
    case Sign::equal: return ValueRange{c, 0};
    case Sign::unequal: return ValueRange{c + 1, all_ones - 1};
    case Sign::less: return c == 0 ? std::nullopt : std::optional(ValueRange{0, c - 1});
    case Sign::at_most: return ValueRange{0, c};
    case Sign::more: return ValueRange{c + 1, all_ones - (c + 1)};
    case Sign::at_least: return ValueRange{c, all_ones - c};
    default: return std::nullopt;
  }
}

// Of a comparison, with its sides exchanged; and of its opposite.
[[nodiscard]] constexpr Sign turned(Sign sign) {
  switch (sign) {
    case Sign::less: return Sign::more;
    case Sign::more: return Sign::less;
    case Sign::at_most: return Sign::at_least;
    case Sign::at_least: return Sign::at_most;
    default: return sign;
  }
}
[[nodiscard]] constexpr Sign opposite(Sign sign) {
  switch (sign) {
    case Sign::equal: return Sign::unequal;
    case Sign::unequal: return Sign::equal;
    case Sign::less: return Sign::at_least;
    case Sign::more: return Sign::at_most;
    case Sign::at_most: return Sign::more;
    case Sign::at_least: return Sign::less;
    default: return sign;
  }
}

// A register with a mask. A pair of the 8080 has the number of its high half.
struct MaskedRegister {
  std::size_t number = 0;
  bool pair = false;
  std::uint32_t mask = ~std::uint32_t{0};

  friend bool operator==(const MaskedRegister&, const MaskedRegister&) = default;
};

// left sign right + offset: the whole of a condition on two registers.
struct Relation {
  MaskedRegister left;
  Sign sign = Sign::equal;
  MaskedRegister right;
  std::int64_t offset = 0;

  friend bool operator==(const Relation&, const Relation&) = default;
};

// A condition that a run waits for.
struct Condition {
  // It is waited for to become true, or to become false again. One without a value counts as true.
  bool is_true = false;
  std::vector<ConditionStep> steps;  // without names; empty: only Probe::look can evaluate it
  // What can change it: registers by their numbers, words of memory, flags of devices, time.
  std::vector<std::size_t> registers;
  bool words = false;
  bool devices = false;
  bool time = false;
  // When it changes, the register is in this range; nothing: it may have any value.
  struct Range {
    MaskedRegister of;
    ValueRange values;

    friend bool operator==(const Range&, const Range&) = default;
  };
  std::optional<Range> range;
  std::optional<Relation> relation;

  friend bool operator==(const Condition&, const Condition&) = default;
};

}  // namespace sightline::guests::run
