// `sightline compare`: compares the programs on emulated machines and the native methods with oracles.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "host/algorithms/skala/surface.hpp"
#include "host/app/commands/answer_output.hpp"
#include "host/app/commands/commands.hpp"
#include "host/app/commands/compare_output.hpp"
#include "host/app/commands/draw.hpp"
#include "host/app/commands/random_views.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/base/nearest_name.hpp"
#include "host/base/progress.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"
#include "host/compare/answer.hpp"
#include "host/compare/answer_plot.hpp"
#include "host/compare/hard_cases/manifest.hpp"
#include "host/compare/hard_cases/run_case.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/compare/variants.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {

namespace {

using base::Json;
using algorithms::skala::Subject;

struct CompareArguments {
  std::vector<std::string> scenes;
  MeshArguments mesh;
  CameraArguments camera;
  std::optional<int> scale;
  bool no_eae = false;
  SkalaSource function;  // without a name: functions by name are in `scenes`
  algorithms::skala::View function_view;
  std::string picture;  // the value of --picture
  SkalaSlices slices;
  std::optional<int> levels;
  std::optional<int> fraction;
  std::vector<std::string> methods;
  std::uint64_t views = 0;  // 0: one view, that of the camera options
  std::optional<std::uint64_t> only_view;  // number of a random view
  RandomViewOptions random;
  bool no_host_times = false;
  bool all = false;  // write all pictures, also those without a difference
  std::string plot;  // empty: none
  std::string directory = "out";
  bool json = false;
};

std::vector<std::string> every_builtin() {
  std::vector<std::string> names;
  for (const std::string_view name : scene::builtin_scene_names()) names.emplace_back(name);
  for (const auto& function : scene::height_functions().first(scene::figure_functions))
    names.emplace_back(function.name);
  return names;
}

void reject(bool given, const char* option, const std::string& name, std::string_view expected) {
  if (given)
    throw base::usage_error(fmt::format("{}: found with {}, expected {}", option, name, expected));
}

// Rejects camera options: all of them for functions, all but the eye for scenes of cells.
void reject_camera(const CameraArguments& camera, bool eye, const std::string& name, std::string_view expected) {
  const bool point = camera.view.find(',') != std::string::npos;
  reject(eye && !camera.eye.empty(), "--eye", name, expected);
  reject(!camera.view.empty() && (eye || !point), "--view", name, expected);
  reject(!camera.look_at.empty(), "--look-at", name, expected);
  reject(!camera.orthographic.empty(), "--orthographic", name, expected);
  reject(!camera.forward.empty() || !camera.right.empty() || !camera.up.empty(), "--up or --forward", name, expected);
  reject(!camera.vertical.empty(), "--vertical", name, expected);
  reject(camera.steps, "--steps", name, expected);
}

// Makes unique names for the overlays of one call, so that those of d1/part.off and d2/part.off are different files.
class OverlayNames {
 public:
  // `name`, with a number appended if an earlier scene has this name.
  std::string unused(const std::string& name) {
    std::string free = name;
    for (int n = 2; !used_.insert(free).second; ++n) free = fmt::format("{}-{}", name, n);
    return free;
  }

