#include "host/app/commands/monitor_session.hpp"

#include <editline/readline.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/app/commands/machine_command.hpp"
#include "host/app/outputs.hpp"
#include "host/base/terminal.hpp"
#include "host/live/console.hpp"
#include "host/live/monitor/monitor.hpp"

namespace sightline::app {

namespace {

using machines::Arguments;
using machines::Machine;

// --- Lines ---

// The file that keeps the history between sessions; empty: none.
std::filesystem::path history_file() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  const char* const home = std::getenv("HOME");
  if (state != nullptr && *state != '\0') return std::filesystem::path(state) / "sightline" / "monitor";
  if (home != nullptr && *home != '\0') return std::filesystem::path(home) / ".local/state/sightline/monitor";
  return {};
}

// Reads a character for libedit, whose own function would pass a signal on to all processes of the terminal. EOF at the end of
// the input and after a signal.
int next_character(std::FILE*) {
  std::string bytes;
  while (base::EndSignals::received() == 0) {
    unsigned char byte = 0;
    const ssize_t n = ::read(STDIN_FILENO, &byte, 1);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return EOF;
    bytes += static_cast<char>(byte);
    wchar_t character = 0;
    std::mbstate_t whole{};
    const std::size_t length = std::mbrtowc(&character, bytes.data(), bytes.size(), &whole);
    if (length == static_cast<std::size_t>(-2)) continue;  // its other bytes follow
    return length == static_cast<std::size_t>(-1) ? byte : static_cast<int>(character);
  }
  return EOF;
}

// The monitor that completes names; a global because libedit calls a plain function.
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
  // nullopt: the input has ended.
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
    rl_catch_signals = 0;
    rl_getc_function = &next_character;
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
  // Ctrl-C discards the line.
  std::optional<std::string> next(const std::string& prompt) override {
    for (;;) {
      const std::unique_ptr<char, void (*)(void*)> line(readline(prompt.c_str()), &std::free);
      if (base::EndSignals::received() == SIGINT) {
        static_cast<void>(base::write_now(STDOUT_FILENO, "^C\n"));
        base::EndSignals::forget();
        continue;
      }
      if (base::EndSignals::received() != 0) return std::nullopt;
      if (!line) {
        static_cast<void>(base::write_now(STDOUT_FILENO, "\n"));  // after Ctrl-D
        return std::nullopt;
      }
      if (*line != '\0') add_history(line.get());
      return std::string(line.get());
    }
  }
 private:
  std::filesystem::path file_;
};

// --- A session ---

// Prints the program's output and records whether its last line has ended.
class Printer {
 public:
  bool print(std::string_view text) {
    if (text.empty()) return true;
    open_ = text.back() != '\n';
    unread_ = unread_ || !base::write_now(STDOUT_FILENO, text);
    return !unread_;
  }
  void end_line() {
    if (open_) static_cast<void>(print("\n"));
  }
  // Whether nobody reads the output any more.
  [[nodiscard]] bool unread() const { return unread_; }

 private:
  bool open_ = false;
  bool unread_ = false;
};

using Heard = std::function<void(std::string_view)>;

// The operator at a terminal; the monitor receives what is printed.
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

machines::Stop run_without_console(Machine& machine, const machines::Limits& limits, Printer& printer, const Heard& heard) {
  std::optional<machines::Stop> stop;
  while (!stop) {
    stop = machine.run(limits, true);
    // The monitor runs a machine in parts with a limit of instructions.
    if (!stop || stop->name == "instruction_limit")
      for (const std::string& warning : machine.take_early_warnings()) warn(warning);
    const std::string text = live::shown_text(machine.take_printed());
    heard(text);
    if (!printer.print(text) && !stop) stop = machines::Stop{machines::interrupted, {}};
    if (!stop && base::EndSignals::received() != 0) stop = machines::Stop{machines::interrupted, {}};
    if (!stop && machine.waits_for_key())
      stop = machines::Stop{live::end_of_input, std::string(live::no_key)};
  }
  return *stop;
}

// The signal that ends the session; 0: none. At a prompt, Ctrl-C only stops the current command. A session also ends if nobody
// reads its output any more.
int ending_signal(const Printer& printer, bool terminal) {
  const int received = base::EndSignals::received();
  if (received != 0 && !(terminal && received == SIGINT)) return received;
  return printer.unread() ? SIGPIPE : 0;  // a closed terminal sends no signal
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

}  // namespace

int radix_of(const Arguments& arguments) {
  const std::string& radix = arguments.text("--radix");
  return radix.empty() ? 0 : radix == "16" ? 16 : radix == "10" ? 10 : 8;
}

