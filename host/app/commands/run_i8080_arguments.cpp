// See run_i8080_arguments.hpp.
#include "host/app/commands/run_i8080_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "host/app/byte_image_argument.hpp"
#include "host/app/command.hpp"
#include "host/app/commands/run_i8080_settings.hpp"
#include "host/app/commands/run_scripts.hpp"

namespace sightline::app {

namespace {

constexpr std::uint64_t slowest_clock = 1'000;
constexpr std::uint64_t fastest_clock = 1'000'000'000;  // core::ClockRate's bound

// A machine without options is the processor and 64K.
machines::SkalaConfiguration machine_from(const RunI8080Arguments& arguments) {
  machines::SkalaConfiguration machine;
  const std::uint64_t hertz = count_argument("--clock", arguments.clock);
  if (hertz < slowest_clock || hertz > fastest_clock) {
    throw Failure(ExitCode::usage, fmt::format("--clock: found {}, expected {} to {} Hz", arguments.clock,
                                               slowest_clock, fastest_clock));
  }
  machine.clock.hertz = static_cast<std::int64_t>(hertz);
  machine.ef9365 = arguments.board == "ef9365";
  machine.alt256 = arguments.board == "alt256";
  machine.calcomp565 = arguments.plotter == "calcomp";
  machine.minigraf0507 = arguments.plotter == "minigraf";
  if (!arguments.plotter_start.empty()) {
    machine.calcomp565_start = plotter_place("--plotter-start", arguments.plotter_start);
  }
  return machine;
}

void check_needs(const RunI8080Arguments& arguments) {
  const auto needs = [](bool given, bool there, std::string_view option, std::string_view other) {
    if (given && !there) throw Failure(ExitCode::usage, fmt::format("{}: needs {}", option, other));
  };
  needs(true, !arguments.loads.empty(), "run i8080",
        "--load FILE: without a program there is nothing to run");
  needs(!arguments.png.empty(), !arguments.board.empty(), "--png", "--board");
  needs(arguments.grey, !arguments.png.empty(), "--grey", "--png");
  needs(!arguments.svg.empty(), !arguments.plotter.empty(), "--svg", "--plotter");
  needs(!arguments.strokes.empty(), !arguments.plotter.empty(), "--strokes", "--plotter");
  needs(!arguments.plotter_start.empty(), arguments.plotter == "calcomp", "--plotter-start",
        "--plotter calcomp");
  needs(!arguments.parallel_out.empty(), !arguments.parallel.empty(), "--parallel-out", "--parallel");
  needs(!arguments.serial_out.empty(), !arguments.serial.empty(), "--serial-out", "--serial");
  needs(!arguments.console.empty(), arguments.cpm, "--console", "--cpm");
}

// Later files win where two have a byte for the same address, and in the start address.
void load_memory(const RunI8080Arguments& arguments, harness::I8080Job& job) {
  for (const std::string& text : arguments.loads) {
    const ByteImageArgument argument = byte_image_argument("--load", text);
    const bool com = arguments.cpm && !argument.address;  // raw bytes without a place are a program for CP/M
    const image::ByteImage loaded =
        load_byte_image(argument, std::nullopt, com ? ByteFormat::com : ByteFormat::bin);
    if (loaded.empty()) continue;
    for (std::uint32_t address = loaded.lowest(); address <= loaded.highest(); ++address) {
      const auto a = static_cast<std::uint16_t>(address);
      if (loaded.used(a)) job.memory.put(a, loaded[a]);
    }
    if (loaded.start) job.memory.start = loaded.start;
  }
  if (!arguments.cpm) return;
  for (const auto& [address, byte] : harness::cpm_stub) {
    if (!job.memory.used(address) || job.memory[address] == byte) continue;
    throw Failure(
        ExitCode::bad_input,
        fmt::format("--load: found a byte for {:04X}, expected none: --cpm has its entry to CP/M there",
                    address));
  }
}

void set_registers(const RunI8080Arguments& arguments, harness::I8080Job& job) {
  job.registers.pc = arguments.cpm ? image::com_origin : job.memory.start.value_or(0);
  for (const std::string& text : arguments.sets) {
    set_i8080_register(job.registers, text);
    if (register_named(text) == "PC" && !arguments.start.empty())
      throw Failure(ExitCode::usage, "--set PC: found --start too, expected one of them");
  }
  if (!arguments.start.empty()) {
    job.registers.pc =
        static_cast<i8080::Address>(hexadecimal_argument("--start", arguments.start, 0xFFFF, "an address"));
  }
}

void set_limits(const RunI8080Arguments& arguments, machines::I8080Limits& limits) {
  if (!arguments.max_instructions.empty()) {
    limits.instructions = count_argument("--max-instructions", arguments.max_instructions);
  }
  if (arguments.max_states.empty()) return;
  constexpr std::uint64_t longest = std::uint64_t{1} << 62;
  limits.until = core::at_t_state(
      static_cast<std::int64_t>(std::min(count_argument("--max-states", arguments.max_states), longest)));
}

}  // namespace

harness::I8080Job i8080_job_from(const RunI8080Arguments& arguments) {
  check_needs(arguments);
  harness::I8080Job job;
  job.cpm = arguments.cpm;
  job.strict = arguments.strict;
  job.machine = machine_from(arguments);
  for (const std::string& text : arguments.interrupts) {
    wire_interrupt(job.machine, text, !arguments.parallel.empty(), !arguments.serial.empty());
  }
  set_limits(arguments, job.limits);
  load_memory(arguments, job);
  set_registers(arguments, job);
  if (!arguments.parallel.empty()) job.parallel = read_input(arguments.parallel);
  if (!arguments.serial.empty()) job.serial = read_input(arguments.serial);
  return job;
}

}  // namespace sightline::app
