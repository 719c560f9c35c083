// See draw_view.hpp.
#include "host/app/commands/draw_view.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "host/app/command_line.hpp"
#include "host/base/json.hpp"
#include "host/picture/hatching.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/picture/line_union.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/model/face_cut.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline::app {

namespace {

using picture::EdgeKind;
using picture::LineLayer;
using picture::LinePicture;
using picture::LinePiece;

// Pens that are easily distinguished on white paper.
constexpr std::array<picture::Colour, 8> body_colours{picture::Colour{0, 0, 0}, {200, 0, 0},   {0, 0, 200},   {0, 130, 0},
                                                      {200, 100, 0},            {130, 0, 130}, {0, 130, 130}, {110, 110, 110}};

// The body of an edge. An edge of several is the first one's, and so is a line in which two cross; that of a wire is the number
// of bodies.
class BodyOfEdge {
 public:
  explicit BodyOfEdge(const scene::PolyScene& scene) : scene_(scene), firsts_(scene::first_face_numbers(scene)), edges_(scene) {}

  [[nodiscard]] std::size_t operator()(const picture::LineEdge& edge) const {
    const std::size_t number = edges_.find(edge.from, edge.to);
    if (number == edges_.size()) return body_of(scene::crossing_at(scene_, edge.from)->face_a);
    const auto uses = edges_.uses(number);
    return uses.empty() ? scene_.bodies.size() : body_of(uses.front().face);
  }

 private:
  [[nodiscard]] std::size_t body_of(std::uint32_t face) const {
    return static_cast<std::size_t>(std::upper_bound(firsts_.begin(), firsts_.end(), face + 1) - firsts_.begin()) - 1;
  }

  const scene::PolyScene& scene_;
  std::vector<std::uint32_t> firsts_;
  scene::EdgeTable edges_;
};

// Edges as text knows them: by their ends in the unit of the file and with their faces. The ends of crossings are on no grid.
class EdgesInFile {
 public:
  explicit EdgesInFile(const scene::PolyScene& scene) : scene_(scene), edges_(scene) {}

  // Members "edges" and "faces".
  void add(std::span<const picture::LineEdge> edges, base::Json& line) const {
    base::Json ends = base::Json::array();
    std::set<std::uint32_t> faces;
    for (const picture::LineEdge& edge : edges) {
      ends.push_back(base::Json::array({place_in_file(edge.from), place_in_file(edge.to)}));
      if (const scene::PolyCrossing* const crossing = scene::crossing_at(scene_, edge.from)) {
        faces.insert({crossing->face_a + 1, crossing->face_b + 1});
      } else {
        for (const scene::EdgeTable::Use& use : edges_.uses(edges_.find(edge.from, edge.to))) faces.insert(use.face + 1);
      }
    }
    line["edges"] = ends;
    line["faces"] = faces;
  }

 private:
  [[nodiscard]] std::array<double, 3> place_in_file(scene::VertexIndex vertex) const {
    if (scene::crossing_at(scene_, vertex) == nullptr) return scene::file_point(scene_, scene_.vertices[vertex]);
    std::array<double, 3> place = scene::place_of(scene_, vertex);
    for (std::size_t a = 0; a < 3; ++a) place[a] = (place[a] + static_cast<double>(scene_.origin[a])) * scene_.step;
    return place;
  }

  const scene::PolyScene& scene_;
  scene::EdgeTable edges_;
};

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
  Work(const registry::LineAlgorithm& algorithm, const scene::LoadedScene& source, const LineViewOptions& options,
       const compare::MatterScene* matter)
      : algorithm_(algorithm), source_(source), options_(options), matter_(matter) {
    if (matter_ == nullptr) choose_edges();
    if (const auto reason = algorithm.why_not(scene()))
      throw base::usage_error(fmt::format("{}: {} does not apply: {}", source.name, algorithm.name, *reason));
    prepared_ = source.decomposition && algorithm.prepare_cells != nullptr
                    ? algorithm.prepare_cells(source.decomposition->complex)
                    : prepared(scene());
  }

  DrawnView at(const scene::PolyCamera& camera, const picture::DrawingField& field) {
    if (const auto reason = algorithm_.why_not_seen(source_.scene, camera)) {
      throw base::bad_input(fmt::format("{}: camera: {} does not apply to this view: {}",
                                                     source_.name, algorithm_.name, *reason));
    }
    DrawnView result;
    std::optional<picture::ChosenEdges> chosen;
    if (matter_ != nullptr) chosen = matter_->lines_at(camera.eye);
    else if (chooser_) chosen = chooser_->at(camera);
    result.view = value_of(chosen ? view_of(prepared_, camera, *chosen) : prepared_.view(camera), source_.name);
    if (chosen && (chosen_by_user_ || matter_ != nullptr)) {
      result.edges = chosen->edges.size();
      result.by_kind = chosen->counts();
    }
    result.visible_length = picture::image_length(result.view.picture, scene(), camera);
    LinePicture drawn = seams_ ? without_seams(result.view.picture, chosen, camera) : result.view.picture;
    result.pieces = drawn.pieces.size();
    std::vector<LineLayer> layers = divided(drawn, chosen, false);
    std::vector<LineLayer> hidden;
    if (options_.hidden) {
      LinePicture whole = chosen ? picture::only(whole_edges(), *chosen) : whole_edges();
      if (seams_) whole = without_seams(whole, chosen, camera);
      hidden = divided(picture::hidden_pieces(whole, drawn), chosen, true);
    }
    if (!options_.hatch) {
      add_all(layers, hidden);
      draw(layers, scene(), camera, field, std::nullopt, result);
    } else {
      add_hatching(camera, field, std::move(layers), std::move(hidden), result);
    }
    return result;
  }

