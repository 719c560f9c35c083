#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/app/camera_options.hpp"
#include "host/app/commands/commands.hpp"
#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/raster_image.hpp"
#include "host/programs/stripes/program.hpp"
#include "host/programs/stripes/stripes.hpp"

namespace sightline::app {

namespace {

namespace stripes = programs::stripes;
using base::Json;

struct StripesArguments {
  std::string scene;
  MeshArguments mesh;
  CameraArguments camera;
  std::optional<double> field;
  std::string device = "raster";
  std::string made_by = "8080";
  std::string priority = "8080";
  std::string palette = "grey";
  int scale = 3;
  std::string directory = "out";
  bool antialias = false;
  bool overwrite = false;
  bool check = false;
  bool json = false;
};

stripes::Computer computer_named(const std::string& name) {
  return name == "host" ? stripes::Computer::host : stripes::Computer::i8080;
}

stripes::Build build_of(const StripesArguments& arguments) {
  if (arguments.antialias) return stripes::Build::coverage;
  return arguments.overwrite ? stripes::Build::overwrite : stripes::Build::plain;
}

stripes::StreamOptions options_of(const StripesArguments& arguments) {
  return {arguments.device == "calcomp" ? stripes::Output::vector : stripes::Output::raster,
          computer_named(arguments.made_by), computer_named(arguments.priority), build_of(arguments)};
}

// Found before the scene is read.
void reject_impossible(const StripesArguments& arguments) {
  const std::string_view option = arguments.antialias ? "--antialias" : "--overwrite";
  if (!arguments.antialias && !arguments.overwrite) return;
  if (arguments.device == "calcomp")
    throw base::usage_error(fmt::format("{}: found with --device calcomp, expected the raster board: {}", option,
                                        arguments.antialias ? "the plotter has no greys" : "a line that is drawn cannot be overwritten"));
  if (arguments.antialias && arguments.made_by == "host")
    throw base::usage_error("--antialias: found with --stripes host, expected stripes by the 8080: lists of the host have no types of sides");
  if (arguments.antialias && arguments.palette == "colour")
    throw base::usage_error("--antialias: found with --palette colour, expected grey: a level between those of two faces has a colour of neither");
}

std::vector<std::string> write_pictures(const StripesArguments& arguments, const std::string& name,
                                        const stripes::MachinePicture& picture) {
  make_directory(arguments.directory);
  const bool vector = arguments.device == "calcomp";
  std::string kind = "-stripes";
  if (vector) kind += "-calcomp";
  if (arguments.antialias) kind += "-antialias";
  if (arguments.overwrite) kind += "-overwrite";
  const std::string base = (std::filesystem::path(arguments.directory) / (file_stem(name) + kind)).string();
  const std::string title = fmt::format("{}, Montani and Re 1985 on the 8080, {}", name, vector ? "CalComp 565" : "EF9365 board");
  const picture::TextEntries text{{"Title", title}, {"Software", "sightline"}};
  std::vector<std::string> paths{base + ".png"};
  Output png(paths[0]);
  if (!vector) {
    const auto palette = arguments.palette == "grey" ? picture::RasterPalette::grey : picture::RasterPalette::colour;
    write_png(png, picture::raster_image(picture.raster, palette, arguments.scale), text);
    png.commit();
    return paths;
  }
  const auto pen = stripes::pen_paths(picture.commands);
  paths.push_back(base + ".svg");
  paths.push_back(base + ".hpgl");
  Output svg(paths[1]);
  Output hpgl(paths[2]);
  write_png(png, picture::pen_image(pen, picture::calcomp_paper, arguments.scale), text);
  svg.write(picture::pen_svg(pen, picture::calcomp_paper, title));
  hpgl.write(picture::hpgl(pen, picture::calcomp_paper));
  png.commit();
  svg.commit();
  hpgl.commit();
  return paths;
}

std::string summary_of(const StripesArguments& arguments, const stripes::Outcome& drawn) {
  const stripes::MachinePicture& picture = drawn.picture;
  const stripes::Counts& counts = picture.counts;
  const bool vector = arguments.device == "calcomp";
  std::string text = fmt::format("{} in stripes on the 8080 at 3 MHz, {}\n", arguments.scene, vector ? "CalComp 565" : "EF9365 board");
  const auto row = [&text](std::string_view name, const std::string& value) { text += fmt::format("{:<17}{}\n", name, value); };
  row("faces", fmt::format("{} turned to the eye{}", drawn.scene.faces.size(), drawn.scene.clipped ? ", clipped to the picture" : ""));
  row("bytes", fmt::format("program {} of {}; scene {}: polygons {}, stripes {}", stripes::resident_program(build_of(arguments)).memory.size(),
                           stripes::program_room, drawn.stream.bytes.size(), drawn.stream.polygon_bytes, drawn.stream.stripe_bytes));
  if (arguments.antialias)
    row("stripes", "made by the 8080; the parts of dots at sides in quarters");
  else if (arguments.overwrite)
    row("stripes", fmt::format("made by the {}; drawn from the back, each face over those behind it", arguments.made_by));
  else
    row("stripes", fmt::format("made by the {}; at most {} ends in a line of a face, {} of the silhouette", arguments.made_by,
                             counts.face_most, counts.silhouette_most));
  if (arguments.priority == "8080") {
    std::string tests;
    for (std::size_t k = 1; k < counts.decided_by.size(); ++k) tests += fmt::format("{}{}", k > 1 ? ", " : "", counts.decided_by[k]);
    row("priority", fmt::format("by the 8080: {} relations; pairs decided by tests 1 to 6: {}", counts.relations, tests));
    row("cycles", fmt::format("{} relations without overlap deleted, {} cuts", counts.deleted, counts.cuts));
  } else {
    row("priority", fmt::format("by the host, {} cuts", drawn.scene.cuts));
  }
  row("receiving", fmt::format("{:.2f} s", core::in_seconds(picture.receiving)));
  row("priority list", fmt::format("{:.2f} s, with the check of the records", core::in_seconds(picture.ranking)));
  row("drawing", fmt::format("{:.2f} s{}", core::in_seconds(picture.drawing),
                             vector ? fmt::format(", of which the plotter moves for {:.2f} s", core::in_seconds(picture.device)) : ""));
  if (vector) {
    const stripes::PenWork work = stripes::pen_work(picture.commands);
    row("pen", fmt::format("{} steps down, {} up, {} lifts", work.steps_down, work.steps_up, work.lifts));
  } else {
    row("dots", std::to_string(counts.dots));
  }
  return text;
}

Json document_of(const StripesArguments& arguments, const stripes::Outcome& drawn, const std::vector<std::string>& pictures) {
  const stripes::MachinePicture& picture = drawn.picture;
  const stripes::Counts& counts = picture.counts;
  Json document{{"schema", "sightline/stripes/1"},
                {"scene", arguments.scene},
                {"device", arguments.device},
                {"stripes_by", arguments.made_by},
                {"priority_by", arguments.priority},
                {"faces", drawn.scene.faces.size()},
                {"program_bytes", stripes::resident_program(build_of(arguments)).memory.size()},
                {"scene_bytes", drawn.stream.bytes.size()},
                {"polygon_bytes", drawn.stream.polygon_bytes},
                {"stripe_bytes", drawn.stream.stripe_bytes},
                {"receiving_seconds", core::in_seconds(picture.receiving)},
                {"priority_seconds", core::in_seconds(picture.ranking)},
                {"drawing_seconds", core::in_seconds(picture.drawing)},
                {"plotter_seconds", core::in_seconds(picture.device)},
                {"relations", counts.relations},
                {"relations_deleted", counts.deleted},
                {"cuts", arguments.priority == "8080" ? counts.cuts : drawn.scene.cuts},
                {"silhouette_ends_most", counts.silhouette_most},
                {"dots", counts.dots},
                {"links", counts.links},
                {"pictures", pictures}};
  if (arguments.antialias) document["antialias"] = true;
  if (arguments.overwrite) document["overwrite"] = true;
  document["pairs_decided_by_test"] = Json::array();
  for (std::size_t k = 1; k < counts.decided_by.size(); ++k) document["pairs_decided_by_test"].push_back(counts.decided_by[k]);
  return document;
}

ExitCode run_stripes(const StripesArguments& arguments) {
  reject_impossible(arguments);
  MeshArguments mesh = arguments.mesh;
  mesh.eye = eye_of(arguments.camera);
  const scene::LoadedScene source = load_scene(arguments.scene, mesh);
  const scene::PolyCamera camera = camera_of(arguments.camera, source.scene, source.name);
  const stripes::View view = stripes::view_of(source.scene, camera, image_field(arguments.field, source.scene, camera));
  const stripes::Outcome drawn = value_of(
      stripes::run({.scene = source.scene, .view = view, .options = options_of(arguments), .check = arguments.check}), arguments.scene);
  const auto pictures =
      write_pictures(arguments, std::filesystem::path(arguments.scene).stem().string(), drawn.picture);
  if (arguments.json) {
    print_json(document_of(arguments, drawn, pictures));
  } else {
    write_stdout(summary_of(arguments, drawn));
    for (const std::string& path : pictures) write_stdout(fmt::format("picture          {}\n", path));
  }
  if (arguments.check) report_equal(arguments.scene);
  return ExitCode::ok;
}

}  // namespace

void add_stripes_command(const Command& program) {
  const Command command = program.add_command("stripes", help_page("stripes", {{"camera", help_page("camera").summary}}));
  const auto arguments = std::make_shared<StripesArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  add_camera_options(command, arguments->camera);
  add_field_option(command, arguments->field, "everything");
  add_mesh_options(command, arguments->mesh);
  command.option("--device", arguments->device, "Filled faces on the raster board, or lines on the plotter")
      .default_value()
      .one_of({"raster", "calcomp"})
      .value("NAME");
  command.option("--stripes", arguments->made_by, "Which computer cuts the faces into stripes")
      .default_value()
      .one_of({"8080", "host"})
      .value("NAME");
  command.option("--priority", arguments->priority, "Which computer finds the priority list")
      .default_value()
      .one_of({"8080", "host"})
      .value("NAME");
  const Option antialias = command.flag("--antialias", arguments->antialias,
                                        "On the board: grey dots at sides, by the parts that the faces cover");
  command.flag("--overwrite", arguments->overwrite, "On the board: draw from the farthest face, without a silhouette")
      .excludes(antialias);
  command.flag("--check", arguments->check, "Compare the picture with that of the same program in C++");
  command.option("--palette", arguments->palette, "Colours of the PNG").default_value().one_of({"grey", "colour"}).value("NAME");
  command.option("--scale", arguments->scale, "Pixels per dot in the PNG").default_value().range(1, 32);
  command.option("-o,--output", arguments->directory, "Folder for the pictures").default_value().value("DIR");
  command.flag("--json", arguments->json, "One JSON document instead of the table");
  command.run([arguments] { return run_stripes(*arguments); });
}

}  // namespace sightline::app
