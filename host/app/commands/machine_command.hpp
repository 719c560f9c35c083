// What `run`, `asm` and `disasm` share: a subcommand for each described machine
// (host/machines/machine.hpp), whose options are data.
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

// One subcommand of `parent`.
void add_machine_command(const Command& parent, std::string_view name, const HelpPage& help,
                         std::span<const machines::Option> options,
                         std::function<ExitCode(const machines::Arguments&)> work);

// Reads a file whole; Error io.
[[nodiscard]] machines::Input read_named(const std::string& path);

// The text of a source that another includes; empty if it cannot be read.
[[nodiscard]] std::optional<std::string> read_include(const std::string& path);

// Error io if the image of --disk could not be written back after the run, which is better known before it.
void check_disk(const machines::Arguments& arguments);

// Puts what the program has changed on disks back into their files, each whole or not at all. Error io.
void write_media_back(const machines::Machine& machine);

}  // namespace sightline::app
