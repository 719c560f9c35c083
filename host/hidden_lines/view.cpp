// Views of a scene and their drawings; see hidden_lines.hpp.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "host/algorithms/oracle/matter_scene.hpp"
#include "host/base/json.hpp"
#include "host/base/threads.hpp"
#include "host/hidden_lines/certificate.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/hidden_lines/origins.hpp"
#include "host/picture/camera_view.hpp"
#include "host/picture/hatching.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/picture/line_union.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::hidden_lines {

namespace {

using algorithms::oracle::MatterScene;
using picture::ChosenEdges;
using picture::EdgeKind;
using picture::LineLayer;
using picture::LinePicture;
using picture::LinePiece;

// Pen colours that are easily distinguished on white paper.
constexpr std::array<picture::Colour, 8> body_colours{picture::Colour{0, 0, 0}, {200, 0, 0},   {0, 0, 200},   {0, 130, 0},
                                                      {200, 100, 0},            {130, 0, 130}, {0, 130, 130}, {110, 110, 110}};

// From above left, behind the eye.
std::array<double, 3> usual_light(const Camera& camera) {
  const picture::CameraView view(camera);
  const auto right = view.axis(0);
  const auto up = view.axis(1);
  const auto forward = view.axis(2);
  std::array<double, 3> light{};
  for (std::size_t a = 0; a < 3; ++a) light[a] = -0.5 * right[a] + 0.7 * up[a] - 0.5 * forward[a];
  return light;
}

// Whether an edge of this kind is no side of a face: a line in which bodies pass through each other, or a wire.
bool is_free_line(EdgeKind kind) { return kind == EdgeKind::intersection || kind == EdgeKind::wire; }

void add_all(std::vector<LineLayer>& layers, std::vector<LineLayer>& more) {
  layers.insert(layers.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

base::Error in_file(base::Error error, const std::string& name) {
  error.file = name;
  return error;
}

base::Result<const registry::LineAlgorithm*> algorithm_named(std::string_view name) {
  if (const registry::LineAlgorithm* const found = registry::find_line_algorithm(name)) return found;
  std::string names;
  for (const registry::LineAlgorithm& each : registry::line_algorithms()) names += (names.empty() ? "" : ", ") + std::string(each.name);
  return base::Error{.file = "algorithm",
                     .found = fmt::format("found \"{}\"", name),
                     .expected = "one of " + names,
                     .kind = base::ErrorKind::usage};
}

base::Result<base::Done> check(const HatchOptions& options) {
  const auto wrong = [](std::string found, std::string expected) {
    return base::Error{.file = "hatch", .found = std::move(found), .expected = std::move(expected), .kind = base::ErrorKind::usage};
  };
  if (!std::isfinite(options.angle)) return wrong(fmt::format("found an angle of {}", options.angle), "a finite number of degrees");
  if (!(options.spacing > 0) || !std::isfinite(options.spacing))
    return wrong(fmt::format("found a spacing of {}", options.spacing), "a finite number above 0");
  if (options.light) {
    const auto& [x, y, z] = *options.light;
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z) || (x == 0 && y == 0 && z == 0))
      return wrong(fmt::format("found light from {},{},{}", x, y, z), "a direction");
  }
  return base::Done{};
}

}  // namespace

base::Result<base::Done> check(const EdgeOptions& options) {
  if (options.crease && !std::isfinite(*options.crease))
    return base::Error{.file = "crease",
                       .found = fmt::format("found {}", *options.crease),
                       .expected = "a finite number of degrees",
                       .kind = base::ErrorKind::usage};
  if (options.kinds.empty() || picture::edge_choice_named(options.kinds)) return base::Done{};
  return base::Error{.file = "edges",
                     .found = fmt::format("found \"{}\"", options.kinds),
                     .expected = "all, feature, or kinds with commas between them: silhouette, boundary, crease, border, intersection, wire",
                     .kind = base::ErrorKind::usage};
}

std::optional<picture::EdgeChoice> edge_choice(const EdgeOptions& options, const scene::PolyScene& scene) {
  if (options.kinds == "all" && scene.crossings.empty() && scene.wires.empty()) return std::nullopt;
  picture::EdgeChoice choice = *picture::edge_choice_named(options.kinds.empty() ? "feature" : options.kinds);
  const bool named = !options.kinds.empty() && options.kinds != "all" && options.kinds != "feature";
  if (scene.materials_are_colours && !named) choice.kinds[static_cast<std::size_t>(EdgeKind::border)] = false;
  choice.crease = options.crease.value_or(scene.surfaces.empty() ? 0 : choice.crease);
  return choice;
}

