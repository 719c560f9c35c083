// `sightline scene`: describes, checks, converts, generates and decomposes scenes.
#include "host/scene/generate/scene.hpp"

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

#include "host/app/commands/commands.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/base/text.hpp"
#include "host/base/text_table.hpp"
#include "host/explain/cell_diagrams.hpp"
#include "host/explain/explain.hpp"
#include "host/hidden_lines/hidden_lines.hpp"
#include "host/programs/jones/encode.hpp"
#include "host/scene/check/cell_complex.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/model/file_units.hpp"
#include "host/scene/model/poly_scene.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::app {

namespace {

using base::Json;
using base::TextTable;

// The number of openings that lead outside.
std::size_t openings_outside(const scene::CellComplex& complex) {
  return static_cast<std::size_t>(
      std::count_if(complex.openings.begin(), complex.openings.end(), [](const auto& opening) {
        return opening.cells[0] == scene::outside || opening.cells[1] == scene::outside;
      }));
}

std::string_view method_name(scene::DecompositionMethod method) {
  return method == scene::DecompositionMethod::bsp ? "bsp" : "grid";
}

std::size_t sheet_count(const scene::PolyScene& scene) {
  return static_cast<std::size_t>(
      std::count_if(scene.bodies.begin(), scene.bodies.end(), [](const scene::PolyBody& body) { return body.sheet; }));
}

// Writes a scene in the format of the file's extension; JSON on standard output (-). `name`: the scene's name in errors.
void write_scene(const scene::PolyScene& scene, const std::string& name, const std::string& path) {
  const auto format = scene::poly_format_of(path);
  if (path != "-" && !(format && scene::can_be_written(*format))) {
    throw base::usage_error(fmt::format("--output: found \"{}\", expected a name that ends in {}", path, scene::poly_endings));
  }
  const std::string text = value_of(scene::write_poly(scene, format.value_or(scene::PolyFormat::json)), name);
  Output output(path);
  output.write(text);
  output.commit();
  const std::size_t sheets = sheet_count(scene);
  std::string what = count_text(scene.bodies.size() - sheets, "solid");
  if (sheets > 0) what += ", " + count_text(sheets, "sheet");
  if (!scene.wires.empty()) what += fmt::format(", {} without faces", count_text(scene.wires.size(), "line"));
  report_written(path, fmt::format("{}, {}, {}", what, count_text(scene::face_count(scene), "face"), count_text(scene.vertices.size(), "vertex", "vertices")));
}

// --- tape

struct TapeArguments {
  std::string scene;
  std::string at;
  bool walk = false;
  std::string output = "-";
};

ExitCode tape(const TapeArguments& arguments) {
  std::optional<geometry::Point> eye;
  if (!arguments.at.empty()) eye = point_argument("--at", arguments.at);
  const scene::CellScene scene = load_cells(arguments.scene);
  const std::string text = value_of(programs::jones::write_tape(scene, eye, arguments.walk ? programs::jones::Tape::walk : programs::jones::Tape::view), arguments.scene);
  Output output(arguments.output);
  output.write(text);
  output.commit();
  report_written(arguments.output, fmt::format("{}, {}", count_text(scene.cells.size(), "cell"), count_text(scene.openings.size(), "portal")));
  return ExitCode::ok;
}

void add_tape(const Command& parent) {
  const Command command = parent.add_command("tape", help_page("scene_tape"));
  const auto arguments = std::make_shared<TapeArguments>();
  command.option("SCENE", arguments->scene, cells_help).required();
  command.option("--at,--eye", arguments->at, "The eye").default_value("the scene's own view").value("X,Y,Z");
  command.flag("--walk", arguments->walk, "For a program assembled with WALK=1: with the planes of the cells");
  command.option("-o,--output", arguments->output, "The tape; - is standard output")
      .default_value()
      .value("FILE");
  command.run([arguments] { return tape(*arguments); });
}

// --- check

struct ShowArguments {
  std::string scene;
  MeshArguments mesh;
  bool json = false;
};

// Reports the defects of a scene; for a mesh, also whether the other commands would repair them.
ExitCode check(const ShowArguments& arguments) {
  scene::SceneReading reading = scene::read_scene(find_scene(arguments.scene));
  const std::string& name = reading.loaded.name;
  // The position of the eye can only be checked among correct bodies.
  if (reading.errors.empty() && reading.loaded.kind != scene::SceneKind::cells) {
    if (auto error = scene::eye_error(reading.loaded.scene, reading.loaded.scene.camera)) {
      error->file = name;
      reading.errors.push_back(std::move(*error));
    }
  }
  const bool possible = reading.errors.empty();
  if (arguments.json) {
    Json errors = Json::array();
    for (const base::Error& error : reading.errors)
      errors.push_back({{"place", error.place}, {"cause", error.found}});
    print_json({{"schema", "sightline/scene-check/1"},
                {"scene", name},
                {"possible", possible},
                {"errors", std::move(errors)}});
  } else {
    for (const base::Error& error : reading.errors) print_message(error.message());
    warn_of_changes(reading.loaded.report);
    if (possible) {
      write_stdout(name + ": a possible scene\n");
    } else if (reading.loaded.report.mended) {
      write_stdout(name + ": all other commands repair this, unless --strict is given\n");
    }
  }
  return possible ? ExitCode::ok : ExitCode::bad_input;
}

// --- info

constexpr const char* info_schema = "sightline/scene-info/1";

std::string box_text(const geometry::Point& low, const geometry::Point& high) {
  return fmt::format("x {}..{}  y {}..{}  z {}..{}", low[0], high[0], low[1], high[1], low[2], high[2]);
}

Json box_json(const geometry::Box& box) {
  return Json::array({box.low, box.high});
}

TextTable facts_table() {
  return TextTable({-15, 0});
}

void describe_cells(const scene::CellScene& scene, const std::string& name, bool json) {
  const programs::jones::EncodedScene core = value_of(programs::jones::encode(scene), name);
  std::size_t lines = 0;
  for (const scene::Cell& cell : scene.cells) lines += cell.lines.size();
  if (json) {
    print_json({{"schema", info_schema},
                {"name", scene.name},
                {"cells", scene.cells.size()},
                {"openings", scene.openings.size()},
                {"solids", scene.solids.size()},
                {"walls", scene.walls.size()},
                {"cell_lines", lines},
                {"outer", box_json(scene.outer)},
                {"default_view", scene.default_view},
                {"initial_cell", core.view.cell},
                {"eye_limits", box_json(core.view.limits)},
                {"words", core.words.size()},
                {"cell_words", core.cell_words},
                {"opening_words", core.opening_words}});
    return;
  }
  TextTable facts = facts_table();
  facts.row({"name", scene.name});
  facts.row({"cells", fmt::format("{}, with {}", scene.cells.size(), count_text(lines, "line"))});
  facts.row({"openings", fmt::format("{}", scene.openings.size())});
  facts.row({"matter", count_text(scene.solids.size(), "solid") + ", " + count_text(scene.walls.size(), "wall")});
  facts.row({"outer box", box_text(scene.outer.low, scene.outer.high)});
  facts.row({"default view", fmt::format("{}, in cell {}", base::joined(scene.default_view, ","), core.view.cell)});
  facts.row({"eye may move", box_text(core.view.limits.low, core.view.limits.high)});
  facts.row({"words of core", fmt::format("{} of {} (cells {}, openings {}, header {})", core.words.size(),
                                          programs::jones::core_words, core.cell_words, core.opening_words,
                                          programs::jones::scene_header_words)});
  write_stdout(facts.text());
}

struct PolyCounts {
  explicit PolyCounts(const scene::PolyScene& scene) : sheets(sheet_count(scene)) {
    for (const scene::PolyBody& body : scene.bodies) {
      for (const scene::PolyFace& face : body.faces) holes += face.holes.size();
      const auto sides = scene::face_edges(body);
      for (std::size_t i = 0; i < sides.size(); ++i)
        edges += i == 0 || !sides[i].same_edge(sides[i - 1]) ? 1U : 0U;
    }
  }

