// See engine.hpp and machine.hpp.
#include "host/machines/engine.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::machines {

namespace {

const char* radix_name(int radix) {
  return radix == 16 ? "hexadecimal" : radix == 8 ? "octal" : "decimal";
}

std::string in_radix(std::uint32_t value, int radix, unsigned width = 0) {
  if (radix == 16) return fmt::format("{:0{}X}", value, width);
  if (radix == 8) return fmt::format("{:0{}o}", value, width);
  return fmt::format("{:0{}}", value, width);
}

// Removes the 0x before or the H after a hexadecimal number.
std::string_view without_mark(std::string_view text, int radix) {
  if (radix != 16) return text;
  if (text.starts_with("0x") || text.starts_with("0X")) return text.substr(2);
  if (text.ends_with('h') || text.ends_with('H')) text.remove_suffix(1);
  return text;
}

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return upper;
}

std::string register_name(std::string_view setting) {
  return upper_case(setting.substr(0, setting.find('=')));
}

std::string address_text(const MachineDescription& machine, std::uint32_t address) {
  return digits(machine, address, machine.address_bits);
}

std::size_t program_counter(const MachineDescription& machine) {
  const auto found = std::find_if(machine.registers.begin(), machine.registers.end(),
                                  [](const Register& r) { return r.name == "PC"; });
  return static_cast<std::size_t>(found - machine.registers.begin());
}

Result<Done> set_register(const MachineDescription& description, Machine& machine,
                          const std::string& setting) {
  const std::string name = register_name(setting);
  const auto found = std::find_if(description.registers.begin(), description.registers.end(),
                                  [&name](const Register& r) { return r.name == name; });
  const std::size_t equals = setting.find('=');
  if (found == description.registers.end() || equals == std::string::npos) {
    std::string names;
    for (const Register& each : description.registers) names += fmt::format(" {}", each.name);
    return base::usage_error(fmt::format("--set: found \"{}\", expected REGISTER=VALUE with one of{}", setting, names));
  }
  const std::uint32_t most = found->in_core ? machine.words() - 1 : (1U << found->bits) - 1;
  const auto value = number_argument("--set " + name, std::string_view(setting).substr(equals + 1),
                                     description.radix, most, found->what);
  if (!value) return value.error();
  machine.set(static_cast<std::size_t>(found - description.registers.begin()), *value);
  return Done{};
}

// Null means a dump.
const Format* find_format(const MachineDescription& machine, const FileArgument& file, const Input& input,
                          std::string_view format, const Arguments* arguments) {
  const std::vector<Format>& formats = machine.formats;
  const auto named = [&formats](std::string_view name) {
    return std::find_if(formats.begin(), formats.end(),
                        [name](const Format& each) { return each.name == name; });
  };
  if (!format.empty()) return &*named(format);
  const Format* found = format_by_name(machine, file.path);
  if (found == nullptr && is_dump(machine, input.bytes)) return nullptr;
  for (auto each = formats.begin(); found == nullptr && each != formats.end(); ++each) {
    if (each->recognise(input.bytes)) found = &*each;
  }
  if (found == nullptr) found = &formats.back();
  if (arguments != nullptr && machine.instead_of != nullptr)
    found = &*named(machine.instead_of(*arguments, found->name, file.address.has_value()));
  return found;
}

Result<Program> read_as(const MachineDescription& machine, const Format* format, const FileArgument& file,
                        const Input& input) {
  if (format != nullptr) return format->read(input.bytes, input.name, file.address);
  if (file.address) return base::usage_error(fmt::format("{}: found an address, expected none: a dump begins at 0", input.name));
  return read_dump(machine, input);
}

// The machine after loading, and what its start needs.
struct Loaded {
  std::optional<std::uint32_t> start;
  std::vector<std::pair<std::size_t, std::uint32_t>> registers;
  std::vector<std::string> warnings;
  std::vector<bool> addresses;  // those with a word
};

