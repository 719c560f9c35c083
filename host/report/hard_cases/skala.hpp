// The hard cases S1 to S16 of slices on a raster: grids of heights, and lists of the program's commands.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/oracle/column_oracle.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/guests/skala/view.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/report/report.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::harness::report {

// What was found, if it is not what is expected.
using Complaint = std::optional<std::string>;

struct SkalaHardCase {
  std::string_view id;    // "S4"
  std::string_view file;  // of hard_case_files(): a grid, or commands (.txt); empty: made when it is run
  std::string_view what;
  std::string_view expected;
  std::string_view value;  // what is checked, beside the oracle's picture
  // Grids.
  guests::skala::View view{};
  Complaint (*dots)(const scene::HeightGrid&, const guests::skala::View&,
                    const picture::PixelGrid&) = nullptr;
  Complaint (*lines)(const scene::HeightGrid&,
                     const picture::VectorDrawing&) = nullptr;  // of the native picture
  int columns = 4096;                                           // of its masks
  // Commands: the chains they are, nearest first by depth.
  std::vector<algorithms::oracle::Chain> chains{};
  std::optional<std::size_t> lit = std::nullopt;  // dots, counted by hand
};

[[nodiscard]] std::vector<SkalaHardCase> skala_hard_cases();

struct SkalaHardResult {
  Cell guest;
  Cell twin;
  Cell native;
  Cell oracle;
};
[[nodiscard]] SkalaHardResult run_hard_case(const SkalaHardCase& hard);

// Of commands only.
[[nodiscard]] SkalaHardResult run_commands(const SkalaHardCase& hard);
// S7: all lines of up to 16 steps in both directions, each from either end.
[[nodiscard]] SkalaHardResult run_all_octants();

// How far from the exact crossing the farther of two lines appears, for slopes that differ by 1 / parameter;
// and the masks native Skala can be given.
[[nodiscard]] Outcome<Table> skala_families(const Context& context);

}  // namespace sightline::harness::report