  std::size_t sheets = 0;
  std::size_t edges = 0;
  std::size_t holes = 0;
};

Json polyhedra_json(const scene::PolyScene& scene) {
  const PolyCounts counts(scene);
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  return {{"schema", info_schema},
          {"name", scene.name},
          {"vertices", scene.vertices.size()},
          {"edges", counts.edges},
          {"faces", scene::face_count(scene)},
          {"holes", counts.holes},
          {"bodies", scene.bodies.size()},
          {"sheets", counts.sheets},
          {"wires", scene.wires.size()},
          {"bounds", Json::array({scene::file_point(scene, bounds.low), scene::file_point(scene, bounds.high)})},
          {"bounds_steps", Json::array({bounds.low, bounds.high})},
          {"surfaces", scene.surfaces.size()},
          {"step", scene.step},
          {"origin", scene.origin}};
}

void list_polyhedra(const scene::PolyScene& scene, TextTable& facts) {
  const PolyCounts counts(scene);
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  if (!scene.name.empty()) facts.row({"name", scene.name});
  facts.row({"vertices", fmt::format("{}", scene.vertices.size())});
  facts.row({"edges", fmt::format("{}", counts.edges)});
  facts.row({"faces", fmt::format("{}, with {}", scene::face_count(scene), count_text(counts.holes, "hole"))});
  facts.row(
      {"bodies", count_text(scene.bodies.size() - counts.sheets, "solid") + ", " + count_text(counts.sheets, "sheet")});
  if (!scene.wires.empty()) facts.row({"lines", fmt::format("{} without faces", scene.wires.size())});
  if (!scene.surfaces.empty()) facts.row({"surfaces", count_text(scene.surfaces.size(), "plane or single face", "planes and single faces")});
  const auto low = scene::file_point(scene, bounds.low);
  const auto high = scene::file_point(scene, bounds.high);
  facts.row({"bounds", fmt::format("x {}..{}  y {}..{}  z {}..{}", low[0], high[0], low[1], high[1], low[2], high[2])});
  facts.row({"step", fmt::format("{}", scene.step)});
  facts.row({"camera", fmt::format("{} at {}", scene.camera.perspective ? "perspective" : "orthographic",
                                   scene::file_point_text(scene, scene.camera.eye))});
}

void describe_polyhedra(const scene::LoadedScene& loaded, bool json) {
  const scene::PolyImportReport& report = loaded.report;
  if (json) {
    Json document = polyhedra_json(loaded.scene);
    document.update({{"unit", report.unit},
                     {"vertical", report.vertical ? Json(std::string(1, "xyz"[*report.vertical])) : Json()},
                     {"quantised", report.quantised},
                     {"largest_shift", report.largest_shift},
                     {"split_faces", report.faces.split_faces},
                     {"largest_deviation", report.faces.largest_deviation}});
    return print_json(document);
  }
  warn_of_changes(report);
  TextTable facts = facts_table();
  list_polyhedra(loaded.scene, facts);
  if (!report.unit.empty()) facts.row({"unit", report.unit});
  write_stdout(facts.text());
}

void describe_decomposition(const scene::LoadedScene& loaded, bool json) {
  const scene::CellComplex& complex = loaded.decomposition->complex;
  const std::string_view method = method_name(loaded.decomposition->method);
  const std::size_t outside = openings_outside(complex);
  if (json) {
    Json document = polyhedra_json(loaded.scene);
    document.update({{"method", method},
                     {"cells", complex.cells.size()},
                     {"openings", complex.openings.size()},
                     {"openings_outside", outside},
                     {"cell_lines", complex.lines.size()},
                     {"planes", complex.planes.size()},
                     {"outer", box_json(complex.outer)}});
    return print_json(document);
  }
  TextTable facts = facts_table();
  list_polyhedra(loaded.scene, facts);
  facts.row(
      {"cells", fmt::format("{}, with {}; by {}", complex.cells.size(), count_text(complex.lines.size(), "line"), method)});
  facts.row({"openings", fmt::format("{}, {} of them to outside", complex.openings.size(), outside)});
  facts.row({"planes", fmt::format("{}", complex.planes.size())});
  facts.row({"outer box", box_text(complex.outer.low, complex.outer.high)});
  write_stdout(facts.text());
}

ExitCode info(const ShowArguments& arguments) {
  const scene::LoadedScene loaded = load_found(find_scene(arguments.scene), arguments.mesh.import_options());
  warn_of_units(loaded, arguments.mesh);
  switch (loaded.kind) {
    case scene::SceneKind::cells: describe_cells(*loaded.cells, loaded.name, arguments.json); break;
    case scene::SceneKind::polyhedra: describe_polyhedra(loaded, arguments.json); break;
    case scene::SceneKind::cell_complex: describe_decomposition(loaded, arguments.json); break;
  }
  return ExitCode::ok;
}

void add_show(const Command& parent, const char* name, ExitCode (*show)(const ShowArguments&), bool mends) {
  const Command command = parent.add_command(name, help_page(std::string("scene_") + name));
  const auto arguments = std::make_shared<ShowArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  if (mends) add_mesh_options(command, arguments->mesh);
  command.flag("--json", arguments->json, "One JSON document instead of lines");
  command.run([arguments, show] { return show(*arguments); });
}

// --- list

ExitCode list(bool json) {
  const auto cells = scene::builtin_scene_names();
  const auto models = scene::builtin_model_names();
  auto names = cells;
  names.insert(names.end(), models.begin(), models.end());
  if (json) {
    print_json({{"schema", "sightline/scene-list/1"}, {"scenes", names}, {"cells", cells}, {"models", models}});
  } else {
    for (const std::string_view name : names) write_stdout(std::string(name) + "\n");
  }
  return ExitCode::ok;
}

void add_list(const Command& parent) {
  const Command command = parent.add_command("list", help_page("scene_list"));
  const auto json = std::make_shared<bool>(false);
  command.flag("--json", *json, "One JSON document instead of lines");
  command.run([json] { return list(*json); });
}

// --- convert

struct ConvertArguments {
  std::string scene;
  MeshArguments mesh;
  std::string output = "-";
};

ExitCode convert(const ConvertArguments& arguments) {
  const scene::LoadedScene loaded = load_scene(arguments.scene, arguments.mesh, Wires::keep);
  write_scene(loaded.scene, loaded.name, arguments.output);
  return ExitCode::ok;
}

void add_convert(const Command& parent) {
  const Command command = parent.add_command("convert", help_page("scene_convert"));
  const auto arguments = std::make_shared<ConvertArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  add_mesh_options(command, arguments->mesh);
  command
      .option("-o,--output", arguments->output,
              fmt::format("A file that ends in {}; - is JSON on standard output", scene::poly_endings))
      .default_value()
      .value("FILE");
  command.run([arguments] { return convert(*arguments); });
}

// --- generate

struct GenerateArguments {
  std::string family;
  std::size_t size = 1;
  std::uint64_t seed = 1;
  std::string output = "-";
};

// The meaning of SIZE for each family. host/scene/generate/scene.hpp describes the families.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> family_sizes{{
    {"boxes", "SIZE boxes that do not touch"},
    {"edgeon", "SIZE boxes that do not touch, seen from the plane of a face"},
    {"touch", "SIZE x SIZE x SIZE cubes that share faces"},
    {"aligned", "SIZE x SIZE x SIZE separate cubes in rows"},
    {"town", "SIZE buildings on the ground"},
    {"triangles", "SIZE triangles"},
    {"bricks", "SIZE small boxes that may touch; fewer if there is no room"},
    {"rooms", "SIZE x SIZE rooms with doors and hatches"},
    {"big_rooms", "SIZE x SIZE rooms with doors and hatches, all lengths divided by 5"},
    {"corridors", "SIZE rooms one behind the other"},
    {"prisms", "SIZE rotated houses of equal height"},
}};

