// The hard cases J1 to J17 of cells and openings: scenes, and what must be seen in them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/report/report.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::harness::report {

using SceneSegment = std::pair<scene::PolyPoint, scene::PolyPoint>;

struct JonesHardCase {
  std::string_view id;    // "J5"
  std::string_view file;  // of hard_case_files(): a cell scene, or one of polyhedra
  std::string_view what;
  std::string_view expected;
  bool rejected = false;                               // every reader must refuse the file
  bool machine_rejects = false;                        // the program cannot stand there and must say so
  std::optional<std::uint64_t> cells = std::nullopt;   // visited, each counted once
  std::optional<std::uint64_t> visits = std::nullopt;  // of cells
  std::optional<std::uint64_t> sides = std::nullopt;   // most of any mask
  std::vector<SceneSegment> seen = {};                 // wholly
  std::vector<SceneSegment> hidden = {};               // wholly
  std::vector<scene::PolyCamera> cameras = {};         // for exact algorithms; none: the scene's own
  std::int32_t scale = 512;                            // S of the program
};

// In order.
[[nodiscard]] std::vector<JonesHardCase> jones_hard_cases();

// What is checked, in few words: "2 cells visited; 1 line seen, 1 hidden".
[[nodiscard]] std::string expected_value(const JonesHardCase& hard);

// What each build made of a case: a judgement, or in words why it does not apply.
struct JonesHardResult {
  Cell guest;
  Cell twin;
  Cell native;
  Cell exact;
  Cell oracle;
};
[[nodiscard]] JonesHardResult run_hard_case(const JonesHardCase& hard);

// Cases with a parameter: the first value with which each build fails.
[[nodiscard]] Outcome<Table> jones_families(const Context& context);

}  // namespace sightline::harness::report
