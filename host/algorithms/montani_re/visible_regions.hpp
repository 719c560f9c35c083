// The visible region of every face, by list priority: relations, the priority list with its cycles cut, and every
// face less those before it. Source: Montani and Re (1985), sections 3 and 5.
//
// A cycle is first freed of relations of tests 3 to 5 whose faces do not overlap in the image (they are most
// of all cycles); what is left is cut by F := F \ G, F behind G, for the relation of least common area. Two
// faces that hide each other in different places, which the paper gives up (Figure 10), are cut part by part
// and have no relation. Faces that pass through each other have no order: they are reported.
//
// The silhouette is kept as the faces it consists of: of those, a face meets only its neighbours in the
// relations, while one region of all faces so far would have their breakpoints all over the scene. Both ways
// give the same, which a test shows; `silhouette` is the paper's own way.
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
  std::array<std::uint64_t, 7> decided_by{};  // pairs by the test that decided
  std::uint64_t relations = 0;
  std::uint64_t spurious = 0;      // relations deleted on cycles because nothing overlaps
  std::uint64_t cuts = 0;          // cycles cut by subtraction
  std::uint64_t mutual_parts = 0;  // parts cut off faces that hide each other
  std::uint64_t subtractions = 0;
  std::uint64_t sides = 0;  // of all that is seen

  RegionCounts& operator+=(const RegionCounts& other);
};

enum class Silhouette { neighbours, whole };

// The priority list, and what it is a list of: what is in front to the back.
struct ListedFaces {
  PriorityList list;
  std::vector<TrapezoidPcs> faces;  // by face: whole but for the cuts of cycles
  std::vector<Relation> relations;
  RegionCounts counts;
  // Faces that pass through each other; list and faces are then empty.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> interpenetrating;
};
class Trace;  // trace.hpp; null: nobody watches
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
