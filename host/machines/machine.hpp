// A machine as data: what `sightline run`, `asm` and `disasm` need to know of it. A new machine is its
// processor (emulators/), an assembler and a disassembler (tools/), a Machine and a MachineDescription
// (here), and one row in machines(). CONTRIBUTING.md walks through it.
//
// The engine (engine.hpp) does what is the same for all: options, loading, registers, running, dump and
// report. Speed depends on the machine alone: the engine calls it once a slice of many instructions.
#pragma once

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
#include "tools/asm/diagnostic.hpp"
#include "tools/asm/listing.hpp"
#include "tools/asm/source.hpp"

namespace sightline::machines {

using base::Bytes;

using base::Result;
using base::Done;

// --- Options ---

enum class OptionKind : std::uint8_t {
  text,
  flag,
  list,       // may be given several times
  step,       // the same; Arguments::steps has all of this kind in the order of the command line
  files,      // the same, and several after one name
  stream,     // a file that is written while the machine runs
  output,     // a file that is written after the run
  position,   // an argument without a name, required
  positions,  // one or more of them
};

struct Option {
  OptionKind kind = OptionKind::text;
  std::string name = {};  // "--memory", "-o,--output"; its values are found under the last of the names
  std::string_view argument = {};  // its name in the help: "FILE"
  std::string help = {};
  std::vector<std::string_view> choices = {};  // empty: any text
  bool any_case = false;                       // of the choices
  std::string_view initial = {};               // the value if none is given
  std::string_view shown_initial = {};         // what the help says instead
  std::string needs = {};          // "--board", "--plotter calcomp": an option that must be given too
  std::string_view excludes = {};  // an earlier option that may not be given too
  // Of a stream that was not named: with this option it goes to standard output, but not with --json.
  std::string_view stdout_with = {};
  std::string_view content = {};  // of that stream, in messages: "what the program prints"

  [[nodiscard]] std::string_view key() const { return std::string_view(name).substr(name.rfind(',') + 1); }
};

// The values of options, under their names.
class Arguments {
 public:
  struct Value {
    std::string text;  // empty: not given
    std::vector<std::string> list;
    bool flag = false;
  };

  // Every option has its initial value.
  explicit Arguments(std::span<const Option> options);

  // Of options of the kind `step`: its name and its value.
  struct Step {
    std::string option;
    std::string text;
  };
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  void add_step(std::string_view option, const std::string& text);

  // Of an option that there is; references stay valid.
  [[nodiscard]] Value& value(std::string_view key);
  [[nodiscard]] const std::string& text(std::string_view key) const { return find(key).text; }
  [[nodiscard]] const std::vector<std::string>& list(std::string_view key) const { return find(key).list; }
  [[nodiscard]] bool given(std::string_view key) const;

 private:
  // Nothing for an option that there is not: a machine need not have all of the engine's.
  [[nodiscard]] const Value& find(std::string_view key) const;

