#include "host/report/experiments/willis_facing.hpp"

#include <fmt/core.h>

#include <optional>
#include <utility>

#include "host/base/value_of.hpp"
#include "host/programs/flight/flight.hpp"
#include "host/report/page.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {

namespace {

namespace flight = programs::flight;

constexpr std::uint32_t frames = 100;

struct FlownScene {
  const char* name;
  scene::PolyScene scene;
  bool plan;
};

// The flight past at most that many pieces.
flight::Outcome fly(const FlownScene& flown, flight::Precision precision, bool facing, std::size_t pieces) {
  const flight::Plan plan = base::value_of(flight::plan_flight(flown.scene, flown.plan, frames, pieces, facing), flown.name);
  return base::value_of(flight::run({.model = plan.model, .path = plan.path, .precision = precision, .facing = facing, .check = true}), flown.name);
}

// Every frame at 25 a second, except for rounding.
bool in_time(const flight::Summary& sum) { return sum.frames_per_second_worst >= 24.9; }

// The most pieces that are in time, of fewer than `too_many`.
flight::Summary most_in_time(const FlownScene& flown, flight::Precision precision, bool facing, std::uint32_t too_many) {
  flight::Summary best;
  std::uint32_t low = 1;
  while (too_many - low > 1) {
    const std::uint32_t middle = low + (too_many - low) / 2;
    const flight::Summary sum = fly(flown, precision, facing, middle).summary;
    if (in_time(sum)) {
      best = sum;
      low = middle;
    } else {
      too_many = middle;
    }
  }
  return best;
}

}  // namespace

std::vector<WillisFacing> willis_facing(const Context& context) {
  std::vector<FlownScene> scenes;
  scenes.push_back({"town-20", scene::generate_town(20), false});
  scenes.push_back({"prisms-25", scene::generate_prisms(25), true});
  scenes.push_back({"town-30", scene::generate_town(30), false});
  std::vector<WillisFacing> rows;
  for (const FlownScene& flown : scenes) {
    context.progress(fmt::format("{} flown through with and without the facing test", flown.name));
    for (const auto& [precision, bits] : {std::pair(flight::Precision::bits_8, 8), std::pair(flight::Precision::bits_12, 12),
                                          std::pair(flight::Precision::bits_16, 16)}) {
      for (const bool facing : {false, true}) {
        const flight::Outcome run = fly(flown, precision, facing, flight::most_pieces);
        const flight::Summary& sum = run.summary;
        const flight::Summary most = in_time(sum) ? sum : most_in_time(flown, precision, facing, sum.pieces);
        rows.push_back({.scene = flown.name,
                        .axes = run.packed.axes,
                        .bits = bits,
                        .facing = facing,
                        .pieces = sum.pieces,
                        .directions = run.packed.directions,
                        .keys = sum.listed_mean,
                        .most_keys = sum.listed_most,
                        .turned = sum.turned_mean,
                        .most_turned = sum.turned_most,
                        .t_states = sum.t_states_mean,
                        .worst_t_states = sum.t_states_worst,
                        .frames_a_second = sum.frames_per_second_mean,
                        .worst_frames_a_second = sum.frames_per_second_worst,
                        .hidden = sum.hidden,
                        .pieces_at_25 = most.pieces,
                        .worst_t_states_at_25 = most.t_states_worst});
      }
    }
  }
  return rows;
}

void willis_facing_chapter(Page& page, const std::vector<WillisFacing>& flights) {
  const auto with = where(flights, &WillisFacing::facing);
  const auto without_of = [&](const WillisFacing& row) -> const WillisFacing& {
    return only(flights, [&](const WillisFacing& other) { return !other.facing && other.scene == row.scene && other.bits == row.bits; });
  };
  const auto share = [&](const WillisFacing& row) { return row.t_states / without_of(row).t_states; };
  const auto worst_share = [&](const WillisFacing& row) {
    return static_cast<double>(row.worst_t_states) / static_cast<double>(without_of(row).worst_t_states);
  };
  const auto more = count(with, [&](const WillisFacing& row) { return row.pieces_at_25 >= without_of(row).pieces_at_25; });
  page.table(
      "willis-facing", "Willis on an 8080: keys only for pieces that face the eye", flights,
      {{"scene", "Scene", &WillisFacing::scene},
       {"axes", "Axes", &WillisFacing::axes},
       {"bits", "Bits", "of a coordinate", &WillisFacing::bits},
       {"build", "Keys of", &WillisFacing::build},
       {"pieces_at_25", "Pieces at 25 frames a second", "in every frame", &WillisFacing::pieces_at_25},
       {"worst_t_states_at_25", "Their worst frame", "T-states", &WillisFacing::worst_t_states_at_25},
       {"pieces", "All pieces", &WillisFacing::pieces},
       {"t_states", "Frame", "T-states, mean", &WillisFacing::t_states, 0},
       {"worst_t_states", "Frame", "T-states, worst", &WillisFacing::worst_t_states},
       {"frames_a_second", "Frames a second", "shown, mean", &WillisFacing::frames_a_second, 1},
       {"worst_frames_a_second", "Frames a second", "shown, worst", &WillisFacing::worst_frames_a_second, 1},
       {"keys", "Keys", "mean of a frame", &WillisFacing::keys, 1},
       {"most_keys", "Keys", "most", &WillisFacing::most_keys},
       {"turned", "Pieces that turn", "mean of a frame", &WillisFacing::turned, 1},
       {"most_turned", "Pieces that turn", "most", &WillisFacing::most_turned},
       {"directions", "Directions", &WillisFacing::directions}},
      {.notes = {
           fmt::format("Flights of {} frames. The most pieces are those nearest to the start, found by halving; they are all pieces of the scene, "
                       "or as many as the machine holds, if the display shows these in time. A worst frame of more than 120,000 T-states is shown in "
                       "time if the frames around it take less.",
                       frames),
           fmt::format("The paper mentions the \"ease of computing which surfaces are facing away from the viewer\" and does not say how. Here the 8080 computes one "
                       "value for each direction of normals, and does work only for pieces that turn (`firmware/i8080/flight`, section 5 of its specification). A mean "
                       "frame takes {} to {} of the time without the test, the worst frame {} to {}.",
                       text_of(least(with, share), 2), text_of(greatest(with, share), 2), text_of(least(with, worst_share), 2),
                       text_of(greatest(with, worst_share), 2)),
           Page::claim(sum(with, &WillisFacing::hidden) == 0, "No piece that faces the eye is without a priority in any frame."),
           Page::claim(more == with.size(),
                       "With the test at least as many pieces are shown at 25 frames a second.",
                       fmt::format("With the test fewer pieces are shown at 25 frames a second in {} of {} flights.", with.size() - more, with.size()))}});
}

}  // namespace sightline::report
