// The edge structure graph (ESG) of one view, which steps through the events of a turn: the on-line phase of Plantinga,
// Seales and Dyer (1990), section 4.
//
// Pieces are in one array with holes; those of an edge are linked. A step changes only the edges of its event. It checks
// that the pieces it removes exist, so a list that lacks an event is detected.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/plantinga/event_list.hpp"

namespace sightline::algorithms::plantinga {

inline constexpr std::uint32_t no_edge = 0xFFFFFFFF;

struct LivePiece {
  EdgeIndex edge = no_edge;  // no_edge: a hole
  Piece piece;
  std::uint32_t next = no_edge;  // next piece of the same edge
};

class EdgeStructureGraph {
 public:
  // The graph starts before the first event, just after -pi. Precondition: the list outlives the graph and belongs to a
  // model with as many edges as list.first has entries.
  explicit EdgeStructureGraph(const EventList& list);

  // Number of events passed since -pi, at most list.events.size().
  [[nodiscard]] std::size_t passed() const { return passed_; }
  [[nodiscard]] std::span<const LivePiece> pieces() const { return pieces_; }
  [[nodiscard]] std::size_t piece_count() const { return count_; }
  [[nodiscard]] EdgeStructure structure_of(EdgeIndex edge) const;

  // Passes one event, circularly. Returns false and does nothing if the list does not fit the graph.
  bool step_forward();
  bool step_backward();
  // Goes the shorter way to an angle in radians; events at or before it are then passed. Returns false if a step does.
  bool turn_to(double angle);
  // Goes the shorter way to the place where `passed` events are passed, at most list.events.size(). Returns false if a
  // step does.
  bool turn_to_place(std::size_t passed);

 private:
  bool apply(const Event& event, bool forward);
  void replace(EdgeIndex edge, std::span<const Piece> pieces);
  [[nodiscard]] bool is(EdgeIndex edge, std::span<const Piece> pieces) const;

  const EventList& list_;
  std::vector<double> angles_;  // of the events
  std::vector<LivePiece> pieces_;
  std::vector<std::uint32_t> first_;  // first piece of each edge
  std::uint32_t hole_ = no_edge;      // first hole; holes are linked, too
  std::size_t passed_ = 0;
  std::size_t count_ = 0;
};

}  // namespace sightline::algorithms::plantinga
