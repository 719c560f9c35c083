// See section.hpp.
#include "host/scene/read/section.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "host/geometry/vector.hpp"
#include "host/scene/model/file_units.hpp"
#include "host/scene/read/poly_quantise.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::scene {
namespace {

using geometry::RealVector;
using EdgeKey = std::uint64_t;

EdgeKey key(VertexIndex from, VertexIndex to) { return EdgeKey{from} << 32U | to; }

// Takes away what lies before one plane of a mesh, and closes the solids.
class Cutter {
 public:
  Cutter(PolyMesh& mesh, const SectionPlane& plane, std::uint32_t cut_material)
      : mesh_(mesh), plane_(plane), sign_(plane.keep_above ? 1 : -1), cut_material_(cut_material) {}

  void run() {
    std::vector<std::uint32_t> materials;
    std::size_t number = 0;
    for (std::size_t b = 0; b < mesh_.bodies.size(); ++b) {
      PolyBody& body = mesh_.bodies[b];
      std::vector<PolyFace> faces;
      segments_.clear();
      unpaired_.clear();
      for (const PolyFace& face : body.faces) {
        cut(face, body.sheet, faces);
        materials.resize(first_of_body_ + faces.size(), mesh_.materials[number++]);
      }
      if (!body.sheet) close(faces);
      materials.resize(first_of_body_ + faces.size(), cut_material_ + static_cast<std::uint32_t>(b % 2));
      body.faces = std::move(faces);
      first_of_body_ = materials.size();
    }
    mesh_.materials = std::move(materials);
    cut_wires();
  }

  // Of cut surfaces, whose sides have a gap.
  [[nodiscard]] std::size_t open_rings() const { return open_rings_; }

 private:
  // Where the boundary of a face passes from the part that is kept to the other one, or back.
  struct Passage {
    VertexIndex vertex = 0;
    double along = 0;  // the line in which the plane meets the face
  };
  // A stretch of a boundary that is kept, from where it enters to where it leaves.
  struct Chain {
    Passage enters;
    Ring vertices;
    Passage leaves;
  };
  // A side of the cut surface.
  struct Segment {
    VertexIndex from = 0;
    VertexIndex to = 0;
    bool used = false;  // in a ring, or not a side after all
  };

  // Above 0: kept.
  [[nodiscard]] double height(VertexIndex v) const { return (mesh_.vertices[v][plane_.axis] - plane_.at) * sign_; }
  [[nodiscard]] bool kept(VertexIndex v) const { return height(v) > 0; }

  // The same for both faces at an edge, whose ends lie on different sides. A vertex in the plane is not kept; it is where its edges meet
  // the plane.
  Passage passage(VertexIndex a, VertexIndex b) {
    const auto [p, q] = std::minmax(a, b);
    Passage at;
    if (height(p) == 0 || height(q) == 0) {
      at.vertex = height(p) == 0 ? p : q;
      return at;
    }
    const auto [known, added] = cuts_.try_emplace(key(p, q), static_cast<VertexIndex>(mesh_.vertices.size()));
    at.vertex = known->second;
    if (!added) return at;
    const RealVector& from = mesh_.vertices[p];
    const RealVector& to = mesh_.vertices[q];
    const double part = height(p) / (height(p) - height(q));
    RealVector point{};
    for (std::size_t k = 0; k < 3; ++k) point[k] = from[k] + part * (to[k] - from[k]);
    point[plane_.axis] = plane_.at;
    mesh_.vertices.push_back(point);
    return at;
  }

  // Along the line in which the plane meets the face, in a direction that has the kept part on its left, seen from outside.
  [[nodiscard]] RealVector line_of(const PolyFace& face) const {
    RealVector normal{};
    const RealVector& origin = mesh_.vertices[face.outline[0]];
    for (std::size_t i = 2; i < face.outline.size(); ++i) {
      const RealVector part = geometry::cross(geometry::difference(mesh_.vertices[face.outline[i - 1]], origin),
                                              geometry::difference(mesh_.vertices[face.outline[i]], origin));
      for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
    }
    RealVector towards_kept{};
    towards_kept[plane_.axis] = sign_;
    return geometry::unit(geometry::cross(towards_kept, normal));
  }

