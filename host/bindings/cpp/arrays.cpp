// See arrays.hpp.
#include "host/bindings/cpp/arrays.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

#include "host/base/threads.hpp"
#include "host/hidden_lines/aim.hpp"
#include "host/picture/camera_view.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline {

namespace bindings {
namespace {

base::Error wrong(std::string_view member, std::string found, std::string expected) {
  return {.file = std::string(member), .found = "found " + std::move(found), .expected = std::move(expected), .kind = base::ErrorKind::usage};
}

std::optional<base::Error> fault_of_jobs(unsigned jobs) {
  constexpr unsigned most = 1024;
  if (jobs >= 1 && jobs <= most) return std::nullopt;
  return wrong("jobs", fmt::format("{}", jobs), fmt::format("1 to {}", most));
}

base::Result<hidden_lines::LoadOptions> load_options(const LoadOptions& options, const base::Watch& watch) {
  if (!(options.weld >= 0) || !std::isfinite(options.weld)) return wrong("weld", fmt::format("{}", options.weld), "a finite number, at least 0");
  if (options.planar_tolerance && (!(*options.planar_tolerance >= 0) || !std::isfinite(*options.planar_tolerance)))
    return wrong("planar_tolerance", fmt::format("{}", *options.planar_tolerance), "a finite number, at least 0");
  if (!options.mend && (options.weld > 0 || options.planar_tolerance)) return wrong("mend", "false with weld or planar_tolerance", "true");
  if (options.eye)
    for (const double c : *options.eye)
      if (!std::isfinite(c)) return wrong("eye", fmt::format("{}", c), "a finite number");
  if (auto error = fault_of_jobs(options.jobs)) return std::move(*error);
  hidden_lines::LoadOptions result;
  result.jobs = base::useful_threads(options.jobs);
  result.mend = options.mend;
  result.weld = options.weld;
  result.planar_tolerance = options.planar_tolerance;
  result.eye = options.eye;
  result.watch = watch;
  return result;
}

// Reads the rings of a mesh one after the other.
class Rings {
 public:
  explicit Rings(const Mesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] scene::Ring next() {
    const std::uint32_t size = mesh_.ring_sizes[ring_++];
    const auto begin = mesh_.corners.begin() + static_cast<std::ptrdiff_t>(corner_);
    corner_ += size;
    return {begin, begin + static_cast<std::ptrdiff_t>(size)};
  }

