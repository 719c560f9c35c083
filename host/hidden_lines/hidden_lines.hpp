// Hidden-line removal: reads a scene of polyhedra, finds which parts of its edges a camera sees, and makes a drawing and
// a file of them.
//
//   const auto scene = hidden_lines::load("part.obj");
//   if (!scene) return fail(scene.error().message());
//   const auto drawing = hidden_lines::view(*scene, scene->scene.camera);
//   if (!drawing) return fail(drawing.error().message());
//   const auto file = hidden_lines::write(drawing->picture, {.format = hidden_lines::Format::svg});
//   if (!file) return fail(file.error().message());
//   // file->bytes is the SVG.
//
// Visibility is decided in integers and fractions, without tolerances: a scene is rounded to a grid once, when it is read
// (host/scene/read/poly_import.hpp), and everything after that is exact. Doubles are only used for positions on the
// paper. The algorithm is `exact` (host/algorithms/exact) unless ViewOptions names another one of
// host/algorithms/registry/lines.hpp.
//
// Nothing here prints, ends the process or throws. A function that can fail returns a base::Result; the kind of its
// base::Error tells whether the input (bad_input), the request (usage) or a file (io) is wrong. `notes` are sentences to
// show to the user about what was changed or left out. Equal input gives equal bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/exact/witnesses.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/base/result.hpp"
#include "host/base/watch.hpp"
#include "host/geometry/rational.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/plotter.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/load.hpp"
#include "host/scene/read/section.hpp"

namespace sightline::hidden_lines {

// --- Scenes

// The polyhedra (`scene`, in steps of its grid; `scene.step` is the length of a step in the unit of the file), the name
// used in errors, and the changes made while reading (`report`).
using Scene = scene::LoadedScene;
// The eye (in steps) and three orthogonal integer directions; host/scene/model/aim_camera.hpp makes one from any
// direction. `Scene::scene.camera` is the file's own camera, or one from above, right and in front.
using Camera = scene::PolyCamera;
using LoadOptions = scene::PolyImportOptions;
// Repairs damage of a mesh, such as faces turned the wrong way.
inline const LoadOptions mending{.mend = true};

// Finds a scene by name: a built-in scene ("house"), a generated one (FAMILY-SIZE or FAMILY-SIZE-SEED, such as
// "boxes-100-7"), or the path of a file (JSON, OFF, OBJ, STL, PLY, glTF or 3MF, recognized by its text). Reads that file
// only.
// Error usage: a generated scene of an impossible size. Error io: the file does not exist or cannot be read.
[[nodiscard]] base::Result<scene::SceneFile> find(const std::string& name);

// Reads and checks a scene from find(), or from a text (SceneFile::text; its format is recognized by SceneFile::name and
// its first bytes).
// Error bad_input: the first fault, with its place in the file.
[[nodiscard]] base::Result<Scene> load(scene::SceneFile file, const LoadOptions& options = mending);
// Finds and reads a scene by name. Errors also as those of find.
[[nodiscard]] base::Result<Scene> load(const std::string& name, const LoadOptions& options = mending);
// Vertices, faces with holes, bodies and lines in memory, in any unit; faces are counterclockwise as seen from outside.
// Error bad_input: a coordinate that is not a finite number, an index without a vertex, or a fault for which a file would
// be rejected.
[[nodiscard]] base::Result<Scene> load(scene::PolyMesh mesh, const LoadOptions& options = mending);

// Describes what was changed while a scene was read: rounding, repairs and omissions.
[[nodiscard]] std::vector<std::string> notes_of(const scene::PolyImportReport& report);

// --- Views

// Which edges are drawn.
struct EdgeOptions {
  // "feature": silhouettes, boundaries, creases, borders of materials, lines in which bodies pass through each other, and
  // lines without faces. "all": also edges between coplanar faces. Or kinds separated by commas:
  // picture::edge_kind_names.
  // Empty: "feature" for a mesh; for other scenes, all edges except those across which the visible surface is flat.
  std::string kinds;
  // Minimum angle in degrees between the faces at a crease. nullopt: 30 for a mesh, 0 for all other scenes.
  std::optional<double> crease = {};

