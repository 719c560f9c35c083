// A machine as data: everything that `sightline run`, `asm` and `disasm` need. A new machine consists of its processor
// (emulators/), an assembler and a disassembler (tools/), a Machine and a MachineDescription (here), and one row in
// machines(). CONTRIBUTING.md has the steps.
//
// The engine (engine.hpp) does the work common to all machines: options, loading, registers, running, dump and report. It
// calls the machine once per slice of many instructions, so the speed depends only on the machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/raster.hpp"
#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "host/base/file.hpp"
#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/machines/probe.hpp"
#include "host/machines/state.hpp"
#include "tools/asm/assembly.hpp"

namespace sightline::machines {

using base::Bytes;

using base::Result;
using base::Done;

// --- Options ---

enum class OptionKind : std::uint8_t {
  text,
  flag,
  list,       // may be given several times
  step,       // the same; Arguments::steps() has all of this kind in the order of the command line
  files,      // the same, and several after one name
  stream,     // a file that is written while the machine runs
  output,     // a file that is written after the run
  position,   // an argument without a name, required
  positions,  // one or more of them
};

struct Option {
  OptionKind kind = OptionKind::text;
  std::string name = {};  // "--memory", "-o,--output"; its values are stored under the last of the names
  std::string_view argument = {};  // its name in the help: "FILE"
  std::string help = {};
  std::vector<std::string_view> choices = {};  // empty: any text
  bool any_case = false;                       // of the choices
  std::string_view initial = {};               // the value if none is given
  std::string_view shown_initial = {};         // the text that help shows instead
  std::string needs = {};          // "--board", "--plotter calcomp": an option that must also be given
  std::string_view excludes = {};  // an earlier option that must not be given too
  // A stream that was not named goes to standard output with this option, but not with --json.
  std::string_view stdout_with = {};
  std::string_view content = {};  // description of that stream for messages: "what the program prints"

  [[nodiscard]] std::string_view key() const { return std::string_view(name).substr(name.rfind(',') + 1); }
};

// The values of options by name.
class Arguments {
 public:
  struct Value {
    std::string text;  // empty: not given
    std::vector<std::string> list;
    bool flag = false;
  };

  // Sets every option to its initial value.
  explicit Arguments(std::span<const Option> options);

  // An option of kind `step`: its name and its value.
  struct Step {
    std::string option;
    std::string text;
  };
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  void add_step(std::string_view option, const std::string& text);

  // The option must exist; references stay valid.
  [[nodiscard]] Value& value(std::string_view key);
  [[nodiscard]] const std::string& text(std::string_view key) const { return find(key).text; }
  [[nodiscard]] const std::vector<std::string>& list(std::string_view key) const { return find(key).list; }
  [[nodiscard]] bool given(std::string_view key) const;

 private:
  // An empty value for an option that does not exist: a machine need not have all of the engine's.
  [[nodiscard]] const Value& find(std::string_view key) const;

