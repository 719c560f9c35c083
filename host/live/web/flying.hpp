// A flight through a scene on an 8080 with the priority display of Willis (firmware/i8080/flight); one exists at a time. It is not a
// machine of the workbench, because its host computer takes part in every frame.
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

  // Answers the requests flight and flight_state; null for any other.
  [[nodiscard]] Json answer(const Workbench& workbench, std::string_view what, const Json& request);

  // Runs to a time; true: the flight continues.
  bool run(std::int64_t t_states);
  [[nodiscard]] std::int64_t t_states() const;
  // The picture of the display: 512 lines of 512 face numbers from 1, 0 for none; the top line first. Empty without a flight.
  [[nodiscard]] std::span<const std::uint32_t> picture();

 private:
  struct Journey;
  [[nodiscard]] Json make(const Workbench& workbench, const Json& request);
  [[nodiscard]] Json state() const;

  std::unique_ptr<Journey> journey_;
};

}  // namespace sightline::live::web
