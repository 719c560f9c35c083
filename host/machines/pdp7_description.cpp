// The PDP-7 as a MachineDescription: its options and their meaning, its tapes, its assembler, and the disassemblers of the
// processor and of the Type 340.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <type_traits>

#include "emulators/machines/pdp7_devices.hpp"
#include "host/base/number.hpp"
#include "host/machines/device_option.hpp"
#include "host/machines/disk_image.hpp"
#include "host/machines/pdp7.hpp"
#include "host/machines/pdp7_vcd.hpp"
#include "tools/asm/pdp7.hpp"
#include "tools/disasm/disasm.hpp"
#include "tools/image/octal.hpp"
#include "tools/image/tape.hpp"

namespace sightline::machines {

namespace {

// --- Times that --timing sets, and choices ---
//
// emulators/pdp7/timing.hpp tells the status of each. Bounds keep a run meaningful, not realistic: a clock tick is shorter
// than the clock's period, and the times of any feasible run add up within the range of the emulated clock.

// One member of pdp7::Timing. `device` is used only for iot_stretch.
struct TimingName {
  std::string_view name;
  std::string_view unit;
  std::int64_t least;
  std::int64_t most;
  std::int64_t (*get)(const pdp7::Timing& timing, std::size_t device);
  void (*set)(pdp7::Timing& timing, std::size_t device, std::int64_t value);
};

template <core::Duration pdp7::Timing::*Member>
constexpr TimingName make_time(std::string_view name, std::int64_t least, std::int64_t most) {
  return {name,
          "ns",
          least,
          most,
          [](const pdp7::Timing& t, std::size_t) { return (t.*Member).count(); },
          [](pdp7::Timing& t, std::size_t, std::int64_t value) { t.*Member = core::Duration(value); }};
}

template <auto Member>
constexpr TimingName make_number(std::string_view name, std::string_view unit, std::int64_t least, std::int64_t most) {
  return {name,
          unit,
          least,
          most,
          [](const pdp7::Timing& t, std::size_t) { return static_cast<std::int64_t>(t.*Member); },
          [](pdp7::Timing& t, std::size_t, std::int64_t value) {
            t.*Member = static_cast<std::remove_reference_t<decltype(t.*Member)>>(value);
          }};
}

// A choice between yes and no.
template <bool pdp7::Timing::*Member>
constexpr TimingName make_choice(std::string_view name) {
  return {name,
          "yes/no",
          0,
          1,
          [](const pdp7::Timing& t, std::size_t) { return std::int64_t{t.*Member ? 1 : 0}; },
          [](pdp7::Timing& t, std::size_t, std::int64_t value) { t.*Member = value != 0; }};
}

constexpr std::string_view stretch_prefix = "iot_stretch.";
constexpr std::int64_t longest_step = 10'000;
constexpr std::int64_t longest_stretch = 100'000;
constexpr std::int64_t longest_line = 1'000'000'000;

using pdp7::Timing;
constexpr std::array timing_names{
    make_time<&Timing::eae_setup>("eae_setup", 0, longest_step),
    make_time<&Timing::eae_shift_step>("eae_shift_step", 0, longest_step),
    make_time<&Timing::eae_normalize_step>("eae_normalize_step", 0, longest_step),
    make_time<&Timing::eae_multiply_step>("eae_multiply_step", 0, longest_step),
    make_time<&Timing::eae_divide_step>("eae_divide_step", 0, longest_step),
    make_number<&Timing::interrupt_cycles>("interrupt_cycles", "cycles", 1, 100),
    make_number<&Timing::clock_tick_cycles>("clock_tick_cycles", "cycles", 1, 100),
    make_number<&Timing::clock_hertz>("clock_hertz", "Hz", 1, 400),
    make_time<&Timing::reader_line>("reader_line", 1, longest_line),
    make_time<&Timing::punch_line>("punch_line", 1, longest_line),
    make_time<&Timing::teletype_character>("teletype_character", 1, longest_line),
    make_choice<&Timing::skip_703361>("skip_703361"),
    make_choice<&Timing::device_33_each_pulse>("device_33_each_pulse"),
    make_time<&Timing::disk_word>("disk_word", 1, longest_stretch),
    make_choice<&Timing::disk_clear_stops>("disk_clear_stops"),
    make_choice<&Timing::disk_late_stops>("disk_late_stops"),
    make_number<&Timing::disk_after_last>("disk_after_last", "word", 0, pdp7::rb09::words_of_disk - 1),
    TimingName{"iot_stretch.DD", "ns", 0, longest_stretch,
               [](const Timing& t, std::size_t device) { return t.iot_stretch[device].count(); },
               [](Timing& t, std::size_t device, std::int64_t value) {
                 t.iot_stretch[device] = core::Duration(value);
               }},
};

struct TimingPlace {
  const TimingName* member;
  std::size_t device;
};

// Devices are written in two octal digits, so each has one name.
std::optional<TimingPlace> timing_place(std::string_view name) {
  if (name.starts_with(stretch_prefix)) {
    const std::string_view digits = name.substr(stretch_prefix.size());
    const auto device = base::whole_number<std::uint8_t>(digits, 8);
    if (digits.size() != 2 || !device || *device >= Timing{}.iot_stretch.size()) return std::nullopt;
    return TimingPlace{&timing_names.back(), *device};
  }
  const auto found = std::find_if(timing_names.begin(), timing_names.end() - 1,
                                  [name](const TimingName& row) { return row.name == name; });
  if (found == timing_names.end() - 1) return std::nullopt;
  return TimingPlace{&*found, 0};
}

// Each text is "NAME=VALUE", in any order; a repeated name replaces the value.
Result<Done> set_timing(const std::vector<std::string>& texts, Pdp7Setup& setup) {
  for (const std::string& text : texts) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals);
    const auto place = timing_place(name);
    if (!place) {
      std::string names;
      for (const TimingName& row : timing_names) names += fmt::format(" {}", row.name);
      return base::usage_error(fmt::format(
          "--timing: found \"{}\", expected NAME=VALUE with one of{} (DD: a device, two octal digits)", text,
          names));
    }
    const TimingName& row = *place->member;
    const std::string digits = equals < text.size() ? text.substr(equals + 1) : "";
    const auto value = base::whole_number<std::int64_t>(digits, 10);
    if (!value || *value < row.least || *value > row.most) {
      return base::usage_error(fmt::format("--timing {}: found \"{}\", expected a whole decimal number, {} to {} ({})",
                               name, digits, row.least, row.most, row.unit));
    }
    row.set(setup.machine.timing, place->device, *value);
    const auto same = std::find_if(setup.timing.begin(), setup.timing.end(),
                                   [&name](const auto& setting) { return setting.first == name; });
    if (same == setup.timing.end()) {
      setup.timing.emplace_back(name, *value);
    } else {
      same->second = *value;
    }
  }
  return Done{};
}