std::string families_help() {
  std::string text;
  for (const std::string_view name : scene::generator_names()) {
    const auto* const row = std::find_if(family_sizes.begin(), family_sizes.end(),
                                         [name](const auto& family) { return family.first == name; });
    text +=
        fmt::format("{}  {:<9}  {}, at most {}", text.empty() ? "" : "\n", name,
                    row == family_sizes.end() ? "SIZE" : row->second, scene::largest_generated_size(name));
  }
  return text;
}

ExitCode generate(const GenerateArguments& arguments) {
  const auto scene = scene::generate_scene(arguments.family, arguments.size, arguments.seed);
  if (!scene) throw base::usage_error(scene.error().message());
  write_scene(*scene, arguments.family, arguments.output);
  return ExitCode::ok;
}

void add_generate(const Command& parent) {
  const Command command =
      parent.add_command("generate", help_page("scene_generate", {{"families", families_help()}}));
  const auto arguments = std::make_shared<GenerateArguments>();
  command.option("FAMILY", arguments->family, "Family of scenes; see below").required();
  command.option("SIZE", arguments->size, "Size of the scene; see below")
      .required()
      .check(whole_number_error);
  command.option("--seed", arguments->seed, "Seed of the random numbers: another seed gives another scene")
      .check(whole_number_error)
      .default_value()
      .value("N");
  command
      .option("-o,--output", arguments->output,
              fmt::format("A file that ends in {}; - is JSON on standard output", scene::poly_endings))
      .default_value()
      .value("FILE");
  command.run([arguments] { return generate(*arguments); });
}

