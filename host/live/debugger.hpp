// A machine under control: run to a goal or a breakpoint, looked into by names, taken back in time. What the monitor does by
// lines of text and the debug adapter by messages, both do with this.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/machines/engine.hpp"
#include "host/live/breakpoints.hpp"
#include "host/live/expression.hpp"
#include "host/live/keys.hpp"
#include "host/live/past.hpp"
#include "host/live/symbols.hpp"

namespace sightline::live {

// What a run needs of the world outside.
struct RunHost {
  // Runs to a stop, showing what the program prints and handing it what is typed; `heard` is told what is printed too.
  std::function<machines::Stop(machines::Machine&, const machines::Limits&,
                                  const std::function<void(std::string_view)>& heard)>
      run;
  // Asked now and then by all that takes long; true: stop.
  std::function<bool()> interrupted;
  // What the program has printed, outside `run`.
  std::function<void(std::string_view)> print;
  // Keys come from send() alone: a run without a goal ends when the program has long asked for one and got none.
  bool nobody_types = false;
  // So long, in seconds of the program's time: it has shown by then that it has nothing to do but wait for a key.
  std::int64_t patience = 60;
};

// Where a run is to stop, besides breakpoints and the limits of the machine.
struct Goal {
  std::uint64_t instructions = std::numeric_limits<std::uint64_t>::max();  // from here
  std::int64_t until = std::numeric_limits<std::int64_t>::max();           // in the machine's unit
  std::string condition = {};  // that becomes true; looked at after each instruction
};

// Why a run has stopped.
struct Halted {
  enum class Why : std::uint8_t { goal, breakpoint, machine };
  Why why = Why::goal;
  int breakpoint = 0;             // its number
  std::string reason = {};        // a line for a person; empty for the goals that are numbers
  machines::Stop stop = {};    // of the machine
};

// A subroutine that has been called and not left.
struct Frame {
  std::uint32_t caller = 0;  // address of the call; of an interrupt, of the instruction it came before
  std::uint32_t entry = 0;   // address that was called
  std::uint32_t behind = 0;  // address behind the call
};

class Debugger {
 public:
  // The machine and its description outlive the debugger; the machine was made with --monitor.
  Debugger(const machines::MachineDescription& description, machines::Machine& machine,
           const machines::Limits& limits, Symbols symbols, RunHost host);

  [[nodiscard]] const machines::MachineDescription& description() const { return description_; }
  [[nodiscard]] machines::Machine& machine() { return machine_; }
  [[nodiscard]] const machines::Machine& machine() const { return machine_; }
  [[nodiscard]] const Symbols& symbols() const { return symbols_; }
  void set_symbols(Symbols symbols) {
    symbols_ = std::move(symbols);
    conditions_.clear();
  }
  [[nodiscard]] Breakpoints& breakpoints() { return breakpoints_; }
  [[nodiscard]] const Breakpoints& breakpoints() const { return breakpoints_; }

  // --- Texts ---

  // 8, 10 or 16, for numbers that are read and shown; that of the machine unless it is set.
  void set_radix(int radix);
  [[nodiscard]] int radix() const { return names_.radix; }
  // The language of instructions that are typed, a value of the assembler's option --dialect; empty: its default.
  void set_dialect(std::string dialect) { dialect_ = std::move(dialect); }

  [[nodiscard]] std::string address(std::uint32_t value) const;
  [[nodiscard]] std::string word(std::uint32_t value) const;
  [[nodiscard]] std::string register_text(std::size_t number) const;  // "AC 000003"
  // "begin+5: lac i 00010", with the line of the source if there is one.
  [[nodiscard]] std::string instruction_text(std::uint32_t at) const;
  [[nodiscard]] std::string time_text(std::int64_t ticks) const;
  // Where so many instructions before `at` begin, the last one ending there; fewer at the beginning of memory. Where instructions have
  // several words that is a guess, the best there is.
  [[nodiscard]] std::vector<std::uint32_t> instructions_before(std::uint32_t at, std::size_t count) const;
  // Where the machine is and what it does next: a line.
  [[nodiscard]] std::string status() const;

  // --- Values ---

  [[nodiscard]] std::uint32_t pc() const { return machine_.get(pc_); }
  [[nodiscard]] std::size_t pc_register() const { return pc_; }
  [[nodiscard]] std::optional<std::size_t> register_named(std::string_view name) const;
  // BC, DE, HL and AF of the 8080, by the numbers of their halves.
  struct Pair {
    std::size_t high;
    std::size_t low;
  };
  [[nodiscard]] std::optional<Pair> pair_named(std::string_view name) const;
  [[nodiscard]] std::uint32_t pair_value(const Pair& pair) const;
  [[nodiscard]] std::uint32_t most_of(const Pair& pair) const;
  [[nodiscard]] std::string pair_text(const Pair& pair) const;  // "HL 1234"
  // Whether a name is one of time, instructions and the conditions: values that are in no register or word.
  [[nodiscard]] bool is_state(std::string_view name) const;
  // All names that expressions know.
  [[nodiscard]] std::vector<std::string> names() const;
  // Names are registers (of the 8080 pairs too), time, instructions, conditions, symbols.
  [[nodiscard]] base::Result<std::int64_t> evaluate(std::string_view expression) const;
  [[nodiscard]] base::Result<std::uint32_t> address_of(std::string_view expression) const;

