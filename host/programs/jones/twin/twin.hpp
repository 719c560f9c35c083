// Native twin of Jones's program on the PDP-7: the same display words and the same status for every scene, view, mode and
// build, written only from firmware/pdp7/jones/SPECIFICATION.md (sections 1, 4, 5, 7 and 10). It reads the data elements from
// an image of core, as the machine does, and uses no code of the emulator.
//
// Left out: time, and everything between views (section 6: switches, clock, the two display files). The search is Jones
// (1971), "The algorithm"; it keeps an explicit stack, as his program does.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "emulators/core/word.hpp"
#include "host/programs/jones/specification.hpp"
#include "host/programs/jones/twin/arithmetic.hpp"
#include "host/programs/jones/twin/rotation.hpp"

namespace sightline::programs::jones {

struct Parameters {
  SpacePoint eye;                             // object units
  std::int32_t scale = 512;                   // S, 64..4096
  bool stereo = false;                        // AC switch 17
  bool immediate = false;                     // AC switch 16: lines are added at once
  std::uint64_t limit = 100'000'000;          // vectors and list entries examined before the twin gives up
  int fraction_bits = machine_fraction_bits;  // 0..3: -D FRACTION of the program
  bool truncate = false;                      // -D TRUNCATE
  std::optional<Direction> direction;         // of the view: -D ROTATE
};
// Eye of the scene header; scale 512, mono.
[[nodiscard]] Parameters default_parameters(std::span<const core::Word18> core, std::uint32_t scene_header);

struct TwinCounts {
  std::uint64_t visits = 0;
  std::uint64_t distinct_cells = 0;
  std::uint64_t openings_tested = 0;
  std::uint64_t openings_crossing = 0;  // the eye strictly on the near side
  std::uint64_t masks_made = 0;         // openings that were entered
  std::uint64_t vectors = 0;            // vector words in chains and rings
  std::uint64_t lines_clipped = 0;
  std::uint64_t pieces = 0;
  std::uint64_t fresh_coordinates = 0;  // projected coordinates not known from the point before in the chain
  int depth = 0;
  int stack_words = 0;
  int mask_vertices = 0;
  double largest_coordinate = 0;  // magnitude, points, before clipping
  Operations operations;
};

template <class Coordinate>
struct BasicView {
  Status status = Status::complete;
  std::vector<core::Word18> display_file;       // includes the stop word
  std::vector<BasicPiece<Coordinate>> pieces;   // drawn, in the order drawn
  std::vector<BasicPiece<Coordinate>> clipped;  // all that left the clip, drawn or without length
  TwinCounts counts;
};
using TwinView = BasicView<std::int32_t>;

// core: 8192 words; words beyond the end of a shorter image read as zero. scene_header: address of the header of section 7;
// addresses wrap at 13 bits. The eye must lie in the initial cell: it is not checked here, as on the machine.
[[nodiscard]] TwinView run_twin(std::span<const core::Word18> core, std::uint32_t scene_header, const Parameters& parameters);

}  // namespace sightline::programs::jones