std::string timing_help() {
  std::string text = "\nTimes that --timing sets, and choices (unit, default, bounds; DD is a device in octal; yes is 1, no is 0):\n";
  for (const TimingName& row : timing_names) {
    text += fmt::format("  {:<20} {:<6}  {} ({} to {})\n", row.name, row.unit, row.get(Timing{}, 0),
                        row.least, row.most);
  }
  return text;
}

// --- A machine from its options ---

Result<Done> choose_display(const Arguments& arguments, Pdp7Setup& setup) {
  Screen::Outputs outputs;
  outputs.picture = arguments.given("--png") || arguments.given("--svg");
  outputs.photograph = arguments.given("--phosphor") || arguments.given("--movie");
  if (arguments.given("--movie")) {
    constexpr std::uint64_t usual = 25, most = 100;
    std::uint64_t rate = usual;
    if (arguments.given("--movie-rate")) {
      const auto wanted = count_argument("--movie-rate", arguments.text("--movie-rate"));
      if (!wanted) return wanted.error();
      rate = *wanted;
    }
    if (rate == 0 || rate > most)
      return base::usage_error(fmt::format("--movie-rate: found {}, expected 1 to {} pictures per second", arguments.text("--movie-rate"), most));
    setup.movie_rate = static_cast<std::uint32_t>(rate);
  }
  setup.picture_wanted = outputs.picture;
  if (arguments.given("--png-window")) {
    const auto window = parse_seconds(arguments.text("--png-window"));
    if (!window || *window == core::Instant{}) {
      return base::usage_error(fmt::format("--png-window: found \"{}\", expected {}, more than 0", arguments.text("--png-window"),
                               seconds_expected));
    }
    outputs.window = window->time_since_epoch();
  }
  if (outputs.picture || outputs.photograph || arguments.given("--strokes")) setup.screen = outputs;
  const std::vector<std::string>& options = arguments.list("--display-option");
  if (arguments.given("--no-display")) {
    for (const std::string_view option : {"--png", "--svg", "--phosphor", "--movie", "--strokes", "--display-option", "--light-pen"})
      if (arguments.given(option)) return base::usage_error(fmt::format("{}: found --no-display too, expected one of them", option));
    return Done{};
  }
  const auto has = [&options](const char* name) {
    return std::find(options.begin(), options.end(), name) != options.end();
  };
  setup.display_when_used =
      !setup.screen && !arguments.given("--display") && options.empty() && !arguments.given("--light-pen");
  setup.display = type340::Options{};
  setup.display->subroutines_347 = has("347");
  setup.display->characters_342 = has("342");
  if (arguments.given("--monitor")) setup.screen = Screen::Outputs{.picture = true, .photograph = true};
  return Done{};
}