class Views::Work {
 public:
  Work(const Scene& source, const ViewOptions& options, const registry::LineAlgorithm& algorithm)
      : source_(source), options_(options), algorithm_(algorithm) {}

  base::Result<base::Done> prepare(std::span<const Camera> cameras, const base::Watch& watch) {
    if (auto checked = check(options_.edges); !checked) return checked;
    if (options_.hatch)
      if (auto checked = check(*options_.hatch); !checked) return checked;
    if (options_.proof && algorithm_.name != "exact")
      return base::Error{.file = "proof", .found = fmt::format("found with {}", algorithm_.name), .expected = "exact", .kind = base::ErrorKind::usage};
    if (!watch.go_on(0)) return base::cancelled();
    find_matter(cameras);
    if (!matter_) find_crossings();
    if (const auto reason = algorithm_.why_not(scene()))
      return base::Error{.file = source_.name,
                         .found = fmt::format("{} does not apply: {}", algorithm_.name, *reason),
                         .kind = base::ErrorKind::usage};
    if (!watch.go_on(0.6)) return base::cancelled();
    const bool by_cells = source_.decomposition && algorithm_.prepare_cells != nullptr;
    const std::optional<picture::EdgeChoice> choice = matter_ ? std::nullopt : choose_edges();
    std::optional<base::Result<registry::PreparedScene>> made;
    base::for_parts(std::min(options_.jobs, 2U), 2, [&](std::size_t, std::size_t begin, std::size_t end) {
      if (begin == 0 && choice) chooser_.emplace(scene(), *choice, options_.jobs);
      if (end == 2) made = by_cells ? algorithm_.prepare_cells(source_.decomposition->complex) : prepared(scene(), matter_ || choice);
    });
    if (options_.strokes || options_.layers == Layers::body) origins_.emplace(scene());
    if (!watch.go_on(1)) return base::cancelled();
    if (!*made) return in_file(std::move(made->error()), source_.name);
    prepared_ = std::move(**made);
    return base::Done{};
  }

  [[nodiscard]] base::Result<Drawing> at(const Camera& camera, const base::Watch& watch) const {
    if (const auto reason = algorithm_.why_not_seen(source_.scene, camera))
      return base::Error{source_.name, "camera", fmt::format("{} does not apply to this view: {}", algorithm_.name, *reason)};
    std::optional<ChosenEdges> chosen;
    if (matter_) chosen = matter_->lines_at(camera.eye);
    else if (chooser_) chosen = chooser_->at(camera);
    if (!watch.go_on(0.05)) return base::cancelled();
    // A proof tells what hides each hidden part.
    const bool with_proof = options_.proof || (options_.hidden && options_.strokes && prepared_.view_watched);
    Proof proof;
    auto seen = prepared_.view_watched ? prepared_.view_watched(camera, chosen ? &*chosen : nullptr, watch.part(0.05, 0.8), with_proof ? &proof.edges : nullptr)
                : chosen               ? registry::view_of(prepared_, camera, *chosen)
                                       : prepared_.view(camera);
    if (!watch.go_on(0.8)) return base::cancelled();
    if (!seen) return in_file(std::move(seen.error()), source_.name);
    Drawing result;
    result.visible = std::move(seen->picture);
    result.counts = std::move(seen->counts);
    if (chosen && (chosen_by_user_ || matter_)) {
      result.edges = chosen->edges.size();
      result.by_kind = chosen->counts();
    }
    result.visible_length = picture::image_length(result.visible, scene(), camera);
    const LinePicture drawn = seams_ ? without_seams(result.visible, chosen, camera) : result.visible;
    result.pieces = drawn.pieces.size();
    std::vector<LineLayer> layers = divided(drawn, chosen, false);
    std::vector<LineLayer> hidden;
    if (options_.hidden) {
      LinePicture whole = chosen ? picture::only(whole_edges(), *chosen) : whole_edges();
      if (seams_) whole = without_seams(whole, chosen, camera);
      hidden = divided(picture::hidden_pieces(whole, drawn), chosen, true);
    }
    if (!watch.go_on(0.85)) return base::cancelled();
    if (with_proof) {
      proof.chosen = chosen;
      result.proof = std::make_shared<const Proof>(std::move(proof));
    }
    if (!options_.hatch && !options_.cut_material) {
      add_all(layers, hidden);
      draw(layers, scene(), camera, std::nullopt, watch.part(0.85, 1), result);
    } else if (auto added = add_hatching(camera, std::move(layers), std::move(hidden), watch.part(0.85, 1), result); !added) {
      return std::move(added.error());
    }
    if (watch.ended()) return base::cancelled();
    return result;
  }

  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  // What is drawn: the scene with its lines.
  [[nodiscard]] const scene::PolyScene& scene() const {
    return matter_ ? matter_->scene() : own_scene_ ? *own_scene_ : source_.scene;
  }

