#include "host/explain/cell_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sightline::explain {
namespace {

// How far a point one unit deeper is shifted to the right and up.
constexpr double shift_right = 0.45;
constexpr double shift_up = 0.3;

// The points with normal . p <= offset.
struct Side {
  Space normal{};
  double offset = 0;
};

// Of length 1, so that values are distances.
Side side_of(const scene::CellComplex& complex, std::uint32_t number, bool turned) {
  const geometry::Plane& plane = complex.planes[number];
  Space normal = geometry::real_vector(plane.normal);
  const double scale = (turned ? -1 : 1) / geometry::length(normal);
  for (double& part : normal) part *= scale;
  return {normal, scale * static_cast<double>(plane.offset)};
}

std::optional<Space> common_point(const Side& a, const Side& b, const Side& c) {
  const Space bc = geometry::cross(b.normal, c.normal);
  const Space ca = geometry::cross(c.normal, a.normal);
  const Space ab = geometry::cross(a.normal, b.normal);
  const double volume = geometry::dot(a.normal, bc);
  if (std::abs(volume) < 1e-12) return std::nullopt;
  Space point{};
  for (std::size_t i = 0; i < 3; ++i) point[i] = (a.offset * bc[i] + b.offset * ca[i] + c.offset * ab[i]) / volume;
  return point;
}

// The part of the line of two sides that is inside all others; nothing if it is shorter than `shortest`.
std::optional<CellEdge> edge_between(const std::vector<Side>& sides, std::size_t a, std::size_t b, double shortest) {
  Space along = geometry::cross(sides[a].normal, sides[b].normal);
  if (geometry::length(along) < 1e-9) return std::nullopt;
  along = geometry::unit(along);
  const auto start = common_point(sides[a], sides[b], {along, 0});
  if (!start) return std::nullopt;
  double low = -1e300;
  double high = 1e300;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == a || i == b) continue;
    const double slope = geometry::dot(sides[i].normal, along);
    const double left = sides[i].offset - geometry::dot(sides[i].normal, *start);
    if (std::abs(slope) < 1e-9) {
      if (left < -shortest) return std::nullopt;
    } else if (slope > 0) {
      high = std::min(high, left / slope);
    } else {
      low = std::max(low, left / slope);
    }
  }
  if (!(high - low > shortest) || low < -1e299 || high > 1e299) return std::nullopt;
  const auto at = [&](double t) { return Space{(*start)[0] + t * along[0], (*start)[1] + t * along[1], (*start)[2] + t * along[2]}; };
  return CellEdge{at(low), at(high), {sides[a].normal, sides[b].normal}};
}

Space axis_near(const scene::PolyPoint& direction, const Space& besides, const Space& besides_too) {
  std::size_t found = 3;
  for (std::size_t a = 0; a < 3; ++a)
    if (besides[a] == 0 && besides_too[a] == 0 && (found == 3 || std::abs(direction[a]) > std::abs(direction[found]))) found = a;
  Space axis{};
  axis[found] = direction[found] < 0 ? -1 : 1;
  return axis;
}

}  // namespace

std::vector<Space> corners_of(const scene::CellComplex& complex, std::uint32_t opening) {
  const scene::ComplexOpening& found = complex.openings[opening];
  const auto sides = complex.sides_of(found);
  const Side plane = side_of(complex, found.plane, false);
  std::vector<Space> corners;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const scene::HalfSpace& next = sides[(i + 1) % sides.size()];
    if (const auto corner = common_point(plane, side_of(complex, sides[i].plane, false), side_of(complex, next.plane, false)))
      corners.push_back(*corner);
  }
  return corners;
}

std::vector<CellEdge> edges_of(const scene::CellComplex& complex, scene::CellNumber cell) {
  std::vector<Side> sides;
  for (const scene::HalfSpace& bound : complex.bounds_of(complex.cells[cell])) sides.push_back(side_of(complex, bound.plane, bound.turned));
  double size = 0;
  for (std::size_t a = 0; a < 3; ++a) size = std::max(size, static_cast<double>(complex.outer.high[a]) - static_cast<double>(complex.outer.low[a]));
  std::vector<CellEdge> edges;
  for (std::size_t a = 0; a < sides.size(); ++a)
    for (std::size_t b = a + 1; b < sides.size(); ++b)
      if (const auto edge = edge_between(sides, a, b, size * 1e-9)) edges.push_back(*edge);
  return edges;
}

Space middle_of(const std::vector<CellEdge>& edges) {
  Space middle{};
  for (const CellEdge& edge : edges)
    for (std::size_t a = 0; a < 3; ++a) middle[a] += (edge.from[a] + edge.to[a]) / (2 * static_cast<double>(edges.size()));
  return middle;
}

ObliqueView::ObliqueView(const scene::PolyCamera& camera) {
  up_ = axis_near(camera.up, {}, {});
  forward_ = axis_near(camera.forward, up_, {});
  right_ = axis_near(camera.right, up_, forward_);
}

Point ObliqueView::at(const Space& p) const {
  const double depth = geometry::dot(forward_, p);
  return {geometry::dot(right_, p) + shift_right * depth, geometry::dot(up_, p) + shift_up * depth};
}

// Points on a line towards the viewer have the same place: right and up balance the shift.
bool ObliqueView::faces_viewer(const Space& normal) const {
  return shift_right * geometry::dot(right_, normal) + shift_up * geometry::dot(up_, normal) - geometry::dot(forward_, normal) > 1e-9;
}

}  // namespace sightline::explain
