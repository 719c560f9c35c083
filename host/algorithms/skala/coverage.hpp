// Where on the screen the surface is: what it hides of lines that lie behind it.
//
// By column as in horizon.hpp, but as a set of intervals: through a hole one sees what is behind, and between two surfaces, too. The surface
// is two flat triangles a cell (facing.hpp). Of whole surfaces it hides what lies behind all of them: the far edges of the box around
// them, contours on the floor of that box. Filled triangle by triangle from near to far, it hides what comes next.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/algorithms/skala/surface.hpp"

namespace sightline::algorithms::skala {

// Parts of a line, 0 at its beginning to 1 at its end.
struct LinePart {
  double from = 0;
  double to = 1;
};

class Coverage {
 public:
  explicit Coverage(int columns) : columns_(static_cast<std::size_t>(columns)) {}

  // Every cell, as triangles or by its edges.
  void add(const Surface& surface, bool triangles = true);
  // What lines between these, one after the other and back, enclose in every column.
  void add(std::span<const Vertex> outline);
  // The extremes of a column; beyond 10^29 there is nothing.
  [[nodiscard]] float top(std::size_t column) const { return columns_[column].empty() ? -1e30F : columns_[column].back().high; }
  [[nodiscard]] float bottom(std::size_t column) const { return columns_[column].empty() ? 1e30F : columns_[column].front().low; }
  [[nodiscard]] std::size_t columns() const { return columns_.size(); }

  // What a few columns hold, to be put back.
  struct Saved;
  [[nodiscard]] Saved saved(float from, float to) const;
  void restore(const Saved& saved);

  // What the surface does not hide, in order. Lines that touch its outline from within 1/64 of a unit are seen.
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