  std::map<std::string, Value, std::less<>> values_;
  std::vector<Step> steps_;
};

// A whole number in the radix, up to `most`; otherwise the error "OPTION: found TEXT, expected WHAT, octal, 0 to MOST". In
// hexadecimal 0x before or H after it is allowed.
[[nodiscard]] Result<std::uint32_t> number_argument(std::string_view option, std::string_view text, int radix,
                                                    std::uint32_t most, std::string_view what);
[[nodiscard]] Result<std::uint64_t> count_argument(std::string_view option, std::string_view text);

// --- Programs ---

// The content that a file gives memory: words at addresses, in ascending order.
struct Program {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> words;
  std::optional<std::uint32_t> start;
  // Of a dump: numbers of registers, as in the description, and their values; includes PC.
  std::vector<std::pair<std::size_t, std::uint32_t>> registers = {};
  std::vector<std::string> warnings = {};  // of reading it
};

// A file format of programs.
struct Format {
  std::string_view name;    // "hex", for --format
  std::string_view ending;  // ".hex" decides before the content does; empty: only the content
  bool (*recognise)(std::span<const std::uint8_t> bytes);
  // `address`: the value after @.
  Result<Program> (*read)(std::span<const std::uint8_t> bytes, const std::string& file,
                          std::optional<std::uint32_t> address);
  Result<Bytes> (*write)(const Program& program, const std::string& file);
  bool tells_address = false;  // after one is written, the user is told where to load it
  std::string_view meant_for = {};  // an option of a run; without it the run warns, with this reason:
  std::string_view missing = {};
};

struct SourceLine {
  std::uint32_t address;
  std::string file;
  std::size_t line;  // from 1
};

struct Assembled {
  std::vector<assembler::Diagnostic> diagnostics;
  Program program;
  std::size_t symbols = 0;
  std::string listing;
  std::string symbol_table;
  std::vector<SourceLine> lines = {};  // those that make words
};

// Returns the text of a file, or nullopt if it cannot be read.
using TextReader = std::function<std::optional<std::string>(const std::string& path)>;

struct Assembler {
  std::string_view help;          // of its subcommand
  std::string_view define_value;  // in the help of -D: "in octal"
  std::string_view listing_help;
  std::vector<Option> options;  // in addition to SOURCE, -D, -o, --format, --listing and --symbols
  std::string_view format;      // default output format
  Result<Assembled> (*assemble)(std::span<const assembler::SourceFile> sources, const Arguments& arguments,
                                const TextReader& include) = nullptr;
};

// The lines of a listing that make words; addresses are in the radix.
[[nodiscard]] std::vector<SourceLine> source_lines(std::span<const assembler::ListingLine> listing, int radix);

// Parses each -D NAME=VALUE with the assembler's reader.
template <class Define>
[[nodiscard]] Result<std::vector<Define>> read_defines(const Arguments& arguments,
                                                       base::Result<Define> (*parse)(std::string_view)) {
  std::vector<Define> defines;
  for (const std::string& text : arguments.list("-D")) {
    auto define = parse(text);
    if (!define) return base::usage_error("-D " + text + ": " + define.error().message());
    defines.push_back(std::move(*define));
  }
  return defines;
}

struct Disassembler {
  std::string_view name;  // of its subcommand
  std::string_view help;
  std::string_view file_help;
  std::string (*disassemble)(const Program& program);
  // Further languages in which it can write, selected by the assembler's option --dialect. `own` is that of `disassemble`.
  // If a dialect cannot express the program, the error names the file.
  struct Dialects {
    using Write = Result<std::string> (*)(const Program& program, const std::string& file);
    std::string_view own = {};
    std::vector<std::pair<std::string_view, Write>> others = {};
  };
  Dialects dialects = {};
};

// --- A run ---

struct Register {
  std::string_view name;  // "PC" is the program counter
  unsigned bits = 0;
  std::string_view what;  // in messages: "a word"
  bool in_core = false;   // holds an address: must be within memory
  bool in_dump = true;
};

struct Limits {
  std::uint64_t instructions = std::numeric_limits<std::uint64_t>::max();
  std::int64_t until = std::numeric_limits<std::int64_t>::max();  // in the machine's unit of time
};

// The reason why a run has ended.
struct Stop {
  std::string_view name;  // "instruction_limit", for reports
  std::string complaint;  // not empty: the program has failed
  bool at_until = false;  // by Limits::until: it could run on
  unsigned exit_code = 0;  // with a complaint: the exit code that the program has chosen, 0: none
};

// The name of a stop by an event of the machine's probe.
inline constexpr std::string_view stopped_by_probe = "event";

// A file read for a run.
struct Input {
  std::string name;  // for messages
  Bytes bytes;
};
// Reads a file, or standard input for "-". It may throw; its exceptions are not caught here.
using FileReader = std::function<Input(const std::string& path)>;

// Receives text as the machine writes it, in blocks of whole lines or at once.
using TextTaker = std::function<void(std::string_view)>;

// Buffers text for a taker.
class TextBlocks {
 public:
  void take(TextTaker taker) { taker_ = std::move(taker); }
  [[nodiscard]] bool wanted() const { return static_cast<bool>(taker_); }
  // `append` writes whole lines at the end of a std::string.
  template <class Append>
  void write(Append append) {
    append(text_);
    if (text_.size() >= 65536) finish();
  }
  void finish() {
    if (!text_.empty()) taker_(text_);
    text_.clear();
  }

