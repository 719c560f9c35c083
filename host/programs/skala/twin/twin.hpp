// Native twin of the Skala program on the 8080: the same dots, the same plotter movements in the same order and the same
// status for every command stream, written only from firmware/i8080/skala/SPECIFICATION.md. It uses no code of the
// emulator.
//
// Left out: time, the link (statuses 4 and 5 never occur here: bytes arrive without errors, and no board or plotter is ever
// busy), and the levels of surfaces on plotters, which cannot show them. Where the specification leaves a case open that no
// host sends (a DEVICE in the middle of a picture, a SILHOUETTE later than directly after RESET), the result of the twin is
// arbitrary and must not be compared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "emulators/core/raster.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/programs/skala/picture.hpp"

namespace sightline::programs::skala {

struct TwinPicture {
  Status status = Status::running;
  // The number of bytes that the program has examined; after an error the last of them is the wrong one.
  std::size_t bytes_taken = 0;
  std::array<core::Raster, 2> rasters{};  // of the EF9365 board and of the ALT-256 board
  std::vector<PlotterMove> moves;         // of the plotters, in order
  Columns columns;                        // at the end; the pending column is not folded in
  Counts counts;

  // Only for a raster device.
  [[nodiscard]] const core::Raster& raster(Device device) const {
    return rasters[device == Device::alt256 ? 1 : 0];
  }
};

struct Equipment {
  std::array<bool, 4> present{true, true, true, true};  // by Device; the Minigraf always counts as present
  bool direct_masks = false;                            // the build without M1T and M1B (SPECIFICATION, section 10)
};

// The result after the program has received all bytes of `stream` that it ever will. A stream without END ends with status
// `running`; the buffered commands are not drawn.
[[nodiscard]] TwinPicture run_twin(std::span<const std::uint8_t> stream, const Equipment& equipment = {});

}  // namespace sightline::programs::skala
