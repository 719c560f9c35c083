// The command `sightline`: finds the subcommand, prints what it fails with, and gives its exit code.
//
// Exit codes are this program's own (command.hpp), not those of the command-line library.
#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "host/app/commands/asm.hpp"
#include "host/app/command.hpp"
#include "host/app/commands/compare.hpp"
#include "host/app/commands/demo.hpp"
#include "host/app/commands/disasm.hpp"
#include "host/app/commands/draw.hpp"
#include "host/app/help_formatter.hpp"
#include "host/app/commands/jones.hpp"
#include "host/app/commands/report.hpp"
#include "host/app/commands/run.hpp"
#include "host/app/commands/scene.hpp"
#include "host/app/commands/skala.hpp"
#include "host/app/commands/spin.hpp"
#include "host/app/commands/sweep.hpp"

namespace {

using sightline::app::ExitCode;

constexpr const char* sightline_examples =
    "Examples:\n"
    "  sightline jones house -o out\n"
    "      run Jones's program on a scene: pictures in out/, times on the terminal\n"
    "  sightline skala lines sinc -o out\n"
    "      run Skala's program on the 8080: a function of two variables with its hidden lines removed\n"
    "  sightline draw exact part.off -o part.svg\n"
    "      a solid drawn by a program of today\n"
    "  sightline draw skala sinc -o sinc.svg\n"
    "      the same function drawn today, as vectors\n"
    "  sightline asm pdp7 hello.s -o hello.rim && sightline run pdp7 --load hello.rim\n"
    "      assemble a program of your own and run it on the PDP-7\n\n"
    "`sightline jones` and `sightline skala` run the old programs themselves on emulated machines, with "
    "their "
    "limits and in their time. `sightline draw jones` and `sightline draw skala` draw by the same methods, "
    "written for today's machines: any scene, any grid.\n\n"
    "Words:\n"
    "  guest   the old program on its emulated machine: Jones's on the PDP-7, Skala's on the 8080\n"
    "  twin    what a guest computes, bit for bit, written again for this computer without the emulator\n"
    "  native  a method of 1971 to 1990, or an exact one of today, written for this computer\n"
    "  oracle  the slow and simple program that all are checked by; it shares no visibility code with "
    "them\n\n"
    "`sightline COMMAND --help` explains a command and its options. Numbers of the PDP-7 are octal.\n"
    "Data goes to standard output, messages to standard error.\n";

// From the whole command to the subcommand the user got to.
std::vector<const CLI::App*> way_to_subcommand(const CLI::App& app) {
  std::vector<const CLI::App*> way{&app};
  for (auto below = app.get_subcommands(); !below.empty(); below = below.front()->get_subcommands()) {
    way.push_back(below.front());
  }
  return way;
}

std::vector<const CLI::App*> choices(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

// `name`: the command as it is typed.
void finish_help(CLI::App& app, const std::string& name) {
  std::string footer = app.get_footer();
  if (!footer.empty()) footer += "\n";
  if (app.get_parent() != nullptr && !choices(app).empty())
    footer += "`" + name + " SUBCOMMAND --help` explains the options of each.\n";
  app.footer(footer + std::string(sightline::app::exit_code_help));
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    finish_help(*command, name + " " + command->get_name());
}

void print_help(const CLI::App& app) {
  const std::vector<const CLI::App*> path = way_to_subcommand(app);
  std::string parents;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) parents += (i == 0 ? "" : " ") + path[i]->get_name();
  sightline::app::write_stdout(path.back()->help(parents));
}

// The library only says that a subcommand is required.
std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = *way_to_subcommand(app).back();
  if (choices(command).empty()) return error.what();
  std::string names;
  for (const CLI::App* choice : choices(command)) names += (names.empty() ? "" : ", ") + choice->get_name();
  const auto rest = command.remaining();
  return (rest.empty() ? "found no more arguments" : "found \"" + rest.front() + "\"") +
         ", expected one of " + names;
}

// An empty value would pass for an option not given: "--at $UNSET" must not draw another picture in silence.
void refuse_empty_arguments(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] != '\0') continue;
    throw sightline::app::Failure(
        ExitCode::usage,
        "found an empty argument after \"" + std::string(argv[i - 1]) + "\", expected something in it");
  }
}

ExitCode run_sightline(CLI::App& app, int argc, char** argv, const ExitCode& exit_code) {
  refuse_empty_arguments(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print_help(app);
  } catch (const CLI::CallForVersion& version) {
    sightline::app::write_stdout(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    sightline::app::complain(explain(app, error));
    std::string name;
    for (const CLI::App* command : way_to_subcommand(app)) name += command->get_name() + " ";
    sightline::app::complain("see `" + name + "--help`");
    return ExitCode::usage;
  }
  sightline::app::check_stdout();
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that grows beyond what the shell allows is an error of writing like others, not the end.
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  ExitCode exit_code = ExitCode::ok;
  try {
    CLI::App app("Sightline: hidden-line programs of 1971-1990 on the machines they were written for",
                 "sightline");
    app.set_version_flag("--version", "sightline " SIGHTLINE_VERSION, "Print name and version");
    app.require_subcommand(1);
    app.formatter(sightline::app::help_formatter());
    sightline::app::add_demo_command(app, exit_code);
    sightline::app::add_report_command(app, exit_code);
    sightline::app::add_jones_command(app, exit_code);
    sightline::app::add_skala_command(app, exit_code);
    sightline::app::add_draw_command(app, exit_code);
    sightline::app::add_compare_command(app, exit_code);
    sightline::app::add_spin_command(app, exit_code);
    sightline::app::add_sweep_command(app, exit_code);
    sightline::app::add_asm_command(app, exit_code);
    sightline::app::add_disasm_command(app, exit_code);
    sightline::app::add_run_command(app, exit_code);
    sightline::app::add_scene_command(app, exit_code);
    app.footer(sightline_examples);
    finish_help(app, app.get_name());
    exit_code = run_sightline(app, argc, argv, exit_code);
  } catch (const sightline::app::Failure& failure) {
    sightline::app::complain(failure.what());
    exit_code = failure.code();
  } catch (const std::bad_alloc&) {
    sightline::app::complain("not enough memory");
    exit_code = ExitCode::io;
  } catch (const std::exception& error) {
    sightline::app::complain(std::string("internal error: ") + error.what());
    exit_code = ExitCode::io;
  }
  return static_cast<int>(exit_code);
}