// An octal word, or a script of switch settings and their times.
Result<Done> set_switches(const std::string& text, const FileReader& read, Pdp7Setup& setup) {
  if (text.empty()) return Done{};
  if (text.find_first_not_of("01234567") != std::string::npos)
    return read_switches(read(text), setup.switch_script);
  const auto word = number_argument("--switches", text, 8, core::Word18::mask, "a word");
  if (!word) return word.error();
  setup.switches = core::Word18(*word);
  return Done{};
}

// Everything that determines how the machine works and is not state; --strict only determines where a run ends.
std::vector<std::string> configuration_of(const Pdp7Setup& setup) {
  const sightline::pdp7::Options& machine = setup.machine;
  std::vector<std::string> words{fmt::format("--memory {}k", machine.core_words / 1024),
                                 machine.model.eae ? "--eae" : "--no-eae"};
  if (setup.disk) words.emplace_back("--disk");
  for (const TimingName& row : timing_names) {
    const bool used = !row.name.starts_with("disk_") || setup.disk;
    if (used && &row != &timing_names.back())
      words.push_back(fmt::format("--timing {}={}", row.name, row.get(machine.timing, 0)));
  }
  const auto& stretch = machine.timing.iot_stretch;
  for (std::size_t device = 0; device < stretch.size(); ++device) {
    if (stretch[device].count() != 0)
      words.push_back(fmt::format("--timing {}{:02o}={}", stretch_prefix, device, stretch[device].count()));
  }
  // Whether the display is plugged in is state; the machine adds it.
  if (!setup.display) words.emplace_back("--no-display");
  if (setup.display && setup.display->characters_342) words.emplace_back("--display-option 342");
  if (setup.display && setup.display->subroutines_347) words.emplace_back("--display-option 347");
  for (const DeviceChoice& device : setup.devices) words.push_back("--device " + device_text(device));
  return words;
}

// The devices of the list that --device attaches: those that are neither always present nor attached by another option.
const std::vector<ListedDevice>& further_devices() {
  static const std::vector<ListedDevice> devices = [] {
    std::vector<std::string_view> known = sightline::pdp7::Options{}.devices;
    known.insert(known.end(), {sightline::pdp7::Rb09::info.name, type340::Display::info.name});
    std::vector<ListedDevice> others;
    for (const core::IotDeviceInfo& info : sightline::pdp7::device_infos) {
      if (std::find(known.begin(), known.end(), info.name) == known.end()) others.push_back({info.name, info.help, info.options});
    }
    return others;
  }();
  return devices;
}

