// The 8080 as a MachineDescription: its options and what their texts mean, its program files, its assembler
// and disassembler. What the options of devices are follows from the rows of machines::SkalaRows.
#include <fmt/core.h>

#include <algorithm>

#include "emulators/devices/calcomp565.hpp"
#include "host/base/number.hpp"
#include "host/guests/run/i8080.hpp"
#include "host/guests/run/i8080_vcd.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/disasm/i8080.hpp"
#include "tools/image/binary.hpp"
#include "tools/image/intel_hex.hpp"

namespace sightline::guests::run {

namespace {

using machines::DeviceKind;
using machines::SkalaConfiguration;
using machines::SkalaRows;

constexpr std::uint64_t slowest_clock = 1'000;
constexpr std::uint64_t fastest_clock = 1'000'000'000;  // core::ClockRate's bound

// --- Devices ---

// The values of the option that attaches a device of this kind.
template <DeviceKind kind>
std::vector<std::string_view> choices() {
  std::vector<std::string_view> choices;
  SkalaRows::each([&choices](auto row) {
    if constexpr (decltype(row)::kind == kind) choices.push_back(row.choice);
  });
  return choices;
}

// visit(row, line) for every interrupt line of a device.
template <class Visit>
void each_line(Visit visit) {
  SkalaRows::each([&visit](auto row) {
    for (const auto& line : decltype(row)::lines) visit(row, line);
  });
}

// "ef9365, calcomp, parallel"
std::string line_names(std::string_view separator, std::string_view last_separator) {
  std::size_t left = 0;
  each_line([&left](auto, const auto&) { ++left; });
  std::string names;
  each_line([&](auto, const auto& line) {
    --left;
    names += fmt::format("{}{}", names.empty() ? "" : left == 0 ? last_separator : separator, line.name);
  });
  return names;
}

// The option that attaches one device of a kind.
const char* option_of(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::raster_board: return "--board";
    case DeviceKind::plotter: return "--plotter";
    case DeviceKind::terminal: return "--terminal";
    default: return "--device";
  }
}

bool is_attached(const SkalaConfiguration& machine, auto row) {
  if constexpr (decltype(row)::kind == DeviceKind::link) {
    return (machine.*decltype(row)::bytes).has_value();
  } else {
    return machine.*decltype(row)::attached;
  }
}

void attach(const Arguments& arguments, const FileReader& read, I8080Setup& setup) {
  SkalaRows::each([&](auto row) {
    using Row = decltype(row);
    if constexpr (Row::kind == DeviceKind::link) {
      const std::string option = fmt::format("--{}", Row::name);
      if (!arguments.given(option)) return;
      Input file = read(arguments.text(option));
      setup.machine.*Row::bytes = setup.sent[Row::name] = std::move(file.bytes);
      setup.sent_from[Row::name] = std::move(file.name);
    } else if constexpr (Row::kind == DeviceKind::other) {
      const auto& wanted = arguments.list("--device");
      setup.machine.*Row::attached = std::find(wanted.begin(), wanted.end(), Row::choice) != wanted.end();
    } else {
      const char* const option = option_of(Row::kind);
      setup.machine.*Row::attached = arguments.text(option) == Row::choice;
    }
  });
}

// "DEVICE=N": the request of that line is wired to RST N.
Result<Done> wire_interrupt(SkalaConfiguration& machine, const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = std::string_view(text).substr(0, equals);
  const auto restart =
      base::whole_number<std::uint8_t>(std::string_view(text).substr(std::min(equals + 1, text.size())));
  bool known = false;
  bool there = false;
  if (restart && *restart <= 7) {
    each_line([&](auto row, const auto& line) {
      if (line.name != name) return;
      known = true;
      there = is_attached(machine, row);
      machine.*line.restart = restart;
    });
  }
  if (!known) {
    return usage(fmt::format("--interrupt: found \"{}\", expected DEVICE=N with N of 0 to 7 and one of {}",
                             text, line_names(" ", " ")));
  }
  if (!there) return usage(fmt::format("--interrupt: found \"{}\", expected a device that is there", name));
  return Done{};
}

// "FIRST+LENGTH" or "FIRST+LENGTH/PERIOD", in T-states.
Result<machines::HoldTimes> hold_times(const std::string& text) {
  const std::size_t plus = std::min(text.find('+'), text.size());
  const std::size_t slash = std::min(text.find('/', plus), text.size());
  const std::string_view whole = text;
  const auto number = [](std::string_view digits) { return base::whole_number<std::uint32_t>(digits); };
  const auto first = number(whole.substr(0, plus));
  const auto length = number(whole.substr(std::min(plus + 1, slash), slash - std::min(plus + 1, slash)));
  const auto period = number(whole.substr(std::min(slash + 1, text.size())));
  const bool once = slash == text.size();
  if (first && length && *length > 0 && (once || (period && *period > *length)))
    return machines::HoldTimes{*first, *length, once ? 0 : std::int64_t{*period}};
  return usage(fmt::format("--hold: found \"{}\", expected FIRST+LENGTH or FIRST+LENGTH/PERIOD in T-states, decimal, LENGTH of 1 "
                           "and more, PERIOD longer than LENGTH",
                           text));
}

// "X,Y", decimal steps, Y on the carriage of the CalComp.
Result<devices::PlotterPlace> plotter_place(std::string_view option, const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view whole = text;
  const auto x = base::whole_number<std::uint16_t>(whole.substr(0, comma));
  const auto y = base::whole_number<std::uint16_t>(whole.substr(std::min(comma + 1, text.size())));
  constexpr std::int32_t highest = devices::calcomp565::carriage_steps;
  if (x && y && *y <= highest) return devices::PlotterPlace{*x, *y};
  return usage(
      fmt::format("{}: found \"{}\", expected X,Y, decimal, X 0 to 65535, Y 0 to {}", option, text, highest));
}

// --- A machine from its options ---

// All that decides how the machine works and is no state; --strict only says where a run ends.
std::vector<std::string> configuration_of(const I8080Setup& setup) {
  std::vector<std::string> words{fmt::format("--clock {}", setup.machine.clock.hertz)};
  if (setup.hold.length != 0) {
    words.push_back(fmt::format("--hold {}+{}", setup.hold.first, setup.hold.length));
    if (setup.hold.period != 0) words.back() += fmt::format("/{}", setup.hold.period);
  }
  if (setup.cpm) {
    words.emplace_back("--cpm");
    if (setup.cpm->console || !setup.cpm->drives.empty()) words.emplace_back("--cpm with console or drives");
    for (const CpmDrive& drive : setup.cpm->drives)
      words.push_back(fmt::format("--cpm-drive {}{}", static_cast<char>('A' + drive.number), drive.read_only ? ",ro" : ""));
  }
  SkalaRows::each([&](auto row) {
    using Row = decltype(row);
    if (!is_attached(setup.machine, row)) return;
    if constexpr (Row::kind == DeviceKind::link) {
      words.push_back(fmt::format("--{}", Row::name));
    } else if constexpr (Row::kind == DeviceKind::other) {
      words.push_back(fmt::format("--device {}", Row::choice));
    } else {
      words.push_back(fmt::format("{} {}", option_of(Row::kind), Row::choice));
      if constexpr (Row::kind == DeviceKind::terminal) words.push_back(fmt::format("--baud {}", setup.machine.*Row::baud));
    }
  });
  each_line([&](auto, const auto& line) {
    const machines::Restart restart = setup.machine.*line.restart;
    if (restart) words.push_back(fmt::format("--interrupt {}={}", line.name, *restart));
  });
  return words;
}

Result<Done> set_baud(const Arguments& arguments, SkalaConfiguration& machine) {
  constexpr std::uint64_t slowest = 50, fastest = 1'000'000;
  if (!arguments.given("--baud")) return Done{};
  const std::string& text = arguments.text("--baud");
  const auto baud = count_argument("--baud", text);
  if (!baud) return baud.error();
  if (*baud < slowest || *baud > fastest) return usage(fmt::format("--baud: found {}, expected {} to {}", text, slowest, fastest));
  SkalaRows::each([&](auto row) {
    using Row = decltype(row);
    if constexpr (Row::kind == DeviceKind::terminal) machine.*Row::baud = static_cast<std::uint32_t>(*baud);
  });
  return Done{};
}

Result<Done> set_up_cpm(const Arguments& arguments, I8080Setup& setup) {
  if (!arguments.given("--cpm")) {
    if (arguments.given("--console") && !arguments.given("--terminal"))
      return usage("--console: needs --cpm or --terminal: the console is that of CP/M, or on a serial board of the Altair");
    return Done{};
  }
  CpmSetup& cpm = setup.cpm.emplace();
  cpm.console = arguments.given("--console");
  cpm.arguments = arguments.text("--cpm-args");
  for (const std::string& text : arguments.list("--cpm-drive")) {
    auto drive = parse_cpm_drive(text);
    if (!drive) return usage(drive.error().message());
    for (const CpmDrive& other : cpm.drives) {
      if (other.number == drive->number)
        return usage(fmt::format("--cpm-drive: found two folders for drive {}, expected one", static_cast<char>('A' + other.number)));
    }
    cpm.drives.push_back(std::move(*drive));
  }
  return Done{};
}

Result<std::unique_ptr<Machine>> make(const Arguments& arguments, const FileReader& read) {
  I8080Setup setup;
  const std::string& clock = arguments.text("--clock");
  const auto hertz = count_argument("--clock", clock);
  if (!hertz) return hertz.error();
  if (*hertz < slowest_clock || *hertz > fastest_clock)
    return usage(fmt::format("--clock: found {}, expected {} to {} Hz", clock, slowest_clock, fastest_clock));
  setup.machine.clock.hertz = static_cast<std::int64_t>(*hertz);
  if (arguments.given("--plotter-start")) {
    const auto place = plotter_place("--plotter-start", arguments.text("--plotter-start"));
    if (!place) return place.error();
    setup.machine.calcomp565_start = *place;
  }
  if (arguments.given("--hold")) {
    const auto hold = hold_times(arguments.text("--hold"));
    if (!hold) return hold.error();
    setup.hold = *hold;
  }
  attach(arguments, read, setup);
  for (const std::string& text : arguments.list("--interrupt")) {
    if (const auto done = wire_interrupt(setup.machine, text); !done) return done.error();
  }
  if (auto done = set_up_cpm(arguments, setup); !done) return done.error();
  if (auto done = set_baud(arguments, setup.machine); !done) return done.error();
  setup.console = arguments.given("--console");
  if (arguments.given("--console-out") && !setup.cpm && !arguments.given("--terminal"))
    return usage("--console-out: needs --cpm or --terminal");
  setup.strict = arguments.given("--strict");
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
  setup.configuration = configuration_of(setup);
  return make_i8080(std::move(setup));
}

Result<std::int64_t> parse_time(std::string_view option, std::string_view text) {
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
  if (!image) return bad_input(image.error().message(base::MessageStyle::compiler));
  return program_of(image.value());
}

Result<Bytes> bytes_of(const base::Result<std::vector<std::uint8_t>>& bytes) {
  if (!bytes) return bad_input(bytes.error().message(base::MessageStyle::compiler));
  return bytes.value();
}

// A lone colon may as well be an 8080's LDA.
bool begins_with_hex_record(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t shortest = 11;  // `:`, then length, address, type and checksum of no bytes at all
  static constexpr std::string_view hexadecimal_digits = "0123456789abcdefABCDEF";
  return bytes.size() >= shortest && bytes.front() == ':' &&
         std::all_of(bytes.begin() + 1, bytes.begin() + shortest, [](std::uint8_t byte) {
           return hexadecimal_digits.find(static_cast<char>(byte)) != std::string_view::npos;
         });
}

using View = std::span<const std::uint8_t>;
using Address = std::optional<std::uint32_t>;

Refusal address_refused(const std::string& file, std::string_view why) {
  return usage(fmt::format("{}: found an address, expected none: {}", file, why));
}

Result<Program> read_com(View bytes, const std::string& file, Address address) {
  if (address && *address != image::com_origin) return address_refused(file, "a .com file goes to 0100");
  return program_of(image::read_com(bytes, file));
}
Result<Program> read_bin(View bytes, const std::string& file, Address address) {
  return program_of(image::read_binary(bytes, file, static_cast<std::uint16_t>(address.value_or(0))));
}
Result<Program> read_hex(View bytes, const std::string& file, Address address) {
  if (address) return address_refused(file, "Intel HEX has its own");
  return program_of(image::read_intel_hex({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file));
}

// Raw bytes without a place are a program for CP/M.
std::string_view instead_of(const Arguments& arguments, std::string_view format, bool address) {
  return arguments.given("--cpm") && format == "bin" && !address ? "com" : format;
}

Result<Assembled> assemble(std::span<const assembler::SourceFile> sources, const Arguments& arguments,
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

std::vector<Option> run_options() {
  std::vector<Option> options{
      {files, "PROGRAM,--load", "FILE[@ADDRESS]", "Sources, programs and data, in order; @ADDRESS in hexadecimal"},
      {text, "--start", "ADDRESS", "Begin at this address"},
      {text, "--restore", "FILE", "Continue from this snapshot instead of a program"},
      {flag, "--cpm", {}, "Run a CP/M .COM program"},
      {.kind = list,
       .name = "--cpm-drive",
       .argument = "X=FOLDER[,ro]",
       .help = "The files of this folder are those of drive X, A to P; ro: the program may not change them",
       .needs = "--cpm"},
      {.name = "--cpm-args",
       .argument = "WORDS",
       .help = "What is typed behind the program's name",
       .needs = "--cpm"},
      {.name = "--clock", .argument = "HZ", .help = "The processor's clock", .initial = "3000000"},
      {list, "--set", "REGISTER=VALUE",
       "Set A, F, B, C, D, E, H, L, SP, PC or INTE before the run, in hexadecimal"},
      {text, "--max-instructions", "N", "Stop after this many instructions"},
      {text, "--max-states", "N", "Stop at the first instruction at or after this T-state"},
      {flag, "--strict", {}, "Stop at a port without a device (exit code 3)"},
      {text, "--board", "BOARD", "Attach a raster board", choices<DeviceKind::raster_board>()},
      {text, "--plotter", "PLOTTER", "Attach a plotter", choices<DeviceKind::plotter>()},
      {text, "--terminal", "BOARD", "Attach a serial board of the Altair with a terminal, which --console is", choices<DeviceKind::terminal>()},
      {.name = "--baud",
       .argument = "N",
       .help = "Bits a second of the terminal's line",
       .shown_initial = "9600",
       .needs = "--terminal"},
      {.name = "--plotter-start",
       .argument = "X,Y",
       .help = "Where the CalComp's pen stands first, in steps",
       .shown_initial = "0,0",
       .needs = "--plotter calcomp"}};
  if (auto others = choices<DeviceKind::other>(); !others.empty())
    options.push_back({list, "--device", "DEVICE", "Attach this device", std::move(others)});
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
  SkalaRows::each([&](auto row) {
    using Row = decltype(row);
    if constexpr (Row::kind == DeviceKind::link) {
      const std::string option = fmt::format("--{}", Row::name);
      options.push_back({text, option, "FILE",
                         fmt::format("Attach the {}; the host computer sends these bytes", Row::chip)});
      received.push_back({.kind = output,
                          .name = option + "-out",
                          .argument = "FILE",
                          .help = std::string(Row::received_by_host),
                          .needs = option});
    }
  });
  const auto console = console_options("The console of CP/M, or the terminal,");
  options.insert(options.end(), console.begin(), console.end());
  options.insert(options.end(), rest.begin(), rest.end());
  options.insert(options.end(), received.begin(), received.end());
  options.push_back({flag, "--json", {}, "The report as one JSON document"});
  return options;
}

MachineDescription described() {
  MachineDescription i8080;
  i8080.name = "i8080";
  i8080.help = "Run a program on the 8080";
  i8080.more_help = vcd_help(i8080_signals());
  i8080.radix = 16;
  i8080.address_bits = 16;
  i8080.word_bits = 8;
  i8080.words_a_line = 16;
  i8080.one_start = true;
  i8080.in_snapshot = {"--plotter-start"};
  for (const char* name : {"A", "F", "B", "C", "D", "E", "H", "L"})
    i8080.registers.push_back({name, 8, "a value"});
  i8080.registers.push_back({"SP", 16, "a value"});
  i8080.registers.push_back({"PC", 16, "a value"});
  i8080.registers.push_back({"INTE", 1, "a value"});
  i8080.options = run_options();
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
  i8080.parse_time = parse_time;
  i8080.make = make;
  i8080.assembler = {"Assemble 8080 source (Intel ASM80, CP/M ASM and MAC, MACRO-80)",
                     "as in a source (10, 0AH, 0x0A)",
                     "Write address, bytes and source, line by line, and the symbols",
                     {{.name = "--dialect",
                       .argument = "NAME",
                       .help = "Whose language the sources are in where they differ: CP/M's MAC and ASM, MACRO-80, or Intel's",
                       .choices = {assembler::i8080_dialect_names.begin(), assembler::i8080_dialect_names.end()},
                       .initial = assembler::i8080_dialect_names.front()}},
                     "hex",
                     assemble};
  i8080.disassemblers = {
      {"i8080", "8080 instructions", "Program, FILE[@ADDRESS], ADDRESS in hexadecimal; - is standard input",
       [](const Program& program) { return disassembler::disassemble_i8080(byte_image(program)); }}};
  return i8080;
}

}  // namespace

const MachineDescription& i8080() {
  static const MachineDescription description = described();
  return description;
}

}  // namespace sightline::guests::run
