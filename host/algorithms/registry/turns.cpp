#include "host/algorithms/registry/turns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <utility>

#include "host/algorithms/plantinga/event_file.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"

namespace sightline::registry {

namespace {

namespace plantinga = algorithms::plantinga;

class PlantingaTurn {
 public:
  PlantingaTurn(plantinga::RotationModel model, plantinga::EventList list)
      : model_(std::move(model)), list_(std::move(list)), graph_(list_), frames_(model_) {}
  PlantingaTurn(const PlantingaTurn&) = delete;  // the graph points into the list
  PlantingaTurn& operator=(const PlantingaTurn&) = delete;

  void visible(double angle, std::vector<TurnLine>& lines) {
    // A list that was read or made is consistent: every step fits.
    static_cast<void>(graph_.turn_to(angle));
    frames_.visible(graph_, angle, found_);
    copy(lines);
  }
  void whole(double angle, std::vector<TurnLine>& lines) {
    frames_.wire(angle, found_);
    copy(lines);
  }
  [[nodiscard]] const plantinga::RotationModel& model() const { return model_; }
  [[nodiscard]] const plantinga::EventList& list() const { return list_; }

 private:
  void copy(std::vector<TurnLine>& lines) const {
    lines.clear();
    for (const plantinga::ImageLine& line : found_) lines.push_back({line.u0, line.v0, line.u1, line.v1});
  }

  plantinga::RotationModel model_;
  plantinga::EventList list_;
  plantinga::EdgeStructureGraph graph_;
  plantinga::FrameMaker frames_;
  std::vector<plantinga::ImageLine> found_;
};

base::Result<plantinga::EventList> events_of(const plantinga::RotationModel& model,
                                             const TurnOptions& options) {
  if (!options.found.empty()) {
    auto read = plantinga::read_events(options.found, model);
    if (read && read->tolerance != options.tolerance) {
      constexpr double degree = std::numbers::pi / 180;
      return base::Error{
          .file = options.found,
          .found = fmt::format("events of a tolerance of {:g} degrees, expected {:g}: name another file",
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
  const auto turn = std::make_shared<PlantingaTurn>(std::move(model), std::move(*list));
  PreparedTurn prepared;
  prepared.visible = [turn](double angle, std::vector<TurnLine>& lines) { turn->visible(angle, lines); };
  prepared.whole = [turn](double angle, std::vector<TurnLine>& lines) { turn->whole(angle, lines); };
  prepared.keep = [turn](const std::string& file) { return plantinga::write_events(file, turn->list()); };
  prepared.counts = {{"edges", turn->model().edges().size()},
                     {"events", turn->list().events.size()},
                     {"changes of edges", turn->list().changes.size()}};
  return prepared;
}

constexpr std::array rows{
    TurnMethod{"plantinga", "Events of a full turn, after Plantinga, Seales and Dyer (1990), exact",
               plantinga::why_not, prepare_plantinga},
};

}  // namespace

std::span<const TurnMethod> turn_methods() {
  return rows;
}

const TurnMethod* find_turn_method(std::string_view name) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [name](const TurnMethod& method) { return method.name == name; });
  return found != rows.end() ? &*found : nullptr;
}

}  // namespace sightline::registry
