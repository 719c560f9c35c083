// Finds which faces hide each other: six tests of increasing cost on pairs of faces sorted by their lowest X, as in
// Montani and Re (1985), section 3 and Table 2, with their misprints corrected (NOTES.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "host/algorithms/montani_re/faces.hpp"

namespace sightline::algorithms::montani_re {

// `near` has priority over `far`: near < far in the paper's sign.
struct Relation {
  std::uint32_t near = 0;
  std::uint32_t far = 0;
  std::uint8_t test = 0;  // the test that decided; for tests 3 to 5 the projections need not overlap
};

// A part of the image of `face` in which the other face of a pair is nearer.
struct HiddenPart {
  std::uint32_t face = 0;
  TrapezoidPcs part;
};

// The result of test 6 for two faces: at most one of an order, hidden parts of both, or interpenetration.
struct Overlap {
  bool overlaps = false;
  int order = 0;  // negative: the first is nearer, positive: the second; 0: coplanar, or differs by part
  bool interpenetrating = false;
  std::vector<HiddenPart> parts;  // where the order differs between parts of the image
  double area = 0;
};
[[nodiscard]] Overlap overlap_of(const FaceSet& set, std::uint32_t first, std::uint32_t second);

struct DepthRelations {
  std::vector<Relation> relations;
  std::vector<HiddenPart> hidden;             // of pairs that hide each other in different parts of the image
  std::array<std::uint64_t, 7> decided_by{};  // number of pairs decided by each test
  std::optional<std::pair<std::uint32_t, std::uint32_t>>
      interpenetrating;  // the first such pair; the other results are then invalid
};
[[nodiscard]] DepthRelations depth_relations(const FaceSet& set);

}  // namespace sightline::algorithms::montani_re
