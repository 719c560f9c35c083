// The visual events of a full turn about the y axis: what the preprocessing phase of Plantinga, Seales and
// Dyer (1990) makes and the on-line phase reads.
//
// An event is a direction at which the structure of one or more edges changes; with every change are the
// pieces that go and the pieces that come, so that it can be undone. The list is circular: before the first
// event and after the last the structure is the same.
//
// Knob: an angle tolerance moves every event up to the next multiple of it (or to pi), joins the changes of
// an edge that fall together and drops those that cancel. A structure is then wrong only at angles less than
// the tolerance after a true event.
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

// What becomes of one edge at one event: runs of EventList::pieces.
struct Change {
  EdgeIndex edge = 0;
  std::uint32_t removed = 0;  // first
  std::uint32_t added = 0;    // first; those removed end here
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
  std::vector<EdgeStructure> first;  // of every edge, before the first event
  std::vector<Event> events;         // ascending
  std::vector<Change> changes;       // of an event together, ascending by edge
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

// Appends one change to the last event. For makers of lists.
void append_change(EventList& list, EdgeIndex edge, const EdgeStructure& before, const EdgeStructure& after);

struct BuildOptions {
  double tolerance = 0;                     // radians, at least 0
  std::uint64_t most_changes = 20'000'000;  // of all edges together
  std::uint64_t most_pieces = 100'000'000;  // in all changes together
  unsigned threads = 0;                     // 0: one for each core
  std::function<void(std::size_t done, std::size_t of)> progress =
      nullptr;  // edges; from any thread, one at a time
  Trace* trace = nullptr;  // told about every edge; then one thread does all the work
};

// Error: a limit was reached; it says which, and how far the work had come.
[[nodiscard]] base::Result<EventList> build_event_list(const RotationModel& model,
                                                       const BuildOptions& options = {});

}  // namespace sightline::algorithms::plantinga
