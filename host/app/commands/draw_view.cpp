// See draw_view.hpp.
#include "host/app/commands/draw_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "host/app/command_line.hpp"
#include "host/picture/hatching.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/model/edge_table.hpp"

namespace sightline::app {

namespace {

using picture::EdgeKind;
using picture::LineLayer;
using picture::LinePicture;
using picture::LinePiece;

// Layers of one kind each.
std::vector<LineLayer> layers_by_kind(const LinePicture& drawn, const picture::ChosenEdges& chosen) {
  std::vector<LineLayer> layers;
  for (const std::string_view name : picture::edge_kind_names) layers.push_back({std::string(name), {}});
  std::size_t edge = 0;
  for (const LinePiece& piece : drawn.pieces) {
    while (chosen.edges[edge] < piece.edge) ++edge;
    layers[static_cast<std::size_t>(chosen.kinds[edge])].picture.pieces.push_back(piece);
  }
  const auto wires = layers.begin() + static_cast<std::ptrdiff_t>(EdgeKind::wire);
  if (wires->picture.pieces.empty()) layers.erase(wires);
  return layers;
}

// Pens that are easily distinguished on white paper.
constexpr std::array<picture::Colour, 8> body_colours{picture::Colour{0, 0, 0}, {200, 0, 0},   {0, 0, 200},   {0, 130, 0},
                                                      {200, 100, 0},            {130, 0, 130}, {0, 130, 130}, {110, 110, 110}};

// A layer for each body, and one for wires. An edge of several is the first one's, and so is a line in which two cross.
std::vector<LineLayer> layers_by_body(const LinePicture& drawn, const scene::PolyScene& scene) {
  std::vector<LineLayer> layers;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::string& name = scene.bodies[b].name;
    layers.push_back({name.empty() ? fmt::format("body {}", b + 1) : name, {}, body_colours[b % body_colours.size()]});
  }
  if (!scene.wires.empty()) layers.push_back({"wires", {}, body_colours[scene.bodies.size() % body_colours.size()]});
  const std::vector<std::uint32_t> firsts = scene::first_face_numbers(scene);
  const auto body_of = [&firsts](std::uint32_t face) {
    return static_cast<std::size_t>(std::upper_bound(firsts.begin(), firsts.end(), face + 1) - firsts.begin()) - 1;
  };
  const scene::EdgeTable edges(scene);
  std::size_t edge = 0;
  std::size_t crossing = 0;
  for (const LinePiece& piece : drawn.pieces) {
    while (edge < edges.size() && picture::LineEdge{edges[edge].low, edges[edge].high} < piece.edge) ++edge;
    if (edge < edges.size() && picture::LineEdge{edges[edge].low, edges[edge].high} == piece.edge) {
      const auto uses = edges.uses(edge);
      layers[uses.empty() ? scene.bodies.size() : body_of(uses.front().face)].picture.pieces.push_back(piece);
      continue;
    }
    while (crossing < scene.crossings.size() && scene.crossings[crossing].from < piece.edge.from) ++crossing;
    if (crossing < scene.crossings.size()) layers[body_of(scene.crossings[crossing].face_a)].picture.pieces.push_back(piece);
  }
  return layers;
}

std::array<double, 3> length_one(const scene::PolyPoint& p) {
  const double size = std::sqrt(double(p[0]) * p[0] + double(p[1]) * p[1] + double(p[2]) * p[2]);
  return {p[0] / size, p[1] / size, p[2] / size};
}

// From above left, behind the eye.
std::array<double, 3> usual_light(const scene::PolyCamera& camera) {
  const auto right = length_one(camera.right);
  const auto up = length_one(camera.up);
  const auto forward = length_one(camera.forward);
  std::array<double, 3> light{};
  for (std::size_t a = 0; a < 3; ++a) light[a] = -0.5 * right[a] + 0.7 * up[a] - 0.5 * forward[a];
  return light;
}

}  // namespace