// If two files have a word for the same address, the later file wins; likewise for the start address and registers.
Result<Loaded> load(const MachineDescription& description, const Arguments& arguments, const FileReader& read,
                    Machine& machine) {
  Loaded loaded;
  loaded.addresses.resize(machine.words());
  for (const std::string& text : arguments.list("--load")) {
    const auto file = file_argument(description, "--load", text);
    if (!file) return file.error();
    const Input input = read(file->path);
    if (named_as_source(file->path)) {
      std::string message = input.name + ": found a source file, expected an assembled program";
      if (description.assembler.assemble != nullptr)
        message += fmt::format("; assemble it with: sightline asm {} {} -o PROGRAM", description.name, file->path);
      return base::bad_input(message);
    }
    if (input.bytes.size() >= snapshot_signature.size() &&
        std::equal(snapshot_signature.begin(), snapshot_signature.end(), input.bytes.begin())) {
      return base::bad_input(fmt::format("{}: found a snapshot, expected a program; continue from it with: sightline run {} "
                                   "--restore {}",
                                   input.name, description.name, file->path));
    }
    const Format* const format = find_format(description, *file, input, {}, &arguments);
    const auto program = read_as(description, format, *file, input);
    if (!program) return program.error();
    loaded.warnings.insert(loaded.warnings.end(), program->warnings.begin(), program->warnings.end());
    if (format != nullptr && !format->meant_for.empty() && !arguments.given(format->meant_for)) {
      loaded.warnings.push_back(fmt::format("{}: found a {} file, expected {} with it; {}", input.name, format->ending,
                                            format->meant_for, format->missing));
    }
    const auto outside = [&](std::string_view what, std::uint32_t address) {
      const std::string size =
          description.memory_option.empty()
              ? std::string()
              : fmt::format(" ({} {})", description.memory_option, arguments.text(description.memory_option));
      return base::bad_input(fmt::format("{}: error: found {} {}, expected one in {}, {}-{}{}", input.name, what,
                                   address_text(description, address), description.memory_name,
                                   address_text(description, 0),
                                   address_text(description, machine.words() - 1), size));
    };
    for (const auto& [address, word] : program->words) {
      if (address >= machine.words()) return outside("a word for address", address);
      if (word >> description.word_bits != 0)
        return base::bad_input(fmt::format("{}: error: found {} at address {}, expected a word of {} bits",
                                     input.name, in_radix(word, description.radix),
                                     address_text(description, address), description.word_bits));
      machine.put(address, word);
      loaded.addresses[address] = true;
    }
    if (!program->registers.empty()) loaded.registers = program->registers;
    if (!program->start) continue;
    if (*program->start >= machine.words()) return outside("the start address", *program->start);
    loaded.start = program->start;
    loaded.registers.clear();
  }
  return loaded;
}

bool sets_pc(const Arguments& arguments) {
  const std::vector<std::string>& settings = arguments.list("--set");
  return std::any_of(settings.begin(), settings.end(),
                     [](const std::string& setting) { return register_name(setting) == "PC"; });
}

// The start comes from --start, otherwise from --set PC, otherwise from the loaded programs. A dump continues without a
// start.
Result<Done> start(const MachineDescription& description, const Arguments& arguments, const Loaded& loaded,
                   Machine& machine) {
  for (const auto& [number, value] : loaded.registers) machine.set(number, value);
  if (arguments.given("--start")) {
    if (sets_pc(arguments) && description.one_start) return base::usage_error("--set PC: found --start too, expected one of them");
    const auto address = number_argument("--start", arguments.text("--start"), description.radix,
                                         machine.words() - 1, description.an_address);
    if (!address) return address.error();
    machine.start(*address);
  } else if (!sets_pc(arguments) && loaded.registers.empty()) {
    machine.start(machine.start_address(loaded.start));
  }
  for (const std::string& setting : arguments.list("--set")) {
    if (const auto done = set_register(description, machine, setting); !done) return done;
  }
  return Done{};
}

// Advice for a program that runs into empty memory.
std::string remedy_for_empty_memory(const Arguments& arguments, const Loaded& loaded, const Machine& machine) {
  const auto lowest = std::find(loaded.addresses.begin(), loaded.addresses.end(), true) - loaded.addresses.begin();
  const std::string_view system = machine.system_missing(static_cast<std::uint32_t>(lowest));
  if (!system.empty()) return std::string(system);
  const bool says_where = loaded.start || !loaded.registers.empty() || arguments.given("--start") || sets_pc(arguments);
  return says_where ? "" : "--start names where the program begins";
}

