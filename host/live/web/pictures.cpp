// Requests about pictures: scenes, the algorithms that draw them, their lessons, and the programs of Jones and Skala on their
// machines.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/algorithms/skala/surface.hpp"
#include "host/explain/explain.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/programs/flight/program.hpp"
#include "host/programs/jones/encode.hpp"
#include "host/programs/jones/program.hpp"
#include "host/programs/jones/specification.hpp"
#include "host/programs/jones/twin/rotation.hpp"
#include "host/programs/skala/program.hpp"
#include "host/programs/skala/skala.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/programs/stripes/program.hpp"
#include "host/programs/turn/program.hpp"
#include "host/live/web/requests.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/heights/expression.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/heights/read_grid.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::live::web {
namespace {

namespace oracle = algorithms::oracle;
namespace skala = programs::skala;

Json vector_json(const scene::PolyPoint& p) { return Json::array({p[0], p[1], p[2]}); }

Json scene_json(const scene::LoadedScene& loaded) {
  const scene::PolyScene& scene = loaded.scene;
  Json vertices = Json::array();
  for (const auto& v : scene.vertices) vertices.push_back(vector_json(v));
  Json edges = Json::array();
  for (const auto& edge : picture::edges_of(scene)) edges.push_back(Json::array({edge.from, edge.to}));
  return Json{{"name", loaded.name},
              {"vertices", std::move(vertices)},
              {"edges", std::move(edges)},
              {"faces", scene::face_count(scene)},
              {"camera",
               {{"perspective", scene.camera.perspective},
                {"eye", vector_json(scene.camera.eye)},
                {"forward", vector_json(scene.camera.forward)},
                {"right", vector_json(scene.camera.right)},
                {"up", vector_json(scene.camera.up)}}}};
}

// An edge by its vertices, then the two ends of the piece as fractions. Exact, so that two builds can be compared.
Json pieces_json(const picture::LinePicture& picture) {
  Json pieces = Json::array();
  for (const auto& piece : picture.pieces) {
    pieces.push_back(Json::array({piece.edge.from, piece.edge.to, piece.low.numerator(), piece.low.denominator(), piece.high.numerator(),
                                  piece.high.denominator()}));
  }
  return pieces;
}

Json draw(Workbench& workbench, const Json& request) {
  auto loaded = scene_named(workbench, text_of(request, "scene"));
  if (!loaded) return error_answer(loaded.error().message());
  const auto camera = camera_of(loaded->scene, request);
  if (!camera) return error_answer(camera.error().message());
  const auto view = hidden_lines::visible_edges(loaded->scene, *camera, text_of(request, "algorithm"));
  if (!view) return error_answer(view.error().message());
  Json counts = Json::object();
  for (const auto& count : view->counts) counts[std::string(count.name)] = count.value;
  return Json{{"pieces", pieces_json(view->picture)}, {"counts", std::move(counts)}};
}

std::string grid_text(const Workbench& workbench, const std::string& name) {
  const Bytes* const bytes = workbench.file(name);
  return bytes != nullptr ? std::string(bytes->begin(), bytes->end()) : std::string();
}

// One line, for the page.
std::string message_of(const base::Error& error) {
  const std::string place = error.place.empty() ? "" : fmt::format("column {}: ", error.place);
  return fmt::format("{}: {}found {}, expected {}", error.file, place, error.found, error.expected);
}

// By "expression", over -"domain" to "domain"; or by the name of a function or of a file of the page. Sampled at "points" by
// "slices"; a file has its own size.
base::Result<scene::HeightGrid> known_heights(const Workbench& workbench, const Json& request) {
  const std::string name = text_of(request, "function");
  const auto size = [&](std::string_view key, double usual) {
    return static_cast<std::size_t>(std::clamp(number_of(request, key, usual), 2.0, 256.0));
  };
  const scene::GridSize wanted{size("points", 33), size("slices", 33)};
  if (request.find("expression") != nullptr) {
    const double half = std::clamp(number_of(request, "domain", 1), 1e-6, 1e6);
    auto grid = scene::sample_expression(text_of(request, "expression"), {{-half, half}, {-half, half}}, wanted, "f(x, z)");
    if (!grid) return base::bad_input(message_of(grid.error()));
    return grid;
  }
  if (workbench.file(name) != nullptr) return scene::read_height_grid(grid_text(workbench, name), name, {.thin_to_fit = true});
  const auto function = scene::height_function(name);
  if (!function) return base::bad_input(fmt::format("{}: no function of that name, expected one of {}", name, scene::height_function_names()));
  return scene::sample(*function, wanted);
}

skala::View view_of(const Json& request) {
  skala::View view;
  const std::string picture = text_of(request, "picture");
  view.subject = picture == "surface" ? skala::Subject::surface : picture == "contours" ? skala::Subject::contours : skala::Subject::lines;
  const std::string along = text_of(request, "along");
  view.family = along == "x" ? skala::Family::along_x : along == "z" ? skala::Family::along_z : along == "both" ? skala::Family::both : skala::Family::automatic;
  view.rotation = number_of(request, "rotation", 30);
  view.elevation = std::clamp(number_of(request, "elevation", 30), -90.0, 90.0);
  view.zoom = std::clamp(number_of(request, "zoom", 1), 0.05, 20.0);
  view.levels = static_cast<int>(std::clamp(number_of(request, "levels", 8), 1.0, 255.0));
  view.visibility = flag_of(request, "visibility", true);
  view.silhouette = view.subject == skala::Subject::contours;
  return view;
}

base::Result<scene::HeightGrid> grid_of(const Workbench& workbench, const Json& request) {
  auto grid = known_heights(workbench, request);
  const auto parts = static_cast<std::size_t>(std::clamp(number_of(request, "subdivide", 1), 1.0, 64.0));
  if (!grid || parts == 1) return grid;
  return algorithms::skala::finer_mesh(*grid, parts, algorithms::skala::smoothed_family(view_of(request)));
}

skala::Device device_of(const Json& request) {
  const std::string device = text_of(request, "device");
  return device == "alt256" ? skala::Device::alt256 : device == "calcomp" ? skala::Device::calcomp : device == "minigraf" ? skala::Device::minigraf : skala::Device::ef9365;
}

// Makes an 8080 with Skala's program, to which a host computer sends the picture.
Json make_skala(Workbench& workbench, const Json& request) {
  const auto grid = grid_of(workbench, request);
  if (!grid) return error_answer(grid.error().message());
  const skala::Device device = device_of(request);
  const skala::Program& program = skala::resident_program(!flag_of(request, "temporary_masks", true));
  workbench.put_file(".skala.stream", skala::stream_of(*grid, view_of(request), {device}));
  workbench.put_file(".skala.bin", program.memory);
  Json options{{"--load", Json::array({".skala.bin"})}, {"--parallel", ".skala.stream"}, {"--start", fmt::format("{:04X}", program.labels.start)}};
  if (skala::is_raster(device)) options["--board"] = device == skala::Device::ef9365 ? "ef9365" : "alt256";
  else options["--plotter"] = device == skala::Device::calcomp ? "calcomp" : "minigraf";
  Json made = workbench.answer(Json{{"do", "make"}, {"machine", "i8080"}, {"options", std::move(options)}});
  made["stream"] = workbench.file(".skala.stream")->size();
  made["start"] = program.labels.start;
  made["status"] = program.labels.status;
  made["drawing"] = program.labels.drawing;
  return made;
}

// The name of an expression's second variable; an error for a text that is no expression.
Json check_expression(const Json& request) {
  const auto parsed = scene::Expression::parse(text_of(request, "expression"), "f(x, z)");
  if (!parsed) return error_answer(message_of(parsed.error()));
  return Json{{"second", std::string(1, parsed->second())}};
}

// The cost of the visibility test: the drawing times with hidden lines removed and with all lines, on the same machine.
Json cost(Workbench& workbench, const Json& request) {
  const auto grid = grid_of(workbench, request);
  if (!grid) return error_answer(grid.error().message());
  skala::View view = view_of(request);
  view.visibility = true;
  const auto run = skala::run({.grid = *grid, .view = view, .device = device_of(request), .time_plain = true});
  if (!run) return error_answer(run.error().message());
  return Json{{"with", run->picture.drawing.count()}, {"without", run->plain_drawing->count()}};
}

// --- Jones

base::Result<scene::CellScene> jones_scene(const Workbench& workbench, const std::string& name) {
  auto loaded = scene_named(workbench, name);
  if (!loaded) return std::move(loaded.error());
  if (!loaded->cells) return base::bad_input(fmt::format("{}: not a scene of cells, which Jones's program needs", name));
  return std::move(*loaded->cells);
}

Json make_jones(Workbench& workbench, const Json& request) {
  const auto scene = jones_scene(workbench, text_of(request, "scene"));
  if (!scene) return error_answer(scene.error().message());
  const bool eae = flag_of(request, "eae", true);
  const bool rotation = flag_of(request, "rotation");
  const auto program = programs::jones::assemble_program(*scene, {.eae = eae, .walk = flag_of(request, "walk") || rotation, .rotation = rotation}, point_of(request.find("eye")));
  if (!program) return error_answer(program.error().message());
  machines::Program image{{}, program->labels.start};
  for (std::uint32_t at = 0; at < program->core.size(); ++at) image.words.emplace_back(at, program->core[at].value());
  std::uint32_t switches = (flag_of(request, "stereo") ? 1U : 0U) | (flag_of(request, "immediate") ? 2U : 0U);
  if (request.find("switches") != nullptr) switches |= static_cast<std::uint32_t>(number_of(request, "switches", 0)) & 0777777U;
  Json made = make_pdp7(workbench, ".jones.oct", {std::move(image), eae, Json::object(), program->symbols}, switches);
  MachineSession* const session = session_of(workbench, made);
  if (session == nullptr) return made;
  if (request.find("scale") != nullptr)
    session->machine().put(program->labels.scale, static_cast<std::uint32_t>(std::clamp(number_of(request, "scale", 512), 64.0, 4096.0)));
  if (rotation) session->machine().put(program->labels.first_angle, static_cast<std::uint32_t>(std::clamp(number_of(request, "angle", 0), 0.0, 359.0)));
  Json labels = Json::object();
  for (const char* const name : {"ex", "ey", "ez", "scale", "views", "status", "file", "shown", "runing", "stops", "angle"}) {
    const auto found = program->symbols.find(name);
    if (found != program->symbols.end()) labels[name] = found->second;
  }
  labels["search"] = program->labels.search;
  labels["start"] = program->labels.start;
  labels["scene"] = program->labels.scene;
  made["labels"] = std::move(labels);
  made["scene_words"] = program->scene.words.size();
  made["cells"] = scene->cells.size();
  made["words"] = program->words_used;
  return made;
}

// The exact picture of a scene of cells from "eye" at scale "scale", as in `compare`: the visible lines of the scene's matter in
// the program's windows, in points of the Type 340, [x0, y0, x1, y1]; with "stereo" those of both eyes; with "angle", degrees, of the
// view turned to the right.
Json sight(Workbench& workbench, const Json& request) {
  namespace jones = programs::jones;
  const auto scene = jones_scene(workbench, text_of(request, "scene"));
  if (!scene) return error_answer(scene.error().message());
  const auto given = point_of(request.find("eye"));
  if (!given) return error_answer("eye: expected three whole numbers");
  const auto place = jones::viewpoint(*scene, *given);
  if (!place) return error_answer(place.error().message());
  const auto matter = oracle::Matter::of(*scene);
  if (!matter) return error_answer("the scene is too large for exact lines");
  const auto scale = static_cast<std::int32_t>(std::clamp(number_of(request, "scale", 512), 64.0, 4096.0));
  const auto real_lines = matter->real_lines();
  const bool turned = request.find("angle") != nullptr;
  const jones::Direction direction = jones::direction_of(static_cast<std::int32_t>(std::clamp(number_of(request, "angle", 0), -360.0, 360.0)));
  Json lines = Json::array();
  const auto add = [&](jones::Pass pass, std::int32_t shift) {
    geometry::Point eye = *given;
    // Both eyes of a pair stay in the box in which the program moves.
    const auto [right, ahead] = jones::TurnedSteps().take(direction, shift, 0);
    if (shift != 0) eye[0] = std::clamp(eye[0] + right, place->limits.low[0], place->limits.high[0]);
    if (shift != 0) eye[2] = std::clamp(eye[2] + ahead, place->limits.low[2], place->limits.high[2]);
    const jones::Window shown = jones::window_of(pass, scale, 0);
    oracle::Window window;
    window.scale = shown.width_scale;
    window.centre = {shown.centre_x, shown.centre_y};
    window.points = {geometry::Span{shown.centre_x + shown.xlo, shown.centre_x + shown.xhi},
                     geometry::Span{shown.centre_y + shown.ylo, shown.centre_y + shown.yhi}};
    window.near = jones::near_z;
    const auto seen = turned ? oracle::turned_view(*matter, real_lines, eye, window, direction.cosine, direction.sine)
                             : oracle::on_screen(oracle::visible_lines(*matter, real_lines, eye, window), eye, window);
    for (const auto& line : seen)
      lines.push_back(Json::array({line.x0, line.y0, line.x1, line.y1}));
  };
  if (flag_of(request, "stereo")) {
    add(jones::Pass::left, -jones::separation);
    add(jones::Pass::right, jones::separation);
  } else {
    add(jones::Pass::mono, 0);
  }
  return Json{{"lines", std::move(lines)}};
}

Json explain(Workbench& workbench, const Json& request) {
  const explain::Explainer* const explainer = explain::find_explainer(text_of(request, "algorithm"));
  if (explainer == nullptr) return error_answer("there is no lesson of that name");
  base::Result<explain::Lesson> lesson = base::bad_input("");
  std::string name = text_of(request, "scene");
  if (explainer->heights != nullptr) {
    const auto grid = grid_of(workbench, request);
    if (!grid) return error_answer(grid.error().message());
    name = text_of(request, "function");
    lesson = explainer->heights(*grid, number_of(request, "rotation", 30), number_of(request, "elevation", 30));
  } else {
    auto loaded = scene_named(workbench, name);
    if (!loaded) return error_answer(loaded.error().message());
    const auto camera = camera_of(loaded->scene, request);
    if (!camera) return error_answer(camera.error().message());
    lesson = explain::explain_scene(*explainer, *loaded, *camera);
  }
  if (!lesson) return error_answer(lesson.error().message());
  lesson->scene = name;
  const auto text = explain::json_of(*lesson);
  return *base::parse_json(text, "lesson");
}

// The sources of the built-in programs, by folder and file: "jones/tape1-control.s".
Json firmware() {
  Json sources = Json::object();
  const auto add = [&sources](std::string_view folder, auto files) {
    for (const auto& [name, text] : files) sources[fmt::format("{}/{}", folder, name)] = text;
  };
  add("flight", programs::flight::embedded_sources());
  add("jones", programs::jones::firmware_tapes());
  add("skala", skala::embedded_sources());
  add("stripes", programs::stripes::embedded_sources());
  add("turn", programs::turn::firmware_tapes());
  return Json{{"sources", std::move(sources)}};
}

Json lists() {
  Json scenes = Json::array();
  for (const auto name : scene::builtin_scene_names()) scenes.push_back(name);
  Json functions = Json::array();
  for (const auto& function : scene::height_functions()) functions.push_back(Json{{"name", function.name}, {"formula", function.formula}, {"description", function.description}});
  Json algorithms = Json::array();
  for (const auto& algorithm : registry::line_algorithms()) algorithms.push_back(Json{{"name", algorithm.name}, {"description", algorithm.description}});
  Json lessons = Json::array();
  for (const auto& each : explain::explainers())
    lessons.push_back(Json{{"algorithm", each.algorithm}, {"summary", each.summary}, {"heights", each.heights != nullptr}});
  return Json{{"scenes", std::move(scenes)}, {"functions", std::move(functions)}, {"algorithms", std::move(algorithms)}, {"lessons", std::move(lessons)}};
}

}  // namespace

Json pictures_answer(Workbench& workbench, std::string_view what, const Json& request) {
  if (what == "lists") return lists();
  if (what == "firmware") return firmware();
  if (what == "scene") {
    const auto loaded = scene_named(workbench, text_of(request, "scene"));
    return loaded ? scene_json(*loaded) : error_answer(loaded.error().message());
  }
  if (what == "draw") return draw(workbench, request);
  if (what == "explain") return explain(workbench, request);
  if (what == "jones") return make_jones(workbench, request);
  if (what == "sight") return sight(workbench, request);
  if (what == "skala") return make_skala(workbench, request);
  if (what == "cost") return cost(workbench, request);
  if (what == "expression") return check_expression(request);
  return {};
}

}  // namespace sightline::live::web
