// See poly_import.hpp.
#include "host/scene/read/poly_import.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "host/base/result.hpp"
#include "host/base/threads.hpp"
#include "host/geometry/box_tree.hpp"
#include "host/geometry/vector.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/model/file_units.hpp"
#include "host/scene/read/open_vertices.hpp"
#include "host/scene/read/poly_mend.hpp"
#include "host/scene/read/poly_planes.hpp"
#include "host/scene/read/poly_quantise.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::scene {
namespace {

constexpr VertexIndex no_point = std::numeric_limits<VertexIndex>::max();

class Import {
 public:
  Import(PolyMesh mesh, const PolyImportOptions& options) : mesh_(std::move(mesh)), options_(options) {}

  base::Result<PolyImport> run() {
    report().vertical = mesh_.vertical;
    report().unit = mesh_.unit.empty() ? options_.unit : std::move(mesh_.unit);
    report().notes = std::move(mesh_.notes);
    face_in_file_ = std::move(mesh_.face_in_file);
    if (mesh_.flaw) leave_out_flawed();
    if (!options_.watch.go_on(0.3)) return base::cancelled();
    quantise();
    if (!options_.watch.go_on(0.4)) return base::cancelled();
    scene().name = std::move(mesh_.name);
    scene().bodies = std::move(mesh_.bodies);
    scene().wires = std::move(mesh_.wires);
    if (auto error = divide_faces_with_holes()) return std::move(*error);
    if (auto error = mend_faces()) return std::move(*error);
    if (!options_.watch.go_on(0.9)) return base::cancelled();
    scene().camera = default_poly_camera(scene());
    if (report().vertical && *report().vertical != 1)
      scene().camera = three_quarter_camera({.vertical = *report().vertical}, scene());
    return std::move(result_);
  }

 private:
  [[nodiscard]] PolyScene& scene() { return result_.scene; }
  [[nodiscard]] PolyImportReport& report() { return result_.report; }
  [[nodiscard]] MendReport& faces() { return result_.report.faces; }

