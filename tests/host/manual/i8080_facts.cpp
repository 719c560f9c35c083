#include "i8080_facts.hpp"

#include <fmt/core.h>

#include <string_view>
#include <type_traits>

#include "emulators/i8080/isa.hpp"
#include "emulators/machines/skala_ports.hpp"
#include "table.hpp"

namespace sightline::manual {
namespace {

using i8080::CycleKind;
using i8080::Operand;

std::string operand_text(Operand operand) {
  switch (operand) {
    case Operand::none: return "";
    case Operand::to_register:
    case Operand::from_register: return "r";
    case Operand::memory: return "M";
    case Operand::pair: return "rp";
    case Operand::pair_b_d: return "B/D";
    case Operand::pair_psw: return "rp/PSW";
    case Operand::restart: return "n";
    case Operand::data8: return "d8";
    case Operand::port: return "port";
    case Operand::data16: return "d16";
    case Operand::address: return "addr";
  }
  return {};
}

std::string cycles_text(const i8080::Cycles& cycles) {
  constexpr std::string_view letters = "FRWrwIOHx";
  std::string text;
  for (const i8080::MachineCycle& cycle : cycles) {
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", letters[static_cast<std::size_t>(cycle.kind)],
                        cycle.t_states);
  }
  return text;
}

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return result;
}

std::string flags_text(std::uint8_t flags) {
  std::string text;
  if ((flags & i8080::flag::sign) != 0) text += 'S';
  if ((flags & i8080::flag::zero) != 0) text += 'Z';
  if ((flags & i8080::flag::auxiliary) != 0) text += 'A';
  if ((flags & i8080::flag::parity) != 0) text += 'P';
  if ((flags & i8080::flag::carry) != 0) text += 'C';
  return text;
}

// The opcodes of a row, as ranges: "40-7F" would be wrong where a row leaves some out, so the first and the number.
std::string opcodes(const i8080::Instruction& row) {
  int count = 0;
  int first = -1;
  for (int opcode = 0; opcode < 256; ++opcode) {
    if (!row.matches(static_cast<std::uint8_t>(opcode))) continue;
    if (first < 0) first = opcode;
    ++count;
  }
  return count == 1 ? fmt::format("{:02X}", first) : fmt::format("{:02X} ({} opcodes)", first, count);
}

std::string ports_text(const auto& ranges) {
  std::string text;
  for (const machines::PortRange range : ranges) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{:02X}", range.first);
    if (range.last != range.first) text += fmt::format("-{:02X}", range.last);
  }
  return text;
}

std::string milliseconds(core::Duration time) {
  return fmt::format("{:g} ms", static_cast<double>(time.count()) / 1e6);
}

std::string byte(unsigned value) { return fmt::format("{:02X}", value); }

}  // namespace

std::string i8080_instructions() {
  Table table{"instruction", "opcode", "bytes", "T-states", "machine cycles", "flags"};
  for (const i8080::Instruction& row : i8080::instructions) {
    if (row.duplicate) continue;
    std::string name = upper(row.mnemonic);
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string text = operand_text(row.operands[i]);
      if (!text.empty()) name += (i == 0 ? " " : ",") + text;
    }
    std::string states = fmt::format("{}", row.cycles.t_states());
    std::string cycles = cycles_text(row.cycles);
    if (row.conditional() && !(row.cycles == row.taken)) {
      states += fmt::format("/{}", row.taken.t_states());
      cycles += " / " + cycles_text(row.taken);
    }
    table.row({code(name), opcodes(row), fmt::format("{}", row.bytes()), states, cycles, flags_text(row.flags)});
  }
  return table.text();
}

