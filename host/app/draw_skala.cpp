#include "host/app/draw_skala.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>

#include "host/algorithms/skala/draw.hpp"
#include "host/app/draw_output.hpp"
#include "host/app/skala_options.hpp"
#include "host/app/skala_source.hpp"

namespace sightline::app {

namespace {

using algorithms::skala::Family;
using algorithms::skala::Subject;

constexpr const char* draw_skala_examples =
    "Examples:\n"
    "  sightline draw skala sinc -o sinc.svg\n"
    "      slices of a function by name, in layers for a drawing program\n"
    "  sightline draw skala heights.csv --along both --rotate 120 -o net.plt\n"
    "      the net of a grid file, for a plotter\n"
    "  sightline draw skala --function \"sin(x)*cos(z)\" --picture contours --levels 12 -o map.png\n"
    "      contours of a function of your own\n"
    "  sightline draw skala peaks --points 512 --slices 512 --picture surface --pixels 2000x1500 -o "
    "peaks.png\n"
    "      a shaded surface\n\n"
    "GRID is a function by name (sinc rogers peaks franke saddle cosr step rosen flat spike gauss terrain) "
    "or a "
    "file:\nCSV or gnuplot's matrix, a line a slice, the first one in front, nan for a hole. --slices and "
    "--points say how finely\na function is sampled; a file has its own size. The drawing is stretched to "
    "the "
    "paper.\n";

struct DrawSkalaArguments {
  SkalaSource source;
  algorithms::skala::View view;
  bool no_visibility = false;
  bool no_rims = false;
  DrawOutput output;
};

ExitCode run_draw_skala(DrawSkalaArguments arguments) {
  algorithms::skala::View& view = arguments.view;
  require_angles(view.rotation, view.elevation);
  view.visibility = !arguments.no_visibility;
  view.rims = !arguments.no_rims;
  const DrawingFormat format = settled(arguments.output);
  if (format == DrawingFormat::hpgl && view.subject == Subject::surface)
    throw Failure(ExitCode::usage, "--picture surface: a plotter draws lines only, expected .svg or .png");
  const SkalaFunction function = load_skala_function(arguments.source, {65, 65});
  write_drawing(algorithms::skala::draw(function.grid, view), arguments.output, format, function.name);
  return ExitCode::ok;
}

void add_view_options(CLI::App& command, DrawSkalaArguments& arguments) {
  algorithms::skala::View& view = arguments.view;
  command.add_option("--picture", view.subject, "lines, surface or contours; unless given lines")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Subject>{
          {"lines", Subject::lines}, {"surface", Subject::surface}, {"contours", Subject::contours}}))
      ->type_name("NAME");
  command
      .add_option("--along", view.family,
                  "Slices along x, z or both; unless given along the one that is less end-on")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Family>{
          {"x", Family::along_x}, {"z", Family::along_z}, {"both", Family::both}}))
      ->type_name("NAME");
  add_angle_options(command, view.rotation, view.elevation);
  add_levels_option(command, view.levels);
  command.add_flag("--net", view.net, "Contours: draw the net of all cells, too");
  command.add_flag("--silhouette", view.silhouette, "Draw where the surface turns away from the eye");
  command.add_flag("--no-rims", arguments.no_rims, "Leave out the surface's own edges between slices");
  command.add_flag("--no-visibility", arguments.no_visibility, "Draw what is hidden, too");
  command.add_option("--columns", view.columns, "Of the masks: how finely hidden parts are found")
      ->capture_default_str()
      ->check(CLI::Range(algorithms::skala::fewest_columns, algorithms::skala::most_columns));
}

}  // namespace

void add_draw_skala(CLI::App& command, ExitCode& exit_code) {
  const auto arguments = std::make_shared<DrawSkalaArguments>();
  arguments->view.rotation = 30;
  command.add_option("GRID", arguments->source.name_or_file, "A function by name, or a file of heights");
  add_function_options(command, arguments->source, "65", "65");
  add_view_options(command, *arguments);
  add_draw_output_options(command, arguments->output);
  command.footer(draw_skala_examples);
  command.callback([arguments, &exit_code] { exit_code = run_draw_skala(*arguments); });
}

}  // namespace sightline::app