 private:
  [[nodiscard]] const scene::PolyScene& scene() const {
    return matter_ != nullptr ? matter_->scene() : own_scene_ ? *own_scene_ : source_.scene;
  }

  void choose_edges() {
    const bool mesh = !source_.scene.surfaces.empty();
    if (find_crossings()) own_scene_ = scene::with_crossings(source_.scene);
    seams_ = !mesh && !options_.edges.are_given();
    if (seams_ && has_lines_apart()) {
      chooser_.emplace(scene(), *picture::edge_choice_named("all"));
    } else if (!seams_) {
      if (const auto choice = edge_choice_of(options_.edges, scene())) chooser_.emplace(scene(), *choice);
    }
    chosen_by_user_ = chooser_.has_value();
    if (options_.strokes_margin && !chooser_) chooser_.emplace(scene(), *picture::edge_choice_named("all"));
  }

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

  // Seams are between faces; lines that are no sides of faces are none.
  [[nodiscard]] LinePicture without_seams(const LinePicture& picture, const std::optional<picture::ChosenEdges>& chosen,
                                          const scene::PolyCamera& camera) const {
    if (!has_lines_apart()) return picture::without_seams(picture, scene(), camera);
    LinePicture sides;
    LinePicture apart;
    std::size_t edge = 0;
    for (const LinePiece& piece : picture.pieces) {
      while (chosen->edges[edge] < piece.edge) ++edge;
      (is_apart(chosen->kinds[edge]) ? apart : sides).pieces.push_back(piece);
    }
    LinePicture result = picture::without_seams(sides, scene(), camera);
    const auto end_of_sides = static_cast<std::ptrdiff_t>(result.pieces.size());
    result.pieces.insert(result.pieces.end(), apart.pieces.begin(), apart.pieces.end());
    std::inplace_merge(result.pieces.begin(), result.pieces.begin() + end_of_sides, result.pieces.end(),
                       [](const LinePiece& a, const LinePiece& b) { return a.edge < b.edge; });
    return result;
  }

  // A picture as layers: by body if that is asked for, and by kind where the kinds are known; of kinds that share a label those
  // before others keep what they have in common. Hidden lines are one layer of a drawing.
  [[nodiscard]] std::vector<LineLayer> divided(const LinePicture& picture, const std::optional<picture::ChosenEdges>& chosen,
                                               bool hidden) const {
    const std::size_t kinds = chosen ? picture::edge_kind_count : 1;
    const bool by_body = options_.layers == "body" && !hidden;
    std::vector<LineLayer> layers;
    const std::size_t bodies = scene().bodies.size();
    for (std::size_t b = 0; b < (by_body ? bodies + (scene().wires.empty() ? 0 : 1) : 1); ++b) {
      for (std::size_t k = 0; k < kinds; ++k) {
        LineLayer layer = hidden ? picture::hidden_layer({}) : LineLayer{"visible", {}};
        if (chosen) layer.kind = picture::edge_kind_names[k];
        if (by_body) {
          const std::string name = b < bodies ? scene().bodies[b].name : "wires";
          layer.label = name.empty() ? fmt::format("body {}", b + 1) : name;
          layer.colour = body_colours[b % body_colours.size()];
        } else if (!hidden && options_.layers == "kind" && chosen_by_user_ && (!seams_ || is_apart(static_cast<EdgeKind>(k)))) {
          layer.label = layer.kind;
        }
        layers.push_back(std::move(layer));
      }
    }
    std::optional<BodyOfEdge> body_of;
    if (by_body) body_of.emplace(scene());
    std::size_t edge = 0;
    for (const LinePiece& piece : picture.pieces) {
      std::size_t layer = by_body ? (*body_of)(piece.edge) * kinds : 0;
      if (chosen) {
        while (chosen->edges[edge] < piece.edge) ++edge;
        layer += static_cast<std::size_t>(chosen->kinds[edge]);
      }
      layers[layer].picture.pieces.push_back(piece);
    }
    if (seams_ && !by_body) {
      // Sides of faces are one layer of the drawing.
      std::stable_partition(layers.begin(), layers.end(), [](const LineLayer& layer) { return layer.label != layer.kind; });
    }
    return layers;
  }

