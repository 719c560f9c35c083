#include "host/algorithms/registry/turns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "host/algorithms/plantinga/event_file.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::registry {

namespace {

namespace plantinga = algorithms::plantinga;

// The convergent nearest to a number from 0 to 1 with numerator and denominator below 2^15.
std::array<std::int32_t, 2> fraction_near(double number) {
  constexpr double limit = 32767;
  std::array<double, 2> before{1, 0};  // the current convergent and the previous one
  std::array<double, 2> last{0, 1};
  double rest = number;
  for (int i = 0; i < 64 && rest > 1e-12; ++i) {
    const double part = std::floor(1 / rest);
    rest = 1 / rest - part;
    const std::array<double, 2> next{part * last[0] + before[0], part * last[1] + before[1]};
    if (next[1] > limit) break;
    before = last;
    last = next;
  }
  return {static_cast<std::int32_t>(last[0]), static_cast<std::int32_t>(last[1])};
}

// A parallel camera, turned about the y axis, with numbers below 2^15.
scene::PolyCamera camera_at(double angle) {
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const bool steep = std::abs(sine) > std::abs(cosine);
  auto [small, large] = fraction_near(steep ? std::abs(cosine / sine) : std::abs(sine / cosine));
  const std::int32_t x = (steep ? large : small) * (sine < 0 ? -1 : 1);
  const std::int32_t z = (steep ? small : large) * (cosine < 0 ? -1 : 1);
  return {false, {}, {-x, 0, -z}, {z, 0, -x}, {0, 1, 0}};
}

std::optional<picture::EdgeChooser> chooser_of(const scene::PolyScene& scene, const TurnOptions& options) {
  if (!options.edges || options.edges->all()) return std::nullopt;
  return std::optional<picture::EdgeChooser>(std::in_place, scene, *options.edges);
}

class PlantingaTurn {
 public:
  PlantingaTurn(plantinga::RotationModel model, plantinga::EventList list,
                std::optional<picture::EdgeChooser> chooser)
      : model_(std::move(model)),
        list_(std::move(list)),
        graph_(list_),
        frames_(model_),
        chooser_(std::move(chooser)) {}
  PlantingaTurn(const PlantingaTurn&) = delete;  // the graph points into the list
  PlantingaTurn& operator=(const PlantingaTurn&) = delete;

  void visible(double angle, std::vector<TurnLine>& lines) {
    // A list that was read or built is consistent, so every step succeeds.
    static_cast<void>(graph_.turn_to(angle));
    frames_.visible(graph_, angle, found_);
    edges_.clear();
    for (const plantinga::LivePiece& piece : graph_.pieces())
      if (piece.edge != plantinga::no_edge) edges_.push_back(piece.edge);
    copy(angle, lines);
  }
  void whole(double angle, std::vector<TurnLine>& lines) {
    frames_.wire(angle, found_);
    edges_.resize(found_.size());
    for (plantinga::EdgeIndex e = 0; e < edges_.size(); ++e) edges_[e] = e;
    copy(angle, lines);
  }
  [[nodiscard]] const plantinga::RotationModel& model() const { return model_; }
  [[nodiscard]] const plantinga::EventList& list() const { return list_; }

 private:
  // Copies the lines of the chosen edges.
  void copy(double angle, std::vector<TurnLine>& lines) {
    drawn_.assign(model_.edges().size(), !chooser_);
    if (chooser_) {
      std::size_t e = 0;
      for (const picture::LineEdge& edge : chooser_->at(camera_at(angle)).edges) {
        while (model_.edges()[e] != edge) ++e;
        drawn_[e] = true;
      }
    }
    lines.clear();
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const plantinga::ImageLine& line = found_[i];
      if (drawn_[edges_[i]]) lines.push_back({line.u0, line.v0, line.u1, line.v1});
    }
  }

  plantinga::RotationModel model_;
  plantinga::EventList list_;
  plantinga::EdgeStructureGraph graph_;
  plantinga::FrameMaker frames_;
  std::optional<picture::EdgeChooser> chooser_;  // nullopt: all edges are drawn
  std::vector<plantinga::ImageLine> found_;
  std::vector<plantinga::EdgeIndex> edges_;  // edge of each line
  std::vector<bool> drawn_;                  // by edge
};

// Draws each view from scratch, for scenes with too many edges to find events for.
class ExactTurn {
 public:
  ExactTurn(const scene::PolyScene& scene, PreparedScene prepared, std::optional<picture::EdgeChooser> chooser)
      : scene_(scene), prepared_(std::move(prepared)), chooser_(std::move(chooser)) {}

