// Reads keys from the terminal and restores its settings however the process ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sightline::base {

// Whether standard input, or standard error, is a terminal.
[[nodiscard]] bool stdin_is_terminal();
[[nodiscard]] bool stderr_is_terminal();
// Columns of the terminal on standard output; the largest number for a file, a pipe or a terminal that does not report them.
[[nodiscard]] std::size_t stdout_columns();

// While it exists the terminal on standard input is in raw mode: each key arrives at once, without echo or translation,
// Ctrl-C included, and printed lines need a carriage return. The settings are restored by its destructor, by a signal that
// ends the process, and while the process is stopped (SIGTSTP). At most one exists at a time.
class RawTerminal {
 public:
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
};

// While it exists the first SIGINT, SIGTERM, SIGHUP or SIGQUIT is remembered instead of ending the process, so that work
// can be saved. A second one prints a message and ends the process; within a quarter of a second it is ignored, because
// `timeout` sends two. SIGPIPE (nobody reads the output any more) is always remembered. At most one exists at a time.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  [[nodiscard]] static int received();  // the signal's number; 0: none
  static void forget();                 // the next signal counts as the first
};

// Up to 4,096 bytes read from standard input within `milliseconds` (-1: no limit). Empty text: no input yet, or a signal.
// nullopt: the input has ended, or the terminal was closed.
[[nodiscard]] std::optional<std::string> read_stdin_within(int milliseconds);

// Writes the whole text now, without the buffer of stdio. False: nobody reads it any more.
[[nodiscard]] bool write_now(int descriptor, std::string_view text);

}  // namespace sightline::base
