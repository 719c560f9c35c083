// The native twin of firmware/i8080/flight, written from its SPECIFICATION.md: from the bytes of a stream to the priorities
// of every frame and the final status. It models neither time nor the way in which the program finds the order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/programs/flight/status.hpp"

namespace sightline::programs::flight {

struct TwinFrame {
  Priorities priorities{};
  // The distance of the order from that of the frame before: pieces moved before another, and pairs exchanged.
  std::uint32_t moved = 0;
  std::uint32_t exchanges = 0;
  std::uint32_t listed = 0;  // pieces of the order
  Turned turned{};           // with the facing test; in the first frame all pieces have appeared
};

struct TwinFlight {
  Status status = Status::running;
  std::vector<TwinFrame> frames;
};

// `facing`: the build with the facing test.
[[nodiscard]] TwinFlight run_twin(std::span<const std::uint8_t> stream, bool facing = false);

}  // namespace sightline::programs::flight
