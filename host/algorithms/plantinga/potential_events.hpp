// Computes potential events: directions at which the topology of the image may change, before visibility is considered
// (Plantinga, Seales and Dyer 1990, section 3).
//
//   EV   a vertex and an edge appear to meet: linear
//   FE   a face is edge-on: linear; the paper omits it, but without it T-junctions stay on the wrong side of a face
//        that has turned
//   EEE  three edges appear to meet: quadratic
//
// In image coordinates u = x Z - z X, v = y and depth w = x X + z Z (nearer is greater), no division is needed. For edges
// p1 + s a1 and pi + si ai, as linear forms of the direction: Ni = (pi - p1) x ai, Di = a1 x ai, Mi = (pi - p1) x a1;
// then s = Ni / Di and si = Mi / Di (equation 5a and its counterpart).
//
// Coordinates are below 2^23.
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

// v . n for a direction v, which has no y component.
[[nodiscard]] constexpr LinearForm form_of(const Vector3& n) {
  return {n[0], n[2]};
}

// The forms N, D and M of edge `other` relative to `edge`.
struct Crossing {
  LinearForm n;
  LinearForm d;
  LinearForm m;
};
[[nodiscard]] Crossing crossing_of(const Segment& edge, const Segment& other);

// N2 D3 - N3 D2, which is 0 where the three edges meet.
[[nodiscard]] QuadraticForm meeting_form(const Crossing& second, const Crossing& third);

// The two opposite directions in which a vertex is seen on the edge. None if the edge is parallel to the plane of
// rotation (P8: they meet always or never), or if the vertex is above, below or on the edge.
[[nodiscard]] std::vector<Direction> vertex_edge_events(const Vector3& vertex, const Segment& edge);
// None for a face parallel to the plane of rotation, which is always edge-on (P16).
[[nodiscard]] std::vector<Direction> face_edge_on_events(const Vector3& normal);
// The directions in which the three edges appear to meet, inside all of them, and change their order. Where they meet at
// an end, it is an EV event (P17).
[[nodiscard]] std::vector<Direction> three_edge_events(const std::array<Segment, 3>& edges);

// Sorts the directions and removes duplicates.
void sort_and_group(std::vector<Direction>& directions);

}  // namespace sightline::algorithms::plantinga