// --- decompose

struct DecomposeArguments {
  std::string scene;
  MeshArguments mesh;
  std::string method;  // empty: auto
  std::string output;
  bool json = false;
};

scene::DecompositionMethod method_named(std::string_view name) {
  if (name == "bsp") return scene::DecompositionMethod::bsp;
  return name == "grid" ? scene::DecompositionMethod::grid : scene::DecompositionMethod::automatic;
}

// `method`: how space was decomposed; "own": the cells came with the scene.
void write_counts(const DecomposeArguments& arguments, const scene::CellComplex& complex, std::string_view method) {
  const std::size_t outside = openings_outside(complex);
  if (arguments.json) {
    return print_json({{"schema", "sightline/scene-compartment/1"},
                       {"scene", arguments.scene},
                       {"method", method},
                       {"cells", complex.cells.size()},
                       {"openings", complex.openings.size()},
                       {"openings_outside", outside},
                       {"lines", complex.lines.size()},
                       {"edges", complex.edges.size()},
                       {"planes", complex.planes.size()}});
  }
  TextTable counts({-10, 0});
  counts.row({"method", method});
  counts.row({"cells", fmt::format("{}", complex.cells.size())});
  counts.row({"openings", fmt::format("{}, {} of them to outside", complex.openings.size(), outside)});
  counts.row({"lines", fmt::format("{}, parts of {}", complex.lines.size(), count_text(complex.edges.size(), "edge"))});
  counts.row({"planes", fmt::format("{}", complex.planes.size())});
  write_stdout(counts.text());
}

