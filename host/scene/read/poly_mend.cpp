// See poly_mend.hpp.
#include "host/scene/read/poly_mend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "host/base/threads.hpp"
#include "host/geometry/predicates.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/model/index_set.hpp"
#include "host/scene/read/mended_mesh.hpp"
#include "host/scene/read/mesh_parts.hpp"
#include "host/scene/read/open_vertices.hpp"
#include "host/scene/read/poly_cracks.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::scene {
namespace {

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

bool clean_already(const Ring& ring) {
  if (ring.size() != 3 && ring.size() != 4) return false;
  const VertexIndex* const v = ring.data();
  if (v[0] == v[1] || v[1] == v[2] || v[0] == v[2]) return false;
  return ring.size() == 3 || (v[3] != v[0] && v[3] != v[1] && v[3] != v[2]);
}

class Mending {
 public:
  Mending(PolyScene& scene, const FileFaces& file, const MendOptions& options, MendReport& report)
      : scene_(scene), options_(options), report_(report), mesh_{scene, file, options, report} {}

  MendResult run() {
    take_faces();
    put_in_order();
    name_faulty_faces();
    std::optional<EdgeTable> edges(mesh_.edge_table());
    for (const auto close : {&join_ends, &divide_edges}) {
      const std::vector<OpenEdge> open = open_edges_of(*edges, [this](std::uint32_t face) { return pieces_[face].body; });
      if (open.empty()) break;
      if (!close(mesh_, *edges, open)) continue;
      put_in_order();
      edges.emplace(mesh_.edge_table());
    }
    for (PolyWire& wire : scene_.wires) wire = {target_[wire[0]], target_[wire[1]]};
    tidy_wires(scene_.wires, report_);
    MeshParts parts = find_parts(mesh_, *edges);
    edges.reset();
    orient(mesh_, parts);
    put_together(parts);
    drop_unused();
    result_.neighbours = std::move(parts.neighbours);
    result_.faults = mesh_.faults.take();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const std::vector<PolyPoint>& points() const { return scene_.vertices; }

  void take_faces() {
    target_ = equal_points(points(), options_.jobs);
    if (options_.name_faults) name_faulty_vertices();
    if (options_.weld > 0) join_near(points(), options_.weld, target_);
    for (VertexIndex v = 0; v < target_.size(); ++v) report_.merged_vertices += target_[v] != v ? 1U : 0U;
    pieces_.reserve(face_count(scene_));
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      mesh_.body_starts.push_back(static_cast<std::uint32_t>(pieces_.size()));
      for (PolyFace& face : scene_.bodies[b].faces) {
        Piece& piece = pieces_.emplace_back(
            Piece{std::move(face.outline), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(pieces_.size())});
        for (VertexIndex& v : piece.ring) v = target_[v];
        if (!clean_already(piece.ring)) {
          const Piece before = options_.name_faults ? piece : Piece{};
          remove_spikes(piece.ring);
          if (piece.ring.size() < before.ring.size()) mark_faulty(before);
        }
        if (piece.ring.empty()) MendedMesh::leave_out(piece, report_.dropped_faces);
      }
      std::vector<PolyFace>().swap(scene_.bodies[b].faces);
    }
  }

  // Of the file. What is different there and fell together by rounding is no fault.
  void name_faulty_vertices() {
    std::vector<VertexIndex> same_as = target_;
    for (VertexIndex v = 0; v < same_as.size(); ++v)
      if (mesh_.file.vertices[same_as[v]] != mesh_.file.vertices[v]) same_as[v] = v;
    check_vertices(scene_, same_as, mesh_.faults);
  }

  // Rounding may have made it so, unless it cannot have.
  void mark_faulty(const Piece& piece, bool even_if_rounded = false) {
    if (options_.name_faults && (even_if_rounded || !options_.rounded)) faulty_.push_back(piece);
  }

