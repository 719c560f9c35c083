// How far the lines that Jones's program draws of one view can be from the exact ones: bounds from the lengths of its words.
//
// The search is gone through again with exact masks in floating point. Beside each side of a mask and each line goes how far the
// computed one can be from it, at each end, at right angles:
//   - a projected coordinate is rounded: half a unit each;
//   - where a line or a side of an opening is cut, the new end is rounded again, by half a unit in each coordinate that is no
//     value of the cutting line; the share in which it is cut has lost bits to the length of a word: 2^(2 - word) of the
//     length that is cut;
//   - what is cut by a computed side ends as far from the exact end as the side is off, divided by the sine of the angle
//     between them. But the end is then no farther from the cutting side's own line, which is drawn there, than side and line
//     are off together.
// A unit is 2^-f points, f the fraction bits (SPECIFICATION.md of firmware/pdp7/jones, sections 1 to 4).
//
// What is drawn is no farther from the exact lines. An exact line can be: where two openings meet in a side that is no line,
// the masks are rounded each for itself, and what runs in the gap between them, at a small angle to it, is drawn through
// neither. No length of words bounds how long such a stretch is; in the views compared at this bound there is none.
#pragma once

#include "host/programs/jones/specification.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::compare {

struct JonesWords {
  int word_bits = programs::jones::machine_word_bits;
  int fraction_bits = programs::jones::machine_fraction_bits;

  friend bool operator==(const JonesWords&, const JonesWords&) = default;
};

// Of the pieces before they are put on points, in points of the display, at a scale of 512. The scene is a checked one, and the
// eye in one of its cells (preconditions).
[[nodiscard]] double jones_piece_bound(const scene::CellScene& scene, const geometry::Point& eye, const JonesWords& words);

// The same of pieces between whole points of the display.
[[nodiscard]] double jones_line_bound(double piece_bound, const JonesWords& words);
// And of the points lit, the beam's way in a vector included.
[[nodiscard]] double jones_flash_bound(double line_bound);

}  // namespace sightline::compare
