// Directions at which the topology of the image may change: potential events, before anything is asked about
// what is visible (Plantinga, Seales and Dyer 1990, section 3).
//
//   EV   a vertex and an edge appear to meet: linear
//   FE   a face is edge-on: linear; the paper leaves it out, and without it T-junctions stay on the wrong
//        side of a face that has turned
//   EEE  three edges appear to meet: quadratic
//
// In image coordinates u = x Z - z X, v = y, depth w = x X + z Z (nearer: larger), nothing is divided. For
// edges p1 + s a1 and pi + si ai: Ni = (pi - p1) x ai, Di = a1 x ai, Mi = (pi - p1) x a1, as linear forms of
// the direction; then s = Ni / Di and si = Mi / Di (equation 5a and its companion).
//
// Coordinates keep below 2^23.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/algorithms/plantinga/direction.hpp"
#include "host/geometry/predicates.hpp"

namespace sightline::algorithms::plantinga {

using geometry::Vector3;

inline constexpr std::int64_t event_coordinate_limit = std::int64_t{1} << 23;

struct Segment {
  Vector3 from{};
  Vector3 to{};

  [[nodiscard]] Vector3 along() const { return {to[0] - from[0], to[1] - from[1], to[2] - from[2]}; }
};

[[nodiscard]] constexpr Vector3 minus(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// v . n for a direction v: the line of sight has no y.
[[nodiscard]] constexpr LinearForm form_of(const Vector3& n) {
  return {n[0], n[2]};
}

// The forms N, D and M of edge `other` against `edge`.
struct Crossing {
  LinearForm n;
  LinearForm d;
  LinearForm m;
};
[[nodiscard]] Crossing crossing_of(const Segment& edge, const Segment& other);

// N2 D3 - N3 D2, which is 0 where the three meet.
[[nodiscard]] QuadraticForm meeting_form(const Crossing& second, const Crossing& third);

// The two opposite directions in which a vertex is seen on the edge; none if the edge is parallel to the
// plane of rotation (P8: they meet always or never), the vertex above or below it, or on it.
[[nodiscard]] std::vector<Direction> vertex_edge_events(const Vector3& vertex, const Segment& edge);
// None for a face parallel to the plane of rotation, which is edge-on always (P16).
[[nodiscard]] std::vector<Direction> face_edge_on_events(const Vector3& normal);
// The directions in which the three appear to meet inside all of them and change their order; where they meet
// at an end it is an EV event (P17).
[[nodiscard]] std::vector<Direction> three_edge_events(const std::array<Segment, 3>& edges);

// Ascending, equal ones once.
void sort_and_group(std::vector<Direction>& directions);

}  // namespace sightline::algorithms::plantinga