Result<Limits> limits_of(const MachineDescription& description, const Arguments& arguments) {
  Limits limits;
  if (arguments.given("--max-instructions")) {
    const auto count = count_argument("--max-instructions", arguments.text("--max-instructions"));
    if (!count) return count.error();
    limits.instructions = *count;
  }
  if (arguments.given(description.time_limit)) {
    const auto until = description.parse_time(description.time_limit, arguments.text(description.time_limit));
    if (!until) return until.error();
    limits.until = *until;
  }
  return limits;
}

// A snapshot holds a program, its state, and the pending lines of scripts.
Result<Done> check_snapshot_alone(const MachineDescription& description, const Arguments& arguments) {
  std::vector<std::string_view> held{"--load", "--start"};
  held.insert(held.end(), description.in_snapshot.begin(), description.in_snapshot.end());
  for (const std::string_view option : held) {
    if (!arguments.given(option)) continue;
    return base::usage_error(fmt::format("--restore: found {} too, expected one of them: the snapshot holds what {} gives",
                             option == "--load" ? "a PROGRAM" : option, option == "--load" ? "it" : option));
  }
  return Done{};
}

// Converts limits relative to the machine's current state to absolute ones.
Limits from_here(const Limits& limits, const Machine& machine) {
  constexpr Limits none;
  Limits later;
  if (limits.instructions <= none.instructions - machine.instructions())
    later.instructions = machine.instructions() + limits.instructions;
  if (limits.until <= none.until - machine.ticks()) later.until = machine.ticks() + limits.until;
  return later;
}

Result<Done> check_needs(const MachineDescription& description, const Arguments& arguments) {
  if (arguments.given("--restore")) {
    if (auto done = check_snapshot_alone(description, arguments); !done) return done;
  } else if (arguments.given(description.instead_of_program)) {
    if (!arguments.list("--load").empty())
      return base::usage_error(fmt::format("{}: found a PROGRAM too, expected one of them", description.instead_of_program));
  } else if (arguments.list("--load").empty()) {
    return base::usage_error(fmt::format("run {}: needs a PROGRAM or --load FILE: without a program there is nothing to run",
                             description.name));
  }
  for (const Option& option : description.options) {
    if (option.needs.empty() || !arguments.given(option.key())) continue;
    const std::string_view needs = option.needs;
    const std::string_view name = needs.substr(0, needs.find(' '));
    const bool there =
        name == needs ? arguments.given(name) : arguments.text(name) == needs.substr(name.size() + 1);
    if (!there) return base::usage_error(fmt::format("{}: needs {}", option.key(), option.needs));
  }
  return Done{};
}

// The words of a line of a dump, separated by blanks.
std::vector<std::string_view> dump_words(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::string_view word = base::take_word(line);
    if (word.empty()) return words;
    words.push_back(word);
  }
}

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::size_t> dumped_registers(const MachineDescription& description) {
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < description.registers.size(); ++n)
    if (description.registers[n].in_dump) numbers.push_back(n);
  return numbers;
}

// nullopt if the word does not have exactly the digits of `bits` bits, or is larger.
std::optional<std::uint32_t> dump_number(const MachineDescription& description, std::string_view word, unsigned bits) {
  if (word.size() != digits(description, 0, bits).size()) return std::nullopt;
  const auto value = base::unsigned_number(word, description.radix);
  if (!value || *value >> bits != 0) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

}  // namespace

bool named_as_source(std::string_view path) {
  constexpr std::array<std::string_view, 4> endings{".s", ".asm", ".mac", ".pal"};
  return std::any_of(endings.begin(), endings.end(),
                     [path](std::string_view ending) { return path.ends_with(ending); });
}

Arguments::Arguments(std::span<const Option> options) {
  for (const Option& option : options) values_[std::string(option.key())].text = option.initial;
}

Arguments::Value& Arguments::value(std::string_view key) {
  return values_.try_emplace(std::string(key)).first->second;
}

const Arguments::Value& Arguments::find(std::string_view key) const {
  static const Value none;
  const auto found = values_.find(key);
  return found == values_.end() ? none : found->second;
}

