// The display words of the Type 340: one table that the display processor, the disassembler and the tests read.
//
// The meaning of a word depends on the mode set by the word before it. `layouts` has one row for each of the eight modes,
// naming every bit; the decoders below turn a word into numbers. Left out: timing (delays.hpp) and the effects of the words
// (registers.hpp).
//
// Sources: DECUS 7-13 "340 Display Programming Manual"; DEC-4-45-M "370 Light Pen Diagnostic" (1964) and the PIXIE
// listing (Cambridge 1972), whose words use modes 0, 1, 3, 4 and 7 as here. Bit 0 is the most significant.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "../core/word.hpp"

namespace sightline::type340 {

enum class Mode : std::uint8_t {
  parameter, point, slave, character, vector, vector_continue, increment, subroutine,
};

enum class FieldKind : std::uint8_t {
  unused,
  flag,       // one bit; the meaning holds when it is 1
  number,     // unsigned
  mode,       // next mode, 0-7
  character,  // six-bit code
  move,       // increment: 10 x, 04 left, 02 y, 01 down (octal)
  unit,       // slave: 4 set, 2 light pen on, 1 on (octal)
  address,
};

struct Field {
  std::string_view name;
  std::uint8_t first;  // DEC bit numbers, both included
  std::uint8_t last;
  FieldKind kind;
  std::string_view meaning;
};

struct Layout {
  Mode mode;
  std::string_view name;
  std::span<const Field> fields;  // from bit 0 to bit 17, every bit once
  std::string_view option;        // the option that the word needs, without which it hangs the display; empty: none
};

namespace detail {

using enum FieldKind;

inline constexpr std::array parameter_fields{
    Field{"unused", 0, 1, unused, ""},
    Field{"mode", 2, 4, mode, "next mode"},
    Field{"load pen", 5, 5, flag, "load light-pen enable"},
    Field{"pen", 6, 6, flag, "light pen enabled"},
    Field{"stop", 7, 7, flag, "stop"},
    Field{"interrupt", 8, 8, flag, "stop interrupts"},
    Field{"unused", 9, 10, unused, ""},
    Field{"load scale", 11, 11, flag, "load scale"},
    Field{"scale", 12, 13, number, "steps of 1, 2, 4, 8 points"},
    Field{"load intensity", 14, 14, flag, "load intensity"},
    Field{"intensity", 15, 17, number, "0 to 7 brightest"},
};
inline constexpr std::array point_fields{
    Field{"unused", 0, 0, unused, ""},
    Field{"y", 1, 1, flag, "coordinate is Y, else X"},
    Field{"mode", 2, 4, mode, "next mode"},
    Field{"load pen", 5, 5, flag, "load light-pen enable"},
    Field{"pen", 6, 6, flag, "light pen enabled"},
    Field{"intensify", 7, 7, flag, "lit"},
    Field{"coordinate", 8, 17, number, "absolute, in points"},
};
inline constexpr std::array slave_fields{
    Field{"unused", 0, 1, unused, ""},
    Field{"mode", 2, 4, mode, "next mode"},
    Field{"unused", 5, 5, unused, ""},
    Field{"unit 1", 6, 8, unit, "slave unit"},
    Field{"unit 2", 9, 11, unit, "slave unit"},
    Field{"unit 3", 12, 14, unit, "slave unit"},
    Field{"unit 4", 15, 17, unit, "slave unit"},
};
inline constexpr std::array character_fields{
    Field{"first", 0, 5, character, ""},
    Field{"second", 6, 11, character, ""},
    Field{"third", 12, 17, character, ""},
};
inline constexpr std::array vector_fields{
    Field{"escape", 0, 0, flag, "mode 0 after this word"},
    Field{"intensify", 1, 1, flag, "lit"},
    Field{"down", 2, 2, flag, "dy is negative"},
    Field{"dy", 3, 9, number, "steps"},
    Field{"left", 10, 10, flag, "dx is negative"},
    Field{"dx", 11, 17, number, "steps"},
};
inline constexpr std::array vector_continue_fields{
    Field{"unused", 0, 0, unused, ""},
    Field{"intensify", 1, 1, flag, "lit"},
    Field{"down", 2, 2, flag, "dy is negative"},
    Field{"dy", 3, 9, number, "steps"},
    Field{"left", 10, 10, flag, "dx is negative"},
    Field{"dx", 11, 17, number, "steps"},
};
inline constexpr std::array increment_fields{
    Field{"escape", 0, 0, flag, "mode 0 after this word"},
    Field{"intensify", 1, 1, flag, "lit"},
    Field{"first", 2, 5, move, ""},
    Field{"second", 6, 9, move, ""},
    Field{"third", 10, 13, move, ""},
    Field{"fourth", 14, 17, move, ""},
};
inline constexpr std::array subroutine_fields{
    Field{"operation", 0, 1, number, "2 DJP jump, 3 DJS jump and save, 1 DDS deposit return"},
    Field{"mode", 2, 4, mode, "next mode"},
    Field{"address", 5, 17, address, "in core"},
};

}  // namespace detail

inline constexpr std::array<Layout, 8> layouts{
    Layout{Mode::parameter, "parameter", detail::parameter_fields, ""},
    Layout{Mode::point, "point", detail::point_fields, ""},
    Layout{Mode::slave, "slave", detail::slave_fields, "Type 343"},
    Layout{Mode::character, "character", detail::character_fields, "Type 342"},
    Layout{Mode::vector, "vector", detail::vector_fields, ""},
    Layout{Mode::vector_continue, "vector continue", detail::vector_continue_fields, ""},
    Layout{Mode::increment, "increment", detail::increment_fields, ""},
    Layout{Mode::subroutine, "subroutine", detail::subroutine_fields, "Type 347"},
};

[[nodiscard]] constexpr const Layout& layout_of(Mode mode) { return layouts[static_cast<std::size_t>(mode)]; }

namespace detail {

[[nodiscard]] constexpr bool every_bit_is_named_once() {
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    if (static_cast<std::size_t>(layouts[i].mode) != i) return false;
    unsigned next = 0;
    for (const Field& field : layouts[i].fields) {
      if (field.first != next || field.last < field.first) return false;
      next = field.last + 1U;
    }
    if (next != core::Word18::bits) return false;
  }
  return true;
}

}  // namespace detail

