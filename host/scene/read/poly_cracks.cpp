// See poly_cracks.hpp.
#include "host/scene/read/poly_cracks.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::scene {
namespace {

// Finds the corner of a face of the file that became a vertex: two faces may have different corners for one vertex.
class FileCorners {
 public:
  FileCorners(const MendedMesh& mesh, std::span<const OpenEdge> open) {
    std::vector<std::uint32_t> sources;
    for (const OpenEdge& edge : open) sources.push_back(mesh.pieces[edge.face].source);
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    for (const std::uint32_t source : sources)
      for (const VertexIndex corner : mesh.file.outline(source)) corners_.push_back({source, mesh.target[corner], corner});
    std::sort(corners_.begin(), corners_.end());
  }

  [[nodiscard]] std::optional<VertexIndex> find(std::uint32_t source, VertexIndex vertex) const {
    const auto found = std::lower_bound(corners_.begin(), corners_.end(), std::array<std::uint32_t, 3>{source, vertex, 0});
    if (found == corners_.end() || (*found)[0] != source || (*found)[1] != vertex) return std::nullopt;
    return (*found)[2];
  }

 private:
  std::vector<std::array<std::uint32_t, 3>> corners_;  // face, vertex, corner
};

// The vertices of other faces on an edge, in the direction of the face.
struct Division {
  std::uint32_t piece = 0;
  VertexIndex from = 0;
  VertexIndex to = 0;
  Ring at;

  [[nodiscard]] bool operator<(const Division& other) const {
    return piece != other.piece ? piece < other.piece : from < other.from;
  }
};

class EdgeDivider {
 public:
  EdgeDivider(MendedMesh& mesh, const EdgeTable& edges, std::span<const OpenEdge> open)
      : mesh_(mesh), pieces_(mesh.pieces), edges_(edges), open_(open) {}

  bool run() {
    const OpenVertices ends(points(), open_, mesh_.file.vertices, mesh_.target);
    const FileCorners corners(mesh_, open_);
    const auto passed_by = [&](const OpenEdge& edge, std::size_t& work) {
      // As this face has them in the file: other faces may have others that became the same vertices.
      const auto place_of = [&](VertexIndex v) {
        const auto corner = corners.find(pieces_[edge.face].source, v);
        return corner ? mesh_.file.vertices[*corner] : ends.in_file(v)[0];
      };
      Ring at = ends.on_edge(edge, place_of(edge.from), place_of(edge.to), mesh_.options.tolerance, mesh_.options.step, work);
      at.insert(at.begin(), edge.from);
      at.push_back(edge.to);
      return at;
    };
    // In a mesh that is meant, few vertices are near an edge. Where all edges pass all vertices, nothing is divided. Some edges
    // tell beforehand how much work it would be.
    constexpr std::size_t most_for_edge = 200;
    constexpr std::size_t samples = 1000;
    const std::size_t most_work = 1'000'000 + most_for_edge * open_.size();
    std::size_t work = 0;
    for (std::size_t i = 0; i < samples && open_.size() > 10 * samples; ++i)
      static_cast<void>(passed_by(open_[i * (open_.size() / samples)], work));
    mesh_.report.crowded = work > samples * most_for_edge;
    if (mesh_.report.crowded) return false;
    std::vector<Ring> passed;  // by each edge, with its ends
    passed.reserve(open_.size());
    for (const OpenEdge& edge : open_) {
      passed.push_back(passed_by(edge, work));
      mesh_.report.crowded = work > most_work;
      if (mesh_.report.crowded) return false;
    }
    std::vector<Division> divisions = helpful_divisions(passed);
    if (divisions.empty()) return false;
    std::sort(divisions.begin(), divisions.end());
    bool divided = false;
    for (std::size_t first = 0; first < divisions.size();) {
      std::size_t end = first + 1;
      while (end < divisions.size() && divisions[end].piece == divisions[first].piece) ++end;
      divided = divide(divisions[first].piece, std::span(divisions).subspan(first, end - first)) || divided;
      first = end;
    }
    if (divided) mesh_.sort_pieces();
    return divided;
  }

