// The native twin of firmware/i8080/stripes, written from its SPECIFICATION.md: dot for dot, step for step, for every stream of
// bytes. It also says what the machine's picture does not: which face each dot shows, and how the work went.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "emulators/core/raster.hpp"
#include "host/programs/stripes/status.hpp"

namespace sightline::programs::stripes {

// Toggles of a line, ascending, below 255; without the 255 at the end.
using Toggles = std::vector<std::uint8_t>;

// The stripes of a face: lists from line `low` on.
struct Stripes {
  int low = 0;
  std::vector<Toggles> lines;

  friend bool operator==(const Stripes&, const Stripes&) = default;
};

// A corner as the stream has it: X and Y in 1/256 dot, Z.
struct Corner {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint16_t z = 0;

  [[nodiscard]] int line() const { return (y + 128) >> 8; }
  friend bool operator==(const Corner&, const Corner&) = default;
};
using CornerRings = std::vector<std::vector<Corner>>;

// Section 2, without its limit: a list may be longer than the program can hold, and `longest` says how long one was, also in between.
[[nodiscard]] Stripes stripes_of(const CornerRings& rings, std::size_t& longest);

struct TwinCounts {
  std::array<std::uint32_t, 7> decided_by{};  // pairs by the test that decided; 4 and 5 together with the coplanar ones in 4
  std::uint32_t relations = 0;
  std::uint32_t deleted = 0;           // relations on cycles of faces that have nothing in common
  std::uint32_t silhouette_most = 0;   // toggles in a line of the silhouette
  std::uint32_t face_most = 0;         // of a face
  std::uint32_t seen_most = 0;
  std::uint32_t dots = 0;              // shown
  std::uint32_t links = 0;             // drawn by the pen
};

struct TwinPicture {
  Status status = Status::running;
  std::uint8_t fault = 0;
  core::Raster raster;
  std::vector<std::uint8_t> commands;  // of the plotter, in order
  std::vector<std::uint8_t> order;     // the priority list
  std::vector<std::pair<std::uint8_t, std::uint8_t>> cuts;  // face, what it is cut by
  std::vector<std::uint8_t> items;     // picture_size squared, from the lowest line: face + 1, 0 for none
  TwinCounts counts;
};

// The device of the stream's mode is there and makes no errors.
[[nodiscard]] TwinPicture run_twin(std::span<const std::uint8_t> stream);

}  // namespace sightline::programs::stripes
