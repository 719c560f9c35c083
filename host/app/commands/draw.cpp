// `sightline draw`: its methods, and the drawing of those that find visible lines.
#include "host/app/commands/draw.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/app/command_line.hpp"
#include "host/app/commands/commands.hpp"
#include "host/app/commands/face_shades.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/picture/png.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

namespace {

// --- --fill: faces filled, by a method that draws lines as well

struct FillArguments {
  bool fill = false;
  double stripe = 1;  // pixels
};

struct FilledPicture {
  const scene::LoadedScene& source;
  const scene::PolyCamera& camera;
  std::optional<double> field;
  const DrawOutput& output;  // settled
  bool json = false;
};

std::vector<registry::FaceCount> write_outlines(const registry::PreparedFaces& prepared,
                                               const FilledPicture& picture, Output& file) {
  const picture::Paper& paper = picture.output.paper;
  const auto micrometres = [&paper](double side) {
    return static_cast<int>(std::lround((side - 2 * paper.margin) * 1000));
  };
  const registry::FaceWindow window =
      registry::face_window(picture.source.scene, picture.camera, micrometres(paper.width),
                           micrometres(paper.height), picture.field);
  auto seen = value_of(prepared.regions(picture.camera, window), picture.source.name);
  const std::vector<Shade> shades = face_shades(picture.source.scene);
  std::vector<picture::FilledArea> areas;
  for (registry::FaceRegion& region : seen.regions) {
    const Shade& shade = shades[region.face - 1];
    areas.push_back({{shade[0], shade[1], shade[2]}, std::move(region.loops)});
  }
  file.write(std::string_view(picture::svg_of(areas, paper, picture.source.name)));
  return seen.counts;
}

std::vector<registry::FaceCount> write_stripes(const registry::PreparedFaces& prepared,
                                              const FilledPicture& picture, Output& file) {
  const picture::ImageSize& size = picture.output.image;
  const registry::FaceWindow window =
      registry::face_window(picture.source.scene, picture.camera, size.width, size.height, picture.field);
  const auto seen = value_of(prepared.view(picture.camera, window), picture.source.name);
  const auto bytes = picture::encode_png(shaded_image(seen.faces, face_shades(picture.source.scene)),
                                         {{"Title", picture.source.name}, {"Software", "sightline"}});
  if (!bytes) throw Failure(ExitCode::io, bytes.error().message());
  file.write(std::span<const std::uint8_t>(*bytes));
  return seen.counts;
}

void print_filled_summary(const registry::FaceAlgorithm& algorithm, const FilledPicture& picture,
                          const std::vector<registry::FaceCount>& counts) {
  base::Json object = base::Json::object();
  for (const auto& count : counts) object[std::string(count.name)] = count.value;
  const base::Json document{{"schema", "sightline/draw/1"},
                            {"algorithm", algorithm.name},
                            {"scene", picture.source.name},
                            {"output", picture.output.file},
                            {"filled", true},
                            {"counts", object}};
  print_json(document);
}

void add_fill_options(const Command& command, FillArguments& arguments) {
  const Option fill =
      command.flag("--fill", arguments.fill,
                   "Faces filled instead of lines: outlines with holes in .svg, stripes of pixels in .png");
  const std::vector<double> thicknesses(registry::stripe_thicknesses.begin(),
                                        registry::stripe_thicknesses.end());
  command.option("--stripe", arguments.stripe, "Thickness of stripes in pixels, with --fill to .png")
      .one_of_numbers(thicknesses)
      .default_value()
      .value("")
      .needs(fill);
}

ExitCode draw_filled(const registry::FaceAlgorithm& algorithm, const FillArguments& arguments,
                     const FilledPicture& picture, DrawingFormat format) {
  if (format == DrawingFormat::hpgl)
    throw Failure(ExitCode::usage, fmt::format("{}: expected a name that ends in .svg or .png with --fill",
                                               picture.output.file));
  if (format == DrawingFormat::svg) refuse_option(picture.output, "--stripe", "a name that ends in .png");
  registry::FaceOptions options;
  options.stripe = arguments.stripe;
  const auto prepared = value_of(algorithm.prepare(picture.source.scene, options), picture.source.name);
  Output file(picture.output.file);
  const auto counts = format == DrawingFormat::svg ? write_outlines(prepared, picture, file)
                                                   : write_stripes(prepared, picture, file);
  file.commit();
  if (picture.json) print_filled_summary(algorithm, picture, counts);
  return ExitCode::ok;
}

// --- lines

using base::Json;

struct DrawLinesArguments {
  std::string scene;
  CameraArguments camera;
  std::optional<double> field;
  bool all_edges = false;
  bool hidden = false;
  bool json = false;
  DrawOutput output;
  FillArguments filled;
};

void check_field(const DrawLinesArguments& arguments, const scene::PolyCamera& camera) {
  if (!arguments.field) return;
  require_finite("--field", *arguments.field);
  if (!(*arguments.field > 0) || (camera.perspective && *arguments.field > 170)) {
    throw Failure(ExitCode::usage,
                  fmt::format("--field: found {}, expected {}", *arguments.field,
                              camera.perspective ? "degrees above 0, at most 170" : "scene units above 0"));
  }
}

registry::LineView view_of(const registry::LineAlgorithm& algorithm, const scene::LoadedScene& source,
                          const scene::PolyCamera& camera) {
  if (const auto reason = algorithm.why_not(source.scene))
    throw Failure(ExitCode::usage,
                  fmt::format("{}: {} does not apply: {}", source.name, algorithm.name, *reason));
  if (const auto reason = algorithm.why_not_seen(source.scene, camera)) {
    throw Failure(ExitCode::bad_input, fmt::format("{}: camera: {} does not apply to this view: {}",
                                                   source.name, algorithm.name, *reason));
  }
  const registry::PreparedScene prepared = source.decomposition && algorithm.prepare_cells != nullptr
                                              ? algorithm.prepare_cells(source.decomposition->complex)
                                              : value_of(algorithm.prepare(source.scene), source.name);
  return value_of(prepared.view(camera), source.name);
}

// A millimetre for paper, about a millimetre on a screen for an image.
picture::DrawingField field_of(const DrawLinesArguments& arguments, DrawingFormat format) {
  picture::DrawingField field;
  field.extent = arguments.field;
  if (format == DrawingFormat::png) {
    constexpr double pixels_per_unit = 4;
    field.width = arguments.output.image.width / pixels_per_unit;
    field.height = arguments.output.image.height / pixels_per_unit;
  } else {
    field.width = arguments.output.paper.width - 2 * arguments.output.paper.margin;
    field.height = arguments.output.paper.height - 2 * arguments.output.paper.margin;
  }
  return field;
}

void print_summary(const registry::LineAlgorithm& algorithm, const DrawLinesArguments& arguments,
                   const scene::LoadedScene& source, const scene::PolyCamera& camera,
                   const registry::LineView& view, std::size_t drawn) {
  Json counts = Json::object();
  for (const auto& count : view.counts) counts[std::string(count.name)] = count.value;
  const Json document{{"schema", "sightline/draw/1"},
                      {"algorithm", algorithm.name},
                      {"scene", source.name},
                      {"output", arguments.output.file},
                      {"camera",
                       {{"perspective", camera.perspective},
                        {"eye", camera.eye},
                        {"forward", camera.forward},
                        {"right", camera.right},
                        {"up", camera.up}}},
                      {"edges", picture::edges_of(source.scene).size()},
                      {"pieces", view.picture.pieces.size()},
                      {"pieces_drawn", drawn},
                      {"visible_length", picture::image_length(view.picture, source.scene, camera)},
                      {"counts", counts}};
  print_json(document);
}

ExitCode run_draw_lines(const registry::LineAlgorithm& algorithm, DrawLinesArguments arguments) {
  const DrawingFormat format = read_draw_output(arguments.output);
  const scene::LoadedScene source = load_scene(arguments.scene);
  const scene::PolyCamera camera = camera_of(arguments.camera, source.scene, source.name);
  check_field(arguments, camera);
  if (arguments.filled.fill) {
    return draw_filled(*registry::find_face_algorithm(algorithm.name), arguments.filled,
                       {source, camera, arguments.field, arguments.output, arguments.json}, format);
  }
  Output file(arguments.output.file);
  const registry::LineView view = view_of(algorithm, source, camera);
  picture::LinePicture drawn = view.picture;
  picture::LinePicture edges = arguments.hidden ? picture::wire_frame(source.scene) : picture::LinePicture();
  if (!arguments.all_edges) {
    drawn = picture::without_seams(drawn, source.scene, camera);
    edges = picture::without_seams(edges, source.scene, camera);
  }
  write_drawing(picture::line_drawing(drawn, source.scene, camera, field_of(arguments, format),
                                      arguments.hidden ? &edges : nullptr),
                arguments.output, format, source.name, file);
  if (arguments.json) print_summary(algorithm, arguments, source, camera, view, drawn.pieces.size());
  return ExitCode::ok;
}

void add_draw_lines(const Command& command, const registry::LineAlgorithm& algorithm) {
  const auto arguments = std::make_shared<DrawLinesArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  add_camera_options(command, arguments->camera);
  command
      .option("--field", arguments->field,
              "Show this much across the shorter side, straight ahead: degrees, or scene units with "
              "--orthographic")
      .default_value("everything")
      .value("ANGLE")
      .group("View");
  const Option all_edges =
      command.flag("--all-edges", arguments->all_edges, "Draw edges between coplanar faces, too");
  const Option hidden =
      command.flag("--hidden", arguments->hidden, "Draw hidden lines as a second layer, dashed");
  if (registry::find_face_algorithm(algorithm.name) != nullptr) {
    add_fill_options(command, arguments->filled);
    command.added("--fill").excludes(all_edges).excludes(hidden);
  }
  add_draw_output_options(command, arguments->output);
  command.flag("--json", arguments->json, "Print what was drawn as one JSON document on standard output");
  command.run([arguments, &algorithm] { return run_draw_lines(algorithm, *arguments); });
}

}  // namespace

