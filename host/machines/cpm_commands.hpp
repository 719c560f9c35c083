// The commands of --cpm-run: a text with a command on each line, as typed after CP/M's prompt.
//
//   [X:]NAME ARGUMENTS    runs NAME.COM of drive X, or of the current one
//   X:                    makes X the current drive
//   USER N                makes N, 0 to 15, the current user
//
// Lines that are empty or begin with ; are ignored.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/machines/machine.hpp"

namespace sightline::machines {

struct CpmCommand {
  std::string text;               // the line
  std::optional<unsigned> drive;  // 0 is A
  std::string program;            // 1 to 8 characters, in capitals; empty: the line selects a drive or a user
  std::optional<std::uint8_t> user;
  std::string tail;  // the rest of the line, from the blank after the name on
};

// An error names the line.
[[nodiscard]] Result<std::vector<CpmCommand>> read_cpm_commands(const Input& file);

// Whether the name is that of a command that is built into CP/M's CCP.
[[nodiscard]] bool is_built_into_ccp(std::string_view name);

}  // namespace sightline::machines
