// What all subcommands of `sightline` share: exit codes, how they fail, how they read and write.
//
// Data goes to standard output, talk to standard error. A subcommand returns its exit code, or throws a
// base::Error, which main prints. Outputs appear whole or not at all: they are opened before the work,
// so that a path that cannot be written is known at once, and put in their places after it.
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

// Shown at the end of every --help.
inline constexpr std::string_view exit_code_help =
    "Exit codes: 0 done, 1 results differ, 2 wrong usage, 3 the emulated program failed, 4 bad input file, "
    "5 a file cannot be read or written, 130 stopped by Ctrl-C.";

[[nodiscard]] ExitCode exit_code_of(base::ErrorKind kind);

using base::value_of;

// One line on standard error, "sightline: text".
void complain(std::string_view text);
void warn(std::string_view text);
// "sightline: FILE: WHAT" for a person who would else see nothing: only if standard error is a terminal, so that scripts
// and pipes see no difference, and not if the file is standard output ("-") or none ("").
void say_written(const std::string& file, std::string_view what);
// "1 line", "2 lines": `unit` is what one is called, `units` what others are; an s is added unless it is given.
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view unit, std::string_view units = {});

// The whole file, or standard input for "-" (named by shown_name). Error io.
[[nodiscard]] base::Bytes read_input(const std::string& path);
[[nodiscard]] std::string read_input_text(const std::string& path);
// "-" as "standard input".
[[nodiscard]] std::string shown_name(const std::string& path);

// Standard output. write_stdout fails quietly; check_stdout throws Error io if anything was lost.
void write_stdout(std::string_view text);
void check_stdout();
// A document of --json.
void print_json(const base::Json& document);

// A file to be, or standard output for "-".
class Output {
 public:
  // Error io if the path cannot be written.
  explicit Output(const std::string& path);

  [[nodiscard]] bool is_stdout() const { return !file_; }
  void write(std::string_view text);
  void write(std::span<const std::uint8_t> bytes);
  // Once. Error io.
  void commit();

 private:
  std::unique_ptr<base::AtomicFile> file_;
};

// The option parser reads -1 as the largest number, and so every number that is too large: a check for options whose
// numbers have no other bounds. Empty if `text` is a whole number from 0 to 2^64 - 1, else the complaint.
[[nodiscard]] std::string why_no_whole_number(const std::string& text);

// The option parser takes nan and inf for numbers: an error of usage for them.
void require_finite(const char* option, double value);

}  // namespace sightline::app