  [[nodiscard]] bool are_given() const { return !kinds.empty() || crease.has_value(); }
};

// Error usage: an unknown kind, or an angle that is not a finite number.
[[nodiscard]] base::Result<base::Done> check(const EdgeOptions& options);
// The edges that the options choose for a scene; nullopt: all edges. Precondition: the options were checked.
[[nodiscard]] std::optional<picture::EdgeChoice> edge_choice(const EdgeOptions& options, const scene::PolyScene& scene);

struct HatchOptions {
  double angle = 45;   // degrees on the paper, counterclockwise from the horizontal
  double spacing = 1;  // distance of the densest lines, in the unit of the field
  // Direction towards the light, in the axes of the file, of any length except 0. nullopt: from above left, behind the
  // eye.
  std::optional<std::array<double, 3>> light = {};
};

// How visible lines are divided into layers of the drawing. Hidden lines and hatching have layers of their own.
enum class Layers : std::uint8_t { kind, body, one };

struct ViewOptions {
  std::string algorithm = "exact";  // see registry::line_algorithms
  EdgeOptions edges = {};
  bool hidden = false;  // also draw the hidden parts of the edges, dashed
  Layers layers = Layers::kind;
  std::optional<HatchOptions> hatch = {};  // faces are shaded by lines
  // Of a section (scene::section_of): its cut faces are hatched, with lines 2 units of the field apart.
  std::optional<std::uint32_t> cut_material = {};
  picture::DrawingField field = {};        // the size of the drawing, and the part of the image that it shows
  bool strokes = false;                    // tell where each line comes from: Drawing::strokes and the following members
  bool proof = false;                      // fill in Drawing::proof; only with the algorithm `exact`
  unsigned jobs = 1;                       // threads; the result is the same for any number
};

inline constexpr std::uint32_t no_number = 0xffffffff;

// An edge of which a drawing shows a part, in terms of the file that the scene came from.
struct DrawnEdge {
  picture::LineEdge edge;                        // by vertex numbers of the scene
  std::string_view kind;                         // of picture::edge_kind_names or picture::hatching_kinds
  std::array<std::array<double, 3>, 2> ends{};   // in the unit of the file
  std::array<std::uint32_t, 2> vertices{no_number, no_number};  // numbers in the file from 0; no_number: an intersection, or a line of hatching
  // The faces at the edge: numbers in the file from 0, ascending, in Drawing::edge_faces.
  std::uint32_t first_face = 0;
  std::uint32_t face_count = 0;
  std::uint32_t body = no_number;  // of the scene; of an edge of several bodies the first; no_number: a wire
};

// An exact part of an edge.
struct DrawnPart {
  std::uint32_t edge = 0;  // of Drawing::edges
  geometry::Rational low;
  geometry::Rational high;
  bool hidden = false;
  // Of a hidden part, a face that hides it: a number in the file from 0. no_number: the part is behind the eye, or its own surface
  // hides it.
  std::uint32_t hidden_by = no_number;
};

// A straight line of a drawing. Strokes do not overlap.
struct Stroke {
  std::array<double, 2> from{};  // in the unit of the field, from its bottom left
  std::array<double, 2> to{};
  std::uint32_t layer = 0;       // of Drawing::layers
  // Numbers of the edges that lie there, ascending, in Drawing::stroke_edges.
  std::uint32_t first_edge = 0;
  std::uint32_t edge_count = 0;
};

struct DrawnLayer {
  std::string kind;  // of the edges
  std::string name;
  bool hidden = false;
};

// Which faces hide the hidden parts of each edge.
struct Proof {
  std::optional<picture::ChosenEdges> chosen;  // nullopt: all edges
  std::vector<algorithms::exact::EdgeProof> edges;
};

struct Drawing {
  picture::VectorDrawing picture;
  picture::ImageWindow window = {};  // the part of the image that the drawing shows
  // The exact visible pieces of the chosen edges, by vertex numbers and fractions of their length. Edges across which the
  // surface is flat are included.
  picture::LinePicture visible = {};
  std::vector<registry::AlgorithmCount> counts = {};  // the algorithm's counts
  std::optional<std::size_t> edges = {};              // number of chosen edges; nullopt: all of the scene
  std::optional<std::array<std::size_t, picture::edge_kind_count>> by_kind = {};
  std::size_t pieces = 0;       // drawn, without hatching
  double visible_length = 0;    // of `visible`, see picture::image_length
  std::size_t hatch_lines = 0;  // before hidden parts are removed
  std::size_t hatch_pieces = 0;
  std::size_t stroke_count = 0;
  double drawn_length = 0;  // of all strokes, in the unit of the field
  // Where the lines come from; empty without ViewOptions::strokes. Edges ascend by their vertices, parts by edge and then along
  // it.
  std::vector<Stroke> strokes = {};
  std::vector<DrawnLayer> layers = {};
  std::vector<DrawnEdge> edges_drawn = {};
  std::vector<DrawnPart> parts = {};
  std::vector<std::uint32_t> stroke_edges = {};
  std::vector<std::uint32_t> edge_faces = {};
  std::shared_ptr<const Proof> proof = {};  // null unless ViewOptions::proof
  std::vector<std::string> notes = {};  // of hidden_lines::view; for Views see Views::notes
};

// Many views of one scene. The data that they share is computed once.
class Views {
 public:
  // Precondition: `scene` outlives the views. `cameras` matter for a scene of cells: the real lines of its matter,
  // including those of the outer box, are drawn if all cameras are perspective cameras inside a cell and no edges are
  // chosen. Otherwise, and for every other scene, the edges of its faces are drawn.
  // Error usage: an option is wrong (Error::file is its name), or the algorithm does not apply to the scene. Error
  // bad_input: the algorithm failed.
  // Error cancelled: the watch ended the work.
  [[nodiscard]] static base::Result<Views> of(const Scene& scene, const ViewOptions& options = {}, std::span<const Camera> cameras = {},
                                              const base::Watch& watch = {});
  Views(Views&&) noexcept;
  Views& operator=(Views&&) noexcept;
  ~Views();

