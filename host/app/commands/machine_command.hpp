// Adds the subcommands of `run`, `asm`, `disasm` and `monitor`: one for each described machine (host/machines/machine.hpp), with
// the options of its description.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/app/command_line.hpp"
#include "host/machines/engine.hpp"

namespace sightline::app {

// Adds a subcommand to `parent`.
void add_machine_command(const Command& parent, std::string_view name, const HelpPage& help,
                         std::span<const machines::Option> options,
                         std::function<ExitCode(const machines::Arguments&)> work);

// Reads a whole file. Error io.
[[nodiscard]] machines::Input read_named(const std::string& path);

// The text of an included source; empty if it cannot be read.
[[nodiscard]] std::optional<std::string> read_include(const std::string& path);

// Checks before the run that the image of --disk can be written back after it. Error io.
void check_disk(const machines::Arguments& arguments);

// Writes changed disks back to their files, each completely or not at all. Error io.
void write_media_back(const machines::Machine& machine);

}  // namespace sightline::app