  std::map<std::string, Value, std::less<>> values_;
  std::vector<Step> steps_;
};

// A whole number in the radix, up to `most`; else "OPTION: found TEXT, expected WHAT, octal, 0 to MOST". In
// hexadecimal 0x before and H behind are allowed.
[[nodiscard]] Result<std::uint32_t> number_argument(std::string_view option, std::string_view text, int radix,
                                                    std::uint32_t most, std::string_view what);
[[nodiscard]] Result<std::uint64_t> count_argument(std::string_view option, std::string_view text);

// --- Programs ---

// What a file leaves in memory: words at addresses, in ascending order.
struct Program {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> words;
  std::optional<std::uint32_t> start;
  // Of a dump: numbers of registers, as in the description, and their values; PC among them.
  std::vector<std::pair<std::size_t, std::uint32_t>> registers = {};
  std::vector<std::string> warnings = {};  // of reading it
};

// A form of a program in a file.
struct Format {
  std::string_view name;    // "hex", for --format
  std::string_view ending;  // ".hex" decides before the content does; empty: only the content
  bool (*recognise)(std::span<const std::uint8_t> bytes);
  // `address`: the value after @.
  Result<Program> (*read)(std::span<const std::uint8_t> bytes, const std::string& file,
                          std::optional<std::uint32_t> address);
  Result<Bytes> (*write)(const Program& program, const std::string& file);
  bool tells_address = false;  // after writing one, the user is told where to load it
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

// The text of a file; empty if it cannot be read.
using TextReader = std::function<std::optional<std::string>(const std::string& path)>;

struct Assembler {
  std::string_view help;          // of its subcommand
  std::string_view define_value;  // in the help of -D: "in octal"
  std::string_view listing_help;
  std::vector<Option> options;  // beside SOURCE, -D, -o, --format, --listing and --symbols
  std::string_view format;      // of an output whose name does not tell
  Result<Assembled> (*assemble)(std::span<const assembler::SourceFile> sources, const Arguments& arguments,
                                const TextReader& include) = nullptr;
};

// The lines of a listing that make words, whose addresses are in the radix.
[[nodiscard]] std::vector<SourceLine> source_lines(std::span<const assembler::ListingLine> listing, int radix);

// Each -D NAME=VALUE, by the assembler's reader of one.
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
  // Languages of the assembler's option --dialect in which it writes, too. `own` is that of `disassemble`. The error of one
  // that cannot say the program names the file.
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
  bool in_core = false;   // holds an address: not larger than the memory is
  bool in_dump = true;
};

struct Limits {
  std::uint64_t instructions = std::numeric_limits<std::uint64_t>::max();
  std::int64_t until = std::numeric_limits<std::int64_t>::max();  // in the machine's unit of time
};

// Why a run has ended.
struct Stop {
  std::string_view name;  // "instruction_limit", for reports
  std::string complaint;  // not empty: the program has failed
  bool at_until = false;  // by Limits::until: it could run on
};

// An event of the machine's probe.
inline constexpr std::string_view stopped_by_probe = "event";

// A file read for a run.
struct Input {
  std::string name;  // for messages
  Bytes bytes;
};
// Reads a file, or standard input for "-". It may throw; what it throws is not caught here.
using FileReader = std::function<Input(const std::string& path)>;

// Takes text as the machine writes it, in blocks of whole lines or at once.
using TextTaker = std::function<void(std::string_view)>;

// Text on its way to a taker.
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

// A warning that is right while the machine runs, and need not wait for the end: a device is not there.
struct EarlyWarning {
  std::string what;   // which it is
  std::string times;  // how often so far; may be empty
};

// --console, --speed, --expect and --send, the same for every machine.
[[nodiscard]] std::vector<Option> console_options(std::string_view device);

struct MachineDescription;

// A machine put together for one run. Nothing here is called while an instruction is obeyed.
class Machine {
 public:
  virtual ~Machine() = default;

  // Memory, without time.
  [[nodiscard]] virtual std::uint32_t words() const = 0;
  [[nodiscard]] virtual std::uint32_t word(std::uint32_t address) const = 0;
  virtual void put(std::uint32_t address, std::uint32_t word) = 0;

  // Registers, numbered as in the description.
  [[nodiscard]] virtual std::uint32_t get(std::size_t number) const = 0;
  virtual void set(std::size_t number, std::uint32_t value) = 0;

  // Where a run begins; `loaded`: the start address of what was loaded.
  [[nodiscard]] virtual std::uint32_t start_address(std::optional<std::uint32_t> loaded) const {
    return loaded.value_or(0);
  }
  virtual void start(std::uint32_t address) = 0;
  // All is loaded: a last look at memory.
  [[nodiscard]] virtual Result<Done> ready() { return Done{}; }

  // The text of a stream option goes to `taker`, which outlives the run.
  virtual void take(std::string_view option, TextTaker taker) = 0;

