// `sightline explain`: shows step by step how an algorithm makes a picture, as JSON or as a page.
#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "host/algorithms/skala/surface.hpp"
#include "host/app/commands/commands.hpp"
#include "host/app/commands/draw.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/commands/skala_source.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/progress.hpp"
#include "host/explain/explain.hpp"
#include "host/explain/lesson_page.hpp"
#include "host/scene/heights/read_grid.hpp"

namespace sightline::app {
namespace {

struct ExplainArguments {
  std::string scene;
  CameraArguments camera;
  SkalaSource source;
  double rotation = 30;
  double elevation = 30;
  std::string file;
};

bool is_page(const std::string& file) { return file.ends_with(".html") || file.ends_with(".htm"); }

void check_name(const std::string& file) {
  if (file != "-" && !is_page(file) && !file.ends_with(".json"))
    throw base::usage_error(fmt::format("{}: expected a name that ends in .json or .html, or - for JSON on standard output", file));
}

void write_lesson(const explain::Lesson& lesson, const std::string& file, Output& output) {
  output.write(std::string_view(is_page(file) ? explain::page_of(lesson) : explain::json_of(lesson) + "\n"));
  output.commit();
  report_written(file, (lesson.cut ? "cut after " : "") + count_text(lesson.steps.size(), "step") + (is_page(file) ? "; open it in a browser" : ""));
}

// If the file is a grid of heights, the error names the lesson that accepts it, skala.
scene::LoadedScene load_scene_of(const explain::Explainer& explainer, const std::string& name, const MeshArguments& mesh) {
  try {
    return load_scene(name, mesh);
  } catch (const base::Error&) {
    if (name == "-" || !scene::load_height_grid(name)) throw;
    throw base::bad_input(fmt::format("{0}: found a grid of heights, expected a scene for {1}; `sightline explain skala {0}` takes it",
                                                   name, explainer.algorithm));
  }
}

ExitCode explain_scene(const explain::Explainer& explainer, const ExplainArguments& arguments) {
  check_name(arguments.file);
  MeshArguments mesh;
  mesh.eye = eye_of(arguments.camera);
  const scene::LoadedScene source = load_scene_of(explainer, arguments.scene, mesh);
  const scene::PolyCamera camera = camera_of(arguments.camera, source.scene, source.name);
  Output output(arguments.file);
  std::optional<base::ProgressClock> clock(fmt::format("making the lesson of {}", explainer.algorithm));
  explain::Lesson lesson = value_of(explain::explain_scene(explainer, source, camera), source.name);
  lesson.scene = source.name;
  clock.reset();
  write_lesson(lesson, arguments.file, output);
  return ExitCode::ok;
}

ExitCode explain_heights(const explain::Explainer& explainer, const ExplainArguments& arguments) {
  check_name(arguments.file);
  require_angles(arguments.rotation, arguments.elevation);
  const SkalaFunction function = load_skala_function(arguments.source, {17, 13}, algorithms::skala::smoothed_family({.rotation = arguments.rotation}));
  Output output(arguments.file);
  explain::Lesson lesson = value_of(explainer.heights(function.grid, arguments.rotation, arguments.elevation), function.name);
  lesson.scene = function.name;
  write_lesson(lesson, arguments.file, output);
  return ExitCode::ok;
}

}  // namespace

void add_explain_command(const Command& program) {
  const Command command = program.add_command("explain", help_page("explain"));
  for (const explain::Explainer& explainer : explain::explainers()) {
    const auto arguments = std::make_shared<ExplainArguments>();
    const std::string name(explainer.algorithm);
    const bool of_heights = explainer.heights != nullptr;
    const Command one = command.add_command(
        name, help_page(of_heights ? "explain_heights" : "explain_scene",
                        {{"summary", std::string(explainer.summary)}, {"method", name}, {"camera", help_page("camera").summary}}));
    if (of_heights) {
      one.option("GRID", arguments->source.name_or_file, "A function by name, or a file of heights");
      add_function_options(one, arguments->source, "13", "17");
      add_angle_options(one, arguments->rotation, arguments->elevation);
    } else {
      one.option("SCENE", arguments->scene, scene_help).required();
      add_camera_options(one, arguments->camera);
    }
    one.option("-o,--output", arguments->file, "The lesson: .html for a browser, .json for other programs, - for JSON on standard output")
        .required()
        .value("FILE");
    one.run([arguments, &explainer] {
      return explainer.heights != nullptr ? explain_heights(explainer, *arguments) : explain_scene(explainer, *arguments);
    });
  }
}

}  // namespace sightline::app
