#include "i8080_facts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/i8080/isa.hpp"
#include "emulators/machines/i8080_devices.hpp"
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

// The first opcode of a row, and the number of opcodes, which are not consecutive.
std::string opcodes(const i8080::Instruction& row) {
  int count = 0;
  int first = -1;
  for (int opcode = 0; opcode < 256; ++opcode) {
    if (!row.matches(static_cast<std::uint8_t>(opcode))) continue;
    if (first < 0) first = opcode;
    ++count;
  }
  return count == 1 ? fmt::format("{:02X}", first) : fmt::format("{:02X} and {} more", first, count - 1);
}

std::string ports_text(std::span<const core::PortRange> ranges) {
  std::string text;
  for (const core::PortRange range : ranges) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{:02X}", range.first);
    if (range.last != range.first) text += fmt::format("-{:02X}", range.last);
  }
  return text;
}

std::string milliseconds(core::Duration time) {
  return fmt::format("{:g} ms", static_cast<double>(time.count()) / 1e6);
}

std::string microseconds(core::Duration time) {
  return fmt::format("{:g} us", static_cast<double>(time.count()) / 1e3);
}

// A new operation without text does not compile (-Wswitch).
std::string effect(i8080::Operation operation) {
  using O = i8080::Operation;
  switch (operation) {
    case O::nop: return "nothing";
    case O::lxi: return "load the pair with the word";
    case O::stax: return "store A at the address in the pair";
    case O::ldax: return "load A from the address in the pair";
    case O::inx: return "add 1 to the pair";
    case O::dcx: return "subtract 1 from the pair";
    case O::inr: return "add 1";
    case O::dcr: return "subtract 1";
    case O::mvi: return "load with the byte";
    case O::mov: return "copy the second operand to the first";
    case O::hlt: return "wait for an interrupt";
    case O::dad: return "add the pair to HL";
    case O::shld: return "store HL at the address, L first";
    case O::lhld: return "load HL from the address";
    case O::sta: return "store A at the address";
    case O::lda: return "load A from the address";
    case O::rlc: return "rotate A left; bit 7 to C and bit 0";
    case O::rrc: return "rotate A right; bit 0 to C and bit 7";
    case O::ral: return "rotate C and A left, nine bits";
    case O::rar: return "rotate C and A right, nine bits";
    case O::daa: return "correct A after an addition of decimal digits";
    case O::cma: return "complement A";
    case O::stc: return "set C";
    case O::cmc: return "complement C";
    case O::add: return "add to A";
    case O::adc: return "add to A, with C";
    case O::sub: return "subtract from A; C is the borrow";
    case O::sbb: return "subtract from A, with the borrow";
    case O::ana: return "AND into A; C is cleared";
    case O::xra: return "exclusive OR into A; C is cleared";
    case O::ora: return "OR into A; C is cleared";
    case O::cmp: return "set the flags as a subtraction from A does, and leave A";
    case O::ret: return "return: PC from the stack";
    case O::jmp: return "go to the address";
    case O::call: return "push PC, go to the address";
    case O::conditional_return: return "return if the condition holds";
    case O::conditional_jump: return "jump if it holds: NZ Z NC C, PO parity odd, PE even, P plus, M minus";
    case O::conditional_call: return "call if it holds";
    case O::rst: return "push PC, go to 8 times n";
    case O::push: return "push the pair; PSW is A and the flags";
    case O::pop: return "pop the pair; the flags change with PSW only";
    case O::xthl: return "exchange HL with the top of the stack";
    case O::sphl: return "copy HL to SP";
    case O::pchl: return "go to the address in HL";
    case O::xchg: return "exchange DE and HL";
    case O::in: return "A from the port";
    case O::out: return "A to the port";
    case O::ei: return "enable interrupts, after the next instruction";
    case O::di: return "disable interrupts";
  }
  return {};
}

std::string byte(unsigned value) { return fmt::format("{:02X}", value); }

}  // namespace

std::string i8080_effects() {
  std::vector<std::pair<i8080::Operation, std::vector<std::string>>> rows;
  for (const i8080::Instruction& row : i8080::instructions) {
    const std::string name = code(upper(row.mnemonic));
    const auto same = [&row](const auto& known) { return known.first == row.operation; };
    auto known = std::find_if(rows.begin(), rows.end(), same);
    if (known == rows.end()) known = rows.insert(rows.end(), {row.operation, {}});
    if (std::find(known->second.begin(), known->second.end(), name) == known->second.end())
      known->second.push_back(name);
  }
  Table table{"instruction", "effect"};
  for (const auto& [operation, names] : rows) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
    table.row({text, effect(operation)});
  }
  return table.text();
}

