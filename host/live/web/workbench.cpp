#include "host/live/web/workbench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "host/base/text.hpp"
#include "host/live/keys.hpp"
#include "host/live/snapshot.hpp"
#include "host/live/web/requests.hpp"

namespace sightline::live::web {
namespace {

using machines::Arguments;
using machines::Input;
using machines::Machine;
using machines::MachineDescription;
using machines::OptionKind;

const MachineDescription* description_of(std::string_view name) {
  const auto machines = machines::machines();
  const auto found = std::find_if(machines.begin(), machines.end(), [&](const auto* each) { return each->name == name; });
  return found == machines.end() ? nullptr : *found;
}

std::int64_t whole_of(const Json& request, std::string_view key, std::int64_t otherwise = 0) {
  const Json* const member = request.find(key);
  return member != nullptr ? member->integer().value_or(otherwise) : otherwise;
}

// Takes the options of a command line: {"--memory": "8k", "--display": true, "--load": ["a.rim"]}. Returns a complaint, or empty.
std::string take_options(const Json& given, std::span<const machines::Option> options, Arguments& arguments) {
  for (const auto& [key, value] : given.members()) {
    const std::string& name = key;
    const auto option = std::find_if(options.begin(), options.end(), [&](const auto& each) { return each.key() == name; });
    if (option == options.end()) return fmt::format("there is no option {}", name);
    Arguments::Value& target = arguments.value(name);
    if (value.boolean()) {
      target.flag = *value.boolean();
    } else if (value.text() != nullptr) {
      const auto& choices = option->choices;
      if (!choices.empty() && std::find(choices.begin(), choices.end(), *value.text()) == choices.end())
        return fmt::format("{}: found \"{}\", expected one of those its help lists", name, *value.text());
      target.text = *value.text();
      if (option->kind == OptionKind::list || option->kind == OptionKind::files) target.list = {*value.text()};
    } else if (value.is_array()) {
      for (const Json& each : value.elements()) {
        if (each.text() == nullptr) return fmt::format("{}: found {}, expected texts", name, describe(each));
        target.list.push_back(*each.text());
      }
    } else {
      return fmt::format("{}: found {}, expected a text, true or an array of texts", name, describe(value));
    }
  }
  return {};
}

// Takes the options of a snapshot's machine from its configuration. Returns a complaint if they name files, or empty.
std::string take_configuration(const std::string& file, const Snapshot& snapshot, const MachineDescription& description, Arguments& arguments) {
  for (const std::string& word : snapshot.configuration) {
    const std::size_t end = std::min(word.find(' '), word.size());
    const std::string name = word.substr(0, end);
    const std::string value = word.substr(std::min(end + 1, word.size()));
    const auto option = std::find_if(description.options.begin(), description.options.end(), [&](const auto& each) { return each.key() == name; });
    const bool flag = option != description.options.end() && option->kind == OptionKind::flag;
    if (option == description.options.end() || name == "--cpm-drive" || (!flag && value.empty()))
      return fmt::format("{}: the machine of this snapshot has files of {}, which are not in it; continue with: sightline run {} --restore {} "
                         "and the options of its first run", file, name, description.name, base::shell_word(file));
    Arguments::Value& target = arguments.value(name);
    if (flag) target.flag = true;
    else if (option->kind == OptionKind::list || option->kind == OptionKind::files) target.list.push_back(value);
    else target.text = value;
    if (name == "--cpm" && !value.empty()) arguments.value("--console").text = "ascii";  // "with console or drives"
  }
  return {};
}

Json halted_json(const Halted& halted) {
  static constexpr std::array<std::string_view, 3> names{"goal", "breakpoint", "machine"};
  return Json{{"why", names[static_cast<std::size_t>(halted.why)]},
              {"breakpoint", halted.breakpoint},
              {"reason", halted.why == Halted::Why::machine ? reason_text(halted) : halted.reason}};
}

Json state_json(MachineSession& session) {
  Debugger& debugger = session.debugger();
  Json registers = Json::array();
  for (std::size_t n = 0; n < session.description().registers.size(); ++n) {
    const auto& each = session.description().registers[n];
    registers.push_back(Json{{"name", each.name},
                             {"value", session.machine().get(n)},
                             {"bits", each.bits},
                             {"text", machines::digits(session.description(), session.machine().get(n), each.bits)}});
  }
  Json flags = Json::array();
  for (const auto& [name, up] : session.machine().conditions()) flags.push_back(Json{{"name", name}, {"up", up}});
  Json devices = Json::array();
  for (const auto& line : session.machine().device_lines()) devices.push_back(Json{{"label", line.label}, {"text", line.text}});
  Json display = Json::array();
  for (const auto& line : session.machine().display_lines()) display.push_back(Json{{"label", line.label}, {"text", line.text}});
  Json times = Json::object();
  session.machine().add_times(times);
  Json warnings = Json::array();
  for (const std::string& each : session.machine().warnings()) warnings.push_back(each);
  return Json{{"status", debugger.status()},
              {"pc", debugger.pc()},
              {"time", debugger.time_text(session.machine().ticks())},
              {"ticks", session.machine().ticks()},
              {"instructions", session.machine().instructions()},
              {"registers", std::move(registers)},
              {"flags", std::move(flags)},
              {"devices", std::move(devices)},
              {"display", std::move(display)},
              {"times", std::move(times)},
              {"warnings", std::move(warnings)}};
}

Json rows_json(MachineSession& session, std::uint32_t from, std::int64_t before, std::int64_t count) {
  Debugger& debugger = session.debugger();
  const std::uint32_t words = session.machine().words();
  std::vector<std::uint32_t> rows;
  if (before > 0) rows = debugger.instructions_before(from, static_cast<std::size_t>(before));
  for (std::uint32_t at = from; std::cmp_less(rows.size(), before + count) && at < words;) {
    rows.push_back(at);
    at += std::max(1U, session.machine().instruction_at(at).words);
  }
  Json lines = Json::array();
  for (const std::uint32_t at : rows) {
    const Machine::Instruction instruction = session.machine().instruction_at(at);
    std::string code;
    for (std::uint32_t i = 0; i < std::max(1U, instruction.words) && at + i < words; ++i)
      code += (code.empty() ? "" : " ") + debugger.word(session.machine().word(at + i));
    const Symbols::Place* const place = debugger.symbols().place(at);
    lines.push_back(Json{{"at", at},
                         {"address", debugger.address(at)},
                         {"code", code},
                         {"text", instruction.text},
                         {"label", debugger.symbols().near(at)},
                         {"source", debugger.symbols().source(at)},
                         {"file", place != nullptr ? Json(place->file) : Json()},
                         {"line", place != nullptr ? Json(place->line) : Json()}});
  }
  return lines;
}

}  // namespace

// A request that runs a machine returns after some seconds, whatever the program does, so that the page stays responsive.
constexpr std::uint64_t most_instructions = 200'000'000;
constexpr int most_slices = 2000;
constexpr std::string_view waits_for_a_key = "waits for a key";

std::string reason_text(const Halted& halted) {
  if (halted.why == Halted::Why::machine && halted.stop.name == waits_for_a_key) return std::string(waits_for_a_key);
  if (!halted.reason.empty()) return halted.reason;
  return halted.stop.complaint.empty() ? std::string(halted.stop.name) : halted.stop.complaint;
}

Json error_answer(std::string_view complaint) { return Json{{"error", complaint}}; }

MachineSession::MachineSession(const MachineDescription& description, machines::Prepared prepared, Symbols symbols)
    : description_(description),
      prepared_(std::move(prepared)),
      debugger_(description, *prepared_.machine, prepared_.limits, std::move(symbols),
                {[this](Machine& machine, const machines::Limits& limits, const std::function<void(std::string_view)>& heard) {
                   std::optional<machines::Stop> stop;
                   while (!stop) {
                     if (spent()) return machines::Stop{machines::interrupted, {}};
                     ++slices_;
                     stop = machine.run(limits, true);
                     const std::string text = machine.take_printed();
                     printed_ += text;
                     heard(text);
                     if (!stop && machine.waits_for_key()) stop = machines::Stop{waits_for_a_key, {}};
                   }
                   return *stop;
                 },
                 [this] { return spent(); }, [this](std::string_view text) { printed_ += text; }}) {
  prepared_.machine->keep_strokes(true);
}

void MachineSession::begin() {
  slices_ = 0;
  begun_at_ = machine().instructions();
}

bool MachineSession::spent() const {
  const std::uint64_t now = prepared_.machine->instructions();
  return slices_ > most_slices || (now > begun_at_ && now - begun_at_ > most_instructions);
}

std::string MachineSession::take_printed() {
  printed_ += machine().take_printed();
  debugger_.forget_printed(debugger_.printed().size());
  return std::exchange(printed_, {});
}

void MachineSession::type(char key) {
  machine().type(code_of_key(description_.radix == 8 ? KeyCodes::parity : KeyCodes::ascii, key));
}

Halted MachineSession::run(std::int64_t until, std::uint64_t instructions) {
  begin();
  Goal goal;
  goal.until = until;
  goal.instructions = instructions;
  return debugger_.run(goal);
}

std::span<const core::Stroke> MachineSession::take_flashes() { return machine().take_strokes(); }

const Bytes* Workbench::file(const std::string& name) const {
  const auto found = files_.find(name);
  return found == files_.end() ? nullptr : &found->second;
}

MachineSession* Workbench::session(int number) {
  const auto found = sessions_.find(number);
  return found == sessions_.end() ? nullptr : found->second.get();
}

int Workbench::add(std::unique_ptr<MachineSession> session) {
  sessions_[++last_] = std::move(session);
  return last_;
}

Json Workbench::make(const Json& request) {
  const std::string from = text_of(request, "snapshot");
  std::optional<Snapshot> snapshot;
  if (!from.empty()) {
    const Bytes* const bytes = file(from);
    if (bytes == nullptr) return error_answer(fmt::format("{}: no such file on the page; drop it first", from));
    auto read = decode_snapshot(*bytes, from);
    if (!read) return error_answer(read.error().message());
    snapshot = std::move(*read);
  }
  const MachineDescription* const description = description_of(snapshot ? snapshot->machine : text_of(request, "machine"));
  if (description == nullptr) return error_answer("found no machine of that name, expected pdp7 or i8080");
  Arguments arguments(description->options);
  if (snapshot) {
    if (std::string complaint = take_configuration(from, *snapshot, *description, arguments); !complaint.empty()) return error_answer(complaint);
    arguments.value("--restore").text = from;
  }
  if (const Json* const options = request.find("options")) {
    if (std::string complaint = take_options(*options, description->options, arguments); !complaint.empty())
      return error_answer(complaint);
  }
  arguments.value("--monitor").flag = true;
  std::string missing;
  auto prepared = machines::prepare(*description, arguments, [&](const std::string& path) {
    const Bytes* const bytes = file(path);
    if (bytes == nullptr) missing = path;
    return Input{path, bytes != nullptr ? *bytes : Bytes()};
  }, [&](Machine& machine, const Input& input) -> base::Result<base::Done> {
    const auto done = restore_snapshot(description->name, machine, input.bytes, input.name);
    if (!done) return base::bad_input(done.error().message());
    return base::Done{};
  });
  if (!missing.empty()) return error_answer(fmt::format("{}: no such file on the page; drop it first", missing));
  if (!prepared) return error_answer(prepared.error().message());
  Symbols symbols(description->radix);
  if (const Json* const table = request.find("symbols"); table != nullptr && table->text() != nullptr)
    static_cast<void>(symbols.add_table(*table->text()));
  if (const Json* const listing = request.find("listing"); listing != nullptr && listing->text() != nullptr)
    symbols.add_listing(*listing->text());
  if (const Json* const lines = request.find("lines")) {
    for (const Json& line : lines->elements()) {
      symbols.add_line(static_cast<std::uint32_t>(whole_of(line, "at")),
                       {text_of(line, "file"), static_cast<std::size_t>(whole_of(line, "line"))});
    }
  }
  Json warnings = Json::array();
  for (const std::string& warning : prepared->warnings) warnings.push_back(warning);
  const int number = add(std::make_unique<MachineSession>(*description, std::move(*prepared), std::move(symbols)));
  return Json{{"id", number}, {"warnings", std::move(warnings)}, {"ticks_a_second", session(number)->machine().ticks_per_second()}};
}

Json Workbench::assemble(const Json& request) {
  const MachineDescription* const description = description_of(text_of(request, "machine"));
  if (description == nullptr) return error_answer("found no machine of that name, expected pdp7 or i8080");
  const Json* const sources = request.find("sources");
  if (sources == nullptr || sources->size() == 0) return error_answer("found no sources, expected some");
  std::vector<assembler::SourceFile> files;
  for (const Json& source : sources->elements()) files.push_back({text_of(source, "name"), text_of(source, "text")});
  Arguments arguments(description->assembler.options);
  // Definitions are an option of the command, not of the language.
  if (const Json* const options = request.find("options")) {
    if (std::string complaint = take_options(*options, description->assembler.options, arguments); !complaint.empty())
      return error_answer(complaint);
  }
  auto assembled = description->assembler.assemble(files, arguments, [&](const std::string& path) -> std::optional<std::string> {
    for (const auto& each : files)
      if (each.name == path) return each.text;
    const Bytes* const bytes = file(path.substr(path.rfind('/') + 1));  // a page has no folders
    if (bytes == nullptr) return std::nullopt;
    return std::string(bytes->begin(), bytes->end());
  });
  if (!assembled) return error_answer(assembled.error().message());
  Json diagnostics = Json::array();
  for (const auto& each : assembled->diagnostics) {
    diagnostics.push_back(Json{{"severity", each.severity == assembler::Severity::error ? "error" : "warning"},
                               {"file", each.file},
                               {"line", each.line},
                               {"column", each.column},
                               {"text", assembler::to_string(each)}});
  }
  Json lines = Json::array();
  for (const auto& line : assembled->lines)
    lines.push_back(Json{{"at", line.address}, {"file", line.file}, {"line", line.line}});
  const bool right = !assembler::any_errors(assembled->diagnostics);
  const std::string name = text_of(request, "name").empty() ? "program" : text_of(request, "name");
  if (right) {
    const auto form = std::find_if(description->formats.begin(), description->formats.end(),
                                   [&](const auto& each) { return each.name == description->assembler.format; });
    auto written = form->write(assembled->program, name);
    if (!written) return error_answer(written.error().message());
    put_file(name, std::move(*written));
  }
  return Json{{"right", right},
              {"diagnostics", std::move(diagnostics)},
              {"listing", assembled->listing},
              {"symbols", assembled->symbol_table},
              {"lines", std::move(lines)},
              {"words", assembled->program.words.size()},
              {"lowest", assembled->program.words.empty() ? Json() : Json(assembled->program.words.front().first)},
              {"highest", assembled->program.words.empty() ? Json() : Json(assembled->program.words.back().first)},
              {"start", assembled->program.start ? Json(*assembled->program.start) : Json()},
              {"program", right ? Json(name) : Json()}};
}

Json Workbench::of_session(MachineSession& session, std::string_view what, const Json& request) {
  session.begin();
  Debugger& debugger = session.debugger();
  Machine& machine = session.machine();
  const auto address = [&]() -> base::Result<std::uint32_t> {
    if (const Json* const at = request.find("at"); at != nullptr && at->text() != nullptr) return debugger.address_of(*at->text());
    const auto number = whole_of(request, "at", -1);
    if (number < 0 || number >= std::int64_t{machine.words()}) return base::bad_input("found no address of this memory");
    return static_cast<std::uint32_t>(number);
  };
  if (what == "state") return state_json(session);
  if (what == "warnings") {
    Json warnings = Json::array();
    for (const std::string& each : machine.take_early_warnings(!flag_of(request, "halted"))) warnings.push_back(each);
    return Json{{"warnings", std::move(warnings)}};
  }
  if (what == "step") {
    const auto count = std::max<std::int64_t>(1, whole_of(request, "count", 1));
    Goal goal;
    goal.instructions = static_cast<std::uint64_t>(count);
    return halted_json(debugger.run(goal));
  }
  if (what == "over") return halted_json(debugger.step_over());
  if (what == "out") {
    auto halted = debugger.step_out();
    return halted ? halted_json(*halted) : error_answer(halted.error().message());
  }
  if (what == "back") {
    const auto done = debugger.back(static_cast<std::uint64_t>(std::max<std::int64_t>(1, whole_of(request, "count", 1))));
    return done ? Json::object() : error_answer(done.error().message());
  }
  if (what == "back_to_breakpoint") {
    const auto found = debugger.back_to_breakpoint();
    if (!found) return error_answer(found.error().message());
    return Json{{"found", found->value_or(false)}};
  }
  if (what == "break") {
    const auto at = address();
    if (!at) return error_answer(at.error().message());
    const auto& all = debugger.breakpoints().all();
    const auto there = std::find_if(all.begin(), all.end(), [&](const Breakpoint& each) {
      return each.kind == Breakpoint::Kind::execution && each.first == *at;
    });
    if (there != all.end()) {
      debugger.breakpoints().remove(there->number);
      return Json{{"set", false}};
    }
    Breakpoint breakpoint;
    breakpoint.first = breakpoint.last = *at;
    breakpoint.condition = text_of(request, "condition");
    breakpoint.text = debugger.address(*at);
    return Json{{"set", true}, {"number", debugger.breakpoints().add(std::move(breakpoint))}};
  }
  if (what == "watch") {
    const auto at = address();
    if (!at) return error_answer(at.error().message());
    Breakpoint breakpoint;
    breakpoint.kind = Breakpoint::Kind::memory;
    breakpoint.first = breakpoint.last = *at;
    breakpoint.access = machines::Probe::is_written;
    breakpoint.text = "write of " + debugger.address(*at);
    return Json{{"number", debugger.breakpoints().add(std::move(breakpoint))}};
  }
  if (what == "breaks") {
    Json breaks = Json::array();
    for (const Breakpoint& each : debugger.breakpoints().all())
      breaks.push_back(Json{{"number", each.number}, {"at", each.first}, {"text", each.text}, {"condition", each.condition}});
    return Json{{"breaks", std::move(breaks)}};
  }
  if (what == "unbreak") {
    if (request.find("number") == nullptr) debugger.breakpoints().clear();
    else debugger.breakpoints().remove(static_cast<int>(whole_of(request, "number")));
    return Json::object();
  }
  if (what == "rows") {
    const auto at = address();
    if (!at) return error_answer(at.error().message());
    return Json{{"rows", rows_json(session, *at, std::clamp<std::int64_t>(whole_of(request, "before"), 0, 200),
                                   std::clamp<std::int64_t>(whole_of(request, "count", 20), 1, 400))}};
  }
  if (what == "memory") {
    const auto at = address();
    if (!at) return error_answer(at.error().message());
    Json words = Json::array();
    const auto count = std::clamp<std::int64_t>(whole_of(request, "count", 128), 1, 4096);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count) && *at + i < machine.words(); ++i)
      words.push_back(debugger.word(machine.word(*at + i)));
    return Json{{"at", *at}, {"address", debugger.address(*at)}, {"words", std::move(words)}};
  }
  if (what == "put") {
    const auto at = address();
    if (!at) return error_answer(at.error().message());
    if (const std::string instruction = text_of(request, "instruction"); !instruction.empty()) {
      const auto done = debugger.put_instruction(*at, instruction);
      return done ? Json::object() : error_answer(done.error().message());
    }
    const auto word = whole_of(request, "word", -1);
    if (word < 0 || (word >> session.description().word_bits) != 0)
      return error_answer(fmt::format("found no word of {} bits", session.description().word_bits));
    debugger.put(*at, static_cast<std::uint32_t>(word));
    return Json::object();
  }
  if (what == "set") {
    const auto number = debugger.register_named(text_of(request, "register"));
    if (!number) return error_answer("there is no register of that name");
    const auto value = whole_of(request, "value", -1);
    if (value < 0 || (value >> session.description().registers[*number].bits) != 0) return error_answer("the register is too small for that value");
    debugger.set(*number, static_cast<std::uint32_t>(value));
    return Json::object();
  }
  if (what == "start") {
    const auto at = address();
    if (!at) return error_answer(at.error().message());
    debugger.start(*at);
    return Json::object();
  }
  if (what == "history") {
    Json lines = Json::array();
    for (const auto& entry : debugger.history(static_cast<std::size_t>(std::clamp<std::int64_t>(whole_of(request, "count", 50), 1, 1000))))
      lines.push_back(machine.history_line(entry));
    return Json{{"lines", std::move(lines)}};
  }
  if (what == "stack") {
    Json frames = Json::array();
    for (const Frame& frame : debugger.stack())
      frames.push_back(Json{{"caller", debugger.address(frame.caller)}, {"entry", debugger.address(frame.entry)}, {"label", debugger.symbols().near(frame.entry)}});
    return Json{{"frames", std::move(frames)}};
  }
  if (what == "who") {
    const auto at = address();
    if (!at) return error_answer(at.error().message());
    const auto writer = debugger.last_writer(*at);
    if (!writer) return Json{{"text", "nothing has written it since the machine was made"}};
    return Json{{"text", debugger.instruction_text(writer->pc)}, {"pc", writer->pc}, {"time", debugger.time_text(writer->event.time)}};
  }
  if (what == "evaluate") {
    const auto value = debugger.evaluate(text_of(request, "text"));
    return value ? Json{{"value", *value}} : error_answer(value.error().message());
  }
  if (what == "symbols") {
    Json symbols = Json::array();
    for (const auto& [name, value] : debugger.symbols().all()) symbols.push_back(Json{{"name", name}, {"value", value}});
    return Json{{"symbols", std::move(symbols)}};
  }
  if (what == "attach") {
    const std::string name = text_of(request, "file");
    const Bytes* const bytes = file(name);
    Input input{name, bytes != nullptr ? *bytes : Bytes()};
    if (request.find("text") != nullptr) {
      const std::string text = text_of(request, "text");
      input = {"the page", Bytes(text.begin(), text.end())};
    } else if (bytes == nullptr && !name.empty()) {
      return error_answer(fmt::format("{}: no such file on the page; drop it first", name));
    }
    const auto done = machine.attach(text_of(request, "device"), input);
    return done ? Json::object() : error_answer(done.error().message());
  }
  if (what == "load") {
    const std::string name = text_of(request, "file");
    const Bytes* const bytes = file(name);
    if (bytes == nullptr) return error_answer(fmt::format("{}: no such file on the page; drop it first", name));
    const auto program = machines::read_program(session.description(), {name, {}}, {name, *bytes}, {}, nullptr);
    if (!program) return error_answer(program.error().message());
    for (const auto& [where, word] : program->words) {
      if (where >= machine.words()) return error_answer(fmt::format("{}: found a word for {}, beyond this memory", name, debugger.address(where)));
      debugger.put(where, word);
    }
    debugger.set_symbols(Symbols(session.description().radix));  // removes those of the previous program
    if (program->start && flag_of(request, "start")) debugger.start(*program->start);
    return Json{{"words", program->words.size()}, {"start", program->start ? Json(*program->start) : Json()}};
  }
  if (what == "save") {
    made_ = debugger.save();
    return Json{{"bytes", made_.size()}};
  }
  if (what == "restore") {
    const std::string name = text_of(request, "file");
    const Bytes* const bytes = file(name);
    if (bytes == nullptr) return error_answer(fmt::format("{}: no such file on the page; drop it first", name));
    const auto done = debugger.restore(*bytes, name);
    return done ? Json::object() : error_answer(done.error().message());
  }
  return error_answer(fmt::format("there is no request \"{}\"", what));
}

Json Workbench::answer(const Json& request) {
  const std::string what = text_of(request, "do");
  if (what == "make") return make(request);
  if (what == "assemble") return assemble(request);
  if (what == "file") {
    const Bytes* const bytes = file(text_of(request, "name"));
    if (bytes == nullptr) return error_answer("no such file on the page");
    made_ = *bytes;
    return Json{{"bytes", made_.size()}};
  }
  const auto number = static_cast<int>(whole_of(request, "id", -1));
  if (what == "drop") {
    sessions_.erase(number);
    return Json::object();
  }
  MachineSession* const found = session(number);
  if (found == nullptr) return error_answer("there is no machine of that number");
  return of_session(*found, what, request);
}

}  // namespace sightline::live::web
