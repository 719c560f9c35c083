// Hidden-line removal: reads a scene of polyhedra, finds what a camera sees of its edges, and makes a drawing and a file of that.
//
//   const auto scene = hidden_lines::load("part.obj");
//   if (!scene) return fail(scene.error().message());
//   const auto drawing = hidden_lines::view(*scene, scene->scene.camera);
//   if (!drawing) return fail(drawing.error().message());
//   const auto file = hidden_lines::write(drawing->picture, {.format = hidden_lines::Format::svg});
//   if (!file) return fail(file.error().message());
//   // file->bytes is the SVG.
//
// What is seen is decided in integers and fractions, without tolerances: a scene is rounded to a grid once, when it is read
// (host/scene/read/poly_import.hpp), and everything after that is exact. Doubles say only where a line lies on the paper.
// The algorithm is `exact` (host/algorithms/exact) unless ViewOptions names another one of host/algorithms/registry/lines.hpp.
//
// Nothing here prints, ends the process or throws. A function that can fail returns a base::Result; the kind of its base::Error says
// whether the input (bad_input), the request (usage) or a file (io) is wrong. `notes` are sentences that a person should read: what was
// changed or left out. Equal input gives equal bytes.
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

#include "host/algorithms/registry/lines.hpp"
#include "host/base/result.hpp"
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

// The polyhedra (`scene`, in steps of its grid; `scene.step` is a step in the unit of the file), the name used in errors, and what was
// changed while reading (`report`).
using Scene = scene::LoadedScene;
// The eye (in steps) and three orthogonal directions of integers; host/scene/model/aim_camera.hpp makes one from any direction.
// `Scene::scene.camera` is the file's own, or one from above, right and in front.
using Camera = scene::PolyCamera;
using LoadOptions = scene::PolyImportOptions;
// Damage of a mesh, such as faces turned the wrong way, is mended.
inline const LoadOptions mending{.mend = true};

// What a name stands for: a built-in scene ("house"), a generated one (FAMILY-SIZE or FAMILY-SIZE-SEED, such as "boxes-100-7"), or the
// path of a file (JSON, OFF, OBJ, STL, PLY, glTF, 3MF; its text says which). Reads the file and nothing else.
// Error usage: a generated scene of an impossible size. Error io: there is no such file, or it cannot be read.
[[nodiscard]] base::Result<scene::SceneFile> find(const std::string& name);

// Reads and checks what was found, or a text (SceneFile::text, its format by SceneFile::name and its first bytes).
// Error bad_input: the first fault, with its place in the file.
[[nodiscard]] base::Result<Scene> load(scene::SceneFile file, const LoadOptions& options = mending);
// The same of a name; errors also as those of find.
[[nodiscard]] base::Result<Scene> load(const std::string& name, const LoadOptions& options = mending);
// Vertices, faces with holes, bodies and lines in memory, in any unit; faces counterclockwise seen from outside.
// Error bad_input: a coordinate that is no finite number, an index without a vertex, or what a file of them is refused for.
[[nodiscard]] base::Result<Scene> load(scene::PolyMesh mesh, const LoadOptions& options = mending);

// What was changed while a scene was read: rounding, and what was mended or passed over.
[[nodiscard]] std::vector<std::string> notes_of(const scene::PolyImportReport& report);

// --- Views

// Which edges are drawn.
struct EdgeOptions {
  // "feature": silhouettes, boundaries, creases, borders of materials, lines in which bodies pass through each other, and lines without
  // faces. "all": also edges between faces in one plane. Or kinds with commas between them: picture::edge_kind_names.
  // Empty: "feature", and of a scene that is no mesh all edges but those across which the visible surface is flat.
  std::string kinds;
  // Degrees by which the faces at a crease bend more. Empty: 30 for a mesh, 0 for all other scenes.
  std::optional<double> crease = {};

  [[nodiscard]] bool are_given() const { return !kinds.empty() || crease.has_value(); }
};

// Error usage: no kind of that name, or no finite number.
[[nodiscard]] base::Result<base::Done> check(const EdgeOptions& options);
// What the options mean for a scene; empty: all edges. They were checked (precondition).
[[nodiscard]] std::optional<picture::EdgeChoice> edge_choice(const EdgeOptions& options, const scene::PolyScene& scene);

struct HatchOptions {
  double angle = 45;   // degrees on the paper, counterclockwise from the horizontal
  double spacing = 1;  // of the densest lines, in the unit of the field
  // Towards the light, in the axes of the file, of any length but 0. Empty: from above left, behind the eye.
  std::optional<std::array<double, 3>> light = {};
};

// How visible lines are divided into layers of the drawing. Hidden lines and hatching are layers of their own.
enum class Layers : std::uint8_t { kind, body, one };

struct ViewOptions {
  std::string algorithm = "exact";  // see registry::line_algorithms
  EdgeOptions edges = {};
  bool hidden = false;  // hidden parts of the edges are drawn, too: dashed
  Layers layers = Layers::kind;
  std::optional<HatchOptions> hatch = {};  // faces are shaded by lines
  // Of a section (scene::section_of): faces of this material are cut, and are hatched 2 units of the field apart.
  std::optional<std::uint32_t> cut_material = {};
  picture::DrawingField field = {};        // the size of the drawing, and how much of the image it shows
  bool strokes = false;                    // Drawing::strokes is filled in
  unsigned jobs = 1;                       // threads for a view, if the algorithm can use more than one; the result is the same
};

