// Where on the screen the whole surface is: what it hides of lines that lie behind all of it, such as the far edges of the box
// around it and contours on the floor of that box.
//
// By column as in horizon.hpp, but as a set of intervals: through a hole one sees what is behind. The surface is two flat
// triangles a cell (facing.hpp).
#pragma once

#include <cstddef>
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
  Coverage(const Surface& surface, int columns);

  // What the surface does not hide, in order. Lines that touch its outline from within 1/64 of a unit are seen.
  [[nodiscard]] std::vector<LinePart> visible(Vertex from, Vertex to) const;

 private:
  struct Interval {
    float low = 0;
    float high = 0;
  };
  using Column = std::vector<Interval>;  // ascending, disjoint

  void add_triangle(Vertex a, Vertex b, Vertex c);
  void add(std::size_t column, Interval interval);
  [[nodiscard]] const Column& column(double x) const;
  void hide(Vertex from, Vertex to, double begin, double end, std::vector<LinePart>& hidden) const;

  std::vector<Column> columns_;
};

}  // namespace sightline::algorithms::skala
