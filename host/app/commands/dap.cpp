// `sightline dap`: the Debug Adapter Protocol on standard input and output.
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/machine_command.hpp"
#include "host/app/commands/monitor_session.hpp"
#include "host/app/outputs.hpp"
#include "host/base/json.hpp"
#include "host/base/terminal.hpp"
#include "host/live/console.hpp"
#include "host/live/dap/dap.hpp"

namespace sightline::app {

namespace {

using base::Json;
using machines::Arguments;
using machines::MachineDescription;
using machines::OptionKind;

[[noreturn]] void reject(const std::string& complaint) {
  throw base::usage_error("launch: " + complaint);
}

// A text or a number, as a word of the command line.
std::string word_of(const Json& value, std::string_view name) {
  if (const std::string* const text = value.text()) return *text;
  if (value.is_number()) return value.dump();
  reject("found " + describe(value) + " for " + std::string(name) + ", expected a text or a number");
}

const MachineDescription& machine_named(const Json& arguments) {
  const Json* const name = arguments.find("machine");
  std::string names;
  for (const MachineDescription* const machine : machines::machines()) {
    if (name != nullptr && name->text() != nullptr && *name->text() == machine->name) return *machine;
    names += (names.empty() ? "" : " or ") + std::string(machine->name);
  }
  reject("found " + (name == nullptr ? std::string("no machine") : name->dump()) + ", expected machine: " + names);
}

Arguments arguments_of(const Json& request, std::span<const machines::Option> options) {
  Arguments arguments(options);
  const auto set = [&](std::string_view name, const Json& value) {
    const auto option = std::find_if(options.begin(), options.end(), [&name](const auto& each) { return each.key() == name; });
    if (name == "--do" || name == "--speed") reject("found option " + std::string(name.substr(2)) + ", which is for a terminal");
    if (option == options.end()) reject("found option " + std::string(name.substr(2)) + ", expected one of `sightline monitor`");
    Arguments::Value& into = arguments.value(name);
    const bool several = option->kind == OptionKind::list || option->kind == OptionKind::files;
    if (option->kind == OptionKind::flag) {
      if (!value.boolean()) reject("found " + describe(value) + " for " + std::string(name.substr(2)) + ", expected true or false");
      into.flag = *value.boolean();
    } else if (several && value.is_array()) {
      for (const Json& each : value.elements()) into.list.push_back(word_of(each, name));
    } else if (several) {
      into.list.push_back(word_of(value, name));
    } else {
      into.text = word_of(value, name);
      const auto& choices = option->choices;
      if (!choices.empty() && std::find(choices.begin(), choices.end(), into.text) == choices.end())
        reject("found " + into.text + " for " + std::string(name.substr(2)) + ", which is none of its values");
    }
  };
  if (const Json* const program = request.find("program")) set("--load", *program);
  if (const Json* const more = request.find("options")) {
    if (!more->is_object()) reject("found " + describe(*more) + " as options, expected an object");
    for (const base::JsonMember& each : more->members()) set("--" + each.key, each.value);
  }
  return arguments;
}

base::Result<live::Launched> launch(const Json& request) {
  try {
    if (!request.is_object()) reject("found " + describe(request) + " as arguments, expected an object");
    const MachineDescription& machine = machine_named(request);
    const std::vector<machines::Option> options = monitor_options(machine);
    const Arguments arguments = arguments_of(request, options);
    MonitoredMachine made = make_monitored(machine, arguments);
    std::vector<std::string> warnings = made.prepared.warnings;
    std::optional<live::KeyCodes> keys;
    if (arguments.given("--console")) keys = value_of(live::console_options(arguments, false)).codes;
    return live::Launched{&machine, std::move(made.prepared), std::move(made.symbols), std::move(warnings),
                          radix_of(arguments), keys, dialect_of(arguments)};
  } catch (const base::Error& error) {
    return error;
  }
}

// A signal, or a client that closes its connection, ends the session in order: changed disks are written back.
ExitCode serve() {
  const base::EndSignals signals;
  live::DapHost host;
  host.read = [](int milliseconds) -> std::optional<std::string> {
    if (base::EndSignals::received() != 0) return std::nullopt;
    return base::read_stdin_within(milliseconds);
  };
  host.write = [](std::string_view text) { return base::write_now(STDOUT_FILENO, text); };
  host.launch = launch;
  host.commands = files_of_commands();
  host.finish = [](const machines::Machine& machine) -> base::Result<base::Done> {
    try {
      write_media_back(machine);
    } catch (const base::Error& error) {
      return error;
    }
    return base::Done{};
  };
  const auto done = live::serve_debug_adapter(host);
  if (!done) throw base::bad_input("dap: " + done.error().message());
  return base::EndSignals::received() == 0 ? ExitCode::ok : ExitCode::interrupted;
}

}  // namespace

void add_dap_command(const Command& program) {
  program.add_command("dap", help_page("dap")).run(serve);
}

}  // namespace sightline::app
