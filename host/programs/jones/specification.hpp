// The common part of Jones's program on the PDP-7 and its twin in C++, from firmware/pdp7/jones/SPECIFICATION.md: sizes of
// areas in core, the statuses of a view, the windows on the screen, and a piece of a line. Left out: the search and its
// arithmetic, which program and twin implement separately.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sightline::programs::jones {

inline constexpr int machine_word_bits = 18;
inline constexpr int machine_fraction_bits = 3;
inline constexpr std::uint32_t core_words = 8192;  // of the machine Jones used
inline constexpr int mask_stack_words = 450;
inline constexpr std::size_t display_file_words = 1384;

enum class Status : std::uint8_t {
  complete,
  stack_overflow,
  display_file_overflow,
  arithmetic_overflow,
  too_many_mask_vertices,
  deeper_than_cells,
  bad_data_element,
  eye_in_no_cell,
  unfinished,  // no status of the machine: the twin reached its own limit, where the machine would continue
};
[[nodiscard]] inline std::string_view name(Status status) {
  switch (status) {
    case Status::complete: return "complete";
    case Status::stack_overflow: return "stack overflow";
    case Status::display_file_overflow: return "display file overflow";
    case Status::arithmetic_overflow: return "arithmetic overflow";
    case Status::too_many_mask_vertices: return "too many mask vertices";
    case Status::deeper_than_cells: return "deeper than the number of cells";
    case Status::bad_data_element: return "bad data element";
    case Status::eye_in_no_cell: return "the eye is in no cell";
    case Status::unfinished: return "unfinished: the search goes on";
  }
  return "unknown status";
}

inline constexpr std::int32_t near_z = 1;
inline constexpr std::int32_t separation = 5;  // half the distance between the eyes of a stereo pair

// Object units, relative to the eye.
struct SpacePoint {
  std::int32_t x = 0, y = 0, z = 0;
  friend constexpr bool operator==(const SpacePoint&, const SpacePoint&) = default;
};
struct SpaceSegment {
  SpacePoint p, q;
  friend constexpr bool operator==(const SpaceSegment&, const SpaceSegment&) = default;
};
// Units relative to the centre of the window, 2^fraction_bits to a point of the screen.
template <class Coordinate>
struct BasicScreenPoint {
  Coordinate x = 0, y = 0;
  friend constexpr bool operator==(const BasicScreenPoint&, const BasicScreenPoint&) = default;
};
template <class Coordinate>
struct BasicScreenSegment {
  BasicScreenPoint<Coordinate> a, b;
  friend constexpr bool operator==(const BasicScreenSegment&, const BasicScreenSegment&) = default;
};
using ScreenPoint = BasicScreenPoint<std::int32_t>;
using ScreenSegment = BasicScreenSegment<std::int32_t>;

enum class Axis : std::uint8_t { x = 1, y = 2, z = 3 };  // A of a vector word: i, j, k

// The area of one half of a stereo pair, or of the whole screen.
struct Window {
  static constexpr std::int32_t unit = std::int32_t{1} << machine_fraction_bits;  // a point of the screen
  // Units relative to the centre.
  std::int32_t xlo = -512 * unit, xhi = 511 * unit, ylo = -512 * unit, yhi = 511 * unit;
  std::int32_t centre_x = 512, centre_y = 512;  // points of the screen
  std::int32_t width_scale = 512 * unit;        // W: units per unit of x/z
  std::int32_t bound_factor = 4;                                  // K: lines are cut at |x|, |y| <= K z
};
enum class Pass : std::uint8_t { mono, left, right };
// scale: S, 64..4096. Section 1, with K chosen for the length of a word.
[[nodiscard]] inline Window window_of(Pass pass, std::int32_t scale, int fraction_bits = machine_fraction_bits,
                                      int word_bits = machine_word_bits) {
  const std::int32_t unit = std::int32_t{1} << fraction_bits;
  Window window;
  window.xlo = window.ylo = -512 * unit;
  window.xhi = window.yhi = 511 * unit;
  window.width_scale = scale * unit;
  if (pass != Pass::mono) {
    window.width_scale = (scale >> 1) * unit;
    window.xlo = -256 * unit;
    window.xhi = 255 * unit;
    window.centre_x = pass == Pass::left ? 256 : 768;
  }
  while (window.bound_factor * window.width_scale < 1024 * unit) window.bound_factor *= 2;
  const std::int64_t farthest = std::int64_t{window.bound_factor} * window.width_scale;
  if (farthest > std::int64_t{1} << (word_bits - 3)) window.bound_factor = 1;
  return window;
}

// A line piece as it left the clip: the vector word that drew it, and its position.
template <class Coordinate>
struct BasicPiece {
  std::uint16_t vector_address = 0;
  Pass pass = Pass::mono;
  BasicScreenSegment<Coordinate> line;  // units relative to the centre of its window, 2^fraction_bits to a point
  bool drawn = true;                    // false: both ends are on the same point of the screen

  friend bool operator==(const BasicPiece&, const BasicPiece&) = default;
};
using Piece = BasicPiece<std::int32_t>;

}  // namespace sightline::programs::jones
