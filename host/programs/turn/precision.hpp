// Bounds of the distance between the program's picture and the exact one at the machine's angle, from the lengths of its
// words.
//
// firmware/pdp7/turn/NOTES.md, "How exact the picture is", derives each of them. Left out: the path of the beam between the
// ends of a vector word (bounded by vector_wander) and everything but rounding: the structure is exact.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/programs/turn/screen_view.hpp"
#include "host/programs/turn/tape.hpp"

namespace sightline::programs::turn {

// Error of the program's cosine and sine of an angle, as a vector, in 2^-14. All angles are tested.
inline constexpr double rotation_error = 1.12;
// Distance of a corner between the vector words of a line from the straight line between its ends, in points of the
// display.
inline constexpr double corner_error = 0.5;
// Distance of a flash from the straight line of its vector word, in points, caused by the Type 340's rate multiplier. All
// words are tested. Along the line the next flash is at most a diagonal step away.
inline constexpr double vector_wander = 1.55;
inline constexpr double flash_step = 1.4143;

// One end of a visible piece of an edge.
struct EndBound {
  bool junction = false;
  double at = 0;     // position on the slot's edge, 0 to 1 from the slot's first vertex, by the words of the tape
  double along = 0;  // error of that position, as a part of the edge
  double x = 0;      // error of the end's position on the display, in points
  double y = 0;
};

struct PieceBound {
  std::uint32_t slot = 0;
  double length = 0;  // of its edge in the image, in points
  std::array<EndBound, 2> ends;
  // The program may find its ends in the wrong order; then it does not draw the piece.
  bool may_be_missing = false;
};

class Precision {
 public:
  // The tape must outlive the object.
  explicit Precision(const Tape& tape) : tape_(tape) {}

  // The bounds of every piece that the states of the slots (Twin::state, one for each) show at an angle. The exact picture
  // may be at another angle between the same events, in radians: then its T-junctions are elsewhere on their edges.
  [[nodiscard]] std::vector<PieceBound> pieces(std::span<const std::uint32_t> states, std::uint32_t angle) const {
    return pieces(states, angle, radians(angle));
  }
  [[nodiscard]] std::vector<PieceBound> pieces(std::span<const std::uint32_t> states, std::uint32_t angle, double of_picture) const;

 private:
  // The unrounded value of a form at an angle, and the error of the program's value from that of the form before it was
  // rounded for the tape, in the form's units.
  struct Value {
    double value = 0;
    double error = 0;
  };
  [[nodiscard]] std::uint32_t word(std::uint32_t address) const { return tape_.words[address - model_base(tape_.memory)].value(); }
  [[nodiscard]] Value form(std::uint32_t address, double angle) const;
  [[nodiscard]] EndBound end(std::uint32_t slot, std::uint32_t code, bool second, double angle, double of_picture) const;

  const Tape& tape_;
};

// The Hausdorff distance between the lines of the whole picture and the exact ones, in points. Vector words are taken as
// straight lines; for the flashes of the display add flash_bound.
[[nodiscard]] double picture_bound(std::span<const PieceBound> pieces);
[[nodiscard]] double flash_bound();

}  // namespace sightline::programs::turn
