#include <algorithm>
#include <bit>
#include <optional>
#include <string_view>
#include <vector>

#include "emulators/machines/pdp7_devices.hpp"
#include "emulators/pdp7/isa.hpp"
#include "host/base/number.hpp"
#include "tools/disasm/disasm.hpp"
#include "tools/disasm/source_lines.hpp"

namespace sightline::disassembler {
namespace {

using base::octal;
using pdp7::Class;
using pdp7::Microinstruction;

constexpr std::uint32_t step_count_mask = 077;
constexpr std::uint32_t command_mask = 0700;  // of the EAE
constexpr std::uint32_t rotates = 0000030;
constexpr std::uint32_t rotate_twice = 0002000;
constexpr std::uint32_t skips = 0001700;
constexpr std::uint32_t skip_inverted = 0001000;
constexpr std::uint32_t halt = 0000040;

std::string short_octal(std::uint32_t value) {
  const unsigned digits = (static_cast<unsigned>(std::bit_width(value)) + 2) / 3;
  return octal(value, std::max(digits, 1U));
}

// The bits that all words of the class have in common.
std::uint32_t class_bits(Class c) {
  return c == Class::opr ? 0740000U : c == Class::eae ? 0640000U : 0700000U;
}

// True if `name` is part of `word` and does not change the meaning of the other bits.
bool is_part_of(std::uint32_t name, std::uint32_t word, Class c) {
  if ((name & ~word) != 0) return false;
  if (c != Class::opr) return true;
  if ((name & skips) != 0 && ((name ^ word) & skip_inverted) != 0) return false;
  return (name & rotates) == 0 || ((name ^ word) & rotate_twice) == 0;
}

// Skips first and HLT last, in the order in which the machine acts; the others from the high bits down.
std::uint32_t action_order(std::uint32_t name, Class c) {
  if (c != Class::opr) return name;
  const std::uint32_t bits = name & ~class_bits(c);
  return (bits & skips) != 0 ? 0100000U + bits : bits == halt ? 0U : bits;
}

// The fewest names whose OR is the word: each step takes the name that adds most bits.
std::vector<const Microinstruction*> names_of(std::uint32_t word, Class c) {
  std::vector<const Microinstruction*> names;
  for (std::uint32_t covered = class_bits(c); covered != word;) {
    const Microinstruction* best = nullptr;
    int most = 0;
    for (const Microinstruction& micro : pdp7::microinstructions) {
      if (pdp7::instruction_of(micro.value).instruction_class != c || !is_part_of(micro.value, word, c))
        continue;
      const int added = std::popcount(micro.value & ~covered);
      if (added > most) {
        best = &micro;
        most = added;
      }
    }
    if (best == nullptr) return {};
    names.push_back(best);
    covered |= best->value;
  }
  std::sort(names.begin(), names.end(), [c](const auto* a, const auto* b) {
    return action_order(a->value, c) > action_order(b->value, c);
  });
  return names;
}

std::string join_names(const std::vector<const Microinstruction*>& names) {
  std::string text;
  for (const Microinstruction* micro : names) text += (text.empty() ? "" : " ") + std::string(micro->name);
  return text;
}

std::optional<std::string> exact_name(std::uint32_t word) {
  for (const Microinstruction& micro : pdp7::microinstructions) {
    if (micro.value == word) return std::string(micro.name);
  }
  for (const auto& device : pdp7::device_infos) {
    for (const core::IotName& iot : device.iots)
      if (iot.word == word) return std::string(iot.mnemonic);
  }
  return std::nullopt;
}

// The names of multiply, divide and normalise include their usual step count: mul-11 is a multiplication of nine steps.
std::optional<std::string> changed_count(std::uint32_t word) {
  for (const Microinstruction& micro : pdp7::microinstructions) {
    if ((micro.value & step_count_mask) == 0 || (micro.value & command_mask) == 0) continue;
    if ((micro.value ^ word) & ~step_count_mask) continue;
    const bool less = word < micro.value;
    return std::string(micro.name) + (less ? "-" : "+") +
           short_octal(less ? micro.value - word : word - micro.value);
  }
  return std::nullopt;
}

// Shifts: named options, and the count as operand.
std::optional<std::string> shift(std::uint32_t word) {
  const auto names = names_of(word & ~step_count_mask, Class::eae);
  if (names.empty()) return std::nullopt;
  return join_names(names) + " " + short_octal(word & step_count_mask);
}

std::optional<std::string> eae(std::uint32_t word, const pdp7::Instruction& row) {
  if (row.operation == pdp7::Operation::eae_setup) {
    const auto names = names_of(word, Class::eae);
    return names.empty() ? std::nullopt : std::optional(join_names(names));
  }
  if (const auto counted = changed_count(word)) return counted;
  const bool shifts = row.operation == pdp7::Operation::eae_long_right ||
                      row.operation == pdp7::Operation::eae_long_left ||
                      row.operation == pdp7::Operation::eae_ac_left;
  return shifts ? shift(word) : std::nullopt;
}

std::optional<std::string> opr(std::uint32_t word) {
  if ((word & rotates) == rotates) return std::nullopt;
  const auto names = names_of(word, Class::opr);
  return names.empty() ? std::nullopt : std::optional(join_names(names));
}

bool alphanumeric(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

// Puts a leading 0 before the octal numbers of an instruction in DEC's language, as `as` expects.
std::string with_leading_zeros(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool begins = text[at] >= '1' && text[at] <= '9' && (at == 0 || !alphanumeric(text[at - 1]));
    if (begins) result += '0';
    result += text[at];
  }
  return result;
}

std::string memory_reference(std::uint32_t word, std::uint32_t address, const pdp7::Instruction& row) {
  const std::string name = std::string(row.mnemonic) + ((word & pdp7::indirect_bit) != 0 ? " i" : "");
  const std::uint32_t field = word & image::field_mask;
  if (row.operands == pdp7::Operands::none && field == 0) return name;
  return name + " " + short_octal((address & image::bank_mask) | field);
}

}  // namespace

std::string disassemble_word(core::Word18 word, std::uint32_t address) {
  const std::uint32_t value = word.value();
  const pdp7::Instruction& row = pdp7::instruction_of(value);
  if (row.instruction_class == Class::memory) return memory_reference(value, address, row);
  std::optional<std::string> text = exact_name(value);
  if (!text && row.instruction_class == Class::law) text = "law " + short_octal(value & image::field_mask);
  if (!text && row.instruction_class == Class::eae) text = eae(value, row);
  if (!text && row.instruction_class == Class::opr) text = opr(value);
  return text.value_or(octal(value, 6));
}

base::Result<std::string> disassemble_pdp7_bell(const image::CoreImage& image) {
  constexpr std::size_t comment_column = 24;
  std::string text = ".. = 0\n";
  std::uint32_t next = 0;
  for (const auto& [address, word] : image.words) {
    if (address > image::field_mask) {
      return base::Error{.found = "a word at " + octal(address, 5),
                         .expected = "words up to 17777, where --dialect bell ends (--end 17777 leaves the others out)"};
    }
    if (address != next) text += ". = 0" + octal(address, 5) + "\n";
    next = address + 1;
    std::string line = "   " + with_leading_zeros(disassemble_word(word, address));
    if (line.size() < comment_column) line.resize(comment_column, ' ');
    text += line + " \" " + octal(address, 5) + " " + octal(word.value(), 6) + "\n";
  }
  if (image.start) text += "\" start " + octal(*image.start, 5) + "\n";
  return text;
}

std::string disassemble_pdp7(const image::CoreImage& image) {
  SourceLines lines;
  for (const auto& [address, word] : image.words) {
    lines.origin_if_needed(address);
    lines.add(disassemble_word(word, address), octal(address, 5) + " " + octal(word.value(), 6));
  }
  return lines.finish(image.start);
}

}  // namespace sightline::disassembler
