// Jones's algorithm today in buildings from ten rooms to a million: "cells to which access is not gained in
// this way are never even considered" (Jones 1971).
//
// The buildings are generate_big_rooms: n by n rooms, between which walls, doors and hatches are drawn by
// lot, so that a building of another size is another building. From within, what can be compared is the time
// of a visit to a cell, and the mean view over many eyes, which stand in the middle of rooms spread evenly
// over the building. The very same view is had from a closed house of 64 rooms beside each.
//
//   buildings  a building each: its size, loading (cell decomposition and preparation), views from within
//   house      the view from the house beside each. Picture and counts must be equal in every row.
//
// Only the smallest building and one other are in memory at a time. A round looks at each of the two some
// times over, so that a computer that changes its speed does so for both; of the rounds the median counts.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "host/algorithms/jones/visible_edges.hpp"
#include "host/report/experiments/experiments.hpp"
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
  if (!cut) throw Failure(ErrorKind::bad_input, cut.error().message());
  return *std::move(cut);
}

// A house beside a building, ready for views. Stays where it is, since views point into it.
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
      throw Failure(ErrorKind::differs,
                    fmt::format("a building of {0} by {0} rooms: {1}", side, seen.error().message()));
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

// The rooms at which eyes stand: all of a small building, and evenly spread ones of a large one.
std::vector<std::int32_t> rooms_with_eyes(std::size_t side) {
  std::vector<std::int32_t> rooms;
  const std::size_t count = std::min(side, eyes_a_side);
  for (std::size_t i = 0; i < count; ++i)
    rooms.push_back(static_cast<std::int32_t>((2 * i + 1) * side / (2 * count)));
  return rooms;
}

void add_views_from_within(RowSet& rows, Building& building, bool host_times) {
  std::size_t views = 0;
  std::uint64_t visits = 0;
  std::uint64_t most_cells = 0;
  double views_s = 0;  // each the quickest of its repetitions
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
        most_cells = std::max(most_cells, view.counts.cells);
      }
      views_s += quickest;
      ++views;
    }
  }
  const auto host = [host_times](double value) { return host_times ? Value(value) : Value(); };
  rows.add({{"rooms", building.side * building.side},
            {"all_rooms", building.side * building.side + scene::house_rooms * scene::house_rooms},
            {"cells", building.complex.cells.size()},
            {"openings", building.complex.openings.size()},
            {"load_s", host(building.load_s)},
            {"views", views},
            {"visits", static_cast<double>(visits) / static_cast<double>(views)},
            {"most_cells", most_cells},
            {"view_us", host(1e6 * views_s / static_cast<double>(views))},
            {"visit_ns", host(1e9 * views_s / static_cast<double>(visits))}});
}

// The mean of a round; the first view, which finds another building in the caches, does not count.
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

void add_view_from_house(RowSet& rows, Building& smallest, const View& first, Building& building,
                         bool host_times) {
  const View view = building.view(building.camera);
  if (view.picture != first.picture || view.counts != first.counts)
    throw Failure(
        ErrorKind::differs,
        fmt::format("the view of the house beside {0} by {0} rooms is not the one beside {1} by {1}",
                    building.side, smallest.side));
  Value view_us;
  Value ratio;
  if (host_times) {
    std::vector<double> here;
    std::vector<double> there;
    for (int round = 0; round < rounds; ++round) {
      there.push_back(round_of(smallest));
      here.push_back(&building == &smallest ? there.back() : round_of(building));
    }
    view_us = 1e6 * median(here);
    ratio = median(here) / median(there);
  }
  rows.add({{"rooms", building.side * building.side},
            {"cells", building.complex.cells.size()},
            {"cells_seen", view.counts.cells},
            {"visits", view.counts.visits},
            {"segments", view.picture.pieces.size()},
            {"view_us", view_us},
            {"ratio", ratio}});
}

}  // namespace

Records jones_unseen(const Context& context) {
  Records records;
  records["rounds"].add({{"rounds", rounds}, {"views_a_round", views_a_round}, {"repetitions", repetitions}});
  std::vector<std::size_t> sides{3, 10, 32, 100};
  // What larger ones add is their times; the largest takes 1.5 GB.
  if (context.host_times) sides.insert(sides.end(), {316, 500});
  if (context.host_times && context.full) sides.push_back(1000);
  Building smallest(sides.front());
  const View first = smallest.view(smallest.camera);
  for (const std::size_t side : sides) {
    context.progress(fmt::format("a building of {} rooms", side * side));
    std::optional<Building> larger;
    if (side != smallest.side) larger.emplace(side);
    Building& building = larger ? *larger : smallest;
    add_views_from_within(records["buildings"], building, context.host_times);
    add_view_from_house(records["house"], smallest, first, building, context.host_times);
  }
  return records;
}

}  // namespace sightline::report