// A straight line of a drawing, each stretch of the paper once.
struct Stroke {
  std::array<double, 2> from{};  // in the unit of the field from its bottom left
  std::array<double, 2> to{};
  std::string kind;  // of picture::edge_kind_names or picture::hatching_kinds
  std::string layer;
  bool hidden = false;
  std::vector<std::array<std::array<double, 3>, 2>> edges = {};  // that lie there: both ends, in the unit of the file
  std::vector<std::uint32_t> faces = {};                         // at these edges: numbers in the file from 1, ascending
};

struct Drawing {
  picture::VectorDrawing picture;
  picture::ImageWindow window = {};  // the part of the image that the drawing shows
  // Exact: the visible pieces of the edges chosen, by the numbers of their vertices and fractions of their length; edges across which
  // the surface is flat are still among them.
  picture::LinePicture visible = {};
  std::vector<registry::AlgorithmCount> counts = {};  // what the algorithm did
  std::optional<std::size_t> edges = {};              // how many were chosen; empty: all of the scene
  std::optional<std::array<std::size_t, picture::edge_kind_count>> by_kind = {};
  std::size_t pieces = 0;       // drawn, hatching apart
  double visible_length = 0;    // of `visible`, see picture::image_length
  std::size_t hatch_lines = 0;  // before any was hidden
  std::size_t hatch_pieces = 0;
  std::size_t stroke_count = 0;
  double drawn_length = 0;  // of all strokes, in the unit of the field
  std::vector<Stroke> strokes = {};
  std::vector<std::string> notes = {};  // of hidden_lines::view; Views has its own
};

// Many views of one scene: what they share is made once.
class Views {
 public:
  // `scene` outlives the views. `cameras`: of a scene of cells the real lines of its matter, those of the outer box among them, are drawn
  // if all of these look in perspective from within a cell and no edges are asked for; otherwise, and of every other scene, the edges of
  // its faces.
  // Error usage: an option is wrong (Error::file is its name), or the algorithm does not apply to the scene. Error bad_input: it failed.
  [[nodiscard]] static base::Result<Views> of(const Scene& scene, const ViewOptions& options = {}, std::span<const Camera> cameras = {});
  Views(Views&&) noexcept;
  Views& operator=(Views&&) noexcept;
  ~Views();

  // The eye is in no solid and on no face (precondition, see scene::eye_error).
  // Error bad_input: the algorithm does not apply to the view; there would be too many lines of hatching.
  [[nodiscard]] base::Result<Drawing> at(const Camera& camera) const;
  [[nodiscard]] const std::vector<std::string>& notes() const;

 private:
  class Work;
  explicit Views(std::unique_ptr<const Work> work);
  std::unique_ptr<const Work> work_;
};

// One view; errors as those of Views.
[[nodiscard]] base::Result<Drawing> view(const Scene& scene, const Camera& camera, const ViewOptions& options = {});

// The visible pieces of all edges, without a drawing. The scene is a checked one (precondition).
// Error bad_input: the algorithm does not apply to the scene or to the view. Error usage: no algorithm of that name.
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
  // The views together fill the field, `gap` units apart, unless it has a scale. The scene outlives the layout.
  SheetLayout(const scene::PolyScene& scene, std::span<const SheetView> views, const picture::DrawingField& field, bool first_angle,
              double gap = 10);

  // With the scale of the sheet, for ViewOptions::field.
  [[nodiscard]] const picture::DrawingField& field() const { return field_; }
  // All drawings on one sheet, as large as the field or larger; made with field() of the views in their order. Their strokes are moved to
  // their places.
  [[nodiscard]] picture::VectorDrawing sheet(std::span<Drawing> drawings) const;

 private:
  picture::DrawingField field_;
  // Of each view: where the middle of the scene lies in its image, and on the sheet.
  std::vector<std::array<double, 2>> in_image_;
  std::vector<std::array<double, 2>> on_sheet_;
};

// --- Strokes

// Drawing::strokes as text: a JSON object on a line for each, its ends moved by `margin` to the right and up and rounded to a millionth.
[[nodiscard]] std::string json_lines(std::span<const Stroke> strokes, double margin = 0);

// --- Files

enum class Format : std::uint8_t { svg, png, hpgl, pdf, dxf, steps };
// "svg", "png", "plt" or "hpgl", "pdf", "dxf", "steps", in small or capital letters; empty for anything else.
[[nodiscard]] std::optional<Format> format_named(std::string_view ending);

struct WriteOptions {
  Format format = Format::svg;
  std::string title = {};
  picture::Paper paper = {};      // millimetres; of all formats, of PNG if it is a sheet
  picture::ImageSize image = {};  // PNG: pixels
  bool sheet = false;             // PNG: of the paper with its margin instead of the drawing alone
  bool as_found = false;          // lines stay in their order; otherwise a pen travels little in the air, see picture/pen_order.hpp
  double min_gap = 0;             // mm: shorter gaps between lines are drawn over
  picture::HpglOptions plotter = {};
};

// What the drawing costs a pen.
struct PenPlot {
  double down = 0;  // mm drawn
  double up = 0;    // mm in the air
  std::size_t lifts = 0;
  std::size_t pens = 0;
  std::string_view plotter;
  double seconds = 0;
};

struct Written {
  std::string bytes;                // of the file
  std::vector<std::string> layers;  // those with lines, in the order of the pens
  std::optional<PenPlot> plot;      // of all formats but PNG
  std::vector<std::string> notes;
};

// Error io: a PNG of that size is not possible.
[[nodiscard]] base::Result<Written> write(const picture::VectorDrawing& drawing, const WriteOptions& options = {});

}  // namespace sightline::hidden_lines
