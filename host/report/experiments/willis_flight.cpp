#include "host/report/experiments/willis_flight.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host/base/value_of.hpp"
#include "host/programs/flight/path.hpp"
#include "host/programs/flight/flight.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/page.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {

namespace {

constexpr std::uint32_t usual_frames = 100;
constexpr std::uint32_t fast_frames = 60;

struct FlownScene {
  const char* name;
  scene::PolyScene scene;
  bool plan;
};

template <class T>
T flown_value(base::Result<T>&& result, const char* name) {
  if (!result) throw base::bad_input(fmt::format("{}: {}", name, result.error().message()));
  return std::move(*result);
}

picture::Image greys_of(std::span<const std::uint32_t> shown) {
  picture::Image image(devices::priority_display::columns, devices::priority_display::lines, 1);
  for (std::size_t i = 0; i < shown.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(shown[i] == 0 ? 255 : 90 + shown[i] * 53 % 120);
  return image;
}

// 25 frames per second, except for rounding.
bool reaches_25(const WillisFlight& flight) {
  return flight.worst_frames_a_second >= 24.9;
}

// Empty if no flight reaches 25 frames per second.
std::optional<std::uint32_t> most_pieces(const std::vector<WillisFlight>& flights,
                                         const std::function<bool(const WillisFlight&)>& holds) {
  const auto chosen = where(flights, [&](const WillisFlight& f) { return reaches_25(f) && holds(f); });
  return chosen.empty() ? std::nullopt : std::optional(greatest(chosen, &WillisFlight::pieces));
}

void add_claims(Page& page, const std::vector<WillisFlight>& flights) {
  const double rate = page.paper_figure("willis.rate").least;
  const double hundreds = page.paper_figure("willis.surfaces").least;
  const auto pieces = range_of(flights, &WillisFlight::pieces);
  const auto of_8_bits = where(flights, equals(&WillisFlight::bits, 8));
  const auto of_16_bits = where(flights, equals(&WillisFlight::bits, 16));
  const auto keeps_up = [rate](const auto& chosen) { return least(chosen, &WillisFlight::worst_frames_a_second) >= 0.99 * rate; };
  const auto most_of_16_bits = [&flights](std::size_t axes) {
    return text_of(most_pieces(flights, [axes](const WillisFlight& f) { return f.bits == 16 && f.axes == axes; }));
  };
  const auto most = most_pieces(flights, [](const WillisFlight&) { return true; });
  page.claims("willis-flight-claims", "25 frames a second, on an 8080 at 3 MHz",
              {{.claim = "willis.rate",
                .here = least_and_greatest(of_8_bits, &WillisFlight::worst_frames_a_second),
                .places = 1,
                .condition =
                    fmt::format("worst frame of flights of {} frames past {} to {} pieces, coordinates of 8 bits; the display "
                                "itself shows 25",
                                usual_frames, pieces.least, pieces.greatest),
                .comparison = keeps_up(of_8_bits) ? "reached in every frame"
                                                  : fmt::format("reached in every frame of {} of {} flights",
                                                                count(of_8_bits, &reaches_25), of_8_bits.size())},
               {.claim = "willis.rate",
                .here = least_and_greatest(of_16_bits, &WillisFlight::worst_frames_a_second),
                .places = 1,
                .condition = "the same with coordinates of 16 bits",
                .comparison = keeps_up(of_16_bits) ? "reached in every frame"
                                                   : fmt::format("reached in every frame up to {} pieces in space, {} in plan",
                                                                 most_of_16_bits(3), most_of_16_bits(2))},
               {.claim = "willis.rate",
                .here = least_and_greatest(of_8_bits, &WillisFlight::fast_worst_frames_a_second),
                .places = 1,
                .condition = fmt::format("worst frame of the same ways flown in {} frames, {} pieces, coordinates of 8 bits",
                                         fast_frames, pieces.greatest),
                .comparison = fmt::format("{} to {} in the mean frame",
                                          text_of(least(of_8_bits, &WillisFlight::fast_frames_a_second), 1),
                                          text_of(greatest(of_8_bits, &WillisFlight::fast_frames_a_second), 1))},
               {.claim = "willis.surfaces",
                .here = {as_cell(most), as_cell(most)},
                .condition = fmt::format("most pieces at 25 frames a second, flights of {} frames", usual_frames),
                .comparison = most.value_or(0) >= hundreds ? "hundreds, though not many" : "not hundreds"}});
}

}  // namespace

std::vector<WillisFlight> willis_flight(const Context& context) {
  namespace flight = programs::flight;
  constexpr std::size_t all = 200;
  std::vector<WillisFlight> flights;
  std::vector<FlownScene> scenes;
  scenes.push_back({"town-20", scene::generate_town(20), false});
  scenes.push_back({"prisms-25", scene::generate_prisms(25), true});
  for (const FlownScene& flown : scenes) {
    context.progress(fmt::format("{} flown through on the 8080", flown.name));
    const scene::SceneFrame frame = scene::frame_of(flown.scene.camera);
    const auto path = flown_value(flight::path_through(flown.scene, frame, usual_frames, flown.plan), flown.name);
    const auto fast_path = flown_value(flight::path_through(flown.scene, frame, fast_frames, flown.plan), flown.name);
    algorithms::willis::ModelOptions model_options;
    model_options.plan = flown.plan;
    model_options.vertical = frame.vertical;
    for (const std::size_t pieces :
         {std::size_t{10}, std::size_t{20}, std::size_t{50}, std::size_t{100}, std::size_t{150}, all}) {
      const auto model = flown_value(flight::flight_model(flown.scene, model_options, path.front().eye, pieces), flown.name);
      for (const auto& [precision, bits] : {std::pair(flight::Precision::bits_8, 8), std::pair(flight::Precision::bits_12, 12),
                                            std::pair(flight::Precision::bits_16, 16)}) {
        flight::Order order{.model = model, .path = path, .precision = precision, .check = true};
        std::optional<Picture> screen;
        order.count_points = pieces == all && bits == 8;
        if (order.count_points) {
          order.picture = [&screen](std::uint32_t number, std::span<const std::uint32_t> shown) {
            if (number == usual_frames / 3) screen = png_picture(greys_of(shown));
          };
        }
        const flight::Outcome run = base::value_of(flight::run(order), flown.name);
        const flight::Packed& packed = run.packed;
        const flight::Summary& sum = run.summary;
        flights.push_back({.scene = flown.name,
                           .axes = packed.axes,
                           .pieces = sum.pieces,
                           .bits = bits,
                           .frames_a_second = sum.frames_per_second_mean,
                           .worst_frames_a_second = sum.frames_per_second_worst,
                           .computed_a_second = sum.computed_per_second_mean,
                           .worst_computed_a_second = sum.computed_per_second_worst,
                           .t_states = sum.t_states_mean,
                           .worst_t_states = sum.t_states_worst,
                           .exchanged = sum.exchanges_mean,
                           .most_exchanged = sum.exchanges_most,
                           .pairs = sum.pairs,
                           .wrong_orders = sum.wrong_orders,
                           .distance_error = packed.error_in_units,
                           .wrong_points = order.count_points ? std::optional(sum.wrong_points) : std::nullopt,
                           .screen = std::move(screen)});
        if (pieces != all) continue;
        const flight::Outcome fast =
            base::value_of(flight::run({.model = model, .path = fast_path, .precision = precision, .check = true}), flown.name);
        flights.back().fast_frames_a_second = fast.summary.frames_per_second_mean;
        flights.back().fast_worst_frames_a_second = fast.summary.frames_per_second_worst;
      }
    }
  }
  return flights;
}

void willis_flight_chapter(Page& page, const std::vector<WillisFlight>& flights) {
  add_claims(page, flights);
  const std::uint64_t wrong_points = greatest(flights, &WillisFlight::wrong_points);
  const double of_100 = least(where(flights, equals(&WillisFlight::pieces, 100U)), &WillisFlight::frames_a_second);
  page.table(
      "willis-flights", "Willis on an 8080 with the priority display: flights", flights,
      {{"scene", "Scene", &WillisFlight::scene},
       {"axes", "Axes", &WillisFlight::axes},
       {"pieces", "Pieces", &WillisFlight::pieces},
       {"bits", "Bits", "of a coordinate", &WillisFlight::bits},
       {"frames_a_second", "Frames a second", "shown, mean", &WillisFlight::frames_a_second, 1},
       {"worst_frames_a_second", "Frames a second", "shown, worst", &WillisFlight::worst_frames_a_second, 1},
       {"fast_frames_a_second", fmt::format("In {} frames", fast_frames), "shown, mean", &WillisFlight::fast_frames_a_second, 1},
       {"fast_worst_frames_a_second", fmt::format("In {} frames", fast_frames), "shown, worst",
        &WillisFlight::fast_worst_frames_a_second, 1},
       {"computed_a_second", "Computed a second", "mean", &WillisFlight::computed_a_second, 1},
       {"worst_computed_a_second", "Computed a second", "worst", &WillisFlight::worst_computed_a_second, 1},
       {"t_states", "Frame", "T-states, mean", &WillisFlight::t_states, 0},
       {"worst_t_states", "Frame", "T-states, worst", &WillisFlight::worst_t_states, 0},
       {"exchanged", "Pairs exchanged", "mean of a frame", &WillisFlight::exchanged, 1},
       {"most_exchanged", "Pairs exchanged", "most", &WillisFlight::most_exchanged},
       {"wrong_orders", "Wrong orders", "pairs turned to the eye", &WillisFlight::wrong_orders},
       {"pairs", "of", "pairs", &WillisFlight::pairs},
       {"distance_error", "Right beyond", "a difference of distances, scene units", &WillisFlight::distance_error, 2},
       {"wrong_points", "Wrong points", "of all pictures", &WillisFlight::wrong_points}},
      {.notes = {
           fmt::format("Flights of {} frames; those past the most pieces also in {}, the eye moving farther from frame to frame.",
                       usual_frames, fast_frames),
           "A program of today makes a model without clusters. The 8080 receives a point of each piece, and the eye of each "
           "frame. It computes the distances, puts the pieces in order and loads their priorities into the display. The "
           "display gets the positions of the pieces on the screen from outside. Every priority is compared with that of a "
           "native program written from the same specification (`firmware/i8080/flight`). Computed a second is the rate of a "
           "display that never lets the program wait.",
           fmt::format(
               "Wrong orders are pairs that exact distances put in the other order. {}",
               wrong_points == 0
                   ? "None of them is visible: pieces that overlap in these pictures differ in distance by more than the "
                     "rounding."
                   : ""),
           of_100 >= 5 ? fmt::format("100 pieces are shown at {} frames a second or more.", text_of(of_100, 1)) : std::string()}});
  Plot plot{.id = "willis-flight-plot",
            .title = "Willis on an 8080: frames computed a second",
            .caption = "The mean of a flight; the display shows 25 a second at most.",
            .alternative =
                "Log-log plot of frames computed a second against the number of pieces, a curve for each scene and number of "
                "bits; all fall.",
            .x = {"pieces"},
            .y = {"frames computed", "a second"}};
  add_curves(
      plot, flights, [](const WillisFlight& f) { return fmt::format("{}, {} bits", f.scene, f.bits); }, &WillisFlight::pieces,
      &WillisFlight::computed_a_second);
  page.plot(std::move(plot));
  page.gallery("willis-flight-pictures", "A frame of each flight",
               where(flights, [](const WillisFlight& f) { return f.screen.has_value(); }), [](const WillisFlight& f) {
                 return figure(*f.screen, "willis-flight-" + f.scene, fmt::format("{}, {} pieces.", f.scene, f.pieces),
                               "A third of the way, as the priority display showed it; each face in one grey.",
                               "Buildings in greys, seen from between them");
               });
}

}  // namespace sightline::report
