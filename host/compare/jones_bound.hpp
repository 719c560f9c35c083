// Bounds the distance of the lines that Jones's program draws of a view from the exact ones, from the lengths of its
// words.
//
// The search is repeated with exact masks in floating point. Each side of a mask and each line carries the greatest
// distance of the computed one from it, at each end, at right angles:
//   - a projected coordinate is rounded: half a unit each;
//   - where a line or a side of an opening is cut, the new end is rounded again, by half a unit in each coordinate
//     that is no value of the cutting line; the parameter of the cut has lost bits to the length of a word:
//     2^(2 - word) of the length that is cut;
//   - an end made by a computed side is as far from the exact end as the side's error, divided by the sine of the
//     angle between them; but it is no farther from the cutting side's own line, which is drawn there, than the sum
//     of the errors of side and line.
// A unit is 2^-f points, f the fraction bits (SPECIFICATION.md of firmware/pdp7/jones, sections 1 to 4).
//
// No drawn line is farther from the exact lines. An exact line may be farther from the drawn ones: where two openings
// meet in a side that is no line, the masks are rounded independently, and a line in the gap between them, at a small
// angle to it, is drawn through neither. Word lengths do not bound the length of such a stretch. The views compared
// with this bound have none.
#pragma once

#include <optional>

#include "host/programs/jones/specification.hpp"
#include "host/programs/jones/twin/rotation.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::compare {

struct JonesWords {
  int word_bits = programs::jones::machine_word_bits;
  int fraction_bits = programs::jones::machine_fraction_bits;

  friend bool operator==(const JonesWords&, const JonesWords&) = default;
};

// For pieces before they are rounded to points, in points of the display, at a scale of 512. The scene is a checked
// one, and the eye in one of its cells (preconditions).
// direction: of a view turned about the vertical, which is taken as exact; the words must be the machine's.
[[nodiscard]] double jones_piece_bound(const scene::CellScene& scene, const geometry::Point& eye, const JonesWords& words,
                                       const std::optional<programs::jones::Direction>& direction = {});

// For pieces between points of the display.
[[nodiscard]] double jones_line_bound(double piece_bound, const JonesWords& words);
// For the lit points, including the beam's deviation within a vector.
[[nodiscard]] double jones_flash_bound(double line_bound);

}  // namespace sightline::compare
