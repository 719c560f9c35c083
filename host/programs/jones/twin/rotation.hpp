// The view of Jones's program turned about the vertical (-D ROTATE=1), in C++: where a corner is on the screen and what is
// left of a level vector between the sides of the view, written only from firmware/pdp7/jones/SPECIFICATION.md section 10.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "host/programs/jones/specification.hpp"
#include "host/programs/jones/twin/number.hpp"

namespace sightline::programs::jones {

// Of the view, times 2^16.
struct Direction {
  std::int32_t cosine = 1 << 16;
  std::int32_t sine = 0;
};
// degrees: to the right of +z, any number.
[[nodiscard]] Direction direction_of(std::int32_t degrees);
// 0..359.
[[nodiscard]] std::int32_t whole_turn(std::int32_t degrees);

// A number of units along x and along z, as sums of the words that the switches give, turned to where the view looks; what is
// left below a unit stays for the next.
class TurnedSteps {
 public:
  // x and z in the scene.
  [[nodiscard]] std::array<std::int32_t, 2> take(const Direction& direction, std::int32_t right, std::int32_t ahead);

 private:
  std::array<std::int64_t, 2> rest_{1 << 15, 1 << 15};
};

// From the eye, as the view looks, times 2^16.
struct TurnedPlace {
  std::int64_t x = 0, z = 0;
};

// The sides of the view beyond which a point is.
enum Beyond : unsigned { beyond_none = 0, beyond_right = 1, beyond_left = 2, beyond_both = 3, beyond_eye = 4 };

struct SeenCorner {
  unsigned beyond = beyond_none;
  ScreenPoint place;       // only between the sides
  bool drawn_back = false;  // in y, to the bound
};

// A level vector between the sides of the view.
struct SeenLevel {
  SeenCorner a, b;                  // `beyond`: the side to which the end was moved
  std::optional<ScreenPoint> bend;  // where it meets the bound in y
};

class RotatedView {
 public:
  RotatedView(const Direction& direction, const Window& window, const ShortWords& number);

  // The place after a vector.
  [[nodiscard]] TurnedPlace moved(TurnedPlace place, Axis axis, std::int32_t units) const;
  // nullopt: z is too large.
  [[nodiscard]] std::optional<SeenCorner> corner(const TurnedPlace& place, std::int32_t y) const;
  // at: a point of the vector, which is along x or z; a, b: its ends. nullopt: nothing of it is between the sides.
  [[nodiscard]] std::optional<SeenLevel> level(Axis axis, const SpacePoint& at, const SeenCorner& a, const SeenCorner& b) const;
  // The corner of the bound at this side; y: whose sign it has.
  [[nodiscard]] ScreenPoint bound_corner(unsigned side, std::int32_t y) const;

 private:
  struct Line {
    std::int32_t w, y, alpha, beta;
  };
  struct Quotient {
    std::int32_t value;
    bool drawn_back;
  };
  [[nodiscard]] Quotient quotient(std::int64_t t, std::int64_t d) const;
  [[nodiscard]] std::optional<SeenCorner> moved_to_side(const Line& line, const SeenCorner& end, const SeenCorner& other) const;
  [[nodiscard]] ScreenPoint bend(const Line& line) const;

  Direction direction_;
  ShortWords number_;
  std::int32_t bound_;  // K W
  int shift_ = 0;       // K = 2^shift
};

}  // namespace sightline::programs::jones