 private:
  std::set<std::string> used_;
};

// All results for one scene or function.
struct ComparedScene {
  bool agrees = true;
  std::string nothing;  // why none of the requested methods applies; empty: one does
  std::string heading;
  std::string notes;
  Json json;
  std::vector<std::string> overlays;
  std::vector<compare::PlotPoint> plotted;  // only if a plot is requested
};

compare::CompareOptions options_of(const CompareArguments& arguments) {
  compare::CompareOptions options;
  if (arguments.scale) options.scale = *arguments.scale;
  options.eae = !arguments.no_eae;
  options.fraction_bits = static_cast<std::uint32_t>(arguments.fraction.value_or(3));
  options.methods = arguments.methods;
  options.host_times = !arguments.no_host_times;
  return options;
}

bool is_chosen(const CompareArguments& arguments, const std::string& method) {
  return arguments.methods.empty() || std::find(arguments.methods.begin(), arguments.methods.end(), method) != arguments.methods.end();
}

// The methods that were omitted: the first reason of each, and the number of views.
class OmittedMethods {
 public:
  // Begins with the requested methods that do not draw this kind of scene at all.
  OmittedMethods(const CompareArguments& arguments, compare::SceneKind kind) {
    for (const std::string& method : arguments.methods)
      if (const auto reason = compare::why_not_applicable(method, kind)) reasons_.push_back({method, *reason, 0});
  }
  void add(const std::vector<std::pair<std::string, std::string>>& not_applicable) {
    for (const auto& [method, reason] : not_applicable) {
      const auto known = std::find_if(reasons_.begin(), reasons_.end(), [&m = method](const Reason& r) { return r.method == m; });
      if (known == reasons_.end())
        reasons_.push_back({method, reason, 1});
      else
        ++known->views;
    }
  }
  // The first reason; empty if there is none.
  [[nodiscard]] std::string first() const {
    return reasons_.empty() ? std::string() : fmt::format("{} does not apply: {}", reasons_.front().method, reasons_.front().reason);
  }
  // The lines of the output; `all`: the number of views.
  [[nodiscard]] std::string text(std::uint64_t all) const {
    std::string lines;
    for (const Reason& r : reasons_)
      lines += r.views == 0 || all == 1 ? fmt::format("{} not compared: {}\n", r.method, r.reason)
                                        : fmt::format("{} not compared in {} of {} views: {}\n", r.method, r.views, all, r.reason);
    return lines;
  }
  [[nodiscard]] Json json() const {
    Json list = Json::array();
    for (const Reason& r : reasons_) list.push_back({{"name", r.method}, {"reason", r.reason}, {"views", r.views}});
    return list;
  }

 private:
  struct Reason {
    std::string method;
    std::string reason;
    std::uint64_t views = 0;  // 0: all views
  };
  std::vector<Reason> reasons_;
};

// The result for a scene or function that none of the requested methods draws.
ComparedScene empty_comparison(const std::string& name, const OmittedMethods& omitted, Json json) {
  ComparedScene compared;
  compared.nothing = omitted.first();
  compared.heading = name + ": nothing to compare\n";
  compared.notes = omitted.text(1);
  compared.json = std::move(json);
  return compared;
}

// Calls `view` for the views 0 to `many` - 1.
template <class View>
void compare_views(std::uint64_t many, const compare::CompareProgress& progress, View&& view) {
  for (std::uint64_t number = 0; number < many; ++number)
    view(number, [&](std::string_view step) { progress(fmt::format("view {} of {}, {}", number + 1, many, step)); });
}

std::string views_heading(const std::string& name, const CompareArguments& arguments) {
  return fmt::format("{}, {} random views of seed {}: the median, and the greatest in brackets\n", name, arguments.views, arguments.random.seed);
}

// Rejects files that are inputs of hard cases, but neither scenes nor grids.
void reject_case_inputs(const std::string& name) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(name, unknown)) return;
  const std::string_view kind = compare::kind_of_commands(read_input_text(name));
  if (kind.empty()) return;
  const std::string file = std::filesystem::path(name).filename().string();
  const bool known = !compare::hard_case_text(file).empty();
  throw base::bad_input(fmt::format("{}: found {}, expected a scene or a grid; {}", name, kind,
                                                 known ? fmt::format("`sightline hard {}` takes this file", std::filesystem::path(file).stem().string())
                                                       : "`sightline hard --list` shows the cases of such files"));
}

std::vector<compare::MethodView> chosen_rows(const CompareArguments& arguments, const compare::HeightComparison& comparison) {
  auto views = method_views(comparison);
  std::erase_if(views, [&](const compare::MethodView& row) { return !is_chosen(arguments, row.method.substr(0, row.method.find(' '))); });
  return views;
}

