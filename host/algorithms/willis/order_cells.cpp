#include "host/algorithms/willis/order_cells.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <utility>

#include "host/algorithms/willis/boundary.hpp"
#include "host/algorithms/willis/cut.hpp"
#include "host/algorithms/willis/distance.hpp"
#include "host/algorithms/willis/near_pairs.hpp"

namespace sightline::algorithms::willis {

namespace {

enum Part : std::size_t { before = 0, in = 1, behind = 2 };

// The side of a plane on which a surface is; nullopt if it is on both.
std::optional<Part> part_of(const Surface& s, const SurfacePlane& plane) {
  bool positive = false;
  bool negative = false;
  for (const Point& p : s.points) {
    const int side = plane.side(p);
    positive |= side > 0;
    negative |= side < 0;
  }
  if (positive && negative) return std::nullopt;
  return positive ? before : negative ? behind : in;
}

struct Set {
  std::vector<Surface> surfaces;
  std::vector<NumberPair> conflicts;
};

using Division = std::array<Set, 3>;

// A piece of the surface at an index of the previous list, in one of the parts.
struct Place {
  Part part = before;
  std::uint32_t number = 0;
};

// nullopt if a cut would need a point off the lattice.
std::optional<Division> divide(const Set& set, const SurfacePlane& plane) {
  Division division;
  std::vector<std::array<std::optional<Place>, 2>> places(set.surfaces.size());
  const auto put = [&](Part part, Surface s) {
    auto& surfaces = division[part].surfaces;
    surfaces.push_back(std::move(s));
    return Place{part, static_cast<std::uint32_t>(surfaces.size() - 1)};
  };
  for (std::size_t i = 0; i < set.surfaces.size(); ++i) {
    const Surface& s = set.surfaces[i];
    if (const auto part = part_of(s, plane)) {
      places[i][0] = put(*part, s);
      continue;
    }
    auto pieces = cut_by(s, plane);
    if (!pieces) return std::nullopt;
    places[i] = {put(before, std::move((*pieces)[0])), put(behind, std::move((*pieces)[1]))};
  }
  for (const auto& [a, b] : set.conflicts) {
    for (const auto& p : places[a]) {
      for (const auto& q : places[b]) {
        if (!p || !q || p->part != q->part || p->part == in) continue;
        const auto& surfaces = division[p->part].surfaces;
        if (touching_conflict(surfaces[p->number], surfaces[q->number]))
          division[p->part].conflicts.emplace_back(p->number, q->number);
      }
    }
  }
  return division;
}

// Planes of surfaces in conflict, ordered by the number of cuts and then by how evenly they divide.
std::vector<SurfacePlane> candidates(const Set& set) {
  constexpr std::size_t most = 32;
  std::vector<std::uint32_t> members;
  for (const auto& [a, b] : set.conflicts) members.insert(members.end(), {a, b});
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
  struct Candidate {
    std::pair<std::int64_t, std::int64_t> cost;  // cuts, unevenness
    SurfacePlane plane;
  };
  std::vector<Candidate> found;
  const std::size_t step = 1 + (members.size() - 1) / most;
  for (std::size_t i = 0; i < members.size(); i += step) {
    Candidate candidate{{0, 0}, set.surfaces[members[i]].plane};
    for (const Surface& s : set.surfaces) {
      const auto part = part_of(s, candidate.plane);
      if (!part) ++candidate.cost.first;
      if (part == before) ++candidate.cost.second;
      if (part == behind) --candidate.cost.second;
    }
    candidate.cost.second = std::abs(candidate.cost.second);
    found.push_back(candidate);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::vector<SurfacePlane> planes;
  for (const Candidate& candidate : found) planes.push_back(candidate.plane);
  return planes;
}

// A set still to be ordered, and where its place in the tree is written: a part of a node, or the root.
struct Task {
  Set set;
  std::size_t node = 0;
  Part part = before;
  bool root = false;
};

class Builder {
 public:
  explicit Builder(std::size_t most) : most_(most) {}

  OrderCells build(std::vector<Surface>& surfaces) {
    tasks_.push_back({first_set(surfaces), 0, before, true});
    pieces_ = surfaces.size();
    surfaces.clear();
    cells_.cells = 0;
    while (!tasks_.empty()) {
      Task task = std::move(tasks_.back());
      tasks_.pop_back();
      settle(std::move(task), surfaces);
    }
    return std::move(cells_);
  }

 private:
  static Set first_set(std::vector<Surface>& surfaces) {
    std::vector<ReachingBox> boxes;
    for (const Surface& s : surfaces) {
      boxes.push_back(box_of(s));
      boxes.back().squared_reach = 0;
    }
    Set set{std::move(surfaces), {}};
    for (const auto& [a, b] : near_pairs(boxes))
      if (touching_conflict(set.surfaces[a], set.surfaces[b])) set.conflicts.emplace_back(a, b);
    return set;
  }

  [[nodiscard]] std::optional<std::pair<SurfacePlane, Division>> division_of(const Set& set) const {
    if (set.conflicts.empty()) return std::nullopt;
    for (const SurfacePlane& plane : candidates(set)) {
      auto division = divide(set, plane);
      if (!division) continue;
      std::size_t pieces = pieces_ - set.surfaces.size();
      for (const Set& part : *division) pieces += part.surfaces.size();
      if (pieces <= most_) return std::pair{plane, std::move(*division)};
    }
    return std::nullopt;
  }

  void write(const Task& task, OrderPlace place) {
    if (task.root) {
      cells_.root = place;
      return;
    }
    OrderNode& node = cells_.nodes[task.node];
    (task.part == before ? node.before : task.part == in ? node.in : node.behind) = place;
  }

  void settle(Task task, std::vector<Surface>& out) {
    auto division = division_of(task.set);
    if (!division) {
      write(task, ~static_cast<OrderPlace>(cells_.cells));
      for (Surface& s : task.set.surfaces) {
        s.cell = cells_.cells;
        out.push_back(std::move(s));
      }
      ++cells_.cells;
      return;
    }
    const std::size_t node = cells_.nodes.size();
    write(task, static_cast<OrderPlace>(node));
    cells_.nodes.push_back({division->first, 0, 0, 0});
    pieces_ -= task.set.surfaces.size();
    for (const Part part : {before, in, behind}) {
      pieces_ += division->second[part].surfaces.size();
      tasks_.push_back({std::move(division->second[part]), node, part, false});
    }
  }

  std::size_t most_;
  std::size_t pieces_ = 0;
  OrderCells cells_;
  std::vector<Task> tasks_;
};

// 1 if the eye is in front of the plane, 0 if in it, -1 if behind it. In orthographic views the eye is infinitely far back.
int side_of_eye(const SurfacePlane& plane, const scene::PolyCamera& camera) {
  if (!camera.perspective)
    return -geometry::sign(geometry::dot(plane.normal, geometry::vector_of(camera.forward)));
  return geometry::sign(geometry::dot(plane.normal, geometry::vector_of(camera.eye)) - plane.offset);
}

}  // namespace

bool touching_conflict(const Surface& s, const Surface& t) {
  return (can_obscure(s, t) || can_obscure(t, s)) && meet(s, t);
}

OrderCells make_order_cells(std::vector<Surface>& surfaces, std::size_t most) {
  return Builder(most).build(surfaces);
}

void rank_cells(const OrderCells& cells, const scene::PolyCamera& camera, std::vector<std::uint32_t>& ranks) {
  ranks.resize(cells.cells);
  std::uint32_t next = 0;
  std::vector<OrderPlace> places{cells.root};
  while (!places.empty()) {
    const OrderPlace place = places.back();
    places.pop_back();
    if (place < 0) {
      ranks[static_cast<std::size_t>(~place)] = next++;
      continue;
    }
    const OrderNode& node = cells.nodes[static_cast<std::size_t>(place)];
    // What is pushed last is processed first.
    if (side_of_eye(node.plane, camera) >= 0)
      places.insert(places.end(), {node.before, node.in, node.behind});
    else
      places.insert(places.end(), {node.behind, node.in, node.before});
  }
}

}  // namespace sightline::algorithms::willis
