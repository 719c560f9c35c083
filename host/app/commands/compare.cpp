#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/compare_output.hpp"
#include "host/app/commands/draw_camera.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/eae_option.hpp"
#include "host/app/scene_argument.hpp"
#include "host/app/scene_source.hpp"
#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {

namespace {

using base::Json;
using guests::skala::PictureKind;

constexpr const char* compare_examples =
    "Examples:\n"
    "  sightline compare\n"
    "      every built-in scene and function: how wrong the old programs are, and that the new ones are not\n"
    "  sightline compare roberts street4 --view 120,90,60 --scale 700 -o pictures\n"
    "      Jones's program on the PDP-7, its twin and the native algorithms from one place\n"
    "  sightline compare sinc heights.csv --rotate 120 --elevate 45\n"
    "      Skala's program on the 8080, its twin and the native algorithm\n"
    "  sightline compare --function \"sin(x)*cos(z)\" --picture contours --levels 12\n"
    "      contours of a function of your own: by points, and the native ones by lines\n"
    "  sightline compare part.off boxes-100 --json\n"
    "      polyhedra: the exact algorithms by lines, faces by points\n"
    "  sightline compare boxes-30 --orthographic 3,0,4\n"
    "      in parallel projection, Plantinga's turns among them\n\n"
    "SCENE is a built-in scene, a JSON, OFF or OBJ file, a generated scene such as boxes-100, a function by "
    "name, or a "
    "grid file. --function and the options after it, up to --levels, are those of `sightline skala`. Every "
    "picture is held against an oracle that shares no visibility code with anything. The guest is the old "
    "program "
    "on its emulated machine, its twin the same computation written again for this computer, bit for bit; "
    "native are the methods of the papers and exact ones of today, written for this computer.\n\n"
    "Of every picture:\n"
    "  missing, extra     length of lines that are seen but not drawn, and drawn but not seen, along the "
    "true "
    "lines\n"
    "  miss >1, extra >1  the part of it that is farther than a pixel from anything drawn, or seen\n"
    "  H, 99.9 %          the farthest any point of one picture is from the other; all but a thousandth are "
    "nearer\n"
    "  wrong points       of random points of all lines, those drawn though hidden or not drawn though seen\n"
    "  pieces             pieces of lines that have no counterpart with the same ends\n"
    "Overlays are NAME-compare-PICTURE.png and .svg: grey where both agree, orange what is missing, blue "
    "what is extra;\n"
    "stretches of up to a pixel are left out of them. The exit code is 1 if an exact algorithm does not give "
    "the\n"
    "oracle's picture, or a guest not its twin's: defects of this program. Old programs may be wrong.\n";

struct CompareArguments {
  std::vector<std::string> scenes;
  std::string view;
  std::string orthographic;
  std::optional<int> scale;
  bool no_eae = false;
  SkalaSource function;  // without a name: names are among the scenes
  guests::skala::View function_view;
  std::string picture;  // as --picture names it
  SkalaSlices slices;
  std::optional<int> levels;
  std::string directory = "out";
  bool json = false;
};

// What is being done, on a terminal only; gone when it is over.
class CompareProgressLine {
 public:
  CompareProgressLine() {
    const char* const kind = std::getenv("TERM");
    terminal_ = isatty(STDERR_FILENO) != 0 && kind != nullptr && std::string_view(kind) != "dumb";
  }
  ~CompareProgressLine() { clear(); }
  CompareProgressLine(const CompareProgressLine&) = delete;
  CompareProgressLine& operator=(const CompareProgressLine&) = delete;

  void show(std::size_t number, std::size_t count, std::string_view name, std::string_view step) {
    if (!terminal_) return;
    fmt::print(stderr, "\r\033[K{} of {}: {}, {}", number, count, name, step);
    static_cast<void>(std::fflush(stderr));
    shown_ = true;
  }
  void clear() {
    if (shown_) fmt::print(stderr, "\r\033[K");
    shown_ = false;
  }

