#include <array>
#include <string_view>

#include "emulators/type340/words.hpp"
#include "host/base/number.hpp"
#include "tools/disasm/disasm.hpp"
#include "tools/disasm/source_lines.hpp"

namespace sightline::disassembler {
namespace {

using base::octal;
using core::Word18;
using type340::Mode;

// All numbers are octal, as in the word and in sources. A scale is shown as its setting 0 to 3 with its factor.
std::string number(unsigned value) {
  unsigned digits = 1;
  for (unsigned rest = value >> 3; rest != 0; rest >>= 3) ++digits;
  return octal(value, digits);
}
std::string pen_text(std::optional<bool> pen) {
  return !pen ? "" : *pen ? ", pen on" : ", pen off";
}
std::string next_text(Mode mode) {
  return ", then " + std::string(type340::layout_of(mode).name);
}

std::string parameter(Word18 word) {
  const auto w = type340::decode_parameter(word);
  std::string text = pen_text(w.pen);
  if (w.scale) text += ", scale " + std::to_string(*w.scale) + " (x" + std::to_string(1 << *w.scale) + ")";
  if (w.intensity) text += ", intensity " + std::to_string(*w.intensity);
  if (w.stop) return text + (w.interrupt ? ", stop and interrupt" : ", stop");
  return text + next_text(w.next);
}

std::string point(Word18 word) {
  const auto w = type340::decode_point(word);
  return (w.y ? ", y " : ", x ") + number(w.coordinate) + (w.intensify ? ", lit" : ", dark") +
         pen_text(w.pen) + next_text(w.next);
}

std::string slave(Word18 word) {
  const auto w = type340::decode_slave(word);
  std::string text;
  for (std::size_t i = 0; i < w.units.size(); ++i) {
    if (!w.units[i].set) continue;
    text += ", unit " + std::to_string(i + 1) + (w.units[i].on ? " on" : " off") +
            (w.units[i].pen ? " with pen" : "");
  }
  return text + next_text(w.next);
}

std::string character(std::uint8_t code) {
  switch (code) {
    case type340::code::line_feed: return "LF";
    case type340::code::carriage_return: return "CR";
    case type340::code::shift_in: return "SI";
    case type340::code::shift_out: return "SO";
    case type340::code::escape: return "escape";
    case type340::code::space: return "space";
    default: return std::string(1, static_cast<char>(code < 040 ? code + 0100 : code));
  }
}

std::string characters(Word18 word) {
  std::string text = ",";
  for (const std::uint8_t code : type340::decode_characters(word)) {
    text += " " + character(code);
    if (code == type340::code::escape) return text + next_text(Mode::parameter);  // the rest is ignored
  }
  return text;
}

std::string vector(Word18 word, Mode mode) {
  const auto w = type340::decode_vector(word);
  const auto component = [](bool negative, unsigned steps) {
    return (negative && steps != 0 ? "-" : "+") + number(steps);
  };
  const bool escapes = mode == Mode::vector && w.escape;
  return ", dx " + component(w.left, w.dx) + " dy " + component(w.down, w.dy) +
         (w.intensify ? ", lit" : ", dark") + (escapes ? next_text(Mode::parameter) : "");
}

std::string increment(Word18 word) {
  const auto w = type340::decode_increment(word);
  constexpr std::array<std::string_view, 3> across{"left", "", "right"};
  constexpr std::array<std::string_view, 3> along{"down", "", "up"};
  std::string text = ",";
  for (const type340::Direction move : w.moves) {
    text += " " + std::string(along[static_cast<std::size_t>(move.y + 1)]);
    if (move.x != 0 && move.y != 0) text += "-";
    text += across[static_cast<std::size_t>(move.x + 1)];
    if (!move.moves()) text += "rest";
  }
  return text + (w.intensify ? ", lit" : ", dark") + (w.escape ? next_text(Mode::parameter) : "");
}

std::string subroutine(Word18 word) {
  const auto w = type340::decode_subroutine(word);
  const std::string address = octal(w.address, 5);
  const std::string next = next_text(w.next);
  switch (w.operation) {
    case type340::SubroutineOperation::deposit: return ", DDS deposit return at " + address + next;
    case type340::SubroutineOperation::jump: return ", DJP jump to " + address + next;
    case type340::SubroutineOperation::jump_and_save: return ", DJS jump and save to " + address + next;
    case type340::SubroutineOperation::none: break;
  }
  return ", no operation" + next;
}

}  // namespace

std::string disassemble_display_word(Word18 word, Mode mode) {
  const std::string name(type340::layout_of(mode).name);
  switch (mode) {
    case Mode::parameter: return name + parameter(word);
    case Mode::point: return name + point(word);
    case Mode::slave: return name + slave(word);
    case Mode::character: return name + characters(word);
    case Mode::vector:
    case Mode::vector_continue: return name + vector(word, mode);
    case Mode::increment: return name + increment(word);
    case Mode::subroutine: break;
  }
  return name + subroutine(word);
}

std::string disassemble_type340(const image::CoreImage& image) {
  SourceLines lines;
  Mode mode = Mode::parameter;
  for (const auto& [address, word] : image.words) {
    if (lines.origin_if_needed(address)) mode = Mode::parameter;
    lines.add(octal(word.value(), 6), octal(address, 5) + " " + disassemble_display_word(word, mode));
    const auto after = type340::following(mode, word);
    mode = after.stops ? Mode::parameter : after.mode;
  }
  return lines.finish(image.start);
}

}  // namespace sightline::disassembler
