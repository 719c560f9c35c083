// Flights on an 8080 with and without the facing test: keys only for pieces that face the eye (firmware/i8080/flight).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// A flight past all pieces of a scene, or as many as the machine holds. Times are the machine's.
struct WillisFacing {
  std::string scene;
  std::size_t axes = 0;
  int bits = 0;
  bool facing = false;  // with the test
  std::uint32_t pieces = 0;
  std::size_t directions = 0;
  double keys = 0;  // pieces with a key, mean of a frame
  std::uint32_t most_keys = 0;
  double turned = 0;  // pieces that come to face the eye or turn away, mean of a frame
  std::uint32_t most_turned = 0;
  double t_states = 0;
  std::int64_t worst_t_states = 0;
  double frames_a_second = 0;  // as shown on the display, at most 25
  double worst_frames_a_second = 0;
  std::uint64_t hidden = 0;  // pieces that face the eye and got no priority, of all frames
  // The most pieces, the nearest to the start, with which every frame is shown in time at 25 frames a second; and their flight.
  std::uint32_t pieces_at_25 = 0;
  std::int64_t worst_t_states_at_25 = 0;

  [[nodiscard]] std::string build() const { return facing ? "facing pieces" : "all pieces"; }
};

[[nodiscard]] std::vector<WillisFacing> willis_facing(const Context& context);

class Page;
void willis_facing_chapter(Page& page, const std::vector<WillisFacing>& flights);

}  // namespace sightline::report
