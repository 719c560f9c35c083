// Hidden-line removal as a library: a mesh and a camera in, the lines that the camera sees out, exactly.
//
//   #include <sightline/hidden_lines.hpp>
//
//   const sightline::Scene scene = sightline::Scene::load("part.stl");
//   const sightline::Drawing drawing = scene.draw({.view = "iso"}, {.hidden = true});
//   for (const sightline::Line& line : drawing.lines) plot(line.from, line.to, line.hidden);
//
// or from arrays, and to a file:
//
//   sightline::Mesh mesh;
//   mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
//   mesh.corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
//   mesh.ring_sizes = {3, 3, 3, 3};
//   std::ofstream("tetrahedron.svg") << sightline::Scene(mesh).draw().file({.format = "svg"});
//
// Visibility is decided without tolerances. When a scene is made, its coordinates are rounded once to a grid (65,536 steps or
// more across the scene; whole numbers up to 262,143 and short decimals are not changed), and damage of a mesh is repaired
// (Scene::notes says what was done). From then on everything is computed in integers and fractions: which parts of which
// edges are visible, and where they end. Only positions on the drawing are doubles.
//
// Equal input gives equal output, on every machine and for any number of threads. There is no global state, nothing is
// printed, and the process is never ended. Errors are exceptions of type sightline::Error; a function that throws has changed
// nothing. A Scene and a Prepared scene can be used by several threads at once. Link with the CMake target
// sightline::hidden_lines (find_package(Sightline)), or with the flags of `pkg-config sightline-hidden-lines`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sightline {

// What a function throws. what() names the file or argument, the place in it, what was found and what was expected.
class Error : public std::runtime_error {
 public:
  enum class Kind : std::uint8_t {
    bad_input,  // a file, a mesh or a camera's place is wrong: the eye is inside a solid
    usage,      // an option is wrong: there is no view of this name
    io,         // a file cannot be read or written
    cancelled,  // the progress function returned false
  };

  Error(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  [[nodiscard]] Kind kind() const noexcept { return kind_; }

 private:
  Kind kind_;
};

using Point = std::array<double, 3>;

// Called now and then during long work, on the thread that called, with the part that is done, from 0 to 1. The work ends
// with an Error of kind cancelled if it returns false; what it throws, the caller gets.
using Progress = std::function<bool(double done)>;

// ----------------------------------------------------------------------------------------------------------- Meshes

// Vertices, planar faces and polylines, in any unit.
//
// A face has an outline, counterclockwise as seen from outside, and may have holes, with at most 1,024 corners in all.
// Faces around a closed volume are a solid, whichever way they are turned; other faces are sheets, visible from both
// sides. Faces of four corners and more that are not planar become triangles. Polylines hide nothing.
struct Mesh {
  std::vector<Point> vertices;
  std::vector<std::uint32_t> corners;     // numbers of vertices, from 0: those of all rings, one ring after the other
  std::vector<std::uint32_t> ring_sizes;  // corners of each ring, at least 3
  std::vector<std::uint32_t> face_rings;  // rings of each face: its outline, then its holes. Empty: each ring is a face
  std::vector<std::uint32_t> bodies;      // number of each face's body, below that of faces. Empty: faces that an edge joins are one body
  std::vector<std::uint32_t> line_points; // numbers of vertices: those of all polylines, one after the other
  std::vector<std::uint32_t> line_sizes;  // points of each polyline, at least 2
  std::string name = "mesh";              // named in errors

  // Adds a face; `holes` are rings of it. Not for a mesh with `bodies`.
  void add_face(std::span<const std::uint32_t> outline, std::span<const std::vector<std::uint32_t>> holes = {}) {
    if (!holes.empty() && face_rings.empty()) face_rings.assign(ring_sizes.size(), 1);
    if (!holes.empty() || !face_rings.empty()) face_rings.push_back(static_cast<std::uint32_t>(1 + holes.size()));
    add_ring(outline);
    for (const std::vector<std::uint32_t>& hole : holes) add_ring(hole);
  }
  void add_polyline(std::span<const std::uint32_t> points) {
    line_points.insert(line_points.end(), points.begin(), points.end());
    line_sizes.push_back(static_cast<std::uint32_t>(points.size()));
  }

