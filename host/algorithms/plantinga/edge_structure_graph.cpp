#include "host/algorithms/plantinga/edge_structure_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sightline::algorithms::plantinga {

EdgeStructureGraph::EdgeStructureGraph(const EventList& list)
    : list_(list), first_(list.first.size(), no_edge) {
  angles_.reserve(list.events.size());
  for (const Event& event : list.events) angles_.push_back(event.direction.angle);
  for (EdgeIndex edge = 0; edge < list.first.size(); ++edge) replace(edge, list.first[edge]);
}

EdgeStructure EdgeStructureGraph::structure_of(EdgeIndex edge) const {
  EdgeStructure structure;
  for (std::uint32_t i = first_[edge]; i != no_edge; i = pieces_[i].next)
    structure.push_back(pieces_[i].piece);
  return structure;
}

bool EdgeStructureGraph::is(EdgeIndex edge, std::span<const Piece> pieces) const {
  std::uint32_t i = first_[edge];
  for (const Piece& piece : pieces) {
    if (i == no_edge || !(pieces_[i].piece == piece)) return false;
    i = pieces_[i].next;
  }
  return i == no_edge;
}

void EdgeStructureGraph::replace(EdgeIndex edge, std::span<const Piece> pieces) {
  for (std::uint32_t i = first_[edge]; i != no_edge;) {
    const std::uint32_t next = pieces_[i].next;
    pieces_[i] = {no_edge, {}, hole_};
    hole_ = i;
    i = next;
    --count_;
  }
  first_[edge] = no_edge;
  for (std::size_t k = pieces.size(); k-- > 0;) {
    std::uint32_t slot = hole_;
    if (slot == no_edge) {
      slot = static_cast<std::uint32_t>(pieces_.size());
      pieces_.emplace_back();
    } else {
      hole_ = pieces_[slot].next;
    }
    pieces_[slot] = {edge, pieces[k], first_[edge]};
    first_[edge] = slot;
    ++count_;
  }
}

bool EdgeStructureGraph::apply(const Event& event, bool forward) {
  const auto changes = list_.changes_of(event);
  const bool fits = std::all_of(changes.begin(), changes.end(), [&](const Change& change) {
    return is(change.edge, forward ? list_.removed_by(change) : list_.added_by(change));
  });
  if (!fits) return false;
  for (const Change& change : changes) {
    replace(change.edge, forward ? list_.added_by(change) : list_.removed_by(change));
  }
  return true;
}

bool EdgeStructureGraph::step_forward() {
  if (list_.events.empty()) return true;
  if (passed_ == list_.events.size()) passed_ = 0;  // the same view
  if (!apply(list_.events[passed_], true)) return false;
  ++passed_;
  return true;
}

bool EdgeStructureGraph::step_backward() {
  if (list_.events.empty()) return true;
  if (passed_ == 0) passed_ = list_.events.size();
  if (!apply(list_.events[passed_ - 1], false)) return false;
  --passed_;
  return true;
}

bool EdgeStructureGraph::turn_to(double angle) {
  const double in_range = std::remainder(angle, 2 * std::numbers::pi);
  return turn_to_place(
      static_cast<std::size_t>(std::upper_bound(angles_.begin(), angles_.end(), in_range) - angles_.begin()));
}

bool EdgeStructureGraph::turn_to_place(std::size_t passed) {
  const std::size_t count = angles_.size();
  if (count == 0) return true;
  const std::size_t ahead = (passed + count - passed_) % count;
  const bool forward = ahead <= count - ahead;
  for (std::size_t i = 0; i < (forward ? ahead : count - ahead); ++i) {
    if (!(forward ? step_forward() : step_backward())) return false;
  }
  return true;
}

}  // namespace sightline::algorithms::plantinga
