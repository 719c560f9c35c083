// Native twin of the Skala program on the 8080: the same dots, the same plotter movements in the same order
// and the same status for every command stream, written from firmware/i8080/skala/SPECIFICATION.md and from
// nothing else. It calls nothing of the emulator.
//
// Left out: time, the link (statuses 4 and 5 never come from here: bytes arrive without errors and no board
// or plotter is ever busy), and the levels of surfaces on plotters, which cannot show them. Where the
// specification leaves a case open that no host sends (a DEVICE in the middle of a picture, a SILHOUETTE
// later than directly after RESET), the twin does what its functions say and
// no comparison should rest on it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "emulators/core/raster.hpp"
#include "host/programs/skala/commands.hpp"

namespace sightline::programs::skala {

// What the columns of the screen hold, by x: section 2 of the specification.
struct Columns {
  std::array<std::uint8_t, 256> mask_top{};        // MT
  std::array<std::uint8_t, 256> mask_bottom{};     // MB
  std::array<std::uint8_t, 256> previous_y{};      // MP, of no meaning where the level is 0
  std::array<std::uint8_t, 256> previous_level{};  // IP
  std::array<std::uint8_t, 256> raised_from{};     // LT, 0: nothing has raised the top since the last fold
  std::array<std::uint8_t, 256> lowered_from{};    // HB, 255: nothing has lowered the bottom
};

enum class PlotterAction : std::uint8_t { step, pen_up, pen_down };

// One movement a plotter is told to make. x and y are the position of the pen after it, in steps from (0, 0); a
// step changes each by at most one.
struct PlotterMove {
  PlotterAction action = PlotterAction::step;
  std::uint8_t x = 0;
  std::uint8_t y = 0;
  bool pen_down = false;  // during a step; after a change of the pen

  friend bool operator==(const PlotterMove&, const PlotterMove&) = default;
};

struct TwinCounts {
  std::uint64_t points_walked = 0;   // steps of lines, curves, slices and outlines, seen or not
  std::uint64_t points_plotted = 0;  // dots written to a raster board, a dot written twice counted twice;
                                     // visible points on a plotter, dropped ones included
  std::uint64_t pen_lifts = 0;
  std::uint64_t steps_pen_down = 0;
  std::uint64_t steps_pen_up = 0;
};

struct TwinPicture {
  Status status = Status::running;
  // How many bytes of the stream the program has looked at; after an error the last of them is the offending
  // one.
  std::size_t bytes_taken = 0;
  std::array<core::Raster, 2> rasters{};  // of the EF9365 board and of the ALT-256 board
  std::vector<PlotterMove> moves;         // of the plotters, in order
  Columns columns;                        // at the end; the pending column is not folded in
  TwinCounts counts;

  // Of a raster device only.
  [[nodiscard]] const core::Raster& raster(Device device) const {
    return rasters[device == Device::alt256 ? 1 : 0];
  }
};

struct Equipment {
  std::array<bool, 4> present{true, true, true, true};  // by Device; the Minigraf always counts as present
};

// What has happened when the program has taken all bytes of `stream` it ever will. A stream without END ends
// in status `running`, and the contents of the buffer are not drawn then.
[[nodiscard]] TwinPicture run_twin(std::span<const std::uint8_t> stream, const Equipment& equipment = {});

}  // namespace sightline::programs::skala
