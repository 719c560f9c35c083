// A checked run of Skala's program: a command stream in, the picture on the emulated 8080 and its twin's out,
// and where they differ.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/programs/skala/guest.hpp"
#include "host/programs/skala/program.hpp"
#include "host/programs/skala/twin/twin.hpp"
#include "host/picture/pen_path.hpp"

namespace sightline::programs::skala {

struct CheckedPicture {
  GuestPicture guest;
  TwinPicture twin;  // with the one device that the machine has
  // As of difference_from_twin; empty: the same in everything.
  std::string difference;
};

// The resident program, assembled once, and as many pictures as are wanted.
class Session {
 public:
  Session() : program_(assemble_program()) {}

  [[nodiscard]] const Program& program() const { return program_; }
  // `stream` as stream_of makes it; any bytes are taken. Whether the program ended, how, and what the device
  // complained of is in the guest's picture.
  [[nodiscard]] CheckedPicture run(std::span<const std::uint8_t> stream,
                                   const GuestOptions& options = {}) const;

 private:
  Program program_;
};

// One path from each lowering of the pen to its lifting, in order; straight runs keep only their ends.
[[nodiscard]] std::vector<picture::PenPath> pen_paths(std::span<const PlotterMove> moves);

}  // namespace sightline::programs::skala
