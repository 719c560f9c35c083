// `sightline monitor`: a machine stopped, looked into and run on, at a prompt or by a file of commands.
#include <editline/readline.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/machine_command.hpp"
#include "host/app/outputs.hpp"
#include "host/base/progress.hpp"
#include "host/base/terminal.hpp"
#include "host/live/console.hpp"
#include "host/live/monitor.hpp"

namespace sightline::app {

namespace {

using guests::run::Arguments;
using guests::run::Machine;
using guests::run::MachineDescription;
using guests::run::OptionKind;

// --- Programs ---

// The programs of a command line, with those that are sources assembled in place, and the symbols of all.
struct Programs {
  std::map<std::string, base::Bytes> assembled;  // under the names that --load has for them now
  live::Symbols symbols;
};

// Replaces sources in --load by what they assemble to. Failure bad_input.
Programs assemble_sources(const MachineDescription& machine, Arguments& arguments) {
  Programs programs{{}, live::Symbols(machine.radix)};
  const auto form = std::find_if(machine.formats.begin(), machine.formats.end(), [&machine](const auto& format) {
    return format.name == machine.assembler.format;
  });
  for (std::string& path : arguments.value("--load").list) {
    if (!guests::run::named_as_source(path)) continue;
    const std::vector<assembler::SourceFile> sources{{path, read_input_text(path)}};
    Arguments options(machine.assembler.options);
    options.value("--listing").flag = true;
    const auto assembled = accepted(machine.assembler.assemble(sources, options, read_include));
    for (const auto& diagnostic : assembled.diagnostics)
      fmt::print(stderr, "{}\n", assembler::to_string(diagnostic));
    if (assembler::any_errors(assembled.diagnostics))
      throw Failure(ExitCode::bad_input, path + ": the source has errors");
    static_cast<void>(programs.symbols.add_table(assembled.symbol_table));
    programs.symbols.add_listing(assembled.listing);
    path += std::string(": ") + std::string(form->name);
    programs.assembled[path] = accepted(form->write(assembled.program, path));
  }
  for (const std::string& path : arguments.list("--symbols"))
    static_cast<void>(value_of(programs.symbols.add_table(read_input_text(path)), path));
  for (const std::string& path : arguments.list("--listing")) programs.symbols.add_listing(read_input_text(path));
  return programs;
}

// --- Lines ---

// Where the lines of the history are kept between sessions; empty: nowhere.
std::filesystem::path history_file() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  const char* const home = std::getenv("HOME");
  if (state != nullptr && *state != '\0') return std::filesystem::path(state) / "sightline" / "monitor";
  if (home != nullptr && *home != '\0') return std::filesystem::path(home) / ".local/state/sightline/monitor";
  return {};
}

// The one monitor whose names are completed: libedit calls a plain function.
const live::Monitor* completed_monitor = nullptr;

char* next_completion(const char* begun, int state) {
  static std::vector<std::string> names;
  static std::size_t next = 0;
  if (state == 0) {
    next = 0;
    names = completed_monitor == nullptr ? std::vector<std::string>{}
                                         : completed_monitor->completions(rl_line_buffer, begun);
  }
  return next < names.size() ? strdup(names[next++].c_str()) : nullptr;
}

class Lines {
 public:
  virtual ~Lines() = default;
  // nullopt: no more.
  virtual std::optional<std::string> next(const std::string& prompt) = 0;
};

class PipedLines final : public Lines {
 public:
  std::optional<std::string> next(const std::string&) override {
    std::string line;
    if (!std::getline(std::cin, line)) return std::nullopt;
    return line;
  }
};

class EditedLines final : public Lines {
 public:
  explicit EditedLines(const live::Monitor& monitor) : file_(history_file()) {
    completed_monitor = &monitor;
    rl_readline_name = const_cast<char*>("sightline");
    rl_completion_entry_function = &next_completion;
    using_history();
    stifle_history(1000);
    if (!file_.empty()) static_cast<void>(read_history(file_.c_str()));
  }
  ~EditedLines() override {
    completed_monitor = nullptr;
    std::error_code ignored;
    if (file_.empty()) return;
    std::filesystem::create_directories(file_.parent_path(), ignored);
    static_cast<void>(write_history(file_.c_str()));
  }
  std::optional<std::string> next(const std::string& prompt) override {
    const std::unique_ptr<char, void (*)(void*)> line(readline(prompt.c_str()), &std::free);
    if (!line) return std::nullopt;
    if (*line != '\0') add_history(line.get());
    return std::string(line.get());
  }

 private:
  std::filesystem::path file_;
};

// --- A session ---

// What the program prints, and whether the line is still open.
class Printer {
 public:
  bool print(std::string_view text) {
    if (text.empty()) return true;
    open_ = text.back() != '\n';
    return base::write_now(STDOUT_FILENO, text);
  }
  void end_line() {
    if (open_) static_cast<void>(print("\n"));
  }

 private:
  bool open_ = false;
};

using Heard = std::function<void(std::string_view)>;

// The operator at a terminal, whose monitor hears what is printed.
class Person final : public live::Operator {
 public:
  Person(Printer& printer, const Heard& heard) : printer_(printer), heard_(heard) {}
  std::optional<std::string> keys(int milliseconds) override { return base::read_stdin_within(milliseconds); }
  bool print(std::string_view text) override {
    heard_(text);
    return printer_.print(text);
  }
  bool at_terminal() const override { return true; }

