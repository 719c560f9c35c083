#include "host/app/command_line.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "host/app/help_formatter.hpp"
#include "host/base/nearest_name.hpp"
#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::app {

// The embedded files of host/app/help.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> help_files();

namespace {

// The chain of commands from the program to the subcommand that was parsed last.
std::vector<const CLI::App*> command_path(const CLI::App& app) {
  std::vector<const CLI::App*> way{&app};
  for (auto below = app.get_subcommands(); !below.empty(); below = below.front()->get_subcommands()) {
    way.push_back(below.front());
  }
  return way;
}

std::vector<const CLI::App*> choices(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

// `name`: the command as a user types it.
void finish_help(CLI::App& app, const std::string& name) {
  std::string footer = app.get_footer();
  if (!footer.empty()) footer += "\n";
  if (app.get_parent() != nullptr && !choices(app).empty())
    footer += "`" + name + " SUBCOMMAND --help` explains all options of each.\n";
  app.footer(footer + std::string(exit_code_help));
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    finish_help(*command, name + " " + command->get_name());
}

void print_help(const CLI::App& app) {
  const std::vector<const CLI::App*> path = command_path(app);
  std::string parents;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) parents += (i == 0 ? "" : " ") + path[i]->get_name();
  write_stdout(path.back()->help(parents));
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

// "-3" and "-1,2,3" are values, although the parser takes them for options.
bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' && (argument[1] < '0' || argument[1] > '9');
}

std::string unknown_option(const CLI::App& command, const std::string& argument) {
  const std::string written = argument.substr(0, argument.find('='));
  for (const CLI::App* below : choices(command))
    if (below->get_option_no_throw(written) != nullptr)
      return fmt::format("{}: found before the subcommand, expected after it, as in `{} {} {}`", written, command.get_name(),
                         below->get_name(), written);
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    if (!option->get_description().empty())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return base::Error{.found = "unknown option " + written, .remedy = base::did_you_mean(written, names)}.message();
}

std::string unknown_command(const CLI::App& command, const std::string& argument) {
  const std::vector<std::string> names = names_of(choices(command));
  base::Error error{.found = "unknown command " + argument, .remedy = base::did_you_mean(argument, names)};
  if (error.remedy.empty()) error.expected = "one of " + base::joined(names, ", ");
  return error.message();
}

// The complaint about an argument that no command accepts, if there is one. It is reported before the errors of the library,
// because a misspelt option would otherwise be reported as a missing one.
std::optional<std::string> explain_unknown(const CLI::App& app) {
  const auto way = command_path(app);
  for (const CLI::App* command : way) {
    const auto rest = command->remaining();
    const bool incomplete = command == way.back() && !choices(*command).empty();
    if (incomplete && !rest.empty() && !is_option(rest.front())) return unknown_command(*command, rest.front());
    const auto option = std::find_if(rest.begin(), rest.end(), is_option);
    if (option != rest.end()) return unknown_option(*command, *option);
  }
  return std::nullopt;
}

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  if (const auto unknown = explain_unknown(app)) return *unknown;
  const auto way = command_path(app);
  const CLI::App& command = *way.back();
  // `explain house jones`: the subcommand is after the words that should follow it.
  if (way.size() > 2 && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    const CLI::App& parent = *way[way.size() - 2];
    const auto before = parent.remaining();
    if (!before.empty() && !is_option(before.front()))
      return fmt::format("found \"{}\" before {}, expected after it, as in `{} {} {}`", before.front(), command.get_name(), parent.get_name(),
                         command.get_name(), before.front());
  }
  // The library only says that a subcommand is required.
  if (!choices(command).empty())
    return "found no more arguments, expected one of " + base::joined(names_of(choices(command)), ", ");
  const auto rest = command.remaining();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !rest.empty())
    return "found \"" + rest.front() + "\", expected no more arguments";
  return error.what();
}

// An empty value would have the effect of an omitted option: `--at "$UNSET"` must not silently draw another picture. But a
// text that is typed, or waited for, may be empty.
void reject_empty_arguments(int argc, char** argv) {
  constexpr std::array<std::string_view, 3> texts{"--expect", "--send", "--cpm-args"};
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] != '\0' || std::find(texts.begin(), texts.end(), argv[i - 1]) != texts.end()) continue;
    throw base::usage_error("found an empty argument after \"" + std::string(argv[i - 1]) +
                                       "\", expected a value");
  }
}

