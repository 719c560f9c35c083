#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/face_shades.hpp"
#include "host/programs/flight/flight.hpp"

namespace sightline::app {

namespace {

namespace flight = programs::flight;
namespace display = devices::priority_display;
using base::Json;

struct FlightArguments {
  std::string scene;
  std::string bits = "8";
  bool plan = false;
  bool facing = false;
  std::uint32_t pieces = 0;
  std::uint32_t frames = 100;
  std::string directory = "out";
  bool check = false;
  bool json = false;
};

flight::Precision precision_of(const std::string& bits) {
  if (bits == "8") return flight::Precision::bits_8;
  return bits == "12" ? flight::Precision::bits_12 : flight::Precision::bits_16;
}

// The picture on the display, the bottom row first; 256 by 256, every second point of every second line.
picture::PixelGrid half_size_picture(std::span<const std::uint32_t> shown) {
  picture::PixelGrid faces(display::columns / 2, display::lines / 2);
  for (int row = 0; row < faces.height; ++row)
    for (int column = 0; column < faces.width; ++column)
      faces.values[faces.index(column, row)] =
          shown[static_cast<std::size_t>(display::lines - 2 - 2 * row) * display::columns + static_cast<std::size_t>(2 * column)];
  return faces;
}

// The same picture with all its points.
picture::PixelGrid full_picture(std::span<const std::uint32_t> shown) {
  picture::PixelGrid faces(display::columns, display::lines);
  for (int row = 0; row < faces.height; ++row)
    std::copy_n(shown.begin() + static_cast<std::ptrdiff_t>(display::lines - 1 - row) * display::columns, display::columns,
                faces.values.begin() + static_cast<std::ptrdiff_t>(faces.index(0, row)));
  return faces;
}

// The time during which the display showed a picture, until the next one.
picture::FrameTime display_time(const std::vector<flight::Frame>& frames, std::size_t number) {
  const core::Duration shown = number + 1 < frames.size() ? frames[number + 1].shown - frames[number].shown : display::frame;
  return {static_cast<std::uint16_t>(std::min<std::int64_t>(shown.count() / 1'000'000, 65'535)), 1000};
}

std::string frame_table(const std::vector<flight::Frame>& frames, bool facing) {
  std::string text = "frame,shown_ms,t_states,waiting_t_states,pieces_moved,pairs_exchanged,pieces_facing,wrong_orders,wrong_points";
  text += facing ? ",pieces_with_key,pieces_appeared,pieces_vanished\n" : "\n";
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const flight::Frame& frame = frames[i];
    text += fmt::format("{},{},{},{},{},{},{},{},{}", i, frame.shown.time_since_epoch().count() / 1'000'000, frame.computing.count(),
                        frame.waiting.count(), frame.moved, frame.exchanges, frame.facing, frame.wrong_orders, frame.wrong_points);
    text += facing ? fmt::format(",{},{},{}\n", frame.listed, frame.turned.appeared, frame.turned.vanished) : "\n";
  }
  return text;
}

struct FlightFiles {
  flight::Outcome run;
  std::vector<std::string> files;
};

FlightFiles fly(const FlightArguments& arguments, const scene::LoadedScene& source, const flight::Plan& planned) {
  make_directory(arguments.directory);
  const std::string stem = file_stem(std::filesystem::path(arguments.scene).stem().string());
  const std::string base = (std::filesystem::path(arguments.directory) / (stem + "-flight")).string();
  FlightFiles made;
  made.files = {base + ".apng", base + ".png", base + ".csv"};
  const std::string title = fmt::format("{} from the priority display, after Willis 1977", stem);
  Output animation(made.files[0]);
  Output still(made.files[1]);
  Output table(made.files[2]);
  const auto shades = picture::face_shades(source.scene);
  std::vector<picture::Image> pictures;
  flight::Order order{.model = planned.model, .path = planned.path, .precision = precision_of(arguments.bits), .facing = arguments.facing, .count_points = true,
                      .check = arguments.check};
  order.picture = [&](std::uint32_t frame, std::span<const std::uint32_t> shown) {
    pictures.push_back(picture::shaded_image(half_size_picture(shown), shades));
    if (frame == arguments.frames / 3) write_png(still, picture::shaded_image(full_picture(shown), shades), {{"Title", title}, {"Software", "sightline"}});
  };
  made.run = value_of(flight::run(order), arguments.scene);
  picture::ApngWriter apng({1, 25}, 0, {{"Title", title}, {"Software", "sightline"}});
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto added = apng.add(pictures[i], display_time(made.run.frames, i));
    if (!added) throw base::io_error(added.error().message());
  }
  const auto bytes = apng.finish();
  if (!bytes) throw base::io_error(bytes.error().message());
  animation.write(*bytes);
  animation.commit();
  still.commit();
  table.write(frame_table(made.run.frames, arguments.facing));
  table.commit();
  return made;
}

Json flight_document(const FlightArguments& arguments, const flight::Plan& planned, const FlightFiles& made) {
  const flight::Packed& packed = made.run.packed;
  const flight::Summary& sum = made.run.summary;
  Json document{{"schema", "sightline/flight/1"},
                {"scene", arguments.scene},
                {"plan", arguments.plan},
                {"bits", std::stoi(arguments.bits)},
                {"pieces", sum.pieces},
                {"surfaces", planned.model.surfaces},
                {"planes", packed.planes},
                {"residual", planned.model.residual.size()},
                {"frames", sum.frames},
                {"coordinate_step", packed.step_in_units},
                {"distance_error", packed.error_in_units},
                {"frames_per_second_mean", sum.frames_per_second_mean},
                {"frames_per_second_worst", sum.frames_per_second_worst},
                {"computed_per_second_mean", sum.computed_per_second_mean},
                {"computed_per_second_worst", sum.computed_per_second_worst},
                {"t_states_mean", sum.t_states_mean},
                {"t_states_worst", sum.t_states_worst},
                {"pairs_exchanged_mean", sum.exchanges_mean},
                {"pairs_exchanged_most", sum.exchanges_most},
                {"pairs", sum.pairs},
                {"wrong_orders", sum.wrong_orders},
                {"wrong_points", sum.wrong_points},
                {"frames_with_wrong_points", sum.frames_wrong},
                {"files", made.files}};
  if (arguments.facing)
    document["facing_test"] = Json{{"directions", packed.directions},
                                   {"facing_error", packed.facing_error_in_units},
                                   {"pieces_with_key_mean", sum.listed_mean},
                                   {"pieces_with_key_most", sum.listed_most},
                                   {"pieces_turned_mean", sum.turned_mean},
                                   {"pieces_turned_most", sum.turned_most},
                                   {"hidden_facing_pieces", sum.hidden}};
  return document;
}

// `unit`: one unit of the scene's coordinates, in units of its file.
std::string flight_text(const FlightArguments& arguments, const flight::Plan& planned, const FlightFiles& made, double unit) {
  const flight::Packed& packed = made.run.packed;
  const flight::Summary& sum = made.run.summary;
  std::string text = fmt::format("{}: a flight on an 8080 at 3 MHz with the priority display{}\n", arguments.scene, arguments.plan ? ", in plan" : "");
  text += fmt::format("pieces           {}, of {} surfaces{}; {} pairs left in clusters\n", sum.pieces, planned.model.surfaces,
                      packed.planes > 0 ? fmt::format(", parted by {} planes", packed.planes) : std::string(), planned.model.residual.size());
  text += fmt::format("coordinates      {} bits, {} axes; a step is {:.3g} in the unit of the file\n", arguments.bits, packed.axes, packed.step_in_units * unit);
  text += fmt::format("frames           {}\n", sum.frames);
  text += fmt::format("{:<17}{:>12}{:>12}\n", "", "mean", "worst");
  const auto row = [&text](const char* name, double mean, double worst, int digits) {
    text += fmt::format("{:<17}{:>12.{}f}{:>12.{}f}\n", name, mean, digits, worst, digits);
  };
  row("frames/s shown", sum.frames_per_second_mean, sum.frames_per_second_worst, 2);
  row("frames/s computed", sum.computed_per_second_mean, sum.computed_per_second_worst, 1);
  row("T-states", sum.t_states_mean, static_cast<double>(sum.t_states_worst), 0);
  row("pairs exchanged", sum.exchanges_mean, sum.exchanges_most, 1);
  if (arguments.facing) {
    row("pieces with a key", sum.listed_mean, sum.listed_most, 1);
    row("pieces turned", sum.turned_mean, sum.turned_most, 1);
    text += fmt::format("facing test      {} directions; right beyond {:.3g} from a piece's plane; facing pieces hidden: {}\n", packed.directions,
                        packed.facing_error_in_units * unit, sum.hidden);
  }
  text += fmt::format("wrong orders     {} of {} pairs turned to the eye; right beyond a difference of {:.3g}\n", sum.wrong_orders, sum.pairs,
                      packed.error_in_units * unit);
  text += fmt::format("wrong pixels     {}, in {} of {} pictures: they show a face that is not the nearest\n", sum.wrong_points, sum.frames_wrong, sum.frames);
  for (const std::string& file : made.files) text += fmt::format("file             {}\n", file);
  return text;
}

ExitCode run_flight(const FlightArguments& arguments) {
  const scene::LoadedScene source = load_scene(arguments.scene);
  const std::optional<std::size_t> pieces = arguments.pieces > 0 ? std::optional<std::size_t>(arguments.pieces) : std::nullopt;
  const flight::Plan planned = value_of(flight::plan_flight(source.scene, arguments.plan, arguments.frames, pieces, arguments.facing), arguments.scene);
  const FlightFiles made = fly(arguments, source, planned);
  if (arguments.json) {
    print_json(flight_document(arguments, planned, made));
  } else {
    write_stdout(flight_text(arguments, planned, made, source.scene.step));
  }
  if (arguments.check) report_equal(arguments.scene);
  return ExitCode::ok;
}

}  // namespace

void add_flight_command(const Command& program) {
  const Command command = program.add_command("flight", help_page("flight"));
  const auto arguments = std::make_shared<FlightArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  command.option("--bits", arguments->bits, "Bits of a coordinate on the machine").one_of({"8", "12", "16"}).default_value();
  command.flag("--plan", arguments->plan,
               "Measure in plan, along the scene's vertical, as the paper does: walls only, seen from between their feet and tops");
  command.flag("--facing", arguments->facing, "Run the program with the facing test: keys and priorities only for pieces that face the camera");
  command.option("--pieces", arguments->pieces, "Use only this many pieces, those nearest to the start")
      .default_value("all")
      .range(1, static_cast<int>(flight::most_pieces));
  command.option("--frames", arguments->frames, "Frames of the flight").default_value().range(2, 2000);
  command.flag("--check", arguments->check, "Compare every priority with that of the same program in C++");
  command.option("-o,--output", arguments->directory, "Folder for the pictures and the table").default_value().value("DIR");
  command.flag("--json", arguments->json, "One JSON document instead of the table");
  command.run([arguments] { return run_flight(*arguments); });
}

}  // namespace sightline::app
