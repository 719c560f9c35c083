// The native twin of firmware/i8080/flight, written from its SPECIFICATION.md: from the bytes of a stream to the priorities of every
// frame and the status at the end. It knows nothing of time, nor of how the program finds the order.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace sightline::programs::flight {

enum class Status : std::uint8_t {
  running = 0,
  complete = 1,
  not_a_flight = 2,
  out_of_range = 3,
  wrong_sum_of_pieces = 4,
  wrong_sum_of_packet = 5,
  unknown_packet = 6,
  host_silent = 7,
  no_display = 8,
};
[[nodiscard]] std::string_view text_of(Status status);

// A coordinate's bits: what the byte `precision` of the stream says.
enum class Precision : std::uint8_t { bits_8 = 1, bits_12 = 2, bits_16 = 3 };

// Priorities by number; 0 where there is no such piece.
using Priorities = std::array<std::uint8_t, 256>;

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
