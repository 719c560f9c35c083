// The masks of the Skala program: in every column of the screen the strip [MB, MT] that hides everything behind it, and the
// column being visited. Source: firmware/i8080/skala/SPECIFICATION.md sections 2 and 4; the strip is the paper's MaskTop
// and MaskBottom, the pending column is its M1T and M1B.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "host/programs/skala/twin/twin.hpp"

namespace sightline::programs::skala {

// The two error terms of the Skala program: Bresenham's line with ties that do not depend on the direction of a segment,
// and a level that changes along it. Source: firmware/i8080/skala/SPECIFICATION.md sections 3 and 6.

struct Point {
  std::uint8_t x = 0;
  std::uint8_t y = 0;

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

[[nodiscard]] constexpr int sign_of(int value) {
  return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

// The number of steps from `from` to `to`: the first point is not a step, the last is.
[[nodiscard]] constexpr int line_steps(Point from, Point to) {
  const int u = to.x < from.x ? from.x - to.x : to.x - from.x;
  const int v = to.y < from.y ? from.y - to.y : to.y - from.y;
  return u >= v ? u : v;
}

// Calls step(point) for each step of the line, in order.
template <class Step>
constexpr void walk_line(Point from, Point to, Step&& step) {
  const int towards_x = sign_of(to.x - from.x);
  const int towards_y = sign_of(to.y - from.y);
  const int u = towards_x * (to.x - from.x);
  const int v = towards_y * (to.y - from.y);
  const bool x_is_major = u >= v;
  const int length = x_is_major ? u : v;
  const int minor = x_is_major ? v : u;
  int error = towards_x >= 0 ? -((length + 1) >> 1) : -((length >> 1) + 1);
  int x = from.x;
  int y = from.y;
  for (int i = 0; i < length; ++i) {
    error += minor;
    const bool minor_step = error >= 0;
    if (minor_step) error -= length;
    if (x_is_major || minor_step) x += towards_x;
    if (!x_is_major || minor_step) y += towards_y;
    step(Point{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)});
  }
}

// A level that goes from one value to another in a number of steps and arrives with the last. With 0 steps next() must not
// be called.
class LevelRamp {
 public:
  constexpr LevelRamp(int from, int to, int steps)
      : level_(from),
        towards_(sign_of(to - from)),
        change_(towards_ * (to - from)),
        steps_(steps),
        error_(-((steps + 1) >> 1)) {}

  // Advances one step; returns the level there.
  constexpr std::uint8_t next() {
    for (error_ += change_; error_ >= 0; error_ -= steps_) level_ += towards_;
    return static_cast<std::uint8_t>(level_);
  }

 private:
  int level_;
  int towards_;
  int change_;
  int steps_;
  int error_;
};

// Dots of one column, from one row to another, both included and in either order.
struct FoldLine {
  std::uint8_t x = 0;
  std::uint8_t from = 0;
  std::uint8_t to = 0;
};

// The lines where the surface turned away from the eye in a column just folded.
struct FoldLines {
  std::optional<FoldLine> top;
  std::optional<FoldLine> bottom;
};

class Masks {
 public:
  // Works on the masks and fold flags in `columns`, which must outlive it.
  // `direct`: each point changes the masks at once (section 10).
  Masks(Columns& columns, bool direct) : columns_(columns), direct_(direct) { reset(); }

  void reset();

  [[nodiscard]] bool visited(std::uint8_t x) const {
    return columns_.mask_top[x] != 0 || columns_.mask_bottom[x] != 255;
  }
  // The test of DRAW and SURFACE: strictly outside the strip.
  [[nodiscard]] bool outside(Point point) const {
    return point.y > columns_.mask_top[point.x] || point.y < columns_.mask_bottom[point.x];
  }
  [[nodiscard]] bool on_border(Point point) const {
    return point.y == columns_.mask_top[point.x] || point.y == columns_.mask_bottom[point.x];
  }
  // The test of TESTDRAW: outside, or in the outermost two rows of the strip; or outside or on the border of the strip in
  // an adjacent visited column.
  [[nodiscard]] bool outside_with_slack(Point point) const;

  // Adds the point to the pending column. The fold lines are those of the column that was pending before.
  FoldLines touch(Point point);
  FoldLines fold();

 private:
  struct Pending {
    std::uint8_t x;
    std::uint8_t low;
    std::uint8_t high;
  };

  [[nodiscard]] std::optional<FoldLine> fold_top(const Pending& column);
  [[nodiscard]] std::optional<FoldLine> fold_bottom(const Pending& column);
  [[nodiscard]] std::vector<std::uint8_t> visited_neighbours(std::uint8_t x) const;

  Columns& columns_;
  bool direct_;
  std::optional<Pending> pending_;
};

}  // namespace sightline::programs::skala
