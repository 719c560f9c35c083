// The bytes of the Skala program's command stream and the status it ends with: sections 1 and 9 of
// firmware/i8080/skala/SPECIFICATION.md. Nothing here says what the commands do.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace sightline::harness {

enum class SkalaCommand : std::uint8_t {
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

// Arguments that always come: for CURVE and SURFACE those up to and including the count n.
struct SkalaCommandRow {
  SkalaCommand command;
  std::string_view name;
  int leading_arguments;
  int bytes_per_item;  // what each of the n items that follow takes; 0 when the command has no list
};

inline constexpr std::array<SkalaCommandRow, 15> skala_commands{{
    {SkalaCommand::end, "END", 0, 0},
    {SkalaCommand::move, "MOVE", 2, 0},
    {SkalaCommand::draw, "DRAW", 2, 0},
    {SkalaCommand::test_draw, "TESTDRAW", 2, 0},
    {SkalaCommand::mask, "MASK", 2, 0},
    {SkalaCommand::colour, "COLOUR", 1, 0},
    {SkalaCommand::commit, "COMMIT", 0, 0},
    {SkalaCommand::reset, "RESET", 0, 0},
    {SkalaCommand::curve, "CURVE", 2, 1},
    {SkalaCommand::surface, "SURFACE", 1, 3},
    {SkalaCommand::device, "DEVICE", 1, 0},
    {SkalaCommand::rim, "RIM", 3, 0},
    {SkalaCommand::silhouette, "SILHOUETTE", 1, 0},
    {SkalaCommand::outline, "OUTLINE", 0, 0},
    {SkalaCommand::gap, "GAP", 2, 0},
}};

// Nothing for a byte that is no command.
[[nodiscard]] constexpr std::optional<SkalaCommandRow> skala_command(std::uint8_t byte) {
  if (byte >= skala_commands.size()) return std::nullopt;
  return skala_commands[byte];
}

// The counts n of CURVE, SURFACE and GAP: 1..255, and 0 for 256.
[[nodiscard]] constexpr int skala_count(std::uint8_t n) {
  return n == 0 ? 256 : n;
}

enum class SkalaDevice : std::uint8_t { ef9365, alt256, calcomp, minigraf };
inline constexpr std::uint8_t skala_no_visibility = 0x80;  // added to the argument of DEVICE

[[nodiscard]] constexpr bool is_raster(SkalaDevice device) {
  return device == SkalaDevice::ef9365 || device == SkalaDevice::alt256;
}

enum class SkalaStatus : std::uint8_t {
  running,
  complete,
  unknown_command,
  argument_out_of_range,
  link_error,
  device_error,
  device_missing,
};

inline constexpr std::array<std::string_view, 7> skala_status_texts{
    "running: waiting for more of the stream",
    "complete",
    "unknown command",
    "argument out of range",
    "overrun, framing or parity error on the serial link",
    "the raster board or plotter reported an error",
    "the device does not answer",
};

[[nodiscard]] constexpr std::string_view text_of(SkalaStatus status) {
  const auto number = static_cast<std::size_t>(status);
  return number < skala_status_texts.size() ? skala_status_texts[number] : "no status of this program";
}

// The buffer of section 9: drawn and used again when fewer than skala_buffer_reserve bytes are free after a
// command.
inline constexpr std::size_t skala_buffer_bytes = 49'152;
inline constexpr std::size_t skala_buffer_reserve = 800;

// The numbers of the commands are their places in the table.
static_assert([] {
  for (std::size_t i = 0; i < skala_commands.size(); ++i)
    if (static_cast<std::size_t>(skala_commands[i].command) != i) return false;
  return true;
}());

}  // namespace sightline::harness