// The format of a drawing of the cells; nullopt: the file is JSON.
std::optional<hidden_lines::Format> drawing_format(const std::string& path) {
  using hidden_lines::Format;
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos) return std::nullopt;
  const auto format = hidden_lines::format_named(path.substr(dot + 1));
  const bool drawing = format == Format::svg || format == Format::pdf || format == Format::png || format == Format::dxf;
  return drawing ? format : std::nullopt;
}

void write_diagrams(const scene::CellComplex& complex, const scene::LoadedScene& source, hidden_lines::Format format, Output& output) {
  const picture::VectorDrawing drawing = value_of(explain::cell_diagrams(complex, source.scene.camera), source.name);
  hidden_lines::WriteOptions options;
  options.format = format;
  options.title = source.name + ", its cells";
  options.paper = {drawing.width + 2 * options.paper.margin, drawing.height + 2 * options.paper.margin};
  constexpr double pixels_per_millimetre = 4;
  constexpr double most_pixels = 8192;
  options.image.width = static_cast<int>(std::min(most_pixels, std::ceil(options.paper.width * pixels_per_millimetre)));
  options.image.height = static_cast<int>(std::min(most_pixels, std::ceil(options.paper.height * pixels_per_millimetre)));
  options.image.unit = std::min(options.image.width / options.paper.width, options.image.height / options.paper.height);
  options.sheet = true;
  const hidden_lines::Written written = value_of(hidden_lines::write(drawing, options));
  output.write(std::string_view(written.bytes));
  output.commit();
}