// `source`: a function by name, a grid file or an expression.
ComparedScene compare_function(const CompareArguments& arguments, const SkalaSource& source, OverlayNames& overlays,
                               const compare::CompareProgress& progress, compare::Answer& answer) {
  const std::string& name = source.expression.empty() ? source.name_or_file : source.expression;
  reject_camera(arguments.camera, true, name, "--rotate and --elevate for a function");
  reject(arguments.scale.has_value(), "--scale", name, "a scene of cells");
  reject(arguments.no_eae, "--no-eae", name, "a scene of cells");
  reject(arguments.fraction.has_value(), "--fraction", name, "a scene of cells");
  algorithms::skala::View view = arguments.function_view;
  view.family = family_of(arguments.slices);
  if (arguments.levels) view.levels = *arguments.levels;
  if (source.expression.empty()) reject_case_inputs(name);
  const SkalaFunction function = load_skala_function(source, usual_grid_size(view.subject), algorithms::skala::smoothed_family(view));
  if (const auto reason = compare::why_not_comparable(function.grid, view))
    throw base::bad_input(fmt::format("{}: {}; `sightline skala --check` draws it and compares it with its twin", name, *reason));
  const auto compare_view = [&](const algorithms::skala::View& of, std::uint64_t number, const compare::CompareProgress& step) {
    auto comparison = compare::compare_heights(function.grid, of, step, function.sampled, !arguments.no_host_times);
    comparison.devices = compare::compare_devices(function.grid, of, step);
    answer.add(function.name, number, chosen_rows(arguments, comparison));
    return comparison;
  };
  const OmittedMethods omitted(arguments, compare::SceneKind::function);
  if (arguments.random.turn || arguments.random.level)
    throw base::usage_error(fmt::format("{}: found {}, expected a scene", arguments.random.turn ? "--turn" : "--level", name));
  if (arguments.views == 0) {
    if (arguments.only_view) view = compare::random_height_view(function.grid, view, arguments.random.seed, *arguments.only_view);
    const auto comparison = compare_view(view, arguments.only_view.value_or(0), progress);
    if (answer.rows().empty()) return empty_comparison(function.name, omitted, compare_json(function.name, comparison));
    ComparedScene compared{comparison.agrees(), "", compare_heading(function.name, comparison),
                           compare_notes(comparison, chosen_rows(arguments, comparison)) + omitted.text(1),
                           compare_json(function.name, comparison),
                           write_overlays(arguments.directory, overlays.unused(function.stem), comparison, arguments.all), {}};
    if (!arguments.plot.empty()) compared.plotted = compare::variants_of(comparison);
    std::erase_if(compared.plotted, [&](const compare::PlotPoint& point) { return !is_chosen(arguments, point.series); });
    return compared;
  }
  ComparedScene compared;
  compared.heading = views_heading(function.name, arguments);
  compared.json = {{"function", function.name}, {"views", arguments.views}, {"seed", arguments.random.seed}};
  compare_views(arguments.views, progress, [&](std::uint64_t number, const compare::CompareProgress& step) {
    const auto of = compare::random_height_view(function.grid, view, arguments.random.seed, number);
    compared.agrees = compare_view(of, number, step).agrees() && compared.agrees;
  });
  if (answer.rows().empty()) return empty_comparison(function.name, omitted, std::move(compared.json));
  compared.notes = omitted.text(arguments.views);
  return compared;
}

// The source of a function named among the scenes. Only sampled functions have --points and --slices.
SkalaSource source_of(const CompareArguments& arguments, const std::string& name) {
  SkalaSource source;
  source.name_or_file = name;
  source.points = arguments.function.points;
  source.slices = arguments.function.slices;
  return source;
}

