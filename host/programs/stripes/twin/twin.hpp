// The native twin of firmware/i8080/stripes, written from its SPECIFICATION.md: dot for dot, step for step, for every stream of
// bytes. It also says what the machine's picture does not: which face each dot shows, and how the work went.
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
  std::vector<std::uint8_t> commands;  // of the plotter, in order
  std::vector<std::uint8_t> order;     // the priority list
  std::vector<std::pair<std::uint8_t, std::uint8_t>> cuts;  // face, what it is cut by
  std::vector<std::uint8_t> items;     // picture_size squared, from the lowest line: face + 1, 0 for none
  std::uint32_t seen_most = 0;  // toggles in a line of what is seen of a face
  Counts counts;
};

// The device of the stream's mode is there and makes no errors.
[[nodiscard]] TwinPicture run_twin(std::span<const std::uint8_t> stream);

}  // namespace sightline::programs::stripes
