// See scene_info.hpp.
#include "host/app/commands/scene_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/guests/jones/encode.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/model/face_numbers.hpp"
#include "host/scene/model/poly_bounds.hpp"

namespace sightline::app {

namespace {

using base::Json;

constexpr const char* info_schema = "sightline/scene-info/1";

std::string point_text(const geometry::Point& p) {
  return fmt::format("{},{},{}", p[0], p[1], p[2]);
}

std::string box_text(const geometry::Point& low, const geometry::Point& high) {
  return fmt::format("x {}..{}  y {}..{}  z {}..{}", low[0], high[0], low[1], high[1], low[2], high[2]);
}

Json box_json(const geometry::Box& box) {
  return Json::array({box.low, box.high});
}

// --- cells of Jones's program

guests::jones::EncodedScene encoded(const scene::CellScene& scene, const std::string& source) {
  auto result = guests::jones::encode(scene);
  if (!result) {
    result.error().file = source;
    throw Failure(ExitCode::bad_input, result.error().message());
  }
  return std::move(*result);
}

void describe_cells(const SceneText& file, bool json) {
  const scene::CellScene scene = load_scene(file.text, file.name);
  const guests::jones::EncodedScene core = encoded(scene, file.name);
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
  write_stdout(fmt::format("name           {}\n", scene.name));
  write_stdout(fmt::format("cells          {}, with {} lines\n", scene.cells.size(), lines));
  write_stdout(fmt::format("openings       {}\n", scene.openings.size()));
  write_stdout(fmt::format("matter         {} solids, {} walls\n", scene.solids.size(), scene.walls.size()));
  write_stdout(fmt::format("outer box      {}\n", box_text(scene.outer.low, scene.outer.high)));
  write_stdout(
      fmt::format("default view   {}, in cell {}\n", point_text(scene.default_view), core.view.cell));
  write_stdout(fmt::format("eye may move   {}\n", box_text(core.view.limits.low, core.view.limits.high)));
  write_stdout(fmt::format("words of core  {} of {} (cells {}, openings {}, header {})\n", core.words.size(),
                           guests::jones::core_words, core.cell_words, core.opening_words,
                           guests::jones::scene_header_words));
}

// --- polyhedra

struct PolyCounts {
  explicit PolyCounts(const scene::PolyScene& scene) {
    for (const scene::PolyBody& body : scene.bodies) {
      sheets += body.sheet ? 1U : 0U;
      for (const scene::PolyFace& face : body.faces) holes += face.holes.size();
      const auto sides = scene::face_edges(body);
      for (std::size_t i = 0; i < sides.size(); ++i)
        edges += i == 0 || !sides[i].same_edge(sides[i - 1]) ? 1U : 0U;
    }
  }

  std::size_t edges = 0;
  std::size_t holes = 0;
  std::size_t sheets = 0;
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
          {"bounds", Json::array({bounds.low, bounds.high})},
          {"step", scene.step},
          {"origin", scene.origin}};
}

void write_polyhedra(const scene::PolyScene& scene) {
  const PolyCounts counts(scene);
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  if (!scene.name.empty()) write_stdout(fmt::format("name           {}\n", scene.name));
  write_stdout(fmt::format("vertices       {}\nedges          {}\n", scene.vertices.size(), counts.edges));
  write_stdout(fmt::format("faces          {}, with {} holes\n", scene::face_count(scene), counts.holes));
  write_stdout(fmt::format("bodies         {} solids, {} sheets\n", scene.bodies.size() - counts.sheets,
                           counts.sheets));
  write_stdout(fmt::format("bounds         {}\n", box_text(bounds.low, bounds.high)));
  write_stdout(fmt::format("step           {}\n", scene.step));
  write_stdout(fmt::format("camera         {} at {}\n",
                           scene.camera.perspective ? "perspective" : "orthographic",
                           point_text(scene.camera.eye)));
}

void describe_polyhedra(const SceneText& file, bool json) {
  const auto [scene, report] = load_poly_file(file, false);
  if (json) {
    Json document = polyhedra_json(scene);
    document["quantised"] = report.quantised;
    document["largest_shift"] = report.largest_shift;
    document["split_faces"] = report.split_faces;
    document["largest_deviation"] = report.largest_deviation;
    print_json(document);
    return;
  }
  tell(report);
  write_polyhedra(scene);
}

// --- cells cut by program

void describe_cell_complex(const SceneText& file, bool json) {
  const auto [scene, compartments] = load_cell_complex(file);
  const scene::CellComplex& complex = compartments.complex;
  if (json) {
    Json document = polyhedra_json(scene);
    document["method"] = method_name(compartments.method);
    document["cells"] = complex.cells.size();
    document["openings"] = complex.openings.size();
    document["openings_outside"] = openings_outside(complex);
    document["cell_lines"] = complex.lines.size();
    document["planes"] = complex.planes.size();
    document["outer"] = box_json(complex.outer);
    print_json(document);
    return;
  }
  write_polyhedra(scene);
  write_stdout(fmt::format("cells          {}, with {} lines; by {}\n", complex.cells.size(),
                           complex.lines.size(), method_name(compartments.method)));
  write_stdout(fmt::format("openings       {}, {} of them to outside\n", complex.openings.size(),
                           openings_outside(complex)));
  write_stdout(fmt::format("planes         {}\n", complex.planes.size()));
  write_stdout(fmt::format("outer box      {}\n", box_text(complex.outer.low, complex.outer.high)));
}

}  // namespace

void describe_scene_text(const SceneText& file, bool json) {
  switch (file.kind) {
    case SceneKind::cells: return describe_cells(file, json);
    case SceneKind::polyhedra: return describe_polyhedra(file, json);
    case SceneKind::cell_complex: return describe_cell_complex(file, json);
  }
}

std::size_t openings_outside(const scene::CellComplex& complex) {
  return static_cast<std::size_t>(
      std::count_if(complex.openings.begin(), complex.openings.end(), [](const auto& opening) {
        return opening.cells[0] == scene::outside || opening.cells[1] == scene::outside;
      }));
}

std::string_view method_name(scene::CompartmentMethod method) {
  return method == scene::CompartmentMethod::bsp ? "bsp" : "grid";
}

}  // namespace sightline::app