class LineViews::Work {
 public:
  Work(const registry::LineAlgorithm& algorithm, const scene::LoadedScene& source, const LineViewOptions& options)
      : algorithm_(algorithm), source_(source), options_(options) {
    const bool mesh = !source.scene.surfaces.empty();
    const bool crossing = find_crossings();
    if (crossing) own_scene_ = scene::with_crossings(source.scene);
    seams_ = !mesh && !options.edges.are_given();
    if (seams_ && has_lines_apart()) {
      chooser_.emplace(scene(), *picture::edge_choice_named("all"));
    } else if (!seams_) {
      if (const auto choice = edge_choice_of(options.edges, scene())) chooser_.emplace(scene(), *choice);
    }
    if (const auto reason = algorithm.why_not(scene()))
      throw Failure(ExitCode::usage, fmt::format("{}: {} does not apply: {}", source.name, algorithm.name, *reason));
    prepared_ = source.decomposition && algorithm.prepare_cells != nullptr
                    ? algorithm.prepare_cells(source.decomposition->complex)
                    : prepared(scene());
  }

  DrawnView at(const scene::PolyCamera& camera, const picture::DrawingField& field) {
    if (const auto reason = algorithm_.why_not_seen(source_.scene, camera)) {
      throw Failure(ExitCode::bad_input, fmt::format("{}: camera: {} does not apply to this view: {}",
                                                     source_.name, algorithm_.name, *reason));
    }
    DrawnView result;
    LinePicture whole = options_.hidden ? whole_edges() : LinePicture();
    std::vector<LineLayer> layers;
    if (chooser_) {
      const picture::ChosenEdges chosen = chooser_->at(camera);
      result.view = value_of(view_of(prepared_, camera, chosen), source_.name);
      result.edges = chosen.edges.size();
      result.by_kind = chosen.counts();
      whole = picture::only(whole, chosen);
      LinePicture drawn = result.view.picture;
      if (seams_) {
        drawn = without_seams(drawn, chosen, camera);
        whole = without_seams(whole, chosen, camera);
      }
      layers = options_.layers == "body"                                   ? layers_by_body(drawn, scene())
               : options_.layers == "kind" && (!seams_ || has_lines_apart()) ? seams_ ? apart(drawn, chosen) : layers_by_kind(drawn, chosen)
                                                                           : std::vector<LineLayer>{{"visible", drawn}};
    } else {
      result.view = value_of(prepared_.view(camera), source_.name);
      LinePicture drawn = seams_ ? picture::without_seams(result.view.picture, scene(), camera) : result.view.picture;
      if (seams_) whole = picture::without_seams(whole, scene(), camera);
      if (options_.layers == "body") {
        layers = layers_by_body(drawn, scene());
      } else {
        layers.push_back({"visible", std::move(drawn)});
      }
    }
    for (const LineLayer& layer : layers) result.pieces += layer.picture.pieces.size();
    result.visible_length = picture::image_length(result.view.picture, scene(), camera);
    const LinePicture* const edges = options_.hidden ? &whole : nullptr;
    if (!options_.hatch) {
      result.drawing = picture::line_drawing(layers, scene(), camera, field, edges);
    } else {
      add_hatching(camera, field, std::move(layers), edges, result);
    }
    return result;
  }

 private:
  [[nodiscard]] const scene::PolyScene& scene() const { return own_scene_ ? *own_scene_ : source_.scene; }
  [[nodiscard]] registry::PreparedScene prepared(const scene::PolyScene& of) const {
    return value_of(options_.jobs > 1 ? algorithm_.prepare_threads(of, options_.jobs) : algorithm_.prepare(of), source_.name);
  }
  // Lines that are no sides of faces: what bodies pass through each other in, and wires.
  [[nodiscard]] bool has_lines_apart() const { return !scene().crossings.empty() || !scene().wires.empty(); }

  // Whether there are lines in which bodies pass through each other, and they are drawn; if not drawn, a warning.
  [[nodiscard]] bool find_crossings() const {
    if (source_.kind != scene::SceneKind::polyhedra) return false;
    const auto crossings = scene::crossings_of(source_.scene, 1);
    if (crossings.empty() || algorithm_.draws_crossings) return !crossings.empty();
    warn(fmt::format("{}: bodies pass through each other, the first at faces {} and {} of the file; `sightline draw exact` draws "
                     "the lines between them",
                     source_.name, crossings[0].face_a, crossings[0].face_b));
    return false;
  }