  void visible(double angle, std::vector<TurnLine>& lines) {
    const scene::PolyCamera camera = camera_at(angle);
    const auto view = chooser_ ? view_of(prepared_, camera, chooser_->at(camera)) : prepared_.view(camera);
    lines.clear();
    if (!view) return;  // `exact` draws every view
    for (const picture::LinePiece& piece : view->picture.pieces)
      add(piece.edge, angle, piece.low.to_double(), piece.high.to_double(), lines);
  }
  void whole(double angle, std::vector<TurnLine>& lines) const {
    lines.clear();
    for (const picture::LineEdge& edge : chooser_ ? chooser_->at(camera_at(angle)).edges : picture::edges_of(scene_))
      add(edge, angle, 0, 1, lines);
  }

 private:
  void add(const picture::LineEdge& edge, double angle, double low, double high,
           std::vector<TurnLine>& lines) const {
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const auto place = [&](scene::VertexIndex v) {
      const std::array<double, 3> p = scene::place_of(scene_, v);
      return std::array{p[0] * cosine - p[2] * sine, p[1]};
    };
    const auto from = place(edge.from);
    const auto to = place(edge.to);
    const double du = to[0] - from[0];
    const double dv = to[1] - from[1];
    lines.push_back({from[0] + low * du, from[1] + low * dv, from[0] + high * du, from[1] + high * dv});
  }

  const scene::PolyScene& scene_;
  PreparedScene prepared_;
  std::optional<picture::EdgeChooser> chooser_;
};

base::Result<PreparedTurn> prepare_exact(const scene::PolyScene& scene, const TurnOptions& options) {
  auto views = find_line_algorithm("exact")->prepare(scene);
  if (!views) return std::move(views.error());
  const auto turn = std::make_shared<ExactTurn>(scene, std::move(*views), chooser_of(scene, options));
  PreparedTurn prepared;
  prepared.visible = [turn](double angle, std::vector<TurnLine>& lines) { turn->visible(angle, lines); };
  prepared.whole = [turn](double angle, std::vector<TurnLine>& lines) { turn->whole(angle, lines); };
  prepared.counts = {{"edges", picture::edges_of(scene).size()}};
  return prepared;
}

base::Result<plantinga::EventList> events_of(const plantinga::RotationModel& model,
                                             const TurnOptions& options) {
  if (!options.found.empty()) {
    auto read = plantinga::read_events(options.found, model);
    if (read && read->tolerance != options.tolerance) {
      constexpr double degree = std::numbers::pi / 180;
      return base::Error{
          .file = options.found,
          .found = fmt::format("found events with a tolerance of {:g} degrees, expected {:g}: name another file",
                               read->tolerance / degree, options.tolerance / degree)};
    }
    return read;
  }
  plantinga::BuildOptions build;
  build.tolerance = options.tolerance;
  build.progress = options.progress;
  return plantinga::build_event_list(model, build);
}

base::Result<PreparedTurn> prepare_plantinga(const scene::PolyScene& scene, const TurnOptions& options) {
  plantinga::RotationModel model(scene);
  auto list = events_of(model, options);
  if (!list) return list.error();
  const auto turn = std::make_shared<PlantingaTurn>(std::move(model), std::move(*list), chooser_of(scene, options));
  PreparedTurn prepared;
  prepared.visible = [turn](double angle, std::vector<TurnLine>& lines) { turn->visible(angle, lines); };
  prepared.whole = [turn](double angle, std::vector<TurnLine>& lines) { turn->whole(angle, lines); };
  prepared.keep = [turn](const std::string& file) { return plantinga::write_events(file, turn->list()); };
  prepared.counts = {{"edges", turn->model().edges().size()},
                     {"events", turn->list().events.size()},
                     {"changes of edges", turn->list().changes.size()}};
  return prepared;
}

constexpr std::array turn_rows{
    TurnMethod{"plantinga", "Events of a full turn, after Plantinga, Seales and Dyer (1990), exact",
               plantinga::why_not, prepare_plantinga},
    TurnMethod{"exact", "Each view from nothing, exact",
               [](const scene::PolyScene&) { return std::optional<std::string>(); }, prepare_exact},
};

}  // namespace

std::span<const TurnMethod> turn_methods() {
  return turn_rows;
}

const TurnMethod* find_turn_method(std::string_view name) {
  const auto found = std::find_if(turn_rows.begin(), turn_rows.end(),
                                  [name](const TurnMethod& method) { return method.name == name; });
  return found != turn_rows.end() ? &*found : nullptr;
}

}  // namespace sightline::registry