  // Faces of fewer than three vertices or with one that is no point, and the vertices that are none.
  void leave_out_flawed() {
    std::vector<VertexIndex> number(mesh_.vertices.size());
    std::size_t points = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      const auto& [x, y, z] = mesh_.vertices[v];
      number[v] = no_point;
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) continue;
      number[v] = static_cast<VertexIndex>(points);
      mesh_.vertices[points++] = mesh_.vertices[v];
      vertex_in_file_.push_back(static_cast<std::uint32_t>(v));
    }
    const std::size_t no_points = number.size() - points;
    mesh_.vertices.resize(points);
    std::size_t thin = 0;
    std::size_t nowhere = 0;
    std::uint32_t face_number = 0;
    std::vector<std::uint32_t> kept_faces;  // their numbers before
    for (PolyBody& body : mesh_.bodies) {
      std::vector<PolyFace> kept;
      for (PolyFace& face : body.faces) {
        for (VertexIndex& v : face.outline) v = number[v];
        if (face.outline.size() < 3) {
          ++thin;
        } else if (std::count(face.outline.begin(), face.outline.end(), no_point) > 0) {
          ++nowhere;
        } else {
          kept.push_back(std::move(face));
          kept_faces.push_back(face_number);
        }
        ++face_number;
      }
      body.faces = std::move(kept);
    }
    std::erase_if(mesh_.bodies, [](const PolyBody& body) { return body.faces.empty(); });
    if (!mesh_.materials.empty()) {
      for (std::size_t f = 0; f < kept_faces.size(); ++f) mesh_.materials[f] = mesh_.materials[kept_faces[f]];
      mesh_.materials.resize(kept_faces.size());
    }
    for (std::uint32_t& face : kept_faces) face = face_in_file(face);
    face_in_file_ = std::move(kept_faces);
    std::size_t wires = 0;
    for (const PolyWire& wire : mesh_.wires) {
      const PolyWire kept{number[wire[0]], number[wire[1]]};
      if (kept[0] != no_point && kept[1] != no_point) mesh_.wires[wires++] = kept;
    }
    mesh_.wires.resize(wires);
    const auto note = [&](std::size_t count, const std::string& one, const std::string& many, const std::string& what) {
      if (count > 0) report().notes.push_back(std::to_string(count) + " " + (count == 1 ? one : many) + what);
    };
    const std::string not_finite = " with a coordinate that is no finite number";
    note(nowhere, "face", "faces", not_finite);
    if (nowhere == 0) note(no_points, "vertex", "vertices", not_finite);
    note(thin, "face", "faces", " of fewer than three vertices");
  }

  void quantise() {
    const Quantisation q = quantisation_of(mesh_.vertices, options_.eye, options_.jobs);
    scene().step = report().step = q.step;
    scene().origin = q.origin;
    report().quantised = !q.as_it_is;
    scene().vertices.resize(mesh_.vertices.size());
    const std::array<double, 3> origin = file_point(scene(), {});
    std::vector<double> shift(options_.jobs);  // the largest one in each part
    std::vector<double> reach(options_.jobs);
    base::for_parts(options_.jobs, mesh_.vertices.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        for (std::size_t a = 0; a < 3; ++a) {
          std::int32_t& c = scene().vertices[v][a];
          double& in_file = mesh_.vertices[v][a];
          c = quantised(in_file, q, a);
          if (!q.as_it_is) shift[part] = std::max(shift[part], std::abs(q.value_of(std::int64_t{c} + q.origin[a]) - in_file));
          reach[part] = std::max(reach[part], std::abs(in_file));
          in_file -= origin[a];  // what is computed from it has the bits for the size of the scene alone
        }
      }
    });
    report().largest_shift = *std::max_element(shift.begin(), shift.end());
    reach_ = *std::max_element(reach.begin(), reach.end());
    size_ = 2 * static_cast<double>(bounds_of(scene()).half_size()) * report().step;
  }

  // Against the outline.
  void turn_holes(PolyFace& face) {
    const auto outwards = ring_normal(scene().vertices, face.outline);
    for (Ring& hole : face.holes)
      if (geometry::wide_dot(outwards, ring_normal(scene().vertices, hole)) > 0) std::reverse(hole.begin(), hole.end());
  }

  // Into triangles: faces that are mended have no holes.
  std::optional<base::Error> divide_faces_with_holes() {
    const auto has_holes = [](const PolyFace& face) { return !face.holes.empty(); };
    const auto is_whole = [&](const PolyBody& body) { return std::none_of(body.faces.begin(), body.faces.end(), has_holes); };
    if (std::all_of(scene().bodies.begin(), scene().bodies.end(), is_whole)) return std::nullopt;
    std::vector<std::uint32_t> sources;  // of each face now
    std::uint32_t number = 0;
    for (std::size_t b = 0; b < scene().bodies.size(); ++b) {
      std::vector<PolyFace> divided;
      for (std::size_t f = 0; f < scene().bodies[b].faces.size(); ++f, ++number) {
        PolyFace& face = scene().bodies[b].faces[f];
        if (!has_holes(face)) {
          divided.push_back(std::move(face));
          sources.push_back(number);
          continue;
        }
        turn_holes(face);
        if (!options_.mend && report().largest_shift == 0) {
          Problems problems;
          const std::string place = "body " + std::to_string(b) + ", face " + std::to_string(f);
          if (!check_face(scene().vertices, face, place, problems)) {
            base::Error error = problems.take().front();
            error.file = mesh_.source;
            return error;
          }
        }
        const auto triangles = triangulate(scene().vertices, face);
        if (!triangles) {
          return base::Error{mesh_.source, "body " + std::to_string(b) + ", face " + std::to_string(f), "cannot be divided into triangles",
                             "holes inside the outline that cross neither it nor each other, and at most " +
                                 std::to_string(most_split_vertices_with_holes) + " vertices"};
        }
        for (const auto& t : *triangles) {
          divided.push_back({{t[0], t[1], t[2]}, {}});
          sources.push_back(number);
        }
      }
      scene().bodies[b].faces = std::move(divided);
    }
    if (!mesh_.materials.empty()) {
      std::vector<std::uint32_t> materials;
      for (const std::uint32_t source : sources) materials.push_back(mesh_.materials[source]);
      mesh_.materials = std::move(materials);
    }
    for (std::uint32_t& source : sources) source = face_in_file(source);
    face_in_file_ = std::move(sources);
    return std::nullopt;
  }

  std::optional<base::Error> mend_faces() {
    FileFaces file{mesh_.vertices, {}};
    file.starts.reserve(face_count(scene()) + 1);
    std::size_t corners = 0;
    for (const PolyBody& body : scene().bodies)
      for (const PolyFace& face : body.faces) corners += face.outline.size();
    file.corners.reserve(corners);
    for (const PolyBody& body : scene().bodies)
      for (const PolyFace& face : body.faces) file.add(face.outline);
    std::vector<std::size_t> body_sizes;
    for (const PolyBody& body : scene().bodies) body_sizes.push_back(body.faces.size());
    MendResult mended = mend(scene(), file, mend_options(options_.weld), faces());
    faces().largest_deviation *= report().step;
    faces().first_crossing = face_in_file(faces().first_crossing);
    name_origins(mended);
    if (mesh_.flaw && !options_.mend) mended.faults = {*mesh_.flaw};
    for (base::Error& fault : mended.faults) fault.file = mesh_.source;
    result_.faults = std::move(mended.faults);
    if (mended.faces.empty() && scene().wires.empty()) {
      if (!result_.faults.empty() && !mesh_.flaw && file.size() > 0) return std::nullopt;
      if (file.size() == 0)
        return mesh_.flaw.value_or(base::Error{mesh_.source, "", "found no faces", "a mesh", "points alone make no drawing"});
      return base::Error{mesh_.source, "", "no face with an area is left of " + std::to_string(file.size()),
                         "a mesh", options_.mend ? "--strict names what is wrong with each" : ""};
    }
    report().mended = options_.mend || !result_.faults.empty();
    if (mended.faces.empty()) return std::nullopt;
    if (!options_.watch.go_on(0.7)) return base::cancelled();
    suggest_weld(file, body_sizes);
    // Numbers so short that this would be much of the mesh are meant as they are: a bevel of 0.2 is none of their errors.
    const double much = 2 * static_cast<double>(bounds_of(scene()).half_size()) * report().step / 1000;
    const double tolerance = options_.planar_tolerance.value_or(std::max(std::min(4 * mesh_.precision, much), options_.weld));
    find_surfaces(scene(), mended, file, std::max(tolerance, least_tolerance()), options_.jobs);
    if (report().quantised && !scene().wires.empty()) find_surfaces_of_wires();
    if (mesh_.materials.empty()) return std::nullopt;
    scene().materials_are_colours = mesh_.materials_are_colours;
    scene().material_of.reserve(mended.faces.size());
    for (const MendedFace& face : mended.faces) scene().material_of.push_back(mesh_.materials[face.source]);
    return std::nullopt;
  }

  void name_origins(const MendResult& mended) {
    scene().face_in_file.reserve(mended.faces.size());
    for (const MendedFace& face : mended.faces) scene().face_in_file.push_back(face_in_file(face.source));
    scene().vertex_in_file = mended.vertices;
    if (vertex_in_file_.empty()) return;
    for (std::uint32_t& vertex : scene().vertex_in_file) vertex = vertex_in_file_[vertex];
  }

  [[nodiscard]] std::uint32_t face_in_file(std::size_t face) const {
    return face_in_file_.empty() ? static_cast<std::uint32_t>(face) : face_in_file_[face];
  }

  // A wire and a corner of a surface are up to 0.87 steps from where the file has them. If that is much of the scene, the
  // numbers are so short that they have to be meant as they are.
  void find_surfaces_of_wires() {
    const double tolerance = std::min(2.0, static_cast<double>(bounds_of(scene()).half_size()) / 5000);
    const auto place_of = [this](VertexIndex v) { return geometry::real_vector(scene().vertices[v]); };
    struct Plane {
      geometry::RealVector normal{};
      double height = 0;
    };
    std::vector<Plane> planes(scene().surfaces.size());
    std::vector<geometry::Box> boxes(planes.size());
    std::vector<bool> known(planes.size(), false);
    std::size_t face = 0;
    for (const PolyBody& body : scene().bodies) {
      for (const PolyFace& of_body : body.faces) {
        const std::uint32_t surface = scene().surface_of[face++];
        const auto& normal = scene().surfaces[surface].normal;
        planes[surface] = {normal, geometry::dot(normal, place_of(of_body.outline[0]))};
        geometry::Box& box = boxes[surface];
        if (!known[surface]) box.low = box.high = scene().vertices[of_body.outline[0]];
        known[surface] = true;
        for (const VertexIndex v : of_body.outline) {
          for (std::size_t a = 0; a < 3; ++a) {
            box.low[a] = std::min(box.low[a], scene().vertices[v][a]);
            box.high[a] = std::max(box.high[a], scene().vertices[v][a]);
          }
        }
      }
    }
    // A surface far from a wire hides it only where both are nearly seen from the side.
    const double reach = 64 * tolerance;
    const geometry::BoxTree tree(boxes);
    for (std::uint32_t w = 0; w < scene().wires.size(); ++w) {
      const PolyWire& wire = scene().wires[w];
      const auto meets = [&](const geometry::Box& box) {
        return geometry::segment_meets(scene().vertices[wire[0]], scene().vertices[wire[1]], box, reach);
      };
      const geometry::RealVector from = place_of(wire[0]);
      const geometry::RealVector to = place_of(wire[1]);
      const std::size_t first = scene().wires_on.size();
      tree.for_each_that(meets, [&](std::uint32_t s) {
        const auto is_on = [&](const geometry::RealVector& p) { return std::abs(geometry::dot(planes[s].normal, p) - planes[s].height) <= tolerance; };
        if (is_on(from) && is_on(to)) scene().wires_on.push_back({w, s});
      });
      std::sort(scene().wires_on.begin() + static_cast<std::ptrdiff_t>(first), scene().wires_on.end());
    }
  }

  // A vertex and the two ends of the edge that it is on were each rounded, by 0.87 units of the precision at most. So are
  // whole numbers in a mesh of many units: what a unit is of a smaller one is meant.
  [[nodiscard]] MendOptions mend_options(double weld) const {
    constexpr double many = 1024;
    const bool whole = mesh_.precision == 0 && size_ >= many;
    return {.weld = weld / result_.report.step,
            .grouped = mesh_.grouped,
            .step = result_.report.step,
            .rounded = result_.report.largest_shift > 0,
            .tolerance = std::max(whole ? 2 : 2 * mesh_.precision, least_tolerance()),
            .name_faults = !options_.mend && !mesh_.flaw,
            .jobs = options_.jobs};
  }

  // What double coordinates leave uncertain of a plane.
  [[nodiscard]] double least_tolerance() const { return reach_ * 0x1p-48; }

  // For parts that are open: the smallest of 1, 2, 5, 10 .. with which as few are left as with any, if that is half of them
  // at most.
  void suggest_weld(const FileFaces& file, const std::vector<std::size_t>& body_sizes) {
    if (faces().sheets == 0 || faces().crowded) return;
    std::vector<double> welds;
    for (const double distance : weld_distances(scene(), faces().sheets / 2))
      if (welds.empty() || distance * report().step > welds.back()) welds.push_back(round_up(distance * report().step));
    if (welds.empty()) return;
    welds.push_back(round_up(1.1 * welds.back()));  // several vertices that belong together are in a chain
    const std::size_t faces_now = face_count(scene());
    const auto sheets_with = [&](double weld) {
      PolyScene again = scene_of(file, body_sizes);
      MendReport after;
      mend(again, file, mend_options(weld), after);
      // Faces that vanish are no help.
      return 10 * face_count(again) < 9 * faces_now ? faces().sheets : after.sheets;
    };
    constexpr int most_tries = 3;
    for (int tries = 0; tries < most_tries && !welds.empty(); ++tries, welds.pop_back()) {
      const std::size_t left = sheets_with(welds.back());
      if (2 * left > faces().sheets) continue;
      std::size_t low = 0;
      std::size_t high = welds.size() - 1;
      while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (sheets_with(welds[middle]) <= left) {
          high = middle;
        } else {
          low = middle + 1;
        }
      }
      faces().helpful_weld = welds[high];
      faces().sheets_with_weld = left;
      return;
    }
  }

  // The least of 1, 2, 5, 10 .. and their tenths that is not below the value, as a person writes it.
  static double round_up(double value) {
    const int exponent = static_cast<int>(std::floor(std::log10(value)));
    const double power = std::pow(10.0, std::abs(exponent));
    for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
      const double rounded = exponent < 0 ? digit / power : digit * power;
      if (rounded >= value * (1 + 1e-12)) return rounded;
    }
    return exponent < 0 ? 20 / power : 20 * power;
  }

  // What mend was given.
  [[nodiscard]] PolyScene scene_of(const FileFaces& file, const std::vector<std::size_t>& body_sizes) const {
    PolyScene scene;
    const Quantisation q{.step = result_.scene.step, .origin = result_.scene.origin};
    const std::array<double, 3> origin = file_point(result_.scene, {});
    for (const auto& vertex : mesh_.vertices) {
      PolyPoint& p = scene.vertices.emplace_back();
      for (std::size_t a = 0; a < 3; ++a) p[a] = quantised(vertex[a] + origin[a], q, a);
    }
    std::size_t face = 0;
    for (const std::size_t size : body_sizes) {
      PolyBody& body = scene.bodies.emplace_back();
      for (std::size_t i = 0; i < size; ++i, ++face) {
        const auto outline = file.outline(face);
        body.faces.push_back({{outline.begin(), outline.end()}, {}});
      }
    }
    return scene;
  }

  PolyMesh mesh_;  // its vertices less the origin, once they are on the grid
  double reach_ = 0;  // the largest coordinate of the file
  double size_ = 0;   // the largest side of its bounds
  std::vector<std::uint32_t> face_in_file_;    // of each face, if it is another one; otherwise empty
  std::vector<std::uint32_t> vertex_in_file_;  // of each vertex, if some were left out
  PolyImportOptions options_;
  PolyImport result_;
};

}  // namespace

