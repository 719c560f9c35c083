#include "host/algorithms/registry/turns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "host/algorithms/plantinga/circle_events.hpp"
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

// The view of an eye on its circle. In perspective, the eye is rounded to the grid of the scene; otherwise its direction to
// numbers below 2^15. right and up span the image plane; visibility does not need them to be orthogonal.
scene::PolyCamera camera_at(const plantinga::EyeCircle& circle, double angle) {
  const plantinga::NearEye eye = plantinga::near_eye_at(circle, angle);
  double largest = 0;
  std::size_t steepest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(eye.turned[i]) > largest) steepest = i;
    largest = std::max(largest, std::abs(eye.turned[i]));
  }
  scene::PolyCamera camera;
  camera.perspective = circle.perspective;
  for (std::size_t i = 0; i < 3; ++i) {
    camera.forward[i] = static_cast<std::int32_t>(std::lround(-32767 * eye.turned[i] / largest));
    if (circle.perspective) camera.eye[i] = static_cast<std::int32_t>(std::lround(eye.about[i] + eye.turned[i]));
  }
  const std::size_t second = (steepest + 1) % 3;
  const std::size_t third = (steepest + 2) % 3;
  camera.right = camera.up = {};
  camera.right[second] = camera.up[third] = camera.forward[steepest];
  camera.right[steepest] = -camera.forward[second];
  camera.up[steepest] = -camera.forward[third];
  return camera;
}

std::optional<picture::EdgeChooser> chooser_of(const scene::PolyScene& scene, const TurnOptions& options) {
  if (!options.edges || options.edges->all()) return std::nullopt;
  return std::optional<picture::EdgeChooser>(std::in_place, scene, *options.edges);
}

class PlantingaTurn {
 public:
  PlantingaTurn(plantinga::RotationModel model, plantinga::EventList list, const std::optional<plantinga::EyeCircle>& circle,
                std::optional<picture::EdgeChooser> chooser)
      : model_(std::move(model)),
        list_(std::move(list)),
        graph_(list_),
        circle_(circle),
        frames_(circle ? plantinga::FrameMaker(model_, *circle) : plantinga::FrameMaker(model_)),
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
      for (const picture::LineEdge& edge : chooser_->at(circle_ ? camera_at(*circle_, angle) : camera_at(angle)).edges) {
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
  std::optional<plantinga::EyeCircle> circle_;
  plantinga::FrameMaker frames_;
  std::optional<picture::EdgeChooser> chooser_;  // nullopt: all edges are drawn
  std::vector<plantinga::ImageLine> found_;
  std::vector<plantinga::EdgeIndex> edges_;  // edge of each line
  std::vector<bool> drawn_;                  // by edge
};

// Draws each view from scratch, for scenes with too many edges to find events for.
class ExactTurn {
 public:
  ExactTurn(const scene::PolyScene& scene, PreparedScene prepared, const std::optional<plantinga::EyeCircle>& circle,
            std::optional<picture::EdgeChooser> chooser)
      : scene_(scene), prepared_(std::move(prepared)), circle_(circle), chooser_(std::move(chooser)) {}

  void visible(double angle, std::vector<TurnLine>& lines) {
    const scene::PolyCamera camera = camera_of(angle);
    const auto view = chooser_ ? view_of(prepared_, camera, chooser_->at(camera)) : prepared_.view(camera);
    lines.clear();
    if (!view) base::give_up("exact did not draw a view of a turn: " + view.error().message());
    for (const picture::LinePiece& piece : view->picture.pieces)
      add(piece.edge, angle, piece.low.to_double(), piece.high.to_double(), lines);
  }
  void whole(double angle, std::vector<TurnLine>& lines) const {
    lines.clear();
    for (const picture::LineEdge& edge : chooser_ ? chooser_->at(camera_of(angle)).edges : picture::edges_of(scene_))
      add(edge, angle, 0, 1, lines);
  }

 private:
  [[nodiscard]] scene::PolyCamera camera_of(double angle) const {
    return circle_ ? camera_at(*circle_, angle) : camera_at(angle);
  }
  void add(const picture::LineEdge& edge, double angle, double low, double high,
           std::vector<TurnLine>& lines) const {
    const auto place = [this](scene::VertexIndex v) { return scene::place_of(scene_, v); };
    if (circle_) {
      const plantinga::CircleImage image(*circle_, angle);
      const std::array<double, 3> p = place(edge.from);
      const std::array<double, 3> q = place(edge.to);
      const auto end = [&](double s) {
        return image.of({p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), p[2] + s * (q[2] - p[2])});
      };
      const auto first = end(low);
      const auto last = end(high);
      lines.push_back({first.u, first.v, last.u, last.v});
      return;
    }
    const double sine = std::sin(angle);
    const double cosine = std::cos(angle);
    const auto image = [&](scene::VertexIndex v) {
      const std::array<double, 3> p = place(v);
      return std::array{p[0] * cosine - p[2] * sine, p[1]};
    };
    const auto from = image(edge.from);
    const auto to = image(edge.to);
    const double du = to[0] - from[0];
    const double dv = to[1] - from[1];
    lines.push_back({from[0] + low * du, from[1] + low * dv, from[0] + high * du, from[1] + high * dv});
  }

  const scene::PolyScene& scene_;
  PreparedScene prepared_;
  std::optional<plantinga::EyeCircle> circle_;
  std::optional<picture::EdgeChooser> chooser_;
};

base::Result<PreparedTurn> prepare_exact(const scene::PolyScene& scene, const TurnOptions& options) {
  auto views = find_line_algorithm("exact")->prepare(scene);
  if (!views) return std::move(views.error());
  const auto turn = std::make_shared<ExactTurn>(scene, std::move(*views), options.circle, chooser_of(scene, options));
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

base::Result<plantinga::EventList> circle_events_of(const plantinga::RotationModel& model, const TurnOptions& options) {
  if (const auto reason = plantinga::why_not(model, *options.circle)) return base::bad_input(*reason);
  plantinga::BuildOptions build;
  build.progress = options.progress;
  auto events = plantinga::build_circle_events(model, *options.circle, build);
  if (!events) return std::move(events.error());
  return std::move(events->list);
}

base::Result<PreparedTurn> prepare_plantinga(const scene::PolyScene& scene, const TurnOptions& options) {
  plantinga::RotationModel model(scene);
  auto list = options.circle ? circle_events_of(model, options) : events_of(model, options);
  if (!list) return list.error();
  const auto turn = std::make_shared<PlantingaTurn>(std::move(model), std::move(*list), options.circle, chooser_of(scene, options));
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
