// The console of an emulated machine, live: the PDP-7's teletype or the terminal of CP/M, typed at and read by a person,
// a pipe or a script, at the speed of the machine or as fast as the host can.
//
// What a pipe or a script types depends on emulated time alone: the next key is pressed when the program asks for it and
// the printer is quiet. Such a session is the same each time.
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

// What happens at the console, in order: the program is waited for until it has printed a text, or a text is typed as it
// asks for keys. The run ends when the last step is a text that has been printed.
struct Step {
  enum class Kind : std::uint8_t { expect, send };
  Kind kind;
  std::string text;
};

// What \r \n \t \e \\ \NNN (octal) and \xHH in an option's text stand for.
[[nodiscard]] base::Result<std::string> plain_text(std::string_view option, std::string_view text);

// --- A session ---

struct ConsoleOptions {
  KeyCodes codes = KeyCodes::ascii;
  std::optional<double> speed;  // times the machine's own; empty: as fast as the host can
  std::vector<Step> script;     // not empty: standard input is not read
};

// The values of --console, --speed, --expect and --send. Without --speed a person at a terminal has the machine's own
// speed, a pipe or a script the fastest.
[[nodiscard]] base::Result<ConsoleOptions> console_options(const machines::Arguments& arguments,
                                                                  bool terminal);

// The other end of the console. Functions may be called between slices of a run only.
class Operator {
 public:
  virtual ~Operator() = default;
  // Keys that have been pressed, waiting so many milliseconds for one. Empty: none yet.
  // nullopt: there will be no more.
  virtual std::optional<std::string> keys(int milliseconds) = 0;
  // The program has printed this. False: nobody reads it.
  virtual bool print(std::string_view text) = 0;
  // Somebody may press a key at any time: keys are sent as they come, not when the program asks.
  [[nodiscard]] virtual bool at_terminal() const { return false; }
};

inline constexpr std::string_view stopped_by_ctrl_e = "operator";
inline constexpr std::string_view stopped_by_signal = "signal";
inline constexpr std::string_view end_of_input = "end_of_input";
// With it, where keys come from `send` alone.
inline constexpr std::string_view no_key = "the program waits for a key, and there is none: `send` types keys";

// Runs the machine to a stop: its own, Ctrl-E, a signal (base::EndSignals must be alive), the end of the input when the
// program waits for more, or the end of the script.
[[nodiscard]] machines::Stop run_console(machines::Machine& machine, const machines::Limits& limits,
                                            const ConsoleOptions& options, Operator& person);

// The process's own standard input, and the descriptor of standard output or error.
[[nodiscard]] std::unique_ptr<Operator> standard_operator(int output_descriptor, bool terminal);

}  // namespace sightline::live
