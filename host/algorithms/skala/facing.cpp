#include "host/algorithms/skala/facing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace sightline::algorithms::skala {
namespace {

// Twice the signed area. Coordinates have 24 bits, so this is exact.
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

bool is_outline(const Surface& surface, std::size_t from_row, std::size_t from_column, std::size_t to_row, std::size_t to_column, int columns) {
  struct Place {
    double x = 0;
    double y = 0;
  };
  const auto place = [&](std::size_t row, std::size_t column) {
    const Vertex& vertex = surface.at(row, column);
    return Place{vertex.x * (picture_extent / columns), vertex.y};
  };
  const auto side = [](Place a, Place b, Place p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
  const Place from = place(from_row, from_column);
  const Place to = place(to_row, to_column);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length == 0) return false;
  // The triangles of the cells around both ends. The two at the edge show on which side of it the surface is.
  constexpr std::size_t around = 1;
  const auto low = [](std::size_t a, std::size_t b) { return std::min(a, b) - std::min(std::min(a, b), around + 1); };
  const std::size_t last_row = std::min(std::max(from_row, to_row) + around, surface.rows() - 2);
  const std::size_t last_column = std::min(std::max(from_column, to_column) + around, surface.columns() - 2);
  std::vector<std::array<Place, 3>> triangles;
  double within = 0;
  for (std::size_t row = low(from_row, to_row); row <= last_row; ++row)
    for (std::size_t column = low(from_column, to_column); column <= last_column; ++column) {
      if (!cell_defined(surface, row, column)) continue;
      using Corner = std::pair<std::size_t, std::size_t>;
      const Corner beside{row, column + 1};
      const Corner behind{row + 1, column};
      for (const Corner& third : {Corner{row, column}, Corner{row + 1, column + 1}}) {
        const std::array corners{beside, behind, third};
        std::array<Place, 3> places;
        for (std::size_t i = 0; i < 3; ++i) places[i] = place(corners[i].first, corners[i].second);
        int shared = 0;
        double farthest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          if (corners[i] == Corner{from_row, from_column} || corners[i] == Corner{to_row, to_column}) ++shared;
          else farthest = side(from, to, places[i]);
        }
        if (shared == 2) within += farthest;
        else triangles.push_back(places);
      }
    }
  // A little beyond points of the edge, which is drawn or omitted as a whole.
  const double beyond = (within > 0 ? -0.02 : 0.02) / length;
  constexpr std::array places_on_edge{0.2, 0.35, 0.5, 0.65, 0.8};
  return std::any_of(places_on_edge.begin(), places_on_edge.end(), [&](double t) {
    const Place p{from.x + t * (to.x - from.x) - beyond * (to.y - from.y), from.y + t * (to.y - from.y) + beyond * (to.x - from.x)};
    return std::none_of(triangles.begin(), triangles.end(), [&](const std::array<Place, 3>& corners) {
      const double a = side(corners[0], corners[1], p);
      const double b = side(corners[1], corners[2], p);
      const double c = side(corners[2], corners[0], p);
      return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
    });
  });
}

double middle_of(const Surface& surface, std::size_t row, std::size_t column) {
  return double{surface.at(row, column).y} + double{surface.at(row, column + 1).y} + double{surface.at(row + 1, column).y} +
         double{surface.at(row + 1, column + 1).y};
}

}  // namespace sightline::algorithms::skala
