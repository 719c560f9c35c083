// The buildings are generate_big_rooms: n by n rooms, between which walls, doors and hatches are drawn by
// lot, so that a building of another size is another building. From within, what can be compared is the time
// of a visit to a cell, and the mean view over many eyes, which stand in the middle of rooms spread evenly
// over the building. The very same view is had from a closed house beside each.
#include "host/report/scene_needs/unseen_native.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "host/algorithms/jones/visible_edges.hpp"
#include "host/report/plot.hpp"
#include "host/report/scene_needs/unseen_house.hpp"
#include "host/scene/cells/decompose.hpp"
#include "host/scene/generate/house_beside.hpp"

namespace sightline::harness::report {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

struct Measured {
  std::size_t cells = 0;
  std::size_t openings = 0;
  std::size_t views = 0;
  std::uint64_t visits = 0;
  std::uint64_t most_cells = 0;  // visited in one view
  double load_s = 0;             // compartmentation and preparation
  double views_s = 0;            // of all views, each the quickest of its repetitions
};

constexpr std::size_t eyes_a_side = 16;
constexpr int repetitions = 5;

// The rooms at which eyes stand: all of a small building, and evenly spread ones of a large one.
std::vector<std::int32_t> rooms_with_eyes(std::size_t side) {
  std::vector<std::int32_t> rooms;
  const std::size_t count = std::min(side, eyes_a_side);
  for (std::size_t i = 0; i < count; ++i)
    rooms.push_back(static_cast<std::int32_t>((2 * i + 1) * side / (2 * count)));
  return rooms;
}

std::optional<ReportError> look(LoadedBuilding& building, Measured& measured) {
  const std::size_t side = building.side;
  for (const std::int32_t i : rooms_with_eyes(side)) {
    for (const std::int32_t j : rooms_with_eyes(side)) {
      scene::PolyCamera here = building.camera;
      here.eye = {scene::building_beside_house + scene::big_room * i + 97, scene::big_room * j + 103, 70};
      double quickest = 0;
      for (int again = 0; again < repetitions; ++again) {
        const auto view_begun = Clock::now();
        const auto view = building.walker.visible_edges(here);
        const double time = seconds_since(view_begun);
        if (!view)
          return ReportError{ErrorKind::differs, fmt::format("a building of {} by {} rooms: {}", side, side,
                                                             view.error().message())};
        quickest = again == 0 ? time : std::min(quickest, time);
        const auto& counts = view->counts;
        if (again == 0) measured.visits += counts.visits;
        measured.most_cells = std::max(measured.most_cells, counts.cells);
      }
      measured.views_s += quickest;
      ++measured.views;
    }
  }
  return std::nullopt;
}

// Leaves the building among the others.
Outcome<Measured> measure(std::size_t side, std::vector<std::unique_ptr<LoadedBuilding>>& buildings) {
  const scene::PolyScene scene = scene::generate_house_beside(side);
  const auto begun = Clock::now();
  auto cut = scene::compartment(scene);
  if (!cut) return ReportError{ErrorKind::bad_input, cut.error().message()};
  buildings.push_back(std::make_unique<LoadedBuilding>(side, std::move(*cut), scene.camera));
  LoadedBuilding& building = *buildings.back();
  Measured measured;
  measured.load_s = seconds_since(begun);
  measured.cells = building.complex.cells.size();
  measured.openings = building.complex.openings.size();
  if (auto error = look(building, measured)) return std::move(*error);
  return measured;
}

Table empty_table() {
  Table table;
  table.id = "unseen-native";
  table.title = "Jones today: buildings from ten rooms to a million";
  table.columns = {{"rooms", "Rooms", "and 64 of the house", false},
                   {"cells", "Cells", "", false},
                   {"openings", "Openings", "", false},
                   {"load_s", "Loading", "s", true},
                   {"load_us_a_room", "Loading", "us a room", true},
                   {"views", "Views", "", false},
                   {"visits", "Visits", "mean of a view", false},
                   {"most_cells", "Cells seen", "most of a view", false},
                   {"view_us", "View", "us, mean", true},
                   {"visit_ns", "Visit", "ns, mean", true}};
  table.notes = {
      "Rooms with doors, hatches or nothing between them, by lot; 256 eyes or one in every room. Loading is "
      "cutting the building into cells and preparing them for views; a view's time is the least of five."};
  return table;
}

Plot empty_plot() {
  Plot plot;
  plot.id = "unseen-plot";
  plot.title = "Jones today: time of a view against the size of the building";
  plot.caption =
      "The view is from inside; nearly all rooms are out of sight. Times of the computer this report was "
      "made on.";
  plot.alternative =
      "Log-log plot: loading time rises in proportion to the number of rooms, the time of a view and that of "
      "a visit to a cell do not rise with it.";
  plot.host_time = true;
  plot.x = {"rooms", "", true, {}};
  plot.y = {"time", "s", true, {}};
  plot.curves = {{"loading", {}}, {"a view, mean", {}}, {"a visit, mean", {}}};
  return plot;
}

void add(Table& table, Plot& plot, std::size_t side, const Measured& measured) {
  const auto rooms = static_cast<double>(side * side + scene::house_rooms * scene::house_rooms);
  const auto views = static_cast<double>(measured.views);
  const auto visits = static_cast<double>(measured.visits);
  table.rows.push_back({static_cast<std::int64_t>(side * side), static_cast<std::int64_t>(measured.cells),
                        static_cast<std::int64_t>(measured.openings), Real{measured.load_s, 3},
                        Real{1e6 * measured.load_s / rooms, 2}, static_cast<std::int64_t>(measured.views),
                        Real{visits / views, 1}, static_cast<std::int64_t>(measured.most_cells),
                        Real{1e6 * measured.views_s / views, 2}, Real{1e9 * measured.views_s / visits, 0}});
  plot.curves[0].points.push_back({rooms, measured.load_s});
  plot.curves[1].points.push_back({rooms, measured.views_s / views});
  plot.curves[2].points.push_back({rooms, measured.views_s / visits});
}

}  // namespace

Outcome<std::vector<Block>> unseen_native(const Context& context) {
  Table table = empty_table();
  Plot plot = empty_plot();
  std::vector<std::size_t> sides{3, 10, 32, 100};
  // What larger ones add is their times.
  if (context.host_times) sides.insert(sides.end(), {316, 1000});
  std::vector<std::unique_ptr<LoadedBuilding>> buildings;
  for (const std::size_t side : sides) {
    context.progress(fmt::format("a building of {} rooms", side * side));
    const auto measured = measure(side, buildings);
    if (!measured) return measured.error();
    add(table, plot, side, *measured);
  }
  auto house = views_from_house(buildings, context);
  if (!house) return std::move(house.error());
  std::vector<Block> blocks;
  blocks.emplace_back(std::move(*house));
  blocks.emplace_back(std::move(table));
  if (!context.host_times) return blocks;
  auto figure = draw_plot(plot);
  if (!figure) return std::move(figure.error());
  blocks.emplace_back(std::move(*figure));
  return blocks;
}

}  // namespace sightline::harness::report
