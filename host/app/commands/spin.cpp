#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/registry/turns.hpp"
#include "host/app/commands/commands.hpp"
#include "host/app/commands/turn_sheet.hpp"
#include "host/app/edge_options.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/progress.hpp"
#include "host/geometry/vector.hpp"
#include "host/picture/apng.hpp"
#include "host/programs/turn/tape.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline::app {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct SpinOptions {
  std::string scene;
  std::string out;
  std::string events;
  std::string tape;
  std::string memory = "8k";
  MeshArguments mesh;
  EdgeArguments edges;
  std::string method;  // empty: by the scene
  std::string vertical;  // empty: that of the file's format, or y
  std::string axis;      // empty: the vertical one
  std::optional<double> elevation;  // degrees
  std::optional<double> distance;   // of the eye; nullopt: parallel projection
  double step = 3;
  double tolerance = 0;
  int size = 480;
  int rate = 25;
  bool wire = false;

  // Whether the scene turns otherwise than about the vertical axis, seen level and in parallel projection.
  [[nodiscard]] bool circles() const { return !axis.empty() || elevation || distance; }
};

// Rotates a point so that the axis `vertical` becomes y.
scene::PolyPoint upright(const scene::PolyPoint& p, std::string_view vertical) {
  if (vertical == "x") return {-p[1], p[0], p[2]};
  if (vertical == "-x") return {p[1], -p[0], p[2]};
  if (vertical == "-y") return {-p[0], -p[1], p[2]};
  if (vertical == "z") return {p[0], p[2], -p[1]};
  if (vertical == "-z") return {p[0], -p[2], p[1]};
  return p;
}

// The scene with y as its vertical axis.
scene::PolyScene turn_upright(scene::PolyScene scene, std::string_view vertical) {
  for (scene::PolyPoint& vertex : scene.vertices) vertex = upright(vertex, vertical);
  // The axis of the turn is the vertical line through the middle.
  const scene::PolyPoint middle = scene::bounds_of(scene).middle();
  for (scene::PolyPoint& vertex : scene.vertices) {
    vertex[0] -= middle[0];
    vertex[2] -= middle[2];
  }
  return scene;
}

constexpr std::array<double, 2> distances{1.05, 8};

// The radius of a ball about the middle that contains all vertices, in units of the grid.
double radius_of(const scene::PolyScene& scene) {
  const scene::PolyPoint middle = scene::bounds_of(scene).middle();
  double radius = 1;
  for (const scene::PolyPoint& v : scene.vertices)
    radius = std::max(radius, geometry::length(geometry::difference(geometry::real_vector(v), geometry::real_vector(middle))));
  return radius;
}

// The eye's coordinates, like those of vertices, are below poly_coordinate_limit; it goes round the origin.
constexpr double farthest_eye = scene::poly_coordinate_limit - 2;

// A mesh is rounded to a coarser grid if the eye at that distance would be outside it: as if there were an eye this far away.
// nullopt: there is room.
std::optional<std::array<double, 3>> far_eye(const scene::PolyScene& scene, double distance) {
  const double far = distance * radius_of(scene);
  if (far <= farthest_eye) return std::nullopt;
  std::array<double, 3> eye = scene::file_point(scene, scene::bounds_of(scene).middle());
  eye[0] += 2.2 * far * scene.step;  // the grid's width is twice the limit
  return eye;
}

// How the eye goes round the scene, whose middle is moved to the origin. A scene of small numbers is enlarged, so that the eye can be
// placed finely. Error bad_input: the eye would be outside the grid.
registry::EyeCircle circle_about(scene::PolyScene& scene, const SpinOptions& options, std::string_view vertical) {
  registry::EyeCircle circle;
  const scene::PolyPoint middle = scene::bounds_of(scene).middle();
  std::int32_t largest = 1;
  for (scene::PolyPoint& v : scene.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] -= middle[i];
      largest = std::max(largest, std::abs(v[i]));
    }
  }
  double radius = radius_of(scene);
  std::int32_t factor = std::max((scene::poly_coordinate_limit / 2) / largest, 1);
  if (options.distance) {
    if (*options.distance * radius > farthest_eye)
      throw base::bad_input(fmt::format("{}: found coordinates too large for --distance {:g}, expected at most {:g}", options.scene, *options.distance,
                                        std::floor(farthest_eye / radius * 100) / 100));
    factor = std::min(factor, static_cast<std::int32_t>(farthest_eye / (*options.distance * radius)));
  }
  for (scene::PolyPoint& v : scene.vertices)
    for (std::int32_t& c : v) c *= factor;
  radius *= factor;
  if (!options.axis.empty()) {
    const geometry::Point axis = point_argument("--axis", options.axis);
    if (axis == geometry::Point{}) throw base::usage_error("--axis: found 0,0,0, expected a direction");
    for (const auto part : axis) {
      if (std::abs(part) > registry::most_axis_part)
        throw base::usage_error(fmt::format("--axis: found {}, expected whole numbers from {} to {}", options.axis, -registry::most_axis_part, registry::most_axis_part));
    }
    const scene::PolyPoint turned = upright({axis[0], axis[1], axis[2]}, vertical);
    circle.axis = {turned[0], turned[1], turned[2]};
  }
  circle.perspective = options.distance.has_value();
  const double far = circle.perspective ? *options.distance * radius : 0x1p20;
  const double elevation = options.elevation.value_or(0) * degree;
  circle.eye = {0, std::llround(far * std::sin(elevation)), std::llround(far * std::cos(elevation))};
  return circle;
}