  // Adds the chains of a ring; true if all of it is kept.
  bool add_chains(const Ring& ring, const RealVector& line, std::vector<Chain>& chains) {
    const std::size_t count = ring.size();
    std::size_t start = 0;
    while (start < count && !(kept(ring[start]) && !kept(ring[(start + count - 1) % count]))) ++start;
    if (start == count) return kept(ring[0]);
    const auto place = [&](VertexIndex a, VertexIndex b) {
      Passage at = passage(a, b);
      at.along = geometry::dot(line, mesh_.vertices[at.vertex]);
      return at;
    };
    for (std::size_t i = 0; i < count; ++i) {
      const VertexIndex v = ring[(start + i) % count];
      const VertexIndex next = ring[(start + i + 1) % count];
      if (!kept(v)) continue;
      if (i == 0 || !kept(ring[(start + i - 1) % count])) chains.push_back({place(ring[(start + i + count - 1) % count], v), {}, {}});
      chains.back().vertices.push_back(v);
      if (!kept(next)) chains.back().leaves = place(v, next);
    }
    return false;
  }

  void cut(const PolyFace& face, bool sheet, std::vector<PolyFace>& faces) {
    std::vector<Chain> chains;
    const RealVector line = line_of(face);
    std::vector<Ring> outlines;
    std::vector<Ring> holes;
    if (add_chains(face.outline, line, chains)) outlines.push_back(face.outline);
    for (const Ring& hole : face.holes)
      if (add_chains(hole, line, chains)) holes.push_back(hole);
    join(chains, sheet, outlines);
    add_faces(outlines, holes, line, faces);
  }

  // Joins chains to rings. In the direction of the line a stretch within the face begins where a chain leaves the kept part, and ends
  // where one enters it.
  void join(const std::vector<Chain>& chains, bool sheet, std::vector<Ring>& outlines) {
    std::vector<std::size_t> leaving(chains.size());
    for (std::size_t i = 0; i < chains.size(); ++i) leaving[i] = i;
    std::vector<std::size_t> entering = leaving;
    std::sort(leaving.begin(), leaving.end(), [&](std::size_t a, std::size_t b) { return chains[a].leaves.along < chains[b].leaves.along; });
    std::sort(entering.begin(), entering.end(), [&](std::size_t a, std::size_t b) { return chains[a].enters.along < chains[b].enters.along; });
    std::vector<std::size_t> next(chains.size());
    for (std::size_t i = 0; i < chains.size(); ++i) {
      next[leaving[i]] = entering[i];
      // The face and the cut surface have this side in opposite directions.
      if (!sheet) add_segment(chains[entering[i]].enters.vertex, chains[leaving[i]].leaves.vertex);
    }
    std::vector<bool> done(chains.size(), false);
    for (std::size_t first = 0; first < chains.size(); ++first) {
      Ring ring;
      for (std::size_t i = first; !done[i]; i = next[i]) {
        done[i] = true;
        ring.push_back(chains[i].enters.vertex);
        ring.insert(ring.end(), chains[i].vertices.begin(), chains[i].vertices.end());
        ring.push_back(chains[i].leaves.vertex);
      }
      if (simplify(ring)) outlines.push_back(std::move(ring));
    }
  }

  // Without equal neighbours; false if no area is left.
  static bool simplify(Ring& ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring.size() >= 3;
  }

