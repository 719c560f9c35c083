// Declares the subcommands of a program and their options, and runs the command line.
//
// A Command is a handle. Options are bound to variables that must exist until the command has run; a command usually keeps
// them in a std::shared_ptr that its function holds. CLI11 parses the command line; only command_line.cpp and
// help_formatter.cpp include it, because its headers are 81,000 lines long. The exit codes are those of command.hpp, not
// those of the library.
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

// The help of a command, from host/app/help/NAME.txt. The first line is the summary; the text below an empty line is printed
// after the options. Each line is a paragraph, wrapped to the width of the terminal; an indented line is an example, or a
// term and its meaning.
struct HelpPage {
  std::string summary;
  std::string text;
};
// `values` replace {KEY} in the text.
[[nodiscard]] HelpPage help_page(std::string_view name,
                                 std::initializer_list<std::pair<std::string_view, std::string>> values = {});

// A flag, an option with a value, or a positional argument. Each function returns the option, so that calls can be chained.
class Option {
 public:
  Option required() const;
  // The default value that the help shows: the variable's value, or a text.
  Option default_value() const;
  Option default_value(const std::string& text) const;
  // The name of the value in the help, such as FILE. Not needed with one_of.
  Option value(const std::string& name) const;
  // The heading under which the help lists the option, instead of "Options".
  Option group(const std::string& heading) const;

  Option one_of(const std::vector<std::string>& values) const;
  Option one_of_numbers(const std::vector<double>& values) const;
  Option one_of_any_case(const std::vector<std::string>& values) const;
  // `low` and `high` are included. nan passes: see require_finite.
  template <class Number>
  Option range(Number low, Number high) const;
  // `why_not` returns the complaint about a value, or an empty text.
  Option check(const std::function<std::string(const std::string&)>& why_not) const;

  // For lists: several values in one argument (NAME,...), or one value each time the option is given.
  Option separated_by(char separator) const;
  Option one_at_a_time() const;

  // The command line is an error if `other` is not given (needs) or is given (excludes) together with this option.
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

  // A command with subcommands must be called with one of them.
  Command add_command(const std::string& name, const std::string& summary) const;
  Command add_command(const std::string& name, const HelpPage& help) const;
  // A second name, accepted but not listed in the help.
  void add_alias(const std::string& name) const;

  // `names`: "-o,--output", or "SCENE" for a positional argument. Value: string, int, unsigned, int64, uint64
  // or double, an optional number, or a vector of strings or ints.
  template <class Value>
  Option option(const std::string& names, Value& variable, std::string_view help) const;
  Option flag(const std::string& names, bool& variable, std::string_view help) const;
  // An option that may be given several times. `each` is called for every value in the order of the command line, also relative
  // to other such options.
  Option in_order(const std::string& names, std::function<void(const std::string&)> each, std::string_view help) const;
  // A flag without effect, for a command line that states the default.
  Option flag(const std::string& names, std::string_view help) const;
  // An option that was added before, by its name.
  [[nodiscard]] Option find_option(const std::string& name) const;

  // Makes the help list the options that most subcommands share. Called after all of them have been added.
  void list_shared_options() const;
  // The text that the help shows below the options, formatted by help_formatter.cpp.
  void footer(const std::string& text) const;
  // The function of the command; it returns the exit code of the process.
  void run(std::function<ExitCode()> work) const;

  // Whether the command line has an option, such as "--size".
  [[nodiscard]] bool is_given(const std::string& option) const;

 private:
  CLI::App* app_;
  ExitCode* exit_code_;
};

// Parses the command line, runs the command, and prints help, version and errors. `help` is the help of the program;
// `add_commands` adds its commands. A non-empty `greeting` is printed if there are no arguments, and also adds the command
// `help`.
[[nodiscard]] int run_command_line(int argc, char** argv, const HelpPage& help,
                                   const std::function<void(const Command&)>& add_commands,
                                   std::string_view greeting = {});

}  // namespace sightline::app
