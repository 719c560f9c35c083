// `sightline draw METHOD SCENE` for methods that find the visible face at each point.

#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "host/algorithms/willis/spans.hpp"
#include "host/app/commands/draw.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/file.hpp"
#include "host/base/json.hpp"
#include "host/base/number.hpp"
#include "host/base/progress.hpp"
#include "host/base/result.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/face_shades.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::app {

namespace {

struct DrawFacesArguments {
  std::string scene;
  MeshArguments mesh;
  bool go_on = false;
  CameraArguments camera;
  std::optional<double> field;
  registry::FaceOptions options;
  std::string output;
  std::string pixels = "512x512";
  std::string picture = "faces";
  int frames = 100;
  bool json = false;
};

std::pair<int, int> faces_size(const std::string& text) {
  if (const auto size = base::whole_numbers<int, 2>(text, 'x', 1, picture::png_size_limit))
    return {(*size)[0], (*size)[1]};
  throw base::usage_error(fmt::format("--pixels: found \"{}\", expected WIDTHxHEIGHT, both 1 to {}",
                                             text, picture::png_size_limit));
}

void name_not_solved(const registry::PreparedFaces& prepared) {
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < prepared.not_solved.size() && i < most; ++i) warn(prepared.not_solved[i]);
  if (prepared.not_solved.size() > most)
    warn(fmt::format("and {} more pairs of faces that could not be separated",
                     prepared.not_solved.size() - most));
}

// A flight looks at the middle of the scene. Without a given camera position it avoids all buildings: the circle is as wide as
// necessary, and if the scene's coordinates do not suffice for that, as high as necessary.
scene::PolyCamera start_of_flight(const CameraArguments& arguments, const scene::PolyScene& scene,
                                  const scene::PolyCamera& camera, int frames) {
  const scene::SceneFrame frame = frame_of(arguments, scene);
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  const scene::PolyPoint middle = bounds.middle();
  const auto looking_from = [&](const scene::PolyPoint& eye) {
    scene::PolyPoint direction{};
    for (std::size_t a = 0; a < 3; ++a) direction[a] = middle[a] - eye[a];
    return direction == scene::PolyPoint{} ? camera : aimed_camera(frame, eye, direction);
  };
  const scene::PolyCamera start = looking_from(camera.eye);
  if (!arguments.eye.empty()) return start;
  const auto is_clear = [&](const scene::PolyCamera& from) {
    for (int i = 0; i < frames; ++i) {
      const auto at = eye_of_turn(frame, scene, from, i, frames);
      if (!at) return false;
      scene::PolyCamera moved = from;
      moved.eye = *at;
      if (scene::eye_error(scene, moved)) return false;
    }
    return true;
  };
  if (is_clear(start)) return start;
  for (const bool higher : {false, true}) {
    for (std::int64_t step = 1; step <= 8; ++step) {
      scene::PolyPoint eye = camera.eye;
      bool within = true;
      for (std::size_t a = 0; a < 3; ++a) {
        std::int64_t place = eye[a];
        if (higher && a == frame.vertical) place += (frame.downwards ? -step : step) * bounds.half_size() / 4;
        if (!higher && a != frame.vertical) place = middle[a] + (place - middle[a]) * (8 + step) / 8;
        within = within && std::abs(place) < scene::poly_coordinate_limit;
        eye[a] = static_cast<std::int32_t>(within ? place : 0);
      }
      if (!within) break;
      if (const scene::PolyCamera wider = looking_from(eye); is_clear(wider)) return wider;
    }
  }
  return start;  // the error then comes from the flight, with the number of the frame
}

// Black where the face number changes, white elsewhere.
picture::Image outline_image(const picture::PixelGrid& faces) {
  const picture::PixelGrid lines = algorithms::willis::outlines(faces);
  picture::Image image(faces.width, faces.height, 1);
  for (int row = 0; row < faces.height; ++row)
    for (int column = 0; column < faces.width; ++column)
      image.pixels[image.index(column, faces.height - 1 - row)] = lines.at(column, row) != 0 ? 0 : 0xFF;
  return image;
}

base::Bytes fly(const DrawFacesArguments& arguments, const scene::LoadedScene& source,
                const registry::PreparedFaces& prepared, const scene::PolyCamera& start,
                const registry::FaceWindow& window) {
  const scene::SceneFrame frame = frame_of(arguments.camera, source.scene);
  const auto shades = picture::face_shades(source.scene);
  picture::ApngWriter writer({1, 25}, 0, {{"Title", source.name}, {"Software", "sightline"}});
  for (int i = 0; i < arguments.frames; ++i) {
    const scene::PolyCamera camera = view_of_turn(frame, source.scene, start, i, arguments.frames);
    if (const auto error = scene::eye_error(source.scene, camera)) {
      throw base::bad_input(fmt::format("{}: frame {} of the flight: {}; --eye says where the flight begins",
                                                     source.name, i, error->message()));
    }
    const auto view = value_of(prepared.view(camera, window), source.name);
    const auto added = writer.add(arguments.picture == "lines" ? outline_image(view.faces)
                                                               : picture::shaded_image(view.faces, shades));
    if (!added) throw base::io_error(added.error().message());
  }
  auto bytes = writer.finish();
  if (!bytes) throw base::io_error(bytes.error().message());
  return std::move(*bytes);
}