  // Faces with these outlines and holes, all in one plane; a hole belongs to the smallest outline around it. `line`: see line_of; zero for
  // faces in the plane of the section.
  void add_faces(std::vector<Ring>& outlines, std::vector<Ring>& holes, const RealVector& line, std::vector<PolyFace>& faces) const {
    const std::size_t first = faces.size();
    for (Ring& outline : outlines) faces.push_back({std::move(outline), {}});
    if (holes.empty() || outlines.empty()) return;
    std::array<std::size_t, 2> axes{(plane_.axis + 1) % 3, (plane_.axis + 2) % 3};
    // A face that the plane cuts has an area in the projection on that axis and the longer one of its line.
    if (line != RealVector{}) axes = {plane_.axis, std::abs(line[axes[0]]) > std::abs(line[axes[1]]) ? axes[0] : axes[1]};
    std::vector<double> areas;
    for (std::size_t f = first; f < faces.size(); ++f) areas.push_back(std::abs(area(faces[f].outline, axes)));
    for (Ring& hole : holes) {
      std::optional<std::size_t> around;
      for (std::size_t f = first; f < faces.size(); ++f)
        if ((!around || areas[f - first] < areas[*around - first]) && contains(faces[f].outline, hole, axes)) around = f;
      if (around) faces[*around].holes.push_back(std::move(hole));
    }
  }

  // Twice the area, positive if counterclockwise.
  [[nodiscard]] double area(const Ring& ring, const std::array<std::size_t, 2>& axes) const {
    double sum = 0;
    const RealVector& origin = mesh_.vertices[ring[0]];
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const RealVector a = geometry::difference(mesh_.vertices[ring[i - 1]], origin);
      const RealVector b = geometry::difference(mesh_.vertices[ring[i]], origin);
      sum += a[axes[0]] * b[axes[1]] - a[axes[1]] * b[axes[0]];
    }
    return sum;
  }

