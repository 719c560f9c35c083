// The visual events of a full turn about the y axis: the result of the preprocessing phase of Plantinga, Seales and Dyer
// (1990), which the on-line phase reads.
//
// An event is a direction at which the structure of one or more edges changes. Each change records the pieces removed and
// the pieces added, so that it can be undone. The list is circular: the structures before the first event and after the
// last one are equal.
//
// An angle tolerance moves every event up to its next multiple (or to pi), joins the changes of an edge that then
// coincide, and drops those that cancel. A structure is then wrong only at angles less than the tolerance after a true
// event.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/base/result.hpp"

namespace sightline::algorithms::plantinga {

// The change of one edge at one event, as ranges of EventList::pieces.
struct Change {
  EdgeIndex edge = 0;
  std::uint32_t removed = 0;  // first piece removed
  std::uint32_t added = 0;    // first piece added; the removed ones end here
  std::uint32_t end = 0;
};

struct Event {
  Direction direction;
  std::uint32_t first_change = 0;
  std::uint32_t change_count = 0;
};

struct EventList {
  std::uint64_t fingerprint = 0;     // of the model
  double tolerance = 0;              // radians
  std::vector<EdgeStructure> first;  // by edge: its structure before the first event
  std::vector<Event> events;         // ascending
  std::vector<Change> changes;       // those of one event are adjacent and ascend by edge
  std::vector<Piece> pieces;

  [[nodiscard]] std::span<const Change> changes_of(const Event& event) const {
    return {changes.data() + event.first_change, event.change_count};
  }
  [[nodiscard]] std::span<const Piece> removed_by(const Change& change) const {
    return {pieces.data() + change.removed, change.added - change.removed};
  }
  [[nodiscard]] std::span<const Piece> added_by(const Change& change) const {
    return {pieces.data() + change.added, change.end - change.added};
  }
};

// Appends one change to the last event. For code that builds lists.
void append_change(EventList& list, EdgeIndex edge, const EdgeStructure& before, const EdgeStructure& after);

struct BuildOptions {
  double tolerance = 0;                     // radians, at least 0
  std::uint64_t most_changes = 20'000'000;  // of all edges
  std::uint64_t most_pieces = 100'000'000;  // in all changes
  unsigned threads = 0;                     // 0: one for each core
  std::function<void(std::size_t done, std::size_t of)> progress =
      nullptr;  // counts edges; called from any thread, one at a time
  Trace* trace = nullptr;  // receives the steps for every edge; then only one thread is used
};

// The error says which limit was reached, and how many edges were done.
[[nodiscard]] base::Result<EventList> build_event_list(const RotationModel& model,
                                                       const BuildOptions& options = {});

}  // namespace sightline::algorithms::plantinga
