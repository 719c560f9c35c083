// The buildings are generate_big_rooms: n by n rooms between which walls, doors and hatches are random, so a building
// of another size is another building. From inside, comparable are the time of a visit to a cell, and the mean view
// from many eyes in the centres of rooms that are evenly distributed over the building. The view from a closed house
// of 64 rooms beside each building is exactly the same.
//
// Only the smallest building and one other are in memory at a time. A round draws views of both several times, so
// that a computer whose speed changes affects both. The result is the median of the rounds.
#include "host/report/experiments/jones_unseen.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "host/algorithms/jones/visible_edges.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/generate/house_beside.hpp"

namespace sightline::report {

namespace {

using algorithms::jones::View;
using Clock = std::chrono::steady_clock;

constexpr std::size_t eyes_a_side = 16;
constexpr int repetitions = 5;
constexpr int rounds = 101;
constexpr int views_a_round = 20;

double seconds_since(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

scene::CellComplex decomposed(const scene::PolyScene& scene) {
  auto cut = scene::decompose(scene);
  if (!cut) throw base::bad_input(cut.error().message());
  return *std::move(cut);
}

// A house beside a building, ready for views. It must not be moved, because views point into it.
struct Building {
  explicit Building(std::size_t rooms_a_side)
      : Building(rooms_a_side, scene::generate_house_beside(rooms_a_side)) {}
  Building(std::size_t rooms_a_side, const scene::PolyScene& scene)
      : begun(Clock::now()),
        side(rooms_a_side),
        complex(decomposed(scene)),
        prepared(complex),
        walker(prepared),
        camera(scene.camera),
        load_s(seconds_since(begun)) {}
  Building(const Building&) = delete;
  Building& operator=(const Building&) = delete;

  [[nodiscard]] View view(const scene::PolyCamera& from) {
    auto seen = walker.visible_edges(from);
    if (!seen)
      throw base::difference(fmt::format("a building of {0} by {0} rooms: {1}", side, seen.error().message()));
    return *std::move(seen);
  }

  Clock::time_point begun;
  std::size_t side;
  scene::CellComplex complex;
  algorithms::jones::PreparedComplex prepared;
  algorithms::jones::Walker walker;
  scene::PolyCamera camera;  // in the house
  double load_s;
};

// The rooms that contain eyes: all of a small building, evenly distributed ones of a large one.
std::vector<std::int32_t> rooms_with_eyes(std::size_t side) {
  std::vector<std::int32_t> rooms;
  const std::size_t count = std::min(side, eyes_a_side);
  for (std::size_t i = 0; i < count; ++i)
    rooms.push_back(static_cast<std::int32_t>((2 * i + 1) * side / (2 * count)));
  return rooms;
}

JonesBuilding seen_from_within(Building& building, bool host_times) {
  JonesBuilding made;
  std::uint64_t visits = 0;
  double views_s = 0;  // each the fastest of its repetitions
  for (const std::int32_t i : rooms_with_eyes(building.side)) {
    for (const std::int32_t j : rooms_with_eyes(building.side)) {
      scene::PolyCamera here = building.camera;
      here.eye = {scene::building_beside_house + scene::big_room * i + 97, scene::big_room * j + 103, 70};
      double quickest = 0;
      for (int again = 0; again < (host_times ? repetitions : 1); ++again) {
        const auto begun = Clock::now();
        const View view = building.view(here);
        const double time = seconds_since(begun);
        quickest = again == 0 ? time : std::min(quickest, time);
        if (again == 0) visits += view.counts.visits;
        made.most_cells = std::max(made.most_cells, view.counts.cells);
      }
      views_s += quickest;
      ++made.views;
    }
  }
  made.rooms = building.side * building.side;
  made.all_rooms = made.rooms + scene::house_rooms * scene::house_rooms;
  made.cells = building.complex.cells.size();
  made.openings = building.complex.openings.size();
  made.visits = static_cast<double>(visits) / static_cast<double>(made.views);
  if (!host_times) return made;
  made.load_s = building.load_s;
  made.view_us = 1e6 * views_s / static_cast<double>(made.views);
  made.visit_ns = 1e9 * views_s / static_cast<double>(visits);
  return made;
}

// The mean of a round without the first view, which finds another building in the caches.
double round_of(Building& building) {
  static_cast<void>(building.walker.visible_edges(building.camera));
  const auto begun = Clock::now();
  for (int i = 0; i < views_a_round; ++i) static_cast<void>(building.walker.visible_edges(building.camera));
  return seconds_since(begun) / views_a_round;
}

double median(std::vector<double> times) {
  const auto middle = times.begin() + rounds / 2;
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

JonesHouse seen_from_house(Building& smallest, const View& first, Building& building, bool host_times) {
  const View view = building.view(building.camera);
  if (view.picture != first.picture || view.counts != first.counts)
    throw base::difference(fmt::format("the view of the house beside {0} by {0} rooms is not the one beside {1} by {1}",
                    building.side, smallest.side));
  JonesHouse made{building.side * building.side, building.complex.cells.size(), view.counts.cells, view.counts.visits,
                  view.picture.pieces.size(), {}, {}};
  if (!host_times) return made;
  std::vector<double> here;
  std::vector<double> there;
  for (int round = 0; round < rounds; ++round) {
    there.push_back(round_of(smallest));
    here.push_back(&building == &smallest ? there.back() : round_of(building));
  }
  made.view_us = 1e6 * median(here);
  made.ratio = median(here) / median(there);
  return made;
}

}  // namespace

JonesUnseen jones_unseen(const Context& context) {
  JonesUnseen made;
  std::vector<std::size_t> sides{3, 10, 32, 100};
  // Larger buildings add times only; the largest takes 1.5 GB.
  if (context.host_times) sides.insert(sides.end(), {316, 500});
  if (context.host_times && context.full) sides.push_back(1000);
  Building smallest(sides.front());
  const View first = smallest.view(smallest.camera);
  for (const std::size_t side : sides) {
    context.progress(fmt::format("a building of {} rooms", side * side));
    std::optional<Building> larger;
    if (side != smallest.side) larger.emplace(side);
    Building& building = larger ? *larger : smallest;
    made.buildings.push_back(seen_from_within(building, context.host_times));
    made.house.push_back(seen_from_house(smallest, first, building, context.host_times));
  }
  return made;
}

void jones_unseen_chapter(Page& page, const JonesUnseen& unseen) {
  std::vector<CheckedText> notes{
      "A closed house of 64 rooms, seen from inside one of them, beside a building that is not visible. Picture and counts "
      "must be the same in every row, or the report ends with an error."};
  if (page.host_times()) {
    const auto ratio = range_of(unseen.house, &JonesHouse::ratio);
    const std::string last = text_of(unseen.house.back().ratio, 2);
    notes.push_back(
        fmt::format("Times are the median of {} rounds, in each of which a view beside the building and one beside "
                    "the smallest are computed in turn, {} times each. ",
                    rounds, views_a_round) +
        page.claim(ratio.greatest <= 1.25 && ratio.least >= 0.8,
                   fmt::format("Beside the largest building the view takes {} times as long as beside the smallest.", last),
                   fmt::format("{} to {}", text_of(ratio.least), text_of(ratio.greatest))));
  }
  using House = JonesHouse;
  page.table("unseen-house", "Jones today: one view beside a growing building", unseen.house,
             {{"rooms", "Rooms", "of the building", &House::rooms},
              {"cells", "Cells", "in all", &House::cells},
              {"cells_seen", "Cells", "seen", &House::cells_seen},
              {"visits", "Visits", &House::visits},
              {"segments", "Segments", "drawn", &House::segments},
              {"view_us", "View", "us, median", &House::view_us, 2, host_time},
              {"ratio", "Ratio", "to the smallest building", &House::ratio, 3, host_time}},
             {std::move(notes)});
  using Building = JonesBuilding;
  const auto& buildings = unseen.buildings;
  const auto rooms = range_of(buildings, &Building::rooms);
  notes = {"Rooms with random doors, hatches or nothing between them; 256 eyes, or one in every room."};
  if (page.host_times())
    notes.push_back(fmt::format("Loading cuts the building into cells and prepares them for views. The time of a view is the "
                                "least of {} runs.",
                                repetitions));
  page.table("unseen-native", fmt::format("Jones today: buildings of {} to {} rooms", text_of(rooms.least), text_of(rooms.greatest)),
             buildings,
             {{"rooms", "Rooms", "including 64 of the house", &Building::rooms},
              {"cells", "Cells", &Building::cells},
              {"openings", "Portals", &Building::openings},
              {"load_s", "Loading", "s", &Building::load_s, 3, host_time},
              {"load_us_a_room", "Loading", "us a room",
               [](const Building& b) { return 1000000 * b.load_s.value_or(0) / static_cast<double>(b.all_rooms); }, 2, host_time},
              {"views", "Views", &Building::views},
              {"visits", "Visits", "mean of a view", &Building::visits, 1},
              {"most_cells", "Cells seen", "most of a view", &Building::most_cells},
              {"view_us", "View", "us, mean", &Building::view_us, 2, host_time},
              {"visit_ns", "Visit", "ns, mean", &Building::visit_ns, 0, host_time}},
             {std::move(notes)});
  if (!page.host_times()) return;
  const Building& small = only(buildings, equals(&Building::rooms, 100U));
  Plot plot{"unseen-plot",
            "Jones today: time of a view against the size of the building",
            fmt::format("The view is from inside; nearly all rooms are invisible. From {} to {} rooms loading takes {} times "
                        "as long, a visit {} times. Times of the computer this report was made on.",
                        text_of(small.all_rooms), text_of(greatest(buildings, &Building::all_rooms)),
                        text_of(greatest(buildings, &Building::load_s) / *small.load_s, 0),
                        text_of(*buildings.back().visit_ns / *small.visit_ns, 1)),
            "Log-log plot of the time of loading, of a view and of a visit to a cell against the number of rooms.",
            {"rooms"},
            {"time", "s"}};
  const auto all_rooms = [](const Building& b) { return static_cast<double>(b.all_rooms); };
  add_curves(plot, buildings, "loading", all_rooms, &Building::load_s);
  add_curves(plot, buildings, "a view, mean", all_rooms, [](const Building& b) { return *b.view_us / 1000000; });
  add_curves(plot, buildings, "a visit, mean", all_rooms, [](const Building& b) { return *b.visit_ns / 1000000000; });
  page.plot(std::move(plot));
}

}  // namespace sightline::report
