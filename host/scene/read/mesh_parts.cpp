// See mesh_parts.hpp.
#include "host/scene/read/mesh_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/model/eye_place.hpp"

namespace sightline::scene {
namespace {

struct Link {
  std::uint32_t to = 0;
  bool agrees = true;  // they pass the edge in opposite directions
};

class PartFinder {
 public:
  PartFinder(MendedMesh& mesh, MeshParts& result)
      : mesh_(mesh), pieces_(mesh.pieces), report_(mesh.report), result_(result), parts_(result.parts), part_of_(result.part_of) {}

  void find(const EdgeTable& edges) {
    // Nearly all edges of most meshes: of two faces of one body, which pass it in opposite directions.
    std::vector<std::uint32_t> others;
    bool all_agree = true;
    result_.neighbours.reserve(edges.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      const auto uses = edges.uses(e);
      const bool of_two = uses.size() == 2 && pieces_[uses[0].face].body == pieces_[uses[1].face].body;
      if (of_two) result_.neighbours.push_back({uses[0].face, uses[1].face});
      if (of_two && uses[0].upwards != uses[1].upwards) continue;
      others.push_back(e);
    }
    for (const std::uint32_t e : others) {
      for_edges_of_bodies(edges.uses(e), [&](std::span<const EdgeTable::Use> uses) {
        if (uses.size() > 2) ++report_.crowded_edges;
        if (uses.size() != 2 || uses[0].upwards != uses[1].upwards) return;
        all_agree = false;
        if (mesh_.names_faults()) add_disagreement(edges[e], pieces_[uses[0].face], pieces_[uses[1].face]);
      });
    }
    if (all_agree) {
      join_faces(edges, others);
    } else {
      turn_faces(edges);
    }
    if (all_agree) {
      for (const std::uint32_t e : others) mark_open(edges.uses(e));
    } else {
      for (std::size_t e = 0; e < edges.size(); ++e) mark_open(edges.uses(e));
    }
    for (auto& pair : result_.neighbours) pair = {pieces_[pair[0]].source, pieces_[pair[1]].source};
    measure();
  }

  // Which solids lie in which: for each, its vertices against those whose bounds are around its own.
  void orient() {
    std::vector<std::uint32_t> solids;
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      if (parts_[p].solid()) solids.push_back(p);
      report_.sheets += parts_[p].solid() ? 0U : 1U;
      report_.one_sided += parts_[p].one_sided ? 1U : 0U;
    }
    if (const auto inner = enclosed_bounds(solids); !inner.empty()) nest(inner);
    for (const Part& part : parts_) add_fault(part);
    for (std::uint32_t f = 0; f < pieces_.size(); ++f) {
      pieces_[f].turned = pieces_[f].turned != parts_[part_of_[f]].inside_out();
      report_.turned_faces += pieces_[f].turned ? 1U : 0U;
    }
  }

 private:
  // Calls visit(uses) for the uses of an edge by each body.
  template <class Visit>
  void for_edges_of_bodies(std::span<const EdgeTable::Use> uses, Visit visit) const {
    while (!uses.empty()) {
      std::size_t count = 1;
      while (count < uses.size() && pieces_[uses[count].face].body == pieces_[uses[0].face].body) ++count;
      visit(uses.first(count));
      uses = uses.subspan(count);
    }
  }

  void add_disagreement(const EdgeTable::Edge& edge, const Piece& one, const Piece& other) {
    mesh_.add_fault(one, "edge " + std::to_string(edge.low) + "-" + std::to_string(edge.high) + " is passed in the same direction by face " +
                             std::to_string(mesh_.face_in_body(other)) + ", expected opposite directions");
  }

  // No face has to be turned to agree with its neighbours.
  void join_faces(const EdgeTable& edges, const std::vector<std::uint32_t>& others) {
    std::vector<std::uint32_t> parents(pieces_.size());
    std::iota(parents.begin(), parents.end(), 0U);
    // The root of a part is its first face.
    const auto join = [&parents](std::uint32_t f, std::uint32_t g) {
      const std::uint32_t a = root_of(parents, f);
      const std::uint32_t b = root_of(parents, g);
      parents[std::max(a, b)] = std::min(a, b);
    };
    for (const auto& [f, g] : result_.neighbours) join(f, g);
    for (const std::uint32_t e : others) {
      for_edges_of_bodies(edges.uses(e), [&](std::span<const EdgeTable::Use> uses) {
        if (uses.size() == 2) join(uses[0].face, uses[1].face);
      });
    }
    part_of_.resize(pieces_.size());
    for (std::uint32_t f = 0; f < pieces_.size(); ++f) {
      const std::uint32_t root = root_of(parents, f);
      if (root == f) {
        part_of_[f] = static_cast<std::uint32_t>(parts_.size());
        parts_.push_back({pieces_[f].body});
        parts_.back().first = f;
      } else {
        part_of_[f] = part_of_[root];
      }
    }
  }

