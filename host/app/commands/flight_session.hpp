// What `sightline flight`, `demo` and their tests share: a flight through a scene on the 8080, checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/willis/model.hpp"
#include "host/programs/flight/session.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

struct PlannedFlight {
  algorithms::willis::Model model;
  std::vector<scene::PolyCamera> path;
};

// `source` names the scene in errors. Error bad_input: no such flight, or a model that does not fit, by how much.
[[nodiscard]] PlannedFlight planned_flight(const scene::PolyScene& scene, const std::string& source, bool plan, std::uint32_t frames,
                                           std::optional<std::size_t> pieces);

// Error differs: a priority is not the twin's; guest_failed: the program did not end as it should.
[[nodiscard]] programs::flight::FlightRun checked_flight(const programs::flight::Session& session, const PlannedFlight& flight,
                                                       const programs::flight::Packed& packed, const std::string& source,
                                                       const programs::flight::FlightOptions& options);

}  // namespace sightline::app