static_assert(detail::every_bit_is_named_once());

struct ParameterWord {
  Mode next;
  std::optional<bool> pen;                // load light-pen enable
  bool stop;
  bool interrupt;                         // matters only with stop
  std::optional<std::uint8_t> scale;      // 0..3: a step is 1 << scale points
  std::optional<std::uint8_t> intensity;  // 0..7
};

[[nodiscard]] constexpr std::optional<bool> pen_of(core::Word18 w) {
  return w.bit(5) ? std::optional(w.bit(6)) : std::nullopt;
}

[[nodiscard]] constexpr ParameterWord decode_parameter(core::Word18 w) {
  using Small = std::optional<std::uint8_t>;
  return {.next = static_cast<Mode>(w.field(2, 4)),
          .pen = pen_of(w),
          .stop = w.bit(7),
          .interrupt = w.bit(8),
          .scale = w.bit(11) ? Small(static_cast<std::uint8_t>(w.field(12, 13))) : std::nullopt,
          .intensity = w.bit(14) ? Small(static_cast<std::uint8_t>(w.field(15, 17))) : std::nullopt};
}

struct PointWord {
  bool y;  // the coordinate is Y, else X
  Mode next;
  std::optional<bool> pen;
  bool intensify;
  std::uint16_t coordinate;  // 0..1023
};

[[nodiscard]] constexpr PointWord decode_point(core::Word18 w) {
  return {.y = w.bit(1),
          .next = static_cast<Mode>(w.field(2, 4)),
          .pen = pen_of(w),
          .intensify = w.bit(7),
          .coordinate = static_cast<std::uint16_t>(w.field(8, 17))};
}

// The part of one Type 343 slave unit, 1 to 4.
struct SlaveUnit {
  bool set;  // false: the unit is left unchanged
  bool on;
  bool pen;
};

struct SlaveWord {
  Mode next;
  std::array<SlaveUnit, 4> units;
};

[[nodiscard]] constexpr SlaveWord decode_slave(core::Word18 w) {
  SlaveWord word{static_cast<Mode>(w.field(2, 4)), {}};
  for (unsigned i = 0; i < 4; ++i) word.units[i] = {w.bit(6 + 3 * i), w.bit(8 + 3 * i), w.bit(7 + 3 * i)};
  return word;
}

