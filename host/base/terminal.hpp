// The terminal a person sits at: keys one by one, and its settings restored on every way out.
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
// Characters in a line of the terminal that standard output is; no limit if it is a file, a pipe, or a terminal that does not say.
[[nodiscard]] std::size_t stdout_columns();

// While it lives each key of the terminal on standard input arrives at once, unechoed and untranslated, Ctrl-C included,
// and lines that are printed need their own carriage return. The settings are restored by its end, by a signal that
// ends the process, and around a stop (Ctrl-Z from outside). One at a time.
class RawTerminal {
 public:
  RawTerminal();
  ~RawTerminal();
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
};

// While it lives the first SIGINT, SIGTERM, SIGHUP or SIGQUIT is remembered instead of ending the process, so that work
// can be put away; a second one ends it, and says so; a quarter of a second after the first it
// counts as the same (`timeout` sends two). SIGPIPE, because
// nobody reads the output any more, is remembered however often it comes. One at a time.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  [[nodiscard]] static int received();  // its number; 0: none
  static void forget();                 // the next one is the first again
};

// What can be read from standard input within so many milliseconds (-1: as long as it takes), at most 4,096 bytes. Empty
// text: nothing yet, or a signal came. nullopt: the end of the input, or a terminal that is gone.
[[nodiscard]] std::optional<std::string> read_stdin_within(int milliseconds);

// Writes all of it now, past the buffer of stdio. False: nobody reads it any more.
[[nodiscard]] bool write_now(int descriptor, std::string_view text);

}  // namespace sightline::base
