// See machine_command.hpp.
#include "host/app/commands/machine_command.hpp"

#include <algorithm>
#include <memory>

namespace sightline::app {

[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> help_files();

namespace {

using guests::run::Arguments;
using guests::run::OptionKind;

Option add(const Command& command, const guests::run::Option& option, Arguments::Value& value) {
  switch (option.kind) {
    case OptionKind::flag:
      // One that is only there to be said has nothing to set.
      return command.flag(option.name, value.flag, option.help);
    case OptionKind::list: return command.option(option.name, value.list, option.help).one_at_a_time();
    case OptionKind::files: return command.option(option.name, value.list, option.help);
    case OptionKind::positions: return command.option(option.name, value.list, option.help).required();
    case OptionKind::position: return command.option(option.name, value.text, option.help).required();
    case OptionKind::text:
    case OptionKind::stream:
    case OptionKind::output: break;
  }
  return command.option(option.name, value.text, option.help);
}

}  // namespace

void add_machine_command(const Command& parent, std::string_view name, std::string_view summary,
                         std::span<const guests::run::Option> options, const std::string& below,
                         std::function<ExitCode(const Arguments&)> work) {
  const Command command = parent.add_command(std::string(name), std::string(summary));
  const auto arguments = std::make_shared<Arguments>(options);
  for (const guests::run::Option& option : options) {
    const Option added = add(command, option, arguments->value(option.key()));
    const std::vector<std::string> choices(option.choices.begin(), option.choices.end());
    if (!choices.empty())
      static_cast<void>(option.any_case ? added.one_of_any_case(choices) : added.one_of(choices));
    if (!option.shown_initial.empty()) {
      static_cast<void>(added.default_value(std::string(option.shown_initial)));
    } else if (!option.initial.empty()) {
      static_cast<void>(added.default_value());
    }
    if (!option.argument.empty()) static_cast<void>(added.value(std::string(option.argument)));
    if (!option.excludes.empty())
      static_cast<void>(added.excludes(command.added(std::string(option.excludes))));
  }
  command.footer(below);
  command.run([arguments, work = std::move(work)] { return work(*arguments); });
}

std::string help_text(std::string_view name) {
  const auto files = help_files();
  const std::string file = std::string(name) + ".txt";
  const auto found =
      std::find_if(files.begin(), files.end(), [&file](const auto& each) { return each.first == file; });
  return found == files.end() ? std::string() : std::string(found->second);
}

Failure failure(const guests::run::Refusal& refusal) {
  return {refusal.kind == guests::run::Refusal::Kind::usage ? ExitCode::usage : ExitCode::bad_input,
          refusal.message};
}

guests::run::Input read_named(const std::string& path) {
  return {shown_name(path), read_input(path)};
}

}  // namespace sightline::app