Result<std::unique_ptr<Machine>> make_pdp7(const Arguments& arguments, const FileReader& read) {
  Pdp7Setup setup;
  const std::string& memory = arguments.text("--memory");  // "8k"
  setup.machine.core_words =
      base::whole_number<std::uint32_t>(std::string_view(memory).substr(0, memory.size() - 1), 10)
          .value_or(8) *
      1024;
  setup.machine.model.eae = !arguments.given("--no-eae");
  setup.machine.model.strict = arguments.given("--strict");
  if (auto done = set_timing(arguments.list("--timing"), setup); !done) return done.error();
  if (auto done = choose_display(arguments, setup); !done) return done.error();
  setup.trace = arguments.given("--trace");
  if (arguments.given("--vcd")) {
    auto writer = VcdWriter::make("pdp7", pdp7_signals(), vcd_target(arguments.text("--vcd")).signals);
    if (!writer) return writer.error();
    setup.vcd = std::move(*writer);
  }
  setup.monitored = arguments.given("--monitor");
  if (auto done = set_switches(arguments.text("--switches"), read, setup); !done) return done.error();
  if (arguments.given("--disk")) {
    const Input input = read(arguments.text("--disk"));
    auto image = read_disk_image(input);
    if (!image) return image.error();
    const bool read_only = arguments.given("--disk-read-only");
    const std::string& path = arguments.text("--disk");
    setup.disk = Pdp7Setup::Disk{read_only || path == "-" ? std::string() : path, std::move(*image),
                                 read_only ? sightline::pdp7::rb09::all_locked : 0};
  }
  if (arguments.given("--reader")) {
    Input tape = read(arguments.text("--reader"));
    setup.reader_tape = std::move(tape.bytes);
    setup.reader_name = std::move(tape.name);
  }
  if (arguments.given("--keyboard")) {
    if (auto done = read_keyboard(read(arguments.text("--keyboard")), setup.keys); !done) return done.error();
  }
  if (arguments.given("--light-pen")) {
    if (auto done = read_light_pen(read(arguments.text("--light-pen")), setup.pen_script); !done)
      return done.error();
  }
  auto devices = read_devices(arguments.list("--device"), further_devices());
  if (!devices) return devices.error();
  setup.devices = std::move(*devices);
  setup.configuration = configuration_of(setup);
  return make_pdp7(std::move(setup));
}

Result<std::int64_t> parse_pdp7_time(std::string_view option, std::string_view text) {
  if (const auto seconds = parse_seconds(text)) return core::nanoseconds_of(*seconds);
  return base::usage_error(fmt::format("{}: found \"{}\", expected {}", option, text, seconds_expected));
}

// --- Programs ---

image::CoreImage core_image(const Program& program) {
  image::CoreImage core;
  for (const auto& [address, word] : program.words)
    core.words.emplace_hint(core.words.end(), address, core::Word18(word));
  core.start = program.start;
  return core;
}

Program program_of(const image::CoreImage& core) {
  Program program;
  for (const auto& [address, word] : core.words) program.words.emplace_back(address, word.value());
  program.start = core.start;
  return program;
}

template <image::Format format>
bool is(std::span<const std::uint8_t> bytes) {
  const auto found = image::recognise(bytes, {});
  return found && found.value() == format;
}

Result<Program> read_image(std::span<const std::uint8_t> bytes, const std::string& file,
                           std::optional<std::uint32_t> address) {
  std::vector<std::string> warnings;
  const auto core = image::read_image(bytes, file, address, &warnings);
  if (!core) return base::bad_input(core.error().message(base::MessageStyle::compiler));
  Program program = program_of(core.value());
  program.warnings = std::move(warnings);
  return program;
}

template <auto write>
Result<Bytes> write_tape(const Program& program, const std::string& file) {
  const auto tape = write(core_image(program), file);
  if (!tape) return base::bad_input(tape.error().message(base::MessageStyle::compiler));
  return tape.value();
}

Result<Bytes> write_octal(const Program& program, const std::string&) {
  const std::string text = image::write_octal(core_image(program));
  return Bytes(text.begin(), text.end());
}

constexpr std::string_view bell_dialect = "bell";

