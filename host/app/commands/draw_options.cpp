// The options that the methods of `sightline draw` share.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "host/app/commands/draw.hpp"
#include "host/base/number.hpp"
#include "host/geometry/predicates.hpp"
#include "host/picture/png.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

namespace {

// --- from where

// Three whole numbers, their magnitudes below `limit`.
scene::PolyPoint vector_argument(std::string_view option, const std::string& text, std::int32_t limit) {
  if (const auto point = base::whole_numbers<std::int32_t, 3>(text, ',', 1 - limit, limit - 1)) return *point;
  throw Failure(ExitCode::usage,
                fmt::format("{}: found \"{}\", expected X,Y,Z, three whole numbers from {} to {}", option,
                            text, 1 - limit, limit - 1));
}

scene::PolyPoint direction_argument(std::string_view option, const std::string& text, std::int32_t limit) {
  const scene::PolyPoint direction = vector_argument(option, text, limit);
  if (direction == scene::PolyPoint{})
    throw Failure(ExitCode::usage, fmt::format("{}: found \"{}\", expected a direction", option, text));
  return direction;
}

void refuse_together(const CameraArguments& arguments) {
  const auto refuse = [](std::string_view a, const std::string& given_a, std::string_view b,
                         const std::string& given_b) {
    if (!given_a.empty() && !given_b.empty())
      throw Failure(ExitCode::usage, fmt::format("found {} and {}, expected one of them", a, b));
  };
  refuse("--orthographic", arguments.orthographic, "--eye", arguments.eye);
  refuse("--orthographic", arguments.orthographic, "--look-at", arguments.look_at);
  refuse("--orthographic", arguments.orthographic, "--forward", arguments.forward);
  refuse("--look-at", arguments.look_at, "--forward", arguments.forward);
  refuse("--vertical", arguments.vertical, "--forward", arguments.forward);
  if (arguments.forward.empty() != arguments.right.empty() || arguments.right.empty() != arguments.up.empty())
    throw Failure(ExitCode::usage, "expected --forward, --right and --up together, or none of them");
}

scene::PolyCamera exact_vectors(const CameraArguments& arguments, scene::PolyCamera camera) {
  camera.forward = direction_argument("--forward", arguments.forward, scene::camera_vector_limit);
  camera.right = direction_argument("--right", arguments.right, scene::camera_vector_limit);
  camera.up = direction_argument("--up", arguments.up, scene::camera_vector_limit);
  const auto square = [](const scene::PolyPoint& a, const scene::PolyPoint& b) {
    return geometry::dot(geometry::vector_of(a), geometry::vector_of(b)) == 0;
  };
  if (!square(camera.forward, camera.right) || !square(camera.forward, camera.up) ||
      !square(camera.right, camera.up)) {
    throw Failure(ExitCode::usage, fmt::format("found --forward {} --right {} --up {}, expected right angles "
                                               "between them",
                                               arguments.forward, arguments.right, arguments.up));
  }
  return camera;
}

scene::PolyCamera aimed(const CameraArguments& arguments, const scene::PolyScene& scene) {
  const scene::SceneFrame frame = frame_of(arguments, scene);
  if (!arguments.orthographic.empty()) {
    return aimed_camera(
        frame, bounds_of(scene).middle(),
        direction_argument("--orthographic", arguments.orthographic, scene::poly_coordinate_limit), false);
  }
  scene::PolyCamera camera = scene.camera;
  if (!arguments.vertical.empty() && !scene.vertices.empty()) camera = three_quarter_camera(frame, scene);
  if (arguments.eye.empty() && arguments.look_at.empty()) return camera;
  if (!arguments.eye.empty())
    camera.eye = vector_argument("--eye", arguments.eye, scene::poly_coordinate_limit);
  camera.perspective = true;
  const scene::PolyBounds bounds = bounds_of(scene);
  if (arguments.look_at.empty() && bounds.contain(camera.eye)) return camera;
  scene::PolyPoint target = bounds.middle();
  if (!arguments.look_at.empty())
    target = vector_argument("--look-at", arguments.look_at, scene::poly_coordinate_limit);
  scene::PolyPoint direction{};
  for (std::size_t a = 0; a < 3; ++a) direction[a] = target[a] - camera.eye[a];
  if (direction == scene::PolyPoint{}) {
    throw Failure(ExitCode::usage,
                  fmt::format("--look-at: found the eye itself, {},{},{}", target[0], target[1], target[2]));
  }
  return aimed_camera(frame, camera.eye, direction);
}

// --- where to

constexpr double widest_paper = 10'000;  // millimetres

std::pair<int, int> size_argument(const char* option, const std::string& text, int most) {
  if (const auto size = base::whole_numbers<int, 2>(text, 'x', 1, most)) return {(*size)[0], (*size)[1]};
  throw Failure(ExitCode::usage,
                fmt::format("{}: found \"{}\", expected WIDTHxHEIGHT, both 1 to {}", option, text, most));
}

std::optional<DrawingFormat> format_of(const std::string& file) {
  const std::size_t dot = file.rfind('.');
  std::string ending = dot == std::string::npos ? std::string() : file.substr(dot);
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".svg") return DrawingFormat::svg;
  if (ending == ".png") return DrawingFormat::png;
  if (ending == ".plt" || ending == ".hpgl") return DrawingFormat::hpgl;
  return std::nullopt;
}

