#include "host/live/dap/view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

#include "host/base/text.hpp"
#include "host/live/dap/messages.hpp"
#include "host/live/monitor/monitor.hpp"

namespace sightline::live::dap {

using base::Json;

namespace {

// The values of variablesReference for the scopes.
enum : std::int64_t { of_registers = 1, of_conditions, of_devices, of_display };

// A line or a column as it is in a request. The limits are outside every file; sums with the first number do not overflow.
std::int64_t position_in(const Json& arguments, std::string_view name, std::int64_t otherwise) {
  constexpr std::int64_t farthest = std::int64_t{1} << 40;
  return std::clamp(integer_in(arguments, name, otherwise), -farthest, farthest);
}

}  // namespace

Json View::threads(const Json&) {
  return Json{{"threads", Json::array({Json{{"id", 1}, {"name", debugger_.description().name}}})}};
}

void View::add_place(Json& object, std::uint32_t at) const {
  const Symbols::Place* const place = debugger_.symbols().place(at);
  object["line"] = place == nullptr ? 0 : numbering_.line(place->line);
  object["column"] = place == nullptr ? 0 : numbering_.first_column;
  if (place == nullptr) return;
  object["source"] = source_of(place->file);
}

Json View::stack_trace(const Json& arguments) {
  const std::vector<Frame> frames = debugger_.stack();
  Json list = Json::array();
  const std::int64_t first = std::max<std::int64_t>(0, integer_in(arguments, "startFrame", 0));
  const std::int64_t levels = integer_in(arguments, "levels", 0);
  const auto all = static_cast<std::int64_t>(frames.size()) + 1;
  for (std::int64_t n = first; n < all && (levels <= 0 || n - first < levels); ++n) {
    const std::uint32_t at = n == 0 ? debugger_.pc() : frames[static_cast<std::size_t>(n - 1)].caller;
    const std::string near = debugger_.symbols().near(at);
    Json frame{{"id", n}, {"name", near.empty() ? debugger_.address(at) : near}, {"instructionPointerReference", reference(at)}};
    add_place(frame, at);
    list.push_back(std::move(frame));
  }
  return Json{{"stackFrames", std::move(list)}, {"totalFrames", all}};
}

Json View::scopes(const Json&) {
  Json list = Json::array();
  const auto add = [&list](std::string_view name, std::int64_t number) {
    list.push_back(Json{{"name", name}, {"variablesReference", number}, {"expensive", false}});
  };
  add("Registers", of_registers);
  if (!debugger_.machine().conditions().empty()) add("Flags", of_conditions);
  add("Devices", of_devices);
  if (!debugger_.machine().display_lines().empty()) add("Display", of_display);
  return Json{{"scopes", std::move(list)}};
}

Json View::variables(const Json& arguments) {
  Json list = Json::array();
  const auto add = [&list](std::string_view name, std::string_view value) {
    list.push_back(Json{{"name", name}, {"value", value}, {"evaluateName", name}, {"variablesReference", 0}});
  };
  // Texts for a person; they have no expression.
  const auto add_lines = [&list](const std::vector<machines::ReportLine>& lines) {
    for (const auto& line : lines)
      list.push_back(Json{{"name", line.label}, {"value", line.text}, {"variablesReference", 0}});
  };
  switch (integer_in(arguments, "variablesReference", 0)) {
    case of_registers:
      for (std::size_t n = 0; n < debugger_.description().registers.size(); ++n) {
        const std::string_view name = debugger_.description().registers[n].name;
        add(name, debugger_.register_text(n).substr(name.size() + 1));
      }
      add("time", debugger_.time_text(debugger_.machine().ticks()));
      break;
    case of_conditions:
      for (const auto& [name, holds] : debugger_.machine().conditions()) add(name, holds ? "1" : "0");
      break;
    case of_devices: add_lines(debugger_.machine().device_lines()); break;
    case of_display: add_lines(debugger_.machine().display_lines()); break;
    default: throw base::usage_error("found a variablesReference that no scope has");
  }
  return Json{{"variables", std::move(list)}};
}

Json View::set_variable(const Json& arguments) {
  const std::string name = text_in(arguments, "name");
  const auto number = debugger_.register_named(name);
  if (integer_in(arguments, "variablesReference", 0) != of_registers || !number)
    throw base::usage_error(fmt::format("found {}, expected a register", name));
  const std::int64_t value = base::value_of(debugger_.evaluate(text_in(arguments, "value")));
  const auto& each = debugger_.description().registers[*number];
  if (value < 0 || value >= std::int64_t{1} << each.bits)
    throw base::usage_error(fmt::format("found {}, expected {} of {} bits", text_in(arguments, "value"), each.what, each.bits));
  debugger_.set(*number, static_cast<std::uint32_t>(value));
  return Json{{"value", debugger_.register_text(*number).substr(name.size() + 1)}};
}

Json View::set_expression(const Json& arguments) {
  const std::string expression = text_in(arguments, "expression");
  if (debugger_.register_named(expression)) {
    Json request = arguments;
    request["name"] = expression;
    request["variablesReference"] = std::int64_t{of_registers};
    return set_variable(request);
  }
  const std::string_view place = word_in_brackets(expression);
  if (place.empty()) throw base::usage_error(fmt::format("found {}, expected a register or a word as [ADDRESS]", expression));
  const std::uint32_t at = base::value_of(debugger_.address_of(place));
  const std::int64_t value = base::value_of(debugger_.evaluate(text_in(arguments, "value")));
  if (value < 0 || value >= std::int64_t{1} << debugger_.description().word_bits)
    throw base::usage_error(fmt::format("found {}, expected a word of {} bits", text_in(arguments, "value"), debugger_.description().word_bits));
  debugger_.put(at, static_cast<std::uint32_t>(value));
  return Json{{"value", debugger_.word(static_cast<std::uint32_t>(value))}};
}

Json View::completions(const Json& arguments) {
  const std::string text = text_in(arguments, "text");
  const std::int64_t column = position_in(arguments, "column", numbering_.first_column) - numbering_.first_column;
  std::string_view before = std::string_view(text).substr(0, static_cast<std::size_t>(std::clamp<std::int64_t>(
                                                                 column, 0, static_cast<std::int64_t>(text.size()))));
  const std::size_t begun = before.find_last_of(" ()[]+-*/&|!<>=~^%");
  if (begun != std::string_view::npos) before.remove_prefix(begun + 1);
  Json targets = Json::array();
  // Verbs of the monitor at the beginning of a line.
  if (begun == std::string_view::npos) {
    for (const std::string_view verb : Monitor::verbs()) {
      if (verb.starts_with(base::lower_case(before)))
        targets.push_back(Json{{"label", verb}, {"type", "keyword"}, {"length", before.size()}, {"start", column - static_cast<std::int64_t>(before.size())}});
    }
  }
  for (const std::string& name : debugger_.names()) {
    if (base::lower_case(name).starts_with(base::lower_case(before)))
      targets.push_back(Json{{"label", name}, {"length", before.size()}, {"start", column - static_cast<std::int64_t>(before.size())}});
  }
  return Json{{"targets", std::move(targets)}};
}

Json View::value_of(const std::string& expression) const {
  const std::int64_t value = base::value_of(debugger_.evaluate(expression));
  Json body{{"result", debugger_.value_text(value)}, {"variablesReference", 0}};
  if (value >= 0 && value < debugger_.machine().words()) body["memoryReference"] = reference(static_cast<std::uint32_t>(value));
  return body;
}

Json View::read_memory(const Json& arguments) {
  const std::int64_t a_word = bytes_a_word(debugger_);
  const std::int64_t first = byte_place_of(debugger_, text_in(arguments, "memoryReference"), integer_in(arguments, "offset", 0));
  const std::int64_t wanted = std::max<std::int64_t>(0, integer_in(arguments, "count", 0));
  const std::int64_t count = std::min(wanted, debugger_.machine().words() * a_word - first);
  std::vector<std::uint8_t> bytes;
  for (std::int64_t place = first; place < first + count; ++place)
    bytes.push_back(static_cast<std::uint8_t>(debugger_.machine().word(static_cast<std::uint32_t>(place / a_word)) >> (8 * (place % a_word))));
  return Json{{"address", reference(static_cast<std::uint32_t>(first / a_word))}, {"unreadableBytes", wanted - count}, {"data", base64(bytes)}};
}

Json View::write_memory(const Json& arguments) {
  const auto bytes = bytes_of_base64(text_in(arguments, "data"));
  if (!bytes) throw base::usage_error("found data that is not base64");
  const std::int64_t a_word = bytes_a_word(debugger_);
  const std::int64_t first = byte_place_of(debugger_, text_in(arguments, "memoryReference"), integer_in(arguments, "offset", 0));
  const auto wanted = static_cast<std::int64_t>(bytes->size());
  const std::int64_t count = std::min(wanted, debugger_.machine().words() * a_word - first);
  if (count < wanted && !flag_in(arguments, "allowPartial"))
    throw base::usage_error(fmt::format("found {} bytes, expected at most {}: memory ends there; allowPartial writes these", wanted, count));
  const std::uint32_t most = (std::uint32_t{1} << debugger_.description().word_bits) - 1;
  // Bytes of a word that are not written keep their value.
  for (std::int64_t n = 0; n < count;) {
    const auto at = static_cast<std::uint32_t>((first + n) / a_word);
    std::uint32_t word = debugger_.machine().word(at);
    do {
      const std::int64_t shift = 8 * ((first + n) % a_word);
      word = (word & ~(std::uint32_t{0xFF} << shift)) | std::uint32_t{(*bytes)[static_cast<std::size_t>(n)]} << shift;
      ++n;
    } while (n < count && (first + n) % a_word != 0);
    debugger_.put(at, word & most);
  }
  return Json{{"bytesWritten", count}};
}

Json View::breakpoint_locations(const Json& arguments) {
  const std::int64_t first = position_in(arguments, "line", 0) + 1 - numbering_.first_line;
  const std::int64_t last = position_in(arguments, "endLine", position_in(arguments, "line", 0)) + 1 - numbering_.first_line;
  Json list = Json::array();
  for (const CodeLine& each : code_lines(debugger_.symbols(), text_in(member(arguments, "source"), "path"), first, last))
    list.push_back(Json{{"line", numbering_.line(each.line)}});
  return Json{{"breakpoints", std::move(list)}};
}

Json View::loaded_sources(const Json&) {
  Json list = Json::array();
  for (const std::string& file : source_files(debugger_.symbols())) list.push_back(source_of(file));
  return Json{{"sources", std::move(list)}};
}

Json View::goto_targets(const Json& arguments) {
  const auto lines = code_lines(debugger_.symbols(), text_in(member(arguments, "source"), "path"),
                                position_in(arguments, "line", 0) + 1 - numbering_.first_line, std::numeric_limits<std::int64_t>::max());
  Json list = Json::array();
  if (!lines.empty()) {
    const CodeLine& found = lines.front();
    list.push_back(Json{{"id", std::int64_t{found.at}},
                        {"label", debugger_.address(found.at) + " " + debugger_.instruction_text(found.at)},
                        {"line", numbering_.line(found.line)},
                        {"instructionPointerReference", reference(found.at)}});
  }
  return Json{{"targets", std::move(list)}};
}

Json View::disassemble(const Json& arguments) {
  const std::int64_t begin = place_of(debugger_, text_in(arguments, "memoryReference"), integer_in(arguments, "offset", 0));
  const std::int64_t words = debugger_.machine().words();
  constexpr std::int64_t most = 4096;
  const std::int64_t count = std::clamp<std::int64_t>(integer_in(arguments, "instructionCount", 0), 0, most);
  const std::int64_t offset = std::clamp<std::int64_t>(integer_in(arguments, "instructionOffset", 0), -most, most);
  std::vector<std::uint32_t> before;
  if (offset < 0) before = debugger_.instructions_before(static_cast<std::uint32_t>(begin), static_cast<std::size_t>(-offset));
  std::int64_t at = begin;
  for (std::int64_t n = 0; n < offset && at < words; ++n)
    at += debugger_.machine().instruction_at(static_cast<std::uint32_t>(at)).words;
  // Rows before the beginning of memory have addresses below it.
  const std::int64_t missing = offset < 0 ? -offset - static_cast<std::int64_t>(before.size()) : 0;
  Json list = Json::array();
  for (std::int64_t n = 0; n < count; ++n) {
    Json row = Json::object();
    const std::int64_t row_before = n - missing;
    if (n < missing) {
      at = -1;
    } else if (row_before < static_cast<std::int64_t>(before.size())) {
      at = before[static_cast<std::size_t>(row_before)];
    } else if (row_before == static_cast<std::int64_t>(before.size()) && offset < 0) {
      at = begin;
    }
    if (at < 0 || at >= words) {
      row = Json{{"address", fmt::format("0x{:X}", std::max<std::int64_t>(at, 0))}, {"instruction", "outside memory"}};
      row["presentationHint"] = "invalid";
      ++at;
    } else {
      const auto place = static_cast<std::uint32_t>(at);
      const auto instruction = debugger_.machine().instruction_at(place);
      std::string content;
      for (std::uint32_t m = 0; m < instruction.words && place + m < words; ++m)
        content += (m == 0 ? "" : " ") + debugger_.word(debugger_.machine().word(place + m));
      row = Json{{"address", reference(place)}, {"instructionBytes", content}, {"instruction", instruction.text}};
      const std::string near = debugger_.symbols().near(place);
      if (!near.empty()) row["symbol"] = near;
      if (const Symbols::Place* const line = debugger_.symbols().place(place)) {
        row["line"] = numbering_.line(line->line);
        row["location"] = source_of(line->file);
      }
      at += std::max(1U, instruction.words);
    }
    list.push_back(std::move(row));
  }
  return Json{{"instructions", std::move(list)}};
}

Json View::whole_memory() const {
  const std::int64_t bytes = std::int64_t{debugger_.machine().words()} * bytes_a_word(debugger_);
  return Json{{"memoryReference", reference(0)}, {"offset", 0}, {"count", bytes}};
}

}  // namespace sightline::live::dap
