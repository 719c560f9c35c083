#include "host/live/monitor/listings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "host/base/text.hpp"
#include "host/live/monitor/arguments.hpp"

namespace sightline::live::monitor {

using machines::Probe;

namespace {

std::string label_lines(const std::vector<machines::ReportLine>& lines) {
  std::string text;
  for (const auto& line : lines) text += fmt::format("{:<12} {}\n", line.label, line.text);
  return text;
}

}  // namespace

std::string memory(const Debugger& debugger, std::uint32_t first, std::uint32_t last) {
  std::string text;
  if (last - first >= most_listed)
    throw base::usage_error(fmt::format("found {} words, expected at most {}", last - first + 1, most_listed));
  if (debugger.description().radix == 8 || first == last) {
    for (std::uint32_t at = first; at <= last; ++at)
      text += fmt::format("{} {}  {}\n", debugger.address(at), debugger.word(debugger.machine().word(at)), debugger.instruction_text(at));
    return text;
  }
  for (std::uint32_t line = first; line <= last; line += 16) {
    std::string bytes;
    std::string characters;
    for (std::uint32_t at = line; at <= std::min(line + 15, last); ++at) {
      const std::uint32_t byte = debugger.machine().word(at);
      bytes += " " + debugger.word(byte);
      characters.push_back(byte >= ' ' && byte < 0x7F ? static_cast<char>(byte) : '.');
    }
    text += fmt::format("{} {:<48}  {}\n", debugger.address(line), bytes, characters);
  }
  return text;
}

std::string disassembly(const Debugger& debugger, std::uint32_t at, std::uint32_t last, std::uint32_t most) {
  std::string text;
  for (std::uint32_t left = most; left > 0 && at <= last; --left) {
    const auto instruction = debugger.machine().instruction_at(at);
    std::string words;
    for (std::uint32_t n = 0; n < instruction.words && at + n < debugger.machine().words(); ++n)
      words += (debugger.description().radix == 16 || words.empty() ? "" : " ") + debugger.word(debugger.machine().word(at + n));
    const int width = debugger.description().radix == 16 ? 6 : 0;
    text += fmt::format("{}{} {:<{}}  {}\n", at == debugger.pc() ? ">" : " ", debugger.address(at), words, width,
                        debugger.instruction_text(at));
    at += std::max(1U, instruction.words);
  }
  return text;
}

std::string writer(Debugger& debugger, std::uint32_t at) {
  const auto writer = debugger.last_writer(at);
  if (!writer) return fmt::format("{}: nothing has written there since the monitor began\n", debugger.address(at));
  std::string by = fmt::format("{} {}", debugger.address(writer->pc), debugger.instruction_text(writer->pc));
  if (writer->event.kind == Probe::Kind::break_write) by = fmt::format("a data break while PC was {}", debugger.address(writer->pc));
  if (writer->event.kind == Probe::Kind::interrupt_write) by = fmt::format("the interrupt before {}", debugger.address(writer->pc));
  return fmt::format("{}: {} was written at {} by {}\n", debugger.address(at), debugger.word(writer->event.value),
                     debugger.time_text(writer->event.time), by);
}

std::string cycles(const Debugger& debugger, const Debugger::Cycled& cycled) {
  std::string text = fmt::format("at {}, inside the instruction that begins at {}:\n", debugger.time_text(cycled.at),
                                 debugger.time_text(debugger.machine().ticks()));
  for (std::size_t n = 0; n < cycled.cycles.size(); ++n) {
    const Past::Cycle& each = cycled.cycles[n];
    const std::int64_t end = n + 1 < cycled.cycles.size() ? cycled.cycles[n + 1].time : std::max(cycled.at + 1, each.time + each.length);
    const bool begun = each.time < cycled.at;
    const std::string_view state = !begun ? "to come" : end <= cycled.at ? "done" : "under way";
    text += fmt::format("{} {:<9}  {:<14}", debugger.time_text(each.time), state, each.name);
    if (each.has_address) text += fmt::format(" {} {}", debugger.address(each.address), begun ? debugger.word(each.value) : std::string());
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text + "before it: " + debugger.status();
}

std::string history(Debugger& debugger, std::uint64_t instructions) {
  std::string text;
  for (const Past::Entry& entry : debugger.history(static_cast<std::size_t>(std::min<std::uint64_t>(instructions, Past::most_history))))
    text += debugger.machine().history_line(entry) + "\n";
  return text.empty() ? "no instruction has been obeyed yet\n" : text;
}

std::string state(Debugger& debugger, std::string_view arguments) {
  const std::string what = base::lower_case(arguments);
  std::string text;
  const auto is = [&what](std::string_view name) { return !what.empty() && name.starts_with(what); };
  if (is("registers")) {
    for (std::size_t n = 0; n < debugger.description().registers.size(); ++n) text += debugger.register_text(n) + "\n";
  } else if (is("devices")) {
    text = label_lines(debugger.machine().device_lines());
  } else if (is("display")) {
    text = label_lines(debugger.machine().display_lines());
    if (text.empty()) text = "no display is attached, or the program has not used it yet\n";
  } else if (is("stack")) {
    for (const Frame& frame : debugger.stack())
      text += fmt::format("{} called from {}  {}\n", debugger.address(frame.entry), debugger.address(frame.caller),
                          debugger.instruction_text(frame.caller));
    if (text.empty()) text = "no subroutine was called and not left in the last instructions\n";
  } else if (is("time")) {
    text = fmt::format("{}, {} instructions\n", debugger.time_text(debugger.machine().ticks()), debugger.machine().instructions());
  } else if (is("breaks") || is("breakpoints")) {
    for (const Breakpoint& each : debugger.breakpoints().all())
      text += fmt::format("{}: {}, passed {} times\n", each.number, each.text, each.passed);
    if (text.empty()) text = "no breakpoints\n";
  } else if (is("conditions")) {
    for (const auto& [name, holds] : debugger.machine().conditions()) text += fmt::format("{:<12} {}\n", name, holds ? 1 : 0);
    if (text.empty()) text = "this machine has none\n";
  } else if (is("symbols")) {
    for (const auto& [name, value] : debugger.symbols().all()) text += fmt::format("{:<16} {}\n", name, debugger.address(value));
    if (text.empty()) text = "no symbols: no source file or --symbols FILE was given, or it has none\n";
  } else {
    throw base::usage_error(fmt::format("found \"{}\", expected registers, devices, display, stack, time, breaks, conditions or symbols", arguments));
  }
  return text;
}

}  // namespace sightline::live::monitor