ComparedScene compare_scene(const CompareArguments& arguments, const std::string& name, OverlayNames& overlays,
                            const compare::CompareProgress& progress, compare::Answer& answer) {
  reject(arguments.function.points || arguments.function.slices, "--points or --slices", name,
         "a function, which is sampled");
  MeshArguments mesh = arguments.mesh;
  mesh.eye = eye_of(arguments.camera);
  scene::LoadedScene source = load_scene(name, mesh);
  const compare::Directions directions = directions_of(arguments.random, source);
  const std::optional<scene::CellScene> cells = source.cells;
  if (directions != compare::Directions::usual) source.cells.reset();  // its polyhedra are compared instead
  if (source.cells) {
    reject_camera(arguments.camera, false, name, "polyhedra; Jones's program looks along +z in perspective");
  } else {
    reject(arguments.scale.has_value(), "--scale", name, "a scene of cells; others fill the picture");
    reject(arguments.no_eae, "--no-eae", name, "a scene of cells, which the PDP-7 can draw");
    reject(arguments.fraction.has_value(), "--fraction", name, "a scene of cells, which the PDP-7 can draw");
  }
  const compare::CompareOptions options = options_of(arguments);
  progress("prepared");
  const compare::SceneMethods methods = value_of(
      source.cells ? compare::SceneMethods::of(*source.cells, options) : compare::SceneMethods::of(source.scene, options), name);
  const std::string shown = source.cells ? source.cells->name : std::filesystem::path(name).stem().string();
  const auto compare_view = [&](const scene::PolyCamera& camera, std::uint64_t number, const compare::CompareProgress& step) {
    auto comparison = value_of(methods.view(camera, step), name);
    comparison.scene = shown;
    answer.add(shown, number, method_views(comparison));
    return comparison;
  };
  OmittedMethods omitted(arguments, source.cells ? compare::SceneKind::cells : compare::SceneKind::polyhedra);
  const auto random_camera = [&](std::uint64_t number) {
    return compare::random_camera(source.scene, cells ? &*cells : nullptr, directions, arguments.random.seed, number);
  };
  if (arguments.views == 0) {
    scene::PolyCamera camera;
    if (arguments.only_view) {
      camera = random_camera(*arguments.only_view);
    } else if (source.cells) {
      const std::string& eye = arguments.camera.eye.empty() ? arguments.camera.view : arguments.camera.eye;
      camera.eye = eye.empty() ? source.cells->default_view : point_argument(arguments.camera.eye.empty() ? "--view" : "--eye", eye);
    } else {
      camera = camera_of(arguments.camera, source.scene, name);
    }
    const auto comparison = compare_view(camera, arguments.only_view.value_or(0), progress);
    omitted.add(comparison.not_applicable);
    if (answer.rows().empty()) return empty_comparison(shown, omitted, compare_json(comparison));
    ComparedScene compared{comparison.agrees(), "", compare_heading(comparison),
                           compare_notes(comparison) + omitted.text(1), compare_json(comparison),
                           write_overlays(arguments.directory, overlays.unused(shown), comparison, arguments.all), {}};
    if (arguments.plot.empty()) return compared;
    compared.plotted = source.cells ? compare::variants_of(*source.cells, options, comparison, progress)
                                    : compare::variants_of(source.scene, options, comparison, progress);
    return compared;
  }
  ComparedScene compared;
  compared.heading = views_heading(shown, arguments);
  compared.json = {{"scene", shown}, {"views", arguments.views}, {"seed", arguments.random.seed}};
  compare_views(arguments.views, progress, [&](std::uint64_t number, const compare::CompareProgress& step) {
    const auto comparison = compare_view(random_camera(number), number, step);
    omitted.add(comparison.not_applicable);
    compared.agrees = comparison.agrees() && compared.agrees;
  });
  compared.notes = omitted.text(arguments.views);
  compared.json["not_compared"] = omitted.json();
  if (answer.rows().empty()) return empty_comparison(shown, omitted, std::move(compared.json));
  return compared;
}

// Compares the n-th scene or function; the expression of --function comes after all names.
ComparedScene compare_next(const CompareArguments& arguments, const std::vector<std::string>& names, std::size_t n,
                           OverlayNames& overlays, const compare::CompareProgress& progress, compare::Answer& answer) {
  if (n == names.size()) return compare_function(arguments, arguments.function, overlays, progress, answer);
  if (is_height_function(names[n]))
    return compare_function(arguments, source_of(arguments, names[n]), overlays, progress, answer);
  return compare_scene(arguments, names[n], overlays, progress, answer);
}

