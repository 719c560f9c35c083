// See command_line.hpp.
#include "host/app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/app/help_formatter.hpp"

namespace sightline::app {

// host/app/help, embedded.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> help_files();

namespace {

// From the whole command to the subcommand the user got to.
std::vector<const CLI::App*> way_to_subcommand(const CLI::App& app) {
  std::vector<const CLI::App*> way{&app};
  for (auto below = app.get_subcommands(); !below.empty(); below = below.front()->get_subcommands()) {
    way.push_back(below.front());
  }
  return way;
}

std::vector<const CLI::App*> choices(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

// `name`: the command as it is typed.
void finish_help(CLI::App& app, const std::string& name) {
  std::string footer = app.get_footer();
  if (!footer.empty()) footer += "\n";
  if (app.get_parent() != nullptr && !choices(app).empty())
    footer += "`" + name + " SUBCOMMAND --help` explains the options of each.\n";
  app.footer(footer + std::string(exit_code_help));
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
    finish_help(*command, name + " " + command->get_name());
}

void print_help(const CLI::App& app) {
  const std::vector<const CLI::App*> path = way_to_subcommand(app);
  std::string parents;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) parents += (i == 0 ? "" : " ") + path[i]->get_name();
  write_stdout(path.back()->help(parents));
}

// The library only says that a subcommand is required.
std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = *way_to_subcommand(app).back();
  if (choices(command).empty()) return error.what();
  std::string names;
  for (const CLI::App* choice : choices(command)) names += (names.empty() ? "" : ", ") + choice->get_name();
  const auto rest = command.remaining();
  return (rest.empty() ? "found no more arguments" : "found \"" + rest.front() + "\"") +
         ", expected one of " + names;
}

// An empty value would pass for an option not given: "--at $UNSET" must not draw another picture in silence.
void refuse_empty_arguments(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] != '\0') continue;
    throw Failure(ExitCode::usage, "found an empty argument after \"" + std::string(argv[i - 1]) +
                                       "\", expected something in it");
  }
}

ExitCode parse_and_run(CLI::App& app, int argc, char** argv, const ExitCode& exit_code) {
  refuse_empty_arguments(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print_help(app);
  } catch (const CLI::CallForVersion& version) {
    write_stdout(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    complain(explain(app, error));
    std::string name;
    for (const CLI::App* command : way_to_subcommand(app)) name += command->get_name() + " ";
    complain("see `" + name + "--help`");
    return ExitCode::usage;
  }
  check_stdout();
  return exit_code;
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
  option_->check(CLI::Range(low, high));
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

void Command::also_called(const std::string& name) const {
  app_->alias(name);
}

template <class Value>
Option Command::option(const std::string& names, Value& variable, std::string_view help) const {
  return Option(app_->add_option(names, variable, std::string(help)));
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
template Option Command::option(const std::string&, std::vector<std::string>&, std::string_view) const;
template Option Command::option(const std::string&, std::vector<int>&, std::string_view) const;

Option Command::flag(const std::string& names, bool& variable, std::string_view help) const {
  return Option(app_->add_flag(names, variable, std::string(help)));
}

Option Command::flag(const std::string& names, std::string_view help) const {
  return Option(app_->add_flag(names)->description(std::string(help)));
}

Option Command::added(const std::string& name) const {
  return Option(app_->get_option(name));
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
                     const std::function<void(const Command&)>& add_commands) {
  // A file that grows beyond what the shell allows is an error of writing like others, not the end.
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  ExitCode exit_code = ExitCode::ok;
  try {
    CLI::App app(help.summary, "sightline");
    app.set_version_flag("--version", "sightline " SIGHTLINE_VERSION, "Print name and version");
    app.formatter(help_formatter());
    add_commands(Command(app, exit_code));
    app.footer(help.text);
    finish_help(app, app.get_name());
    exit_code = parse_and_run(app, argc, argv, exit_code);
  } catch (const Failure& failure) {
    complain(failure.what());
    exit_code = failure.code();
  } catch (const std::bad_alloc&) {
    complain("not enough memory");
    exit_code = ExitCode::io;
  } catch (const std::exception& error) {
    complain(std::string("internal error: ") + error.what());
    exit_code = ExitCode::io;
  }
  return static_cast<int>(exit_code);
}

}  // namespace sightline::app
