// The line pieces that Jones's program draws on the emulated PDP-7, taken out of its core as it draws them:
// which vector word, where the piece lies in the program's own fraction of a point, and between which points
// of the screen.
//
// The machine has no display, and the clock is off. Source of the labels: firmware/pdp7/jones/NOTES.md.
#pragma once

#include <cstdint>
#include <vector>

#include "emulators/core/time.hpp"
#include "host/programs/jones/program.hpp"
#include "host/programs/jones/twin/twin.hpp"

namespace sightline::programs::jones {

struct GuestPieces {
  Status status = Status::unfinished;     // no view within the limit of time
  std::vector<Piece> clipped;             // as the twin's View::clipped
  std::vector<ScreenSegment> on_display;  // of each in clipped: its ends, points of the screen
  core::Duration time{};                  // of the view
};

// program: assembled for a machine with the EAE or without, as `eae` says. scale: 64..4096. One eye only.
[[nodiscard]] GuestPieces run_for_pieces(const Program& program, bool eae, std::int32_t scale = 512);

}  // namespace sightline::programs::jones
