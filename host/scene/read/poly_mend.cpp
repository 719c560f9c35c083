// See poly_mend.hpp.
#include "host/scene/read/poly_mend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>

#include "host/base/threads.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/index_set.hpp"
#include "host/scene/read/open_vertices.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::scene {
namespace {


constexpr std::uint32_t no_part = std::numeric_limits<std::uint32_t>::max();

std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

// Joins, of the vertices that are their own target, those at most `distance` apart, and those that these join.
void join_near(const std::vector<PolyPoint>& points, double distance, std::vector<VertexIndex>& target) {
  const double side = std::max(distance, 1.0);
  const auto cell_of = [side](const PolyPoint& p) {
    std::array<std::int64_t, 3> cell{};
    for (std::size_t a = 0; a < 3; ++a) cell[a] = static_cast<std::int64_t>(std::floor(p[a] / side));
    return cell;
  };
  const auto key = [](const std::array<std::int64_t, 3>& cell) {
    std::uint64_t result = 0;
    for (const std::int64_t c : cell) result = result << 21U | static_cast<std::uint64_t>(c + (1 << 20));
    return result;
  };
  std::unordered_map<std::uint64_t, std::vector<VertexIndex>> cells;
  std::vector<std::uint32_t> parents(points.size());
  std::iota(parents.begin(), parents.end(), 0U);
  for (VertexIndex v = 0; v < points.size(); ++v) {
    if (target[v] != v) continue;
    const auto cell = cell_of(points[v]);
    for (std::int64_t n = 0; n < 27; ++n) {
      const auto found = cells.find(key({cell[0] + n / 9 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n % 3 - 1}));
      if (found == cells.end()) continue;
      for (const VertexIndex w : found->second) {
        const auto between = geometry::difference(points[v], points[w]);
        if (static_cast<double>(geometry::dot(between, between)) > distance * distance) continue;
        const std::uint32_t a = root_of(parents, v);
        const std::uint32_t b = root_of(parents, w);
        const bool a_is_lower = points[a] < points[b];
        parents[a_is_lower ? b : a] = a_is_lower ? a : b;
      }
    }
    cells[key(cell)].push_back(v);
  }
  for (VertexIndex& t : target) t = root_of(parents, t);
}

// A face while it is mended.
struct Piece {
  Ring ring;
  std::uint32_t body = 0;
  std::uint32_t source = 0;
  bool turned = false;
  bool left_out = false;
};

// Removes repeated vertices and spikes, where the ring goes to a vertex and straight back.
void clean(Ring& ring) {
  bool changed = true;
  while (changed && ring.size() >= 3) {
    changed = false;
    Ring kept;
    for (const VertexIndex v : ring) {
      if (!kept.empty() && kept.back() == v) continue;
      if (kept.size() >= 2 && kept[kept.size() - 2] == v) {
        kept.pop_back();
        continue;
      }
      kept.push_back(v);
    }
    const auto matches = [&kept](std::size_t i, std::size_t from_end) {
      return kept[i] == kept[kept.size() - from_end];
    };
    while (kept.size() >= 2 && matches(0, 1)) kept.pop_back();
    while (kept.size() >= 3 && (matches(0, 2) || matches(1, 1))) {
      kept.pop_back();
      while (kept.size() >= 2 && matches(0, 1)) kept.pop_back();
    }
    changed = kept.size() != ring.size();
    ring = std::move(kept);
  }
  if (ring.size() < 3) ring.clear();
}

bool clean_already(const Ring& ring) {
  if (ring.size() != 3 && ring.size() != 4) return false;
  const VertexIndex* const v = ring.data();
  if (v[0] == v[1] || v[1] == v[2] || v[0] == v[2]) return false;
  return ring.size() == 3 || (v[3] != v[0] && v[3] != v[1] && v[3] != v[2]);
}

// Finds the corner of a face of the file that became a vertex: two faces may have different corners for one vertex.
class FileCorners {
 public:
  FileCorners(const std::vector<Piece>& pieces, std::span<const OpenEdge> open, const FileFaces& file,
              std::span<const VertexIndex> target) {
    std::vector<std::uint32_t> sources;
    for (const OpenEdge& edge : open) sources.push_back(pieces[edge.face].source);
    std::sort(sources.begin(), sources.end());
    sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
    for (const std::uint32_t source : sources)
      for (const VertexIndex corner : file.outline(source)) corners_.push_back({source, target[corner], corner});
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

class Mending {
 public:
  Mending(PolyScene& scene, const FileFaces& file, const MendOptions& options, MendReport& report)
      : scene_(scene), file_(file), options_(options), report_(report) {}

  MendResult run() {
    take_faces();
    put_in_order();
    std::optional<EdgeTable> edges(edge_table());
    for (const auto close : {&Mending::join_ends, &Mending::divide_edges}) {
      const std::vector<OpenEdge> open = open_edges_of(*edges, [this](std::uint32_t face) { return pieces_[face].body; });
      if (open.empty()) break;
      if (!(this->*close)(*edges, open)) continue;
      put_in_order();
      edges.emplace(edge_table());
    }
    for (PolyWire& wire : scene_.wires) wire = {target_[wire[0]], target_[wire[1]]};
    tidy_wires(scene_.wires, report_);
    make_parts(*edges);
    edges.reset();
    orient();
    put_together();
    drop_unused();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const std::vector<PolyPoint>& points() const { return scene_.vertices; }

  void take_faces() {
    target_ = equal_points(points(), options_.jobs);
    if (options_.weld > 0) join_near(points(), options_.weld, target_);
    for (VertexIndex v = 0; v < target_.size(); ++v) report_.merged_vertices += target_[v] != v ? 1U : 0U;
    pieces_.reserve(face_count(scene_));
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      for (PolyFace& face : scene_.bodies[b].faces) {
        Piece& piece = pieces_.emplace_back(
            Piece{std::move(face.outline), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(pieces_.size())});
        for (VertexIndex& v : piece.ring) v = target_[v];
        if (!clean_already(piece.ring)) clean(piece.ring);
        if (piece.ring.empty()) leave_out(piece, report_.dropped_faces);
      }
      std::vector<PolyFace>().swap(scene_.bodies[b].faces);
    }
  }

  // Of the faces as they are now, numbered as in pieces_.
  [[nodiscard]] EdgeTable edge_table() const {
    std::vector<const Ring*> outlines;
    outlines.reserve(pieces_.size());
    for (const Piece& piece : pieces_) outlines.push_back(&piece.ring);
    return {points().size(), outlines, options_.jobs};
  }

  // The faces for whose rings a condition holds, ascending.
  template <class Condition>
  [[nodiscard]] std::vector<std::uint32_t> rings_where(Condition holds) const {
    std::vector<std::vector<std::uint32_t>> parts(options_.jobs);
    base::for_parts(options_.jobs, pieces_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
        if (holds(pieces_[p].ring)) parts[part].push_back(static_cast<std::uint32_t>(p));
    });
    std::vector<std::uint32_t> found = std::move(parts[0]);
    for (std::size_t part = 1; part < parts.size(); ++part) found.insert(found.end(), parts[part].begin(), parts[part].end());
    return found;
  }

  void put_in_order() {
    split_faces();
    drop_duplicates();
    give_flat_triangles_away();
    drop_left_out();
  }

  static void leave_out(Piece& piece, std::size_t& count) {
    piece.left_out = true;
    piece.ring.clear();
    ++count;
  }

  [[nodiscard]] bool on_a_line(const Ring& ring) const {
    for (std::size_t i = 2; i < ring.size(); ++i)
      if (!geometry::is_zero(geometry::normal_of(points()[ring[0]], points()[ring[1]], points()[ring[i]]))) return false;
    return true;
  }

  // The largest distance of a vertex from the plane through the first one with the ring's mean direction, in
  // steps.
  [[nodiscard]] double deviation(const Ring& ring, const geometry::Vector3& normal) const {
    geometry::Int128 most = 0;
    for (const VertexIndex v : ring) {
      const auto height = geometry::wide_dot(normal, geometry::difference(points()[v], points()[ring[0]]));
      most = std::max(most, height < 0 ? -height : height);
    }
    double length = 0;
    for (const std::int64_t c : normal) length += static_cast<double>(c) * static_cast<double>(c);
    return static_cast<double>(most) / std::sqrt(length);
  }

  // Faces of four and more vertices that are not planar or not simple become triangles, each where its face was
  // in the list, the others at its end.
  void split_faces() {
    const std::size_t count = pieces_.size();
    for (const std::uint32_t p : rings_where([this](const Ring& ring) { return ring.size() > 3 && !is_plainly_in_order(points(), ring); })) {
      const Ring& ring = pieces_[p].ring;
      if (on_a_line(ring)) {
        leave_out(pieces_[p], report_.dropped_faces);
        continue;
      }
      const auto normal = ring_normal(points(), ring);
      const bool area = !geometry::is_zero(normal);
      const double height = area ? deviation(ring, normal) : 0;
      if (area && height == 0 && is_simple_face(points(), ring)) continue;
      const auto triangles = area ? triangulate(points(), {ring, {}}) : std::nullopt;
      if (!triangles || triangles->empty()) {
        if (report_.crossing_faces == 0) report_.first_crossing = pieces_[p].source;
        leave_out(pieces_[p], report_.crossing_faces);
        continue;
      }
      ++report_.split_faces;
      report_.largest_deviation = std::max(report_.largest_deviation, height);
      for (std::size_t t = 1; t < triangles->size(); ++t)
        pieces_.push_back({{(*triangles)[t][0], (*triangles)[t][1], (*triangles)[t][2]}, pieces_[p].body, pieces_[p].source});
      pieces_[p].ring = {(*triangles)[0][0], (*triangles)[0][1], (*triangles)[0][2]};
    }
    if (pieces_.size() != count) sort_pieces();
  }

  // In the order of the file.
  void sort_pieces() {
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.source < b.source; });
  }

