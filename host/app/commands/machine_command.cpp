#include "host/app/commands/machine_command.hpp"

#include <memory>

#include "host/base/file.hpp"

namespace sightline::app {

namespace {

using machines::Arguments;
using machines::OptionKind;

Option add(const Command& command, const machines::Option& option, Arguments& arguments) {
  Arguments::Value& value = arguments.value(option.key());
  switch (option.kind) {
    case OptionKind::flag:
      // A flag that only states the default sets nothing.
      return command.flag(option.name, value.flag, option.help);
    case OptionKind::list: return command.option(option.name, value.list, option.help).one_at_a_time();
    case OptionKind::step:
      return command.in_order(
          option.name, [&arguments, key = std::string(option.key())](const std::string& text) { arguments.add_step(key, text); },
          option.help);
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

void add_machine_command(const Command& parent, std::string_view name, const HelpPage& help,
                         std::span<const machines::Option> options,
                         std::function<ExitCode(const Arguments&)> work) {
  const Command command = parent.add_command(std::string(name), help);
  const auto arguments = std::make_shared<Arguments>(options);
  for (const machines::Option& option : options) {
    const Option added = add(command, option, *arguments);
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
      static_cast<void>(added.excludes(command.find_option(std::string(option.excludes))));
  }
  command.run([arguments, work = std::move(work)] { return work(*arguments); });
}

machines::Input read_named(const std::string& path) {
  return {display_name(path), read_input(path)};
}

// Errors are ignored because the assembler tries several names and reports if none can be read. In a source, `-` is an ordinary
// file name, not standard input.
std::optional<std::string> read_include(const std::string& path) {
  if (path == "-") return std::nullopt;
  try {
    return read_input_text(path);
  } catch (const base::Error&) {
    return std::nullopt;
  }
}

void check_disk(const machines::Arguments& arguments) {
  const std::string& path = arguments.text("--disk");
  if (path.empty() || arguments.given("--disk-read-only") || base::file_status(path).kind != base::FileStatus::Kind::file) return;
  const auto image = base::AtomicFile::create(path);
  if (!image)
    throw base::io_error(image.error().message() + "; its changes could not be kept: --disk-read-only leaves it as it is");
}

void write_media_back(const machines::Machine& machine) {
  for (const auto& medium : machine.changed_media()) {
    const auto done = base::write_file_atomically(medium.path, medium.content);
    if (!done) throw done.error();
  }
}

}  // namespace sightline::app