 private:
  const Mesh& mesh_;
  std::size_t ring_ = 0;
  std::size_t corner_ = 0;
};

std::uint64_t sum_of(const std::vector<std::uint32_t>& sizes) {
  std::uint64_t sum = 0;
  for (const std::uint32_t size : sizes) sum += size;
  return sum;
}

std::optional<base::Error> fault_of(const Mesh& mesh) {
  const auto fault = [&mesh](std::string place, std::string found, std::string expected) {
    return base::Error{mesh.name, std::move(place), "found " + std::move(found), std::move(expected)};
  };
  constexpr std::size_t most = 0x7ffffffe;
  if (mesh.vertices.size() > most || mesh.corners.size() > most)
    return fault("", fmt::format("{} vertices and {} corners", mesh.vertices.size(), mesh.corners.size()), fmt::format("at most {} of each", most));
  if (const std::uint64_t sum = sum_of(mesh.ring_sizes); sum != mesh.corners.size())
    return fault("ring_sizes", fmt::format("sizes with the sum {}", sum), fmt::format("{}, the number of corners", mesh.corners.size()));
  if (const std::uint64_t sum = sum_of(mesh.face_rings); !mesh.face_rings.empty() && sum != mesh.ring_sizes.size())
    return fault("face_rings", fmt::format("numbers with the sum {}", sum), fmt::format("{}, the number of rings", mesh.ring_sizes.size()));
  if (const std::uint64_t sum = sum_of(mesh.line_sizes); sum != mesh.line_points.size())
    return fault("line_sizes", fmt::format("sizes with the sum {}", sum), fmt::format("{}, the number of line_points", mesh.line_points.size()));
  const std::size_t faces = mesh.face_rings.empty() ? mesh.ring_sizes.size() : mesh.face_rings.size();
  if (!mesh.bodies.empty() && mesh.bodies.size() != faces)
    return fault("bodies", fmt::format("{} numbers", mesh.bodies.size()), fmt::format("{}, one for each face", faces));
  for (std::size_t i = 0; i < faces && !mesh.bodies.empty(); ++i)
    if (mesh.bodies[i] >= faces)
      return fault(fmt::format("bodies[{}]", i), fmt::format("{}", mesh.bodies[i]), fmt::format("a number below {}, the number of faces", faces));
  const auto at_least = [&](std::string_view name, const std::vector<std::uint32_t>& sizes, std::uint32_t least) -> std::optional<base::Error> {
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (sizes[i] < least) return fault(fmt::format("{}[{}]", name, i), fmt::format("{}", sizes[i]), fmt::format("at least {}", least));
    return std::nullopt;
  };
  if (auto found = at_least("ring_sizes", mesh.ring_sizes, 3)) return found;
  if (auto found = at_least("face_rings", mesh.face_rings, 1)) return found;
  if (auto found = at_least("line_sizes", mesh.line_sizes, 2)) return found;
  const auto in_range = [&](std::string_view name, const std::vector<std::uint32_t>& numbers) -> std::optional<base::Error> {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i] >= mesh.vertices.size())
        return fault(fmt::format("{}[{}]", name, i), fmt::format("vertex {}", numbers[i]), fmt::format("a number below {}", mesh.vertices.size()));
    return std::nullopt;
  };
  if (auto found = in_range("corners", mesh.corners)) return found;
  return in_range("line_points", mesh.line_points);
}

scene::PolyMesh poly_mesh(const Mesh& mesh) {
  scene::PolyMesh result;
  result.source = mesh.name;
  result.name = mesh.name;
  result.vertices = mesh.vertices;
  result.grouped = !mesh.bodies.empty();
  const std::size_t faces = mesh.face_rings.empty() ? mesh.ring_sizes.size() : mesh.face_rings.size();
  const std::size_t bodies = mesh.bodies.empty() ? (faces > 0 ? 1 : 0) : *std::max_element(mesh.bodies.begin(), mesh.bodies.end()) + std::size_t{1};
  result.bodies.resize(bodies);
  Rings rings(mesh);
  for (std::size_t f = 0; f < faces; ++f) {
    scene::PolyFace& face = result.bodies[mesh.bodies.empty() ? 0 : mesh.bodies[f]].faces.emplace_back();
    face.outline = rings.next();
    for (std::uint32_t hole = 1; !mesh.face_rings.empty() && hole < mesh.face_rings[f]; ++hole) face.holes.push_back(rings.next());
  }
  // A PolyMesh has them in the order of the bodies.
  result.face_in_file.resize(mesh.bodies.size());
  std::iota(result.face_in_file.begin(), result.face_in_file.end(), 0U);
  std::stable_sort(result.face_in_file.begin(), result.face_in_file.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return mesh.bodies[a] < mesh.bodies[b]; });
  std::size_t point = 0;
  for (const std::uint32_t size : mesh.line_sizes) {
    for (std::size_t i = 1; i < size; ++i) result.wires.push_back({mesh.line_points[point + i - 1], mesh.line_points[point + i]});
    point += size;
  }
  return result;
}

hidden_lines::Aim aim_of(const Camera& camera) {
  return {.view = camera.view, .perspective = camera.perspective, .direction = camera.direction, .eye = camera.eye,
          .look_at = camera.look_at, .up = camera.up, .vertical = camera.vertical};
}

Kind kind_of(std::string_view name) {
  for (std::size_t k = 0; k < picture::edge_kind_count; ++k)
    if (picture::edge_kind_names[k] == name) return static_cast<Kind>(k);
  return Kind::flat;
}