  // --- Changes, which going back remembers ---

  void put(std::uint32_t at, std::uint32_t word);
  void set(std::size_t register_number, std::uint32_t value);
  void set(const Pair& pair, std::uint32_t value);
  void start(std::uint32_t at);
  // Assembles one instruction, which may use the symbols, to that address, in the dialect that is set.
  [[nodiscard]] base::Result<base::Done> put_instruction(std::uint32_t at, std::string_view text);
  // What else is done to the machine from outside.
  void changed() { past_.changed(); }
  // After a change of media: what was before cannot be gone back to.
  void forget_past() { past_.forget(); }
  // What the keys send; of itself that of the KSR 33 on the PDP-7, 7 bits on the 8080.
  void set_key_codes(KeyCodes codes) { key_codes_ = codes; }
  // Keys for the console, to be typed as the program asks for them in the runs that follow.
  void send(std::string_view keys) { keys_ += keys; }
  [[nodiscard]] bool keys_wait() const { return !keys_.empty(); }

  // --- Running ---

  [[nodiscard]] Halted run(const Goal& goal);
  // So many of the machine's ticks on, into the middle of an instruction if they end there. The machine is then where that instruction
  // begins, which any other run goes on from, and the cycles of the instruction tell where it is; the next such run counts on from there.
  struct Cycled {
    Halted halted;
    std::int64_t at = 0;                    // in the machine's unit: where it is
    std::vector<Past::Cycle> cycles = {};  // of that instruction; none: at a boundary
  };
  [[nodiscard]] base::Result<Cycled> run_cycles(std::int64_t ticks);
  // Over one instruction; a subroutine that it calls runs to its return.
  [[nodiscard]] Halted step_over();
  // To the return from the subroutine that was called last.
  [[nodiscard]] base::Result<Halted> step_out();
  // The last stop of the machine by itself, for a report.
  [[nodiscard]] const machines::Stop& last_stop() const { return last_stop_; }
  // What has been printed since the last call of forget_printed().
  [[nodiscard]] const std::string& printed() const { return printed_; }
  void forget_printed(std::size_t length) { printed_.erase(0, length); }
  // Hands out what the program has printed.
  void show_printed();

  // --- The past ---

  [[nodiscard]] base::Result<base::Done> back(std::uint64_t instructions);
  // To the last place before here where a breakpoint, whatever its condition and count, would have stopped a run; false: to the
  // beginning of the past; nullopt: it was interrupted, and the machine is where it was.
  [[nodiscard]] base::Result<std::optional<bool>> back_to_breakpoint();
  [[nodiscard]] std::vector<Past::Entry> history(std::size_t n);
  [[nodiscard]] std::optional<Past::Writer> last_writer(std::uint32_t at);
  // The latest first, as far as the last some ten thousand instructions show them.
  [[nodiscard]] std::vector<Frame> stack();

  [[nodiscard]] machines::Bytes save();
  // `file`: its name, for errors.
  [[nodiscard]] base::Result<base::Done> restore(std::span<const std::uint8_t> snapshot, const std::string& file);

 private:
  struct Reason {
    int breakpoint;
    std::string text;
  };
  [[nodiscard]] std::string number_text(std::uint32_t value, unsigned bits) const;
  [[nodiscard]] std::optional<std::int64_t> value_of(std::string_view name) const;
  [[nodiscard]] std::function<std::int64_t()> reader_of(std::string_view name) const;
  // Null: it cannot be read.
  [[nodiscard]] const Expression* condition_of(const std::string& text);
  // Lets the run ask at each boundary whether a condition has become true, or false again.
  void watch_conditions(const std::string& goal);
  // What only the time decides can change while the processor stands still in a halt or a HOLD, where there is no boundary: the
  // run ends at the times where it changes.
  void end_at_times(const std::string& goal, machines::Limits& limits);
  [[nodiscard]] Reason reason_of(const Breakpoints::Hit& hit) const;
  [[nodiscard]] Halted run_to_return(const Frame& frame);
  [[nodiscard]] std::uint32_t behind(std::uint32_t at, std::uint32_t words) const;
  void type_next();

  const machines::MachineDescription& description_;
  machines::Machine& machine_;
  machines::Limits limits_;
  Symbols symbols_;
  RunHost host_;
  std::size_t pc_ = 0;
  Breakpoints breakpoints_;
  Past past_;
  machines::Stop last_stop_{"operator", {}};
  std::string dialect_;
  std::string printed_;
  std::string keys_;
  KeyCodes key_codes_;
  // Where run_cycles() has come to, if nothing has happened since.
  struct Inside {
    std::int64_t boundary;
    std::int64_t at;
  };
  std::optional<Inside> inside_;
  Names names_;
  std::map<std::string, std::optional<Expression>, std::less<>> conditions_;  // by their texts
  Breakpoints::Condition holds_;
};

}  // namespace sightline::live
