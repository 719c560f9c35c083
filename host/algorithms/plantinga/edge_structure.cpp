// See edge_structure.hpp.
#include "host/algorithms/plantinga/edge_structure.hpp"

#include <optional>

#include "host/algorithms/plantinga/structure_from_scratch.hpp"

namespace sightline::algorithms::plantinga {

EdgeStructure structure_at(const RotationModel& model, EdgeIndex edge, const std::vector<Occluder>& occluders,
                           const Sight& sight, std::vector<PieceRange>* ranges) {
  FromScratch<DirectArithmetic> scratch(model, sight.x, sight.z);
  EdgeStructure structure;
  for (const auto& seen : scratch.pieces_of(edge, occluders)) {
    structure.push_back(seen.piece);
    if (ranges != nullptr)
      ranges->push_back({seen.low.part, seen.low.whole, seen.high.part, seen.high.whole});
  }
  return structure;
}

EdgeStructure structure_between(const RotationModel& model, EdgeIndex edge,
                                const std::vector<Occluder>& occluders, const Direction& a,
                                const Direction& b) {
  const std::optional<Sight> sight = sight_between(a, b);
  if (sight) return structure_at(model, edge, occluders, *sight);
  return wide_structure_between(model, edge, occluders, a, b);
}

}  // namespace sightline::algorithms::plantinga
