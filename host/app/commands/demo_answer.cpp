#include "host/app/commands/demo_answer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "host/app/camera_options.hpp"
#include "host/app/command.hpp"
#include "host/app/commands/answer_output.hpp"
#include "host/app/commands/compare_output.hpp"
#include "host/app/scene_argument.hpp"
#include "host/compare/height_devices.hpp"
#include "host/compare/variants.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {
namespace {

using base::Json;

constexpr std::string_view cells_in_plot = "roberts";
constexpr std::string_view function_in_plot = "sinc";
constexpr const char* boxes = "boxes-20";
constexpr const char* turned_boxes = "boxes-8";
constexpr const char* turned_view = "1,0,2";

template <class Value>
Value value_or_throw(base::Result<Value> result, std::string_view name) {
  return value_of(std::move(result), std::string(name), base::ErrorKind::program_failed);
}

void add_plotted(std::vector<compare::PlotPoint> points, DemoAnswer& answer) {
  answer.plotted.insert(answer.plotted.end(), std::make_move_iterator(points.begin()), std::make_move_iterator(points.end()));
}

void compare_cells(const compare::CompareOptions& options, DemoAnswer& answer) {
  for (const std::string_view name : scene::builtin_scene_names()) {
    const scene::CellScene scene = load_cells(std::string(name));
    answer.scenes.push_back(value_or_throw(compare::compare_cell_scene(scene, options), name));
    if (name == cells_in_plot) add_plotted(compare::variants_of(scene, options, answer.scenes.back()), answer);
  }
}

void compare_polyhedra(const compare::CompareOptions& options, DemoAnswer& answer) {
  for (const char* const name : {boxes, turned_boxes}) {
    const scene::PolyScene scene = load_scene(name).scene;
    CameraArguments camera;
    if (name == turned_boxes) camera.orthographic = turned_view;
    answer.scenes.push_back(value_or_throw(compare::compare_poly_scene(scene, camera_of(camera, scene, name), options), name));
    answer.scenes.back().scene = name;
    if (name == boxes) continue;
    // The plot shows the other methods on the scene of cells.
    std::vector<compare::PlotPoint> points = compare::variants_of(scene, options, answer.scenes.back());
    std::erase_if(points, [](const compare::PlotPoint& point) {
      return !point.series.starts_with("plantinga") && point.series != "turn-pdp7";
    });
    add_plotted(std::move(points), answer);
  }
}

void compare_functions(bool host_times, DemoAnswer& answer) {
  algorithms::skala::View view;
  view.rotation = 30;
  for (const scene::HeightFunction& function : scene::height_functions().first(scene::figure_functions)) {
    const scene::HeightGrid grid = sample(function, {33, 60});
    auto comparison = compare::compare_heights(
        grid, view, [](std::string_view) {}, [&](scene::GridSize size) { return sample(function, size); }, host_times);
    comparison.devices = compare::compare_devices(grid, view);
    if (function.name == function_in_plot) add_plotted(compare::variants_of(comparison), answer);
    answer.functions.emplace_back(function.name, std::move(comparison));
  }
}

}  // namespace

bool DemoAnswer::agrees() const {
  return std::all_of(scenes.begin(), scenes.end(), [](const auto& scene) { return scene.agrees(); }) &&
         std::all_of(functions.begin(), functions.end(), [](const auto& function) { return function.second.agrees(); });
}

DemoAnswer answer_for_demo(bool host_times) {
  DemoAnswer answer;
  compare::CompareOptions options;
  options.host_times = host_times;
  compare_cells(options, answer);
  compare_polyhedra(options, answer);
  compare_functions(host_times, answer);
  compare::Answer by_scene;
  compare::Answer by_method;
  std::uint64_t number = 0;
  const auto add = [&](const std::string& name, std::vector<compare::MethodView> views) {
    by_scene.add(name, 0, views);
    for (compare::MethodView& view : views) view.read = view.of_all = std::nullopt;  // counts of different scenes cannot be combined
    by_method.add("all", number++, views);
  };
  for (const compare::SceneComparison& scene : answer.scenes)
    add(scene.camera.perspective ? scene.scene : scene.scene + ", parallel", method_views(scene));
  for (const auto& [name, function] : answer.functions) add(name, method_views(function));
  answer.rows = by_scene.rows();
  answer.methods = by_method.rows();
  answer.plotted_text = fmt::format(
      "{} from its own view; of {} in parallel projection along {} Plantinga's events and turn-pdp7; the function {}, rotated 30 "
      "degrees",
      cells_in_plot, turned_boxes, turned_view, function_in_plot);
  return answer;
}

void add_demo_answer(Json& document, const DemoAnswer& answer) {
  document["table"] = answer_json(answer.rows);
  document["plot"] = Json::array();
  for (const compare::PlotPoint& point : answer.plotted) {
    document["plot"].push_back({{"computer", point.panel == compare::PlotPanel::host ? "this" : "emulated"},
                                {"series", point.series},
                                {"label", point.label},
                                {"seconds", point.seconds},
                                {"wrong_percent", point.wrong_percent}});
  }
  Json& compared = document["compared"];
  compared = {{"agrees", answer.agrees()}, {"scenes", Json::array()}};
  for (const compare::SceneComparison& scene : answer.scenes) compared["scenes"].push_back(compare_json(scene));
  for (const auto& [name, function] : answer.functions) compared["scenes"].push_back(compare_json(name, function));
}

}  // namespace sightline::app