  void name_faulty_faces() {
    std::stable_sort(faulty_.begin(), faulty_.end(), by_source);
    for (std::size_t i = 0; i < faulty_.size() && !mesh_.faults.full(); ++i) {
      const Piece& piece = faulty_[i];
      if (i > 0 && piece.source == faulty_[i - 1].source) continue;
      const auto normal = ring_normal(points(), piece.ring);
      if (options_.rounded && !geometry::is_zero(normal) && mesh_.deviation(piece.ring, normal) > 0)
        mesh_.add_fault(piece, "is not planar and cannot be split into triangles along its vertices");
      else
        check_face(points(), {piece.ring, {}}, mesh_.place_of(piece), mesh_.faults);
    }
    for (const auto& [piece, first] : duplicates_)
      mesh_.add_fault(piece, "has the same vertices as face " + std::to_string(mesh_.face_in_body(first)));
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

  [[nodiscard]] bool on_a_line(const Ring& ring) const {
    for (std::size_t i = 2; i < ring.size(); ++i)
      if (!geometry::is_zero(geometry::normal_of(points()[ring[0]], points()[ring[1]], points()[ring[i]]))) return false;
    return true;
  }

  // Faces of four and more vertices that are not planar or not simple become triangles, each where its face was
  // in the list, the others at its end.
  void split_faces() {
    const std::size_t count = pieces_.size();
    for (const std::uint32_t p : rings_where([this](const Ring& ring) { return ring.size() > 3 && !is_plainly_in_order(points(), ring); })) {
      const Ring& ring = pieces_[p].ring;
      if (on_a_line(ring)) {
        mark_faulty(pieces_[p]);
        MendedMesh::leave_out(pieces_[p], report_.dropped_faces);
        continue;
      }
      const auto normal = ring_normal(points(), ring);
      const bool area = !geometry::is_zero(normal);
      const double height = area ? mesh_.deviation(ring, normal) : 0;
      if (area && height == 0 && is_simple_face(points(), ring)) continue;
      const auto triangles = area ? triangulate(points(), {ring, {}}) : std::nullopt;
      const bool can_be_split = triangles && !triangles->empty();
      mark_faulty(pieces_[p], !can_be_split || height == 0);
      if (!can_be_split) {
        if (report_.crossing_faces == 0) report_.first_crossing = pieces_[p].source;
        MendedMesh::leave_out(pieces_[p], report_.crossing_faces);
        continue;
      }
      ++report_.split_faces;
      report_.largest_deviation = std::max(report_.largest_deviation, height);
      for (std::size_t t = 1; t < triangles->size(); ++t)
        pieces_.push_back({{(*triangles)[t][0], (*triangles)[t][1], (*triangles)[t][2]}, pieces_[p].body, pieces_[p].source});
      pieces_[p].ring = {(*triangles)[0][0], (*triangles)[0][1], (*triangles)[0][2]};
    }
    if (pieces_.size() != count) mesh_.sort_pieces();
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
    for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
      Piece& piece = pieces_[p];
      if (first[p] == p || piece.left_out) continue;
      if (mesh_.names_faults() && have_equal_corners(piece, pieces_[first[p]])) duplicates_.push_back({piece, pieces_[first[p]]});
      MendedMesh::leave_out(piece, report_.duplicate_faces);
    }
  }

  // As the file has them, not only after rounding.
  [[nodiscard]] bool have_equal_corners(const Piece& a, const Piece& b) const {
    const auto corners_of = [this](const Piece& piece) {
      const auto outline = mesh_.file.outline(piece.source);
      return std::set<VertexIndex>(outline.begin(), outline.end());
    };
    return a.source != b.source && corners_of(a) == corners_of(b);
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
    for (const std::uint32_t p : flat) mark_faulty(pieces_[p]);
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
      if (!pieces_[p].left_out) MendedMesh::leave_out(pieces_[p], report_.dropped_faces);
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
    MendedMesh::leave_out(pieces_[p], report_.dropped_faces);
    return true;
  }

  void drop_left_out() {
    pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(), [](const Piece& piece) { return piece.left_out; }),
                  pieces_.end());
  }

  // Moves the faces to the bodies of the result.
  void put_together(const MeshParts& of_mesh) {
    const std::vector<Part>& parts = of_mesh.parts;
    std::vector<PolyBody> bodies;
    std::vector<std::uint32_t> body_of(parts.size(), no_part);
    std::vector<std::array<std::uint32_t, 2>> of_file(scene_.bodies.size(), {no_part, no_part});
    const auto add_body = [&](std::uint32_t p) {
      bodies.emplace_back();
      bodies.back().name = scene_.bodies[parts[p].body].name;
      bodies.back().sheet = !parts[p].solid();
      return static_cast<std::uint32_t>(bodies.size() - 1);
    };
    for (std::uint32_t p = 0; p < parts.size(); ++p) {
      if (options_.grouped && !parts[p].crowded) {
        std::uint32_t& body = of_file[parts[p].body][parts[p].solid() ? 0 : 1];
        if (body == no_part) body = add_body(p);
        body_of[p] = body;
      } else if (parts[p].depth % 2 == 0) {
        body_of[p] = add_body(p);
      }
    }
    for (std::uint32_t p = 0; p < parts.size(); ++p) {
      std::uint32_t around = parts[p].around;
      while (body_of[p] == no_part && around != no_part) {
        body_of[p] = parts[around].depth % 2 == 0 ? body_of[around] : no_part;
        around = parts[around].around;
      }
      if (body_of[p] == no_part) body_of[p] = add_body(p);
    }
    std::vector<std::uint32_t> starts(bodies.size() + 1);  // of the faces of each body
    for (const std::uint32_t part : of_mesh.part_of) ++starts[body_of[part] + 1];
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      bodies[b].faces.reserve(starts[b + 1]);
      starts[b + 1] += starts[b];
    }
    result_.faces.resize(pieces_.size());
    for (std::uint32_t f = 0; f < pieces_.size(); ++f) {
      const std::uint32_t to = body_of[of_mesh.part_of[f]];
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
      if (!used[v]) continue;
      scene_.vertices[count++] = scene_.vertices[v];
      result_.vertices.push_back(v);
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
  const MendOptions& options_;
  MendReport& report_;
  MendedMesh mesh_;
  std::vector<VertexIndex>& target_ = mesh_.target;
  std::vector<Piece>& pieces_ = mesh_.pieces;
  std::vector<Piece> faulty_;                        // faces whose rings have to be changed, as they were before
  std::vector<std::pair<Piece, Piece>> duplicates_;  // each with the first one
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