 private:
  // Those with which a part of an edge is a part of another one, too: a vertex that only touches an edge does not divide it. Nor
  // do vertices with which three faces would meet in a part.
  [[nodiscard]] std::vector<Division> helpful_divisions(const std::vector<Ring>& passed) const {
    using EdgePart = std::array<std::uint32_t, 3>;
    const auto part_of = [&](std::size_t e, std::size_t i) {
      return EdgePart{open_[e].body, std::min(passed[e][i], passed[e][i + 1]), std::max(passed[e][i], passed[e][i + 1])};
    };
    std::vector<EdgePart> parts;
    for (std::size_t e = 0; e < open_.size(); ++e)
      for (std::size_t i = 0; i + 1 < passed[e].size(); ++i) parts.push_back(part_of(e, i));
    std::sort(parts.begin(), parts.end());
    const auto is_shared = [&](const EdgePart& part) {
      const auto found = std::lower_bound(parts.begin(), parts.end(), part);
      return found + 1 != parts.end() && *(found + 1) == part;
    };
    const auto is_crowded = [&](const EdgePart& part) {
      const auto found = std::equal_range(parts.begin(), parts.end(), part);
      if (found.second - found.first > 2) return true;
      const std::size_t edge = edges_.find(part[1], part[2]);
      if (edge == edges_.size()) return false;
      const auto uses = edges_.uses(edge);
      return std::count_if(uses.begin(), uses.end(), [&](const EdgeTable::Use& use) { return pieces_[use.face].body == part[0]; }) > 1;
    };
    std::vector<Division> divisions;
    for (std::size_t e = 0; e < open_.size(); ++e) {
      bool crowded = false;
      for (std::size_t i = 0; passed[e].size() > 2 && i + 1 < passed[e].size(); ++i) crowded = crowded || is_crowded(part_of(e, i));
      if (crowded) continue;
      Division division{open_[e].face, open_[e].from, open_[e].to, {}};
      for (std::size_t i = 1; i + 1 < passed[e].size(); ++i)
        if (is_shared(part_of(e, i - 1)) || is_shared(part_of(e, i))) division.at.push_back(passed[e][i]);
      if (!division.at.empty()) divisions.push_back(std::move(division));
    }
    return divisions;
  }

  // False if the face cannot have these vertices: they are its own, or it cannot become triangles.
  bool divide(std::uint32_t p, std::span<Division> divisions) {
    const Ring ring = pieces_[p].ring;
    std::set<VertexIndex> seen(ring.begin(), ring.end());
    std::size_t edges = 0;
    for (Division& division : divisions) {
      Ring mine;
      for (const VertexIndex v : division.at)
        if (seen.insert(v).second) mine.push_back(v);
      division.at = std::move(mine);
      edges += division.at.empty() ? 0U : 1U;
    }
    if (edges == 0) return false;
    const auto on_side = [&](VertexIndex from, VertexIndex to) -> Ring {
      const auto found = std::lower_bound(divisions.begin(), divisions.end(), Division{p, from, to, {}});
      return found != divisions.end() && found->from == from && found->to == to ? found->at : Ring{};
    };
    Ring longer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      longer.push_back(ring[i]);
      const Ring side = on_side(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
      longer.insert(longer.end(), side.begin(), side.end());
    }
    const auto normal = ring_normal(points(), longer);
    if (!geometry::is_zero(normal) && mesh_.deviation(longer, normal) == 0 && is_simple_face(points(), longer)) {
      pieces_[p].ring = std::move(longer);
    } else {
      const auto triangles = triangulate(points(), {ring, {}});
      if (!triangles || triangles->empty()) return false;
      std::vector<std::array<VertexIndex, 3>> parts;
      for (const auto& t : *triangles)
        divide_triangle(t, {on_side(t[0], t[1]), on_side(t[1], t[2]), on_side(t[2], t[0])}, parts);
      for (std::size_t t = 1; t < parts.size(); ++t)
        pieces_.push_back({{parts[t][0], parts[t][1], parts[t][2]}, pieces_[p].body, pieces_[p].source});
      pieces_[p].ring = {parts[0][0], parts[0][1], parts[0][2]};
    }
    mesh_.report.divided_edges += edges;
    for (const Division& division : divisions) {
      if (division.at.empty() || !mesh_.names_faults()) continue;
      mesh_.add_fault(pieces_[p], "edge " + std::to_string(division.from) + "-" + std::to_string(division.to) + " passes vertex " +
                                      std::to_string(division.at[0]) + ", expected a corner of the face there");
    }
    return true;
  }