void add_draw_command(const Command& program) {
  std::string methods;
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
    methods += std::string(algorithm.name) + ", ";
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms())
    if (registry::find_line_algorithm(algorithm.name) == nullptr)
      methods += std::string(algorithm.name) + ", ";
  for (const registry::HeightMethod& method : registry::height_methods())
    if (!method.algorithm.empty()) methods += std::string(method.algorithm) + ", ";
  methods.resize(methods.size() - 2);
  const Command command = program.add_command("draw", help_page("draw", {{"methods", methods}}));
  const auto add_method = [&command](const auto& algorithm, std::string_view page) {
    return command.add_command(std::string(algorithm.name),
                               help_page(page, {{"summary", std::string(algorithm.description)},
                                                {"method", std::string(algorithm.name)},
                                                {"camera", help_page("camera").summary}}));
  };
  // A new algorithm is a row of its registry; nothing changes here.
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
    add_draw_lines(add_method(algorithm, algorithm.why_not_view == nullptr ? "draw_lines" : "draw_parallel"),
                   algorithm);
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms())
    if (registry::find_line_algorithm(algorithm.name) == nullptr)
      add_draw_faces(add_method(algorithm, "draw_faces"), algorithm);
  for (const registry::HeightMethod& method : registry::height_methods()) {
    if (method.algorithm.empty()) continue;
    const std::string name(method.algorithm);
    add_draw_heights(command.add_command(name, help_page("draw_" + name)), method);
  }
}

}  // namespace sightline::app
