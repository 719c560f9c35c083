#include "tools/disasm/i8080.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "emulators/i8080/isa.hpp"

namespace sightline::disassembler {
namespace {

using i8080::Operand;
using image::hexadecimal;

constexpr std::size_t comment_column = 32;
constexpr std::size_t operand_column = 16;
constexpr std::string_view indent = "        ";

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return upper;
}

// As the assembler requires: a number begins with a digit.
std::string number(std::uint32_t value, unsigned digits) {
  const std::string text = hexadecimal(value, digits) + "H";
  return text[0] > '9' ? "0" + text : text;
}

std::string operand_text(Operand operand, std::array<std::uint8_t, 3> bytes) {
  const unsigned opcode = bytes[0];
  switch (operand) {
    case Operand::none: return "";
    case Operand::to_register: return upper_case(i8080::register_names[opcode >> 3 & 7]);
    case Operand::from_register: return upper_case(i8080::register_names[opcode & 7]);
    case Operand::memory: return "M";
    case Operand::pair:
    case Operand::pair_b_d: return upper_case(i8080::pair_names[opcode >> 4 & 3]);
    case Operand::pair_psw: return upper_case(i8080::psw_pair_names[opcode >> 4 & 3]);
    case Operand::restart: return std::to_string(opcode >> 3 & 7);
    case Operand::data8:
    case Operand::port: return number(bytes[1], 2);
    case Operand::data16:
    case Operand::address: break;
  }
  return number(static_cast<std::uint32_t>(bytes[2] << 8 | bytes[1]), 4);
}

class Lines {
 public:
  void origin(std::uint16_t address) {
    text_ += std::string(indent) + "ORG     " + number(address, 4) + "\n";
  }

  void add(std::uint16_t address, std::string statement, std::span<const std::uint8_t> bytes,
           std::string_view note) {
    statement.insert(0, indent);
    statement.resize(std::max(statement.size() + 1, comment_column), ' ');
    text_ += statement + "; " + hexadecimal(address, 4);
    for (const std::uint8_t byte : bytes) text_ += " " + hexadecimal(byte, 2);
    if (!note.empty()) text_ += "  " + std::string(note);
    text_ += "\n";
  }

  void add_data(std::uint16_t address, std::span<const std::uint8_t> bytes, std::string_view note) {
    std::string statement = "DB      ";
    for (std::size_t i = 0; i < bytes.size(); ++i) statement += (i == 0 ? "" : ",") + number(bytes[i], 2);
    add(address, std::move(statement), bytes, note);
  }

  [[nodiscard]] std::string finish(std::optional<std::uint16_t> start) {
    text_ += std::string(indent) + "END" + (start ? "     " + number(*start, 4) : "") + "\n";
    return std::move(text_);
  }

 private:
  std::string text_;
};

std::size_t end_of_run(const image::ByteImage& image, std::size_t from) {
  while (from < image::byte_memory_size && image.used(static_cast<std::uint16_t>(from))) ++from;
  return from;
}

void add_run(Lines& lines, const image::ByteImage& image, std::size_t at, std::size_t end) {
  lines.origin(static_cast<std::uint16_t>(at));
  while (at < end) {
    const auto address = static_cast<std::uint16_t>(at);
    const auto byte = [&](std::size_t i) { return at + i < end ? image.bytes()[at + i] : std::uint8_t{0}; };
    const I8080Line line = disassemble_i8080_instruction({byte(0), byte(1), byte(2)});
    const auto size = static_cast<std::size_t>(line.bytes);
    if (at + size > end) {
      lines.add_data(address, image.bytes().subspan(at, end - at), "part of an instruction");
      return;
    }
    const auto bytes = image.bytes().subspan(at, size);
    if (line.duplicate) {
      lines.add_data(address, bytes, "acts as " + line.text);
    } else {
      lines.add(address, line.text, bytes, "");
    }
    at += size;
  }
}

}  // namespace

I8080Line disassemble_i8080_instruction(std::array<std::uint8_t, 3> bytes) {
  const i8080::Instruction& row = i8080::lookup(bytes[0]);
  std::string text = upper_case(row.mnemonic);
  if (row.operands[0] != Operand::none) {
    text.resize(std::max(text.size() + 1, operand_column - indent.size()), ' ');
    text += operand_text(row.operands[0], bytes);
  }
  if (row.operands[1] != Operand::none) text += "," + operand_text(row.operands[1], bytes);
  return {std::move(text), row.bytes(), row.duplicate};
}

std::string disassemble_i8080(const image::ByteImage& image) {
  Lines lines;
  for (std::size_t at = 0; at < image::byte_memory_size; ++at) {
    const std::size_t end = end_of_run(image, at);
    if (end == at) continue;
    add_run(lines, image, at, end);
    at = end;
  }
  return lines.finish(image.start);
}

}  // namespace sightline::disassembler
