// The part of the screen that surfaces cover, which hides lines behind it.
//
// Like horizon.hpp it works by column, but with a set of intervals, so that lines are visible through a hole and between
// two surfaces. The surface consists of two flat triangles per cell (facing.hpp). Filled with whole surfaces, it hides
// what lies behind all of them: the far edges of the box around them, and contours on the floor of that box. Filled
// triangle by triangle from near to far, it hides what is added next.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/algorithms/skala/surface.hpp"

namespace sightline::algorithms::skala {

// Part of a line, from 0 at its start to 1 at its end.
struct LinePart {
  double from = 0;
  double to = 1;
};

class Coverage {
 public:
  explicit Coverage(int columns) : columns_(static_cast<std::size_t>(columns)) {}

  // Adds every cell, as two triangles or by its edges.
  void add(const Surface& surface, bool triangles = true);
  // Adds, in every column, the area enclosed by a closed polygon.
  void add(std::span<const Vertex> outline);
  // The extremes of a column; a magnitude above 10^29 means that the column is empty.
  [[nodiscard]] float top(std::size_t column) const { return columns_[column].empty() ? -1e30F : columns_[column].back().high; }
  [[nodiscard]] float bottom(std::size_t column) const { return columns_[column].empty() ? 1e30F : columns_[column].front().low; }
  [[nodiscard]] std::size_t columns() const { return columns_.size(); }

  // The contents of several columns, to be restored later.
  struct Saved;
  [[nodiscard]] Saved saved(float from, float to) const;
  void restore(const Saved& saved);

  // The visible parts of a line, in order. A line that touches the outline from within, up to 1/64 of a unit, is visible.
  [[nodiscard]] std::vector<LinePart> visible(Vertex from, Vertex to) const;

 private:
  struct Interval {
    float low = 0;
    float high = 0;
  };
  using Column = std::vector<Interval>;  // ascending, disjoint

  void add(std::size_t column, Interval interval);
  [[nodiscard]] const Column& column(double x) const;
  void hide(Vertex from, Vertex to, double begin, double end, std::vector<LinePart>& hidden) const;

  std::vector<Column> columns_;

 public:
  struct Saved {
    std::size_t first = 0;
    std::vector<Column> columns;
  };
};

}  // namespace sightline::algorithms::skala