  // Precondition: the eye is in no solid and on no face (see scene::eye_error).
  // Error bad_input: the algorithm does not apply to the view, or there would be too many lines of hatching. Error cancelled: the
  // watch ended the work.
  [[nodiscard]] base::Result<Drawing> at(const Camera& camera, const base::Watch& watch = {}) const;
  // The proof of a drawing as text, which `sightline verify` checks: tools/verify/README.md.
  // Preconditions: the drawing was made by at() for this camera, with ViewOptions::proof.
  [[nodiscard]] std::string certificate(const Camera& camera, const Drawing& drawing) const;
  [[nodiscard]] const std::vector<std::string>& notes() const;

 private:
  class Work;
  explicit Views(std::unique_ptr<const Work> work);
  std::unique_ptr<const Work> work_;
};

// A single view. Errors as those of Views.
[[nodiscard]] base::Result<Drawing> view(const Scene& scene, const Camera& camera, const ViewOptions& options = {});

// The visible pieces of all edges, without a drawing. Precondition: the scene is checked.
// Error bad_input: the algorithm does not apply to the scene or to the view. Error usage: no algorithm has this name.
[[nodiscard]] base::Result<registry::LineView> visible_edges(const scene::PolyScene& scene, const Camera& camera,
                                                             std::string_view algorithm = "exact");

// --- Sheets

// Where a view belongs among others. `free`: an oblique view.
enum class Side : std::uint8_t { front, back, left, right, top, bottom, free };

struct SheetView {
  Camera camera;  // without perspective
  Side side = Side::free;
};

// Several views of one scene on one sheet at one scale, arranged as in third-angle projection (the view from above lies above that from
// the front) or in first-angle projection (it lies below), ISO 5456-2. Views in one row or column are aligned.
class SheetLayout {
 public:
  // The views together fill the field, `gap` units apart, unless it has a scale. 
  SheetLayout(const scene::PolyScene& scene, std::span<const SheetView> views, const picture::DrawingField& field, bool first_angle,
              double gap = 10);

  // With the scale of the sheet, for ViewOptions::field.
  [[nodiscard]] const picture::DrawingField& field() const { return field_; }
  // All drawings on one sheet as large as the field. They are made with field(), in the order of the views. Their strokes are moved to
  // their places.
  [[nodiscard]] picture::VectorDrawing sheet(std::span<Drawing> drawings) const;

 private:
  picture::DrawingField field_;
  // Of each view: where the middle of the scene lies in its image, and on the sheet.
  std::vector<std::array<double, 2>> in_image_;
  std::vector<std::array<double, 2>> on_sheet_;
};

// --- Strokes

// Drawing::strokes as text: one JSON object per line. Ends are moved by `margin` to the right and up and rounded to a
// millionth.
[[nodiscard]] std::string json_lines(const Drawing& drawing, double margin = 0);

// --- Files

enum class Format : std::uint8_t { svg, png, hpgl, pdf, dxf, steps };
// "svg", "png", "plt" or "hpgl", "pdf", "dxf", "steps", in lower or upper case; nullopt for anything else.
[[nodiscard]] std::optional<Format> format_named(std::string_view ending);

struct WriteOptions {
  Format format = Format::svg;
  std::string title = {};
  picture::Paper paper = {};      // millimetres; for all formats; for PNG only with `sheet`
  picture::ImageSize image = {};  // PNG: pixels
  bool sheet = false;             // PNG: draw the paper with its margin instead of only the drawing
  bool as_found = false;          // keep the lines' order; otherwise it is optimized for a pen (picture/pen_order.hpp)
  double min_gap = 0;             // mm: shorter gaps between lines are closed
  picture::HpglOptions plotter = {};
};

// What plotting the drawing takes.
struct PenPlot {
  double down = 0;  // mm drawn
  double up = 0;    // mm travelled with the pen up
  std::size_t lifts = 0;
  std::size_t pens = 0;
  std::string_view plotter;
  double seconds = 0;
};

struct Written {
  std::string bytes;                // of the file
  std::vector<std::string> layers;  // layers with lines, in the order of the pens
  std::optional<PenPlot> plot;      // for all formats except PNG
  std::vector<std::string> notes;
};

// Error io: a PNG of this size is impossible.
[[nodiscard]] base::Result<Written> write(const picture::VectorDrawing& drawing, const WriteOptions& options = {});

}  // namespace sightline::hidden_lines
