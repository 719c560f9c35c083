// The visible region of every face by list priority: relations, the priority list with its cycles cut, and the
// subtraction of the faces before each face. Source: Montani and Re (1985), sections 3 and 5.
//
// Most cycles disappear when relations of tests 3 to 5 whose faces do not overlap in the image are deleted. The remaining
// ones are cut by F := F \ G, F behind G, for the relation with the least common area. Two faces that hide each other in
// different parts of the image, which the paper does not handle (Figure 10), are cut part by part and have no relation.
// Faces that pass through each other have no order: they are reported.
//
// The silhouette is kept as the faces that it consists of. Each face is compared only with those related to it, whereas
// one region of all faces so far would have breakpoints all over the scene. Both methods give the same result, which a
// test checks; Silhouette::whole is the paper's method.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "host/algorithms/montani_re/faces.hpp"
#include "host/algorithms/montani_re/priority.hpp"

namespace sightline::algorithms::montani_re {

struct RegionCounts {
  std::array<std::uint64_t, 7> decided_by{};  // number of pairs decided by each test
  std::uint64_t relations = 0;
  std::uint64_t spurious = 0;      // relations deleted on cycles because their faces do not overlap
  std::uint64_t cuts = 0;          // cycles cut by subtraction
  std::uint64_t mutual_parts = 0;  // parts cut off faces that hide each other
  std::uint64_t subtractions = 0;
  std::uint64_t sides = 0;  // of all visible regions

  RegionCounts& operator+=(const RegionCounts& other);
};

enum class Silhouette { neighbours, whole };

// The priority list, nearest first, and the regions of its faces.
struct ListedFaces {
  PriorityList list;
  std::vector<TrapezoidPcs> faces;  // by face: whole, except for the cuts of cycles
  std::vector<Relation> relations;
  RegionCounts counts;
  // Two faces that pass through each other; list and faces are then empty.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> interpenetrating;
};
class Trace;  // trace.hpp; may be null
[[nodiscard]] ListedFaces listed_faces(const FaceSet& set, Trace* trace = nullptr);

struct VisibleRegions {
  std::vector<TrapezoidPcs> regions;  // by face
  PriorityList list;
  RegionCounts counts;
  std::optional<std::pair<std::uint32_t, std::uint32_t>> interpenetrating;  // regions are then empty
};

[[nodiscard]] VisibleRegions visible_regions(const FaceSet& set,
                                             Silhouette silhouette = Silhouette::neighbours, Trace* trace = nullptr);

}  // namespace sightline::algorithms::montani_re