 private:
  // Real lines are drawn if the algorithm can draw lines other than edges of faces, and the options do not choose edges.
  void find_matter(std::span<const Camera> cameras) {
    if (!source_.cells || !algorithm_.draws_crossings || options_.edges.are_given() || cameras.empty()) return;
    const auto leave_out_box = [&](std::string_view reason) { note(fmt::format("the outer box is left out: {}", reason)); };
    for (const Camera& camera : cameras) {
      if (!camera.perspective) return leave_out_box("parallel projection looks at the scene from outside");
      if (!scene::locate(*source_.cells, camera.eye)) return leave_out_box("the eye is outside all cells");
    }
    auto matter = MatterScene::of(*source_.cells);
    if (!matter) return leave_out_box("the scene " + matter.error().message());
    matter_.emplace(std::move(*matter));
  }

  void find_crossings() {
    if (source_.kind == scene::SceneKind::polyhedra && are_drawn(scene::crossings_of(source_.scene, 1, options_.jobs)))
      own_scene_ = scene::with_crossings(source_.scene, options_.jobs);
  }

  // nullopt: all edges.
  std::optional<picture::EdgeChoice> choose_edges() {
    seams_ = source_.scene.surfaces.empty() && !options_.edges.are_given();
    auto choice = seams_ ? std::nullopt : edge_choice(options_.edges, scene());
    picture::EdgeChoice all = *picture::edge_choice_named("all");
    all.crease = options_.edges.crease.value_or(source_.scene.surfaces.empty() ? 0 : all.crease);
    if (seams_ && has_free_lines()) choice = all;
    chosen_by_user_ = choice.has_value();
    return options_.strokes && !choice ? all : choice;
  }

  void note(const std::string& text) { notes_.push_back(fmt::format("{}: {}", source_.name, text)); }

  // For views of chosen edges, or of all.
  [[nodiscard]] base::Result<registry::PreparedScene> prepared(const scene::PolyScene& of, bool of_chosen) const {
    return algorithm_.prepare_threads != nullptr ? algorithm_.prepare_threads(of, options_.jobs, of_chosen) : algorithm_.prepare(of);
  }
  // Whether there are lines that are not sides of faces: intersections of bodies, and wires.
  [[nodiscard]] bool has_free_lines() const { return !scene().crossings.empty() || !scene().wires.empty(); }

  using Crossings = std::vector<scene::Crossing>;

  // Whether bodies pass through each other and the algorithm draws the lines of intersection; if it does not, adds a
  // note.
  [[nodiscard]] bool are_drawn(const Crossings& crossings) {
    if (crossings.empty() || algorithm_.draws_crossings) return !crossings.empty();
    note(fmt::format("bodies pass through each other, the first at faces {} and {} of the file; `sightline draw exact` draws "
                     "the lines between them",
                     scene::face_in_file(source_.scene, crossings[0].face_a) + 1, scene::face_in_file(source_.scene, crossings[0].face_b) + 1));
    return false;
  }

  [[nodiscard]] LinePicture whole_edges() const {
    LinePicture whole = picture::wire_frame(scene());
    for (const scene::PolyCrossing& crossing : scene().crossings) whole.pieces.push_back({{crossing.from, crossing.to}, 0, 1});
    return whole;
  }

  // Removes seams. They are only between faces, so lines that are not sides of faces are kept.
  [[nodiscard]] LinePicture without_seams(const LinePicture& picture, const std::optional<ChosenEdges>& chosen, const Camera& camera) const {
    if (!has_free_lines()) return picture::without_seams(picture, scene(), camera);
    LinePicture sides;
    LinePicture apart;
    std::size_t edge = 0;
    for (const LinePiece& piece : picture.pieces) {
      while (chosen->edges[edge] < piece.edge) ++edge;
      (is_free_line(chosen->kinds[edge]) ? apart : sides).pieces.push_back(piece);
    }
    LinePicture result = picture::without_seams(sides, scene(), camera);
    const auto end_of_sides = static_cast<std::ptrdiff_t>(result.pieces.size());
    result.pieces.insert(result.pieces.end(), apart.pieces.begin(), apart.pieces.end());
    std::inplace_merge(result.pieces.begin(), result.pieces.begin() + end_of_sides, result.pieces.end(),
                       [](const LinePiece& a, const LinePiece& b) { return a.edge < b.edge; });
    return result;
  }