// Drawings show the cells that come with a scene; for JSON, and for all other scenes, its space is decomposed.
// host/scene/read/cell_complex_file.hpp describes the format of the JSON file.
ExitCode decompose(const DecomposeArguments& arguments) {
  const auto format = drawing_format(arguments.output);
  std::unique_ptr<Output> output;
  if (!arguments.output.empty()) output = std::make_unique<Output>(arguments.output);
  const scene::LoadedScene source = load_scene(arguments.scene, arguments.mesh);
  if (auto own = format && arguments.method.empty() ? explain::cells_of_search(source) : std::nullopt) {
    write_diagrams(*own, source, *format, *output);
    write_counts(arguments, *own, "own");
    return ExitCode::ok;
  }
  const scene::Decomposition result =
      value_of(scene::decomposition_of(source.scene, method_named(arguments.method)), arguments.scene);
  const auto errors = scene::check_complex(result.complex, source.scene);
  for (const base::Error& error : errors) print_message(error.message());
  if (!errors.empty()) return ExitCode::differs;
  if (format) {
    write_diagrams(result.complex, source, *format, *output);
  } else if (output) {
    scene::write_cell_complex(source.scene, result, [&](std::string_view text) { output->write(text); });
    output->commit();
  }
  if (!output || !output->is_stdout()) write_counts(arguments, result.complex, method_name(result.method));
  return ExitCode::ok;
}

void add_decompose(const Command& parent) {
  const Command command = parent.add_command("decompose", help_page("scene_decompose"));
  command.add_alias("compartment");
  const auto arguments = std::make_shared<DecomposeArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  add_mesh_options(command, arguments->mesh);
  command.option("--method", arguments->method, "How space is decomposed")
      .one_of({"auto", "grid", "bsp"})
      .default_value("auto; a drawing shows the cells that come with the scene")
      .value("METHOD");
  command
      .option("-o,--output", arguments->output,
              "A drawing of the cells (.svg, .pdf, .png, .dxf), or the cells as JSON (any other name; - is standard output, without the counts)")
      .value("FILE");
  command.flag("--json", arguments->json, "The counts as one JSON document");
  command.run([arguments] { return decompose(*arguments); });
}

}  // namespace

void add_scene_command(const Command& program) {
  const Command command = program.add_command("scene", help_page("scene"));
  add_tape(command);
  add_show(command, "check", &check, false);
  add_show(command, "info", &info, true);
  add_list(command);
  add_convert(command);
  add_generate(command);
  add_decompose(command);
}

}  // namespace sightline::app
