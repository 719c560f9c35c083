// Flights on an 8080 with the priority display (firmware/i8080/flight): what the machine of Willis's time could do. Times are the machine's.
//
//   flights    a scene, a number of pieces and bits of a coordinate, each. With 8 bits and the most pieces wrong points are counted,
//              and there is a picture.
#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host/guests/flight/path.hpp"
#include "host/guests/flight/session.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {

namespace {

struct FlownScene {
  const char* name;
  scene::PolyScene scene;
  bool plan;
};

template <class T>
T flown_value(base::Result<T>&& result, const char* name) {
  if (!result) throw Failure(ErrorKind::bad_input, fmt::format("{}: {}", name, result.error().message()));
  return std::move(*result);
}

picture::Image greys_of(std::span<const std::uint32_t> shown) {
  picture::Image image(devices::priority_display::columns, devices::priority_display::lines, 1);
  for (std::size_t i = 0; i < shown.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(shown[i] == 0 ? 255 : 90 + shown[i] * 53 % 120);
  return image;
}

}  // namespace

Records willis_flight(const Context& context) {
  namespace guest = guests::flight;
  constexpr std::uint32_t frames = 100;
  constexpr std::size_t all = 200;
  Records records;
  const guest::Session session;
  std::vector<FlownScene> scenes;
  scenes.push_back({"town-20", scene::generate_town(20), false});
  scenes.push_back({"prisms-25", scene::generate_prisms(25), true});
  for (const FlownScene& flown : scenes) {
    context.progress(fmt::format("{} flown through on the 8080", flown.name));
    const scene::SceneFrame frame = scene::frame_of(flown.scene.camera);
    const auto path = flown_value(guest::path_through(flown.scene, frame, frames, flown.plan), flown.name);
    algorithms::willis::ModelOptions model_options;
    model_options.plan = flown.plan;
    model_options.vertical = frame.vertical;
    for (const std::size_t pieces : {std::size_t{10}, std::size_t{20}, std::size_t{50}, std::size_t{100}, std::size_t{150}, all}) {
      const auto model = flown_value(guest::flight_model(flown.scene, model_options, path.front().eye, pieces), flown.name);
      for (const auto& [precision, bits] :
           {std::pair(guest::Precision::bits_8, 8), std::pair(guest::Precision::bits_12, 12), std::pair(guest::Precision::bits_16, 16)}) {
        const guest::Packed packed = guest::pack(model, path, precision);
        guest::FlightOptions options;
        std::optional<Picture> screen;
        options.count_points = pieces == all && bits == 8;
        if (options.count_points) {
          options.picture = [&screen](std::uint32_t number, std::span<const std::uint32_t> shown) {
            if (number == frames / 3) screen = png_picture(greys_of(shown));
          };
        }
        const guest::FlightRun run = session.run(model, path, packed, options);
        if (!run.difference.empty()) throw Failure(ErrorKind::differs, fmt::format("{}: {}", flown.name, run.difference));
        const guest::FlightSummary& sum = run.summary;
        records["flights"].add({{"scene", flown.name},
                                {"axes", packed.axes},
                                {"pieces", sum.pieces},
                                {"bits", bits},
                                {"frames_a_second", sum.frames_per_second_mean},
                                {"worst_frames_a_second", sum.frames_per_second_worst},
                                {"computed_a_second", sum.computed_per_second_mean},
                                {"worst_computed_a_second", sum.computed_per_second_worst},
                                {"t_states", sum.t_states_mean},
                                {"worst_t_states", sum.t_states_worst},
                                {"exchanged", sum.exchanges_mean},
                                {"most_exchanged", sum.exchanges_most},
                                {"pairs", sum.pairs},
                                {"wrong_orders", sum.wrong_orders},
                                {"wrong_points", options.count_points ? Value(sum.wrong_points) : Value()},
                                {"distance_error", packed.error_in_units},
                                {"screen", screen ? Value(*screen) : Value()}});
      }
    }
  }
  return records;
}

}  // namespace sightline::report