  // Divides a picture into layers: by body if requested, and by kind where the kinds are known. Where kinds share a
  // label, the earlier kind keeps the common parts. Hidden lines are one layer of a drawing.
  [[nodiscard]] std::vector<LineLayer> divided(const LinePicture& picture, const std::optional<ChosenEdges>& chosen, bool hidden) const {
    const std::size_t kinds = chosen ? picture::edge_kind_count : 1;
    const bool by_body = options_.layers == Layers::body && !hidden;
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
        } else if (!hidden && options_.layers == Layers::kind && chosen_by_user_ && (!seams_ || is_free_line(static_cast<EdgeKind>(k)))) {
          layer.label = layer.kind;
        }
        layers.push_back(std::move(layer));
      }
    }
    std::size_t edge = 0;
    for (const LinePiece& piece : picture.pieces) {
      std::size_t layer = by_body ? origins_->body_of(piece.edge, scene()) * kinds : 0;
      if (chosen) {
        while (chosen->edges[edge] < piece.edge) ++edge;
        layer += static_cast<std::size_t>(chosen->kinds[edge]);
      }
      layers[layer].picture.pieces.push_back(piece);
    }
    if (seams_ && !by_body) {
      // Sides of faces become one layer of the drawing.
      std::stable_partition(layers.begin(), layers.end(), [](const LineLayer& layer) { return layer.label != layer.kind; });
    }
    return layers;
  }

  // Draws into the given window, or chooses one. Clears the layers' pictures. Incomplete if the watch has ended.
  void draw(std::vector<LineLayer>& layers, const scene::PolyScene& of, const Camera& camera,
            const std::optional<picture::ImageWindow>& given, const base::Watch& watch, Drawing& result) const {
    const picture::DrawingField& field = options_.field;
    picture::UnitedLines lines = picture::united_lines(layers, of, camera);
    if (!watch.go_on(0.4)) return;
    const picture::ImageWindow window = given ? *given : picture::drawing_window(lines, camera, field);
    if (options_.hatch || options_.cut_material) picture::leave_out_hatching_on_lines(lines, layers, window);
    result.window = window;
    if (options_.strokes) add_edges(layers, of, result);
    for (LineLayer& layer : layers) layer.picture = {};
    if (!watch.go_on(0.6)) return;
    const std::vector<picture::LineStroke> strokes = picture::strokes_in(lines, layers, window, field);
    result.stroke_count = strokes.size();
    for (const picture::LineStroke& stroke : strokes)
      result.drawn_length += std::hypot(stroke.to[0] - stroke.from[0], stroke.to[1] - stroke.from[1]);
    result.drawn_length *= window.units(field);
    if (!watch.go_on(0.7)) return;
    result.picture = picture::line_drawing(strokes, layers, window, field);
    if (!watch.go_on(0.8)) return;
    if (options_.strokes) add_strokes(strokes, lines, layers, window, field, result);
  }

  // The exact parts of the lines, and their edges.
  void add_edges(const std::vector<LineLayer>& layers, const scene::PolyScene& of, Drawing& result) const {
    struct Found {
      const LinePiece* piece;
      const LineLayer* layer;
    };
    std::vector<Found> found;
    for (const LineLayer& layer : layers)
      for (const LinePiece& piece : layer.picture.pieces) found.push_back({&piece, &layer});
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
      return a.piece->edge == b.piece->edge ? a.piece->low < b.piece->low : a.piece->edge < b.piece->edge;
    });
    for (const auto& [piece, layer] : found) {
      if (result.edges_drawn.empty() || result.edges_drawn.back().edge != piece->edge) {
        result.edges_drawn.push_back(origins_->drawn_edge(piece->edge, of, result.edge_faces));
        result.edges_drawn.back().kind = kind_named(layer->kind);
      }
      const DrawnPart part{static_cast<std::uint32_t>(result.edges_drawn.size() - 1), piece->low, piece->high, layer->hidden};
      if (part.hidden && result.proof != nullptr) add_hidden(part, piece->edge, of, result);
      else result.parts.push_back(part);
    }
  }

  // Divides a hidden part of an edge where another face begins to hide it, from the left as seen.
  static void add_hidden(DrawnPart part, const picture::LineEdge& edge, const scene::PolyScene& of, Drawing& result) {
    const auto& proofs = result.proof->edges;
    const auto proof = std::lower_bound(proofs.begin(), proofs.end(), edge,
                                        [](const algorithms::exact::EdgeProof& a, const picture::LineEdge& b) { return a.edge < b; });
    if (proof == proofs.end() || proof->edge != edge) return result.parts.push_back(part);
    const geometry::Rational high = part.high;
    for (const algorithms::exact::Witness& witness : proof->left) {
      if (witness.high <= part.low) continue;
      if (high <= witness.low || !(part.low < high)) break;
      if (part.low < witness.low) {
        part.high = witness.low;
        part.hidden_by = no_number;
        result.parts.push_back(part);
        part.low = witness.low;
      }
      part.high = std::min(high, witness.high);
      part.hidden_by = witness.face == algorithms::exact::Witness::behind_eye ? no_number : scene::face_in_file(of, witness.face);
      result.parts.push_back(part);
      part.low = part.high;
    }
    if (!(part.low < high)) return;
    part.high = high;
    part.hidden_by = no_number;
    result.parts.push_back(part);
  }

  // The name itself, which lives as long as the program.
  static std::string_view kind_named(std::string_view kind) {
    for (const std::string_view each : picture::edge_kind_names)
      if (each == kind) return each;
    for (const std::string_view each : picture::hatching_kinds)
      if (each == kind) return each;
    return {};
  }

  static void add_strokes(const std::vector<picture::LineStroke>& strokes, const picture::UnitedLines& lines,
                          const std::vector<LineLayer>& layers, const picture::ImageWindow& window, const picture::DrawingField& field,
                          Drawing& result) {
    for (const LineLayer& layer : layers) result.layers.push_back({layer.kind, layer.label, layer.hidden});
    for (const picture::LineStroke& stroke : strokes) {
      result.strokes.push_back({window.in_field(stroke.from, field), window.in_field(stroke.to, field), stroke.layer,
                                static_cast<std::uint32_t>(result.stroke_edges.size()), stroke.source_count});
      for (std::uint32_t s = 0; s < stroke.source_count; ++s) {
        const auto at = std::lower_bound(result.edges_drawn.begin(), result.edges_drawn.end(), lines.sources[stroke.first_source + s],
                                         [](const DrawnEdge& drawn, const picture::LineEdge& edge) { return drawn.edge < edge; });
        result.stroke_edges.push_back(static_cast<std::uint32_t>(at - result.edges_drawn.begin()));
      }
    }
  }

  base::Result<base::Done> add_hatching(const Camera& camera, std::vector<LineLayer> layers, std::vector<LineLayer> hidden,
                                        const base::Watch& watch, Drawing& result) const {
    std::vector<LineLayer> edges = layers;
    edges.insert(edges.end(), hidden.begin(), hidden.end());
    const picture::ImageWindow window = picture::drawing_window(picture::united_lines(edges, scene(), camera), camera, options_.field);
    const double units = window.units(options_.field);
    const HatchOptions shading = options_.hatch.value_or(HatchOptions{});
    picture::HatchOptions wanted{shading.angle, shading.spacing, shading.light.value_or(usual_light(camera)), options_.hatch.has_value()};
    wanted.cut_material = options_.cut_material;
    const auto hatching = picture::hatch(scene(), camera, window, units, wanted);
    if (!hatching) return in_file(hatching.error(), "hatch");
    const auto lines = prepared(hatching->scene, true);
    if (!lines) return in_file(lines.error(), source_.name);
    const auto seen = registry::view_of(*lines, camera, hatching->lines);
    if (!seen) return in_file(seen.error(), source_.name);
    std::array<LineLayer, picture::hatching_kinds.size()> hatched;
    for (std::size_t k = 0; k < hatched.size(); ++k) hatched[k] = {std::string(picture::hatching_kinds[k]), {}, {}, std::string(picture::hatching_kinds[k])};
    hatched[3].label = hatched[2].label;
    std::size_t line = 0;
    for (const LinePiece& piece : seen->picture.pieces) {
      while (hatching->lines.edges[line] < piece.edge) ++line;
      hatched[static_cast<std::size_t>(hatching->directions[line])].picture.pieces.push_back(piece);
    }
    result.hatch_lines = hatching->lines.edges.size();
    result.hatch_pieces = seen->picture.pieces.size();
    for (LineLayer& layer : hatched) layers.push_back(std::move(layer));
    add_all(layers, hidden);
    draw(layers, hatching->scene, camera, window, watch, result);
    return base::Done{};
  }

  const Scene& source_;
  const ViewOptions options_;
  const registry::LineAlgorithm& algorithm_;
  std::optional<MatterScene> matter_;          // for a scene of cells whose real lines are drawn instead of the edges of faces
  std::optional<scene::PolyScene> own_scene_;  // with crossings
  bool chosen_by_user_ = false;                // or by the scene; otherwise kinds are used only for the list of strokes
  bool seams_ = false;                         // leave out seams: of a scene that is not a mesh and for which no edges are chosen
  std::optional<picture::EdgeChooser> chooser_;
  std::optional<Origins> origins_;  // for strokes and layers of bodies
  registry::PreparedScene prepared_;
  std::vector<std::string> notes_;
};

