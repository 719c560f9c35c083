// The exit codes, messages, inputs and outputs of all subcommands of `sightline`.
//
// Data goes to standard output, messages to standard error. A subcommand returns its exit code or throws a base::Error, which
// main prints. Outputs are opened before the work, so that a path that cannot be written is reported at once, and committed
// after it: files are written completely or not at all.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/base/file.hpp"
#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/base/value_of.hpp"

namespace sightline::app {

enum class ExitCode : int {
  ok = 0,
  differs = 1,       // a comparison or a check of results failed
  usage = 2,         // the command line is wrong
  guest_failed = 3,  // the program on the emulated machine failed
  bad_input = 4,     // an input file is wrong
  io = 5,            // a file could not be read or written
  interrupted = 130,
};

// Printed at the end of every --help.
inline constexpr std::string_view exit_code_help =
    "Exit codes: 0 done, 1 results differ, 2 wrong usage, 3 the emulated program failed, 4 bad input file, "
    "5 a file cannot be read or written, 130 stopped by Ctrl-C.";

[[nodiscard]] ExitCode exit_code_of(base::ErrorKind kind);

using base::value_of;

// Prints one line on standard error: "sightline: TEXT".
void print_message(std::string_view text);
void warn(std::string_view text);
// Prints "sightline: FILE: WHAT" if standard error is a terminal; scripts and pipes see nothing. Prints nothing for standard
// output ("-") and for no file ("").
void report_written(const std::string& file, std::string_view what);
// "1 line", "2 lines": `unit` is the singular, `units` the plural, by default the singular with an s.
[[nodiscard]] std::string count_text(std::uint64_t count, std::string_view unit, std::string_view units = {});

// Reads a whole file, or standard input for "-". Error io.
[[nodiscard]] base::Bytes read_input(const std::string& path);
[[nodiscard]] std::string read_input_text(const std::string& path);
// The name of an input in messages: "standard input" for "-".
[[nodiscard]] std::string display_name(const std::string& path);

// write_stdout ignores failures; check_stdout throws Error io if any output was lost.
void write_stdout(std::string_view text);
void check_stdout();
// Prints the document of --json on standard output.
void print_json(const base::Json& document);

// A file to be written, or standard output for "-".
class Output {
 public:
  // Error io if the path cannot be written.
  explicit Output(const std::string& path);

  [[nodiscard]] bool is_stdout() const { return !file_; }
  void write(std::string_view text);
  void write(std::span<const std::uint8_t> bytes);
  // Called once. Error io.
  void commit();

 private:
  std::unique_ptr<base::AtomicFile> file_;
};

// A check for options whose numbers have no other bounds: empty if `text` is a whole number from 0 to 2^64 - 1, else the
// complaint. The option parser would accept -1 and numbers that are too large, as 2^64 - 1.
[[nodiscard]] std::string whole_number_error(const std::string& text);

// Throws Error usage for nan and inf, which the option parser accepts as numbers.
void require_finite(const char* option, double value);

}  // namespace sightline::app
