#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <utility>

#include "host/algorithms/skala/surface.hpp"
#include "host/app/commands/commands.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/commands/skala_report.hpp"
#include "host/app/commands/skala_pictures.hpp"
#include "host/app/commands/skala_source.hpp"
#include "host/app/outputs.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::app {

namespace {

using programs::skala::Device;
using programs::skala::Link;
using algorithms::skala::Subject;
using picture::RasterPalette;

HelpPage skala_help() {
  return help_page("skala", {{"functions", scene::height_function_names()}});
}

struct SkalaArguments {
  SkalaSource source;
  programs::skala::Order order;
  std::string device = "raster";
  std::string link = "parallel";
  std::string palette;  // empty: the usual one
  bool no_visibility = false;
  SkalaSlices slices;
  std::int64_t clock = core::ClockRate{}.hertz;
  int scale = 3;
  std::string directory = "out";
  bool json = false;
};

// The value of --device by name.
programs::skala::Device device_named(const std::string& name) {
  if (name == "alt256") return programs::skala::Device::alt256;
  if (name == "calcomp") return programs::skala::Device::calcomp;
  return name == "minigraf" ? programs::skala::Device::minigraf : programs::skala::Device::ef9365;
}

ExitCode run_skala(SkalaArguments arguments) {
  programs::skala::Order& order = arguments.order;
  require_angles(order.view.rotation, order.view.elevation);
  require_finite("--zoom", order.view.zoom);
  order.view.family = family_of(arguments.slices);
  SkalaFunction function = load_skala_function(arguments.source, usual_grid_size(order.view.subject), algorithms::skala::smoothed_family(order.view));
  order.grid = std::move(function.grid);
  order.clock.hertz = arguments.clock;
  order.view.visibility = !arguments.no_visibility;
  order.device = device_named(arguments.device);
  if (arguments.link == "serial") order.link = programs::skala::Link::serial;
  order.time_plain = true;
  order.view.silhouette = order.view.subject == Subject::contours;
  const SkalaRequest request{function.name, std::move(order)};
  const programs::skala::Outcome outcome = value_of(programs::skala::run(request.order), request.name);
  if (request.order.direct_masks) function.stem += "-direct";
  SkalaFiles files{arguments.directory, function.stem, usual_palette(request.order.view.subject), arguments.scale};
  if (!arguments.palette.empty())
    files.palette = arguments.palette == "grey" ? RasterPalette::grey : RasterPalette::colour;
  const auto pictures = write_skala_pictures(files, request, outcome);
  write_stdout(arguments.json ? skala_document(request, outcome, pictures)
                              : skala_summary(request, outcome, pictures));
  if (request.order.check) report_equal(request.name);
  return ExitCode::ok;
}

void add_skala_source_options(const Command& command, SkalaArguments& arguments) {
  command.option("FUNCTION", arguments.source.name_or_file, "A function by name, or a grid file");
  const scene::GridSize usual = usual_grid_size(arguments.order.view.subject);
  add_function_options(command, arguments.source, std::to_string(usual.slices), std::to_string(usual.points));
}

void add_view_options(const Command& command, SkalaArguments& arguments) {
  algorithms::skala::View& view = arguments.order.view;
  add_angle_options(command, view.rotation, view.elevation);
  command.option("--zoom", view.zoom, "Enlarge about the middle")
      .default_value()
      .range(0.01, 100.0)
      .value("F");
  if (view.subject != Subject::contours) {
    add_slices_options(command, arguments.slices);
    // Accepted so that one command line works for all pictures, but hidden because it has no effect.
    if (view.subject == Subject::surface) command.find_option("--both").hidden();
    return;
  }
  command.flag("--both", arguments.slices.both, "");
  add_levels_option(command, view.levels);
  command.flag("--net", view.net, "Draw the net of all cells, not only the border of the domain");
}

void add_machine_options(const Command& command, SkalaArguments& arguments) {
  command.option("--device", arguments.device, "A raster board or a plotter")
      .default_value()
      .one_of({"raster", "alt256", "calcomp", "minigraf"})
      .value("NAME");
  command.flag("--no-visibility", arguments.no_visibility, "Draw everything: the program without its visibility test");
  command.flag("--direct-masks", arguments.order.direct_masks,
               "Leave out the temporary masks M1T and M1B: every dot changes the masks at once; on a raster board, counts the wrong dots");
  command.flag("--check", arguments.order.check, "Compare the picture with that of the same program in C++");
  command.option("--link", arguments.link, "Link from the host computer; serial has 9600 baud")
      .default_value()
      .one_of({"parallel", "serial"})
      .value("NAME");
  command.option("--clock", arguments.clock, "The processor's clock in Hz; the programs are timed for 3 MHz")
      .default_value()
      .range(std::int64_t{100'000}, std::int64_t{100'000'000})
      .value("HZ");
}

void add_output_options(const Command& command, SkalaArguments& arguments) {
  command.option("--palette", arguments.palette, "Colours of the PNG")
      .default_value("grey for surfaces, colour for others")
      .one_of({"colour", "grey"})
      .value("NAME");
  command.option("--scale", arguments.scale, "Pixels per point in the PNG").default_value().range(1, 32);
  command.option("-o,--output", arguments.directory, "Folder for the pictures").default_value().value("DIR");
  command.flag("--json", arguments.json, "One JSON document instead of the summary");
}

void add_picture(const Command& parent, const char* name, const char* description, Subject picture) {
  const Command command = parent.add_command(name, HelpPage{description, skala_help().text});
  const auto arguments = std::make_shared<SkalaArguments>();
  arguments->order.view.subject = picture;
  arguments->order.view.rotation = 30;
  add_skala_source_options(command, *arguments);
  add_view_options(command, *arguments);
  add_machine_options(command, *arguments);
  add_output_options(command, *arguments);
  command.run([arguments] { return run_skala(*arguments); });
}

}  // namespace

void add_skala_command(const Command& program) {
  const Command command = program.add_command("skala", skala_help());
  add_picture(command, "lines", "Slices of a surface with hidden lines removed", Subject::lines);
  add_picture(command, "surface", "A shaded surface with hidden parts removed", Subject::surface);
  add_picture(command, "contours", "Contour lines on a surface with hidden parts removed",
              Subject::contours);
}

}  // namespace sightline::app
