// The six models of Plantinga, Seales and Dyer (1990), ready to turn, for the experiments that need them.
//
// Finding the events of a turn takes seconds. Context::cache names a folder that stores the lists for the next
// report, with the times they took. A list is checked against the model and its own checksum when it is read
// (event_file.hpp). A file that is damaged or belongs to another model is made again.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/plantinga/event_list.hpp"
#include "host/report/experiment.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::report {

// Without --full: those whose events take about a second in all.
[[nodiscard]] std::vector<std::string_view> plantinga_models_of(const Context& context);
// The models whose error is measured.
[[nodiscard]] std::vector<std::string_view> plantinga_turned_models(const Context& context);

// Degrees: angle tolerances of event lists, and steps from frame to frame.
inline constexpr std::array plantinga_tolerances{0.0, 0.001, 0.01, 0.1, 1.0};
inline constexpr std::array plantinga_steps{0.01, 0.1, 1.0, 3.0, 10.0, 30.0};

// Throws base::Error (bad_input) if there is no model of that name or it cannot be used.
[[nodiscard]] scene::PolyScene plantinga_scene(std::string_view name);

// Wall-clock times.
struct StudyTimes {
  double one_core_s = 0;
  double all_cores_s = 0;
};

struct StudiedModel {
  std::string name;
  algorithms::plantinga::RotationModel model;
  algorithms::plantinga::EventList list;
  std::optional<StudyTimes> times;  // empty without Context::host_times
  bool from_cache = false;
};
// Throws the same, and base::Error (differs) if there are more events than the limit.
[[nodiscard]] StudiedModel study_model(const Context& context, std::string_view name);

}  // namespace sightline::report
