// The structure of an edge between two events with no direction in small integers between them.
#include "host/algorithms/plantinga/structure_from_scratch.hpp"

namespace sightline::algorithms::plantinga {

EdgeStructure wide_structure_between(const RotationModel& model, EdgeIndex edge,
                                     const std::vector<Occluder>& occluders, const Direction& a,
                                     const Direction& b) {
  const WideSight sight = wide_sight_between(a, b);
  FromScratch<FlatView<WideArithmetic<wide_sight_bits>>> scratch(model, {sight.x, sight.z});
  EdgeStructure structure;
  for (const auto& seen : scratch.pieces_of(edge, occluders)) structure.push_back(seen.piece);
  return structure;
}

}  // namespace sightline::algorithms::plantinga
