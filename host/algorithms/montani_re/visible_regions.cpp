#include "host/algorithms/montani_re/visible_regions.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>

#include "host/algorithms/montani_re/depth_relations.hpp"
#include "host/algorithms/montani_re/trace.hpp"

namespace sightline::algorithms::montani_re {
namespace {

// Deletes relations on cycles and records which faces must be cut by which.
class CycleCutter {
 public:
  CycleCutter(const FaceSet& set, std::span<const Relation> relations, RegionCounts& counts, Trace* trace)
      : set_(set), relations_(relations), counts_(counts), areas_(relations.size(), -1), trace_(trace) {}

  std::vector<std::uint32_t> operator()(std::span<const std::uint32_t> on_cycles) {
    std::vector<std::uint32_t> spurious;
    for (const std::uint32_t r : on_cycles) {
      if (areas_[r] >= 0) continue;
      const Overlap overlap = overlap_of(set_, relations_[r].near, relations_[r].far);
      areas_[r] = overlap.area;
      if (!overlap.overlaps) spurious.push_back(r);
    }
    if (!spurious.empty()) {
      counts_.spurious += spurious.size();
      if (trace_ != nullptr)
        for (const std::uint32_t r : spurious) trace_->cycle(relations_[r], false);
      return spurious;
    }
    const std::uint32_t least = *std::min_element(on_cycles.begin(), on_cycles.end(), [this](auto a, auto b) {
      return areas_[a] != areas_[b] ? areas_[a] < areas_[b] : a < b;
    });
    ++counts_.cuts;
    if (trace_ != nullptr) trace_->cycle(relations_[least], true);
    cut.push_back(least);
    return {least};
  }

  std::vector<std::uint32_t> cut;  // relations

 private:
  const FaceSet& set_;
  std::span<const Relation> relations_;
  RegionCounts& counts_;
  std::vector<double> areas_;  // common area of both faces; negative: not computed yet
  Trace* trace_;
};

// Subtracts regions from others and counts the operations.
class Subtraction {
 public:
  Subtraction(const FaceSet& set, RegionCounts& counts)
      : set_(set), counts_(counts), subtract_(set.image, Operation::subtract) {}

  void operator()(TrapezoidPcs& region, const TrapezoidPcs& other) {
    if (region.empty()) return;
    ++counts_.subtractions;
    subtract_(region, other);
  }
  // Subtracts another face from what is left of a face.
  void operator()(TrapezoidPcs& region, std::uint32_t face, std::uint32_t near) {
    if (region.empty()) return;
    const Placement placement = placement_of(set_, set_.faces[face], set_.faces[near]);
    if (placement == Placement::mixed) return (*this)(region, set_.faces[near].pcs);
    ++counts_.subtractions;
    if (placement == Placement::covered) region = {};
  }

 private:
  const FaceSet& set_;
  RegionCounts& counts_;
  Combiner subtract_;
};

// Subtracts from every face those before it in the list that are related to it, nearest first. One region is used for all
// faces, to reuse its memory, and is copied when a face is finished.
void hide_by_neighbours(const FaceSet& set, std::span<const Relation> relations, VisibleRegions& result, Trace* trace) {
  std::vector<std::uint32_t> rank(set.faces.size());
  std::vector<std::uint32_t> by_rank;
  by_rank.reserve(set.faces.size());
  for (const PriorityClass& members : result.list.classes()) {
    for (const std::uint32_t face : members) {
      rank[face] = static_cast<std::uint32_t>(by_rank.size());
      by_rank.push_back(face);
    }
  }
  // The ranks of the related faces before a face begin at first[face].
  std::vector<std::uint32_t> first(set.faces.size() + 1);
  for (const Relation& relation : relations)
    if (rank[relation.near] < rank[relation.far]) ++first[relation.far];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> before(first.back());
  for (const Relation& relation : relations) {
    if (rank[relation.near] < rank[relation.far]) before[--first[relation.far]] = rank[relation.near];
  }
  Subtraction subtract(set, result.counts);
  TrapezoidPcs region;
  for (std::uint32_t face = 0; face < set.faces.size(); ++face) {
    const std::span nearer(before.data() + first[face], before.data() + first[face + std::size_t{1}]);
    if (nearer.empty()) continue;
    std::sort(nearer.begin(), nearer.end());
    region = result.regions[face];
    for (const std::uint32_t near : nearer) {
      subtract(region, face, by_rank[near]);
      if (trace != nullptr) trace->subtracted(face, by_rank[near], region);
    }
    result.regions[face] = region;
  }
}

void hide_by_silhouette(const FaceSet& set, VisibleRegions& result) {
  TrapezoidPcs silhouette;
  Subtraction subtract(set, result.counts);
  for (const PriorityClass& members : result.list.classes()) {
    for (const std::uint32_t face : members) {
      TrapezoidPcs& region = result.regions[face];
      subtract(region, silhouette);
      silhouette = combine(set.image, silhouette, region, Operation::unite);
    }
  }
}

}  // namespace

RegionCounts& RegionCounts::operator+=(const RegionCounts& other) {
  for (std::size_t i = 0; i < decided_by.size(); ++i) decided_by[i] += other.decided_by[i];
  relations += other.relations;
  spurious += other.spurious;
  cuts += other.cuts;
  mutual_parts += other.mutual_parts;
  subtractions += other.subtractions;
  sides += other.sides;
  return *this;
}

ListedFaces listed_faces(const FaceSet& set, Trace* trace) {
  ListedFaces result;
  DepthRelations depth = depth_relations(set);
  result.counts.decided_by = depth.decided_by;
  result.counts.relations = depth.relations.size();
  result.interpenetrating = depth.interpenetrating;
  if (result.interpenetrating) return result;
  if (trace != nullptr) trace->related(depth);
  result.relations = std::move(depth.relations);
  CycleCutter cutter(set, result.relations, result.counts, trace);
  RankListener ranked;
  if (trace != nullptr) ranked = [trace](const PriorityClass& front, const PriorityClass& back) { trace->ranked(front, back); };
  result.list =
      priority_list(static_cast<std::uint32_t>(set.faces.size()), result.relations,
                    [&cutter](std::span<const std::uint32_t> on_cycles) { return cutter(on_cycles); }, ranked);
  result.faces.reserve(set.faces.size());
  for (const Face& face : set.faces) result.faces.push_back(face.pcs);
  Subtraction subtract(set, result.counts);
  for (const std::uint32_t r : cutter.cut) {
    const Relation& relation = result.relations[r];
    subtract(result.faces[relation.far], relation.far, relation.near);
    if (trace != nullptr) trace->subtracted(relation.far, relation.near, result.faces[relation.far]);
  }
  result.counts.mutual_parts = depth.hidden.size();
  for (const HiddenPart& part : depth.hidden) {
    subtract(result.faces[part.face], part.part);
    if (trace != nullptr) trace->subtracted(part.face, part.face, result.faces[part.face]);
  }
  return result;
}

VisibleRegions visible_regions(const FaceSet& set, Silhouette silhouette, Trace* trace) {
  ListedFaces listed = listed_faces(set, trace);
  VisibleRegions result{std::move(listed.faces), std::move(listed.list), listed.counts,
                        listed.interpenetrating};
  if (result.interpenetrating) return result;
  if (silhouette == Silhouette::whole) {
    hide_by_silhouette(set, result);
  } else {
    hide_by_neighbours(set, listed.relations, result, trace);
  }
  for (const TrapezoidPcs& region : result.regions) result.counts.sides += region.sides.size();
  return result;
}

}  // namespace sightline::algorithms::montani_re
