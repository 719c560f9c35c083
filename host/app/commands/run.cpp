// See run.hpp.
#include "host/app/commands/run.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "host/app/commands/run_arguments.hpp"
#include "host/app/commands/run_i8080.hpp"
#include "host/app/commands/run_outputs.hpp"
#include "host/app/commands/run_report.hpp"
#include "host/app/commands/run_timing.hpp"
#include "host/app/eae_option.hpp"
#include "host/base/progress.hpp"

namespace sightline::app {

namespace {

constexpr const char* run_pdp7_examples =
    "Examples:\n"
    "  sightline run pdp7 --load hello.rim --teletype -\n"
    "      from the tape's own start address to HLT; what it types goes to standard output\n"
    "  sightline run pdp7 --load jones.rim house.oct@10000 --switches turns.txt --max-time 5 --png a.png\n"
    "      five emulated seconds with the display, a person at the switches, the last picture as PNG\n\n"
    "Addresses, words and registers are octal; counts and seconds are decimal. Tapes (RIM, HRI) and octal "
    "core images\n"
    "are told apart by content; an HRI tape needs @ADDRESS. Core not loaded is 0.\n"
    "Start: --start, else the start address of the last tape that has one, else 0. With --set PC and no "
    "--start the\n"
    "START key is not pressed: the machine goes on from there, --set values in force (SR: AC switches, ION: "
    "interrupts).\n"
    "The Type 340 is there with --display or any option that needs it. Without --strict an instruction that "
    "nothing in\n"
    "the machine obeys does nothing in one cycle and is warned about once a code; with it, it stops the "
    "run.\n"
    "HLT and limits end with exit code 0 and the reason in the report. All files are written at every stop, "
    "also at\n"
    "Ctrl-C; `-` writes to standard output. Without --max-time and --max-instructions nothing but the "
    "program "
    "itself, or Ctrl-C, ends a run.\n\n"
    "Formats:\n"
    "  switch script     lines `SECONDS OCTAL`, # begins a comment\n"
    "  keyboard script   lines `SECONDS TEXT`, with \\r \\n \\t \\\\ and \\NNN (octal)\n"
    "  light-pen script  lines `SECONDS X Y [RADIUS]` or `SECONDS off`, in order of time: from then on the "
    "pen "
    "sees the square of RADIUS points (default 4) around X Y, decimal, (0, 0) lower left; # begins a "
    "comment\n"
    "  dump              `PC AC L MQ SC`, then all words of core, eight to a line, six digits\n"
    "  trace             `TIME_NS PC WORD INSTRUCTION AC L MQ`, a line an instruction, registers after it\n"
    "  strokes           `T_NS X Y INTENSITY ADDRESS`, a line a flash of the beam\n";

ExitCode run_pdp7(const RunArguments& arguments) {
  harness::Pdp7Job job = job_from(arguments);
  RunOutputs outputs(arguments);
  outputs.attach(job);
  harness::Pdp7Report report;
  {
    const base::InterruptKey key;
    base::ProgressLine line;
    job.keep_running = [&line](const harness::Progress& progress) {
      line.show_run(static_cast<std::uint64_t>(core::nanoseconds_of(progress.now)), progress.instructions);
      return !base::InterruptKey::pressed();
    };
    report = harness::run_pdp7(job);
  }
  warn_about(report);
  outputs.write(report);
  if (!outputs.uses_stdout())
    write_stdout(arguments.json ? json_report(arguments, job, report) : table_report(job, report));
  return judge(report);
}

void add_machine_options(CLI::App& command, RunArguments& to) {
  command.add_option("--load", to.loads, "Tapes and core images, in order; @ADDRESS in octal")
      ->type_name("FILE[@ADDRESS]");
  command.add_option("--start", to.start, "Press START at this address")->type_name("ADDRESS");
  command.add_option("--memory", to.memory, "Size of core; extend mode above 8k")
      ->check(CLI::IsMember({"4k", "8k", "16k", "32k"}, CLI::ignore_case))
      ->capture_default_str()
      ->type_name("SIZE");
  add_eae_options(command, to.no_eae);
  command.add_option("--set", to.sets, "Set PC, AC, L, MQ, SC, SR or ION before the run, in octal")
      ->allow_extra_args(false)
      ->type_name("REGISTER=VALUE");
  command
      .add_option("--switches", to.switches,
                  "The AC switches: an octal word, or a script of who moves them when")
      ->type_name("OCTAL|SCRIPT");
  command.add_flag("--display", to.display, "Attach the Type 340");
  command
      .add_option("--display-option", to.display_options,
                  "Build into the display: 342 draws characters, 347 calls subroutines")
      ->check(CLI::IsMember({"342", "347"}))
      ->allow_extra_args(false)
      ->type_name("342|347");
  command.add_option("--light-pen", to.light_pen, "A script of where the display's light pen points when")
      ->type_name("SCRIPT");
  command
      .add_option("--timing", to.timings, "Set a time of the machine that no document settles; names below")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  command.add_option("--reader", to.reader, "The tape in the paper-tape reader")->type_name("FILE");
  command.add_option("--keyboard", to.keyboard, "A script of what is typed when")->type_name("SCRIPT");
  command.add_option("--max-instructions", to.max_instructions, "Stop after this many instructions")
      ->type_name("N");
  command.add_option("--max-time", to.max_time, "Stop after this much emulated time")->type_name("SECONDS");
  command.add_flag("--strict", to.strict,
                   "Stop at an instruction that nothing in the machine obeys (exit code 3)");
}

void add_output_options(CLI::App& command, RunArguments& to) {
  command.add_option("--dump", to.dump, "Registers and all of core after the run")->type_name("FILE");
  command.add_option("--trace", to.trace, "Every instruction")->type_name("FILE");
  command.add_option("--strokes", to.strokes, "Every flash of the display's beam")->type_name("FILE");
  command.add_option("--png", to.png, "The last complete pass through the display file, 1024x1024, crisp")
      ->type_name("FILE");
  command.add_option("--phosphor", to.phosphor, "A photograph of the P7 screen, the last 0.2 s (PNG)")
      ->type_name("FILE");
  command.add_option("--svg", to.svg, "The same pass as lines in millimetres")->type_name("FILE");
  command.add_option("--punch", to.punch, "What was punched, a byte a line of tape")->type_name("FILE");
  command.add_option("--teletype", to.teletype, "What was typed, seven-bit codes")->type_name("FILE");
  command.add_flag("--json", to.json, "The report as one JSON document");
}

}  // namespace

void add_run_command(CLI::App& app, ExitCode& exit_code) {
  CLI::App* const command =
      app.add_subcommand("run", "Run a program of your own on an emulated machine: PDP-7 or 8080");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  sightline run pdp7 --load hello.rim\n"
      "  sightline run i8080 --cpm --load hello.com\n");
  CLI::App* const pdp7 = command->add_subcommand("pdp7", "Run a program on the PDP-7");
  const auto arguments = std::make_shared<RunArguments>();
  add_machine_options(*pdp7, *arguments);
  add_output_options(*pdp7, *arguments);
  pdp7->footer(
      run_pdp7_examples +
      ("\nTimes that --timing sets (unit, default, bounds; DD is a device in octal):\n" + timing_help()));
  pdp7->callback([arguments, &exit_code] { exit_code = run_pdp7(*arguments); });
  add_run_i8080_command(*command, exit_code);
}

}  // namespace sightline::app
