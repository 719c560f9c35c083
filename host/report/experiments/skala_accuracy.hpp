// Skala's program and its native version on rasters, grids and numbers of levels of every size: their errors and
// times.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/experiments/surface_error.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

// A study (raster, grid, levels), function, program and setting.
struct SkalaPoint {
  std::string study;
  std::string function;
  std::string program;
  int setting = 0;  // dots a side, points per slice, levels
  int raster = 0;   // dots a side
  SurfaceError error;
  std::optional<std::uint64_t> drawing_t_states;  // of the 8080
  std::optional<double> drawing_s;
  std::optional<double> host_us;

  [[nodiscard]] bool native() const { return !drawing_t_states; }
  [[nodiscard]] double dots_off() const;  // the greatest distance, in dots of the raster
};

// Both boards on both links, 65 points in each of 33 slices.
struct SkalaBoard {
  std::string function;
  std::string board;
  SurfaceError error;
  std::uint64_t drawing_t_states = 0;
  double drawing_s = 0;
  std::uint64_t total_t_states = 0;
  double total_s = 0;
  std::uint64_t dots_not_shown = 0;
};

struct SkalaAccuracy {
  std::vector<SkalaPoint> points;
  std::vector<SkalaBoard> boards;
};

void skala_accuracy(const Context& context, SkalaAccuracy& made);
void skala_accuracy_chapter(Page& page, const SkalaAccuracy& skala);

}  // namespace sightline::report