 private:
  TextTaker taker_;
  std::string text_;
};

struct ReportLine {
  std::string label;
  std::string text;
};

// A warning that can be given during the run, such as a missing device.
struct EarlyWarning {
  std::string what;   // the text, by which warnings are distinguished
  std::string times;  // how often so far; can be empty
};

// --console, --speed, --expect and --send, the same for every machine.
[[nodiscard]] std::vector<Option> console_options(std::string_view device);

struct MachineDescription;

// Bytes of Machine::memory_image() in which a clock counts without the program.
struct ClockWord {
  std::size_t first = 0;
  std::size_t size = 0;  // 0: there are none
};

// A machine built for one run. No member is called during an instruction.
class Machine {
 public:
  virtual ~Machine() = default;

  // Memory, accessed without time.
  [[nodiscard]] virtual std::uint32_t words() const = 0;
  [[nodiscard]] virtual std::uint32_t word(std::uint32_t address) const = 0;
  virtual void put(std::uint32_t address, std::uint32_t word) = 0;

  // Registers, numbered as in the description.
  [[nodiscard]] virtual std::uint32_t get(std::size_t number) const = 0;
  virtual void set(std::size_t number, std::uint32_t value) = 0;

  // The address where a run begins; `loaded`: the start address in the loaded files.
  [[nodiscard]] virtual std::uint32_t start_address(std::optional<std::uint32_t> loaded) const {
    return loaded.value_or(0);
  }
  virtual void start(std::uint32_t address) = 0;
  // Where the program began, or was when it was restored.
  [[nodiscard]] std::uint32_t beginning() const { return beginning_; }
  void set_beginning(std::uint32_t address) { beginning_ = address; }
  // What resets the machine, without starting it: the RESET line of the 8080, the START key of the PDP-7 without its address.
  virtual void reset() {}
  // Called when all files are loaded, for a final check of memory.
  [[nodiscard]] virtual Result<Done> ready() { return Done{}; }

  // Sends the text of a stream option to `taker`, which must outlive the run.
  virtual void take(std::string_view option, TextTaker taker) = 0;

  // Runs until it stops. If `asked`, returns nullopt after about ten milliseconds of host time, so that the engine can ask
  // whether to continue; such slices do not change the machine's behaviour.
  [[nodiscard]] virtual std::optional<Stop> run(const Limits& limits, bool asked) = 0;
  // Called after the last slice: flushes the streams.
  virtual void finish() {}

  // The console, with --console: the PDP-7's teletype or the terminal of CP/M. Codes have eight bits.
  virtual void type(std::uint8_t) {}
  // The program has read all typed keys, and has polled for another, waits for it, or takes keys by interrupt.
  [[nodiscard]] virtual bool wants_key() const { return false; }
  // A ^S typed now stops the output of the program until the next key.
  [[nodiscard]] virtual bool pauses_at_key() const { return false; }
  // The program cannot continue without a key, in a blocking read or in HLT: run() returns at once, and emulated time does
  // not pass.
  [[nodiscard]] virtual bool waits_for_key() const { return false; }

  // For live::IdleLoop, which finds out whether a program does nothing but wait.
  // From now on run() also returns, as at the end of a slice, at the boundary after a poll that finds no key.
  virtual void return_at_polls(bool) {}
  // Whether such a poll has come since the last call.
  [[nodiscard]] virtual bool take_poll() { return false; }
  // All registers and memory, to be compared with those of another moment.
  [[nodiscard]] virtual std::array<std::uint64_t, 2> register_image() const { return {}; }
  [[nodiscard]] virtual std::span<const std::byte> memory_image() const { return {}; }
  [[nodiscard]] virtual ClockWord clock_word() const { return {}; }
  // Something outside the processor will change without an access: a device works, or a script goes on.
  [[nodiscard]] virtual bool has_deadline() const { return false; }
  // A number that changes with everything that goes from the program to its devices or comes from them, polls excepted.
  [[nodiscard]] virtual std::uint64_t traffic() const { return 0; }

