// The bytes of the Skala program's command stream and the program's final status: sections 1 and 9 of
// firmware/i8080/skala/SPECIFICATION.md. The twin has the semantics of the commands.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace sightline::programs::skala {

enum class Command : std::uint8_t {
  end = 0x00,
  move = 0x01,       // x y
  draw = 0x02,       // x y
  test_draw = 0x03,  // x y
  mask = 0x04,       // x y
  colour = 0x05,     // c
  commit = 0x06,
  reset = 0x07,
  curve = 0x08,       // x n y1..yn
  surface = 0x09,     // n, n times x y level
  device = 0x0A,      // number, bit 7: no visibility test
  rim = 0x0B,         // x y level
  silhouette = 0x0C,  // c
  outline = 0x0D,
  gap = 0x0E,  // x n
};

// Arguments that are always present: for CURVE and SURFACE those up to and including the count n.
struct CommandRow {
  Command command;
  std::string_view name;
  int leading_arguments;
  int bytes_per_item;  // bytes of each of the n items that follow; 0 for a command without a list
};

inline constexpr std::array<CommandRow, 15> commands{{
    {Command::end, "END", 0, 0},
    {Command::move, "MOVE", 2, 0},
    {Command::draw, "DRAW", 2, 0},
    {Command::test_draw, "TESTDRAW", 2, 0},
    {Command::mask, "MASK", 2, 0},
    {Command::colour, "COLOUR", 1, 0},
    {Command::commit, "COMMIT", 0, 0},
    {Command::reset, "RESET", 0, 0},
    {Command::curve, "CURVE", 2, 1},
    {Command::surface, "SURFACE", 1, 3},
    {Command::device, "DEVICE", 1, 0},
    {Command::rim, "RIM", 3, 0},
    {Command::silhouette, "SILHOUETTE", 1, 0},
    {Command::outline, "OUTLINE", 0, 0},
    {Command::gap, "GAP", 2, 0},
}};

// nullopt for a byte that is no command.
[[nodiscard]] constexpr std::optional<CommandRow> find_command(std::uint8_t byte) {
  if (byte >= commands.size()) return std::nullopt;
  return commands[byte];
}

// The counts n of CURVE, SURFACE and GAP: 1..255, and 0 for 256.
[[nodiscard]] constexpr int count_of(std::uint8_t n) {
  return n == 0 ? 256 : n;
}

enum class Device : std::uint8_t { ef9365, alt256, calcomp, minigraf };
inline constexpr std::uint8_t no_visibility = 0x80;  // added to the argument of DEVICE

[[nodiscard]] constexpr bool is_raster(Device device) {
  return device == Device::ef9365 || device == Device::alt256;
}

// The output device of a stream.
struct Output {
  Device device = Device::ef9365;
  bool serpentine = true;  // plotters: chains are drawn from the end nearer to the pen
};

enum class Status : std::uint8_t {
  running,
  complete,
  unknown_command,
  argument_out_of_range,
  link_error,
  device_error,
  device_missing,
};

inline constexpr std::array<std::string_view, 7> status_texts{
    "running: waiting for more of the stream",
    "complete",
    "unknown command",
    "argument out of range",
    "overrun, framing or parity error on the serial link",
    "the raster board or plotter reported an error",
    "the device does not answer",
};

[[nodiscard]] constexpr std::string_view text_of(Status status) {
  const auto number = static_cast<std::size_t>(status);
  return number < status_texts.size() ? status_texts[number] : "no status of this program";
}

// The buffer of section 9: it is drawn and emptied when fewer than buffer_reserve bytes are free after a command.
inline constexpr std::size_t buffer_bytes = 49'152;
inline constexpr std::size_t buffer_reserve = 800;

// The number of a command is its index in the table.
static_assert([] {
  for (std::size_t i = 0; i < commands.size(); ++i)
    if (static_cast<std::size_t>(commands[i].command) != i) return false;
  return true;
}());

}  // namespace sightline::programs::skala