// `help COMMAND...` prints the same text as `COMMAND... --help`.
void add_help_command(CLI::App& app) {
  const HelpPage page = help_page("help");
  CLI::App* const help = app.add_subcommand("help", page.summary);
  help->footer(page.text);
  const auto words = std::make_shared<std::vector<std::string>>();
  help->add_option("COMMAND", *words, "The command, with its subcommand if it has any");
  help->callback([&app, words] {
    CLI::App* command = &app;
    std::string parents;
    for (const std::string& word : *words) {
      const auto below = command->get_subcommands([&word](const CLI::App* choice) { return choice->check_name(word); });
      if (below.empty()) throw base::usage_error(unknown_command(*command, word));
      parents += (parents.empty() ? "" : " ") + command->get_name();
      command = below.front();
    }
    const std::string name = parents.empty() ? command->get_name() : parents + " " + command->get_name();
    write_stdout(command->get_formatter()->make_help(command, name, CLI::AppFormatMode::Normal));
  });
}

ExitCode parse_and_run(CLI::App& app, int argc, char** argv, const ExitCode& exit_code) {
  reject_empty_arguments(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    if (const auto unknown = explain_unknown(app)) throw base::usage_error(*unknown);
    print_help(app);
  } catch (const CLI::CallForVersion& version) {
    write_stdout(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    print_message(explain(app, error));
    std::string name;
    for (const CLI::App* command : command_path(app)) name += command->get_name() + " ";
    print_message("see `" + name + "--help`");
    return ExitCode::usage;
  }
  check_stdout();
  return exit_code;
}

template <class Value>
constexpr bool is_whole = std::is_integral_v<Value>;
template <class Value>
constexpr bool is_whole<std::optional<Value>> = std::is_integral_v<Value>;
template <class Value>
constexpr bool is_whole<std::vector<Value>> = std::is_integral_v<Value>;

// Writes a count such as 1e6 as digits, 1000000.
std::string count_in_digits(std::string text) {
  const auto count = base::count_number(text);
  return count ? std::to_string(*count) : text;
}

}  // namespace

HelpPage help_page(std::string_view name,
                   std::initializer_list<std::pair<std::string_view, std::string>> values) {
  const std::string file = std::string(name) + ".txt";
  for (const auto& [path, contents] : help_files()) {
    if (path != file) continue;
    std::string text(contents);
    for (const auto& [key, value] : values) {
      const std::string place = "{" + std::string(key) + "}";
      for (std::size_t at = 0; (at = text.find(place, at)) != std::string::npos; at += value.size())
        text.replace(at, place.size(), value);
    }
    const std::size_t summary = text.find('\n');
    return {text.substr(0, summary), text.substr(std::min(summary + 2, text.size()))};
  }
  throw std::logic_error("no help text " + file);
}

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::default_value() const {
  option_->capture_default_str();
  return *this;
}

Option Option::default_value(const std::string& text) const {
  option_->default_str(text);
  return *this;
}

