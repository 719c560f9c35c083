#include "host/algorithms/skala/facing.hpp"

namespace sightline::algorithms::skala {
namespace {

// Twice the area; the coordinates have 24 bits, so that this is exact.
double turn(Vertex a, Vertex b, Vertex c) {
  const double ux = double{b.x} - double{a.x};
  const double uy = double{b.y} - double{a.y};
  const double vx = double{c.x} - double{a.x};
  const double vy = double{c.y} - double{a.y};
  return ux * vy - uy * vx;
}

}  // namespace

bool cell_defined(const Surface& surface, std::size_t row, std::size_t column) {
  return row + 1 < surface.rows() && column + 1 < surface.columns() && surface.defined(row, column) &&
         surface.defined(row, column + 1) && surface.defined(row + 1, column) &&
         surface.defined(row + 1, column + 1);
}

Side side_of(const Surface& surface, std::size_t row, std::size_t column, Half half) {
  if (!cell_defined(surface, row, column)) return Side::none;
  const Vertex& near = surface.at(row, column);
  const Vertex& beside = surface.at(row, column + 1);
  const Vertex& behind = surface.at(row + 1, column);
  const Vertex& far = surface.at(row + 1, column + 1);
  const double area = half == Half::near ? turn(near, beside, behind) : turn(far, behind, beside);
  if (area == 0) return Side::none;
  return area > 0 ? Side::anticlockwise : Side::clockwise;
}

double middle_of(const Surface& surface, std::size_t row, std::size_t column) {
  return double{surface.at(row, column).y} + double{surface.at(row, column + 1).y} + double{surface.at(row + 1, column).y} +
         double{surface.at(row + 1, column + 1).y};
}

}  // namespace sightline::algorithms::skala
