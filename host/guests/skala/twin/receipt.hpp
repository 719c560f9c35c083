// Receipt of the command stream by the Skala program's twin: the checks made before a command is buffered,
// and how much of the stream gets drawn. Source: firmware/i8080/skala/SPECIFICATION.md sections 1 and 9.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/guests/skala/commands.hpp"

namespace sightline::guests::skala {

struct ReceivedCommand {
  Command command;
  std::size_t last_byte;  // its place in the stream
  std::span<const std::uint8_t> arguments;
};

struct Receipt {
  // The commands that are drawn, in order: those buffered when the buffer filled up, and all when END came.
  std::vector<ReceivedCommand> drawn;
  // What receipt itself ends with: complete, an error, or running when the stream is at its end too early.
  Status status = Status::running;
  std::size_t bytes_taken = 0;
};

// The spans point into `stream`.
[[nodiscard]] Receipt receive_stream(std::span<const std::uint8_t> stream);

}  // namespace sightline::guests::skala