Option Option::value(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

Option Option::group(const std::string& heading) const {
  option_->group(heading);
  return *this;
}

Option Option::one_of(const std::vector<std::string>& values) const {
  option_->check(CLI::IsMember(values));
  return *this;
}

Option Option::one_of_numbers(const std::vector<double>& values) const {
  option_->check(CLI::IsMember(values));
  return *this;
}

Option Option::one_of_any_case(const std::vector<std::string>& values) const {
  option_->check(CLI::IsMember(values, CLI::ignore_case));
  return *this;
}

template <class Number>
Option Option::range(Number low, Number high) const {
  CLI::Range range(low, high);  // gives the option its description
  range.operation([low, high](std::string& text) {
    Number number{};
    if (CLI::detail::lexical_cast(text, number) && number >= low && number <= high) return std::string();
    return fmt::format("found \"{}\", expected {}{} to {}", text, std::is_integral_v<Number> ? "a whole number from " : "",
                       low, high);
  });
  option_->check(range);
  return *this;
}
template Option Option::range(int, int) const;
template Option Option::range(unsigned, unsigned) const;
template Option Option::range(std::int64_t, std::int64_t) const;
template Option Option::range(std::uint64_t, std::uint64_t) const;
template Option Option::range(double, double) const;

Option Option::check(const std::function<std::string(const std::string&)>& why_not) const {
  option_->check(why_not);
  return *this;
}

Option Option::separated_by(char separator) const {
  option_->delimiter(separator);
  return *this;
}

Option Option::one_at_a_time() const {
  option_->allow_extra_args(false);
  return *this;
}

Option Option::needs(const Option& other) const {
  option_->needs(other.option_);
  return *this;
}

Option Option::excludes(const Option& other) const {
  option_->excludes(other.option_);
  return *this;
}

Option Option::hidden() const {
  option_->description("");
  return *this;
}

Command Command::add_command(const std::string& name, const std::string& summary) const {
  app_->require_subcommand(1);
  return {*app_->add_subcommand(name, summary), *exit_code_};
}

Command Command::add_command(const std::string& name, const HelpPage& help) const {
  const Command command = add_command(name, help.summary);
  command.footer(help.text);
  return command;
}

void Command::add_alias(const std::string& name) const {
  app_->alias(name);
}

template <class Value>
Option Command::option(const std::string& names, Value& variable, std::string_view help) const {
  CLI::Option* const option = app_->add_option(names, variable, std::string(help));
  if constexpr (is_whole<Value>) option->transform(count_in_digits);
  return Option(option);
}
template Option Command::option(const std::string&, std::string&, std::string_view) const;
template Option Command::option(const std::string&, int&, std::string_view) const;
template Option Command::option(const std::string&, unsigned&, std::string_view) const;
template Option Command::option(const std::string&, std::int64_t&, std::string_view) const;
template Option Command::option(const std::string&, std::uint64_t&, std::string_view) const;
template Option Command::option(const std::string&, double&, std::string_view) const;
template Option Command::option(const std::string&, std::optional<int>&, std::string_view) const;
template Option Command::option(const std::string&, std::optional<double>&, std::string_view) const;
template Option Command::option(const std::string&, std::optional<std::size_t>&, std::string_view) const;
template Option Command::option(const std::string&, std::optional<std::string>&, std::string_view) const;
template Option Command::option(const std::string&, std::vector<std::string>&, std::string_view) const;
template Option Command::option(const std::string&, std::vector<int>&, std::string_view) const;

Option Command::in_order(const std::string& names, std::function<void(const std::string&)> each,
                         std::string_view help) const {
  return Option(app_->add_option_function<std::string>(names, each, std::string(help))->trigger_on_parse());
}

Option Command::flag(const std::string& names, bool& variable, std::string_view help) const {
  return Option(app_->add_flag(names, variable, std::string(help)));
}

Option Command::flag(const std::string& names, std::string_view help) const {
  return Option(app_->add_flag(names)->description(std::string(help)));
}

Option Command::find_option(const std::string& name) const {
  return Option(app_->get_option(name));
}

void Command::list_shared_options() const {
  app_->formatter(help_formatter_with_shared_options());
}

void Command::footer(const std::string& text) const {
  app_->footer(text);
}

void Command::run(std::function<ExitCode()> work) const {
  app_->callback([work = std::move(work), exit_code = exit_code_] { *exit_code = work(); });
}

bool Command::is_given(const std::string& option) const {
  return app_->count(option) > 0;
}

int run_command_line(int argc, char** argv, const HelpPage& help,
                     const std::function<void(const Command&)>& add_commands, std::string_view greeting) {
  // A file that exceeds the shell's limit of size is reported as a write error; the signal would end the process.
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  ExitCode exit_code = ExitCode::ok;
  try {
    if (argc == 1 && !greeting.empty()) {
      write_stdout(help_text(greeting));
      check_stdout();
      return static_cast<int>(ExitCode::ok);
    }
    CLI::App app(help.summary, "sightline");
    app.set_version_flag("--version", "sightline " SIGHTLINE_VERSION, "Print name and version");
    app.formatter(help_formatter());
    add_commands(Command(app, exit_code));
    if (!greeting.empty()) add_help_command(app);
    app.footer(help.text);
    finish_help(app, app.get_name());
    exit_code = parse_and_run(app, argc, argv, exit_code);
  } catch (const base::Error& error) {
    print_message(error.message());
    exit_code = exit_code_of(error.kind);
  } catch (const std::bad_alloc&) {
    print_message("not enough memory");
    exit_code = ExitCode::io;
  } catch (const std::exception& error) {
    print_message(std::string("internal error: ") + error.what());
    exit_code = ExitCode::io;
  }
  return static_cast<int>(exit_code);
}

}  // namespace sightline::app