  // Whether the middle of the hole's first side is within the outline.
  [[nodiscard]] bool contains(const Ring& outline, const Ring& hole, const std::array<std::size_t, 2>& axes) const {
    const auto [u, v] = axes;
    const double x = (mesh_.vertices[hole[0]][u] + mesh_.vertices[hole[1]][u]) / 2;
    const double y = (mesh_.vertices[hole[0]][v] + mesh_.vertices[hole[1]][v]) / 2;
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const RealVector& a = mesh_.vertices[outline[i]];
      const RealVector& b = mesh_.vertices[outline[(i + 1) % outline.size()]];
      if ((a[v] > y) != (b[v] > y) && x < a[u] + (y - a[v]) / (b[v] - a[v]) * (b[u] - a[u])) inside = !inside;
    }
    return inside;
  }

  // Two faces that meet in an edge in the plane have it in both directions: the cut surface then does not have it.
  void add_segment(VertexIndex from, VertexIndex to) {
    if (from == to) return;
    if (const auto opposite = unpaired_.find(key(to, from)); opposite != unpaired_.end() && !opposite->second.empty()) {
      segments_[opposite->second.back()].used = true;
      opposite->second.pop_back();
      return;
    }
    unpaired_[key(from, to)].push_back(segments_.size());
    segments_.push_back({from, to});
  }

  // The side that follows a side at its end: of several the one that has no other between it and the side, in the inside, which is on the
  // left, seen from the part that was taken away.
  [[nodiscard]] std::size_t next_of(std::size_t side, const std::vector<std::size_t>& starts, std::size_t first) const {
    const std::array<std::size_t, 2> axes{(plane_.axis + 1) % 3, (plane_.axis + 2) % 3};
    const auto direction = [&](VertexIndex from, VertexIndex to) {
      const RealVector d = geometry::difference(mesh_.vertices[to], mesh_.vertices[from]);
      return std::atan2(d[axes[1]] * -sign_, d[axes[0]]);
    };
    const double back = direction(segments_[side].to, segments_[side].from);
    std::size_t best = segments_.size();
    double least = 0;
    for (const std::size_t each : starts) {
      if (segments_[each].used && each != first) continue;
      double turn = back - direction(segments_[each].from, segments_[each].to);
      while (turn <= 0) turn += 2 * std::numbers::pi;
      if (best != segments_.size() && turn >= least) continue;
      best = each;
      least = turn;
    }
    return best;
  }

  // The cut surface of a solid: its sides joined to rings, outlines counterclockwise seen from the part that was taken away. A ring with a
  // gap is left out, and the body becomes a sheet.
  void close(std::vector<PolyFace>& faces) {
    std::unordered_map<VertexIndex, std::vector<std::size_t>> starts;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      if (!segments_[i].used) starts[segments_[i].from].push_back(i);
    const std::array<std::size_t, 2> axes{(plane_.axis + 1) % 3, (plane_.axis + 2) % 3};
    std::vector<Ring> outlines;
    std::vector<Ring> holes;
    for (std::size_t first = 0; first < segments_.size(); ++first) {
      if (segments_[first].used) continue;
      Ring ring;
      std::size_t side = first;
      do {
        segments_[side].used = true;
        ring.push_back(segments_[side].from);
        side = next_of(side, starts[segments_[side].to], first);
      } while (side != first && side != segments_.size());
      if (side != first) {
        ++open_rings_;
        continue;
      }
      for (Ring& loop : loops_of(ring)) {
        const double turn = area(loop, axes) * -sign_;
        if (turn > 0) outlines.push_back(std::move(loop));
        if (turn < 0) holes.push_back(std::move(loop));
      }
    }
    add_faces(outlines, holes, {}, faces);
  }

  // Loops that pass no vertex twice.
  static std::vector<Ring> loops_of(const Ring& ring) {
    std::vector<Ring> loops;
    Ring path;
    std::unordered_map<VertexIndex, std::size_t> position;
    for (const VertexIndex v : ring) {
      if (const auto known = position.find(v); known != position.end()) {
        const std::size_t begin = known->second;
        loops.emplace_back(path.begin() + begin, path.end());
        for (std::size_t i = begin; i < path.size(); ++i) position.erase(path[i]);
        path.resize(begin);
      }
      position[v] = path.size();
      path.push_back(v);
    }
    loops.push_back(std::move(path));
    return loops;
  }

  void cut_wires() {
    std::vector<PolyWire> wires;
    for (PolyWire wire : mesh_.wires) {
      if (!kept(wire[0]) && !kept(wire[1])) continue;
      if (kept(wire[0]) != kept(wire[1])) wire[kept(wire[0]) ? 1 : 0] = passage(wire[0], wire[1]).vertex;
      wires.push_back(wire);
    }
    mesh_.wires = std::move(wires);
  }

  PolyMesh& mesh_;
  SectionPlane plane_;
  double sign_;
  std::uint32_t cut_material_;
  std::size_t first_of_body_ = 0;  // of the new faces
  std::size_t open_rings_ = 0;
  std::unordered_map<EdgeKey, VertexIndex> cuts_;
  std::vector<Segment> segments_;                          // of one body
  std::unordered_map<EdgeKey, std::vector<std::size_t>> unpaired_;  // of these, by both vertices
};

// The scene as a mesh in the unit of the file. Borders between colours of single faces are no lines, so that these materials are left out.
PolyMesh mesh_of(const LoadedScene& source) {
  const PolyScene& scene = source.scene;
  PolyMesh mesh;
  mesh.source = source.name;
  mesh.name = scene.name;
  for (const PolyPoint& vertex : scene.vertices) mesh.vertices.push_back(file_point(scene, vertex));
  mesh.bodies = scene.bodies;
  mesh.grouped = true;
  mesh.materials = scene.material_of;
  if (mesh.materials.empty() || scene.materials_are_colours) mesh.materials.assign(face_count(scene), 0);
  mesh.wires = scene.wires;
  mesh.unit = source.report.unit;
  // The vertices of the scene are planar but for rounding, those of the cut but for the last bits of doubles.
  const PolyBounds bounds = bounds_of(scene);
  mesh.precision = static_cast<double>(bounds.half_size()) * scene.step * 0x1p-40;
  return mesh;
}