  // From the first face of each part on, its neighbours are turned to agree with it.
  void turn_faces(const EdgeTable& edges) {
    std::vector<std::uint32_t> start(pieces_.size() + 1);
    const auto for_links = [&](auto visit) {
      for (std::size_t e = 0; e < edges.size(); ++e) {
        for_edges_of_bodies(edges.uses(e), [&](std::span<const EdgeTable::Use> uses) {
          if (uses.size() == 2) visit(uses[0], uses[1]);
        });
      }
    };
    for_links([&](const EdgeTable::Use& a, const EdgeTable::Use& b) {
      ++start[a.face + 1];
      ++start[b.face + 1];
    });
    for (std::size_t f = 1; f < start.size(); ++f) start[f] += start[f - 1];
    std::vector<Link> links(start.back());
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for_links([&](const EdgeTable::Use& a, const EdgeTable::Use& b) {
      const bool agrees = a.upwards != b.upwards;
      links[fill[a.face]++] = {b.face, agrees};
      links[fill[b.face]++] = {a.face, agrees};
    });
    part_of_.assign(pieces_.size(), no_part);
    std::vector<std::uint32_t> queue;
    for (std::uint32_t f = 0; f < pieces_.size(); ++f) {
      if (part_of_[f] != no_part) continue;
      const auto number = static_cast<std::uint32_t>(parts_.size());
      Part part{pieces_[f].body};
      part.first = f;
      part_of_[f] = number;
      queue.assign(1, f);
      while (!queue.empty()) {
        const std::uint32_t face = queue.back();
        queue.pop_back();
        for (std::uint32_t l = start[face]; l < start[face + 1]; ++l) {
          const bool turned = pieces_[face].turned != !links[l].agrees;
          if (part_of_[links[l].to] == no_part) {
            part_of_[links[l].to] = number;
            pieces_[links[l].to].turned = turned;
            queue.push_back(links[l].to);
          } else {
            part.one_sided = part.one_sided || pieces_[links[l].to].turned != turned;
          }
        }
      }
      parts_.push_back(part);
    }
  }

  // A part is closed if each of its edges is a side of two of its faces, passed in opposite directions.
  void mark_open(std::span<const EdgeTable::Use> uses) {
    for (const EdgeTable::Use& use : uses) {
      std::size_t up = 0;
      std::size_t down = 0;
      for (const EdgeTable::Use& other : uses) {
        if (part_of_[other.face] != part_of_[use.face]) continue;
        (other.upwards != pieces_[other.face].turned ? up : down) += 1;
      }
      Part& part = parts_[part_of_[use.face]];
      part.closed = part.closed && up == 1 && down == 1;
      part.crowded = part.crowded || uses.size() > 2;
    }
  }

  [[nodiscard]] const Ring& ring_at(std::uint32_t face) const { return pieces_[face].ring; }

  void measure() {
    for (std::uint32_t f = 0; f < pieces_.size(); ++f) {
      Part& part = parts_[part_of_[f]];
      if (part.first == f) part.low = part.high = points()[ring_at(f)[0]];
      const auto volume = enclosed_volume(points(), ring_at(f));
      part.volume += pieces_[f].turned ? -volume : volume;
      for (const VertexIndex v : ring_at(f)) {
        for (std::size_t a = 0; a < 3; ++a) {
          part.low[a] = std::min(part.low[a], points()[v][a]);
          part.high[a] = std::max(part.high[a], points()[v][a]);
        }
      }
    }
  }

  void add_fault(const Part& part) {
    const Piece& first = pieces_[part.first];
    if (part.closed && !part.one_sided && part.volume == 0) mesh_.add_fault(first, "is part of a surface that encloses nothing");
    if (!part.inside_out()) return;
    mesh_.add_fault(first, part.depth % 2 == 0 ? "is part of a surface turned inside out, expected outlines counterclockwise from outside"
                                               : "is part of a surface inside a solid, expected outlines clockwise from outside: a cavity");
  }

