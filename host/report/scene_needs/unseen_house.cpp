// How times are compared: all buildings are in memory, and every round looks at each of them some times over,
// so that a computer that changes its speed does so for all of them. Of a building's rounds the median
// counts.
#include "host/report/scene_needs/unseen_house.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace sightline::harness::report {

namespace {

using algorithms::jones::View;
using Clock = std::chrono::steady_clock;

constexpr int rounds = 201;
constexpr int views_a_round = 20;

// The mean of a round; the first view, which finds another building in the caches, does not count.
double round_of(LoadedBuilding& building) {
  static_cast<void>(building.walker.visible_edges(building.camera));
  const auto begun = Clock::now();
  for (int i = 0; i < views_a_round; ++i) static_cast<void>(building.walker.visible_edges(building.camera));
  return std::chrono::duration<double>(Clock::now() - begun).count() / views_a_round;
}

std::vector<double> median_times(const std::vector<std::unique_ptr<LoadedBuilding>>& buildings) {
  std::vector<std::vector<double>> times(buildings.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t b = 0; b < buildings.size(); ++b) times[b].push_back(round_of(*buildings[b]));
  std::vector<double> medians;
  for (std::vector<double>& of_one : times) {
    const auto middle = of_one.begin() + rounds / 2;
    std::nth_element(of_one.begin(), middle, of_one.end());
    medians.push_back(*middle);
  }
  return medians;
}

Outcome<std::vector<View>> first_views(const std::vector<std::unique_ptr<LoadedBuilding>>& buildings) {
  std::vector<View> views;
  for (const auto& building : buildings) {
    auto view = building->walker.visible_edges(building->camera);
    if (!view)
      return ReportError{ErrorKind::differs,
                         fmt::format("the house beside {} by {} rooms: {}", building->side, building->side,
                                     view.error().message())};
    views.push_back(std::move(*view));
    if (views.back().picture != views.front().picture || views.back().counts != views.front().counts)
      return ReportError{
          ErrorKind::differs,
          fmt::format("the view of the house beside {} by {} rooms is not the one beside {} by {}",
                      building->side, building->side, buildings.front()->side, buildings.front()->side)};
  }
  return views;
}

Table empty_table() {
  Table table;
  table.id = "unseen-house";
  table.title = "Jones today: one view beside a building that grows";
  table.columns = {{"rooms", "Rooms", "of the building", false},
                   {"cells", "Cells", "in all", false},
                   {"cells_seen", "Cells", "seen", false},
                   {"visits", "Visits", "", false},
                   {"segments", "Segments", "drawn", false},
                   {"view_us", "View", "us, median", true},
                   {"ratio", "Ratio", "to the smallest building", true}};
  table.notes = {fmt::format(
      "A closed house of 64 rooms, looked at from within one of them, beside a building of which "
      "nothing is seen. Picture and counts are the same in every row; the report checks that. Times "
      "are the median of {} rounds, in each of which all buildings are looked at in turn, {} times "
      "each.",
      rounds, views_a_round)};
  return table;
}

}  // namespace

Outcome<Table> views_from_house(const std::vector<std::unique_ptr<LoadedBuilding>>& buildings,
                                const Context& context) {
  const auto looked = first_views(buildings);
  if (!looked) return looked.error();
  const auto& views = *looked;
  context.progress("the house beside each of them");
  const std::vector<double> times =
      context.host_times ? median_times(buildings) : std::vector<double>(buildings.size(), 1.0);
  Table table = empty_table();
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const LoadedBuilding& building = *buildings[b];
    table.rows.push_back({static_cast<std::int64_t>(building.side * building.side),
                          static_cast<std::int64_t>(building.complex.cells.size()),
                          static_cast<std::int64_t>(views[b].counts.cells),
                          static_cast<std::int64_t>(views[b].counts.visits),
                          static_cast<std::int64_t>(views[b].picture.pieces.size()), Real{1e6 * times[b], 2},
                          Real{times[b] / times.front(), 3}});
  }
  return table;
}

}  // namespace sightline::harness::report