base::Result<PolyImport> import_poly(PolyMesh mesh, const PolyImportOptions& options) {
  return Import(std::move(mesh), options).run();
}

PolyCamera default_poly_camera(const PolyScene& scene) {
  PolyCamera camera{true, {}, {-12, -9, -20}, {5, 0, -3}, {-27, 136, -45}};
  if (scene.vertices.empty()) return camera;
  PolyPoint low = scene.vertices[0];
  PolyPoint high = low;
  for (const PolyPoint& p : scene.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  std::int64_t half = 1;
  for (std::size_t a = 0; a < 3; ++a) half = std::max(half, (std::int64_t{high[a]} - low[a] + 1) / 2);
  // |forward| is 25: the eye is 25/8 of the half side away, the corners of the scene less than 14/8.
  std::array<std::int64_t, 3> eye{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t centre = (std::int64_t{low[a]} + high[a]) / 2;
    camera.eye[a] = static_cast<std::int32_t>(centre);
    eye[a] = centre - (camera.forward[a] * half - 7) / 8;
  }
  camera.perspective = std::all_of(eye.begin(), eye.end(), [](std::int64_t c) {
    return -poly_coordinate_limit < c && c < poly_coordinate_limit;
  });
  if (camera.perspective)
    for (std::size_t a = 0; a < 3; ++a) camera.eye[a] = static_cast<std::int32_t>(eye[a]);
  return camera;
}

}  // namespace sightline::scene
