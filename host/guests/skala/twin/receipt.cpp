#include "host/guests/skala/twin/receipt.hpp"

#include <utility>

namespace sightline::harness {
namespace {

// The first argument that is out of range, counted from 0, or -1. Only arguments that always come are ever
// checked.
[[nodiscard]] int offending_argument(SkalaCommand command, std::span<const std::uint8_t> arguments) {
  switch (command) {
    case SkalaCommand::curve:
    case SkalaCommand::gap:
      return arguments.size() >= 2 && arguments[0] + skala_count(arguments[1]) > 256 ? 1 : -1;
    case SkalaCommand::device:
      return !arguments.empty() && (arguments[0] & ~skala_no_visibility) > 3 ? 0 : -1;
    default: return -1;
  }
}

// How many arguments the command at hand has, as far as those that have come tell.
[[nodiscard]] std::size_t arguments_wanted(const SkalaCommandRow& row,
                                           std::span<const std::uint8_t> arguments) {
  const auto leading = static_cast<std::size_t>(row.leading_arguments);
  if (row.bytes_per_item == 0 || arguments.size() < leading) return leading;
  return leading + static_cast<std::size_t>(skala_count(arguments[leading - 1]) * row.bytes_per_item);
}

}  // namespace

SkalaReceipt receive_skala_stream(std::span<const std::uint8_t> stream) {
  SkalaReceipt receipt;
  std::vector<SkalaReceivedCommand> buffered;
  std::size_t used = 0;
  const auto draw_buffered = [&] {
    receipt.drawn.insert(receipt.drawn.end(), buffered.begin(), buffered.end());
    buffered.clear();
    used = 0;
  };
  for (std::size_t at = 0; at < stream.size();) {
    const auto row = skala_command(stream[at]);
    if (!row) return {std::move(receipt.drawn), SkalaStatus::unknown_command, at + 1};
    const auto come = stream.subspan(at + 1);
    if (const int bad = offending_argument(row->command, come); bad >= 0)
      return {std::move(receipt.drawn), SkalaStatus::argument_out_of_range,
              at + 2 + static_cast<std::size_t>(bad)};
    const std::size_t wanted = arguments_wanted(*row, come);
    if (come.size() < wanted) break;
    buffered.push_back({row->command, at + wanted, come.first(wanted)});
    at += 1 + wanted;
    used += 1 + wanted;
    if (row->command == SkalaCommand::end) {
      draw_buffered();
      return {std::move(receipt.drawn), SkalaStatus::complete, at};
    }
    if (skala_buffer_bytes - used < skala_buffer_reserve) draw_buffered();
  }
  receipt.bytes_taken = stream.size();
  return receipt;
}

}  // namespace sightline::harness
