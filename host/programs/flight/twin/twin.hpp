// The native twin of firmware/i8080/flight, written from its SPECIFICATION.md: from the bytes of a stream to the priorities of every
// frame and the status at the end. It knows nothing of time, nor of how the program finds the order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/programs/flight/status.hpp"

namespace sightline::programs::flight {

struct TwinFrame {
  Priorities priorities{};
  // How far the order is from that of the frame before: pieces that had to go before another, and pairs that changed places.
  std::uint32_t moved = 0;
  std::uint32_t exchanges = 0;
};

struct TwinFlight {
  Status status = Status::running;
  std::vector<TwinFrame> frames;
};

[[nodiscard]] TwinFlight run_twin(std::span<const std::uint8_t> stream);

}  // namespace sightline::programs::flight