  // The text printed since the last call.
  [[nodiscard]] virtual std::string take_printed() { return {}; }

  // Non-null for a machine made with --monitor.
  [[nodiscard]] virtual Probe* probe() { return nullptr; }
  // For a monitor: the instruction at an address, and its number of words.
  struct Instruction {
    std::string text;
    unsigned words = 1;
  };
  [[nodiscard]] virtual Instruction instruction_at(std::uint32_t) const { return {}; }
  // Whether an instruction may call or leave a subroutine; `word` as in Probe::Entry.
  enum class Flow : std::uint8_t { plain, call, leave };
  [[nodiscard]] virtual Flow flow_of(std::uint32_t) const { return Flow::plain; }
  // A line of the history, with the fields of the trace.
  [[nodiscard]] virtual std::string history_line(const Probe::Entry&) const { return {}; }
  // Inserts a medium into a device (a tape into the reader) or removes it; an error if there is no such device.
  [[nodiscard]] virtual Result<Done> attach(std::string_view device, const Input&) {
    return base::usage_error("found device \"" + std::string(device) + "\", expected none: nothing can be attached to this machine");
  }
  // For a screen shown during the run: from now on every stroke of the display or the plotter is kept until it is taken,
  // independently of any output. The machine must have been made with --monitor or with an output of strokes.
  virtual void keep_strokes(bool) {}
  // The strokes since the last call, in drawing order; valid until the machine continues.
  virtual std::span<const core::Stroke> take_strokes() { return {}; }
  // The image of the raster board; null without one.
  [[nodiscard]] virtual const core::Raster* raster() const { return nullptr; }
  // Data received from the host's files is recorded, so that a run can be repeated from a snapshot without accessing them.
  // Drops all but the latest such records, as many as the argument; returns the time, in the machine's unit, from which
  // runs can be repeated.
  [[nodiscard]] virtual std::int64_t trim_journal(std::size_t) { return 0; }
  // Media whose content the program has changed, with their files.
  struct Medium {
    std::string path;
    Bytes content;
  };
  [[nodiscard]] virtual std::vector<Medium> changed_media() const { return {}; }
  // Flags of devices at which a monitor can stop; names are in lower case.
  [[nodiscard]] virtual std::vector<std::pair<std::string_view, bool>> conditions() { return {}; }
  // One of them, by its index in the list.
  [[nodiscard]] virtual bool condition(std::size_t number) { return conditions().at(number).second; }
  // The state of the devices, one per line; the display's registers, empty without a display.
  [[nodiscard]] virtual std::vector<ReportLine> device_lines() const { return {}; }
  [[nodiscard]] virtual std::vector<ReportLine> display_lines() const { return {}; }

  [[nodiscard]] virtual std::uint64_t instructions() const = 0;
  [[nodiscard]] virtual core::Instant now() const = 0;
  // The same in the machine's unit, that of Limits::until, and the number of these units per second.
  [[nodiscard]] virtual std::int64_t ticks() const = 0;
  [[nodiscard]] virtual std::int64_t ticks_per_second() const = 0;

  // Snapshots (host/live/snapshot.hpp), taken between two calls of run. The configuration is that with which the machine
  // was built, as command line options; a state can be restored only into a machine with the same configuration.
  [[nodiscard]] virtual std::vector<std::string> configuration() const { return {}; }
  [[nodiscard]] virtual MachineState save() { return {}; }
  // An error leaves the machine unchanged. Outputs produced since then are dropped; text that a stream has written stays.
  [[nodiscard]] virtual base::Result<Done> restore(const MachineState& state);
  // The configuration of the machine in that state: a device plugged in at its first use is present or not.
  [[nodiscard]] virtual std::vector<std::string> configuration_in(const MachineState&) const { return configuration(); }