// A mesh has too many events to compute.
const registry::TurnMethod& method_of(const SpinOptions& options, const scene::PolyScene& scene) {
  if (!options.method.empty()) return *registry::find_turn_method(options.method);
  const bool each_view =
      options.events.empty() && (!scene.surfaces.empty() || !scene::crossings_of(scene, 1).empty());
  return *registry::find_turn_method(each_view ? "exact" : "plantinga");
}

// Reads the events from the file if it exists; otherwise computes and writes them.
registry::PreparedTurn prepare_turn(const registry::TurnMethod& method, const scene::PolyScene& scene,
                                    const SpinOptions& options, const std::optional<registry::EyeCircle>& circle) {
  const bool keeps = !options.events.empty();
  const bool found = keeps && std::filesystem::exists(options.events);
  base::ProgressLine line;
  registry::TurnOptions turn;
  turn.tolerance = options.tolerance * degree;
  turn.edges = hidden_lines::edge_choice(options.edges.options(), scene);
  if (found) turn.found = options.events;
  turn.circle = circle;
  turn.progress = [&line](std::size_t done, std::size_t of) {
    line.show(fmt::format("events: {} of {} edges", done, of));
  };
  auto prepared = value_of(method.prepare(scene, turn), found ? options.events : options.scene);
  if (keeps && !found) {
    const auto kept = prepared.keep(options.events);
    if (!kept) throw base::io_error(kept.error().message());
  }
  return prepared;
}

// Writes the tape for the PDP-7.
void write_tape(const scene::PolyScene& scene, const SpinOptions& options) {
  namespace turn = programs::turn;
  const auto memory = options.memory == "32k" ? turn::Memory::words_32k : turn::Memory::words_8k;
  Output output(options.tape);
  output.write(turn::punch(value_of(turn::make_tape(scene, memory), options.scene)));
  output.commit();
}

