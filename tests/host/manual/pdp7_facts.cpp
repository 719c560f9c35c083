#include "pdp7_facts.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "emulators/machines/pdp7_devices.hpp"
#include "emulators/pdp7/isa.hpp"
#include "emulators/pdp7/status.hpp"
#include "emulators/pdp7/timing.hpp"
#include "emulators/type340/characters.hpp"
#include "emulators/type340/delays.hpp"
#include "emulators/type340/words.hpp"
#include "host/machines/machine.hpp"
#include "table.hpp"

namespace sightline::manual {
namespace {

using pdp7::Operation;

std::string octal(std::uint32_t word) { return fmt::format("{:06o}", word); }

std::string microseconds(core::Duration time) {
  return fmt::format("{:g}", static_cast<double>(time.count()) / 1000);
}

// One sentence per operation; a new operation without text does not compile (-Wswitch).
std::string effect(Operation operation) {
  switch (operation) {
    case Operation::cal: return "JMS to 20; the address is ignored";
    case Operation::dac: return "deposit AC in Y";
    case Operation::jms: return "store L and PC in Y, go to Y+1";
    case Operation::dzm: return "deposit zero in Y";
    case Operation::lac: return "load AC from Y";
    case Operation::xor_: return "exclusive OR of AC and Y into AC";
    case Operation::add: return "one's complement sum of AC and Y into AC; L is set by an overflow";
    case Operation::tad: return "two's complement sum of AC and Y into AC; a carry complements L";
    case Operation::xct: return "execute the instruction in Y";
    case Operation::isz: return "count Y up by one, skip if it becomes zero";
    case Operation::and_: return "AND of AC and Y into AC";
    case Operation::sad: return "skip if AC and Y differ";
    case Operation::jmp: return "go to Y";
    case Operation::eae_setup: return "EAE: clear, complement, load MQ and AC, see below";
    case Operation::eae_multiply: return "EAE: multiply by the word that follows";
    case Operation::eae_unused: return "EAE: the options of bits 4 to 8 only";
    case Operation::eae_divide: return "EAE: divide by the word that follows";
    case Operation::eae_normalize: return "EAE: shift AC and MQ left until bits 0 and 1 of AC differ";
    case Operation::eae_long_right: return "EAE: shift AC and MQ right";
    case Operation::eae_long_left: return "EAE: shift AC and MQ left";
    case Operation::eae_ac_left: return "EAE: shift AC left";
    case Operation::iot: return "input or output, see below";
    case Operation::opr: return "operate on AC and L, skip, halt, see below";
    case Operation::law: return "load AC with this word itself";
  }
  return {};
}

std::string operands(pdp7::Operands operands) {
  switch (operands) {
    case pdp7::Operands::none: return "";
    case pdp7::Operands::address: return " Y";
    case pdp7::Operands::steps: return " + steps";
    case pdp7::Operands::microcode: return " + bits";
    case pdp7::Operands::immediate: return " N";
  }
  return {};
}

std::string names_of(pdp7::Class wanted, pdp7::Class or_wanted) {
  Table table{"name", "word", "meaning"};
  for (const pdp7::Microinstruction& row : pdp7::microinstructions) {
    const pdp7::Class found = pdp7::instruction_of(row.value).instruction_class;
    if (found != wanted && found != or_wanted) continue;
    table.row({code(row.name), octal(row.value), std::string(row.meaning)});
  }
  return table.text();
}

std::string bits(const type340::Field& field) {
  return field.first == field.last ? fmt::format("{}", field.first)
                                   : fmt::format("{}-{}", field.first, field.last);
}

std::string value(const type340::Field& field) {
  using enum type340::FieldKind;
  switch (field.kind) {
    case unused:
    case flag: return std::string(field.meaning);
    case number:
    case mode:
    case address: return std::string(field.meaning);
    case character: return "a character, six bits";
    case move: return "10 move in x, 04 to the left; 02 move in y, 01 down";
    case unit: return "slave unit: 4 set it, 2 its light pen on, 1 its beam on";
  }
  return {};
}

}  // namespace

std::string pdp7_instructions() {
  Table table{"instruction", "word", "effect", "cycles", "time", "source"};
  for (const pdp7::Instruction& row : pdp7::instructions) {
    table.row({code(row.mnemonic) + operands(row.operands), octal(row.value), effect(row.operation),
               fmt::format("{}", row.cycles), microseconds(pdp7::machine_cycle * row.cycles) + " us",
               std::string(row.source)});
  }
  return table.text();
}

std::string pdp7_operate() { return names_of(pdp7::Class::opr, pdp7::Class::law); }

std::string pdp7_eae() { return names_of(pdp7::Class::eae, pdp7::Class::eae); }

// IOTs of the devices, in the order of their codes, come before those of the extend mode.
std::string pdp7_iots() {
  Table table{"name", "word", "meaning"};
  const auto add_own = [&table](bool of_extend_mode) {
    constexpr std::uint32_t extend_mode = 0707700;
    for (const pdp7::Microinstruction& row : pdp7::microinstructions) {
      if (pdp7::instruction_of(row.value).instruction_class != pdp7::Class::iot) continue;
      if ((row.value >= extend_mode) == of_extend_mode) table.row({code(row.name), octal(row.value), std::string(row.meaning)});
    }
  };
  add_own(false);
  auto devices = pdp7::device_infos;
  std::sort(devices.begin(), devices.end(), [](const auto& a, const auto& b) { return a.codes.front() < b.codes.front(); });
  for (const core::IotDeviceInfo& device : devices) {
    for (const core::IotName& iot : device.iots) table.row({code(iot.mnemonic), octal(iot.word), std::string(iot.what)});
  }
  add_own(true);
  return table.text();
}

std::string pdp7_status() {
  Table table{"bit", "mask", "1 means"};
  const auto row = [&table](std::uint32_t mask, const char* meaning) {
    int bit = 17;
    for (std::uint32_t left = mask; left > 1; left >>= 1) --bit;
    table.row({fmt::format("{}", bit), octal(mask), meaning});
  };
  namespace status = pdp7::status;
  row(0400000, "interrupts are on");
  row(status::reader, "reader flag");
  row(status::punch, "punch flag");
  row(status::keyboard, "keyboard flag");
  row(status::printer, "printer flag");
  row(status::light_pen, "light-pen flag of the display");
  row(status::clock, "clock flag");
  row(status::clock_on, "the clock is on");
  return table.text();
}

// The table that `sightline run pdp7 --help` prints.
std::string pdp7_timing() {
  const std::string& help = machines::pdp7().more_help;
  const std::size_t table = help.find("  eae_setup");
  if (table == std::string::npos) return {};
  return "```\n" + help.substr(table, help.find("\n\n", table) - table) + (help.ends_with('\n') ? "" : "\n") + "```\n";
}

std::string type340_modes() {
  Table table{"mode", "its words", "needs"};
  for (std::size_t mode = 0; mode < type340::layouts.size(); ++mode) {
    const type340::Layout& layout = type340::layouts[mode];
    table.row({fmt::format("{}", mode), std::string(layout.name),
               layout.option.empty() ? "" : std::string(layout.option)});
  }
  return table.text();
}

std::string type340_words(std::size_t mode) {
  Table table{"bits", "mask", "name", "meaning"};
  for (const type340::Field& field : type340::layouts[mode].fields) {
    const std::uint32_t mask = ((1U << (field.last - field.first + 1U)) - 1U) << (17U - field.last);
    table.row({bits(field), octal(mask), std::string(field.name), value(field)});
  }
  return table.text();
}

std::string type340_times() {
  namespace t = type340::timing;
  Table table{"word", "time in us"};
  const auto row = [&table](const char* word, core::Duration time) { table.row({word, microseconds(time)}); };
  row("parameter", t::strobe + t::intensify);
  row("point, X, or Y lit", t::strobe + t::deflection + 2 * t::intensify);
  row("point, Y dark", t::strobe + 2 * t::intensify);
  for (const int pulses : {7, 15, 31, 63, 127}) {
    const std::string name = fmt::format("vector, larger of dx and dy {} to {} (decimal)",
                                         pulses == 7 ? 0 : (pulses + 1) / 2, pulses);
    row(name.c_str(), t::strobe + pulses * t::pulse + t::intensify);
  }
  row("increment", t::strobe + 4 * t::pulse + t::intensify);
  row("one stroke of a character", t::pulse);
  return table.text();
}

std::string type340_codes() {
  namespace c = type340::code;
  Table table{"code", "meaning"};
  const auto row = [&table](std::uint32_t code, const std::string& meaning) {
    table.row({fmt::format("{:02o}", code), meaning});
  };
  table.row({"00", "nothing; takes no room"});
  table.row({fmt::format("01-{:02o}", 032), "A to Z; after shift out a to z"});
  row(c::line_feed,
      fmt::format("line feed: {} dark steps down (decimal)", type340::path_of(c::line_feed, false).size()));
  row(c::carriage_return, "carriage return: X = 0");
  row(c::shift_in, "shift in: capital letters");
  row(c::shift_out, "shift out: small letters");
  row(c::escape, "escape: the rest of the word is not read, mode 0 follows");
  row(c::space, fmt::format("space: {} dark steps to the right", type340::path_of(c::space, false).size()));
  table.row({fmt::format("{:02o}-77", c::space + 1), "the signs and digits of ASCII 041 to 077"});
  return table.text();
}

}  // namespace sightline::manual
