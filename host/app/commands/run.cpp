// `sightline run`: runs any program on an emulated machine with the requested devices.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/machine_command.hpp"
#include "host/app/commands/monitor_session.hpp"
#include "host/app/commands/program_sources.hpp"
#include "host/app/outputs.hpp"
#include "host/base/progress.hpp"
#include "host/base/terminal.hpp"
#include "host/machines/vcd.hpp"
#include "host/live/console.hpp"
#include "host/live/snapshot.hpp"

namespace sightline::app {

namespace {

using machines::Arguments;
using machines::Machine;
using machines::MachineDescription;
using machines::OptionKind;

// The programs and the tape, which no output may replace. A program may have @ADDRESS behind its name.
std::vector<std::string> inputs_of(const MachineDescription& description, const Arguments& arguments) {
  std::vector<std::string> inputs;
  for (const machines::Option& option : description.options) {
    if (option.name == "--tape" && arguments.given(option.name)) inputs.push_back(arguments.text(option.name));
    if (option.kind != OptionKind::files) continue;
    for (const std::string& file : arguments.list(option.key())) {
      inputs.push_back(file);
      if (const std::size_t at = file.rfind('@'); at != std::string::npos) inputs.push_back(file.substr(0, at));
    }
  }
  return inputs;
}

// The files that a run writes: opened before it, written during and after it, committed at the end.
class RunOutputs {
 public:
  // Error usage: a path is named twice or is one of `inputs`, or more than one output goes to standard output. Error io: one cannot be written.
  RunOutputs(const MachineDescription& description, const Arguments& arguments, const std::vector<std::string>& inputs) {
    const bool json = arguments.given("--json");
    std::string stdout_twice = "-: named for two outputs";
    for (const machines::Option& option : description.options) {
      if (option.kind != OptionKind::output && option.kind != OptionKind::stream) continue;
      std::string path = arguments.text(option.key());
      if (option.key() == "--vcd" && !path.empty()) {
        const std::string found = std::exchange(path, machines::vcd_target(path).file);
        if (path.empty()) throw base::usage_error(fmt::format("--vcd: found \"{}\", expected FILE or FILE:SIGNALS", found));
      }
      if (path.empty() && !json && !arguments.given("--console") && arguments.given(option.stdout_with)) {
        path = "-";
        stdout_twice = "-: standard output has " + std::string(option.content) + "; " + option.name +
                       " FILE puts that elsewhere";
      }
      if (!path.empty()) files_.push_back({&option, path, std::nullopt});
    }
    for (const File& file : files_) {
      const auto is_same = [&file](const std::string& input) { return file.path != "-" && are_one_file(file.path, input); };
      if (std::any_of(inputs.begin(), inputs.end(), is_same))
        throw base::usage_error(fmt::format("{}: found {}, expected no file that is an input of this run", file.option->name, file.path));
    }
    std::vector<NamedOutput> named;
    for (File& file : files_) named.push_back({&file.path, &file.output});
    uses_stdout_ = open_outputs(named, json, stdout_twice);
    if (uses_stdout_ && arguments.given("--console"))
      throw base::usage_error("--console needs standard output; an output cannot be `-`");
  }

  // Connects the machine's streams to their files. This object must outlive the run.
  void attach(Machine& machine) {
    for (File& file : files_) {
      if (file.option->kind != OptionKind::stream) continue;
      machine.take(file.option->key(), [&file](std::string_view text) { file.output->write(text); });
    }
  }
  // Writes the results of the run and commits all files. Error io.
  void write(const MachineDescription& description, Machine& machine) {
    for (File& file : files_) {
      if (file.option->kind != OptionKind::output) continue;
      if (file.option->key() == "--dump") {
        file.output->write(dump_text(description, machine));
      } else if (file.option->key() == "--save") {
        file.output->write(std::span<const std::uint8_t>(live::save_snapshot(description.name, machine)));
      } else {
        file.output->write(std::span<const std::uint8_t>(machine.output(file.option->key())));
      }
    }
    for (File& file : files_) file.output->commit();
  }

  [[nodiscard]] bool uses_stdout() const { return uses_stdout_; }

