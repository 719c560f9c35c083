#include "host/algorithms/plantinga/potential_events.hpp"

#include <algorithm>

namespace sightline::algorithms::plantinga {
namespace {

// Whether 0 < n / d < 1 at a direction.
bool inside(const Direction& direction, const LinearForm& n, const LinearForm& d) {
  const int below = sign_at(direction, d);
  return below != 0 && sign_at(direction, n) == below && sign_at(direction, {d.x - n.x, d.z - n.z}) == below;
}

}  // namespace

Crossing crossing_of(const Segment& edge, const Segment& other) {
  const Vector3 a1 = edge.along();
  const Vector3 a2 = other.along();
  const Vector3 between = minus(other.from, edge.from);
  return {form_of(geometry::cross(between, a2)), form_of(geometry::cross(a1, a2)),
          form_of(geometry::cross(between, a1))};
}

QuadraticForm meeting_form(const Crossing& second, const Crossing& third) {
  const LinearForm& n2 = second.n;
  const LinearForm& d2 = second.d;
  const LinearForm& n3 = third.n;
  const LinearForm& d3 = third.d;
  return {Int128{n2.x} * d3.x - Int128{n3.x} * d2.x,
          Int128{n2.x} * d3.z + Int128{n2.z} * d3.x - Int128{n3.x} * d2.z - Int128{n3.z} * d2.x,
          Int128{n2.z} * d3.z - Int128{n3.z} * d2.z};
}

std::vector<Direction> vertex_edge_events(const Vector3& vertex, const Segment& edge) {
  const auto [low, high] = std::minmax(edge.from[1], edge.to[1]);
  if (low == high || vertex[1] < low || vertex[1] > high) return {};
  return roots_of(form_of(geometry::cross(minus(vertex, edge.from), edge.along())));
}

std::vector<Direction> face_edge_on_events(const Vector3& normal) {
  return roots_of(form_of(normal));
}

std::vector<Direction> three_edge_events(const std::array<Segment, 3>& edges) {
  const Crossing second = crossing_of(edges[0], edges[1]);
  const Crossing third = crossing_of(edges[0], edges[2]);
  std::vector<Direction> found = roots_of(meeting_form(second, third));
  const auto apart = [&](const Direction& direction) {
    return !inside(direction, second.n, second.d) || !inside(direction, second.m, second.d) ||
           !inside(direction, third.n, third.d) || !inside(direction, third.m, third.d);
  };
  found.erase(std::remove_if(found.begin(), found.end(), apart), found.end());
  return found;
}

void sort_and_group(std::vector<Direction>& directions) {
  std::sort(directions.begin(), directions.end(), less);
  directions.erase(std::unique(directions.begin(), directions.end()), directions.end());
}

}  // namespace sightline::algorithms::plantinga
