// A flight through a scene on an 8080 with the priority display of Willis (firmware/i8080/flight): one at a time. It is no machine of the
// workbench: what its host computer does for each frame belongs to it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "host/live/web/workbench.hpp"

namespace sightline::live::web {

class Flying {
 public:
  Flying();
  ~Flying();

  // The answer to a request of this file's kind; null if it is none: flight, flight_state.
  [[nodiscard]] Json answer(const Workbench& workbench, std::string_view what, const Json& request);

  // To that time; whether there is more to fly.
  bool run(std::int64_t t_states);
  [[nodiscard]] std::int64_t t_states() const;
  // What the display shows: 512 lines of 512 numbers of faces from 1, 0 for none; the top line first. Empty without a flight.
  [[nodiscard]] std::span<const std::uint32_t> picture();

 private:
  struct Journey;
  [[nodiscard]] Json make(const Workbench& workbench, const Json& request);
  [[nodiscard]] Json state() const;

  std::unique_ptr<Journey> journey_;
};

}  // namespace sightline::live::web
