// Flights on an 8080 with the priority display (firmware/i8080/flight): what a machine of Willis's time could do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// A flight through a scene past `pieces` pieces, with coordinates of `bits` bits. Times are the machine's.
struct WillisFlight {
  std::string scene;
  std::size_t axes = 0;
  std::uint32_t pieces = 0;
  int bits = 0;
  double frames_a_second = 0;  // as shown on the display, at most 25
  double worst_frames_a_second = 0;
  double computed_a_second = 0;  // for a display that never lets the program wait
  double worst_computed_a_second = 0;
  double t_states = 0;  // mean per frame
  std::int64_t worst_t_states = 0;
  double exchanged = 0;  // pairs per frame, mean
  std::uint32_t most_exchanged = 0;
  std::uint64_t pairs = 0;  // of pieces turned to the eye
  std::uint64_t wrong_orders = 0;
  double distance_error = 0;  // in scene units; pieces whose distances differ by more are in the right order
  // The same path in 60 frames instead of 100: the eye moves farther from frame to frame, and more pairs change
  // places. For flights past the most pieces.
  std::optional<double> fast_frames_a_second = {};
  std::optional<double> fast_worst_frames_a_second = {};
  // For flights with 8 bits and the most pieces.
  std::optional<std::uint64_t> wrong_points = {};
  std::optional<Picture> screen = {};
};

[[nodiscard]] std::vector<WillisFlight> willis_flight(const Context& context);

class Page;
void willis_flight_chapter(Page& page, const std::vector<WillisFlight>& flights);

}  // namespace sightline::report