void refuse_sizes_of_others(const DrawOutput& output, DrawingFormat format) {
  constexpr std::string_view on_paper = "a name that ends in .svg, .plt or .hpgl";
  if (format != DrawingFormat::png) {
    refuse_option(output, "--pixels", "a name that ends in .png");
  } else {
    refuse_option(output, "--size", on_paper);
    refuse_option(output, "--margin", on_paper);
  }
  if (format != DrawingFormat::svg) refuse_option(output, "--pen", "a name that ends in .svg");
}

}  // namespace

void add_camera_options(const Command& command, CameraArguments& arguments) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    command.option(name, value, help).value("X,Y,Z").group("View");
  };
  add("--eye", arguments.eye, "Look from this point");
  add("--look-at", arguments.look_at, "Look at this point");
  add("--orthographic", arguments.orthographic, "No perspective: look in this direction");
  add("--forward", arguments.forward,
      "With --right and --up: the camera's vectors themselves, at right angles");
  add("--right", arguments.right, "See --forward");
  add("--up", arguments.up, "See --forward");
  command.option("--vertical", arguments.vertical, "Which axis points up, such as z or -y")
      .one_of({"x", "y", "z", "-x", "-y", "-z"})
      .value("AXIS")
      .group("View");
}

scene::SceneFrame frame_of(const CameraArguments& arguments, const scene::PolyScene& scene) {
  scene::SceneFrame frame = scene::frame_of(scene.camera);
  if (arguments.vertical.empty()) return frame;
  frame.downwards = arguments.vertical.size() == 2;
  frame.vertical = static_cast<std::size_t>(arguments.vertical.back() - 'x');
  return frame;
}

scene::PolyCamera camera_of(const CameraArguments& arguments, const scene::PolyScene& scene,
                            const std::string& source) {
  refuse_together(arguments);
  scene::PolyCamera camera;
  if (arguments.forward.empty()) {
    camera = aimed(arguments, scene);
  } else {
    camera = exact_vectors(arguments, scene.camera);
    if (!arguments.eye.empty()) {
      camera.eye = vector_argument("--eye", arguments.eye, scene::poly_coordinate_limit);
      camera.perspective = true;
    }
  }
  if (auto error = scene::eye_error(scene, camera)) {
    error->file = source;
    throw Failure(ExitCode::bad_input, error->message());
  }
  return camera;
}

void add_draw_output_options(const Command& command, DrawOutput& output) {
  output.command = command;
  command
      .option("-o,--output", output.file,
              "The drawing; the ending says what it is: .svg, .png, .plt or .hpgl")
      .required()
      .value("FILE");
  command.option("--size", output.size, "Size of the paper in mm, for .svg, .plt and .hpgl")
      .default_value()
      .value("WxH");
  command.option("--margin", output.paper.margin, "Margin around the drawing in mm, for .svg, .plt and .hpgl")
      .default_value()
      .range(0.0, 1000.0)
      .value("MM");
  command.option("--pen", output.paper.pen, "Width of a line in mm, for .svg")
      .default_value()
      .range(0.01, 10.0)
      .value("MM");
  command.option("--pixels", output.pixels, "Size of the image, for .png").default_value().value("WxH");
}

void refuse_option(const DrawOutput& output, const std::string& option, std::string_view needed) {
  if (output.command->is_given(option))
    throw Failure(ExitCode::usage, fmt::format("{}: found without {}", option, needed));
}

DrawingFormat read_draw_output(DrawOutput& output) {
  const auto format = format_of(output.file);
  if (!format)
    throw Failure(ExitCode::usage,
                  fmt::format("{}: expected a name that ends in .svg, .png, .plt or .hpgl", output.file));
  refuse_sizes_of_others(output, *format);
  const auto [width, height] = size_argument("--size", output.size, static_cast<int>(widest_paper));
  output.paper.width = width;
  output.paper.height = height;
  // A value that is not a number (nan) passes the ranges of the options.
  if (!std::isfinite(output.paper.margin) || !std::isfinite(output.paper.pen)) {
    throw Failure(ExitCode::usage, fmt::format("{}: found no number, expected millimetres",
                                               std::isfinite(output.paper.pen) ? "--margin" : "--pen"));
  }
  if (2 * output.paper.margin >= std::min(width, height)) {
    throw Failure(ExitCode::usage, fmt::format("--margin: found {} mm on both sides of {}, expected less",
                                               output.paper.margin, output.size));
  }
  const auto [columns, rows] = size_argument("--pixels", output.pixels, picture::png_size_limit);
  output.image.width = columns;
  output.image.height = rows;
  return *format;
}

void write_drawing(const picture::VectorDrawing& drawing, const DrawOutput& output, DrawingFormat format,
                   const std::string& title, Output& file) {
  if (drawing.lines.empty() && drawing.facets.empty())
    warn(fmt::format("{}: the drawing is empty, nothing is in view", output.file));
  if (format == DrawingFormat::svg) {
    file.write(std::string_view(svg_of(drawing, output.paper, title)));
  } else if (format == DrawingFormat::hpgl) {
    file.write(std::string_view(hpgl_of(drawing, output.paper)));
  } else {
    const auto bytes =
        picture::encode_png(image_of(drawing, output.image), {{"Title", title}, {"Software", "sightline"}});
    if (!bytes) throw Failure(ExitCode::io, bytes.error().message());
    file.write(std::span<const std::uint8_t>(*bytes));
  }
  file.commit();
}

}  // namespace sightline::app