// Faces without holes, as import_poly mends them: those with holes become triangles between their vertices, as these will be rounded.
// Error bad_input: a face has too many vertices for that.
std::optional<base::Error> split_faces_with_holes(PolyMesh& mesh, const std::optional<std::array<double, 3>>& eye) {
  const Quantisation grid = quantisation_of(mesh.vertices, eye);
  std::vector<PolyPoint> vertices;
  std::vector<std::uint32_t> materials;
  std::size_t number = 0;
  for (PolyBody& body : mesh.bodies) {
    std::vector<PolyFace> faces;
    for (PolyFace& face : body.faces) {
      const std::uint32_t material = mesh.materials[number++];
      if (face.holes.empty()) {
        faces.push_back(std::move(face));
        materials.push_back(material);
        continue;
      }
      if (vertices.empty()) {
        for (const auto& vertex : mesh.vertices)
          vertices.push_back({quantised(vertex[0], grid, 0), quantised(vertex[1], grid, 1), quantised(vertex[2], grid, 2)});
      }
      const auto triangles = triangulate(vertices, face, most_split_vertices);
      if (!triangles) {
        std::size_t count = face.outline.size();
        for (const Ring& hole : face.holes) count += hole.size();
        return base::Error{mesh.source, "the section", fmt::format("found a face of {} vertices with {} holes that cannot be divided into triangles",
                                                                   count, face.holes.size()),
                           fmt::format("a simple face of at most {} vertices", most_split_vertices), "move the plane"};
      }
      for (const auto& triangle : *triangles) faces.push_back({{triangle[0], triangle[1], triangle[2]}, {}});
      materials.resize(materials.size() + triangles->size(), material);
    }
    body.faces = std::move(faces);
  }
  mesh.materials = std::move(materials);
  return std::nullopt;
}

}  // namespace

base::Result<Section> section_of(const LoadedScene& source, std::span<const SectionPlane> planes, const PolyImportOptions& options) {
  PolyMesh mesh = mesh_of(source);
  Section section;
  section.cut_material = mesh.materials.empty() ? 1 : *std::max_element(mesh.materials.begin(), mesh.materials.end()) + 1;
  std::size_t open_rings = 0;
  for (SectionPlane plane : planes) {
    // The vertices were rounded to the grid, and so are faces in the plane.
    if (source.report.largest_shift > 0)
      plane.at = steps_in_file(std::llround(plane.at / source.scene.step), source.scene.step);
    Cutter cutter(mesh, plane, section.cut_material);
    cutter.run();
    open_rings += cutter.open_rings();
  }
  std::erase_if(mesh.bodies, [](const PolyBody& body) { return body.faces.empty(); });
  if (mesh.bodies.empty() && mesh.wires.empty()) return base::Error{source.name, "", "nothing behind the planes of the section"};
  if (auto error = split_faces_with_holes(mesh, options.eye)) return std::move(*error);
  PolyImportOptions import_options;
  import_options.mend = true;
  import_options.eye = options.eye;
  if (source.report.largest_shift > 0) import_options.planar_tolerance = 2 * source.scene.step;
  auto import = import_poly(std::move(mesh), import_options);
  if (!import) return std::move(import.error());
  LoadedScene& loaded = section.loaded;
  loaded.name = source.name;
  loaded.scene = std::move(import->scene);
  loaded.report = source.report;
  loaded.report.step = import->report.step;
  loaded.report.largest_shift = std::max(source.report.largest_shift, import->report.largest_shift);
  const std::size_t left_out = open_rings + import->report.faces.crossing_faces;
  if (left_out > 0) section.notes.push_back(fmt::format("{} cut faces of the section are left out: their outlines cross or have gaps", left_out));
  loaded.scene.name = source.scene.name;
  PolyCamera camera = source.scene.camera;
  if (const auto eye = grid_point(loaded.scene, file_point(source.scene, camera.eye))) {
    camera.eye = *eye;
  } else {
    camera.perspective = false;
    camera.eye = bounds_of(loaded.scene).middle();
  }
  loaded.scene.camera = camera;
  return section;
}

}  // namespace sightline::scene
