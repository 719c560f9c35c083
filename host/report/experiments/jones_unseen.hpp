// Jones's algorithm today in buildings of ten to a million rooms: "cells to which access is not gained in this way
// are never even considered" (Jones 1971).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

// A building: its size, loading (cell decomposition and preparation), views from inside. Times of this computer.
struct JonesBuilding {
  std::size_t rooms = 0;
  std::size_t all_rooms = 0;  // including those of the house beside it
  std::size_t cells = 0;
  std::size_t openings = 0;
  std::optional<double> load_s;
  std::size_t views = 0;
  double visits = 0;  // mean per view
  std::uint64_t most_cells = 0;
  std::optional<double> view_us;
  std::optional<double> visit_ns;
};

// The view from the house beside a building. Picture and counts are the same in every row.
struct JonesHouse {
  std::size_t rooms = 0;
  std::size_t cells = 0;
  std::uint64_t cells_seen = 0;
  std::uint64_t visits = 0;
  std::size_t segments = 0;
  std::optional<double> view_us;
  std::optional<double> ratio;  // to the time beside the smallest building
};

struct JonesUnseen {
  std::vector<JonesBuilding> buildings;
  std::vector<JonesHouse> house;
};

[[nodiscard]] JonesUnseen jones_unseen(const Context& context);
void jones_unseen_chapter(Page& page, const JonesUnseen& unseen);

}  // namespace sightline::report