Result<Assembled> assemble_pdp7(std::span<const assembler::SourceFile> sources, const Arguments& arguments,
                           const TextReader&) {
  assembler::Options options;
  auto defines = read_defines(arguments, assembler::parse_define);
  if (!defines) return defines.error();
  options.defines = std::move(*defines);
  if (arguments.text("--dialect") == bell_dialect) {
    options.dialect = assembler::Dialect::bell;
    for (const std::string_view option : {"--twos-complement", "--undefined-are-variables", "--title"}) {
      if (arguments.given(option))
        return base::usage_error(fmt::format("{}: found --dialect {}, expected it with --dialect dec only", option, bell_dialect));
    }
  }
  options.twos_complement = arguments.given("--twos-complement");
  options.undefined_are_variables = arguments.given("--undefined-are-variables");
  options.first_line_is_title = arguments.given("--title");
  const auto assembly = assembler::assemble_pdp7(sources, options);
  return Assembled{assembly.diagnostics, program_of(assembly.image), assembly.symbols.size(),
                   assembler::write_listing(assembly.listing), assembler::write_symbols(assembly.symbols),
                   source_lines(assembly.listing, 8)};
}

Result<std::string> disassemble_bell(const Program& program, const std::string& file) {
  auto text = disassembler::disassemble_pdp7_bell(core_image(program));
  if (text) return std::move(*text);
  base::Error error = text.error();
  error.file = file;
  return base::bad_input(error.message(base::MessageStyle::compiler));
}

template <auto disassembler>
std::string disassemble(const Program& program) {
  return disassembler(core_image(program));
}

// --- The description ---

using enum OptionKind;

std::vector<Option> pdp7_options() {
  std::vector<Option> options{
      {files, "PROGRAM,--load", "FILE[@ADDRESS]", "Sources, tapes and core images, in order; @ADDRESS in octal"},
      {text, "--start", "ADDRESS", "Press START at this address"},
      {text, "--restore", "FILE", "Continue from this snapshot instead of a program"},
      {.name = "--memory",
       .argument = "SIZE",
       .help = "Size of core; extend mode above 8k",
       .choices = {"4k", "8k", "16k", "32k"},
       .any_case = true,
       .initial = "8k"},
      {flag, "--eae", {}, "The PDP-7 with the Type 177 extended arithmetic element, the default"},
      {.kind = flag,
       .name = "--no-eae",
       .help = "The PDP-7 without it, where 64xxxx does nothing",
       .excludes = "--eae"},
      {list, "--set", "REGISTER=VALUE", "Set PC, AC, L, MQ, SC, SR or ION before the run, in octal"},
      {text, "--switches", "OCTAL|SCRIPT",
       "The AC switches: an octal word, or a script of settings and their times"},
      {flag, "--display", {}, "Attach the Type 340 from the beginning, not only when the program uses it"},
      {.kind = flag, .name = "--no-display", .help = "The PDP-7 without the Type 340, whose instructions do nothing", .excludes = "--display"},
      {list,
       "--display-option",
       "342|347",
       "Build into the display: 342 draws characters, 347 calls subroutines",
       {"342", "347"}},
      {text, "--light-pen", "SCRIPT", "A script of positions of the display's light pen and their times"},
      {list, "--timing", "NAME=VALUE", "Set a time or a choice of the machine that no document settles; names below"},
      {text, "--reader", "FILE", "The tape in the paper-tape reader"},
      {text, "--disk", "FILE", "The image in the RB09 disk drive; what the program writes is written back after the run"},
      {.kind = flag,
       .name = "--disk-read-only",
       .help = "All write-lock switches of the disk on: the image stays as it is",
       .needs = "--disk"},
      {text, "--keyboard", "SCRIPT", "A script of typed text and its times"},
      {text, "--max-instructions", "N", "Stop after this many instructions"},
      {text, "--max-time", "SECONDS", "Stop after this much emulated time"},
      {flag, "--strict", {}, "Stop at an instruction that nothing in the machine obeys (exit code 3)"},
      {output, "--dump", "FILE", "Registers and all of core after the run"},
      {output, "--save", "FILE", "A snapshot of the whole machine after the run"},
      {stream, "--trace", "FILE", "Every instruction"},
      {stream, "--vcd", "FILE[:SIGNALS]", "Cycles, breaks, registers and display flags as a value change dump; names below"},
      {stream, "--strokes", "FILE", "Every flash of the display's beam"},
      {output, "--png", "FILE", "The last complete pass through the display file, 1024x1024, crisp"},
      {text, "--png-window", "SECONDS", "--png and --svg show all strokes of this last period instead"},
      {output, "--phosphor", "FILE", "A photograph of the P7 screen, the last 0.2 s (PNG)"},
      {output, "--movie", "FILE", "A movie of such photographs (APNG), at most 750"},
      {.name = "--movie-rate",
       .argument = "N",
       .help = "Photographs per second of emulated time",
       .shown_initial = "25",
       .needs = "--movie"},
      {output, "--svg", "FILE", "The same pass as lines in millimetres"},
      {output, "--punch", "FILE", "What was punched, one byte per line of tape"},
      {output, "--teletype", "FILE", "What was typed, seven-bit codes"},
      {flag, "--json", {}, "The report as one JSON document"},
  };
  const auto console = console_options("The teletype");
  const auto keyboard = std::find_if(options.begin(), options.end(),
                                     [](const Option& option) { return option.name == "--keyboard"; });
  options.insert(keyboard + 1, console.begin(), console.end());
  if (auto device = device_option(further_devices())) options.push_back(std::move(*device));
  return options;
}