void Arguments::add_step(std::string_view option, const std::string& text) {
  value(option).flag = true;
  steps_.push_back({std::string(option), text});
}

bool Arguments::given(std::string_view key) const {
  const Value& value = find(key);
  return value.flag || !value.text.empty() || !value.list.empty();
}

std::vector<Option> console_options(std::string_view device) {
  return {{.name = "--console",
           .argument = "MODE",
           .help = fmt::format("{} is your terminal, or standard input and output; MODE is what its keys send: ascii, "
                               "parity, unix or upper",
                               device)},
          {.name = "--speed",
           .argument = "real|max|N",
           .help = "Run in real time, as fast as possible, or N times as fast as the machine; needs --console",
           .shown_initial = "real at a terminal, else max",
           .needs = "--console"},
          {.kind = OptionKind::step,
           .name = "--expect",
           .argument = "PRINTED",
           .help = "Wait until the program has printed this; --expect and --send in the order of the session",
           .needs = "--console"},
          {.kind = OptionKind::step,
           .name = "--within",
           .argument = "SECONDS",
           .help = "The --expect before it fails after this emulated time",
           .needs = "--console"},
          {.kind = OptionKind::step,
           .name = "--send",
           .argument = "KEYS",
           .help = "Type this as the program asks for keys",
           .needs = "--console"}};
}

Result<std::uint32_t> number_argument(std::string_view option, std::string_view text, int radix,
                                      std::uint32_t most, std::string_view what) {
  const auto value = base::unsigned_number(without_mark(text, radix), radix);
  if (value && *value <= most) return static_cast<std::uint32_t>(*value);
  return base::usage_error(fmt::format("{}: found \"{}\", expected {}, {}, 0 to {}", option, text, what,
                           radix_name(radix), in_radix(most, radix)));
}

Result<std::uint64_t> count_argument(std::string_view option, std::string_view text) {
  if (const auto value = base::count_number(text)) return *value;
  return base::usage_error(fmt::format("{}: found \"{}\", expected a whole decimal number such as 1000000 or 1e6", option, text));
}

Result<FileArgument> file_argument(const MachineDescription& machine, std::string_view option,
                                   const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos) return FileArgument{text, std::nullopt};
  // In octal, a digit 8 or 9 is an error and not part of the name.
  const std::string_view allowed = machine.radix == 16 ? "0123456789abcdefABCDEF" : "0123456789";
  const std::string_view tail = without_mark(std::string_view(text).substr(at + 1), machine.radix);
  if (tail.empty() || tail.find_first_not_of(allowed) != std::string_view::npos)
    return FileArgument{text, std::nullopt};
  const std::uint32_t most = (1U << machine.address_bits) - 1;
  const auto address = number_argument(option, tail, machine.radix, most, "an address after @");
  if (!address) {
    if (machine.radix != 16) return address.error();
    return base::usage_error(fmt::format("{}: found {}, expected an address after @, 0 to {:X}", option, tail, most));
  }
  return FileArgument{text.substr(0, at), *address};
}

std::vector<std::string_view> format_names(const MachineDescription& machine) {
  std::vector<std::string_view> names;
  for (const Format& format : machine.formats) names.push_back(format.name);
  return names;
}

bool has_endings(const MachineDescription& machine) {
  return std::any_of(machine.formats.begin(), machine.formats.end(),
                     [](const Format& format) { return !format.ending.empty(); });
}

const Format* format_by_name(const MachineDescription& machine, std::string_view path) {
  for (const Format& format : machine.formats) {
    if (!format.ending.empty() &&
        (path.ends_with(format.ending) || path.ends_with(upper_case(format.ending))))
      return &format;
  }
  return nullptr;
}

Result<Program> read_program(const MachineDescription& machine, const FileArgument& file, const Input& input,
                             std::string_view format, const Arguments* arguments) {
  return read_as(machine, find_format(machine, file, input, format, arguments), file, input);
}