// Six-bit codes of the Type 342 (DEC trimmed ASCII, except these).
namespace code {
inline constexpr std::uint8_t line_feed = 033;
inline constexpr std::uint8_t carriage_return = 034;
inline constexpr std::uint8_t shift_in = 035;
inline constexpr std::uint8_t shift_out = 036;
inline constexpr std::uint8_t escape = 037;
inline constexpr std::uint8_t space = 040;
}  // namespace code

[[nodiscard]] constexpr std::array<std::uint8_t, 3> decode_characters(core::Word18 w) {
  return {static_cast<std::uint8_t>(w.field(0, 5)), static_cast<std::uint8_t>(w.field(6, 11)),
          static_cast<std::uint8_t>(w.field(12, 17))};
}

// Vector and vector continue; sign and magnitude, in steps.
struct VectorWord {
  bool escape;  // no effect in vector continue
  bool intensify;
  bool down;
  std::uint8_t dy;  // 0..127
  bool left;
  std::uint8_t dx;  // 0..127
};

[[nodiscard]] constexpr VectorWord decode_vector(core::Word18 w) {
  return {.escape = w.bit(0),
          .intensify = w.bit(1),
          .down = w.bit(2),
          .dy = static_cast<std::uint8_t>(w.field(3, 9)),
          .left = w.bit(10),
          .dx = static_cast<std::uint8_t>(w.field(11, 17))};
}

// One step of a beam: -1, 0 or 1 each, right and up positive.
struct Direction {
  std::int8_t x = 0;
  std::int8_t y = 0;
  [[nodiscard]] constexpr bool moves() const { return x != 0 || y != 0; }
  friend constexpr bool operator==(Direction, Direction) = default;
};

[[nodiscard]] constexpr Direction direction_of_move(std::uint32_t four_bits) {
  Direction d;
  if ((four_bits & 010U) != 0) d.x = (four_bits & 04U) != 0 ? -1 : 1;
  if ((four_bits & 02U) != 0) d.y = (four_bits & 01U) != 0 ? -1 : 1;
  return d;
}

struct IncrementWord {
  bool escape;
  bool intensify;
  std::array<Direction, 4> moves;
};

[[nodiscard]] constexpr IncrementWord decode_increment(core::Word18 w) {
  return {.escape = w.bit(0),
          .intensify = w.bit(1),
          .moves = {direction_of_move(w.field(2, 5)), direction_of_move(w.field(6, 9)),
                    direction_of_move(w.field(10, 13)), direction_of_move(w.field(14, 17))}};
}

enum class SubroutineOperation : std::uint8_t { none, deposit, jump, jump_and_save };

struct SubroutineWord {
  SubroutineOperation operation;
  Mode next;
  std::uint16_t address;  // 13 bits
};

[[nodiscard]] constexpr SubroutineWord decode_subroutine(core::Word18 w) {
  return {static_cast<SubroutineOperation>(w.field(0, 1)), static_cast<Mode>(w.field(2, 4)),
          static_cast<std::uint16_t>(w.field(5, 17))};
}

// What follows a word in a display file that is read without running it: the mode of the next word, or that there is none.
// Vector continue is assumed to reach its edge; a jump, to continue in the mode it names.
struct Following {
  Mode mode;
  bool stops;
};

[[nodiscard]] constexpr Following following(Mode mode, core::Word18 w) {
  switch (mode) {
    case Mode::parameter: return {decode_parameter(w).next, decode_parameter(w).stop};
    case Mode::vector: return {w.bit(0) ? Mode::parameter : mode, false};
    case Mode::increment: return {w.bit(0) ? Mode::parameter : mode, false};
    case Mode::vector_continue: return {Mode::parameter, false};
    case Mode::character:
      for (const std::uint8_t c : decode_characters(w)) {
        if (c == code::escape) return {Mode::parameter, false};
      }
      return {mode, false};
    case Mode::point:
    case Mode::slave:
    case Mode::subroutine: break;
  }
  return {static_cast<Mode>(w.field(2, 4)), false};
}

}  // namespace sightline::type340