Views::Views(std::unique_ptr<const Work> work) : work_(std::move(work)) {}
Views::Views(Views&&) noexcept = default;
Views& Views::operator=(Views&&) noexcept = default;
Views::~Views() = default;

base::Result<Views> Views::of(const Scene& scene, const ViewOptions& options, std::span<const Camera> cameras, const base::Watch& watch) {
  const auto algorithm = algorithm_named(options.algorithm);
  if (!algorithm) return algorithm.error();
  auto work = std::make_unique<Work>(scene, options, **algorithm);
  if (auto prepared = work->prepare(cameras, watch); !prepared) return std::move(prepared.error());
  return Views(std::move(work));
}

base::Result<Drawing> Views::at(const Camera& camera, const base::Watch& watch) const { return work_->at(camera, watch); }

std::string Views::certificate(const Camera& camera, const Drawing& drawing) const {
  return certificate_of(work_->scene(), camera, *drawing.proof);
}

const std::vector<std::string>& Views::notes() const { return work_->notes(); }

base::Result<Drawing> view(const Scene& scene, const Camera& camera, const ViewOptions& options) {
  const auto views = Views::of(scene, options, {&camera, 1});
  if (!views) return views.error();
  auto drawing = views->at(camera);
  if (drawing) drawing->notes = views->notes();
  return drawing;
}