  // The report: rows of its table, and members of its JSON document before and after the registers.
  [[nodiscard]] virtual std::vector<ReportLine> lines() const = 0;
  virtual void add_times(base::Json& report) const = 0;
  virtual void add_details(base::Json&) const {}
  // The warnings after the run, without those that take_early_warnings() has returned.
  [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
  // The warnings since the last call, between slices of a run. If the program does not run on, it is not about to execute
  // the word at PC.
  [[nodiscard]] std::vector<std::string> take_early_warnings(bool runs_on = true);
  // From now on take_early_warnings() also tells, once, that the program executes memory into which nothing was loaded.
  // `loaded`: whether an address has a word of a program; `remedy`: advice, may be empty; the description must outlive the
  // machine.
  void watch_empty_memory(const MachineDescription& description, std::vector<bool> loaded, std::string remedy);
  // The processor waits for an interrupt: its next action is not the instruction at PC.
  [[nodiscard]] virtual bool halted() const { return false; }
  // The system that a program loaded from `lowest` on may need if it runs into empty memory; may be empty.
  [[nodiscard]] virtual std::string_view system_missing([[maybe_unused]] std::uint32_t lowest) const { return {}; }
  // The content of an output option; not called for --dump.
  [[nodiscard]] virtual Bytes output(std::string_view) const { return {}; }

 protected:
  // All early warnings of the run.
  [[nodiscard]] virtual std::vector<EarlyWarning> early_warnings() const { return {}; }
  // Those that have not been returned.
  [[nodiscard]] std::vector<std::string> early_warnings_left() const;

 private:
  std::uint32_t beginning_ = 0;
  std::set<std::string, std::less<>> warned_;
  const MachineDescription* description_ = nullptr;
  std::vector<bool> loaded_;  // empty: not watched, or already reported
  std::string remedy_;
};

struct MachineDescription {
  std::string_view name;  // "pdp7", also the name of the subcommands
  std::string_view help;  // of `sightline run NAME`
  std::string more_help;  // the end of the text of `sightline run NAME --help`
  std::int64_t ticks_per_cycle = 1;  // memory cycle, in the unit of Limits::until
  int radix = 8;          // of addresses, words and registers: 8 or 16
  unsigned address_bits = 0;
  unsigned word_bits = 0;
  std::size_t words_per_line = 8;           // of a dump
  std::string_view memory_name = "memory";  // in messages
  std::string_view an_address = "an address";
  std::string_view memory_option = {};  // sets the size of memory
  std::string_view instead_of_program = {};  // the option that names programs to run; it excludes PROGRAM
  // Whether --set PC together with --start is an error. If not, START is pressed at --start, and PC is set then.
  bool one_start = false;
  // Options whose values a snapshot holds, in addition to --load and --start.
  std::vector<std::string_view> in_snapshot = {};

  std::vector<Register> registers;  // in the order of dump and report
  // The options of `sightline run NAME`, in the order of its help. The engine reads --load, --start, --restore, --set,
  // --max-instructions, --dump, --save and --json; the machine reads all others.
  std::vector<Option> options;
  // If none recognises a file, the last one reads it and reports what is wrong.
  std::vector<Format> formats;
  // Returns the format to use instead of one found by content or ending; nullptr: always the one that was found.
  std::string_view (*instead_of)(const Arguments& arguments, std::string_view format, bool address) = nullptr;

  // The option that limits time, and the parser of its text into the machine's unit.
  std::string_view time_limit = {};
  Result<std::int64_t> (*parse_time)(std::string_view option, std::string_view text) = nullptr;
  Result<std::unique_ptr<Machine>> (*make)(const Arguments& arguments, const FileReader& read) = nullptr;

  Assembler assembler = {};
  std::vector<Disassembler> disassemblers = {};
};

[[nodiscard]] const MachineDescription& pdp7();
[[nodiscard]] const MachineDescription& i8080();

// All machines, in the order of the help.
[[nodiscard]] std::span<const MachineDescription* const> machines();

}  // namespace sightline::machines