  // Whether an edge of this kind is no side of a face.
  static bool is_apart(EdgeKind kind) { return kind == EdgeKind::intersection || kind == EdgeKind::wire; }

  static void add_all(std::vector<LineLayer>& layers, std::vector<LineLayer>& more) {
    layers.insert(layers.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }

  // Into a window if one is given. The layers' pictures are given up.
  void draw(std::vector<LineLayer>& layers, const scene::PolyScene& of, const scene::PolyCamera& camera,
            const picture::DrawingField& field, const std::optional<picture::ImageWindow>& given, DrawnView& result) const {
    picture::UnitedLines lines = picture::united_lines(layers, of, camera);
    const picture::ImageWindow window = given ? *given : picture::drawing_window(lines, camera, field);
    if (options_.hatch) picture::leave_out_hatching_on_lines(lines, layers, window);
    for (LineLayer& layer : layers) layer.picture = {};
    const std::vector<picture::LineStroke> strokes = picture::strokes_in(lines, layers, window, field);
    result.strokes = strokes.size();
    for (const picture::LineStroke& stroke : strokes)
      result.drawn_length += std::hypot(stroke.to[0] - stroke.from[0], stroke.to[1] - stroke.from[1]);
    result.drawn_length *= window.units(field);
    result.drawing = picture::line_drawing(strokes, layers, window, field);
    if (!options_.strokes_margin) return;
    const EdgesInFile edges(of);
    for (const picture::LineStroke& stroke : strokes) {
      const LineLayer& layer = layers[stroke.layer];
      const auto on_paper = [&](const std::array<double, 2>& end) {
        base::Json point = base::Json::array();
        constexpr double parts = 1e6;  // finer than any file of a drawing
        for (const double c : window.in_field(end, field))
          point.push_back(std::round((c + *options_.strokes_margin) * parts) / parts);
        return point;
      };
      base::Json line{{"from", on_paper(stroke.from)}, {"to", on_paper(stroke.to)}, {"kind", layer.kind}, {"layer", layer.label},
                      {"hidden", layer.hidden}};
      edges.add({lines.sources.data() + stroke.first_source, stroke.source_count}, line);
      result.strokes_text += line.dump() + "\n";
    }
  }

  void add_hatching(const scene::PolyCamera& camera, const picture::DrawingField& field, std::vector<LineLayer> layers,
                    std::vector<LineLayer> hidden, DrawnView& result) const {
    std::vector<LineLayer> edges = layers;
    edges.insert(edges.end(), hidden.begin(), hidden.end());
    const picture::ImageWindow window = picture::drawing_window(picture::united_lines(edges, scene(), camera), camera, field);
    const double units = window.units(field);
    const picture::HatchOptions wanted{options_.hatch->angle, options_.hatch->spacing,
                                       options_.hatch->light.value_or(usual_light(camera))};
    const picture::Hatching hatching = value_of(picture::hatched(scene(), camera, window, units, wanted), "--hatch");
    const registry::PreparedScene lines = prepared(hatching.scene);
    const registry::LineView seen = value_of(view_of(lines, camera, hatching.lines), source_.name);
    LineLayer along{"hatching", {}, {}, std::string(picture::hatching_kind)};
    LineLayer across{"cross-hatching", {}, {}, std::string(picture::cross_hatching_kind)};
    std::size_t line = 0;
    for (const LinePiece& piece : seen.picture.pieces) {
      while (hatching.lines.edges[line] < piece.edge) ++line;
      (hatching.across[line] != 0 ? across : along).picture.pieces.push_back(piece);
    }
    result.hatch_lines = hatching.lines.edges.size();
    result.hatch_pieces = seen.picture.pieces.size();
    layers.push_back(std::move(along));
    layers.push_back(std::move(across));
    add_all(layers, hidden);
    draw(layers, hatching.scene, camera, field, window, result);
  }

  const registry::LineAlgorithm& algorithm_;
  const scene::LoadedScene& source_;
  LineViewOptions options_;
  const compare::MatterScene* matter_;  // null: the edges of faces are drawn
  std::optional<scene::PolyScene> own_scene_;  // with crossings
  bool chosen_by_user_ = false;                // or by the scene; else kinds are known for the list of strokes alone
  bool seams_ = false;                         // are left out: of a scene that is no mesh, and of which nothing is asked
  std::optional<picture::EdgeChooser> chooser_;
  registry::PreparedScene prepared_;
};

LineViews::LineViews(const registry::LineAlgorithm& algorithm, const scene::LoadedScene& source, const LineViewOptions& options,
                     const compare::MatterScene* matter)
    : work_(std::make_unique<Work>(algorithm, source, options, matter)) {}

LineViews::~LineViews() = default;

DrawnView LineViews::at(const scene::PolyCamera& camera, const picture::DrawingField& field) {
  return work_->at(camera, field);
}

}  // namespace sightline::app
