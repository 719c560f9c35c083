// The final statuses of the program of firmware/i8080/flight, and data of its stream and its display. Source: its
// SPECIFICATION.md.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

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
[[nodiscard]] constexpr std::string_view text_of(Status status) {
  switch (status) {
    case Status::running: return "running";
    case Status::complete: return "complete";
    case Status::not_a_flight: return "the stream does not begin with FL, or with the facing test FF";
    case Status::out_of_range: return "a precision, a number of axes, pieces, planes or directions, a coordinate, a place, a cell or an entry out of range";
    case Status::wrong_sum_of_pieces: return "the check of the pieces is wrong";
    case Status::wrong_sum_of_packet: return "the check of a packet is wrong";
    case Status::unknown_packet: return "a packet of no known kind";
    case Status::host_silent: return "the host has gone silent";
    case Status::no_display: return "there is no priority display";
  }
  return "unknown status";
}

// The bits of a coordinate: the byte `precision` of the stream.
enum class Precision : std::uint8_t { bits_8 = 1, bits_12 = 2, bits_16 = 3 };

// Priorities by number; 0 where no such piece exists, and with the facing test for a piece that faces away.
using Priorities = std::array<std::uint8_t, 256>;

// Changes of the facing test from one frame to the next.
struct Turned {
  std::uint32_t appeared = 0;  // pieces that have come to face the eye
  std::uint32_t vanished = 0;
  std::uint32_t passed = 0;    // pieces of both frames that are before the last one that has appeared

  friend bool operator==(const Turned&, const Turned&) = default;
};

}  // namespace sightline::programs::flight