// Options of the command are no remedy here.
base::Result<hidden_lines::Scene> of_library(base::Result<hidden_lines::Scene> loaded) {
  if (!loaded && loaded.error().remedy.starts_with("--")) loaded.error().remedy.clear();
  return loaded;
}

std::optional<std::string> note_of_eye(const Point& given, const Point& used, double step) {
  double shift = 0;
  for (std::size_t a = 0; a < 3; ++a) shift = std::max(shift, std::abs(given[a] - used[a]));
  if (shift < step * 1e-6) return std::nullopt;
  return fmt::format("eye: rounded from {},{},{} to {},{},{}, the grid of the scene, which has steps of {}; give the eye when the scene is made, too",
                     given[0], given[1], given[2], used[0], used[1], used[2], step);
}

Fraction fraction_of(const geometry::Rational& value) { return {value.numerator(), value.denominator()}; }

}  // namespace

base::Result<hidden_lines::Scene> load(const std::string& path, const LoadOptions& options, const base::Watch& watch) {
  const auto checked = load_options(options, watch);
  if (!checked) return checked.error();
  return of_library(hidden_lines::load(path, *checked));
}

base::Result<hidden_lines::Scene> load(const Mesh& mesh, const LoadOptions& options, const base::Watch& watch) {
  const auto checked = load_options(options, watch);
  if (!checked) return checked.error();
  if (auto fault = fault_of(mesh)) return std::move(*fault);
  return of_library(hidden_lines::load(poly_mesh(mesh), *checked));
}

base::Result<hidden_lines::ViewOptions> view_options(const DrawOptions& options, const hidden_lines::Scene& scene) {
  const auto positive = [](double value) { return value > 0 && value <= 1e9; };
  constexpr std::string_view expected = "a number above 0, at most 1e9";
  if (!positive(options.width)) return wrong("width", fmt::format("{}", options.width), std::string(expected));
  if (!positive(options.height)) return wrong("height", fmt::format("{}", options.height), std::string(expected));
  if (options.scale && !positive(*options.scale)) return wrong("scale", fmt::format("{}", *options.scale), std::string(expected));
  if (options.field && !(*options.field > 0 && *options.field <= 170))
    return wrong("field", fmt::format("{}", *options.field), "degrees above 0, at most 170");
  if (!(options.min_length >= 0) || !std::isfinite(options.min_length))
    return wrong("min_length", fmt::format("{}", options.min_length), "a finite number, at least 0");
  if (auto error = fault_of_jobs(options.jobs)) return std::move(*error);
  hidden_lines::ViewOptions result;
  result.edges = {.kinds = options.edges, .crease = options.crease};
  if (auto checked = hidden_lines::check(result.edges); !checked) return std::move(checked.error());
  result.hidden = options.hidden;
  result.field.width = options.width;
  result.field.height = options.height;
  result.field.extent = options.field;
  if (options.scale) result.field.scale = *options.scale * scene.scene.step;
  result.field.min_length = options.min_length;
  result.strokes = true;
  result.proof = options.certificate;
  result.jobs = base::useful_threads(options.jobs);
  return result;
}

