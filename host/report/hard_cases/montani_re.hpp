// The hard cases M1 to M18 of stripes and priority lists: scenes of sheets seen along z, and regions on the
// lattice as chains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/report/report.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::harness::report {

// What is to come of one or two regions of a file of chains.
struct LatticeExpected {
  enum class Combination { first, both, either, less };  // A; A and B; A or B; A less B
  Combination combination = Combination::first;
  std::int64_t eighths = 0;  // of a square step: its area
  std::size_t loops = 0;     // outlines and holes
};

struct MontaniReHardCase {
  std::string_view id;    // "M3"
  std::string_view file;  // of hard_case_files(): a scene (.json), or chains (.txt)
  std::string_view what;
  std::string_view expected;
  // Scenes.
  std::vector<double> areas = {};  // seen of each body, in their order; sides along the lattice
  std::optional<std::uint64_t> relations = std::nullopt;
  std::optional<std::uint64_t> cuts = std::nullopt;   // of cycles
  std::optional<std::uint64_t> parts = std::nullopt;  // cut off faces that hide each other
  std::optional<std::uint64_t> edge_on = std::nullopt;
  std::optional<std::uint64_t> by_test_3 = std::nullopt;
  std::string_view list = {};  // "S,E / U,C": names of bodies by class
  std::optional<std::pair<std::size_t, std::size_t>> through = std::nullopt;  // bodies; to be refused
  bool whole_silhouette = false;  // coplanar faces hide each other in one silhouette only
  bool on_lines = false;          // all corners lie between stripes of 8: every thickness is exact
  // Chains.
  std::vector<LatticeExpected> regions = {};
};

// In order.
[[nodiscard]] std::vector<MontaniReHardCase> montani_re_hard_cases();

// What is checked, in few words: "seen areas 200, 200, 400; 1 cut".
[[nodiscard]] std::string expected_value(const MontaniReHardCase& hard);

// What each build made of a case: a judgement, or in words why it does not apply.
struct MontaniReHardResult {
  Cell native;   // the exact build
  Cell stripes;  // of a pixel
  Cell exact;
  Cell oracle;
};
[[nodiscard]] MontaniReHardResult run_hard_case(const MontaniReHardCase& hard);
// Of chains only.
[[nodiscard]] MontaniReHardResult run_lattice_case(const MontaniReHardCase& hard);

// What is wrong with the lines of the exact build in the scene's own view; nothing if they are the true ones,
// or the view is one it does not claim to draw.
[[nodiscard]] std::optional<std::string> wrong_lines(const scene::PolyScene& scene,
                                                     const picture::LinePicture& truth);

[[nodiscard]] Table montani_re_cases(const Context& context);
// Pinwheels of 3 to 12 bars, and a sliver that becomes lower and lower: the first with which each build
// fails.
[[nodiscard]] Table montani_re_families(const Context& context);

}  // namespace sightline::harness::report
