// The events that the algorithm reports to a listener. Loops without a listener are compiled separately and have no cost
// for it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/plantinga/edge_structure.hpp"

namespace sightline::algorithms::plantinga {

// Why a direction is a potential event of an edge. EV and EEE are the paper's (section 2, figures 3 to 5).
enum class EventKind : std::uint8_t {
  own_face,         // a face at the edge is edge-on: first is the face
  face_edge_on,     // a face before the edge is edge-on: first is the face
  vertex_in_front,  // EV: a nearer vertex is on the image of the edge: first is the vertex
  vertex_behind,    // EV: an end of the edge is behind a nearer edge: first is the vertex, second the nearer edge
  three_edges,      // EEE: two nearer edges cross on the edge: first and second are these edges
  edge_pair,        // the plane of two nearer edges that meet in a vertex, but in no face, is edge-on: first and second
  own_plane,        // the plane of the edge and an edge that meets it in a vertex is edge-on: first is that edge
  in_line,          // the edge and another edge in one plane are collinear in the image: first is that edge
  passage,          // the edge passes through the plane of a face behind another edge: first is the face, second the other edge
};

struct PotentialEvent {
  EventKind kind = EventKind::own_face;
  EdgeIndex edge = 0;  // whose structure may change
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  Direction direction;
};

class Trace {
 public:
  virtual ~Trace() = default;

  // The initial picture, from scratch. Edges are reported in order; for each: start, comparisons with faces, end.
  virtual void scratch_begins(EdgeIndex edge, std::span<const Occluder> occluders) = 0;
  // The face covers the edge from low to high on one side of its line in the image; usually it is reported for both
  // sides. A part is hidden if faces cover it on both sides.

  virtual void scratch_covers(EdgeIndex edge, FaceIndex face, double low, double high) = 0;
  // What is left of the edge. `compared` is false if all its faces are turned away, or its image is a point.
  virtual void scratch_ends(EdgeIndex edge, bool compared, const EdgeStructure& left) = 0;

  // Preprocessing. Edges are reported in order; for each: start, potential events, comparisons ordered by direction.
  virtual void study_begins(EdgeIndex edge, std::span<const Occluder> occluders) = 0;
  // An event that the filter keeps. Several may have the same direction.
  virtual void potential(const PotentialEvent& event) = 0;
  // An event that the filter drops: its point is hidden, or one of its edges is not a contour.
  virtual void dropped(EventKind kind, EdgeIndex edge) = 0;
  // The structures of the edge before and after a direction. It is an event if they differ.
  virtual void compared(EdgeIndex edge, const Direction& direction, const EdgeStructure& before, const EdgeStructure& after) = 0;
  virtual void study_ends(EdgeIndex edge, const EdgeHistory& history) = 0;
};

// The listener that does nothing.
struct NoListener {
  template <class Fraction>
  void hides(EdgeIndex, FaceIndex, const Fraction&, const Fraction&) {}
  void potential(EventKind, EdgeIndex, std::uint32_t, std::uint32_t, const Direction&) {}
  void dropped(EventKind, EdgeIndex) {}
};

// Forwards everything to a Trace.
class TraceListener {
 public:
  explicit TraceListener(Trace& trace) : trace_(&trace) {}

  template <class Fraction>
  void hides(EdgeIndex edge, FaceIndex face, const Fraction& low, const Fraction& high) {
    trace_->scratch_covers(edge, face, value_of(low), value_of(high));
  }
  void potential(EventKind kind, EdgeIndex edge, std::uint32_t first, std::uint32_t second, const Direction& direction) {
    trace_->potential({kind, edge, first, second, direction});
  }
  void dropped(EventKind kind, EdgeIndex edge) { trace_->dropped(kind, edge); }

 private:
  template <class Fraction>
  static double value_of(const Fraction& fraction) {
    return static_cast<double>(fraction.part) / static_cast<double>(fraction.whole);
  }

  Trace* trace_;
};

}  // namespace sightline::algorithms::plantinga