  // Into triangles that have all vertices of its sides; no one is between three vertices of one side.
  static void divide_triangle(const std::array<VertexIndex, 3>& corners, const std::array<Ring, 3>& sides,
                              std::vector<std::array<VertexIndex, 3>>& parts) {
    for (std::size_t s = 0; s < 3; ++s) {
      if (sides[s].empty()) continue;
      const std::size_t half = sides[s].size() / 2;
      const auto at = sides[s].begin() + static_cast<std::ptrdiff_t>(half);
      const VertexIndex from = corners[s];
      const VertexIndex to = corners[(s + 1) % 3];
      const VertexIndex apex = corners[(s + 2) % 3];
      divide_triangle({from, *at, apex}, {Ring(sides[s].begin(), at), {}, sides[(s + 2) % 3]}, parts);
      divide_triangle({*at, to, apex}, {Ring(at + 1, sides[s].end()), sides[(s + 1) % 3], {}}, parts);
      return;
    }
    parts.push_back(corners);
  }

  [[nodiscard]] const std::vector<PolyPoint>& points() const { return mesh_.points(); }

  MendedMesh& mesh_;
  std::vector<Piece>& pieces_;
  const EdgeTable& edges_;
  std::span<const OpenEdge> open_;
};

}  // namespace

bool join_ends(MendedMesh& mesh, const EdgeTable& /*edges*/, std::span<const OpenEdge> open) {
  if (!mesh.options.rounded) return false;
  const OpenVertices ends(mesh.points(), open, mesh.file.vertices, mesh.target);
  const auto pairs = ends.near_pairs(mesh.options.step);
  if (pairs.empty()) return false;
  std::vector<std::uint32_t> parents(mesh.points().size());
  std::iota(parents.begin(), parents.end(), 0U);
  std::unordered_map<std::uint32_t, PolyBounds> groups;
  const auto bounds_of_group = [&](std::uint32_t root) {
    return groups.try_emplace(root, PolyBounds{mesh.points()[root], mesh.points()[root]}).first->second;
  };
  for (const auto& [v, w] : pairs) {
    const std::uint32_t a = root_of(parents, v);
    const std::uint32_t b = root_of(parents, w);
    if (a == b) continue;
    PolyBounds both = bounds_of_group(a);
    const PolyBounds other = bounds_of_group(b);
    bool small = true;
    for (std::size_t i = 0; i < 3; ++i) {
      both.low[i] = std::min(both.low[i], other.low[i]);
      both.high[i] = std::max(both.high[i], other.high[i]);
      small = small && both.high[i] - both.low[i] <= 1;
    }
    if (!small) continue;
    const bool a_is_lower = mesh.points()[a] < mesh.points()[b];
    parents[a_is_lower ? b : a] = a_is_lower ? a : b;
    groups[a_is_lower ? a : b] = both;
    ++mesh.report.joined_vertices;
  }
  for (VertexIndex& t : mesh.target) t = root_of(parents, t);
  for (Piece& piece : mesh.pieces) {
    bool changed = false;
    for (VertexIndex& v : piece.ring) {
      const VertexIndex now = root_of(parents, v);
      changed = changed || now != v;
      v = now;
    }
    if (changed) remove_spikes(piece.ring);
    if (piece.ring.empty()) MendedMesh::leave_out(piece, mesh.report.dropped_faces);
  }
  return true;
}

bool divide_edges(MendedMesh& mesh, const EdgeTable& edges, std::span<const OpenEdge> open) {
  return EdgeDivider(mesh, edges, open).run();
}

}  // namespace sightline::scene