 private:
  void add_ring(std::span<const std::uint32_t> ring) {
    corners.insert(corners.end(), ring.begin(), ring.end());
    ring_sizes.push_back(static_cast<std::uint32_t>(ring.size()));
  }
};

struct LoadOptions {
  // Repairs damage: joins vertices at one place, turns faces, splits faces that are not planar, leaves out faces without
  // area, closes cracks that rounding makes. If false, the first damage is an error.
  bool mend = true;
  double weld = 0;  // vertices at most this far apart become one, in the unit of the mesh
  // Faces whose vertices are within this distance of the plane of a larger neighbour belong to one surface with it.
  // nullopt: as the precision of the numbers requires.
  std::optional<double> planar_tolerance = {};
  // An eye from which the scene will be drawn. The grid is then chosen so that the eye is on it, or near: finer for a mesh of small
  // whole numbers, whose grid has steps of 1 otherwise; coarser for an eye far outside.
  std::optional<Point> eye = {};
  unsigned jobs = 1;  // threads
  Progress progress = {};
};

// ---------------------------------------------------------------------------------------------------------- Cameras

// Where the scene is seen from: a `view`, a `direction`, or an `eye` and a point to `look_at`; more than one of the three is an
// error. Without any, it is the camera of the file, or perspective from above, right and in front.
//
// Directions of view are kept to 15 bits: they differ by at most 0.3 degrees from what is asked for, and not at all where
// small whole numbers describe them, as in all standard views (Drawing::camera_error says by how much).
struct Camera {
  // In parallel projection: front, back, left, right, top, bottom, iso, dimetric, trimetric, NE, NW, SE or SW.
  std::string view = {};
  bool perspective = false;            // show `view` in perspective
  std::optional<Point> direction = {};  // parallel projection, looking in this direction
  // Perspective: looking from `eye` at `look_at`, or at the middle of the scene (from within its bounds, in the direction of the
  // scene's own camera). The eye is rounded to the scene's grid;
  // Drawing::eye is the one that was used, and Drawing::notes says so (see LoadOptions::eye).
  std::optional<Point> eye = {};
  std::optional<Point> look_at = {};
  std::optional<Point> up = {};  // points up on the drawing, as nearly as possible. nullopt: the vertical
  // The axis of the scene that points up: x, y, z, -x, -y or -z. Empty: as the format of the file says, or y.
  std::string vertical = {};
};

// --------------------------------------------------------------------------------------------------------- Drawings

struct DrawOptions {
  // Which edges are drawn: "feature" (all kinds but flat), "all", or some of silhouette, boundary, crease, border, intersection and
  // wire (polylines), separated by commas.
  std::string edges = "feature";
  double crease = 30;   // degrees: the least angle between the faces at a crease
  bool hidden = false;  // also the hidden parts
  // The size of the drawing, and the unit of all positions on it: millimetres, if it becomes a file. The picture is fitted
  // to it and placed in its middle.
  double width = 200;
  double height = 200;
  // Units of the drawing per unit of the mesh, instead of fitting; only in parallel projection. The drawing grows beyond width
  // and height if necessary.
  std::optional<double> scale = {};
  // Angle of the image across the shorter side, in degrees; only in perspective.
  std::optional<double> field = {};
  double min_length = 0;  // of a line on the drawing; shorter ones that join no others are left out
  unsigned jobs = 1;      // threads; the drawing is the same for any number. Hidden parts are searched by one
  bool certificate = false;  // fill in Drawing::certificate
  Progress progress = {};
};

// An edge of several kinds has the first of them.
enum class Kind : std::uint8_t {
  silhouette,    // between a face turned to the eye and one turned away
  junction,      // of three or more faces; drawn with every choice
  boundary,      // of one face
  crease,        // between two faces that bend by more than the angle
  border,        // between two materials of a file
  intersection,  // where two faces pass through each other
  polyline,      // of a polyline
  flat,          // all others
};

inline constexpr std::uint32_t none = 0xffffffff;

// Where a line of the scene comes from. Numbers are those of the mesh or file that the scene was made from, from 0.
struct Edge {
  Kind kind = Kind::flat;
  std::array<Point, 2> ends{};  // in the unit of the mesh, on the grid of the scene
  // none: the end of an intersection. Of a file without numbered vertices, such as STL, different places are numbered as they come.
  std::array<std::uint32_t, 2> vertices{none, none};
  // The faces at the edge, ascending: Drawing::faces[first_face] and the following ones; of an intersection, both faces.
  std::uint32_t first_face = 0;
  std::uint32_t face_count = 0;
  std::uint32_t body = none;  // of the scene: see Scene::bodies. Of an edge of several, the first; none: of a polyline
};

// An exact fraction in lowest terms.
struct Fraction {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;  // positive

