// Connects the console of an emulated machine (the PDP-7's teletype or the terminal of CP/M) with a person, a pipe or a script,
// at the speed of the machine or as fast as the host can.
//
// The keys of a pipe or a script depend on emulated time only: the next key is typed when the program asks for one and the
// printer is idle. Such a session is the same each time. The exception is a pipe that is silent for longer than a second
// while the program computes and polls: it is not waited for.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/machines/engine.hpp"
#include "host/live/keys.hpp"

namespace sightline::live {

// --- A script ---

// A step of a session: wait until the program has printed a text (expect), or type a text as the program asks for keys (send).
// An empty text has been printed, and is typed, at once. If the last step is an `expect`, the run ends when its text has been
// printed.
struct Step {
  enum class Kind : std::uint8_t { expect, send };
  Kind kind;
  std::string text;
  std::optional<double> within = {};  // of an `expect`: the longest emulated time for it, in seconds
};

// Replaces the escape sequences \r \n \t \e \\ \NNN (octal) and \xHH in the text of an option.
[[nodiscard]] base::Result<std::string> plain_text(std::string_view option, std::string_view text);

// --- A session ---

struct ConsoleOptions {
  KeyCodes codes = KeyCodes::ascii;
  std::optional<double> speed;  // relative to the machine's own; empty: as fast as the host can
  std::vector<Step> script;     // if not empty, standard input is not read
};

// Reads --console, --speed, --expect, --within and --send. Without --speed, a session with a person at a terminal runs at the machine's
// own speed, one with a pipe or a script as fast as possible.
[[nodiscard]] base::Result<ConsoleOptions> console_options(const machines::Arguments& arguments,
                                                                  bool terminal);

// The other end of the console. Its functions are called only between slices of a run.
class Operator {
 public:
  virtual ~Operator() = default;
  // Returns the keys that have been pressed, after waiting up to `milliseconds` for one. Empty: none yet. nullopt: the input has
  // ended.
  virtual std::optional<std::string> keys(int milliseconds) = 0;
  // Prints the program's output. False: nobody reads it.
  virtual bool print(std::string_view text) = 0;
  // Whether a person types: keys are then sent at once, not when the program asks for them.
  [[nodiscard]] virtual bool at_terminal() const { return false; }
};

inline constexpr std::string_view stopped_by_ctrl_e = "operator";
inline constexpr std::string_view stopped_by_signal = "signal";
inline constexpr std::string_view end_of_input = "end_of_input";
// The complaint of such a stop if only the command `send` types keys.
inline constexpr std::string_view no_key = "the program waits for a key, and there is none: `send` types keys";

// Runs the machine until it stops, or until Ctrl-E, a signal (base::EndSignals must exist), the end of the script, or the end
// of the input when the program waits for more: in a blocking read, in an idle loop (idle_loop.hpp), or in HLT.
[[nodiscard]] machines::Stop run_console(machines::Machine& machine, const machines::Limits& limits,
                                            const ConsoleOptions& options, Operator& person);

// The operator at the process's standard input; prints to the descriptor of standard output or error.
[[nodiscard]] std::unique_ptr<Operator> standard_operator(int output_descriptor, bool terminal);

}  // namespace sightline::live
