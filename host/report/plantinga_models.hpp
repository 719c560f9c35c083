// The six models of Plantinga, Seales and Dyer (1990), ready to turn, for the parts of the report that need
// them.
//
// Finding the events of a turn takes seconds; Context::cache names a folder where the lists are kept for the
// next report, with the times they took. What is there is held against the model and its own checksum when it
// is read (event_file.hpp); a file that is damaged or of another model is made anew.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/report/report.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::harness::report {

// In the order of the paper's Table 1.
inline constexpr std::array<std::string_view, 6> plantinga_models{"squares", "grid", "objects",
                                                                  "bars",    "tori", "spring"};

// Without --full: those that take a second or so together.
[[nodiscard]] std::vector<std::string_view> plantinga_models_of(const Context& context);

// Errors: bad_input, if there is no model of that name or it is not as it should be.
[[nodiscard]] Outcome<scene::PolyScene> plantinga_scene(std::string_view name);

// Wall clock.
struct StudyTimes {
  double one_core_s = 0;
  double all_cores_s = 0;
};

struct StudiedModel {
  std::string name;
  algorithms::plantinga::RotationModel model;
  algorithms::plantinga::EventList list;
  std::optional<StudyTimes> times;  // nothing without Context::host_times
  bool from_cache = false;
};
// The same errors, and differs if the events are more than the limits.
[[nodiscard]] Outcome<StudiedModel> study_model(const Context& context, std::string_view name);

}  // namespace sightline::harness::report