Result<Prepared> prepare(const MachineDescription& description, const Arguments& arguments,
                         const FileReader& read, const Restorer& restore) {
  if (const auto done = check_needs(description, arguments); !done) return done.error();
  auto machine = description.make(arguments, read);
  if (!machine) return machine.error();
  const auto limits = limits_of(description, arguments);
  if (!limits) return limits.error();
  if (arguments.given("--restore")) {
    if (const auto done = restore(**machine, read(arguments.text("--restore"))); !done) return done.error();
    for (const std::string& setting : arguments.list("--set")) {
      if (const auto done = set_register(description, **machine, setting); !done) return done.error();
    }
    (*machine)->set_beginning((*machine)->get(program_counter(description)));
    const Limits later = from_here(*limits, **machine);
    return Prepared{std::move(*machine), later};
  }
  const auto loaded = load(description, arguments, read, **machine);
  if (!loaded) return loaded.error();
  if (const auto done = (*machine)->ready(); !done) return done.error();
  if (const auto done = start(description, arguments, *loaded, **machine); !done) return done.error();
  (*machine)->set_beginning((*machine)->get(program_counter(description)));
  if (!arguments.given(description.instead_of_program))
    (*machine)->watch_empty_memory(description, loaded->addresses, remedy_for_empty_memory(arguments, *loaded, **machine));
  return Prepared{std::move(*machine), *limits, loaded->warnings};
}

std::vector<std::string> Machine::take_early_warnings(bool runs_on) {
  std::vector<std::string> texts;
  for (const EarlyWarning& each : early_warnings()) {
    if (!warned_.insert(each.what).second) continue;
    texts.push_back(each.times.empty() ? each.what : fmt::format("{} ({} so far)", each.what, each.times));
  }
  // A nonzero word there was stored by the program, which may execute it.
  if (!runs_on || loaded_.empty() || halted()) return texts;
  const std::uint32_t pc = get(program_counter(*description_));
  if (pc >= loaded_.size() || loaded_[pc] || word(pc) != 0) return texts;
  loaded_.clear();
  texts.push_back(fmt::format("PC {}: executes memory that is empty: nothing was loaded there{}", address_text(*description_, pc),
                              remedy_.empty() ? "" : "; " + remedy_));
  return texts;
}

void Machine::watch_empty_memory(const MachineDescription& description, std::vector<bool> loaded, std::string remedy) {
  description_ = &description;
  loaded_ = std::move(loaded);
  remedy_ = std::move(remedy);
}

std::vector<std::string> Machine::early_warnings_left() const {
  std::vector<std::string> texts;
  for (const EarlyWarning& each : early_warnings()) {
    if (warned_.find(each.what) != warned_.end()) continue;
    texts.push_back(each.times.empty() ? each.what : fmt::format("{} ({})", each.what, each.times));
  }
  return texts;
}

Stop run_to_stop(Machine& machine, const Limits& limits, const KeepRunning& keep_running) {
  std::optional<Stop> stop;
  while (!stop) {
    stop = machine.run(limits, static_cast<bool>(keep_running));
    if (!stop && keep_running && !keep_running({machine.instructions(), machine.now()}))
      stop = Stop{interrupted, {}};
  }
  machine.finish();
  return *stop;
}

std::vector<SourceLine> source_lines(std::span<const assembler::ListingLine> listing, int radix) {
  std::vector<SourceLine> lines;
  for (const assembler::ListingLine& line : listing) {
    const auto address = base::unsigned_number(line.address, radix);
    // Labels and directives of the 8080 have an address and no code.
    if (address && !line.code.empty() && line.line_number != 0)
      lines.push_back({static_cast<std::uint32_t>(*address), line.file, line.line_number});
  }
  return lines;
}

std::string digits(const MachineDescription& machine, std::uint32_t value, unsigned bits) {
  const unsigned bits_per_digit = machine.radix == 16 ? 4 : 3;
  return in_radix(value, machine.radix, (bits + bits_per_digit - 1) / bits_per_digit);
}

std::string dump_text(const MachineDescription& description, const Machine& machine) {
  std::string registers;
  for (std::size_t n = 0; n < description.registers.size(); ++n) {
    const Register& each = description.registers[n];
    if (each.in_dump)
      registers += (registers.empty() ? "" : " ") + digits(description, machine.get(n), each.bits);
  }
  std::string text = registers + '\n';
  for (std::uint32_t a = 0; a < machine.words(); ++a) {
    const bool last_in_line = (a + 1) % description.words_per_line == 0 || a + 1 == machine.words();
    text += digits(description, machine.word(a), description.word_bits);
    text += last_in_line ? '\n' : ' ';
  }
  return text;
}

