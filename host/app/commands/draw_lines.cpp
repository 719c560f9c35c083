// See draw_lines.hpp.
#include "host/app/commands/draw_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "host/app/commands/draw_camera.hpp"
#include "host/app/commands/draw_filled.hpp"
#include "host/app/commands/draw_output.hpp"
#include "host/app/scene_source.hpp"
#include "host/base/json.hpp"
#include "host/picture/line_drawing.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/picture/line_picture_seams.hpp"

namespace sightline::app {

namespace {

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

// Of a method that has no picture of some views: one direction that Plantinga's turns have.
std::string draw_parallel_footer(std::string_view algorithm) {
  return fmt::format(
      "Examples:\n"
      "  sightline draw {0} part.off --orthographic 3,0,4 -o part.svg\n"
      "      one moment of a turn about the vertical axis; `sightline spin part.off` shows the whole turn\n"
      "  sightline draw {0} boxes-30 --orthographic 3,0,4 --hidden -o boxes.plt\n"
      "      a generated scene for a plotter, what is hidden dashed with the second pen\n\n"
      "The method knows a scene that turns about its y axis in parallel projection: --orthographic X,0,Z, or "
      "a "
      "file whose own view is such a one. All other views are refused.\n"
      "The picture is fitted to the paper or image, undistorted. Edges between faces in one plane are left "
      "out "
      "unless --all-edges is given.\n",
      algorithm);
}

std::string draw_lines_footer(std::string_view algorithm) {
  return fmt::format(
      "Examples:\n"
      "  sightline draw {0} part.off -o part.svg\n"
      "      a solid with its hidden lines removed, for a drawing program\n"
      "  sightline draw {0} boxes-30 --hidden -o boxes.plt\n"
      "      a generated scene for a plotter, what is hidden dashed with the second pen\n"
      "  sightline draw {0} house --eye 100,40,-300 --look-at 100,40,100 --field 60 -o house.png\n"
      "      a built-in scene from a point of your own\n"
      "  sightline draw {0} part.obj --vertical z --orthographic -1,2,-1 --json -o part.svg\n"
      "      a file whose z points up, without perspective; what was drawn in numbers on standard output\n\n"
      "{1}The picture is fitted to the paper or image, undistorted; where it is all around the eye, 90 "
      "degrees "
      "of it\nare. Edges between faces in one plane are left out unless --all-edges is given.\n",
      algorithm, camera_help);
}

void check_field(const DrawLinesArguments& arguments, const scene::PolyCamera& camera) {
  if (!arguments.field) return;
  require_finite("--field", *arguments.field);
  if (!(*arguments.field > 0) || (camera.perspective && *arguments.field > 170)) {
    throw Failure(ExitCode::usage,
                  fmt::format("--field: found {}, expected {}", *arguments.field,
                              camera.perspective ? "degrees above 0, at most 170" : "scene units above 0"));
  }
}

harness::LineView view_of(const harness::LineAlgorithm& algorithm, const SceneSource& source,
                          const scene::PolyCamera& camera) {
  if (const auto reason = algorithm.why_not(source.scene))
    throw Failure(ExitCode::usage,
                  fmt::format("{}: {} does not apply: {}", source.name, algorithm.name, *reason));
  if (const auto reason = algorithm.why_not_seen(source.scene, camera)) {
    throw Failure(ExitCode::bad_input, fmt::format("{}: camera: {} does not apply to this view: {}",
                                                   source.name, algorithm.name, *reason));
  }
  const auto checked = [&](auto result) {
    if (!result) {
      result.error().file = source.name;
      throw Failure(ExitCode::bad_input, result.error().message());
    }
    return std::move(*result);
  };
  const harness::PreparedScene prepared = source.complex && algorithm.prepare_cells != nullptr
                                              ? algorithm.prepare_cells(*source.complex)
                                              : checked(algorithm.prepare(source.scene));
  return checked(prepared.view(camera));
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

void print_summary(const harness::LineAlgorithm& algorithm, const DrawLinesArguments& arguments,
                   const SceneSource& source, const scene::PolyCamera& camera, const harness::LineView& view,
                   std::size_t drawn) {
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

ExitCode run_draw_lines(const harness::LineAlgorithm& algorithm, DrawLinesArguments arguments) {
  const DrawingFormat format = settled(arguments.output);
  const SceneSource source = load_scene_source(arguments.scene);
  const scene::PolyCamera camera = camera_of(arguments.camera, source.scene, source.name);
  check_field(arguments, camera);
  if (arguments.filled.fill) {
    return draw_filled(*harness::find_face_algorithm(algorithm.name), arguments.filled,
                       {source, camera, arguments.field, arguments.output, arguments.json}, format);
  }
  Output file(arguments.output.file);
  const harness::LineView view = view_of(algorithm, source, camera);
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

}  // namespace

void add_draw_lines(const Command& command, const harness::LineAlgorithm& algorithm) {
  const auto arguments = std::make_shared<DrawLinesArguments>();
  command.option("SCENE", arguments->scene, scene_source_help).required();
  add_camera_options(command, arguments->camera);
  command
      .option("--field", arguments->field,
              "Show this much across the shorter side, straight ahead: degrees, or scene units with "
              "--orthographic")
      .default_value("everything")
      .value("ANGLE")
      .group("View");
  const Option all_edges =
      command.flag("--all-edges", arguments->all_edges, "Draw edges between faces in one plane, too");
  const Option hidden =
      command.flag("--hidden", arguments->hidden, "Draw what is hidden as a second layer, dashed");
  if (harness::find_face_algorithm(algorithm.name) != nullptr) {
    add_fill_options(command, arguments->filled);
    command.added("--fill").excludes(all_edges).excludes(hidden);
  }
  add_draw_output_options(command, arguments->output);
  command.flag("--json", arguments->json, "Say what was drawn as one JSON document on standard output");
  command.footer(algorithm.why_not_view == nullptr ? draw_lines_footer(algorithm.name)
                                                   : draw_parallel_footer(algorithm.name));
  command.run([arguments, &algorithm] { return run_draw_lines(algorithm, *arguments); });
}

}  // namespace sightline::app