 private:
  bool terminal_ = false;
  bool shown_ = false;
};

std::vector<std::string> every_builtin() {
  std::vector<std::string> names;
  for (const std::string_view name : scene::builtin_scene_names()) names.emplace_back(name);
  for (const auto& function : scene::height_functions().first(scene::figure_functions))
    names.emplace_back(function.name);
  return names;
}

bool is_height_function(const std::string& name) {
  if (scene::builtin_scene_text(name)) return false;
  if (scene::height_function(name)) return true;
  std::error_code unknown;
  const auto ends = [&](std::string_view ending) { return name.ends_with(ending); };
  return std::filesystem::exists(name, unknown) && !ends(".json") && !ends(".off") && !ends(".obj");
}

void refuse(bool given, const char* option, const std::string& name, const char* expected) {
  if (given)
    throw Failure(ExitCode::usage, fmt::format("{}: found with {}, expected {}", option, name, expected));
}

struct ComparedScene {
  bool agrees = true;
  std::string table;
  Json json;
  std::vector<std::string> overlays;
};

// `source` is by name, from a file or an expression.
ComparedScene compare_function(const CompareArguments& arguments, const SkalaSource& source,
                               const compare::CompareProgress& progress) {
  const std::string& name = source.expression.empty() ? source.name_or_file : source.expression;
  refuse(!arguments.view.empty(), "--view", name, "--rotate and --elevate for a function");
  refuse(!arguments.orthographic.empty(), "--orthographic", name, "--rotate and --elevate for a function");
  refuse(arguments.scale.has_value(), "--scale", name, "a scene of cells");
  refuse(arguments.no_eae, "--no-eae", name, "a scene of cells");
  guests::skala::View view = arguments.function_view;
  view.family = family_of(arguments.slices);
  if (arguments.levels) view.levels = *arguments.levels;
  const SkalaFunction function = load_skala_function(source, usual_grid_size(view.picture));
  if (const auto reason = compare::why_not_comparable(function.grid, view))
    throw Failure(ExitCode::bad_input, fmt::format("{}: {}", name, *reason));
  const auto comparison = compare::compare_heights(function.grid, view, progress);
  return {comparison.agrees(), compare_table(function.name, comparison),
          compare_json(function.name, comparison),
          write_overlays(arguments.directory, function.stem, comparison)};
}

// Of the functions among the scenes: only what is sampled has a size to choose.
SkalaSource source_of(const CompareArguments& arguments, const std::string& name) {
  SkalaSource source;
  source.name_or_file = name;
  source.points = arguments.function.points;
  source.slices = arguments.function.slices;
  return source;
}

ComparedScene compare_scene(const CompareArguments& arguments, const std::string& name,
                            const compare::CompareProgress& progress) {
  refuse(arguments.function.points || arguments.function.slices, "--points or --slices", name,
         "a function, which is sampled");
  const SceneSource source = load_scene_source(name);
  const auto compared = [&] {
    if (source.cells) {
      refuse(!arguments.orthographic.empty(), "--orthographic", name,
             "polyhedra; Jones's program looks along +z in perspective");
      compare::CompareOptions options;
      if (!arguments.view.empty()) options.eye = point_argument("--view", arguments.view);
      if (arguments.scale) options.scale = *arguments.scale;
      options.eae = !arguments.no_eae;
      return compare::compare_cell_scene(*source.cells, options, progress);
    }
    refuse(arguments.scale.has_value(), "--scale", name, "a scene of cells; others fill the picture");
    refuse(arguments.no_eae, "--no-eae", name, "a scene of cells, which the PDP-7 can draw");
    CameraArguments camera;
    camera.eye = arguments.view;
    camera.orthographic = arguments.orthographic;
    return compare::compare_poly_scene(source.scene, camera_of(camera, source.scene, name), progress);
  }();
  if (!compared) {
    base::Error named = compared.error();
    named.file = name;
    throw Failure(ExitCode::bad_input, named.message());
  }
  auto comparison = *compared;
  if (!source.cells) comparison.scene = std::filesystem::path(name).stem().string();
  return {comparison.agrees(), compare_table(comparison), compare_json(comparison),
          write_overlays(arguments.directory, comparison)};
}

// One scene or function; the last is --function's if there is no name left.
ComparedScene compare_next(const CompareArguments& arguments, const std::vector<std::string>& names,
                           std::size_t n, const compare::CompareProgress& progress) {
  if (n == names.size()) return compare_function(arguments, arguments.function, progress);
  if (is_height_function(names[n]))
    return compare_function(arguments, source_of(arguments, names[n]), progress);
  return compare_scene(arguments, names[n], progress);
}

ExitCode run_compare(CompareArguments arguments) {
  if (arguments.picture == "surface") arguments.function_view.picture = guests::skala::PictureKind::surface;
  if (arguments.picture == "contours") arguments.function_view.picture = guests::skala::PictureKind::contours;
  require_angles(arguments.function_view.rotation, arguments.function_view.elevation);
  if (arguments.levels && arguments.function_view.picture != guests::skala::PictureKind::contours)
    throw Failure(ExitCode::usage, "--levels: found without --picture contours");
  const bool expression = !arguments.function.expression.empty();
  if (!expression && !arguments.function.domain.empty())
    throw Failure(ExitCode::usage, "--domain: found without --function; names and grid files have their own");
  const auto names = arguments.scenes.empty() && !expression ? every_builtin() : arguments.scenes;
  Json document{{"schema", "sightline/compare/1"}, {"agrees", true}, {"scenes", Json::array()}};
  bool agrees = true;
  CompareProgressLine line;
  const std::size_t count = names.size() + (expression ? 1 : 0);
  for (std::size_t n = 0; n < count; ++n) {
    const std::string& name = n < names.size() ? names[n] : arguments.function.expression;
    const auto progress = [&](std::string_view step) { line.show(n + 1, count, name, step); };
    ComparedScene compared = compare_next(arguments, names, n, progress);
    line.clear();
    agrees = agrees && compared.agrees;
    if (arguments.json) {
      compared.json["overlays"] = compared.overlays;
      document["scenes"].push_back(std::move(compared.json));
      continue;
    }
    write_stdout((n > 0 ? "\n" : "") + compared.table);
    for (const std::string& path : compared.overlays)
      if (path.ends_with(".png")) write_stdout(fmt::format("overlay {}, .svg\n", path));
  }
  document["agrees"] = agrees;
  if (arguments.json) print_json(document);
  if (agrees) return ExitCode::ok;
  complain("an exact algorithm is not exact, or a guest is not its twin: see above");
  return ExitCode::differs;
}

void add_compare_options(const Command& command, CompareArguments& arguments) {
  command.option("SCENE", arguments.scenes, "Scenes and functions").default_value("all built-in ones");
  command.option("--view,--eye", arguments.view, "The eye in a scene")
      .default_value("the scene's own view")
      .value("X,Y,Z");
  command
      .option("--orthographic", arguments.orthographic,
              "Polyhedra in parallel projection along this direction, as turns want it")
      .value("X,Y,Z");
  command.option("--scale", arguments.scale, "Scale factor of a scene of cells; 512 shows 90 degrees")
      .default_value("512")
      .range(64, 4096);
  add_eae_options(command, arguments.no_eae);
  guests::skala::View& view = arguments.function_view;
  constexpr scene::GridSize usual = usual_grid_size(guests::skala::PictureKind::lines);
  constexpr scene::GridSize of_contours = usual_grid_size(guests::skala::PictureKind::contours);
  add_function_options(command, arguments.function,
                       fmt::format("{}, of contours {}", usual.slices, of_contours.slices),
                       std::to_string(usual.points));
  add_angle_options(command, view.rotation, view.elevation);
  add_picture_option(command, arguments.picture, "What is drawn of a function");
  add_slices_options(command, arguments.slices);
  add_levels_option(command, arguments.levels);
  command.option("-o,--output", arguments.directory, "Folder for the overlays").default_value().value("DIR");
  command.flag("--json", arguments.json, "One JSON document instead of the tables");
}

}  // namespace

void add_compare_command(const Command& program) {
  const Command command = program.add_command(
      "compare",
      "Hold the old programs (guest and twin) and the native methods against the oracle, on one view");
  const auto arguments = std::make_shared<CompareArguments>();
  arguments->function_view.rotation = 30;
  add_compare_options(command, *arguments);
  command.footer(compare_examples);
  command.run([arguments] { return run_compare(*arguments); });
}

}  // namespace sightline::app