bool is_dump(const MachineDescription& description, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t longest_line = 400;
  std::string_view text = text_of(bytes.first(std::min(bytes.size(), 2 * longest_line)));
  const auto registers = dump_words(base::take_line(text));
  const auto numbers = dumped_registers(description);
  if (registers.size() != numbers.size()) return false;
  for (std::size_t n = 0; n < numbers.size(); ++n)
    if (!dump_number(description, registers[n], description.registers[numbers[n]].bits)) return false;
  const auto words = dump_words(base::take_line(text));
  return words.size() == description.words_per_line &&
         std::all_of(words.begin(), words.end(), [&](std::string_view word) {
           return dump_number(description, word, description.word_bits).has_value();
         });
}

Result<Program> read_dump(const MachineDescription& description, const Input& input) {
  std::string_view text = text_of(input.bytes);
  std::size_t line = 1;
  const auto refused = [&](std::string_view found, std::string_view expected) {
    return base::Error{.file = input.name,
                       .place = fmt::format("line {}", line),
                       .found = fmt::format("found {}", found),
                       .expected = std::string(expected),
                       .remedy = "make the dump again with --dump"};
  };
  const auto expected = [&](std::string_view what, unsigned bits) {
    return fmt::format("{}, {} with {} digits", what, radix_name(description.radix), digits(description, 0, bits).size());
  };
  Program program;
  const auto numbers = dumped_registers(description);
  const auto registers = dump_words(base::take_line(text));
  if (registers.size() != numbers.size())
    return refused(fmt::format("{} numbers", registers.size()), fmt::format("{} registers", numbers.size()));
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const Register& each = description.registers[numbers[n]];
    const auto value = dump_number(description, registers[n], each.bits);
    if (!value) return refused(fmt::format("\"{}\"", registers[n]), expected(each.name, each.bits));
    program.registers.emplace_back(numbers[n], *value);
  }
  const std::uint32_t most = 1U << description.address_bits;
  while (!text.empty()) {
    ++line;
    for (const std::string_view word : dump_words(base::take_line(text))) {
      const auto value = dump_number(description, word, description.word_bits);
      if (!value) return refused(fmt::format("\"{}\"", word), expected("a word", description.word_bits));
      const auto address = static_cast<std::uint32_t>(program.words.size());
      if (address == most) return refused("more words", fmt::format("{} words at most", most));
      program.words.emplace_back(address, *value);
    }
  }
  return program;
}

std::string table_report(const MachineDescription& description, const Machine& machine, const Stop& stop) {
  std::string reason(stop.name);
  std::replace(reason.begin(), reason.end(), '_', ' ');
  const std::size_t pc = program_counter(description);
  std::string text =
      fmt::format("{:<15} {}, PC {}\n", "stopped by", reason, address_text(description, machine.get(pc)));
  for (const ReportLine& line : machine.lines()) text += fmt::format("{:<15} {}\n", line.label, line.text);
  std::string registers;
  for (std::size_t n = 0; n < description.registers.size(); ++n) {
    const Register& each = description.registers[n];
    if (n == pc) continue;
    registers += fmt::format("{}{} {}", registers.empty() ? "" : "  ", each.name,
                             digits(description, machine.get(n), each.bits));
  }
  return text + fmt::format("{:<15} {}\n", "registers", registers);
}

base::Json json_report(const MachineDescription& description, const Machine& machine, const Stop& stop) {
  base::Json report{{"schema", fmt::format("sightline/run-{}/1", description.name)},
                    {"stop_reason", stop.name},
                    {"pc", address_text(description, machine.get(program_counter(description)))},
                    {"instructions", machine.instructions()}};
  machine.add_times(report);
  base::Json& registers = report["registers"] = base::Json::object();
  for (std::size_t n = 0; n < description.registers.size(); ++n) {
    const Register& each = description.registers[n];
    base::Json& value = registers[base::lower_case(each.name)];
    if (each.bits == 1) {
      value = machine.get(n);
    } else {
      value = digits(description, machine.get(n), each.bits);
    }
  }
  machine.add_details(report);
  return report;
}

}  // namespace sightline::machines