base::Bytes draw_still(const DrawFacesArguments& arguments, const scene::LoadedScene& source,
                       const registry::FaceView& view) {
  const auto bytes =
      picture::encode_png(arguments.picture == "lines" ? outline_image(view.faces)
                                                       : picture::shaded_image(view.faces, picture::face_shades(source.scene)),
                          {{"Title", source.name}, {"Software", "sightline"}});
  if (!bytes) throw base::io_error(bytes.error().message());
  return *bytes;
}

void print_faces_summary(const registry::FaceAlgorithm& algorithm, const DrawFacesArguments& arguments,
                         const scene::LoadedScene& source, const registry::PreparedFaces& prepared,
                         const std::vector<registry::FaceCount>& counts) {
  using base::Json;
  const auto object = [](const std::vector<registry::FaceCount>& list) {
    Json result = Json::object();
    for (const auto& count : list) result[std::string(count.name)] = count.value;
    return result;
  };
  const Json document{
      {"schema", "sightline/draw/1"},        {"algorithm", algorithm.name},      {"scene", source.name},
      {"output", arguments.output},          {"model", object(prepared.counts)}, {"counts", object(counts)},
      {"not_separated", prepared.not_solved}};
  print_json(document);
}

ExitCode run_draw_faces(const registry::FaceAlgorithm& algorithm, const DrawFacesArguments& arguments) {
  const bool flight = arguments.output.ends_with(".apng");
  if (!flight && !arguments.output.ends_with(".png")) {
    throw base::usage_error(fmt::format("{}: expected a name that ends in .png or, for a flight, .apng", arguments.output));
  }
  const auto [width, height] = faces_size(arguments.pixels);
  MeshArguments mesh = arguments.mesh;
  mesh.eye = eye_of(arguments.camera);
  const scene::LoadedScene source = load_scene(arguments.scene, mesh);
  const std::size_t faces = scene::face_count(source.scene);
  reject_long_work(source, algorithm.name, algorithm.mesh_time, arguments.go_on);
  scene::PolyCamera camera = camera_of(arguments.camera, source.scene, source.name);
  const std::optional<double> field = image_field(arguments.field, source.scene, camera);
  if (flight && !camera.perspective)
    throw base::usage_error(fmt::format("{}: expected perspective for a flight", arguments.output));
  if (flight) camera = start_of_flight(arguments.camera, source.scene, camera, arguments.frames);
  Output file(arguments.output);
  registry::FaceOptions options = arguments.options;
  options.vertical = frame_of(arguments.camera, source.scene).vertical;
  std::optional<base::ProgressClock> clock;
  clock.emplace(fmt::format("{}: {} faces", algorithm.name, faces));
  const auto prepared = value_of(algorithm.prepare(source.scene, options), source.name);
  clock.reset();
  name_not_solved(prepared);
  constexpr double usual_field = 60;
  const auto extent = flight && !field ? std::optional(usual_field) : field;
  const registry::FaceWindow window = registry::face_window(source.scene, camera, width, height, extent);
  std::vector<registry::FaceCount> counts;
  if (flight) {
    file.write(std::span<const std::uint8_t>(fly(arguments, source, prepared, camera, window)));
  } else {
    const auto view = value_of(prepared.view(camera, window), source.name);
    counts = view.counts;
    file.write(std::span<const std::uint8_t>(draw_still(arguments, source, view)));
  }
  file.commit();
  if (arguments.json) {
    print_faces_summary(algorithm, arguments, source, prepared, counts);
  } else {
    report_written(arguments.output, fmt::format("{}, {} x {} pixels", flight ? count_text(static_cast<std::uint64_t>(arguments.frames), "frame") : count_text(faces, "face"), width, height));
  }
  return ExitCode::ok;
}

}  // namespace

void add_draw_faces(const Command& command, const registry::FaceAlgorithm& algorithm) {
  const auto arguments = std::make_shared<DrawFacesArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  command
      .option("-o,--output", arguments->output, "The picture (.png), or a flight once around the scene (.apng)")
      .required()
      .value("FILE");
  add_camera_options(command, arguments->camera);
  add_field_option(command, arguments->field, "the whole scene; for a flight 60 degrees");
  add_mesh_options(command, arguments->mesh);
  if (algorithm.mesh_time.seconds > 0) add_go_on_option(command, arguments->go_on);
  command
      .option("--pixels", arguments->pixels,
              "Size of the image; at 512x512 the picture is that of the priority display")
      .default_value()
      .value("WxH");
  command.option("--picture", arguments->picture, "Filled faces, or the lines between them")
      .one_of({"faces", "lines"})
      .default_value();
  command.option("--frames", arguments->frames, "Frames of a flight, 25 per second").range(1, 10'000).default_value();
  command.option("--depth", arguments->options.depth, "Cut each surface at most this many times")
      .range(0, 1000)
      .default_value("30");
  command.flag(
      "--plan", arguments->options.plan,
      "Measure in plan, along the scene's vertical, as the paper does: walls only, seen from between "
      "their feet and tops");
  command.flag("--rule90", arguments->options.rule90,
               "The paper's rule that normals be within 90 degrees, which is wrong");
  command.flag("--json", arguments->json, "Print what was drawn as one JSON document on standard output");
  command.run([arguments, &algorithm] { return run_draw_faces(algorithm, *arguments); });
}

}  // namespace sightline::app
