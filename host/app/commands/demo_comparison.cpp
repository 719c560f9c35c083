#include "host/app/commands/demo_comparison.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "host/app/command.hpp"
#include "host/app/commands/compare_output.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {

namespace {

using base::Json;
using compare::ComparedPicture;
using compare::ComparedRaster;
using compare::HeightComparison;
using compare::SceneComparison;

const ComparedPicture* guest_of(const SceneComparison& comparison) {
  const auto found = std::find_if(comparison.pictures.begin(), comparison.pictures.end(),
                                  [](const ComparedPicture& picture) { return picture.name == "jones-pdp7"; });
  return found == comparison.pictures.end() ? nullptr : &*found;
}

const ComparedRaster* raster_of(const HeightComparison& comparison, std::string_view name) {
  const auto found = std::find_if(comparison.rasters.begin(), comparison.rasters.end(),
                                  [name](const ComparedRaster& raster) { return raster.name == name; });
  return found == comparison.rasters.end() ? nullptr : &*found;
}

std::string_view is_its_twin(bool identical) {
  return identical ? "identical" : "DIFFERS";
}

// The exact algorithms that gave the oracle's picture, and how many there are.
std::string exact_text(const SceneComparison& comparison) {
  std::size_t exact = 0;
  std::size_t equal = 0;
  for (const ComparedPicture& picture : comparison.pictures) {
    if (!picture.identical) continue;
    ++exact;
    equal += *picture.identical ? 1 : 0;
  }
  return fmt::format("{} of {}", equal, exact);
}

std::string scene_line(const SceneComparison& comparison) {
  const ComparedPicture* const guest = guest_of(comparison);
  if (guest == nullptr) return fmt::format("{:<11}{:>10}\n", comparison.scene, "no guest");
  const picture::LineMetrics& m = guest->metrics;
  return fmt::format("{:<11}{:>10}{:>11.2f} %{:>11.2f} %{:>11.2f} %{:>12.2f} %{:>12}\n", comparison.scene,
                     is_its_twin(comparison.guest && comparison.guest->difference.empty()),
                     100 * m.share(m.missing), 100 * m.share(m.extra), 100 * m.share(m.extra_far),
                     100 * m.wrong_visibility.rate, exact_text(comparison));
}

std::string function_line(const std::string& name, const HeightComparison& comparison) {
  const ComparedRaster* const guest = raster_of(comparison, "guest");
  const ComparedRaster* const native = raster_of(comparison, "native");
  if (guest == nullptr) return fmt::format("{:<11}{:>10}\n", name, "no guest");
  return fmt::format(
      "{:<11}{:>10}{:>13}{:>13}{:>13}{:>14}\n", name, is_its_twin(comparison.guest_difference.empty()),
      guest->metrics.lit, guest->metrics.missing, guest->metrics.extra,
      native == nullptr ? std::string("-")
                        : fmt::format("{}", native->metrics.missing_far + native->metrics.extra_far));
}

}  // namespace

bool DemoComparison::agrees() const {
  return std::all_of(scenes.begin(), scenes.end(), [](const auto& scene) { return scene.agrees(); }) &&
         std::all_of(functions.begin(), functions.end(),
                     [](const auto& function) { return function.second.agrees(); });
}

DemoComparison compare_for_demo() {
  DemoComparison comparison;
  for (const std::string_view name : scene::builtin_scene_names()) {
    auto compared = compare::compare_cell_scene(load_cells(std::string(name)), {});
    if (!compared)
      throw Failure(ExitCode::guest_failed, fmt::format("{}: {}", name, compared.error().message()));
    comparison.scenes.push_back(std::move(*compared));
  }
  for (const scene::HeightFunction& function : scene::height_functions().first(scene::figure_functions)) {
    guests::skala::View view;
    view.rotation = 30;
    comparison.functions.emplace_back(function.name,
                                      compare::compare_heights(sample(function, {33, 60}), view));
  }
  return comparison;
}

std::string demo_comparison_table(const DemoComparison& comparison) {
  std::string text = fmt::format("{:<11}{:>10}{:>13}{:>13}{:>13}{:>14}{:>12}\n", "scene", "twin", "missing",
                                 "extra", "extra >1 px", "wrong points", "exact");
  for (const SceneComparison& scene : comparison.scenes) text += scene_line(scene);
  text +=
      "Of the visible length, what the PDP-7 did not draw and drew though hidden, in points of its display; "
      "exact: of\nthe native algorithms, those whose picture is the oracle's piece for piece.\n";
  text += fmt::format("{:<11}{:>10}{:>13}{:>13}{:>13}{:>14}\n", "function", "twin", "dots", "missing",
                      "extra", "native >1 dot");
  for (const auto& [name, function] : comparison.functions) text += function_line(name, function);
  text +=
      "Dots of the 8080's slices against the oracle's columns; the last column: dots of the native drawing "
      "farther than\none dot from the oracle's, and the other way round.\n";
  return text;
}

void add_demo_comparison(Json& document, const DemoComparison& comparison) {
  Json& compared = document["compared"];
  compared = {{"agrees", comparison.agrees()}, {"scenes", Json::array()}};
  for (const SceneComparison& scene : comparison.scenes) compared["scenes"].push_back(compare_json(scene));
  for (const auto& [name, function] : comparison.functions)
    compared["scenes"].push_back(compare_json(name, function));
}

}  // namespace sightline::app
