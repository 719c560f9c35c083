// Controls a machine: runs it to a goal or a breakpoint, reads and changes registers and memory, and runs it backwards. The
// monitor and the debug adapter are both built on it.
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
#include "host/live/idle_loop.hpp"
#include "host/live/keys.hpp"
#include "host/live/past.hpp"
#include "host/live/symbols.hpp"

namespace sightline::live {

// The functions of the caller that a run needs.
struct RunHost {
  // Runs to a stop, prints the program's output, and passes on the keys that are typed; also calls `heard` with the output.
  std::function<machines::Stop(machines::Machine&, const machines::Limits&,
                                  const std::function<void(std::string_view)>& heard)>
      run;
  // Polled during long work; true: stop.
  std::function<bool()> interrupted;
  // Receives what the program prints outside of `run`.
  std::function<void(std::string_view)> print;
  // `run` passes on the keys of a person. Otherwise only send() types: a run without a goal ends when the program waits for a
  // key and there is none.
  bool person_types = false;
  // Nobody can interrupt a run: it also ends if the program has only waited for `patience` while a clock or a display ran.
  bool nobody_interrupts = false;
  // In seconds of emulated time; long enough to conclude that the program does nothing but wait.
  std::int64_t patience = IdleLoop::patience;
  // Receives the lines of breakpoints that print, without a line end; empty: `print` receives them.
  std::function<void(std::string_view)> log = {};
};

// Where a run stops, besides breakpoints and the limits of the machine.
struct Goal {
  std::uint64_t instructions = std::numeric_limits<std::uint64_t>::max();  // from here
  std::int64_t until = std::numeric_limits<std::int64_t>::max();           // in the machine's unit
  std::string condition = {};  // stops when it becomes true; checked after each instruction
  bool ends_in_waiting = false;  // stops when the program waits for a key that does not come, as a run without a goal does
};

// Why a run has stopped.
struct Halted {
  enum class Why : std::uint8_t { goal, breakpoint, machine };
  Why why = Why::goal;
  int breakpoint = 0;             // its number
  std::string reason = {};        // a line for a person; empty for goals that are numbers
  machines::Stop stop = {};    // of the machine
};

// A subroutine that has been called and has not returned.
struct Frame {
  std::uint32_t caller = 0;  // address of the call; for an interrupt, of the instruction before which it occurred
  std::uint32_t entry = 0;   // the called address
  std::uint32_t behind = 0;  // address after the call
};

class Debugger {
 public:
  // The machine and its description must outlive the debugger; the machine was made with --monitor.
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

  // 8, 10 or 16, for numbers that are read and shown; the default is that of the machine.
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
  // The addresses of the `count` instructions before `at`, fewer at the beginning of memory. If instructions have several words, this
  // is a guess.
  [[nodiscard]] std::vector<std::uint32_t> instructions_before(std::uint32_t at, std::size_t count) const;
  // One line: the time, and the next instruction.
  [[nodiscard]] std::string status() const;

  // --- Values ---

  [[nodiscard]] std::uint32_t pc() const { return machine_.get(pc_); }
  [[nodiscard]] std::size_t pc_register() const { return pc_; }
  [[nodiscard]] std::optional<std::size_t> register_named(std::string_view name) const;
  // BC, DE, HL or AF of the 8080, by the register numbers of its halves.
  struct Pair {
    std::size_t high;
    std::size_t low;
  };
  [[nodiscard]] std::optional<Pair> pair_named(std::string_view name) const;
  [[nodiscard]] std::uint32_t pair_value(const Pair& pair) const;
  [[nodiscard]] std::uint32_t most_of(const Pair& pair) const;
  [[nodiscard]] std::string pair_text(const Pair& pair) const;  // "HL 1234"
  // Whether a name is time, instructions or a condition: values that are in no register or word.
  [[nodiscard]] bool is_state(std::string_view name) const;
  // All names that expressions may contain.
  [[nodiscard]] std::vector<std::string> names() const;
  // Names are registers (on the 8080 also pairs), time, instructions, conditions and symbols.
  [[nodiscard]] base::Result<std::int64_t> evaluate(std::string_view expression) const;
  [[nodiscard]] base::Result<std::uint32_t> address_of(std::string_view expression) const;
  // A value in all forms: in the radix, in decimal, as a word with a sign, as an address near a symbol. "108 = 264. = LOOP"
  [[nodiscard]] std::string value_text(std::int64_t value) const;
  // A text with the values of the expressions that it has in braces: "ac is {ac}"; {{ and }} are braces. An error: an expression or a
  // brace is wrong.
  [[nodiscard]] base::Result<std::string> log_text(std::string_view text) const;

