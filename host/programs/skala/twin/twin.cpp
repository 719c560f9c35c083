#include "host/programs/skala/twin/twin.hpp"

#include <utility>

#include "host/programs/skala/twin/drawing.hpp"

namespace sightline::programs::skala {
namespace {

// --- Receipt: the checks before a command is buffered, and which part of the stream is drawn (SPECIFICATION.md sections 1
// and 9)

struct Receipt {
  // The commands that are drawn, in order: those buffered when the buffer was full, and all when END arrived.
  std::vector<ReceivedCommand> drawn;
  // The status of receipt: complete, an error, or running if the stream ends too early.
  Status status = Status::running;
  std::size_t bytes_taken = 0;
};

// The first argument that is out of range, counted from 0, or -1. Only arguments that are always present are checked.
[[nodiscard]] int offending_argument(Command command, std::span<const std::uint8_t> arguments) {
  switch (command) {
    case Command::curve:
    case Command::gap: return arguments.size() >= 2 && arguments[0] + count_of(arguments[1]) > 256 ? 1 : -1;
    case Command::device: return !arguments.empty() && (arguments[0] & ~no_visibility) > 3 ? 0 : -1;
    default: return -1;
  }
}

// The number of arguments of the current command, as far as the received ones tell.
[[nodiscard]] std::size_t arguments_wanted(const CommandRow& row, std::span<const std::uint8_t> arguments) {
  const auto leading = static_cast<std::size_t>(row.leading_arguments);
  if (row.bytes_per_item == 0 || arguments.size() < leading) return leading;
  return leading + static_cast<std::size_t>(count_of(arguments[leading - 1]) * row.bytes_per_item);
}

// The spans point into `stream`.
Receipt receive_stream(std::span<const std::uint8_t> stream) {
  Receipt receipt;
  std::vector<ReceivedCommand> buffered;
  std::size_t used = 0;
  const auto draw_buffered = [&] {
    receipt.drawn.insert(receipt.drawn.end(), buffered.begin(), buffered.end());
    buffered.clear();
    used = 0;
  };
  for (std::size_t at = 0; at < stream.size();) {
    const auto row = find_command(stream[at]);
    if (!row) return {std::move(receipt.drawn), Status::unknown_command, at + 1};
    const auto come = stream.subspan(at + 1);
    if (const int bad = offending_argument(row->command, come); bad >= 0)
      return {std::move(receipt.drawn), Status::argument_out_of_range,
              at + 2 + static_cast<std::size_t>(bad)};
    const std::size_t wanted = arguments_wanted(*row, come);
    if (come.size() < wanted) break;
    buffered.push_back({row->command, at + wanted, come.first(wanted)});
    at += 1 + wanted;
    used += 1 + wanted;
    if (row->command == Command::end) {
      draw_buffered();
      return {std::move(receipt.drawn), Status::complete, at};
    }
    if (buffer_bytes - used < buffer_reserve) draw_buffered();
  }
  receipt.bytes_taken = stream.size();
  return receipt;
}

}  // namespace

TwinPicture run_twin(std::span<const std::uint8_t> stream, const Equipment& equipment) {
  const Receipt receipt = receive_stream(stream);
  TwinPicture picture;
  TwinDrawing drawing(picture, equipment);
  for (const ReceivedCommand& received : receipt.drawn) {
    if (drawing.obey(received)) continue;
    picture.status = Status::device_missing;
    picture.bytes_taken = received.last_byte + 1;
    return picture;
  }
  picture.status = receipt.status;
  picture.bytes_taken = receipt.bytes_taken;
  return picture;
}

}  // namespace sightline::programs::skala
