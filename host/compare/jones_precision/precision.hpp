// Jones's program in other arithmetic: the search of the twin with words of 12 to 36 bits, 0 to 8 fraction bits,
// rounding or truncating, or in floating point. With 18 bits it equals the twin, and with up to 3 fraction bits the
// program on the machine. So the error that arithmetic alone causes can be measured.
//
// A value that does not fit a word ends the view with "arithmetic overflow"; a scene is not scaled down to fit.
// Rules: firmware/pdp7/jones/SPECIFICATION.md; for words of other lengths, its section 8. The limits of the machine's
// core (stack, display file, 8192 words) still apply.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/base/result.hpp"
#include "host/programs/jones/encode.hpp"
#include "host/programs/jones/twin/twin.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::compare::jones_precision {

enum class NumberKind : std::uint8_t { fixed_point, single_float, double_float };

struct Precision {
  NumberKind kind = NumberKind::fixed_point;
  int word_bits = programs::jones::machine_word_bits;          // 12..36; of fixed point
  int fraction_bits = programs::jones::machine_fraction_bits;  // 0..8; of fixed point
  bool truncate = false;                      // for fixed point
  friend bool operator==(const Precision&, const Precision&) = default;
};
inline constexpr int shortest_word = 12;
inline constexpr int longest_word = 36;
inline constexpr int most_fraction_bits = 8;
[[nodiscard]] bool is_possible(const Precision& precision);
// "18 bits, f=1", "18 bits, f=1, truncated", "float", "double"
[[nodiscard]] std::string name(const Precision& precision);

// A vector of a cell or an opening as a line of the scene; from < to on its axis.
struct SceneLine {
  std::size_t axis = 0;  // 0, 1, 2: x, y, z
  geometry::Point from{};
  geometry::Point to{};
  friend bool operator==(const SceneLine&, const SceneLine&) = default;
};

// A piece after clipping, in points of the screen with their fraction.
struct PrecisePiece {
  std::uint16_t vector_address = 0;  // in core
  programs::jones::Pass pass = programs::jones::Pass::mono;
  algorithms::oracle::ScreenSegment line;
};

struct PreciseView {
  programs::jones::Status status = programs::jones::Status::complete;
  std::vector<PrecisePiece> pieces;  // in the order drawn, including those of length 0 on the screen
  std::size_t display_words = 0;
  programs::jones::TwinCounts counts;
};

// core, scene_header: as for the twin's run; fraction_bits and truncate of the parameters are ignored. precision:
// is_possible().
[[nodiscard]] PreciseView run_precisely(std::span<const core::Word18> core, std::uint32_t scene_header,
                                        const programs::jones::Parameters& parameters, const Precision& precision);

// The same, with each rounding by the machine's own words (true: the parameters' fraction_bits and truncate) or with
// 8 fraction bits (false).
[[nodiscard]] PreciseView run_mixed(std::span<const core::Word18> core, std::uint32_t scene_header,
                                    const programs::jones::Parameters& parameters,
                                    const std::array<bool, programs::jones::roundings>& of_machine, bool convex_masks = false);

// A scene in core without the program, its header at 0, and the line of each vector word.
struct SceneInCore {
  std::vector<core::Word18> core;
  std::vector<std::optional<SceneLine>> lines;  // by address
};
// Error: as for encode.
[[nodiscard]] base::Result<SceneInCore> scene_in_core(const scene::CellScene& scene,
                                                      const geometry::Point& eye);
// For an image in which the scene was encoded; core: the words by address.
[[nodiscard]] std::vector<std::optional<SceneLine>> lines_by_address(const programs::jones::EncodedScene& scene,
                                                                     std::span<const core::Word18> core);

}  // namespace sightline::compare::jones_precision
