// See run_i8080.hpp.
#include "host/app/commands/run_i8080.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "host/app/commands/run_i8080_arguments.hpp"
#include "host/app/commands/run_i8080_outputs.hpp"
#include "host/app/commands/run_i8080_report.hpp"
#include "host/base/progress.hpp"

namespace sightline::app {

namespace {

constexpr const char* run_i8080_examples =
    "Examples:\n"
    "  sightline run i8080 --cpm --load hello.com\n"
    "      a CP/M program: what it prints goes to standard output, the report to standard error\n"
    "  sightline run i8080 --load draw.hex --start 8000 --board ef9365 --png a.png --max-states 6000000\n"
    "      two seconds at 3 MHz with the raster board, its picture as PNG\n"
    "  sightline run i8080 --load rom.bin@E000 data.bin@2000 --start E000 --set SP=F000 --trace t --json\n"
    "      raw bytes at two places, every instruction into a file, the report as JSON\n\n"
    "Addresses, bytes and registers are hexadecimal; counts are decimal. The ending tells what a file is "
    "(.com .bin\n"
    ".hex), for another ending the content: text that begins as a HEX record does is Intel HEX, all else "
    "raw. "
    "Raw bytes go\n"
    "to ADDRESS, 0000 if none is given; a .com file goes to 0100, Intel HEX where it says. Memory not loaded "
    "is 0.\n"
    "Start: --start or --set PC, else the start address of the last file that has one, else 0000.\n"
    "--cpm: raw files are .COM programs and go to 0100, where the run starts with SP=0000. BDOS functions 2 "
    "and 9 print;\n"
    "a jump to 0000, function 0 and a RET at the top level end the run; any other function is an error (exit "
    "code 3).\n"
    "In memory: OUT 0 at 0000 and at 00D3 (where a RET with SP=0000 leads: the two bytes at 0000 are its "
    "address), and\n"
    "OUT 1, RET at 0005; all of them take their T-states, the printing takes none. With --json what is "
    "printed is the\n"
    "report's \"console\" (a byte above 7F as that character of Latin-1) unless --console names a file.\n"
    "Ports: 30-33 ALT-256, 40-50 EF9365, 60 CalComp 565, E4-E7 8255, EC-EF 8251, F0 Minigraf. Without "
    "--strict a port\n"
    "that nothing answers reads as FF and is warned about; with it, it stops the run.\n"
    "HLT ends the run if no interrupt can end it. HLT and limits end with exit code 0 and the reason in the "
    "report. All\n"
    "files are written at every stop, also at Ctrl-C; `-` writes to standard output. Without --max-states "
    "and "
    "--max-instructions nothing but the program itself, or Ctrl-C, ends a run.\n\n"
    "Formats:\n"
    "  dump     `A F B C D E H L SP PC INTE`, then all of memory, 4096 lines of 16 bytes\n"
    "  trace    `T PC BYTES INSTRUCTION A F B C D E H L SP PC INTE`, a line an instruction: T-state and "
    "address of its fetch, registers after it; INT before an instruction that a device supplied, * before an "
    "opcode that Intel left undefined\n"
    "  bus      `T SS AAAA DD`, a line a machine cycle: T-state of its T1, status byte, address, data (-- in "
    "a halt); none for the internal cycles of DAD\n"
    "  strokes  `T_NS X Y INTENSITY ADDRESS`, a line a step of the plotter's lowered pen\n";

ExitCode run_i8080(const RunI8080Arguments& arguments) {
  harness::I8080Job job = i8080_job_from(arguments);
  RunI8080Outputs outputs(arguments);
  outputs.attach(job);
  harness::I8080Report report;
  {
    const base::InterruptKey key;
    base::ProgressLine line;
    job.keep_running = [&line, &job](const harness::I8080Progress& progress) {
      line.show_run(
          static_cast<std::uint64_t>(core::nanoseconds_of(job.machine.clock.to_nanoseconds(progress.now))),
          progress.instructions);
      return !base::InterruptKey::pressed() &&
             std::ferror(stdout) == 0;  // nobody reads what the program prints
    };
    report = harness::run_i8080(job);
  }
  warn_about(report);
  outputs.write(report);
  if (arguments.json) {
    write_stdout(json_report(job, report, outputs.kept_console()));
  } else if (outputs.uses_stdout()) {
    static_cast<void>(std::fputs(table_report(job, report).c_str(), stderr));
  } else {
    write_stdout(table_report(job, report));
  }
  return judge(report);
}

void add_machine_options(CLI::App& command, RunI8080Arguments& to) {
  command.add_option("--load", to.loads, "Programs and data, in order; @ADDRESS in hexadecimal")
      ->type_name("FILE[@ADDRESS]");
  command.add_option("--start", to.start, "Begin at this address")->type_name("ADDRESS");
  command.add_flag("--cpm", to.cpm, "Run a CP/M .COM program");
  command.add_option("--clock", to.clock, "The processor's clock")->capture_default_str()->type_name("HZ");
  command
      .add_option("--set", to.sets,
                  "Set A, F, B, C, D, E, H, L, SP, PC or INTE before the run, in hexadecimal")
      ->allow_extra_args(false)
      ->type_name("REGISTER=VALUE");
  command.add_option("--max-instructions", to.max_instructions, "Stop after this many instructions")
      ->type_name("N");
  command.add_option("--max-states", to.max_states, "Stop at the first instruction at or after this T-state")
      ->type_name("N");
  command.add_flag("--strict", to.strict, "Stop at a port that nothing answers (exit code 3)");
}

void add_device_options(CLI::App& command, RunI8080Arguments& to) {
  command.add_option("--board", to.board, "Attach a raster board")
      ->check(CLI::IsMember({"ef9365", "alt256"}))
      ->type_name("BOARD");
  command.add_option("--plotter", to.plotter, "Attach a plotter")
      ->check(CLI::IsMember({"calcomp", "minigraf"}))
      ->type_name("PLOTTER");
  command.add_option("--plotter-start", to.plotter_start, "Where the CalComp's pen stands first, in steps")
      ->default_str("0,0")
      ->type_name("X,Y");
  command.add_option("--parallel", to.parallel, "Attach the 8255; the host computer sends these bytes")
      ->type_name("FILE");
  command.add_option("--serial", to.serial, "Attach the 8251; the host computer sends these bytes")
      ->type_name("FILE");
  command
      .add_option("--interrupt", to.interrupts,
                  "Wire ef9365, calcomp, parallel, serial-receive or serial-transmit to RST N")
      ->allow_extra_args(false)
      ->type_name("DEVICE=N");
}

void add_output_options(CLI::App& command, RunI8080Arguments& to) {
  command.add_option("--dump", to.dump, "Registers and all of memory after the run")->type_name("FILE");
  command.add_option("--trace", to.trace, "Every instruction")->type_name("FILE");
  command.add_option("--bus", to.bus, "Every machine cycle")->type_name("FILE");
  command.add_option("--console", to.console, "What the CP/M program prints")->type_name("FILE");
  command.add_option("--png", to.png, "What the raster board shows, 256x256 in eight colours")
      ->type_name("FILE");
  command.add_flag("--grey", to.grey, "The PNG in eight levels of grey instead");
  command.add_option("--strokes", to.strokes, "Every step of the plotter's lowered pen")->type_name("FILE");
  command.add_option("--svg", to.svg, "What the plotter drew, in millimetres")->type_name("FILE");
  command.add_option("--parallel-out", to.parallel_out, "What the host took from the 8255")
      ->type_name("FILE");
  command.add_option("--serial-out", to.serial_out, "What the 8251 sent to the host")->type_name("FILE");
  command.add_flag("--json", to.json, "The report as one JSON document");
}

}  // namespace

void add_run_i8080_command(CLI::App& parent, ExitCode& exit_code) {
  CLI::App* const command = parent.add_subcommand("i8080", "Run a program on the 8080");
  const auto arguments = std::make_shared<RunI8080Arguments>();
  add_machine_options(*command, *arguments);
  add_device_options(*command, *arguments);
  add_output_options(*command, *arguments);
  command->footer(run_i8080_examples);
  command->callback([arguments, &exit_code] { exit_code = run_i8080(*arguments); });
}

}  // namespace sightline::app