  // --- Changes; going back restores them ---

  void put(std::uint32_t at, std::uint32_t word);
  void set(std::size_t register_number, std::uint32_t value);
  void set(const Pair& pair, std::uint32_t value);
  void start(std::uint32_t at);
  // Resets the machine without starting it: see machines::Machine.
  void reset();
  // Assembles one instruction, which may use the symbols, at an address, in the dialect of set_dialect().
  [[nodiscard]] base::Result<base::Done> put_instruction(std::uint32_t at, std::string_view text);
  // Called after any other change of the machine from outside.
  void changed() { past_.changed(); }
  // Called after a change of media: earlier states can no longer be restored.
  void forget_past() { past_.forget(); }
  // The codes of the keys; by default those of the KSR 33 on the PDP-7 and 7 bits on the 8080.
  void set_key_codes(KeyCodes codes) { key_codes_ = codes; }
  // Keys that the next runs type on the console when the program asks for them.
  void send(std::string_view keys) { keys_ += keys; }
  [[nodiscard]] bool keys_wait() const { return !keys_.empty(); }

  // --- Running ---

  [[nodiscard]] Halted run(const Goal& goal);
  // Runs for so many ticks of the machine, which may end inside an instruction. The machine then stands at the beginning of that
  // instruction, where any other run continues, and `cycles` shows the instruction; the next such run counts on from `at`.
  struct Cycled {
    Halted halted;
    std::int64_t at = 0;                    // the time reached, in the machine's unit
    std::vector<Past::Cycle> cycles = {};  // of that instruction; empty: between two instructions
  };
  [[nodiscard]] base::Result<Cycled> run_cycles(std::int64_t ticks);
  // Executes one instruction; a subroutine that it calls runs to its return.
  [[nodiscard]] Halted step_over();
  // Runs to the return from the subroutine that was called last.
  [[nodiscard]] base::Result<Halted> step_out();
  // The last stop that the machine itself caused, for a report.
  [[nodiscard]] const machines::Stop& last_stop() const { return last_stop_; }
  // The output of the program, without the parts that forget_printed() removed.
  [[nodiscard]] const std::string& printed() const { return printed_; }
  void forget_printed(std::size_t length) { printed_.erase(0, length); }
  // Passes what the program has printed to the host.
  void show_printed();

  // --- The past ---

  [[nodiscard]] base::Result<base::Done> back(std::uint64_t instructions);
  // Goes back to the last instruction at which a breakpoint, conditions and counts ignored, would have stopped a run. False: there is
  // none, and the machine is at the beginning of the past. nullopt: interrupted, and the machine is unchanged.
  [[nodiscard]] base::Result<std::optional<bool>> back_to_breakpoint();
  [[nodiscard]] std::vector<Past::Entry> history(std::size_t n);
  [[nodiscard]] std::optional<Past::Writer> last_writer(std::uint32_t at);
  // The latest call first; found in the last ten thousand or so instructions.
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
  // Null: the condition cannot be parsed.
  [[nodiscard]] const Expression* condition_of(const std::string& text);
  // Makes the run check at each instruction boundary whether a condition has become true, or false again.
  void watch_conditions(const std::string& goal);
  // A condition on the time can change during a halt or a HOLD, where there are no instruction boundaries: ends the run at the times
  // at which such a condition changes.
  void end_at_times(const std::string& goal, machines::Limits& limits);
  [[nodiscard]] Reason reason_of(const Breakpoints::Hit& hit) const;
  [[nodiscard]] Halted run_to_return(const Frame& frame);
  [[nodiscard]] std::uint32_t behind(std::uint32_t at, std::uint32_t words) const;
  void type_next();
  void log(const std::string& text);
  void forget_run();

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
  // The position of run_cycles(), if the machine has not changed since.
  struct Inside {
    std::int64_t boundary;
    std::int64_t at;
  };
  std::optional<Inside> inside_;
  IdleLoop idle_loop_;
  Names names_;
  std::map<std::string, std::optional<Expression>, std::less<>> conditions_;  // by text
  Breakpoints::Condition holds_;
};

}  // namespace sightline::live