void check_methods(const std::vector<std::string>& methods) {
  const std::vector<std::string> known = compare::method_names();
  for (const std::string& method : methods) {
    if (std::find(known.begin(), known.end(), method) != known.end()) continue;
    const std::string meant = base::did_you_mean(method, known);
    throw base::usage_error(fmt::format("--methods: found \"{}\", expected some of {}{}", method, base::joined(known, ", "),
                                               meant.empty() ? "" : "; " + meant));
  }
}

// The output of --plot; empty if not requested.
std::optional<Output> plot_output(const CompareArguments& arguments) {
  if (arguments.plot.empty()) return std::nullopt;
  if (arguments.plot == "-") throw base::usage_error("--plot: found -, expected a file: the table goes to standard output");
  if (arguments.views != 0) throw base::usage_error("--plot: found with --views, expected one view of each scene");
  return std::optional<Output>(std::in_place, arguments.plot);
}

ExitCode run_compare(CompareArguments arguments) {
  if (arguments.picture == "surface") arguments.function_view.subject = algorithms::skala::Subject::surface;
  if (arguments.picture == "contours") arguments.function_view.subject = algorithms::skala::Subject::contours;
  require_angles(arguments.function_view.rotation, arguments.function_view.elevation);
  if (arguments.levels && arguments.function_view.subject != algorithms::skala::Subject::contours)
    throw base::usage_error("--levels: found without --picture contours");
  const bool expression = !arguments.function.expression.empty();
  if (!expression && !arguments.function.domain.empty())
    throw base::usage_error("--domain: found without --function; names and grid files have their own");
  check_methods(arguments.methods);
  if (arguments.views != 0 && arguments.only_view) throw base::usage_error("--only-view: found with --views, expected one of them");
  if ((arguments.random.turn || arguments.random.level) && arguments.views == 0 && !arguments.only_view)
    throw base::usage_error(fmt::format("{}: found without random views, expected --views or --only-view",
                                               arguments.random.turn ? "--turn" : "--level"));
  if (arguments.views != 0 || arguments.only_view)
    reject_camera(arguments.camera, true, arguments.views != 0 ? "--views" : "--only-view", "random views, which have cameras of their own");
  const auto names = arguments.scenes.empty() && !expression ? every_builtin() : arguments.scenes;
  std::optional<Output> plot = plot_output(arguments);
  std::vector<compare::PlotPoint> plotted;
  Json document{{"schema", "sightline/compare/2"}, {"agrees", true}, {"table", Json::array()}, {"scenes", Json::array()}};
  bool agrees = true;
  bool compared_any = false;
  std::size_t pictures = 0;
  bool first_table = true;
  std::string text;     // messages about scenes without a table; an error if no scene has one
  std::string nothing;  // why the first of these scenes has none
  const std::size_t count = names.size() + (expression ? 1 : 0);
  OverlayNames overlays;
  for (std::size_t n = 0; n < count; ++n) {
    const std::string& name = n < names.size() ? names[n] : arguments.function.expression;
    compare::Answer answer;
    ComparedScene compared = [&] {
      base::ProgressLine line;
      const auto show = [&](std::string_view step) { line.show(fmt::format("{} of {}: {}, {}", n + 1, count, name, step)); };
      return compare_next(arguments, names, n, overlays, show, answer);
    }();
    if (nothing.empty() && !compared.nothing.empty()) nothing = fmt::format("{}: {}", name, compared.nothing);
    compared_any = compared_any || compared.nothing.empty();
    agrees = agrees && compared.agrees;
    plotted.insert(plotted.end(), compared.plotted.begin(), compared.plotted.end());
    if (arguments.json) {
      compared.json["overlays"] = compared.overlays;
      document["scenes"].push_back(std::move(compared.json));
      const Json rows = answer_json(answer.rows());
      for (const Json& row : rows.elements()) document["table"].push_back(row);
      continue;
    }
    if (answer.rows().empty()) {
      text += (n > 0 ? "\n" : "") + compared.heading + compared.notes;
      continue;
    }
    write_stdout(std::exchange(text, "") + (n > 0 ? "\n" : "") + compared.heading + answer_text(answer.rows()));
    if (std::exchange(first_table, false)) {
      write_stdout(
          "different: length that is missing or extra along the lines, or points; wrong: the part of it more than a pixel from what is right; "
          "farthest: a line's distance beside its place counts here only\n`sightline compare --help` explains all columns\n");
    }
    write_stdout(compared.notes);
    for (const std::string& path : compared.overlays)
      if (path.ends_with(".png")) write_stdout(fmt::format("picture {}\n", path));
    pictures += compared.overlays.size();
  }
  if (!compared_any) throw base::usage_error(nothing);
  write_stdout(text);
  document["agrees"] = agrees;
  if (plot) {
    const std::string title = count == 1 ? (expression ? arguments.function.expression : names.front()) + ": time against error"
                                         : fmt::format("Time against error, medians of {} scenes and functions", count);
    plot->write(value_of(compare::plot_svg(compare::medians_of(plotted), title), "--plot"));
    plot->commit();
    document["plot"] = arguments.plot;
    if (!arguments.json) write_stdout(fmt::format("plot {}\n", arguments.plot));
  }
  if (arguments.json) print_json(document);
  if (!arguments.json && arguments.views == 0 && pictures == 0)
    report_written(arguments.directory, "no pictures: nothing differs in any of them (--all writes them)");
  if (agrees) return ExitCode::ok;
  print_message("an exact algorithm is not exact, or a program on its machine differs from the same program in C++: see above");
  return ExitCode::differs;
}

