// The hard cases P1 to P22 of events of a turning scene: a few edges and vertices whose events are asked for
// (.txt), scenes that turn (.json), and models.
//
// Edges and vertices stand in a file one a line: "edge x y z  x y z", "vertex x y z"; "#" begins a remark.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/algorithms/plantinga/potential_events.hpp"
#include "host/base/result.hpp"
#include "host/report/report.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::harness::report {

struct EventLines {
  std::vector<algorithms::plantinga::Vector3> vertices;
  std::vector<algorithms::plantinga::Segment> edges;
};
// The error names the line, and what was expected.
[[nodiscard]] base::Result<EventLines> read_event_lines(std::string_view text);

// The events of every vertex with every edge; without vertices of three edges, or of the ends of two with
// each other. whole_lines: of three, wherever their lines meet. Ascending, equal ones once.
[[nodiscard]] std::vector<algorithms::plantinga::Direction> events_of(const EventLines& lines,
                                                                      bool whole_lines);
// How many directions they are, and everything computed, in doubles.
[[nodiscard]] std::size_t event_count_in_doubles(const EventLines& lines, bool whole_lines);

struct TurnedScene {
  scene::PolyScene scene;
  algorithms::plantinga::RotationModel model;
  algorithms::plantinga::EventList list;
};
using TurnCheck = std::optional<std::string> (*)(const TurnedScene&);

struct PlantingaHardCase {
  std::string_view id;    // "P5"
  std::string_view file;  // of hard_case_files(); empty: one of the paper's models, or its table
  std::string_view what;
  std::string_view expected;
  std::string_view checked;
  // Of edges and vertices.
  std::size_t directions = 0;
  std::vector<std::array<std::int64_t, 2>> there{};  // X : Z, exactly
  std::vector<std::array<std::int64_t, 2>> not_there{};
  std::vector<double> tangents{};                                  // of some, to nine places
  std::optional<std::array<std::int64_t, 3>> form = std::nullopt;  // of three edges, but for its sign
  bool whole_lines = false;
  // Of scenes, beside what is asked of all.
  TurnCheck turn = nullptr;
  std::string_view model = {};  // of plantinga_models
  // Of neither.
  std::optional<std::string> (*table)() = nullptr;
};

// In order.
[[nodiscard]] std::vector<PlantingaHardCase> plantinga_hard_cases();

[[nodiscard]] Outcome<Table> plantinga_cases(const Context& context);
// Nearly equal angles: the first separation that doubles alone get wrong.
[[nodiscard]] Table plantinga_families(const Context& context);

}  // namespace sightline::harness::report