  // Runs on until it stops. If `asked`, nothing comes back after some ten milliseconds of the host's time:
  // the engine asks whether to go on. Such a slice changes nothing in the machine.
  [[nodiscard]] virtual std::optional<Stop> run(const Limits& limits, bool asked) = 0;
  // After the last slice: hands out what is left of the streams.
  virtual void finish() {}

  // The console, with --console: the PDP-7's teletype, the terminal of CP/M. Codes have eight bits.
  virtual void type(std::uint8_t) {}
  // All keys typed have been read, and the program has asked for another.
  [[nodiscard]] virtual bool wants_key() const { return false; }
  // It cannot run on without one: run() comes back at once, and emulated time does not pass.
  [[nodiscard]] virtual bool waits_for_key() const { return false; }
  // What has been printed since the last call.
  [[nodiscard]] virtual std::string take_printed() { return {}; }

  // Of a machine made with --monitor; else null.
  [[nodiscard]] virtual Probe* probe() { return nullptr; }
  // For a monitor: the instruction at an address, and how many words it has.
  struct Instruction {
    std::string text;
    unsigned words = 1;
  };
  [[nodiscard]] virtual Instruction instruction_at(std::uint32_t) const { return {}; }
  // Whether an instruction may call a subroutine or leave one; `word` as in Probe::Entry.
  enum class Flow : std::uint8_t { plain, call, leave };
  [[nodiscard]] virtual Flow flow_of(std::uint32_t) const { return Flow::plain; }
  // A line of the history: the fields of the trace.
  [[nodiscard]] virtual std::string history_line(const Probe::Entry&) const { return {}; }
  // Puts something into a device (a tape into the reader), or takes it out; a complaint if there is no such device.
  [[nodiscard]] virtual Result<Done> attach(std::string_view device, const Input&) {
    return base::usage_error("found device \"" + std::string(device) + "\", expected none: nothing can be attached to this machine");
  }
  // For a screen that is looked at while the machine runs: from now on every stroke of the display or the plotter is kept until
  // it is taken, and for no output. The display of a machine made with --monitor, or with an output of its strokes.
  virtual void keep_strokes(bool) {}
  // Those since the last call, in the order in which they were drawn; valid until the machine runs on.
  virtual std::span<const core::Stroke> take_strokes() { return {}; }
  // What the raster board shows; null without one.
  [[nodiscard]] virtual const core::Raster* raster() const { return nullptr; }
  // What a run has had from the host's files is kept, so that it can be repeated from a snapshot without touching them.
  // Forgets the oldest but so many; the time, in the machine's unit, from which runs can be repeated.
  [[nodiscard]] virtual std::int64_t trim_journal(std::size_t) { return 0; }
  // Media whose content the program has changed, with the files they came from.
  struct Medium {
    std::string path;
    Bytes content;
  };
  [[nodiscard]] virtual std::vector<Medium> changed_media() const { return {}; }
  // Flags of devices that a monitor can stop at: the names are in lower case.
  [[nodiscard]] virtual std::vector<std::pair<std::string_view, bool>> conditions() { return {}; }
  // One of them, by its place in the list.
  [[nodiscard]] virtual bool condition(std::size_t number) { return conditions().at(number).second; }
  // What the devices do, one to a line; the display's registers, empty without one.
  [[nodiscard]] virtual std::vector<ReportLine> device_lines() const { return {}; }
  [[nodiscard]] virtual std::vector<ReportLine> display_lines() const { return {}; }

  [[nodiscard]] virtual std::uint64_t instructions() const = 0;
  [[nodiscard]] virtual core::Instant now() const = 0;
  // The same in the machine's unit, that of Limits::until, and how many of them are a second.
  [[nodiscard]] virtual std::int64_t ticks() const = 0;
  [[nodiscard]] virtual std::int64_t ticks_a_second() const = 0;