 private:
  struct File {
    const machines::Option* option;
    std::string path;
    std::optional<Output> output;
  };
  std::list<File> files_;
  bool uses_stdout_ = false;
};

struct Ended {
  machines::Stop stop;
  int signal = 0;  // the signal that ended it, 0: none; SIGPIPE: nobody reads the program's output
};

Ended run_to_stop(const machines::Prepared& prepared, const Arguments& arguments) {
  const base::EndSignals signals;
  // Without a disk nothing must be saved if nobody reads the output: the process ends at once, like other filters.
  if (!arguments.given("--disk")) static_cast<void>(std::signal(SIGPIPE, SIG_DFL));
  base::ProgressLine line;
  // Counted in instructions, not in time, so that the messages of a run are the same each time.
  constexpr std::uint64_t instructions_between_warnings = std::uint64_t{1} << 15;
  std::uint64_t next_warnings = 0;
  machines::Stop stop = machines::run_to_stop(
      *prepared.machine, prepared.limits, [&](const machines::Progress& progress) {
        if (progress.instructions >= next_warnings) {
          next_warnings = progress.instructions + instructions_between_warnings;
          for (const std::string& warning : prepared.machine->take_early_warnings()) {
            line.clear();
            warn(warning);
          }
        }
        line.show_run(static_cast<std::uint64_t>(core::nanoseconds_of(progress.now)), progress.instructions);
        return base::EndSignals::received() == 0 && std::ferror(stdout) == 0;  // the disk may be full
      });
  return {std::move(stop), base::EndSignals::received()};
}

// Whether a person types, not a script or a pipe.
bool person_types(const Arguments& arguments) {
  return arguments.given("--console") && base::stdin_is_terminal() && arguments.steps().empty();
}

// Runs with a console: a person at a terminal, a pipe, or a script. The program's output goes to standard output, with --json
// to standard error.
Ended run_on_console(const machines::Prepared& prepared, const Arguments& arguments) {
  const bool person = person_types(arguments);
  const live::ConsoleOptions options = value_of(live::console_options(arguments, base::stdin_is_terminal()));
  const base::EndSignals signals;
  std::optional<base::RawTerminal> raw;
  if (person) {
    static_cast<void>(std::fputs("Ctrl-E enters the monitor; `quit` there ends the run.\n", stderr));
    raw.emplace();
  }
  const auto operator_ = live::standard_operator(
      arguments.given("--json") ? STDERR_FILENO : STDOUT_FILENO, person);
  machines::Stop stop = live::run_console(*prepared.machine, prepared.limits, options, *operator_);
  if (person) static_cast<void>(base::write_now(STDERR_FILENO, "\r\n"));
  return {std::move(stop), base::EndSignals::received()};
}

ExitCode run(const MachineDescription& description, Arguments arguments) {
  const bool person = person_types(arguments);
  if (person) arguments.value("--monitor").flag = true;
  const auto restore = [&description](Machine& machine,
                                      const machines::Input& snapshot) -> base::Result<base::Done> {
    const auto done = live::restore_snapshot(description.name, machine, snapshot.bytes, snapshot.name);
    if (!done) return base::bad_input(done.error().message());
    return base::Done{};
  };
  check_disk(arguments);
  const std::vector<std::string> inputs = inputs_of(description, arguments);  // before the sources become programs
  Programs programs = assemble_sources(description, arguments, "run");
  const machines::Prepared prepared = value_of(prepare(description, arguments, programs.reader(), restore));
  for (const std::string& warning : prepared.warnings) warn(warning);
  Machine& machine = *prepared.machine;
  RunOutputs outputs(description, arguments, inputs);
  outputs.attach(machine);
  const bool console = arguments.given("--console");
  Ended ended = console ? run_on_console(prepared, arguments) : run_to_stop(prepared, arguments);
  const machines::Stop& stop = ended.stop;
  if (person && stop.name == live::stopped_by_ctrl_e) {
    const ExitCode code =
        run_monitor_session({description, machine, prepared.limits, std::move(programs.symbols), arguments});
    ended.signal = std::max(0, static_cast<int>(code) - 128);
  }
  for (const std::string& warning : machine.warnings()) warn(warning);
  // If a disk cannot be written, the other files are still written.
  std::optional<base::Error> disk_failure;
  try {
    write_media_back(machine);
  } catch (const base::Error& error) {
    disk_failure = error;
  }
  outputs.write(description, machine);
  if (arguments.given("--json")) {
    base::Json report = json_report(description, machine, stop);
    if (arguments.given("--restore")) report["restored_from"] = arguments.text("--restore");
    if (arguments.given("--save")) report["saved_to"] = arguments.text("--save");
    print_json(report);
  } else if (!outputs.uses_stdout() && !console) {
    write_stdout(table_report(description, machine, stop));
  } else {
    // On a terminal it would otherwise continue the program's last line.
    if (!person && base::stderr_is_terminal()) static_cast<void>(std::fputs("\n", stderr));
    static_cast<void>(std::fputs(table_report(description, machine, stop).c_str(), stderr));
  }
  if (disk_failure) throw *disk_failure;
  if (stop.name == machines::interrupted && ended.signal == 0) {
    print_message("stopped: standard output takes no more; all outputs hold what was done so far");
    return ExitCode::io;
  }
  if (ended.signal == SIGINT && !console) {
    print_message("stopped by Ctrl-C; all outputs hold what was done so far");
  } else if (ended.signal != 0 && ended.signal != SIGPIPE) {
    print_message(fmt::format("stopped by signal {}; all outputs hold what was done so far", ended.signal));
  }
  if (ended.signal != 0) return static_cast<ExitCode>(128 + ended.signal);
  if (stop.complaint.empty()) return ExitCode::ok;
  print_message(stop.complaint);
  return stop.exit_code != 0 ? static_cast<ExitCode>(stop.exit_code) : ExitCode::guest_failed;
}

}  // namespace

void add_run_command(const Command& program) {
  const Command command = program.add_command("run", help_page("run"));
  for (const MachineDescription* machine : machines::machines()) {
    HelpPage help =
        help_page("run_" + std::string(machine->name), {{"summary", std::string(machine->help)}});
    help.text += machine->more_help;
    std::vector<machines::Option> options = machine->options;
    if (const auto* const dialect = dialect_option(*machine)) options.push_back(*dialect);
    add_machine_command(command, machine->name, help, options,
                        [machine](const Arguments& arguments) { return run(*machine, arguments); });
  }
}

}  // namespace sightline::app