MachineDescription describe_pdp7() {
  MachineDescription pdp7;
  pdp7.name = "pdp7";
  pdp7.help = "Run a program on the PDP-7";
  pdp7.radix = 8;
  pdp7.ticks_per_cycle = sightline::pdp7::machine_cycle.count();
  pdp7.address_bits = 15;
  pdp7.word_bits = 18;
  pdp7.words_per_line = 8;
  pdp7.memory_name = "core";
  pdp7.an_address = "an address in core";
  pdp7.memory_option = "--memory";
  pdp7.more_help = timing_help() + vcd_help(pdp7_signals()) + device_help(further_devices());
  pdp7.in_snapshot = {"--switches", "--keyboard", "--light-pen"};
  pdp7.registers = {{"PC", 15, "an address in core", true},
                    {"AC", 18, "a word"},
                    {"L", 1, "a bit"},
                    {"MQ", 18, "a word"},
                    {"SC", 6, "a step count"},
                    {"SR", 18, "a word", false, false},
                    {"ION", 1, "a bit", false, false}};
  pdp7.options = pdp7_options();
  pdp7.formats = {{"rim", {}, is<image::Format::rim>, read_image, write_tape<image::write_rim>},
                  {"hri", {}, is<image::Format::hri>, read_image, write_tape<image::write_hri>, true},
                  {"octal", {}, is<image::Format::octal>, read_image, write_octal}};
  pdp7.time_limit = "--max-time";
  pdp7.parse_time = parse_pdp7_time;
  pdp7.make = make_pdp7;
  pdp7.assembler = {"Assemble PDP-7 symbolic source (DEC, DIGITAL-7-3-S; or `as` of Bell Laboratories)",
                    "in octal",
                    "Write address, octal word and source, line by line",
                    {{.name = "--dialect",
                      .argument = "NAME",
                      .help = "Language of the sources: DEC's, or that of Bell Laboratories' `as` of 1970",
                      .choices = {"dec", bell_dialect},
                      .initial = "dec"},
                     {flag, "--twos-complement", {}, "-1 is 777777 (default: one's complement, 777776)"},
                     {flag,
                      "--undefined-are-variables",
                      {},
                      "DEC's rule: an undefined symbol is a variable (default: an error)"},
                     {flag, "--title", {}, "The first line of each source is a title, not assembled"}},
                    "rim",
                    assemble_pdp7};
  constexpr std::string_view file_help = "Tape or octal core image, FILE[@ADDRESS], ADDRESS in octal";
  pdp7.disassemblers = {
      {"pdp7", "PDP-7 instructions", file_help, disassemble<disassembler::disassemble_pdp7>,
       {"dec", {{bell_dialect, disassemble_bell}}}},
      {"type340", "Display words of the Type 340", file_help,
       disassemble<disassembler::disassemble_type340>}};
  return pdp7;
}

}  // namespace

const MachineDescription& pdp7() {
  static const MachineDescription description = describe_pdp7();
  return description;
}

}  // namespace sightline::machines