  // For each part the solids whose bounds are within its own; empty if there are none. The low corners are sorted into cells, about
  // one per solid, and those in the cells of a solid's bounds are tried.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> enclosed_bounds(const std::vector<std::uint32_t>& solids) const {
    std::vector<std::vector<std::uint32_t>> inner;
    if (solids.size() < 2) return inner;
    PolyPoint low = parts_[solids[0]].low;
    PolyPoint high = low;
    for (const std::uint32_t p : solids) {
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], parts_[p].low[a]);
        high[a] = std::max(high[a], parts_[p].low[a]);
      }
    }
    const auto a_side = static_cast<std::int64_t>(std::cbrt(static_cast<double>(solids.size()))) + 1;
    std::array<std::int64_t, 3> size{};
    for (std::size_t a = 0; a < 3; ++a) size[a] = (std::int64_t{high[a]} - low[a]) / a_side + 1;
    const auto place = [&](const PolyPoint& p, std::size_t a) {
      return std::min((std::int64_t{p[a]} - low[a]) / size[a], a_side - 1);
    };
    const auto cell = [&](std::int64_t x, std::int64_t y, std::int64_t z) { return static_cast<std::size_t>((x * a_side + y) * a_side + z); };
    std::vector<std::uint32_t> starts(static_cast<std::size_t>(a_side * a_side * a_side) + 1);
    const auto cell_of = [&](std::uint32_t p) { return cell(place(parts_[p].low, 0), place(parts_[p].low, 1), place(parts_[p].low, 2)); };
    for (const std::uint32_t p : solids) ++starts[cell_of(p) + 1];
    for (std::size_t c = 1; c < starts.size(); ++c) starts[c] += starts[c - 1];
    std::vector<std::uint32_t> members(solids.size());
    std::vector<std::uint32_t> fill(starts.begin(), starts.end() - 1);
    for (const std::uint32_t p : solids) members[fill[cell_of(p)]++] = p;
    for (const std::uint32_t outer : solids) {
      const Part& around = parts_[outer];
      for (std::int64_t x = place(around.low, 0); x <= place(around.high, 0); ++x) {
        for (std::int64_t y = place(around.low, 1); y <= place(around.high, 1); ++y) {
          // Cells along z follow each other.
          const std::size_t begin = starts[cell(x, y, place(around.low, 2))];
          const std::size_t end = starts[cell(x, y, place(around.high, 2)) + 1];
          for (std::size_t i = begin; i < end; ++i) {
            if (!within(parts_[members[i]], around)) continue;
            inner.resize(parts_.size());
            inner[outer].push_back(members[i]);
          }
        }
      }
    }
    return inner;
  }

  [[nodiscard]] bool within(const Part& inner, const Part& outer) const {
    if (inner.crowded || outer.crowded || (mesh_.options.grouped && inner.body != outer.body)) return false;
    for (std::size_t a = 0; a < 3; ++a)
      if (inner.low[a] <= outer.low[a] || outer.high[a] <= inner.high[a]) return false;
    return true;
  }

  // Rays along x meet only faces whose bounds in y are around them: those are looked up in rows.
  void nest(const std::vector<std::vector<std::uint32_t>>& inner) {
    std::vector<bool> looked_up(parts_.size());
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      if (!inner[p].empty()) looked_up[p] = true;
      for (const std::uint32_t q : inner[p]) looked_up[q] = true;
    }
    std::vector<std::vector<std::uint32_t>> faces_of(parts_.size());
    for (std::uint32_t f = 0; f < pieces_.size(); ++f)
      if (looked_up[part_of_[f]]) faces_of[part_of_[f]].push_back(f);
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      if (inner[p].empty()) continue;
      constexpr std::size_t rows = 256;
      const std::int64_t low = parts_[p].low[1];
      const std::int64_t size = std::int64_t{parts_[p].high[1]} - low + 1;
      const auto row_of = [&](std::int32_t y) { return static_cast<std::size_t>((y - low) * std::int64_t{rows} / size); };
      std::vector<std::vector<std::uint32_t>> in_row(rows);
      for (const std::uint32_t f : faces_of[p]) {
        std::size_t first = rows;
        std::size_t last = 0;
        for (const VertexIndex v : ring_at(f)) {
          first = std::min(first, row_of(points()[v][1]));
          last = std::max(last, row_of(points()[v][1]));
        }
        for (std::size_t row = first; row <= last; ++row) in_row[row].push_back(f);
      }
      const auto is_inside = [&](VertexIndex vertex) {
        const PolyPoint& at = points()[vertex];
        bool inside = false;
        for (const std::uint32_t f : in_row[row_of(at[1])]) inside = inside != ray_crosses(points(), ring_at(f), at);
        return inside;
      };
      for (const std::uint32_t q : inner[p]) {
        if (!is_inside(ring_at(parts_[q].first)[0])) continue;
        // One that sticks out is no cavity.
        std::vector<VertexIndex> others;
        for (const std::uint32_t f : faces_of[q]) others.insert(others.end(), ring_at(f).begin(), ring_at(f).end());
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        if (!std::all_of(others.begin(), others.end(), is_inside)) continue;
        ++parts_[q].depth;
        if (parts_[q].around == no_part || size_of(p) < size_of(parts_[q].around)) parts_[q].around = p;
      }
    }
  }

  [[nodiscard]] geometry::Int128 size_of(std::uint32_t part) const {
    return parts_[part].volume < 0 ? -parts_[part].volume : parts_[part].volume;
  }

  [[nodiscard]] const std::vector<PolyPoint>& points() const { return mesh_.points(); }

  MendedMesh& mesh_;
  std::vector<Piece>& pieces_;
  MendReport& report_;
  MeshParts& result_;
  std::vector<Part>& parts_;
  std::vector<std::uint32_t>& part_of_;
};

}  // namespace

MeshParts find_parts(MendedMesh& mesh, const EdgeTable& edges) {
  MeshParts parts;
  PartFinder(mesh, parts).find(edges);
  return parts;
}

void orient(MendedMesh& mesh, MeshParts& parts) { PartFinder(mesh, parts).orient(); }

}  // namespace sightline::scene