std::string i8080_ports() {
  Table table{"device", "option", "IN", "OUT", "interrupt lines"};
  machines::SkalaRows::each([&table](auto row) {
    using Row = decltype(row);
    std::string option;
    if constexpr (Row::kind == machines::DeviceKind::raster_board) option = "--board " + std::string(Row::choice);
    if constexpr (Row::kind == machines::DeviceKind::plotter) option = "--plotter " + std::string(Row::choice);
    if constexpr (Row::kind == machines::DeviceKind::link) option = "--" + std::string(Row::name) + " FILE";
    std::string lines;
    for (const auto& line : Row::lines) lines += (lines.empty() ? "" : ", ") + std::string(line.name);
    table.row({std::string(Row::name), code(option), ports_text(Row::reads), ports_text(Row::writes), lines});
  });
  return table.text();
}

std::string ef9365_status() {
  using Status = devices::Ef9365::Status;
  Table table{"mask", "1 means"};
  table.row({byte(Status::blanking), "vertical blanking"});
  table.row({byte(Status::ready), "ready: the last command is done"});
  table.row({byte(Status::pen_outside), "the pen is outside 256 by 256"});
  table.row({byte(Status::blanking_interrupt), "vertical blanking has begun, with its interrupt enabled; reading clears"});
  table.row({byte(Status::ready_interrupt), "a command has ended, with its interrupt enabled; reading clears"});
  table.row({byte(Status::interrupt), "one of the two above"});
  return table.text();
}

std::string board_times() {
  namespace ef = devices::ef9365;
  namespace alt = devices::alt256;
  Table table{"device", "what", "time"};
  table.row({"EF9365", "a vector or character of n dots scanned", fmt::format("(n + {}) * 4/7 us", ef::start_up_clocks)});
  table.row({"EF9365", "clear, fill", milliseconds(ef::sweep)});
  table.row({"EF9365", "other commands", fmt::format("{:g} us", static_cast<double>(ef::clocks(ef::register_command_clocks).count()) / 1000)});
  table.row({"EF9365", "a field of the screen", milliseconds(ef::field)});
  table.row({"ALT-256", "a dot: to the next horizontal blanking, one in each line of", milliseconds(alt::line)});
  table.row({"ALT-256", "erase", milliseconds(alt::erase)});
  table.row({"CalComp 565", "a step", milliseconds(devices::calcomp565::step)});
  table.row({"CalComp 565", "pen up or down", milliseconds(devices::calcomp565::pen)});
  table.row({"Minigraf 0507", "shortest time between two steps of one motor", milliseconds(devices::MinigrafTimes{}.shortest_step)});
  table.row({"Minigraf 0507", "until the lowered pen touches", milliseconds(devices::MinigrafTimes{}.pen)});
  table.row({"8255", "the host answers after", fmt::format("{:g} us", static_cast<double>(devices::ParallelHost{}.response.count()) / 1000)});
  table.row({"8251", "a bit of the host", fmt::format("1/{} s", devices::SerialHost{}.baud)});
  return table.text();
}

std::string calcomp_status() {
  using Status = devices::CalComp565<core::NoStrokes>::Status;
  Table table{"mask", "1 means"};
  table.row({byte(Status::busy), "busy: a command is under way"});
  table.row({byte(Status::done), "done: a command has ended; the next command clears it"});
  table.row({byte(Status::pen), "the pen is down"});
  table.row({byte(Status::error), "a command while busy, off the carriage, or of unknown code; the next obeyed command clears it"});
  return table.text();
}

std::string i8251_status() {
  using Status = devices::I8251::Status;
  Table table{"mask", "1 means"};
  table.row({byte(Status::transmit_ready), "TxRDY: the next byte can be written"});
  table.row({byte(Status::receive_ready), "RxRDY: a byte can be read"});
  table.row({byte(Status::transmit_empty), "TxEMPTY: everything is sent"});
  table.row({byte(Status::parity_error), "parity error"});
  table.row({byte(Status::overrun), "overrun: a byte came before the last was read"});
  table.row({byte(Status::framing_error), "framing error: no stop bit"});
  table.row({byte(Status::data_set_ready), "DSR, always"});
  return table.text();
}

}  // namespace sightline::manual