 private:
  Printer& printer_;
  const Heard& heard_;
};

guests::run::Stop run_plainly(Machine& machine, const guests::run::Limits& limits, Printer& printer, const Heard& heard) {
  std::optional<guests::run::Stop> stop;
  while (!stop) {
    stop = machine.run(limits, true);
    const std::string text = live::shown_text(machine.take_printed());
    heard(text);
    static_cast<void>(printer.print(text));
    if (!stop && base::InterruptKey::pressed()) stop = guests::run::Stop{guests::run::interrupted, {}};
    if (!stop && machine.waits_for_key()) stop = guests::run::Stop{live::end_of_input, {}};
  }
  return *stop;
}

ExitCode exit_code_of(live::Answer::Kind kind) {
  switch (kind) {
    case live::Answer::Kind::wrong: return ExitCode::usage;
    case live::Answer::Kind::failed: return ExitCode::differs;
    case live::Answer::Kind::done:
    case live::Answer::Kind::quit: break;
  }
  return ExitCode::ok;
}

ExitCode monitor(const MachineDescription& description, Arguments arguments) {
  arguments.value("--monitor").flag = true;
  Programs programs = assemble_sources(description, arguments);
  const auto prepared = accepted(prepare(description, arguments, [&programs](const std::string& path) {
    const auto found = programs.assembled.find(path);
    return found == programs.assembled.end() ? read_named(path) : guests::run::Input{path, found->second};
  }));
  for (const std::string& warning : prepared.warnings) warn(warning);
  Machine& machine = *prepared.machine;
  const bool terminal = base::stdin_is_terminal();
  const bool console = arguments.given("--console");
  std::optional<live::ConsoleOptions> console_options;
  if (console) console_options = accepted(live::console_options(arguments, terminal));

  Printer printer;
  // A command may run the machine in pieces: the terminal is raw until it has ended.
  struct Live {
    base::EndSignals signals;
    base::RawTerminal raw;
  };
  std::optional<Live> live_terminal;
  live::MonitorHost host;
  host.running.run = [&](Machine& running, const guests::run::Limits& limits, const Heard& heard) {
    if (!console_options || !terminal) return run_plainly(running, limits, printer, heard);
    if (!live_terminal) live_terminal.emplace();
    Person person(printer, heard);
    return live::run_console(running, limits, *console_options, person);
  };
  host.running.interrupted = [] { return base::InterruptKey::pressed(); };
  host.running.print = [&printer](std::string_view text) { static_cast<void>(printer.print(text)); };
  host.read = [](const std::string& path) -> guests::run::Result<guests::run::Input> {
    auto bytes = base::read_file(path);
    if (!bytes) return guests::run::bad_input(bytes.error().message());
    return guests::run::Input{path, std::move(*bytes)};
  };
  host.write = [](const std::string& path, std::span<const std::uint8_t> bytes) -> guests::run::Result<base::Done> {
    const auto done = base::write_file_atomically(path, bytes);
    if (!done) return guests::run::bad_input(done.error().message());
    return base::Done{};
  };
  host.speed = [&](const std::string& text) -> guests::run::Result<base::Done> {
    if (!console_options) return guests::run::usage("there is no console; begin with --console MODE");
    Arguments changed = arguments;
    changed.value("--speed").text = text;
    auto options = live::console_options(changed, terminal);
    if (!options) return options.error();
    console_options = *options;
    return base::Done{};
  };
  live::Monitor session(description, machine, prepared.limits, std::move(programs.symbols), std::move(host));

  std::unique_ptr<Lines> lines;
  if (terminal) {
    fmt::print("{}help lists the commands.\n", session.status());
    lines = std::make_unique<EditedLines>(session);
  } else {
    lines = std::make_unique<PipedLines>();
  }
  const std::string prompt = std::string(description.name) + "> ";
  live::Answer answer;
  std::vector<std::string> first = arguments.list("--do");
  for (std::size_t n = 0; answer.kind != live::Answer::Kind::quit; ++n) {
    std::optional<std::string> line;
    static_cast<void>(std::fflush(stdout));
    if (n < first.size()) {
      line = "do \"" + first[n] + "\"";
    } else {
      line = lines->next(prompt);
    }
    if (!line) break;
    {
      const base::InterruptKey key;
      answer = session.execute(*line);
      live_terminal.reset();
    }
    if (!answer.text.empty()) printer.end_line();
    static_cast<void>(printer.print(answer.text));
    // What goes wrong at a prompt is told; in a file of commands it ends the session.
    const bool failed = answer.kind == live::Answer::Kind::wrong || answer.kind == live::Answer::Kind::failed;
    if (failed && !terminal) return exit_code_of(answer.kind);
  }
  printer.end_line();
  machine.finish();
  return ExitCode::ok;
}

std::vector<guests::run::Option> monitor_options(const MachineDescription& machine) {
  std::vector<guests::run::Option> options;
  for (guests::run::Option option : machine.options) {
    if (option.kind == OptionKind::stream || option.kind == OptionKind::step || option.name == "--json") continue;
    if (option.kind == OptionKind::output) continue;
    options.push_back(option);
  }
  options.push_back({OptionKind::list, "--symbols", "FILE", "Symbols of the program, as `sightline asm --symbols` writes them"});
  options.push_back({OptionKind::list, "--listing", "FILE", "Its listing, whose lines are shown with the instructions"});
  options.push_back({OptionKind::list, "--do", "FILE", "Commands to begin with"});
  return options;
}

}  // namespace

void add_monitor_command(const Command& program) {
  const Command command = program.add_command("monitor", help_page("monitor"));
  for (const MachineDescription* machine : guests::run::machines()) {
    const HelpPage help = help_page("monitor_machine", {{"machine", std::string(machine->name)}});
    add_machine_command(command, machine->name, help, monitor_options(*machine),
                        [machine](const Arguments& arguments) { return monitor(*machine, arguments); });
  }
}

}  // namespace sightline::app