  [[nodiscard]] LinePicture whole_edges() const {
    LinePicture whole = picture::wire_frame(scene());
    for (const scene::PolyCrossing& crossing : scene().crossings) whole.pieces.push_back({{crossing.from, crossing.to}, 0, 1});
    return whole;
  }

  // Seams are between faces; lines apart are none.
  [[nodiscard]] LinePicture without_seams(const LinePicture& picture, const picture::ChosenEdges& chosen,
                                          const scene::PolyCamera& camera) const {
    const std::vector<LineLayer> layers = apart(picture, chosen);
    LinePicture result = picture::without_seams(layers[0].picture, scene(), camera);
    for (std::size_t layer = 1; layer < layers.size(); ++layer) {
      const std::size_t before = result.pieces.size();
      const auto& more = layers[layer].picture.pieces;
      result.pieces.insert(result.pieces.end(), more.begin(), more.end());
      std::inplace_merge(result.pieces.begin(), result.pieces.begin() + static_cast<std::ptrdiff_t>(before), result.pieces.end(),
                         [](const LinePiece& a, const LinePiece& b) { return a.edge < b.edge; });
    }
    return result;
  }

  // Sides of faces and lines apart as layers.
  [[nodiscard]] std::vector<LineLayer> apart(const LinePicture& picture, const picture::ChosenEdges& chosen) const {
    std::vector<LineLayer> layers{{"visible", {}}};
    if (!scene().crossings.empty()) layers.push_back({"intersection", {}});
    if (!scene().wires.empty()) layers.push_back({"wire", {}});
    std::size_t edge = 0;
    for (const LinePiece& piece : picture.pieces) {
      while (chosen.edges[edge] < piece.edge) ++edge;
      const EdgeKind kind = chosen.kinds[edge];
      const std::size_t layer = kind == EdgeKind::wire ? layers.size() - 1 : kind == EdgeKind::intersection ? 1 : 0;
      layers[layer].picture.pieces.push_back(piece);
    }
    return layers;
  }

  void add_hatching(const scene::PolyCamera& camera, const picture::DrawingField& field, std::vector<LineLayer> layers,
                    const LinePicture* edges, DrawnView& result) const {
    const picture::ImageWindow window = picture::drawing_window(layers, scene(), camera, field, edges);
    const double units = field.width / (window.high[0] - window.low[0]);
    const picture::HatchOptions wanted{options_.hatch->angle, options_.hatch->spacing,
                                       options_.hatch->light.value_or(usual_light(camera))};
    const picture::Hatching hatching = value_of(picture::hatched(scene(), camera, window, units, wanted), "--hatch");
    const registry::PreparedScene lines = prepared(hatching.scene);
    const registry::LineView seen = value_of(view_of(lines, camera, hatching.lines), source_.name);
    LineLayer along{"hatching", {}};
    LineLayer across{"cross-hatching", {}};
    std::size_t line = 0;
    for (const LinePiece& piece : seen.picture.pieces) {
      while (hatching.lines.edges[line] < piece.edge) ++line;
      (hatching.across[line] != 0 ? across : along).picture.pieces.push_back(piece);
    }
    result.hatch_lines = hatching.lines.edges.size();
    result.hatch_pieces = seen.picture.pieces.size();
    layers.push_back(std::move(along));
    layers.push_back(std::move(across));
    result.drawing = picture::line_drawing(layers, hatching.scene, camera, field, window, edges);
  }

  const registry::LineAlgorithm& algorithm_;
  const scene::LoadedScene& source_;
  LineViewOptions options_;
  std::optional<scene::PolyScene> own_scene_;  // with crossings
  bool seams_ = false;                         // are left out: of a scene that is no mesh, and of which nothing is asked
  std::optional<picture::EdgeChooser> chooser_;
  registry::PreparedScene prepared_;
};

LineViews::LineViews(const registry::LineAlgorithm& algorithm, const scene::LoadedScene& source, const LineViewOptions& options)
    : work_(std::make_unique<Work>(algorithm, source, options)) {}

LineViews::~LineViews() = default;

DrawnView LineViews::at(const scene::PolyCamera& camera, const picture::DrawingField& field) {
  return work_->at(camera, field);
}

}  // namespace sightline::app
