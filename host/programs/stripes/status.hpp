// The final statuses of the program of firmware/i8080/stripes, and its limits. Source: its SPECIFICATION.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sightline::programs::stripes {

enum class Status : std::uint8_t {
  running,
  complete,
  not_a_stream,
  link_silent,
  checksum,
  too_large,
  bad_record,
  full,
  no_device,
  device_error,
};

[[nodiscard]] constexpr std::string_view text_of(Status status) {
  switch (status) {
    case Status::running: return "running";
    case Status::complete: return "complete";
    case Status::not_a_stream: return "not a stream of faces";
    case Status::link_silent: return "the link is silent in the middle of the stream";
    case Status::checksum: return "check sums differ";
    case Status::too_large: return "too many faces or too long a body";
    case Status::bad_record: return "a face's record is damaged";
    case Status::full: return "a line has too many substripes, or there are too many cuts";
    case Status::no_device: return "no device answers";
    case Status::device_error: return "the plotter reports an error";
  }
  return "unknown";
}

inline constexpr std::uint8_t first_byte = 0x53;
inline constexpr std::uint8_t version = 1;
inline constexpr std::size_t header_bytes = 6;
inline constexpr std::size_t most_body_bytes = 0x6800;
inline constexpr std::size_t most_faces = 64;
inline constexpr std::size_t most_cuts = 63;
inline constexpr int picture_size = 255;  // columns and lines
inline constexpr std::size_t most_face_toggles = 15;  // in a line
inline constexpr std::size_t most_silhouette_toggles = 31;
inline constexpr std::size_t most_seen_toggles = 15;  // vector output

// The builds of the program (SPECIFICATION, sections 8 and 9).
enum class Build : std::uint8_t { plain, coverage, overwrite };

inline constexpr std::size_t most_coverage_body_bytes = 0x2800;
inline constexpr std::size_t most_face_changes = 23;  // columns in a line of a face in which layers change
inline constexpr std::size_t most_silhouette_changes = 31;

[[nodiscard]] constexpr std::size_t most_body_bytes_of(Build build) {
  return build == Build::coverage ? most_coverage_body_bytes : most_body_bytes;
}

// Bits of the mode.
inline constexpr std::uint8_t vector_output = 1;
inline constexpr std::uint8_t find_priority = 2;
inline constexpr std::uint8_t faces_are_stripes = 4;

}  // namespace sightline::programs::stripes
