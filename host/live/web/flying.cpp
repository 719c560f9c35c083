#include "host/live/web/flying.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/programs/flight/flight.hpp"
#include "host/live/web/requests.hpp"
#include "host/picture/face_shades.hpp"

namespace sightline::live::web {

namespace flight = programs::flight;

struct Flying::Journey {
  Journey(flight::Plan&& planned, flight::Precision precision, bool facing)
      : plan(std::move(planned)),
        run({.model = plan.model, .path = plan.path, .precision = precision, .facing = facing, .count_points = true, .shown = true, .check = true}) {}

  flight::Plan plan;
  flight::FlightInProgress run;
};

Flying::Flying() = default;
Flying::~Flying() = default;

Json Flying::make(const Workbench& workbench, const Json& request) {
  journey_.reset();
  const auto loaded = scene_named(workbench, text_of(request, "scene"));
  if (!loaded) return error_answer(loaded.error().message());
  const auto frames = static_cast<std::uint32_t>(std::clamp(number_of(request, "frames", 100), 2.0, 2000.0));
  const auto pieces = static_cast<std::size_t>(std::clamp(number_of(request, "pieces", flight::most_pieces), 1.0, double{flight::most_pieces}));
  const bool facing = flag_of(request, "facing");
  auto planned = flight::plan_flight(loaded->scene, flag_of(request, "plan"), frames, pieces, facing);
  if (!planned) return error_answer(planned.error().message());
  const double bits = number_of(request, "bits", 8);
  const auto precision = bits > 12 ? flight::Precision::bits_16 : bits > 8 ? flight::Precision::bits_12 : flight::Precision::bits_8;
  journey_ = std::make_unique<Journey>(std::move(*planned), precision, facing);

  Json shades = Json::array();
  const auto number = [](const picture::Shade& shade) { return shade[0] << 16 | shade[1] << 8 | shade[2]; };
  shades.push_back(number(picture::sky));
  for (const picture::Shade& shade : picture::face_shades(loaded->scene)) shades.push_back(number(shade));
  const flight::Plan& made = journey_->plan;
  const flight::Packed& packed = journey_->run.outcome().packed;
  return Json{{"pieces", made.model.pieces.size()},
              {"surfaces", made.model.surfaces},
              {"frames", made.path.size()},
              {"stream", packed.stream.size()},
              {"coordinate_step", packed.step_in_units},
              {"distance_error", packed.error_in_units},
              {"shades", std::move(shades)}};
}

// The counts of all frames so far, and of the last frame.
Json Flying::state() const {
  if (journey_ == nullptr) return error_answer("nothing flies");
  const flight::Outcome& run = journey_->run.outcome();
  const flight::Summary& sum = run.summary;
  Json state{{"ended", run.flight.ended},
             {"status", flight::text_of(run.flight.status)},
             {"difference", journey_->run.difference()},
             {"t_states", run.flight.total.count()},
             {"frames", run.frames.size()},
             {"frames_per_second_mean", sum.frames_per_second_mean},
             {"frames_per_second_worst", sum.frames_per_second_worst},
             {"t_states_mean", sum.t_states_mean},
             {"t_states_worst", sum.t_states_worst},
             {"pairs_exchanged_mean", sum.exchanges_mean},
             {"wrong_orders", sum.wrong_orders},
             {"pairs", sum.pairs},
             {"wrong_points", sum.wrong_points},
             {"frames_with_wrong_points", sum.frames_wrong}};
  if (!run.frames.empty()) {
    const flight::Frame& frame = run.frames.back();
    state["frame"] = Json{{"shown_ms", frame.shown.time_since_epoch().count() / 1'000'000}, {"t_states", frame.computing.count()},
                          {"waiting", frame.waiting.count()},   {"moved", frame.moved},
                          {"exchanges", frame.exchanges},       {"facing", frame.facing},
                          {"with_key", frame.listed},           {"appeared", frame.turned.appeared},
                          {"vanished", frame.turned.vanished},
                          {"wrong_orders", frame.wrong_orders}, {"wrong_points", frame.wrong_points}};
  }
  return state;
}

Json Flying::answer(const Workbench& workbench, std::string_view what, const Json& request) {
  if (what == "flight") return make(workbench, request);
  if (what == "flight_state") return state();
  return {};
}

bool Flying::run(std::int64_t t_states) {
  if (journey_ == nullptr) return false;
  flight::FlightInProgress& flight = journey_->run;
  flight.run(std::min(core::at_t_state(t_states), flight.latest_end()));
  return !flight.ended() && flight.now() < flight.latest_end();
}

std::int64_t Flying::t_states() const { return journey_ != nullptr ? journey_->run.now().time_since_epoch().count() : 0; }

std::span<const std::uint32_t> Flying::picture() {
  if (journey_ == nullptr) return {};
  return journey_->run.picture();
}

}  // namespace sightline::live::web
