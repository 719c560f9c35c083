// The priority list: sets of faces of the same priority, from front and back at once. Source: Montani and Re
// (1985), section 3, Tables 3 and 4.
//
// At each step the faces that hide none of those left (NMIN = 0, isolated ones among them) go before the BACK
// list, the others that none of those left hides (NMAX = 0) go behind the FRONT list. Where there is neither,
// what is left holds cycles, and the caller has to delete relations.
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

  // Both lists linked.
  [[nodiscard]] std::vector<PriorityClass> classes() const;
};

// Given the relations that lie on cycles (indices, ascending), which to delete: at least one of them.
using CycleBreaker = std::function<std::vector<std::uint32_t>(std::span<const std::uint32_t>)>;

// Told the faces that each step adds to the front and to the back; empty: nobody is.
using RankListener = std::function<void(const PriorityClass& front, const PriorityClass& back)>;

[[nodiscard]] PriorityList priority_list(std::uint32_t faces, std::span<const Relation> relations,
                                         const CycleBreaker& break_cycles, const RankListener& ranked = {});

}  // namespace sightline::algorithms::montani_re