// Instructions with the same length, times and flags share a row.
std::string i8080_instructions() {
  std::vector<std::pair<std::vector<std::string>, std::string>> rows;
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
    const std::vector<std::string> facts{fmt::format("{}", row.bytes()), states, cycles, flags_text(row.flags)};
    const std::string instruction = code(name) + " " + opcodes(row);
    const auto same = std::find_if(rows.begin(), rows.end(), [&facts](const auto& r) { return r.first == facts; });
    if (same == rows.end())
      rows.emplace_back(facts, instruction);
    else
      same->second += ", " + instruction;
  }
  Table table{"instructions and first opcodes", "bytes", "T-states", "machine cycles", "flags"};
  for (const auto& [facts, names] : rows) table.row({names, facts[0], facts[1], facts[2], facts[3]});
  return table.text();
}

std::string i8080_ports() {
  Table table{"device", "option", "IN", "OUT", "interrupt lines"};
  using Kind = core::PortDeviceKind;
  for (const i8080::KnownDevice& known : i8080::known_devices) {
    const core::PortDeviceInfo& info = *known.info;
    if (info.kind == Kind::special && &info != &devices::SenseSwitches::info) continue;
    std::string option = "--device " + std::string(info.name);
    if (info.kind == Kind::raster_board) option = "--board " + std::string(info.choice);
    if (info.kind == Kind::plotter) option = "--plotter " + std::string(info.choice);
    if (info.kind == Kind::terminal) option = "--terminal " + std::string(info.choice);
    if (info.kind == Kind::link) option = "--" + std::string(info.name) + " FILE";
    if (info.kind == Kind::special) option = "--" + std::string(info.name) + " XX";
    std::string lines;
    for (const std::string_view line : info.lines) lines += (lines.empty() ? "" : ", ") + std::string(line);
    table.row({std::string(info.name), code(option), ports_text(info.reads), ports_text(info.writes), lines});
  }
  return table.text();
}

std::string ef9365_status() {
  using Status = devices::Ef9365::Status;
  Table table{"mask", "1 means"};
  table.row({byte(Status::blanking), "vertical blanking"});
  table.row({byte(Status::ready), "ready: the last command is done"});
  table.row({byte(Status::pen_outside), "the pen is outside 256 by 256"});
  table.row({byte(Status::blanking_interrupt), "vertical blanking has begun, if CTRL1 enables it; reading clears"});
  table.row({byte(Status::ready_interrupt), "a command has ended, if CTRL1 enables it; reading clears"});
  table.row({byte(Status::interrupt), "one of the two above"});
  return table.text();
}

std::string board_times() {
  namespace ef = devices::ef9365;
  namespace alt = devices::alt256;
  Table table{"device", "what", "time"};
  table.row({"EF9365", "a vector or character of n dots scanned",
             fmt::format("(n + {}) * 4/7 us", ef::start_up_clocks)});
  table.row({"EF9365", "clear, fill", milliseconds(ef::sweep)});
  table.row({"EF9365", "other commands", microseconds(ef::clocks(ef::register_command_clocks))});
  table.row({"EF9365", "a field of the screen", milliseconds(ef::field)});
  table.row({"ALT-256", "a dot: to the next horizontal blanking, one in each line of", milliseconds(alt::line)});
  table.row({"ALT-256", "erase", milliseconds(alt::erase)});
  table.row({"CalComp 565", "a step", milliseconds(devices::calcomp565::step)});
  table.row({"CalComp 565", "pen up or down", milliseconds(devices::calcomp565::pen)});
  table.row({"Minigraf 0507", "shortest time between two steps of one motor",
             milliseconds(devices::MinigrafTimes{}.shortest_step)});
  table.row({"Minigraf 0507", "until the lowered pen touches", milliseconds(devices::MinigrafTimes{}.pen)});
  table.row({"8255", "the host answers after", microseconds(devices::ParallelHost{}.response)});
  table.row({"8251", "a bit of the host", fmt::format("1/{} s", devices::SerialHost{}.baud)});
  return table.text();
}

std::string calcomp_status() {
  using Status = devices::CalComp565::Status;
  Table table{"mask", "1 means"};
  table.row({byte(Status::busy), "busy: a command is under way"});
  table.row({byte(Status::done), "done: a command has ended; the next command clears it"});
  table.row({byte(Status::pen), "the pen is down"});
  table.row({byte(Status::error), "a command while busy, off the carriage, or unknown; the next obeyed one clears it"});
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
