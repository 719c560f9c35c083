// The masks of the Skala program: in every column of the screen the strip [MB, MT] behind which nothing is
// seen, and the one column that is being visited. Source: firmware/i8080/skala/SPECIFICATION.md sections 2
// and 4; the strip is the paper's MaskTop and MaskBottom, the pending column stands for its M1T and M1B.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/guests/skala/twin/line.hpp"
#include "host/guests/skala/twin/twin.hpp"

namespace sightline::guests::skala {

// Dots of one column, from one row to another, both included and in either order.
struct FoldLine {
  std::uint8_t x = 0;
  std::uint8_t from = 0;
  std::uint8_t to = 0;
};

// Where the surface turned away from the eye in a column just folded.
struct FoldLines {
  std::optional<FoldLine> top;
  std::optional<FoldLine> bottom;
};

class Masks {
 public:
  // Works on the masks and fold flags in `columns`, which must outlive it.
  explicit Masks(Columns& columns) : columns_(columns) { reset(); }

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
  // The test of TESTDRAW: outside, or in the outermost two rows of the strip; or outside or on the border of
  // the strip in a column beside it that has been visited.
  [[nodiscard]] bool outside_with_slack(Point point) const;

  // The point belongs to the pending column. The fold lines are those of the column that was pending before.
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
  std::optional<Pending> pending_;
};

}  // namespace sightline::guests::skala
