// `sightline draw METHOD GRID`: draws a surface over a grid with its hidden parts removed, by a method of the registry.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/skala/surface.hpp"
#include "host/app/commands/draw.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/commands/skala_source.hpp"
#include "host/base/json.hpp"
#include "host/base/number.hpp"
#include "host/scene/heights/round_values.hpp"

namespace sightline::app {

namespace {

using algorithms::skala::Family;
using algorithms::skala::Subject;

struct DrawHeightsArguments {
  std::vector<std::string> grids;
  SkalaSource source;  // the options that all grids share
  algorithms::skala::View view;
  std::string picture;
  std::string along;
  std::string colours;
  std::string aspect = "free";
  std::optional<double> contour_step;
  std::vector<std::string> axis_names;
  algorithms::skala::FigureOptions figure;
  bool no_legend = false;
  bool silhouette = false;
  bool no_silhouette = false;
  bool json = false;
  bool no_visibility = false;
  bool no_rims = false;
  DrawOutput output;
};

// Values of options by name; empty: not given.
Subject subject_named(const std::string& name) {
  if (name == "surface") return Subject::surface;
  return name == "contours" ? Subject::contours : Subject::lines;
}

Family slices_named(const std::string& name) {
  if (name.empty()) return Family::automatic;
  if (name == "both") return Family::both;
  return name == "x" ? Family::along_x : Family::along_z;
}

void reject_without_axes(const DrawOutput& output, const std::string& option, bool axes) {
  if (!axes) reject_option(output, option, "--axes");
}

// --- proportions of the box

using algorithms::skala::BoxSides;

// "4:3:1"
std::optional<BoxSides> sides_named(const std::string& text) {
  std::array<double, 3> sides{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t end = i < 2 ? rest.find(':') : rest.size();
    if (end == std::string_view::npos) return std::nullopt;
    const auto number = base::fixed_number(rest.substr(0, end), 1e-3, 1e3);
    if (!number) return std::nullopt;
    sides[i] = *number;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  const double longer = std::max(sides[0], sides[1]);
  return BoxSides{sides[0] / longer, sides[1] / longer, sides[2] / longer};
}

BoxSides sides_of(const std::string& aspect, const scene::HeightGrid& grid) {
  if (aspect == "free") return {};
  if (aspect != "equal" && aspect != "equal-xy") {
    if (const auto sides = sides_named(aspect)) return *sides;
    throw base::usage_error(fmt::format("--aspect: found \"{}\", expected free, equal-xy, equal, or three sides X:Y:HEIGHT, each 0.001 to 1000", aspect));
  }
  const auto extent = [](scene::Interval interval) { return interval.high / 2 - interval.low / 2; };
  const double longer = std::max(extent(grid.domain_x), extent(grid.domain_z));
  BoxSides sides{extent(grid.domain_x) / longer, extent(grid.domain_z) / longer, BoxSides{}.height};
  if (aspect == "equal") sides.height = extent(grid.range) / longer;
  constexpr double thinnest = 1e-3;
  if (std::min(sides.x, sides.z) < thinnest || sides.height > 1 / thinnest) {
    throw base::usage_error(fmt::format("--aspect {}: one side of the box is more than 1000 times as long as another, expected free or sides of your own",
                                               aspect));
  }
  return sides;
}

// --- contours

// Round heights within the range, unless --levels or --contour-step is given.
std::vector<double> levels_of(const DrawHeightsArguments& arguments, const scene::HeightGrid& grid) {
  constexpr int most_levels = 255;
  constexpr int usual_most = 12;
  if (arguments.output.command->is_given("--levels")) return {};
  if (arguments.contour_step) {
    auto levels = scene::multiples_within(grid.range, *arguments.contour_step, most_levels);
    if (levels.empty() && grid.range.high > grid.range.low)
      throw base::usage_error(fmt::format("--contour-step: found {}, of which heights from {} to {} have none or more than {} multiples", *arguments.contour_step,
                                                 scene::shortest_text(grid.range.low), scene::shortest_text(grid.range.high), most_levels));
    return levels;
  }
  std::vector<double> levels;
  for (const scene::RoundValue& round : scene::round_values(grid.range, usual_most))
    if (round.value > grid.range.low && round.value < grid.range.high) levels.push_back(round.value);
  return levels;
}

base::Json numbers(const std::vector<double>& values) {
  base::Json array = base::Json::array();
  for (const double value : values) array.push_back(value);
  return array;
}

void print_drawing(const registry::HeightAlgorithm& algorithm, const DrawHeightsArguments& arguments,
                   const SkalaFunction& function, const algorithms::skala::Figure& figure,
                   const std::optional<base::Json>& plot) {
  using base::Json;
  const picture::VectorDrawing& drawing = figure.drawing;
  const bool equal = figure.scale[0] == figure.scale[1];
  Json document{{"schema", "sightline/draw/1"},
                      {"algorithm", algorithm.name},
                      {"scene", function.name},
                      {"output", arguments.output.file},
                      {"picture", arguments.picture.empty() ? "lines" : arguments.picture},
                      {"slices", function.grid.slices()},
                      {"points", function.grid.points()},
                      {"x_range", numbers({function.grid.domain_x.low, function.grid.domain_x.high})},
                      {"y_range", numbers({function.grid.domain_z.low, function.grid.domain_z.high})},
                      {"height_range", numbers({function.grid.range.low, function.grid.range.high})},
                      {"rotation", arguments.view.rotation},
                      {"elevation", arguments.view.elevation},
                      {"aspect", {{"name", arguments.aspect}, {"box", numbers({figure.sides.x, figure.sides.z, figure.sides.height})}, {"stretched", !equal}}},
                      {"counts", {{"lines", drawing.lines.size()}, {"facets", drawing.facets.size()}}}};
  if (arguments.view.subject == Subject::contours || arguments.figure.floor) {
    const std::vector<double>& levels = arguments.view.level_heights;
    document["levels"] = levels.empty() ? Json(arguments.view.levels) : numbers(levels);
  }
  if (plot) document["plot"] = *plot;
  // Names of functions and files come from the user: bytes that are not UTF-8 are replaced.
  print_json(document);
}

// --- what is drawn

void read_view(DrawHeightsArguments& arguments, hidden_lines::Format format) {
  algorithms::skala::View& view = arguments.view;
  view.subject = subject_named(arguments.picture);
  view.family = slices_named(arguments.along);
  require_angles(view.rotation, view.elevation);
  view.visibility = !arguments.no_visibility;
  view.rims = !arguments.no_rims;
  // Without a silhouette, contours would end at no visible line where the surface turns away, and a net where a cell is folded.
  const bool needs_silhouette = view.subject == Subject::contours || (view.subject == Subject::surface && view.net);
  view.silhouette = arguments.silhouette || (needs_silhouette && !arguments.no_silhouette);
  if (arguments.colours == "heights") view.colouring = algorithms::skala::Colouring::heights;
  const bool with_pens = format == hidden_lines::Format::hpgl || format == hidden_lines::Format::dxf || format == hidden_lines::Format::steps;
  if (with_pens && view.subject == Subject::surface)
    throw base::usage_error("--picture surface: a plotter draws lines only, expected .svg, .pdf or .png");
  const DrawOutput& output = arguments.output;
  const bool levels = view.subject == Subject::contours || arguments.figure.floor;
  if (!levels)
    for (const char* option : {"--levels", "--contour-step", "--labels"}) reject_option(output, option, "--picture contours or --floor");
  if (view.subject == Subject::lines) {
    reject_option(output, "--net", "--picture contours or --picture surface");
    if (!arguments.figure.floor) reject_option(output, "--colours", "--picture contours or --picture surface");
  }
  if (arguments.contour_step) require_finite("--contour-step", *arguments.contour_step);
  if (arguments.contour_step && output.command->is_given("--levels")) throw base::usage_error("--levels: found with --contour-step");
  require_finite("--text", arguments.figure.text);
  if (!arguments.axis_names.empty() && arguments.axis_names.size() != 3)
    throw base::usage_error(fmt::format("--axis-names: found {}, expected three: of x, y and the height", arguments.axis_names.size()));
  if (!arguments.axis_names.empty()) reject_without_axes(output, "--axis-names", arguments.figure.axes);
  arguments.figure.legend = view.colouring == algorithms::skala::Colouring::heights && !with_pens && !arguments.no_legend;
}

// The unit is 1 mm on paper; in an image four pixels, about 1 mm on a screen.
void read_page(DrawHeightsArguments& arguments, const SkalaFunction& function, hidden_lines::Format format) {
  algorithms::skala::FigureOptions& figure = arguments.figure;
  const DrawOutput& output = arguments.output;
  if (format == hidden_lines::Format::png && !output.is_sheet()) {
    constexpr double pixels_per_unit = 4;
    figure.width = output.image.width / pixels_per_unit;
    figure.height = output.image.height / pixels_per_unit;
  } else {
    figure.width = output.paper.width - 2 * output.paper.margin;
    figure.height = output.paper.height - 2 * output.paper.margin;
  }
  figure.names = function.grid.names;
  if (figure.names[0].empty()) figure.names[0] = "x";
  if (figure.names[1].empty()) figure.names[1] = "y";
  for (std::size_t i = 0; i < arguments.axis_names.size(); ++i) figure.names[i] = arguments.axis_names[i];
}

// If there are more layers than pens, the contours of all levels become one layer, and so do those of the floor.
void join_levels(picture::VectorDrawing& drawing, const DrawOutput& output) {
  const std::size_t pens = !output.pens.empty()           ? output.pens.size()
                           : output.plotter() != nullptr ? static_cast<std::size_t>(output.plotter()->pens)
                                                         : picture::most_hpgl_pens;
  if (drawing.layers.size() <= pens) return;
  std::vector<picture::DrawingLayer> layers;
  std::vector<std::uint32_t> moved;
  for (const picture::DrawingLayer& layer : drawing.layers) {
    const std::string_view label = layer.label;
    const std::string kind(label.starts_with("contour ") ? "contours" : label.starts_with("floor ") ? "floor" : label);
    if (layers.empty() || layers.back().label != kind) layers.push_back({kind, layer.colour});
    moved.push_back(static_cast<std::uint32_t>(layers.size()) - 1);
  }
  for (picture::DrawingLine& line : drawing.lines) line.layer = moved[line.layer];
  drawing.layers = std::move(layers);
}

// Loads all surfaces and gives each the common range of heights. Returns the first one, with the names of all.
SkalaFunction load_all(const DrawHeightsArguments& arguments, std::vector<scene::HeightGrid>& grids) {
  constexpr scene::GridSize usual{65, 65};
  std::vector<std::string> names = arguments.grids;
  // The surface of --function; if there is none, load_skala_function reports it.
  if (names.empty() || !arguments.source.expression.empty()) names.emplace_back();
  const Family cut = names.size() > 1 && arguments.along.empty() ? Family::both : algorithms::skala::smoothed_family(arguments.view);
  SkalaFunction all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    SkalaSource source = arguments.source;
    source.name_or_file = names[i];
    if (!names[i].empty()) source.expression.clear();
    if (!names[i].empty() && !source.domain.empty() && !arguments.source.expression.empty()) source.domain.clear();
    source.nets = names.size() == 1;
    SkalaFunction each = load_skala_function(source, usual, cut);
    if (i == 0) {
      all = each;
    } else {
      if (each.grid.x != grids[0].x || each.grid.z != grids[0].z || each.grid.domain_x != grids[0].domain_x || each.grid.domain_z != grids[0].domain_z) {
        throw base::bad_input(fmt::format("{}: found {} slices of {} points over other places than those of {}, expected surfaces over the same places in one drawing", each.name,
                                  each.grid.slices(), each.grid.points(), all.name));
      }
      all.name += ", " + each.name;
    }
    grids.push_back(std::move(each.grid));
  }
  scene::Interval range = grids[0].range;
  for (const scene::HeightGrid& grid : grids) range = {std::min(range.low, grid.range.low), std::max(range.high, grid.range.high)};
  for (scene::HeightGrid& grid : grids) grid.range = range;
  all.grid = grids[0];
  return all;
}

// "65 lines", "4096 facets, 12 lines"
std::string drawing_text(const picture::VectorDrawing& drawing) {
  std::string text;
  if (!drawing.facets.empty()) text = count_text(drawing.facets.size(), "facet");
  if (text.empty() || !drawing.lines.empty()) text += (text.empty() ? "" : ", ") + count_text(drawing.lines.size(), "line");
  return text;
}

algorithms::skala::Figure figure_of_net(const DrawHeightsArguments& arguments, const SkalaFunction& function) {
  for (const char* option : {"--picture", "--along", "--levels", "--contour-step", "--labels", "--floor", "--net", "--silhouette", "--no-silhouette", "--colours",
                             "--no-legend", "--no-rims", "--no-visibility", "--columns", "--axes", "--title", "--stretch"})
    reject_option(arguments.output, option, "a surface over a grid; " + function.name + " is a net of curves");
  const NetView view{arguments.view.sides, arguments.view.rotation, arguments.view.elevation, {.width = arguments.figure.width, .height = arguments.figure.height, .extent = {}}};
  return {draw_net(*function.net, view, function.name), view.sides, {1, 1}};
}

ExitCode run_draw_heights(const registry::HeightAlgorithm& algorithm, DrawHeightsArguments arguments) {
  algorithms::skala::View& view = arguments.view;
  const hidden_lines::Format format = read_draw_output(arguments.output);
  if (arguments.output.file == "-" && arguments.json) throw base::usage_error("--output: found - with --json, expected a file");
  read_view(arguments, format);
  std::vector<scene::HeightGrid> grids;
  const SkalaFunction function = load_all(arguments, grids);
  if (grids.size() > 1 && arguments.along.empty()) view.family = Family::both;
  view.sides = sides_of(arguments.aspect, function.grid);
  if (view.subject == Subject::contours || arguments.figure.floor) view.level_heights = levels_of(arguments, function.grid);
  read_page(arguments, function, format);
  Output file(arguments.output.file);
  if (const auto reason = function.net ? std::nullopt : algorithm.why_not(function.grid, view))
    throw base::usage_error(fmt::format("{}: {} does not apply: {}", function.name, algorithm.name, *reason));
  algorithms::skala::Figure figure = function.net ? figure_of_net(arguments, function) : algorithm.figure(grids, view, arguments.figure);
  figure.drawing = picture::without_empty_layers(std::move(figure.drawing));
  if (format == hidden_lines::Format::hpgl) join_levels(figure.drawing, arguments.output);
  const auto plot = write_drawing(figure.drawing, arguments.output, format, function.name, file);
  if (arguments.json) {
    print_drawing(algorithm, arguments, function, figure, plot);
  } else {
    report_written(arguments.output.file, fmt::format("{}, {}", drawing_text(figure.drawing), size_text(arguments.output, format)));
  }
  return ExitCode::ok;
}

void add_view_options(const Command& command, DrawHeightsArguments& arguments) {
  algorithms::skala::View& view = arguments.view;
  add_picture_option(command, arguments.picture, "What is drawn");
  command.option("--along", arguments.along, "Slices along x, along z or both")
      .one_of({"x", "z", "both"})
      .default_value("the family seen less end-on; for several surfaces both");
  add_angle_options(command, view.rotation, view.elevation);
  command.option("--levels", view.levels, "Number of contour levels, at equal distances").range(1, 255).default_value("round heights, at most 12");
  command.option("--contour-step", arguments.contour_step, "Contours at the multiples of this height").range(1e-300, 1e300).value("H");
  command.flag("--labels", arguments.figure.contour_labels, "Label contours with their heights");
  command.flag("--floor", arguments.figure.floor, "Also draw contours on a floor below the surface");
  command.flag("--net", view.net, "Also draw the net of all cells, with contours or a surface");
  const Option silhouette = command.flag("--silhouette", arguments.silhouette, "Draw the silhouette; contours and a surface with --net always have it");
  command.flag("--no-silhouette", arguments.no_silhouette, "Omit the silhouette from contours and --net").excludes(silhouette);
  command.option("--colours", arguments.colours, "Colours of a surface or of contours by height, or of a surface by its slope").one_of({"slope", "heights"}).default_value("slope");
  command.flag("--no-legend", arguments.no_legend, "Omit the legend of --colours heights");
  command.flag("--no-rims", arguments.no_rims, "Omit the borders of the surface between slices");
  command.flag("--no-visibility", arguments.no_visibility, "Also draw hidden lines");
  command.option("--columns", view.columns, "Columns of the horizon masks; more columns find hidden parts more finely")
      .default_value()
      .range(algorithms::skala::fewest_columns, algorithms::skala::most_columns);
}

void add_figure_options(const Command& command, DrawHeightsArguments& arguments) {
  command.flag("--axes", arguments.figure.axes, "A box of axes with ticks and labels around the surface").group("Figure");
  command.option("--axis-names", arguments.axis_names, "Names of the three axes").separated_by(',').default_value("those of the file or x,y").value("X,Y,HEIGHT").group("Figure");
  command.option("--title", arguments.figure.title, "A title above the drawing").value("WORDS").group("Figure");
  command.option("--text", arguments.figure.text, "Height of capital letters in mm; in an image 1 mm is four pixels").default_value().range(0.5, 50.0).value("MM").group("Figure");
  command
      .option("--aspect", arguments.aspect,
              "Proportions of the box: free (1:1:0.6 for all units), equal-xy (x and y at the same scale), equal (also heights), or X:Y:HEIGHT")
      .default_value()
      .value("X:Y:HEIGHT")
      .group("Figure");
  command.flag("--stretch", arguments.figure.stretch, "Stretch the drawing to the paper in both directions").group("Figure");
}

}  // namespace

void add_draw_heights(const Command& command, const registry::HeightAlgorithm& algorithm) {
  const auto arguments = std::make_shared<DrawHeightsArguments>();
  arguments->view.rotation = 30;
  command.option("GRID", arguments->grids, "Functions by name, files of heights, - for standard input; several are surfaces over the same places");
  add_function_options(command, arguments->source, "65", "65");
  add_view_options(command, *arguments);
  add_figure_options(command, *arguments);
  add_draw_output_options(command, arguments->output);
  command.flag("--json", arguments->json, "Print what was drawn as one JSON document on standard output");
  command.run([arguments, &algorithm] { return run_draw_heights(algorithm, *arguments); });
}

}  // namespace sightline::app