void spin(const SpinOptions& options) {
  if (!options.out.ends_with(".apng") && !options.out.ends_with(".png")) {
    throw base::usage_error(fmt::format("{}: expected a name that ends in .apng or .png", options.out));
  }
  check_edges(options.edges);
  if (options.circles()) {
    const std::string_view given = !options.axis.empty() ? "--axis" : options.elevation ? "--elevation" : "--distance";
    for (const auto& [other, found] : {std::pair{"--events", !options.events.empty()}, std::pair{"--tape", !options.tape.empty()},
                                       std::pair{"--tolerance", options.tolerance > 0}}) {
      if (found) throw base::usage_error(fmt::format("{}: found with {}, expected a turn about the vertical axis, level and in parallel projection", other, given));
    }
  }
  scene::SceneFile file = find_scene(options.scene);
  MeshArguments mesh = options.mesh;
  if (options.distance) mesh.eye = far_eye(load_found(file, mesh.import_options()).scene, *options.distance);
  const scene::LoadedScene source = load_scene(std::move(file), options.scene, mesh);
  if (!options.tape.empty()) write_tape(source.scene, options);
  const std::string vertical = options.vertical.empty() ? std::string(1, "xyz"[source.report.vertical.value_or(1)]) : options.vertical;
  scene::PolyScene scene = turn_upright(source.scene, vertical);
  std::optional<registry::EyeCircle> circle;
  if (options.circles()) circle = circle_about(scene, options, vertical);
  const registry::TurnMethod& method = method_of(options, scene);
  if (method.name == "exact") scene = scene::with_crossings(std::move(scene));
  if (const auto reason = method.why_not(scene))
    throw base::bad_input(fmt::format("{}: {}; --method exact computes each view from scratch", options.scene, *reason));
  if (method.name == "exact" && !options.events.empty())
    throw base::usage_error("--events: found with --method exact, which computes no events");
  Output output(options.out);
  const registry::PreparedTurn turn = prepare_turn(method, scene, options, circle);
  const TurnSheet sheet = circle ? TurnSheet(scene, options.size, *circle) : TurnSheet(scene, options.size);
  picture::ApngWriter apng({1, static_cast<std::uint16_t>(options.rate)});
  std::vector<registry::TurnLine> lines;
  const int count = static_cast<int>(std::ceil(360 / options.step - 1e-9));
  base::ProgressLine progress;
  for (int i = 0; i < count; ++i) {
    progress.show(fmt::format("frame {} of {}", i + 1, count));
    const double angle = options.step * i * degree;
    (options.wire ? turn.whole : turn.visible)(angle, lines);
    const auto added = apng.add(sheet.image_of(lines));
    if (!added) throw base::usage_error(added.error().message());
  }
  const auto bytes = apng.finish();
  if (!bytes) throw base::usage_error(bytes.error().message());
  output.write(*bytes);
  output.commit();
  std::string counts;
  for (const registry::TurnCount& of : turn.counts) counts += fmt::format("{} {}, ", of.value, of.name);
  write_stdout(fmt::format("{}: {}{} frames\n", source.name, counts, count));
  check_stdout();
  report_written(options.out, fmt::format("{}, {} x {} pixels", count_text(static_cast<std::uint64_t>(count), "frame"), options.size, options.size));
}

}  // namespace

void add_spin_command(const Command& program) {
  const auto options = std::make_shared<SpinOptions>();
  const Command command = program.add_command("spin", help_page("spin"));
  command.option("SCENE", options->scene, scene_help).required();
  command.option("-o,--output", options->out, "The animated PNG").required().value("FILE");
  add_edge_options(command, options->edges);
  add_mesh_options(command, options->mesh);
  command
      .option("--events", options->events,
              "Read the events of the turn from this file; if it does not exist, compute and write them")
      .value("FILE");
  command
      .option("--tape", options->tape,
              "Also write the model with its events as a tape for the PDP-7, as in `sightline turn`")
      .value("FILE");
  command.option("--memory", options->memory, "Core of the machine for which the tape is made")
      .one_of({"8k", "32k"})
      .default_value();
  std::vector<std::string> methods;
  for (const registry::TurnMethod& method : registry::turn_methods()) methods.emplace_back(method.name);
  command.option("--method", options->method, "How the views of the turn are computed")
      .one_of(methods)
      .default_value("exact for a mesh and if bodies pass through each other, plantinga for others");
  command.option("--vertical", options->vertical, "Which axis points up, such as z or -y")
      .one_of({"x", "y", "z", "-x", "-y", "-z"})
      .value("AXIS")
      .default_value("that of the file's format, or y");
  command
      .option("--axis", options->axis,
              fmt::format("Turn about this direction through the middle of the scene, in the file's coordinates, such as 1,1,0; whole numbers from {} to {}",
                          -registry::most_axis_part, registry::most_axis_part))
      .value("X,Y,Z")
      .default_value("the vertical axis");
  command.option("--elevation", options->elevation, "See the scene from this many degrees above the horizontal")
      .value("DEGREES")
      .range(-85.0, 85.0)
      .default_value("0");
  command
      .option("--distance", options->distance,
              "Perspective: the distance of the eye from the middle of the scene, in units of that of the farthest vertex")
      .value("RATIO")
      .range(distances[0], distances[1])
      .default_value("parallel projection");
  command.option("--step", options->step, "Degrees from frame to frame")
      .value("DEGREES")
      .range(0.05, 180.0)
      .default_value();
  command.option("--tolerance", options->tolerance, "Join events within this many degrees; 0: exact")
      .value("DEGREES")
      .range(0.0, 30.0)
      .default_value();
  command.option("--size,--pixels", options->size, "Width and height in pixels")
      .range(16, 4096)
      .default_value();
  command.option("--rate", options->rate, "Frames per second").range(1, 100).default_value();
  command.flag("--wire", options->wire, "Draw every edge whole, hidden or not, for comparison");
  command.run([options] {
    require_finite("--step", options->step);
    require_finite("--tolerance", options->tolerance);
    spin(*options);
    return ExitCode::ok;
  });
}

}  // namespace sightline::app
