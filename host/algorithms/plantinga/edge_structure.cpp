#include "host/algorithms/plantinga/edge_structure.hpp"

#include <optional>
#include <utility>

#include "host/algorithms/plantinga/edge_candidates.hpp"
#include "host/algorithms/plantinga/structure_from_scratch.hpp"

namespace sightline::algorithms::plantinga {

namespace {

template <class Scratch>
EdgeStructure structure_from(Scratch& scratch, EdgeIndex edge, const std::vector<Occluder>& occluders,
                             std::vector<PieceRange>* ranges) {
  EdgeStructure structure;
  for (const auto& seen : scratch.pieces_of(edge, occluders)) {
    structure.push_back(seen.piece);
    if (ranges != nullptr)
      ranges->push_back({seen.low.part, seen.low.whole, seen.high.part, seen.high.whole});
  }
  return structure;
}

// For edges whose structure never changes, any direction is right; this one is not aligned with the axes.
constexpr Sight anywhere{314159, 271828};

}  // namespace

EdgeStructure structure_at(const RotationModel& model, EdgeIndex edge, const std::vector<Occluder>& occluders,
                           const Sight& sight, std::vector<PieceRange>* ranges) {
  FromScratch<FlatView<DirectArithmetic>> scratch(model, {sight.x, sight.z});
  return structure_from(scratch, edge, occluders, ranges);
}

EdgeStructure structure_at(const RotationModel& model, EdgeIndex edge, const std::vector<Occluder>& occluders,
                           const Sight& sight, std::vector<PieceRange>* ranges, Trace& trace) {
  trace.scratch_begins(edge, occluders);
  FromScratch<FlatView<DirectArithmetic>, TraceListener> scratch(model, {sight.x, sight.z}, TraceListener(trace));
  EdgeStructure structure = structure_from(scratch, edge, occluders, ranges);
  trace.scratch_ends(edge, scratch.compared(), structure);
  return structure;
}

EdgeStructure structure_between(const RotationModel& model, EdgeIndex edge,
                                const std::vector<Occluder>& occluders, const Direction& a,
                                const Direction& b) {
  const std::optional<Sight> sight = sight_between(a, b);
  if (sight) return structure_at(model, edge, occluders, *sight);
  return wide_structure_between(model, edge, occluders, a, b);
}

EdgeHistory history_of(const RotationModel& model, const ConvexParts& parts, EdgeIndex edge, Trace* trace) {
  const std::vector<Occluder> occluders = model.occluders_of(edge);
  if (trace != nullptr) trace->study_begins(edge, occluders);
  const std::vector<Direction> candidates = candidates_of(model, parts, edge, occluders, trace);
  EdgeHistory history;
  history.candidates = candidates.size();
  if (candidates.empty()) {
    history.first = structure_at(model, edge, occluders, anywhere);
    if (trace != nullptr) trace->study_ends(edge, history);
    return history;
  }
  history.first = structure_between(model, edge, occluders, candidates.back(), candidates.front());
  const EdgeStructure* now = &history.first;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    EdgeStructure after = i + 1 == candidates.size()
                              ? history.first
                              : structure_between(model, edge, occluders, candidates[i], candidates[i + 1]);
    if (trace != nullptr) trace->compared(edge, candidates[i], *now, after);
    if (after == *now) continue;
    history.changes.push_back({candidates[i], std::move(after)});
    now = &history.changes.back().after;
  }
  if (trace != nullptr) trace->study_ends(edge, history);
  return history;
}

}  // namespace sightline::algorithms::plantinga