std::string dialect_of(const Arguments& arguments) {
  return arguments.given("--dialect") ? arguments.text("--dialect") : std::string();
}

live::MonitorHost files_of_commands() {
  live::MonitorHost host;
  host.read = [](const std::string& path) -> base::Result<machines::Input> {
    auto bytes = base::read_file(path);
    if (!bytes) return base::bad_input(bytes.error().message());
    return machines::Input{path, std::move(*bytes)};
  };
  host.write = [](const std::string& path, std::span<const std::uint8_t> bytes) -> base::Result<base::Done> {
    const auto done = base::write_file_atomically(path, bytes);
    if (!done) return base::bad_input(done.error().message());
    return base::Done{};
  };
  host.speed = [](const std::string&) -> base::Result<base::Done> {
    return base::usage_error("there is no console; begin with --console MODE");
  };
  return host;
}

ExitCode run_monitor_session(MonitorSetup setup) {
  Machine& machine = setup.machine;
  const Arguments& arguments = setup.arguments;
  const bool terminal = base::stdin_is_terminal();
  const bool console = arguments.given("--console");
  std::optional<live::ConsoleOptions> console_options;
  if (console) console_options = value_of(live::console_options(arguments, terminal));

  Printer printer;
  const base::EndSignals signals;
  // A command may run the machine in parts: the terminal stays in raw mode until the command has ended.
  std::optional<base::RawTerminal> raw_terminal;
  live::MonitorHost host = files_of_commands();
  host.running.run = [&](Machine& running, const machines::Limits& limits, const Heard& heard) {
    if (!console_options || !terminal) return run_without_console(running, limits, printer, heard);
    if (!raw_terminal) raw_terminal.emplace();
    Person person(printer, heard);
    return live::run_console(running, limits, *console_options, person);
  };
  host.running.person_types = terminal && console;
  host.running.nobody_interrupts = !terminal;
  host.running.interrupted = [] { return base::EndSignals::received() != 0; };
  host.running.print = [&printer](std::string_view text) { static_cast<void>(printer.print(text)); };
  host.speed = [&](const std::string& text) -> base::Result<base::Done> {
    if (!console_options) return base::usage_error("there is no console; begin with --console MODE");
    Arguments changed = arguments;
    changed.value("--speed").text = text;
    auto options = live::console_options(changed, terminal);
    if (!options) return options.error();
    console_options = *options;
    return base::Done{};
  };
  host.person = terminal;
  live::Monitor session(setup.description, machine, setup.limits, std::move(setup.symbols), std::move(host));

  if (const int radix = radix_of(arguments); radix != 0) session.set_radix(radix);
  session.set_dialect(dialect_of(arguments));
  if (console_options) session.set_key_codes(console_options->codes);

  std::unique_ptr<Lines> lines;
  if (terminal) {
    fmt::print("{}help lists the commands.\n", session.status());
    lines = std::make_unique<EditedLines>(session);
  } else {
    lines = std::make_unique<PipedLines>();
  }
  const std::string prompt = std::string(setup.description.name) + "> ";
  live::Answer answer;
  const std::vector<std::string> first = arguments.list("--do");
  for (std::size_t n = 0; answer.kind != live::Answer::Kind::quit && ending_signal(printer, terminal) == 0; ++n) {
    if (base::EndSignals::received() != 0) base::EndSignals::forget();
    std::optional<std::string> line;
    static_cast<void>(std::fflush(stdout));
    if (n < first.size()) {
      line = "do \"" + first[n] + "\"";
    } else {
      line = lines->next(prompt);
    }
    if (!line) break;
    answer = session.execute(*line);
    raw_terminal.reset();
    if (!answer.text.empty()) printer.end_line();
    static_cast<void>(printer.print(answer.text));
    // At a prompt an error is printed; in a file of commands it ends the session.
    const bool failed = answer.kind == live::Answer::Kind::wrong || answer.kind == live::Answer::Kind::failed;
    if (failed && !terminal && ending_signal(printer, terminal) == 0) {
      static_cast<void>(printer.print(session.finish().text));
      return exit_code_of(answer.kind);
    }
  }
  printer.end_line();
  const live::Answer last = session.finish();
  static_cast<void>(printer.print(last.text));
  machine.finish();
  if (last.kind == live::Answer::Kind::wrong && ending_signal(printer, terminal) == 0) return exit_code_of(last.kind);
  const int signal = ending_signal(printer, terminal);
  return signal == 0 ? ExitCode::ok : static_cast<ExitCode>(128 + signal);
}

}  // namespace sightline::app