  // Snapshots (host/live/snapshot.hpp), between two calls of run. The configuration is what the machine was put
  // together from, in the words of the command line: a state belongs to machines with the same.
  [[nodiscard]] virtual std::vector<std::string> configuration() const { return {}; }
  [[nodiscard]] virtual MachineState save() { return {}; }
  // An error leaves the machine as it was. What it has produced since then is dropped from its outputs; what a stream
  // has written stays.
  [[nodiscard]] virtual base::Result<Done> restore(const MachineState& state);
  // The configuration it has in that state: a device that is plugged in when it is used is then there or not.
  [[nodiscard]] virtual std::vector<std::string> configuration_in(const MachineState&) const { return configuration(); }

  // The report: rows of its table, and members of its JSON document before and after the registers.
  [[nodiscard]] virtual std::vector<ReportLine> lines() const = 0;
  virtual void add_times(base::Json& report) const = 0;
  virtual void add_details(base::Json&) const {}
  // After the run; without those that take_early_warnings() has handed out.
  [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
  // Between slices of a run: those that have come up since the last call. A program that does not run on is not about to execute what is
  // at PC.
  [[nodiscard]] std::vector<std::string> take_early_warnings(bool runs_on = true);
  // From now on these tell, once, that the program has run into memory to which nothing was loaded. `loaded`: whether an
  // address has a word of a program; `remedy`: what may help, may be empty; the description outlives the machine.
  void watch_empty_memory(const MachineDescription& description, std::vector<bool> loaded, std::string remedy);
  // The processor waits for an interrupt: the instruction at PC is not the next thing it does.
  [[nodiscard]] virtual bool halted() const { return false; }
  // What a program needs that is loaded from `lowest` on and runs into empty memory; may be empty.
  [[nodiscard]] virtual std::string_view system_missing([[maybe_unused]] std::uint32_t lowest) const { return {}; }
  // What an output option asks for; not asked for --dump.
  [[nodiscard]] virtual Bytes output(std::string_view) const { return {}; }

 protected:
  // All of the run.
  [[nodiscard]] virtual std::vector<EarlyWarning> early_warnings() const { return {}; }
  // Those that have not been handed out.
  [[nodiscard]] std::vector<std::string> early_warnings_left() const;

 private:
  std::set<std::string, std::less<>> warned_;
  const MachineDescription* description_ = nullptr;
  std::vector<bool> loaded_;  // empty: not watched, or told
  std::string remedy_;
};

struct MachineDescription {
  std::string_view name;  // "pdp7", of the subcommands
  std::string_view help;  // of `sightline run NAME`
  std::string more_help;  // at the end of what `sightline run NAME --help` explains
  std::int64_t ticks_a_cycle = 1;  // of memory, in the unit of Limits::until
  int radix = 8;          // of addresses, words and registers: 8 or 16
  unsigned address_bits = 0;
  unsigned word_bits = 0;
  std::size_t words_a_line = 8;             // of a dump
  std::string_view memory_name = "memory";  // in messages
  std::string_view an_address = "an address";
  std::string_view memory_option = {};  // sets the size of memory
  // With --set PC and --start: an error. Else START is pressed at --start, and PC set then.
  bool one_start = false;
  // Options of which a snapshot holds what they give, besides --load and --start.
  std::vector<std::string_view> in_snapshot = {};

  std::vector<Register> registers;  // in the order of dump and report
  // Of `sightline run NAME`, in the order of its help. The engine reads --load, --start, --restore, --set,
  // --max-instructions, --dump, --save and --json; all others are the machine's.
  std::vector<Option> options;
  // The last one is asked to read what none recognises: it says what is wrong.
  std::vector<Format> formats;
  // The format to take for one found by content or ending; nullptr: the one that was found.
  std::string_view (*instead_of)(const Arguments& arguments, std::string_view format, bool address) = nullptr;

  // The option that limits time, and what its text means in the machine's unit.
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
