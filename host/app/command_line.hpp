// A program with subcommands: what they are called, the options they take, and how the process ends.
//
// A Command is a handle: options are bound to variables that live until the command has run, so a command
// usually keeps its arguments in a std::shared_ptr that the function it runs holds. The library behind it,
// CLI11, is included by command_line.cpp and help_formatter.cpp alone, because its headers are 81,000 lines
// long. Exit codes are this program's own (command.hpp), not those of the library.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/app/command.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sightline::app {

// What --help says of a command: the file host/app/help/NAME.txt. Its first line is the summary; the text
// below an empty line follows the options. A line is a paragraph, broken to the width of the terminal; what
// is indented is an example, or a term and what it means.
struct HelpPage {
  std::string summary;
  std::string text;
};
// `values` replace {KEY}.
[[nodiscard]] HelpPage help_page(std::string_view name,
                                 std::initializer_list<std::pair<std::string_view, std::string>> values = {});

// A flag, an option with a value, or a positional argument. Each function returns the option itself.
class Option {
 public:
  Option required() const;
  // What is taken if the option is not given, for its help: the variable's value, or a text that says it.
  Option default_value() const;
  Option default_value(const std::string& text) const;
  // What the help calls the value: FILE. Not needed with one_of.
  Option value(const std::string& name) const;
  // The heading of the help under which the option stands, instead of "Options".
  Option group(const std::string& heading) const;

  Option one_of(const std::vector<std::string>& values) const;
  Option one_of_numbers(const std::vector<double>& values) const;
  Option one_of_any_case(const std::vector<std::string>& values) const;
  // `low` and `high` themselves are within. A value that is not a number passes: see require_finite.
  template <class Number>
  Option range(Number low, Number high) const;
  // `why_not` returns what is wrong with a value, or an empty text.
  Option check(const std::function<std::string(const std::string&)>& why_not) const;

  // Of lists: NAME,... in one argument; or one value each time the option is given.
  Option separated_by(char separator) const;
  Option one_at_a_time() const;

  // The command line is refused if `other` is not given as well, or is.
  Option needs(const Option& other) const;
  Option excludes(const Option& other) const;
  // Accepted, but not listed in the help.
  Option hidden() const;

 private:
  friend class Command;
  explicit Option(CLI::Option* option) : option_(option) {}
  CLI::Option* option_;
};

class Command {
 public:
  Command(CLI::App& app, ExitCode& exit_code) : app_(&app), exit_code_(&exit_code) {}

  // One of its commands must then be given.
  Command add_command(const std::string& name, const std::string& summary) const;
  Command add_command(const std::string& name, const HelpPage& help) const;
  // Another name that is accepted, but not listed.
  void also_called(const std::string& name) const;

  // `names`: "-o,--output", or "SCENE" of a positional argument. Value: string, int, unsigned, int64, uint64
  // or double, an optional of a number, or a vector of strings or ints.
  template <class Value>
  Option option(const std::string& names, Value& variable, std::string_view help) const;
  Option flag(const std::string& names, bool& variable, std::string_view help) const;
  // An option that may be given several times: `each` has its values in the order of the command line, also among those of
  // other such options.
  Option in_order(const std::string& names, std::function<void(const std::string&)> each, std::string_view help) const;
  // A flag that says what is so without it.
  Option flag(const std::string& names, std::string_view help) const;
  // An option that was added before.
  [[nodiscard]] Option added(const std::string& name) const;

  // The help also lists the options that most of its commands share. After all of them were added.
  void list_shared_options() const;
  // What the help says below the options; laid out by help_formatter.cpp.
  void footer(const std::string& text) const;
  // What the command does; its result is the exit code of the process.
  void run(std::function<ExitCode()> work) const;

  // Whether the command line has this option, "--size".
  [[nodiscard]] bool is_given(const std::string& option) const;

 private:
  CLI::App* app_;
  ExitCode* exit_code_;
};

// Reads the command line, runs the command it names, prints help, version and what the command fails with.
// `help` is that of the program; `add_commands` adds its commands. `greeting` is printed if there are no arguments, and
// there is a command `help`; without a greeting both are left out.
[[nodiscard]] int run_command_line(int argc, char** argv, const HelpPage& help,
                                   const std::function<void(const Command&)>& add_commands,
                                   std::string_view greeting = {});

}  // namespace sightline::app