base::Result<registry::LineView> visible_edges(const scene::PolyScene& scene, const Camera& camera, std::string_view algorithm) {
  const auto found = algorithm_named(algorithm);
  if (!found) return found.error();
  const registry::LineAlgorithm& by = **found;
  if (const auto reason = by.why_not(scene)) return base::bad_input(*reason);
  if (const auto reason = by.why_not_seen(scene, camera)) return base::bad_input(*reason);
  const auto prepared = by.prepare(scene);
  if (!prepared) return prepared.error();
  return prepared->view(camera);
}

std::string json_lines(const Drawing& drawing, double margin) {
  const auto moved = [margin](const std::array<double, 2>& end) {
    base::Json point = base::Json::array();
    constexpr double parts = 1e6;  // finer than the resolution of any drawing file
    for (const double c : end) point.push_back(std::round((c + margin) * parts) / parts);
    return point;
  };
  std::string text;
  for (const Stroke& stroke : drawing.strokes) {
    const DrawnLayer& layer = drawing.layers[stroke.layer];
    base::Json line{{"from", moved(stroke.from)}, {"to", moved(stroke.to)}, {"kind", layer.kind}, {"layer", layer.name},
                    {"hidden", layer.hidden}};
    base::Json ends = base::Json::array();
    std::set<std::uint32_t> faces;  // from 1
    for (std::uint32_t e = 0; e < stroke.edge_count; ++e) {
      const DrawnEdge& edge = drawing.edges_drawn[drawing.stroke_edges[stroke.first_edge + e]];
      ends.push_back(base::Json::array({edge.ends[0], edge.ends[1]}));
      for (std::uint32_t f = 0; f < edge.face_count; ++f) faces.insert(drawing.edge_faces[edge.first_face + f] + 1);
    }
    line["edges"] = ends;
    line["faces"] = faces;
    text += line.dump() + "\n";
  }
  return text;
}

}  // namespace sightline::hidden_lines
