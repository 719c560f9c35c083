// The native twin of firmware/i8080/stripes, written from its SPECIFICATION.md: dot for dot, step for step, for every
// stream of bytes. It also gives data that the machine's picture lacks: the face shown at each dot, and counts of the work.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "emulators/core/raster.hpp"
#include "host/programs/stripes/counts.hpp"
#include "host/programs/stripes/status.hpp"

namespace sightline::programs::stripes {

struct TwinPicture {
  Status status = Status::running;
  std::uint8_t fault = 0;
  core::Raster raster;
  std::vector<std::uint8_t> commands;  // to the plotter, in order
  std::vector<std::uint8_t> order;     // the priority list
  std::vector<std::pair<std::uint8_t, std::uint8_t>> cuts;  // face, and the face that cuts it
  std::vector<std::uint8_t> items;     // picture_size squared, from the lowest line: face + 1, 0 for none; not with coverage
  std::uint32_t seen_most = 0;  // toggles in a line of the visible part of a face
  Counts counts;
};

// Assumes that the device of the stream's mode is present and makes no errors.
[[nodiscard]] TwinPicture run_twin(std::span<const std::uint8_t> stream, Build build = Build::plain);

}  // namespace sightline::programs::stripes
