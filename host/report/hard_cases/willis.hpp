// The hard cases W1 to W16 of distance as priority: scenes, mostly walls in plan, and what must come of them.
//
// Walls are sheets, seen from both sides: two surfaces, so that every cluster of the paper's one-sided walls
// counts twice.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/willis/model.hpp"
#include "host/report/report.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::harness::report {

// What must be so of a scene and its model besides the picture; the text says what was found.
using WillisFacts = Verdict (*)(const scene::PolyScene&, const algorithms::willis::Model&);

enum class WillisEnd {
  solved,     // no pair is left over
  left_over,  // some are, because they touch, and are named
  refused,    // the eye is in no place to look from
};

struct WillisHardCase {
  std::string_view id;    // "W6"
  std::string_view file;  // of hard_case_files()
  std::string_view what;
  std::string_view expected;
  std::string_view checked;
  WillisFacts facts = nullptr;
  WillisEnd end = WillisEnd::solved;
  algorithms::willis::ModelOptions options{.plan = true};
  std::optional<std::size_t> clusters = std::nullopt;
};

// In order.
[[nodiscard]] std::vector<WillisHardCase> willis_hard_cases();

struct WillisHardResult {
  Cell facts;
  Cell build;    // solved, left over and named, or refused
  Cell picture;  // against the nearest face of every point, from several places
};
[[nodiscard]] WillisHardResult run_hard_case(const WillisHardCase& hard);

// Their table, and W10 for walls of lengths from 10 to 10000.
[[nodiscard]] Table willis_table(const Context& context);
[[nodiscard]] Table willis_lengths(const Context& context);

}  // namespace sightline::harness::report