base::Result<Drawing> draw(const hidden_lines::Scene& scene, const hidden_lines::Views& views, const Camera& camera, const DrawOptions& options,
                           const base::Watch& watch) {
  const auto aimed = hidden_lines::aimed_camera(aim_of(camera), scene.scene);
  if (!aimed) {
    base::Error error = aimed.error();
    if (error.file == "eye" && error.expected.starts_with("a point between")) error.remedy = "give the eye when the scene is made, too";
    return error;
  }
  if (options.scale && aimed->camera.perspective) return wrong("scale", "in perspective", "parallel projection");
  if (options.field && !aimed->camera.perspective) return wrong("field", "in parallel projection", "perspective, or scale");
  if (auto error = scene::eye_error(scene.scene, aimed->camera)) {
    error->file = scene.name;
    return std::move(*error);
  }
  auto drawn = views.at(aimed->camera, watch);
  if (!drawn) return std::move(drawn.error());
  Drawing result;
  result.lines.reserve(drawn->strokes.size());
  for (const hidden_lines::Stroke& stroke : drawn->strokes) {
    const hidden_lines::DrawnLayer& layer = drawn->layers[stroke.layer];
    result.lines.push_back({stroke.from, stroke.to, kind_of(layer.kind), layer.hidden, stroke.first_edge, stroke.edge_count});
  }
  result.parts.reserve(drawn->parts.size());
  for (const hidden_lines::DrawnPart& part : drawn->parts)
    result.parts.push_back({part.edge, fraction_of(part.low), fraction_of(part.high), part.hidden, part.hidden_by});
  result.edges.reserve(drawn->edges_drawn.size());
  for (const hidden_lines::DrawnEdge& edge : drawn->edges_drawn)
    result.edges.push_back({kind_of(edge.kind), edge.ends, edge.vertices, edge.first_face, edge.face_count, edge.body});
  result.line_edges = std::move(drawn->stroke_edges);
  result.faces = std::move(drawn->edge_faces);
  const picture::CameraView view(aimed->camera);
  // In parallel projection the image is in steps of the grid.
  const double unit = aimed->camera.perspective ? 1 : scene.scene.step;
  result.perspective = aimed->camera.perspective;
  result.eye = scene::file_point(scene.scene, aimed->camera.eye);
  for (std::size_t a = 0; a < 3; ++a) result.axes[a] = view.axis(a);
  const picture::DrawingField field = {.width = options.width, .height = options.height, .extent = {},
                                       .scale = options.scale ? std::optional(*options.scale * scene.scene.step) : std::nullopt};
  result.scale = drawn->window.units(field) / unit;
  result.low = {drawn->window.low[0] * unit, drawn->window.low[1] * unit};
  result.camera_error = aimed->error;
  result.notes = views.notes();
  if (options.certificate) result.certificate = views.certificate(aimed->camera, *drawn);
  result.width = drawn->picture.width;
  result.height = drawn->picture.height;
  if (camera.eye)
    if (auto note = note_of_eye(*camera.eye, result.eye, scene.scene.step)) result.notes.push_back(std::move(*note));
  result.picture = std::make_shared<const Drawing::Picture>(Drawing::Picture{std::move(drawn->picture), result.width, result.height});
  return result;
}

std::vector<std::string> notes_of(const hidden_lines::Scene& scene) { return hidden_lines::notes_of(scene.report); }

base::Result<std::string> file_of(const Drawing& drawing, const FileOptions& options) {
  const auto format = hidden_lines::format_named(options.format);
  if (!format) return wrong("format", fmt::format("\"{}\"", options.format), "svg, pdf, dxf, hpgl, png or steps");
  if (!(options.margin >= 0) || options.margin > 1e6) return wrong("margin", fmt::format("{}", options.margin), "0 to 1e6");
  if (!(options.pen > 0) || options.pen > 100) return wrong("pen", fmt::format("{}", options.pen), "a width above 0, at most 100");
  if (!(options.dpi >= 1) || options.dpi > 2400) return wrong("dpi", fmt::format("{}", options.dpi), "1 to 2400");
  if (drawing.picture == nullptr) return wrong("drawing", "one without a picture", "one that Scene::draw has made");
  hidden_lines::WriteOptions write{.format = *format};
  write.title = options.title;
  write.paper = {drawing.picture->width + 2 * options.margin, drawing.picture->height + 2 * options.margin, options.margin, options.pen};
  write.image.unit = options.dpi / 25.4;
  const auto pixels = [&](double size) { return static_cast<int>(std::lround(std::min(size * write.image.unit, 1e6))); };
  write.image.width = pixels(write.paper.width);
  write.image.height = pixels(write.paper.height);
  write.image.pen = options.pen * write.image.unit;
  write.sheet = true;
  write.as_found = options.as_found;
  auto written = hidden_lines::write(drawing.picture->drawing, write);
  if (!written) return std::move(written.error());
  return std::move(written->bytes);
}

}  // namespace bindings
}  // namespace sightline