  void drop_duplicates() {
    // The same for every order of the vertices.
    const auto key_of_piece = [this](std::uint32_t p) {
      std::uint64_t key = pieces_[p].body;
      for (const VertexIndex v : pieces_[p].ring) key += spread(v + 1);
      return key;
    };
    const auto are_same = [this](std::uint32_t p, std::uint32_t q) {
      if (pieces_[p].body != pieces_[q].body || pieces_[p].ring.size() != pieces_[q].ring.size()) return false;
      Ring one = pieces_[p].ring;
      Ring other = pieces_[q].ring;
      std::sort(one.begin(), one.end());
      std::sort(other.begin(), other.end());
      return one == other;
    };
    // Faces that are left out already have no vertices, so they are equal to each other alone.
    const std::vector<std::uint32_t> first = first_of_same(pieces_.size(), key_of_piece, are_same, options_.jobs);
    for (std::uint32_t p = 0; p < pieces_.size(); ++p)
      if (first[p] != p && !pieces_[p].left_out) leave_out(pieces_[p], report_.duplicate_faces);
  }

  // Which corner of a triangle without area lies between the other two; 3 for every other ring.
  [[nodiscard]] std::size_t middle_of_flat(const Ring& ring) const {
    if (ring.size() != 3 || !on_a_line(ring)) return 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const PolyPoint& b = points()[ring[i]];
      const PolyPoint& a = points()[ring[(i + 2) % 3]];
      const PolyPoint& c = points()[ring[(i + 1) % 3]];
      if ((a < b && b < c) || (c < b && b < a)) return i;
    }
    return 3;
  }

  static std::uint64_t side_key(VertexIndex a, VertexIndex b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
  }

  // The face beyond the longest side of a flat triangle gets its middle corner. It may be flat itself: then it
  // has to be given away first.
  void give_flat_triangles_away() {
    const std::vector<std::uint32_t> flat = rings_where([this](const Ring& ring) { return middle_of_flat(ring) < 3; });
    if (flat.empty()) return;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> faces_at;  // sides of flat triangles
    for (const std::uint32_t p : flat)
      for (std::size_t i = 0; i < 3; ++i) faces_at[side_key(pieces_[p].ring[i], pieces_[p].ring[(i + 1) % 3])];
    for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
      const Ring& ring = pieces_[p].ring;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto found = faces_at.find(side_key(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]));
        if (found != faces_at.end()) found->second.push_back(p);
      }
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (const std::uint32_t p : flat) changed = (!pieces_[p].left_out && move_face_to_body(p, faces_at)) || changed;
    }
    for (const std::uint32_t p : flat)
      if (!pieces_[p].left_out) leave_out(pieces_[p], report_.dropped_faces);
  }

  bool move_face_to_body(std::uint32_t p, std::unordered_map<std::uint64_t, std::vector<std::uint32_t>>& faces_at) {
    const Ring flat = pieces_[p].ring;
    const std::size_t middle = middle_of_flat(flat);
    const VertexIndex b = flat[middle];
    const VertexIndex a = flat[(middle + 2) % 3];
    const VertexIndex c = flat[(middle + 1) % 3];
    std::uint32_t taker = no_part;
    for (const std::uint32_t q : faces_at[side_key(a, c)]) {
      if (q == p || pieces_[q].left_out || pieces_[q].body != pieces_[p].body) continue;
      if (taker != no_part || middle_of_flat(pieces_[q].ring) < 3) return false;
      taker = q;
    }
    if (taker == no_part) return false;
    Ring& ring = pieces_[taker].ring;
    if (std::find(ring.begin(), ring.end(), b) != ring.end()) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (side_key(ring[i], ring[(i + 1) % ring.size()]) != side_key(a, c)) continue;
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, b);
      break;
    }
    faces_at[side_key(a, b)].push_back(taker);
    faces_at[side_key(b, c)].push_back(taker);
    leave_out(pieces_[p], report_.dropped_faces);
    return true;
  }

  void drop_left_out() {
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), [](const Piece& piece) { return piece.left_out; }),
                  pieces_.end());
  }

  // --- cracks

  // Joins ends of open edges that only rounding keeps apart.
  bool join_ends(const EdgeTable& /*edges*/, const std::vector<OpenEdge>& open) {
    if (!options_.rounded) return false;
    const OpenVertices ends(points(), open, file_.vertices, target_);
    const auto pairs = ends.near_pairs(options_.step);
    if (pairs.empty()) return false;
    std::vector<std::uint32_t> parents(points().size());
    std::iota(parents.begin(), parents.end(), 0U);
    std::unordered_map<std::uint32_t, PolyBounds> groups;
    const auto bounds_of_group = [&](std::uint32_t root) {
      return groups.try_emplace(root, PolyBounds{points()[root], points()[root]}).first->second;
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
      const bool a_is_lower = points()[a] < points()[b];
      parents[a_is_lower ? b : a] = a_is_lower ? a : b;
      groups[a_is_lower ? a : b] = both;
      ++report_.joined_vertices;
    }
    for (VertexIndex& t : target_) t = root_of(parents, t);
    for (Piece& piece : pieces_) {
      bool changed = false;
      for (VertexIndex& v : piece.ring) {
        const VertexIndex now = root_of(parents, v);
        changed = changed || now != v;
        v = now;
      }
      if (changed) clean(piece.ring);
      if (piece.ring.empty()) leave_out(piece, report_.dropped_faces);
    }
    return true;
  }

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

  bool divide_edges(const EdgeTable& edges, const std::vector<OpenEdge>& open) {
    const OpenVertices ends(points(), open, file_.vertices, target_);
    const FileCorners corners(pieces_, open, file_, target_);
    const auto passed_by = [&](const OpenEdge& edge, std::size_t& work) {
      // As this face has them in the file: other faces may have others that became the same vertices.
      const auto place_of = [&](VertexIndex v) {
        const auto corner = corners.find(pieces_[edge.face].source, v);
        return corner ? file_.vertices[*corner] : ends.in_file(v)[0];
      };
      Ring at = ends.on_edge(edge, place_of(edge.from), place_of(edge.to), options_.tolerance, options_.step, work);
      at.insert(at.begin(), edge.from);
      at.push_back(edge.to);
      return at;
    };
    // In a mesh that is meant, few vertices are near an edge. Where all edges pass all vertices, nothing is divided. Some edges
    // tell beforehand how much work it would be.
    constexpr std::size_t most_for_edge = 200;
    constexpr std::size_t samples = 1000;
    const std::size_t most_work = 1'000'000 + most_for_edge * open.size();
    std::size_t work = 0;
    for (std::size_t i = 0; i < samples && open.size() > 10 * samples; ++i)
      static_cast<void>(passed_by(open[i * (open.size() / samples)], work));
    report_.crowded = work > samples * most_for_edge;
    if (report_.crowded) return false;
    std::vector<Ring> passed;  // by each edge, with its ends
    passed.reserve(open.size());
    for (const OpenEdge& edge : open) {
      passed.push_back(passed_by(edge, work));
      report_.crowded = work > most_work;
      if (report_.crowded) return false;
    }
    std::vector<Division> divisions = helpful_divisions(edges, open, passed);
    if (divisions.empty()) return false;
    std::sort(divisions.begin(), divisions.end());
    bool divided = false;
    for (std::size_t first = 0; first < divisions.size();) {
      std::size_t end = first + 1;
      while (end < divisions.size() && divisions[end].piece == divisions[first].piece) ++end;
      divided = divide(divisions[first].piece, std::span(divisions).subspan(first, end - first)) || divided;
      first = end;
    }
    if (divided) sort_pieces();
    return divided;
  }

  // Those with which a part of an edge is a part of another one, too: a vertex that only touches an edge does not divide it. Nor
  // do vertices with which three faces would meet in a part.
  [[nodiscard]] std::vector<Division> helpful_divisions(const EdgeTable& edges, const std::vector<OpenEdge>& open,
                                                        const std::vector<Ring>& passed) const {
    using EdgePart = std::array<std::uint32_t, 3>;
    const auto part_of = [&](std::size_t e, std::size_t i) {
      return EdgePart{open[e].body, std::min(passed[e][i], passed[e][i + 1]), std::max(passed[e][i], passed[e][i + 1])};
    };
    std::vector<EdgePart> parts;
    for (std::size_t e = 0; e < open.size(); ++e)
      for (std::size_t i = 0; i + 1 < passed[e].size(); ++i) parts.push_back(part_of(e, i));
    std::sort(parts.begin(), parts.end());
    const auto is_shared = [&](const EdgePart& part) {
      const auto found = std::lower_bound(parts.begin(), parts.end(), part);
      return found + 1 != parts.end() && *(found + 1) == part;
    };
    const auto is_crowded = [&](const EdgePart& part) {
      const auto found = std::equal_range(parts.begin(), parts.end(), part);
      if (found.second - found.first > 2) return true;
      const std::size_t edge = edges.find(part[1], part[2]);
      if (edge == edges.size()) return false;
      const auto uses = edges.uses(edge);
      return std::count_if(uses.begin(), uses.end(), [&](const EdgeTable::Use& use) { return pieces_[use.face].body == part[0]; }) > 1;
    };
    std::vector<Division> divisions;
    for (std::size_t e = 0; e < open.size(); ++e) {
      bool crowded = false;
      for (std::size_t i = 0; passed[e].size() > 2 && i + 1 < passed[e].size(); ++i) crowded = crowded || is_crowded(part_of(e, i));
      if (crowded) continue;
      Division division{open[e].face, open[e].from, open[e].to, {}};
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
    if (!geometry::is_zero(normal) && deviation(longer, normal) == 0 && is_simple_face(points(), longer)) {
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
    report_.divided_edges += edges;
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

  struct Link {
    std::uint32_t to = 0;
    bool agrees = true;  // they pass the edge in opposite directions
  };

  struct Part {
    std::uint32_t body = 0;
    bool one_sided = false;
    bool closed = true;
    bool crowded = false;  // at an edge with three or more faces: a body of its own
    geometry::Int128 volume = 0;  // six times
    PolyPoint low{};
    PolyPoint high{};
    std::uint32_t first = 0;  // face
    std::uint32_t around = no_part;  // the smallest closed part that it lies in
    std::uint32_t depth = 0;      // how many it lies in

    [[nodiscard]] bool solid() const { return closed && !one_sided && volume != 0; }
  };

  void make_parts(const EdgeTable& edges) {
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
        all_agree = all_agree && (uses.size() != 2 || uses[0].upwards != uses[1].upwards);
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

  // Which solids lie in which: for each, its vertices against those whose bounds are around its own.
  void orient() {
    std::vector<std::uint32_t> solids;
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      if (parts_[p].solid()) solids.push_back(p);
      report_.sheets += parts_[p].solid() ? 0U : 1U;
      report_.one_sided += parts_[p].one_sided ? 1U : 0U;
    }
    if (const auto inner = enclosed_bounds(solids); !inner.empty()) nest(inner);
    for (std::uint32_t f = 0; f < pieces_.size(); ++f) {
      const Part& part = parts_[part_of_[f]];
      const bool inside_out = part.solid() && (part.volume > 0) != (part.depth % 2 == 0);
      pieces_[f].turned = pieces_[f].turned != inside_out;
      report_.turned_faces += pieces_[f].turned ? 1U : 0U;
    }
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
    if (inner.crowded || outer.crowded || (options_.grouped && inner.body != outer.body)) return false;
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

  // --- the scene

  // Moves the faces to the bodies of the result.
  void put_together() {
    std::vector<PolyBody> bodies;
    std::vector<std::uint32_t> body_of(parts_.size(), no_part);
    std::vector<std::array<std::uint32_t, 2>> of_file(scene_.bodies.size(), {no_part, no_part});
    const auto add_body = [&](std::uint32_t p) {
      bodies.emplace_back();
      bodies.back().name = scene_.bodies[parts_[p].body].name;
      bodies.back().sheet = !parts_[p].solid();
      return static_cast<std::uint32_t>(bodies.size() - 1);
    };
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      if (options_.grouped && !parts_[p].crowded) {
        std::uint32_t& body = of_file[parts_[p].body][parts_[p].solid() ? 0 : 1];
        if (body == no_part) body = add_body(p);
        body_of[p] = body;
      } else if (parts_[p].depth % 2 == 0) {
        body_of[p] = add_body(p);
      }
    }
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      std::uint32_t around = parts_[p].around;
      while (body_of[p] == no_part && around != no_part) {
        body_of[p] = parts_[around].depth % 2 == 0 ? body_of[around] : no_part;
        around = parts_[around].around;
      }
      if (body_of[p] == no_part) body_of[p] = add_body(p);
    }
    std::vector<std::uint32_t> starts(bodies.size() + 1);  // of the faces of each body
    for (const std::uint32_t part : part_of_) ++starts[body_of[part] + 1];
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      bodies[b].faces.reserve(starts[b + 1]);
      starts[b + 1] += starts[b];
    }
    result_.faces.resize(pieces_.size());
    for (std::uint32_t f = 0; f < pieces_.size(); ++f) {
      const std::uint32_t to = body_of[part_of_[f]];
      Ring& ring = pieces_[f].ring;
      if (pieces_[f].turned) std::reverse(ring.begin(), ring.end());
      result_.faces[starts[to] + bodies[to].faces.size()] = {pieces_[f].source, pieces_[f].turned};
      bodies[to].faces.push_back({std::move(ring), {}});
    }
    scene_.bodies = std::move(bodies);
    std::vector<Piece>().swap(pieces_);
  }

  void drop_unused() {
    std::vector<bool> used(points().size(), false);
    for (const PolyBody& body : scene_.bodies)
      for (const PolyFace& face : body.faces)
        for (const VertexIndex v : face.outline) used[v] = true;
    for (const PolyWire& wire : scene_.wires) used[wire[0]] = used[wire[1]] = true;
    std::vector<VertexIndex> number(points().size());
    VertexIndex count = 0;
    for (VertexIndex v = 0; v < number.size(); ++v) {
      number[v] = count;
      if (used[v]) scene_.vertices[count++] = scene_.vertices[v];
    }
    report_.dropped_vertices = points().size() - count - report_.merged_vertices - report_.joined_vertices;
    if (count == points().size()) return;
    scene_.vertices.resize(count);
    for (PolyBody& body : scene_.bodies)
      for (PolyFace& face : body.faces)
        for (VertexIndex& v : face.outline) v = number[v];
    for (PolyWire& wire : scene_.wires) wire = {number[wire[0]], number[wire[1]]};
  }

  PolyScene& scene_;
  const FileFaces& file_;
  const MendOptions& options_;
  MendReport& report_;
  std::vector<VertexIndex> target_;  // of each vertex of the file: the one that it became
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> part_of_;  // of each face
  std::vector<Part> parts_;
  MendResult result_;
};

}  // namespace

void tidy_wires(std::vector<PolyWire>& wires, MendReport& report) {
  for (PolyWire& wire : wires)
    if (wire[1] < wire[0]) std::swap(wire[0], wire[1]);
  const auto points = std::remove_if(wires.begin(), wires.end(), [](const PolyWire& wire) { return wire[0] == wire[1]; });
  report.dropped_wires += static_cast<std::size_t>(wires.end() - points);
  wires.erase(points, wires.end());
  std::sort(wires.begin(), wires.end());
  wires.erase(std::unique(wires.begin(), wires.end()), wires.end());
}

MendResult mend(PolyScene& scene, const FileFaces& file, const MendOptions& options, MendReport& report) {
  return Mending(scene, file, options, report).run();
}

}  // namespace sightline::scene
