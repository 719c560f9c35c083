#include "host/app/commands/flight_session.hpp"

#include <fmt/core.h>

#include <utility>

#include "host/app/command.hpp"
#include "host/programs/flight/path.hpp"

namespace sightline::app {

namespace flight = programs::flight;

namespace {

template <class T>
T flight_value(base::Result<T>&& result, const std::string& source) {
  if (result) return std::move(*result);
  base::Error error = result.error();
  error.file = source;
  throw base::bad_input(error.message());
}

}  // namespace

PlannedFlight planned_flight(const scene::PolyScene& scene, const std::string& source, bool plan, std::uint32_t frames,
                             std::optional<std::size_t> pieces) {
  const scene::SceneFrame frame = scene::frame_of(scene.camera);
  PlannedFlight planned;
  planned.path = flight_value(flight::path_through(scene, frame, frames, plan), source);
  algorithms::willis::ModelOptions options;
  options.plan = plan;
  options.vertical = frame.vertical;
  planned.model = flight_value(flight::flight_model(scene, options, planned.path.front().eye, pieces), source);
  return planned;
}

flight::FlightRun checked_flight(const flight::Session& session, const PlannedFlight& planned, const flight::Packed& packed,
                                 const std::string& source, const flight::FlightOptions& options) {
  flight::FlightRun run = session.run(planned.model, planned.path, packed, options);
  if (!run.difference.empty())
    throw base::difference(fmt::format("{}: internal error: a priority on the 8080 is not the one its native twin computes: {}", source, run.difference));
  if (run.guest.status != flight::Status::complete)
    throw base::program_failed(fmt::format("{}: the program stopped: {}", source, flight::text_of(run.guest.status)));
  return run;
}

}  // namespace sightline::app
