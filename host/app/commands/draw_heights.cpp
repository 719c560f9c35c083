// `sightline draw METHOD GRID`: a surface over a grid with its hidden parts removed, by a method of the
// registry.
#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "host/app/commands/draw.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/commands/skala_source.hpp"
#include "host/base/json.hpp"

namespace sightline::app {

namespace {

using algorithms::skala::Family;
using algorithms::skala::Subject;

struct DrawHeightsArguments {
  SkalaSource source;
  registry::HeightView view;
  std::string picture;
  std::string along;
  bool json = false;
  bool no_visibility = false;
  bool no_rims = false;
  DrawOutput output;
};

// By the names the options take; empty: not given.
Subject subject_named(const std::string& name) {
  if (name == "surface") return Subject::surface;
  return name == "contours" ? Subject::contours : Subject::lines;
}

Family slices_named(const std::string& name) {
  if (name.empty()) return Family::automatic;
  if (name == "both") return Family::both;
  return name == "x" ? Family::along_x : Family::along_z;
}

void print_drawing(const registry::HeightMethod& method, const DrawHeightsArguments& arguments,
                   const SkalaFunction& function, const picture::VectorDrawing& drawing,
                   const std::optional<base::Json>& plot) {
  using base::Json;
  Json document{{"schema", "sightline/draw/1"},
                      {"algorithm", method.algorithm},
                      {"scene", function.name},
                      {"output", arguments.output.file},
                      {"picture", arguments.picture.empty() ? "lines" : arguments.picture},
                      {"slices", function.grid.slices()},
                      {"points", function.grid.points()},
                      {"rotation", arguments.view.rotation},
                      {"elevation", arguments.view.elevation},
                      {"counts", {{"lines", drawing.lines.size()}, {"facets", drawing.facets.size()}}}};
  if (plot) document["plot"] = *plot;
  // Names of functions and files come from the user: what is no UTF-8 is shown as far as it can be.
  print_json(document);
}

ExitCode run_draw_heights(const registry::HeightMethod& method, DrawHeightsArguments arguments) {
  registry::HeightView& view = arguments.view;
  view.subject = subject_named(arguments.picture);
  view.family = slices_named(arguments.along);
  require_angles(view.rotation, view.elevation);
  view.visibility = !arguments.no_visibility;
  view.rims = !arguments.no_rims;
  const DrawingFormat format = read_draw_output(arguments.output);
  if (arguments.output.file == "-" && arguments.json) throw Failure(ExitCode::usage, "--output: found - with --json, expected a file");
  if ((format == DrawingFormat::hpgl || format == DrawingFormat::dxf) && view.subject == Subject::surface)
    throw Failure(ExitCode::usage, "--picture surface: a plotter draws lines only, expected .svg, .pdf or .png");
  if (view.subject != Subject::contours) {
    refuse_option(arguments.output, "--levels", "--picture contours");
    refuse_option(arguments.output, "--net", "--picture contours");
  }
  const SkalaFunction function = load_skala_function(arguments.source, {65, 65});
  Output file(arguments.output.file);
  if (const auto reason = method.why_not(function.grid, view))
    throw Failure(ExitCode::usage,
                  fmt::format("{}: {} does not apply: {}", function.name, method.algorithm, *reason));
  const registry::HeightPicture picture = method.draw(function.grid, view);
  const auto plot = write_drawing(*picture.drawing, arguments.output, format, function.name, file);
  if (arguments.json) print_drawing(method, arguments, function, *picture.drawing, plot);
  return ExitCode::ok;
}

void add_view_options(const Command& command, DrawHeightsArguments& arguments) {
  registry::HeightView& view = arguments.view;
  add_picture_option(command, arguments.picture, "What is drawn");
  command.option("--along", arguments.along, "Slices along x, along z or both")
      .one_of({"x", "z", "both"})
      .default_value("the less end-on");
  add_angle_options(command, view.rotation, view.elevation);
  add_levels_option(command, view.levels);
  command.flag("--net", view.net, "Contours: draw the net of all cells, too");
  command.flag("--silhouette", view.silhouette, "Draw where the surface turns away from the eye");
  command.flag("--no-rims", arguments.no_rims, "Leave out the surface's own edges between slices");
  command.flag("--no-visibility", arguments.no_visibility, "Draw hidden lines, too");
  command.option("--columns", view.columns, "Columns of the horizon masks; more columns find hidden parts more finely")
      .default_value()
      .range(algorithms::skala::fewest_columns, algorithms::skala::most_columns);
}

}  // namespace

void add_draw_heights(const Command& command, const registry::HeightMethod& method) {
  const auto arguments = std::make_shared<DrawHeightsArguments>();
  arguments->view.rotation = 30;
  command.option("GRID", arguments->source.name_or_file, "A function by name, or a file of heights");
  add_function_options(command, arguments->source, "65", "65");
  add_view_options(command, *arguments);
  add_draw_output_options(command, arguments->output);
  command.flag("--json", arguments->json, "Print what was drawn as one JSON document on standard output");
  command.run([arguments, &method] { return run_draw_heights(method, *arguments); });
}

}  // namespace sightline::app
