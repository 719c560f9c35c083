// See run_arguments.hpp.
#include "host/app/commands/run_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/command.hpp"
#include "host/app/image_argument.hpp"
#include "host/app/commands/run_scripts.hpp"
#include "host/app/commands/run_timing.hpp"

namespace sightline::app {

namespace {

machines::Pdp7Options machine_from(const RunArguments& arguments) {
  machines::Pdp7Options machine;
  const auto kilowords = static_cast<std::uint32_t>(
      count_argument("--memory", arguments.memory.substr(0, arguments.memory.size() - 1)));
  machine.configuration.core_words = kilowords * 1024;
  machine.configuration.model.eae = !arguments.no_eae;
  machine.configuration.model.strict = arguments.strict;
  set_timing(machine.configuration.timing, timing_settings(arguments.timings));
  if (!arguments.wants_display()) return machine;
  const auto has = [&arguments](const char* name) {
    return std::find(arguments.display_options.begin(), arguments.display_options.end(), name) !=
           arguments.display_options.end();
  };
  machine.display = type340::Options{};
  machine.display->subroutines_347 = has("347");
  machine.display->characters_342 = has("342");
  return machine;
}

// Later files win where two have a word for the same address, and in the start address.
void load_core(const RunArguments& arguments, harness::Pdp7Job& job) {
  const std::uint32_t words = job.machine.configuration.core_words;
  const auto outside = [&](const std::string& path, std::string_view what, std::uint32_t address) {
    throw Failure(ExitCode::bad_input,
                  fmt::format("{}: error: found {} {:05o}, expected one in core, 00000-{:05o} (--memory {})",
                              shown_name(path), what, address, words - 1, arguments.memory));
  };
  for (const std::string& text : arguments.loads) {
    const ImageArgument argument = image_argument("--load", text);
    const image::CoreImage core = load_image(argument);
    for (const auto& [address, word] : core.words) {
      if (address >= words) outside(argument.path, "a word for address", address);
      job.core[address] = word;
    }
    if (!core.start) continue;
    if (*core.start >= words) outside(argument.path, "the start address", *core.start);
    job.start = *core.start;
  }
}

// The START key is pressed unless --set PC says where to go on.
void choose_start(const RunArguments& arguments, harness::Pdp7Job& job) {
  if (!arguments.start.empty()) {
    job.start = octal_argument("--start", arguments.start, job.machine.configuration.core_words - 1,
                               "an address in core");
  } else if (job.registers.pc) {
    job.start = std::nullopt;
  } else if (!job.start) {
    job.start = 0;
  }
}

void set_switches(const std::string& text, harness::Pdp7Job& job) {
  if (text.empty()) return;
  if (text.find_first_not_of("01234567") == std::string::npos) {
    job.registers.switches = core::Word18(octal_argument("--switches", text, core::Word18::mask, "a word"));
    return;
  }
  job.switch_script = read_switch_script(read_input_text(text), shown_name(text));
}

void set_limits(const RunArguments& arguments, machines::Limits& limits) {
  if (!arguments.max_instructions.empty()) {
    limits.instructions = count_argument("--max-instructions", arguments.max_instructions);
  }
  if (!arguments.max_time.empty()) limits.until = seconds_argument("--max-time", arguments.max_time);
}

}  // namespace

harness::Pdp7Job job_from(const RunArguments& arguments) {
  // Core is empty otherwise: nothing but --load puts a word there, and an empty core runs round for ever.
  if (arguments.loads.empty()) {
    throw Failure(ExitCode::usage, "run pdp7: needs --load FILE: without a program there is nothing to run");
  }
  harness::Pdp7Job job;
  job.machine = machine_from(arguments);
  set_limits(arguments, job.limits);
  set_switches(arguments.switches, job);
  for (const std::string& text : arguments.sets) {
    set_register(job.registers, text, job.machine.configuration.core_words);
  }
  load_core(arguments, job);
  choose_start(arguments, job);
  if (!arguments.reader.empty()) job.reader_tape = read_input(arguments.reader);
  if (!arguments.keyboard.empty()) {
    job.keys = read_keyboard_script(read_input_text(arguments.keyboard), shown_name(arguments.keyboard));
  }
  if (!arguments.light_pen.empty()) {
    job.pen_script =
        read_light_pen_script(read_input_text(arguments.light_pen), shown_name(arguments.light_pen));
  }
  return job;
}

}  // namespace sightline::app