void add_compare_options(const Command& command, CompareArguments& arguments) {
  command.option("SCENE", arguments.scenes, "Scenes and functions").default_value("all built-in ones");
  add_camera_options(command, arguments.camera);
  command.option("--scale", arguments.scale, "Scale factor of a scene of cells; 512 shows 90 degrees")
      .default_value("512")
      .range(64, 4096);
  add_mesh_options(command, arguments.mesh);
  add_eae_options(command, arguments.no_eae);
  algorithms::skala::View& view = arguments.function_view;
  constexpr scene::GridSize usual = usual_grid_size(algorithms::skala::Subject::lines);
  constexpr scene::GridSize of_contours = usual_grid_size(algorithms::skala::Subject::contours);
  add_function_options(command, arguments.function,
                       fmt::format("{}, of contours {}", usual.slices, of_contours.slices),
                       std::to_string(usual.points));
  add_angle_options(command, view.rotation, view.elevation);
  add_picture_option(command, arguments.picture, "What is drawn of a function");
  add_slices_options(command, arguments.slices);
  add_levels_option(command, arguments.levels);
  command.option("--fraction", arguments.fraction, "Fraction bits of the screen coordinates of Jones's program").default_value("3").range(0, 3).value("BITS");
  command.option("--methods", arguments.methods, "Only these: " + base::joined(compare::method_names(), ", "))
      .default_value("all that apply")
      .separated_by(',')
      .value("NAME,...");
  command.option("--views", arguments.views, "Compare this many random views instead of one: median and greatest values")
      .range(std::uint64_t{1}, std::uint64_t{100'000})
      .value("N");
  command.option("--only-view", arguments.only_view, "One of the random views, by its number in a sweep, from 0").check(whole_number_error).value("K");
  add_random_view_options(command, arguments.random);
  command.flag("--no-host-times", arguments.no_host_times, "Omit times of this computer: the same bytes in every run");
  command.option("--plot", arguments.plot, "Write time against error of every setting of the methods as SVG").value("FILE.svg");
  command.flag("--all", arguments.all, "Also write the pictures without a difference");
  command.option("-o,--output", arguments.directory, "Folder for the pictures").default_value().value("DIR");
  command.flag("--json", arguments.json, "One JSON document instead of the tables");
}

}  // namespace

void add_compare_command(const Command& program) {
  const Command command = program.add_command("compare", help_page("compare"));
  const auto arguments = std::make_shared<CompareArguments>();
  arguments->function_view.rotation = 30;
  add_compare_options(command, *arguments);
  command.run([arguments] { return run_compare(*arguments); });
}

}  // namespace sightline::app
