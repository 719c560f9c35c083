// The 8080 as a MachineDescription: its options and their meaning, its program files, its assembler and disassembler. The
// options of devices follow from i8080::known_devices.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/port_device.hpp"
#include "emulators/devices/bus_master.hpp"
#include "emulators/devices/calcomp565.hpp"
#include "emulators/devices/sense_switches.hpp"
#include "emulators/machines/i8080_devices.hpp"
#include "host/base/number.hpp"
#include "host/machines/device_option.hpp"
#include "host/machines/i8080.hpp"
#include "host/machines/i8080_vcd.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/disasm/i8080.hpp"
#include "tools/image/binary.hpp"
#include "tools/image/intel_hex.hpp"

namespace sightline::machines {

namespace {

using core::PortDeviceInfo;
using core::PortDeviceKind;

constexpr std::uint64_t slowest_clock = 1'000;
constexpr std::uint64_t fastest_clock = 1'000'000'000;  // core::ClockRate's bound

// --- Devices ---

// Everything from which a machine is built.
struct Wanted {
  i8080::Options options;
  std::vector<DeviceChoice> devices;  // in the order of the list
  std::map<std::string_view, std::uint8_t> interrupts;  // restart numbers by line
};

// Null: not wanted.
template <class Machine>
auto find(Machine& wanted, const PortDeviceInfo& info) {
  const auto found =
      std::find_if(wanted.devices.begin(), wanted.devices.end(), [&info](const DeviceChoice& each) { return each.name == info.name; });
  return found == wanted.devices.end() ? nullptr : &*found;
}

// Calls visit(info) for each device of a kind.
template <class Visit>
void each_of(PortDeviceKind kind, Visit visit) {
  for (const i8080::KnownDevice& known : i8080::known_devices)
    if (known.info->kind == kind) visit(*known.info);
}

// The values of the option that attaches a device of this kind.
std::vector<std::string_view> choices(PortDeviceKind kind) {
  std::vector<std::string_view> choices;
  each_of(kind, [&choices](const PortDeviceInfo& info) { choices.push_back(info.choice); });
  return choices;
}

// Calls visit(info, line) for every interrupt line of a device.
template <class Visit>
void each_line(Visit visit) {
  for (const i8080::KnownDevice& known : i8080::known_devices)
    for (const std::string_view line : known.info->lines) visit(*known.info, line);
}

// "ef9365, calcomp, parallel"
std::string line_names(std::string_view separator, std::string_view last_separator) {
  std::size_t left = 0;
  each_line([&left](const PortDeviceInfo&, std::string_view) { ++left; });
  std::string names;
  each_line([&](const PortDeviceInfo&, std::string_view line) {
    --left;
    names += fmt::format("{}{}", names.empty() ? "" : left == 0 ? last_separator : separator, line);
  });
  return names;
}

// The option that attaches one device of a kind.
const char* option_of(PortDeviceKind kind) {
  switch (kind) {
    case PortDeviceKind::raster_board: return "--board";
    case PortDeviceKind::plotter: return "--plotter";
    case PortDeviceKind::terminal: return "--terminal";
    default: return "--device";
  }
}

// The devices that --device attaches.
std::vector<ListedDevice> listed_devices() {
  std::vector<ListedDevice> devices;
  each_of(PortDeviceKind::other, [&devices](const PortDeviceInfo& info) { devices.push_back({info.name, info.help, info.options}); });
  return devices;
}

constexpr std::string_view usual_tape_channel = "2sio-b";

// Whether a paper tape is on this channel.
bool has_tape(const PortDeviceInfo& info, const Arguments& arguments) {
  const std::string& channel = arguments.text("--tape-channel");
  return arguments.given("--tape") && info.choice == (channel.empty() ? usual_tape_channel : std::string_view(channel));
}

// The choice of this device by the options; nullopt: not wanted.
std::optional<DeviceChoice> choice_of(const PortDeviceInfo& info, const Arguments& arguments, std::span<const DeviceChoice> listed) {
  switch (info.kind) {
    case PortDeviceKind::raster_board:
    case PortDeviceKind::plotter:
      if (arguments.text(option_of(info.kind)) == info.choice) return DeviceChoice{info.name, {}};
      break;
    case PortDeviceKind::terminal: {
      const bool terminal = arguments.text("--terminal") == info.choice;
      const bool tape = has_tape(info, arguments);
      if (terminal || tape) return DeviceChoice{info.name, {{"terminal", terminal ? 1 : 0}, {"tape", tape ? 1 : 0}}};
      break;
    }
    case PortDeviceKind::link:
      if (arguments.given(fmt::format("--{}", info.name))) return DeviceChoice{info.name, {}};
      break;
    case PortDeviceKind::other:
      for (const DeviceChoice& choice : listed)
        if (choice.name == info.name) return choice;
      break;
    case PortDeviceKind::special: break;
  }
  return std::nullopt;
}

// --- Settings of devices from separate options ---

using Settings = std::vector<core::Setting>;

// "FIRST+LENGTH" or "FIRST+LENGTH/PERIOD", in T-states: the settings of a bus master.
Result<Settings> hold_times(const std::string& text) {
  const std::size_t plus = std::min(text.find('+'), text.size());
  const std::size_t slash = std::min(text.find('/', plus), text.size());
  const std::string_view whole = text;
  const auto number = [](std::string_view digits) { return base::whole_number<std::uint32_t>(digits); };
  const auto first = number(whole.substr(0, plus));
  const auto length = number(whole.substr(std::min(plus + 1, slash), slash - std::min(plus + 1, slash)));
  const auto period = number(whole.substr(std::min(slash + 1, text.size())));
  const bool once = slash == text.size();
  if (first && length && *length > 0 && (once || (period && *period > *length)))
    return Settings{{"first", *first}, {"length", *length}, {"period", once ? 0 : *period}};
  return base::usage_error(fmt::format("--hold: found \"{}\", expected FIRST+LENGTH or FIRST+LENGTH/PERIOD in T-states, decimal, LENGTH of 1 "
                           "and more, PERIOD longer than LENGTH",
                           text));
}

// "X,Y", decimal steps, Y on the carriage of the CalComp: a plotter's settings.
Result<Settings> plotter_place(const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view whole = text;
  const auto x = base::whole_number<std::uint16_t>(whole.substr(0, comma));
  const auto y = base::whole_number<std::uint16_t>(whole.substr(std::min(comma + 1, text.size())));
  constexpr std::int32_t highest = devices::calcomp565::carriage_steps;
  if (x && y && *y <= highest) return Settings{{"start-x", *x}, {"start-y", *y}};
  return base::usage_error(
      fmt::format("--plotter-start: found \"{}\", expected X,Y, decimal, X 0 to 65535, Y 0 to {}", text, highest));
}

Result<Settings> terminal_baud(const std::string& text) {
  constexpr std::uint64_t slowest = 50, fastest = 1'000'000;
  const auto baud = count_argument("--baud", text);
  if (!baud) return baud.error();
  if (*baud < slowest || *baud > fastest) return base::usage_error(fmt::format("--baud: found {}, expected {} to {}", text, slowest, fastest));
  return Settings{{"baud", static_cast<std::int64_t>(*baud)}};
}

// --- A machine from its options ---

Result<Done> want_devices(const Arguments& arguments, Wanted& wanted) {
  Settings place;
  Settings hold;
  if (arguments.given("--plotter-start")) {
    auto settings = plotter_place(arguments.text("--plotter-start"));
    if (!settings) return settings.error();
    place = std::move(*settings);
  }
  if (arguments.given("--hold")) {
    auto settings = hold_times(arguments.text("--hold"));
    if (!settings) return settings.error();
    hold = std::move(*settings);
  }
  const auto listed = read_devices(arguments.list("--device"), listed_devices());
  if (!listed) return listed.error();
  for (const i8080::KnownDevice& known : i8080::known_devices)
    if (auto choice = choice_of(*known.info, arguments, *listed)) wanted.devices.push_back(std::move(*choice));
  if (DeviceChoice* const calcomp = find(wanted, devices::CalComp565::info); calcomp != nullptr) calcomp->settings = std::move(place);
  if (arguments.given("--sense")) {
    const auto value = number_argument("--sense", arguments.text("--sense"), 16, 0xFF, "the switches A15 to A8");
    if (!value) return value.error();
    wanted.devices.push_back({devices::SenseSwitches::info.name, {{"value", *value}}});
  }
  if (!hold.empty()) wanted.devices.push_back({devices::BusMaster::info.name, std::move(hold)});
  return Done{};
}

// "DEVICE=N": connects the request of that line to RST N.
Result<Done> want_interrupt(Wanted& wanted, const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = std::string_view(text).substr(0, equals);
  const auto restart =
      base::whole_number<std::uint8_t>(std::string_view(text).substr(std::min(equals + 1, text.size())));
  bool known = false;
  bool there = false;
  if (restart && *restart <= 7) {
    each_line([&](const PortDeviceInfo& info, std::string_view line) {
      if (line != name) return;
      known = true;
      there = find(wanted, info) != nullptr;
      wanted.interrupts[line] = *restart;
    });
  }
  if (!known) {
    return base::usage_error(fmt::format("--interrupt: found \"{}\", expected DEVICE=N with N of 0 to 7 and one of {}",
                             text, line_names(" ", " ")));
  }
  if (!there) return base::usage_error(fmt::format("--interrupt: found \"{}\", expected an attached device", name));
  return Done{};
}

// Everything that determines how the machine works and is not state; --strict only determines where a run ends.
std::vector<std::string> configuration_of(const Wanted& wanted, const std::optional<CpmSetup>& cpm) {
  std::vector<std::string> words{fmt::format("--clock {}", wanted.options.clock.hertz)};
  if (wanted.options.memory != image::byte_memory_size) words.push_back(fmt::format("--memory {}k", wanted.options.memory / 1024));
  if (const DeviceChoice* const sense = find(wanted, devices::SenseSwitches::info); sense != nullptr)
    words.push_back(fmt::format("--sense {:02X}", sense->settings[0].value));
  if (const DeviceChoice* const hold = find(wanted, devices::BusMaster::info); hold != nullptr) {
    words.push_back(fmt::format("--hold {}+{}", hold->settings[0].value, hold->settings[1].value));
    if (hold->settings[2].value != 0) words.back() += fmt::format("/{}", hold->settings[2].value);
  }
  if (cpm) {
    words.emplace_back("--cpm");
    if (cpm->console || !cpm->drives.empty()) words.emplace_back("--cpm with console or drives");
    for (const CpmDrive& drive : cpm->drives)
      words.push_back(fmt::format("--cpm-drive {}{}", static_cast<char>('A' + drive.number), drive.read_only ? ",ro" : ""));
    for (const CpmCommand& command : cpm->commands) words.push_back("--cpm-run " + command.text);
  }
  for (const i8080::KnownDevice& known : i8080::known_devices) {
    const PortDeviceInfo& info = *known.info;
    const DeviceChoice* const choice = find(wanted, info);
    if (choice == nullptr) continue;
    switch (info.kind) {
      case PortDeviceKind::special: break;
      case PortDeviceKind::link: words.push_back(fmt::format("--{}", info.name)); break;
      case PortDeviceKind::other: words.push_back(fmt::format("--device {}", device_text(*choice))); break;
      case PortDeviceKind::terminal: {
        const auto setting = [&](std::string_view name) { return core::value_of(name, info.options, choice->settings); };
        if (setting("terminal") != 0) words.push_back(fmt::format("--terminal {}", info.choice));
        if (setting("tape") != 0) words.push_back(fmt::format("--tape-channel {}", info.choice));
        words.push_back(fmt::format("--baud {}", setting("baud")));
        break;
      }
      default: words.push_back(fmt::format("{} {}", option_of(info.kind), info.choice));
    }
  }
  each_line([&](const PortDeviceInfo&, std::string_view line) {
    const auto restart = wanted.interrupts.find(line);
    if (restart != wanted.interrupts.end()) words.push_back(fmt::format("--interrupt {}={}", line, restart->second));
  });
  return words;
}

Result<Done> set_up_cpm(const Arguments& arguments, const FileReader& read, I8080Setup& setup) {
  if (!arguments.given("--cpm")) {
    if (arguments.given("--console") && !arguments.given("--terminal"))
      return base::usage_error("--console: needs --cpm or --terminal: the console is that of CP/M, or on a serial board of the Altair");
    return Done{};
  }
  CpmSetup& cpm = setup.cpm.emplace();
  cpm.console = arguments.given("--console");
  cpm.arguments = arguments.text("--cpm-args");
  constexpr std::size_t most = cpm::longest_tail - 1;  // without the blank before them
  if (cpm.arguments.size() > most) {
    return base::usage_error(fmt::format("--cpm-args: found {} characters, expected {} at most: CP/M's command line has no room for more",
                                         cpm.arguments.size(), most));
  }
  if (arguments.given("--cpm-user")) {
    const auto user = base::whole_number<std::uint8_t>(arguments.text("--cpm-user"));
    if (!user || *user > 15) return base::usage_error(fmt::format("--cpm-user: found \"{}\", expected 0 to 15", arguments.text("--cpm-user")));
    cpm.user = *user;
  }
  for (const std::string& text : arguments.list("--cpm-drive")) {
    auto drive = parse_cpm_drive(text);
    if (!drive) return base::usage_error(drive.error().message());
    for (const CpmDrive& other : cpm.drives) {
      if (other.number == drive->number)
        return base::usage_error(fmt::format("--cpm-drive: found two folders for drive {}, expected one", static_cast<char>('A' + other.number)));
    }
    cpm.drives.push_back(std::move(*drive));
  }
  if (!arguments.given("--cpm-run")) return Done{};
  if (cpm.drives.empty()) return base::usage_error("--cpm-run: needs --cpm-drive X=FOLDER: its programs are files of a drive");
  if (arguments.given("--cpm-args"))
    return base::usage_error("--cpm-args: found --cpm-run too, expected one of them: each command has its own arguments");
  const Input file = read(arguments.text("--cpm-run"));
  auto commands = read_cpm_commands(file);
  if (!commands) return commands.error();
  cpm.commands = std::move(*commands);
  return Done{};
}

Result<Done> set_baud(const Arguments& arguments, Wanted& wanted) {
  if (!arguments.given("--baud")) return Done{};
  const auto settings = terminal_baud(arguments.text("--baud"));
  if (!settings) return settings.error();
  each_of(PortDeviceKind::terminal, [&](const PortDeviceInfo& info) {
    if (DeviceChoice* const terminal = find(wanted, info); terminal != nullptr)
      terminal->settings.insert(terminal->settings.end(), settings->begin(), settings->end());
  });
  return Done{};
}

// The bytes that the host sends over a link, and those of a paper tape, are in a file.
void read_links(const Arguments& arguments, const FileReader& read, I8080Setup& setup) {
  const auto read_for = [&](const PortDeviceInfo& info, const std::string& option) {
    Input file = read(arguments.text(option));
    setup.sent[info.name] = std::move(file.bytes);
    setup.sent_from[info.name] = std::move(file.name);
  };
  each_of(PortDeviceKind::link, [&](const PortDeviceInfo& info) {
    if (const std::string option = fmt::format("--{}", info.name); arguments.given(option)) read_for(info, option);
  });
  each_of(PortDeviceKind::terminal, [&](const PortDeviceInfo& info) {
    if (has_tape(info, arguments)) read_for(info, "--tape");
  });
}

// "16k": from 1k to 64k.
Result<std::uint32_t> memory_size(const std::string& text) {
  constexpr std::uint32_t kilobyte = 1024;
  std::string_view digits = text;
  if (digits.ends_with('k') || digits.ends_with('K')) digits.remove_suffix(1);
  const auto size = base::whole_number<std::uint32_t>(digits);
  if (size && *size >= 1 && *size <= image::byte_memory_size / kilobyte) return *size * kilobyte;
  return base::usage_error(fmt::format("--memory: found \"{}\", expected 1k to 64k", text));
}

Result<Done> build_machine(const Wanted& wanted, I8080Setup& setup) {
  setup.machine = std::make_unique<i8080::Machine>(wanted.options);
  for (const DeviceChoice& choice : wanted.devices)
    if (const std::string error = setup.machine->attach(choice.name, choice.settings); !error.empty()) return base::usage_error(error);
  for (const auto& [line, restart] : wanted.interrupts)
    if (const std::string error = setup.machine->wire(line, restart); !error.empty()) return base::usage_error(error);
  for (const auto& [link, bytes] : setup.sent) setup.machine->device(link)->link_host()->send(bytes);
  return Done{};
}

Result<std::unique_ptr<Machine>> make_i8080(const Arguments& arguments, const FileReader& read) {
  I8080Setup setup;
  Wanted wanted;
  const std::string& clock = arguments.text("--clock");
  const auto hertz = count_argument("--clock", clock);
  if (!hertz) return hertz.error();
  if (*hertz < slowest_clock || *hertz > fastest_clock)
    return base::usage_error(fmt::format("--clock: found {}, expected {} to {} Hz", clock, slowest_clock, fastest_clock));
  const auto memory = memory_size(arguments.text("--memory"));
  if (!memory) return memory.error();
  if (*memory != image::byte_memory_size && arguments.given("--cpm"))
    return base::usage_error(fmt::format("--memory {}: found --cpm too, expected one of them: CP/M is at the end of 64k", arguments.text("--memory")));
  wanted.options = {{static_cast<std::int64_t>(*hertz)}, arguments.given("--strict"), *memory};
  if (auto done = want_devices(arguments, wanted); !done) return done.error();
  read_links(arguments, read, setup);
  for (const std::string& text : arguments.list("--interrupt")) {
    if (const auto done = want_interrupt(wanted, text); !done) return done.error();
  }
  if (auto done = set_up_cpm(arguments, read, setup); !done) return done.error();
  if (auto done = set_baud(arguments, wanted); !done) return done.error();
  setup.console = arguments.given("--console");
  if (arguments.given("--console-out") && !setup.cpm && !arguments.given("--terminal"))
    return base::usage_error("--console-out: needs --cpm or --terminal");
  setup.observed = arguments.given("--trace") || arguments.given("--bus") || arguments.given("--vcd");
  if (arguments.given("--vcd")) {
    auto writer = VcdWriter::make("i8080", i8080_signals(), vcd_target(arguments.text("--vcd")).signals);
    if (!writer) return writer.error();
    setup.vcd = std::move(*writer);
  }
  setup.keep_console = setup.cpm.has_value() && arguments.given("--json") && !arguments.given("--console-out");
  setup.monitored = arguments.given("--monitor");
  setup.drawing = arguments.given("--svg");
  setup.grey = arguments.given("--grey");
  setup.configuration = configuration_of(wanted, setup.cpm);
  if (auto done = build_machine(wanted, setup); !done) return done.error();
  return make_i8080(std::move(setup));
}

Result<std::int64_t> parse_i8080_time(std::string_view option, std::string_view text) {
  constexpr std::uint64_t longest = std::uint64_t{1} << 62;
  const auto count = count_argument(option, text);
  if (!count) return count.error();
  return static_cast<std::int64_t>(std::min(*count, longest));
}

// --- Programs ---

image::ByteImage byte_image(const Program& program) {
  image::ByteImage image;
  for (const auto& [address, byte] : program.words)
    image.put(static_cast<std::uint16_t>(address), static_cast<std::uint8_t>(byte));
  if (program.start) image.start = static_cast<std::uint16_t>(*program.start);
  return image;
}

Program program_of(const image::ByteImage& image) {
  Program program;
  program.start = image.start;
  if (image.empty()) return program;
  for (std::uint32_t address = image.lowest(); address <= image.highest(); ++address) {
    const auto a = static_cast<std::uint16_t>(address);
    if (image.used(a)) program.words.emplace_back(address, image[a]);
  }
  return program;
}

Result<Program> program_of(const base::Result<image::ByteImage>& image) {
  if (!image) return base::bad_input(image.error().message(base::MessageStyle::compiler));
  return program_of(image.value());
}

Result<Bytes> bytes_of(const base::Result<std::vector<std::uint8_t>>& bytes) {
  if (!bytes) return base::bad_input(bytes.error().message(base::MessageStyle::compiler));
  return bytes.value();
}

// A lone colon can also be the 8080's LDA opcode.
bool begins_with_hex_record(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t shortest = 11;  // `:`, then length, address, type and checksum of no bytes at all
  static constexpr std::string_view hexadecimal_digits = "0123456789abcdefABCDEF";
  return bytes.size() >= shortest && bytes.front() == ':' &&
         std::all_of(bytes.begin() + 1, bytes.begin() + shortest, [](std::uint8_t byte) {
           return hexadecimal_digits.find(static_cast<char>(byte)) != std::string_view::npos;
         });
}

using View = std::span<const std::uint8_t>;
using LoadAddress = std::optional<std::uint32_t>;

base::Error address_refused(const std::string& file, std::string_view why) {
  return base::usage_error(fmt::format("{}: found an address, expected none: {}", file, why));
}

Result<Program> read_com(View bytes, const std::string& file, LoadAddress address) {
  if (address && *address != image::com_origin) return address_refused(file, "a .com file goes to 0100");
  return program_of(image::read_com(bytes, file));
}
Result<Program> read_bin(View bytes, const std::string& file, LoadAddress address) {
  return program_of(image::read_binary(bytes, file, static_cast<std::uint16_t>(address.value_or(0))));
}
Result<Program> read_hex(View bytes, const std::string& file, LoadAddress address) {
  if (address) return address_refused(file, "Intel HEX has its own");
  std::vector<std::string> warnings;
  auto program = program_of(image::read_intel_hex({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file, &warnings));
  if (program) program->warnings = std::move(warnings);
  return program;
}

// With --cpm, raw bytes without an address are a CP/M program.
std::string_view instead_of(const Arguments& arguments, std::string_view format, bool address) {
  return arguments.given("--cpm") && format == "bin" && !address ? "com" : format;
}

Result<Assembled> assemble_i8080(std::span<const assembler::SourceFile> sources, const Arguments& arguments,
                           const TextReader& include) {
  assembler::I8080Options options;
  auto defines = read_defines(arguments, assembler::parse_i8080_define);
  if (!defines) return defines.error();
  options.defines = std::move(*defines);
  options.listing = arguments.given("--listing");
  options.dialect = assembler::i8080_dialect_named(arguments.text("--dialect")).value_or(assembler::I8080Dialect::common);
  options.include = include;
  const auto assembly = assembler::assemble_i8080(sources, options);
  return Assembled{assembly.diagnostics, program_of(assembly.image), assembly.symbols.size(),
                   assembler::write_listing(assembly.listing),
                   assembler::write_i8080_symbols(assembly.symbols), source_lines(assembly.listing, 16)};
}

// --- The description ---

using enum OptionKind;

std::vector<Option> i8080_options() {
  std::vector<Option> options{
      {files, "PROGRAM,--load", "FILE[@ADDRESS]", "Sources, programs and data, in order; @ADDRESS in hexadecimal"},
      {text, "--start", "ADDRESS", "Begin at this address"},
      {text, "--restore", "FILE", "Continue from this snapshot instead of a program"},
      {flag, "--cpm", {}, "Run a CP/M .COM program"},
      {.kind = list,
       .name = "--cpm-drive",
       .argument = "X=FOLDER[,ro]",
       .help = "Make this folder drive X, A to P; ro: the program cannot change its files",
       .needs = "--cpm"},
      {.name = "--cpm-user", .argument = "N", .help = "The user number at the start, 0 to 15", .shown_initial = "0", .needs = "--cpm"},
      {.name = "--cpm-args",
       .argument = "WORDS",
       .help = "The arguments typed after the program's name",
       .needs = "--cpm"},
      {.name = "--cpm-run",
       .argument = "FILE",
       .help = "Run the commands in this file one after the other, instead of a PROGRAM",
       .needs = "--cpm"},
      {.name = "--clock", .argument = "HZ", .help = "The processor's clock", .initial = "3000000"},
      {.name = "--memory", .argument = "SIZE", .help = "RAM from 0000 on, 1k to 64k; above it reads are FF and writes are lost", .initial = "64k"},
      {text, "--sense", "XX", "An Altair's front panel: its sense switches, read at port FF, in hexadecimal"},
      {list, "--set", "REGISTER=VALUE",
       "Set A, F, B, C, D, E, H, L, SP, PC or INTE before the run, in hexadecimal"},
      {text, "--max-instructions", "N", "Stop after this many instructions"},
      {text, "--max-states", "N", "Stop at the first instruction at or after this T-state"},
      {flag, "--strict", {}, "Stop at a port without a device and after an undefined opcode (exit code 3)"},
      {text, "--board", "BOARD", "Attach a raster board", choices(PortDeviceKind::raster_board)},
      {text, "--plotter", "PLOTTER", "Attach a plotter", choices(PortDeviceKind::plotter)},
      {text, "--terminal", "BOARD", "Attach an Altair serial board with a terminal, to which --console connects", choices(PortDeviceKind::terminal)},
      {.name = "--baud",
       .argument = "N",
       .help = "Bits per second on the terminal's line",
       .shown_initial = "9600",
       .needs = "--terminal"},
      {.name = "--plotter-start",
       .argument = "X,Y",
       .help = "Initial position of the CalComp's pen, in steps",
       .shown_initial = "0,0",
       .needs = "--plotter calcomp"}};
  if (auto listed = device_option(listed_devices())) options.push_back(std::move(*listed));
  const std::vector<Option> rest{
      {list, "--interrupt", "DEVICE=N", fmt::format("Wire {} to RST N", line_names(", ", " or "))},
      {text, "--hold", "FIRST+LENGTH[/PERIOD]",
       "A board takes the bus: HOLD is high for LENGTH T-states from FIRST on, and again every PERIOD"},
      {output, "--dump", "FILE", "Registers and all of memory after the run"},
      {output, "--save", "FILE", "A snapshot of the whole machine after the run"},
      {stream, "--trace", "FILE", "Every instruction"},
      {stream, "--bus", "FILE", "Every machine cycle"},
      {stream, "--vcd", "FILE[:SIGNALS]", "Pins by T-state and registers as a value change dump; names below"},
      {.kind = stream,
       .name = "--console-out",
       .argument = "FILE",
       .help = "What the CP/M program prints, or sends to the terminal",
       .needs = {},
       .stdout_with = "--cpm",
       .content = "what the program prints"},
      {.kind = stream,
       .name = "--list",
       .argument = "FILE",
       .help = "What the CP/M program sends to the list device",
       .needs = "--cpm"},
      {.kind = stream, .name = "--cpm-log", .argument = "FILE", .help = "Every call of BDOS", .needs = "--cpm"},
      {.kind = output,
       .name = "--png",
       .argument = "FILE",
       .help = "What the raster board shows, 256x256 in eight colours",
       .needs = "--board"},
      {.kind = flag, .name = "--grey", .help = "The PNG in eight levels of grey instead", .needs = "--png"},
      {.kind = stream,
       .name = "--strokes",
       .argument = "FILE",
       .help = "Every step of the plotter's lowered pen",
       .needs = "--plotter"},
      {.kind = output,
       .name = "--svg",
       .argument = "FILE",
       .help = "What the plotter drew, in millimetres",
       .needs = "--plotter"}};
  std::vector<Option> received;
  each_of(PortDeviceKind::link, [&](const PortDeviceInfo& info) {
    const std::string option = fmt::format("--{}", info.name);
    options.push_back({text, option, "FILE", fmt::format("Attach the {}; the host computer sends these bytes", info.choice)});
    received.push_back({.kind = output, .name = option + "-out", .argument = "FILE", .help = std::string(info.received), .needs = option});
  });
  options.push_back({text, "--tape", "FILE", "Attach a paper tape reader and punch to an Altair serial channel; this tape is read, unchanged"});
  options.push_back({.name = "--tape-channel",
                     .argument = "BOARD",
                     .help = "Their channel; with that of --terminal they are the terminal's",
                     .choices = choices(PortDeviceKind::terminal),
                     .shown_initial = usual_tape_channel,
                     .needs = "--tape"});
  received.push_back({.kind = output, .name = "--tape-out", .argument = "FILE", .help = "What the program punched, unchanged", .needs = "--tape"});
  const auto console = console_options("The console of CP/M, or the terminal,");
  options.insert(options.end(), console.begin(), console.end());
  options.insert(options.end(), rest.begin(), rest.end());
  options.insert(options.end(), received.begin(), received.end());
  options.push_back({flag, "--json", {}, "The report as one JSON document"});
  return options;
}

MachineDescription describe_i8080() {
  MachineDescription i8080;
  i8080.name = "i8080";
  i8080.help = "Run a program on the 8080";
  i8080.more_help = vcd_help(i8080_signals()) + device_help(listed_devices());
  i8080.radix = 16;
  i8080.address_bits = 16;
  i8080.word_bits = 8;
  i8080.words_per_line = 16;
  i8080.memory_option = "--memory";
  i8080.one_start = true;
  i8080.in_snapshot = {"--plotter-start", "--cpm-args", "--cpm-user"};
  i8080.instead_of_program = "--cpm-run";
  for (const char* name : {"A", "F", "B", "C", "D", "E", "H", "L"})
    i8080.registers.push_back({name, 8, "a value"});
  i8080.registers.push_back({"SP", 16, "a value"});
  i8080.registers.push_back({"PC", 16, "a value"});
  i8080.registers.push_back({"INTE", 1, "a value"});
  i8080.options = i8080_options();
  i8080.formats = {{"com", ".com", [](View) { return false; }, read_com,
                    [](const Program& program, const std::string& file) {
                      return bytes_of(image::write_com(byte_image(program), file));
                    },
                    false,
                    "--cpm",
                    "without it the functions of CP/M are missing"},
                   {"bin", ".bin", [](View bytes) { return !begins_with_hex_record(bytes); }, read_bin,
                    [](const Program& program, const std::string& file) {
                      return bytes_of(image::write_binary(byte_image(program), file));
                    }},
                   {"hex", ".hex", begins_with_hex_record, read_hex,
                    [](const Program& program, const std::string&) -> Result<Bytes> {
                      const std::string text = image::write_intel_hex(byte_image(program));
                      return Bytes(text.begin(), text.end());
                    }}};
  i8080.instead_of = instead_of;
  i8080.time_limit = "--max-states";
  i8080.parse_time = parse_i8080_time;
  i8080.make = make_i8080;
  i8080.assembler = {"Assemble 8080 source (Intel ASM80, CP/M ASM and MAC, MACRO-80)",
                     "as in a source (10, 0AH, 0x0A)",
                     "Write address, bytes and source, line by line, and the symbols",
                     {{.name = "--dialect",
                       .argument = "NAME",
                       .help = "Dialect of the sources: common, or that of CP/M's MAC and ASM, MACRO-80, or Intel",
                       .choices = {assembler::i8080_dialect_names.begin(), assembler::i8080_dialect_names.end()},
                       .initial = assembler::i8080_dialect_names.front()}},
                     "hex",
                     assemble_i8080};
  i8080.disassemblers = {
      {"i8080", "8080 instructions", "Program, FILE[@ADDRESS], ADDRESS in hexadecimal; - is standard input",
       [](const Program& program) { return disassembler::disassemble_i8080(byte_image(program)); }}};
  return i8080;
}

}  // namespace

const MachineDescription& i8080() {
  static const MachineDescription description = describe_i8080();
  return description;
}

}  // namespace sightline::machines
