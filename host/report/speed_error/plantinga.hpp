// Plantinga, Seales and Dyer (1990): how wrong frames are when events are joined within an angle tolerance,
// or when a frame stands until the next one, and what that saves.
//
// What is true at an angle is hidden-line removal from scratch there, exact, at angles of which the list of
// events knows nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/report/report.hpp"

namespace sightline::harness::report {

struct PlantingaPoint {
  double degrees = 0;  // the tolerance, or from frame to frame
  // Shares, 0 to 1.
  double wrong_views = 0;   // angles at which the structure of any edge is wrong (TOPO)
  double wrong_length = 0;  // of the length of all edges in the image, wrongly seen or hidden (WVR)
  double expected = 0;      // of wrong views, were the groups spread evenly
  std::size_t groups = 0;
  double file_kb = 0;
  std::optional<double> prepare_s;
  std::optional<double> frame_ns;
};

struct PlantingaCurve {
  std::string model;
  std::vector<PlantingaPoint> tolerances;
  std::vector<PlantingaPoint> steps;
  double hidden_length = 0;          // share that is hidden: what is wrong with the wire frame
  std::optional<double> wire_ns;     // a wire frame
  std::optional<double> scratch_ns;  // hidden-line removal from scratch
};

[[nodiscard]] Outcome<std::vector<PlantingaCurve>> measure_plantinga(const Context& context);

// Plots and two tables.
[[nodiscard]] Outcome<std::vector<Block>> plantinga_error_blocks(const std::vector<PlantingaCurve>& curves);

}  // namespace sightline::harness::report
