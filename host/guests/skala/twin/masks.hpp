// The masks of the Skala program: in every column of the screen the strip [MB, MT] behind which nothing is
// seen, and the one column that is being visited. Source: firmware/i8080/skala/SPECIFICATION.md sections 2
// and 4; the strip is the paper's MaskTop and MaskBottom, the pending column stands for its M1T and M1B.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/guests/skala/twin/twin.hpp"
#include "host/guests/skala/twin/line.hpp"

namespace sightline::harness {

// Dots of one column, from one row to another, both included and in either order.
struct SkalaFoldLine {
  std::uint8_t x = 0;
  std::uint8_t from = 0;
  std::uint8_t to = 0;
};

// Where the surface turned away from the eye in a column just folded.
struct SkalaFoldLines {
  std::optional<SkalaFoldLine> top;
  std::optional<SkalaFoldLine> bottom;
};

class SkalaMasks {
 public:
  // Works on the masks and fold flags in `columns`, which must outlive it.
  explicit SkalaMasks(SkalaColumns& columns) : columns_(columns) { reset(); }

  void reset();

  [[nodiscard]] bool visited(std::uint8_t x) const {
    return columns_.mask_top[x] != 0 || columns_.mask_bottom[x] != 255;
  }
  // The test of DRAW and SURFACE: strictly outside the strip.
  [[nodiscard]] bool outside(SkalaPoint point) const {
    return point.y > columns_.mask_top[point.x] || point.y < columns_.mask_bottom[point.x];
  }
  [[nodiscard]] bool on_border(SkalaPoint point) const {
    return point.y == columns_.mask_top[point.x] || point.y == columns_.mask_bottom[point.x];
  }
  // The test of TESTDRAW: outside, or in the outermost two rows of the strip; or outside or on the border of
  // the strip in a column beside it that has been visited.
  [[nodiscard]] bool outside_with_slack(SkalaPoint point) const;

  // The point belongs to the pending column. The fold lines are those of the column that was pending before.
  SkalaFoldLines touch(SkalaPoint point);
  SkalaFoldLines fold();

 private:
  struct Pending {
    std::uint8_t x;
    std::uint8_t low;
    std::uint8_t high;
  };

  [[nodiscard]] std::optional<SkalaFoldLine> fold_top(const Pending& column);
  [[nodiscard]] std::optional<SkalaFoldLine> fold_bottom(const Pending& column);
  [[nodiscard]] std::vector<std::uint8_t> visited_neighbours(std::uint8_t x) const;

  SkalaColumns& columns_;
  std::optional<Pending> pending_;
};

}  // namespace sightline::harness