  [[nodiscard]] double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
  friend bool operator==(const Fraction&, const Fraction&) = default;
};

// A part of one edge, from ends[0] + low (ends[1] - ends[0]) to the same with high. Parts ascend by edge, then along it. The
// fractions of intersections are rounded to multiples of 2^-60; all others are exact. Where a hidden part passes from one face to
// another that hides it, it is divided; so it is between triangles of one face.
struct Part {
  std::uint32_t edge = 0;  // of Drawing::edges
  Fraction low;
  Fraction high;
  bool hidden = false;
  // A face that hides the part, in the numbers of the mesh. none: the part is visible or behind the eye; or the edge is one of a
  // curved surface, which itself hides it.
  std::uint32_t hidden_by = none;
};

// A straight line of the drawing, in its unit, from the bottom left corner; no two cover each other. Edges that lie exactly
// behind one another share a line.
struct Line {
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  Kind kind = Kind::flat;
  bool hidden = false;
  // Drawing::line_edges[first_edge] and the following ones are the edges that lie there.
  std::uint32_t first_edge = 0;
  std::uint32_t edge_count = 0;
};

struct FileOptions {
  std::string format = "svg";  // svg, pdf, dxf, hpgl, png or steps
  std::string title = {};
  double margin = 10;        // mm around the drawing, on paper; added to its width and height
  double pen = 0.2;          // mm: width of a line, in SVG, PDF and PNG
  double dpi = 150;          // pixels per inch, in PNG
  bool as_found = false;     // keep the order of the lines; otherwise the raised pen's way is made short
};

struct Drawing {
  std::vector<Line> lines;  // what is to be drawn
  std::vector<Part> parts;  // the exact parts of edges behind it: visible ones, and with DrawOptions::hidden also the others
  std::vector<Edge> edges;  // the chosen edges that have a part
  std::vector<std::uint32_t> line_edges;  // numbers of edges, ascending for each line
  std::vector<std::uint32_t> faces;       // numbers of faces, see Edge
  // The camera: `axes` are the directions to the right, upwards and forwards, of length 1. A point p has the image
  // x = axes[0] . (p - eye), y = axes[1] . (p - eye), both divided by axes[2] . (p - eye) in perspective. It is drawn at
  // scale * (x - low[0], y - low[1]).
  bool perspective = false;
  Point eye{};  // in the unit of the mesh
  std::array<Point, 3> axes{};
  double scale = 1;
  std::array<double, 2> low{};
  double camera_error = 0;  // degrees between the direction of view and the one asked for
  double width = 0;         // of the drawing
  double height = 0;
  std::vector<std::string> notes;  // sentences on what differs from what was asked for
  // A proof of what is visible and what is hidden, which `sightline verify` checks: see DrawOptions::certificate.
  std::string certificate;

  // The drawing as the bytes of a file. Throws Error usage: an unknown format; io: a PNG of this size is impossible.
  [[nodiscard]] std::string file(const FileOptions& options = {}) const;

  struct Picture;
  std::shared_ptr<const Picture> picture;  // what a file is made of
};

// ----------------------------------------------------------------------------------------------------------- Scenes

class Prepared;

// A mesh on its grid, repaired and checked. Copies share it.
class Scene {
 public:
  // Throws Error bad_input: a coordinate that is not finite, a number of a vertex that does not exist, sizes that do not add
  // up, a mesh without faces and lines, or, without LoadOptions::mend, damage.
  explicit Scene(const Mesh& mesh, const LoadOptions& options = {});
  // A file (OBJ, OFF, STL, PLY, glTF, 3MF or JSON, recognized by its beginning), a built-in scene ("house") or a generated
  // one ("boxes-100-7"). Throws Error io: it cannot be read; bad_input: the first fault, with its place in the file.
  [[nodiscard]] static Scene load(const std::string& path, const LoadOptions& options = {});

  // Throws Error usage: an option is wrong; bad_input: the eye is inside a solid or on a face.
  [[nodiscard]] Drawing draw(const Camera& camera = {}, const DrawOptions& options = {}) const;
  // For many views: computes what they share. Errors as those of draw.
  [[nodiscard]] Prepared prepare(const DrawOptions& options = {}) const;

  [[nodiscard]] std::size_t face_count() const;    // after repairs
  [[nodiscard]] std::size_t vertex_count() const;  // after repairs
  [[nodiscard]] std::array<Point, 2> bounds() const;       // in the unit of the mesh
  [[nodiscard]] std::vector<std::string> bodies() const;   // their names, which may be empty
  [[nodiscard]] double step() const;                       // of the grid, in the unit of the mesh
  [[nodiscard]] std::vector<std::string> notes() const;    // sentences on what rounding and repairs changed

 private:
  friend class Prepared;
  struct Data;
  explicit Scene(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

// A scene made ready for views with the same options.
class Prepared {
 public:
  // Throws what Scene::draw throws.
  [[nodiscard]] Drawing draw(const Camera& camera = {}) const;

 private:
  friend class Scene;
  struct Data;
  explicit Prepared(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

// The names of standard views, for Camera::view.
[[nodiscard]] std::vector<std::string> view_names();
// "0.1.0"
[[nodiscard]] std::string version();

}  // namespace sightline
