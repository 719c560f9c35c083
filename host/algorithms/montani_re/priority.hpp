// The priority list: sets of faces of equal priority, found from the front and the back at once. Source: Montani and Re
// (1985), section 3, Tables 3 and 4.
//
// In each step, the remaining faces that hide no other (NMIN = 0, among them isolated ones) are put before the BACK list,
// and the others that no remaining face hides (NMAX = 0) behind the FRONT list. If there are none of either kind, the
// remaining faces contain cycles, and the caller must delete relations.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "host/algorithms/montani_re/depth_relations.hpp"

namespace sightline::algorithms::montani_re {

using PriorityClass = std::vector<std::uint32_t>;  // ascending

struct PriorityList {
  std::vector<PriorityClass> front;  // nearest first
  std::vector<PriorityClass> back;

  // The front list followed by the back list.
  [[nodiscard]] std::vector<PriorityClass> classes() const;
};

// Receives the relations that lie on cycles (indices, ascending) and returns those to delete, at least one.
using CycleBreaker = std::function<std::vector<std::uint32_t>(std::span<const std::uint32_t>)>;

// Receives the faces that each step adds to the front and the back list. May be empty.
using RankListener = std::function<void(const PriorityClass& front, const PriorityClass& back)>;

[[nodiscard]] PriorityList priority_list(std::uint32_t faces, std::span<const Relation> relations,
                                         const CycleBreaker& break_cycles, const RankListener& ranked = {});

}  // namespace sightline::algorithms::montani_re
