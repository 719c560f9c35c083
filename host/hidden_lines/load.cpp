// Loads scenes from memory, and describes what was changed; see hidden_lines.hpp.
#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "host/hidden_lines/hidden_lines.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/read/changes.hpp"
#include "host/scene/read/poly_import.hpp"

namespace sightline::hidden_lines {
namespace {

// Checks a mesh from memory for faults that the file readers exclude.
std::optional<base::Error> fault_of(const scene::PolyMesh& mesh) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    for (const double coordinate : mesh.vertices[v])
      if (!std::isfinite(coordinate))
        return base::Error{mesh.source, fmt::format("vertex {}", v), fmt::format("found {}", coordinate), "a finite number"};
  std::size_t faces = 0;
  for (const scene::PolyBody& body : mesh.bodies) faces += body.faces.size();
  if (!mesh.materials.empty() && mesh.materials.size() != faces)
    return base::Error{mesh.source, "materials", fmt::format("found {}", mesh.materials.size()), fmt::format("none, or {}, one for each face", faces)};
  const auto outside = [&](std::span<const scene::VertexIndex> ring) {
    for (const scene::VertexIndex v : ring)
      if (v >= mesh.vertices.size()) return true;
    return false;
  };
  const std::string expected = fmt::format("indices below {}", mesh.vertices.size());
  for (std::size_t b = 0; b < mesh.bodies.size(); ++b) {
    for (std::size_t f = 0; f < mesh.bodies[b].faces.size(); ++f) {
      const scene::PolyFace& face = mesh.bodies[b].faces[f];
      bool wrong = outside(face.outline);
      for (const auto& hole : face.holes) wrong = wrong || outside(hole);
      if (wrong) return base::Error{mesh.source, fmt::format("body {}, face {}", b, f), "an index without a vertex", expected};
    }
  }
  for (std::size_t w = 0; w < mesh.wires.size(); ++w)
    if (outside(mesh.wires[w])) return base::Error{mesh.source, fmt::format("line {}", w), "an index without a vertex", expected};
  return std::nullopt;
}

}  // namespace

base::Result<Scene> load(scene::PolyMesh mesh, const LoadOptions& options) {
  if (auto fault = fault_of(mesh)) return std::move(*fault);
  Scene loaded{.name = mesh.source};
  auto import = scene::import_poly(std::move(mesh), options);
  if (!import) return std::move(import.error());
  loaded.scene = std::move(import->scene);
  loaded.report = std::move(import->report);
  if (!import->faults.empty()) return scene::first_of(import->faults);
  return loaded;
}

std::vector<std::string> notes_of(const scene::PolyImportReport& report) {
  std::vector<std::string> notes;
  const std::string unit = report.unit.empty() ? "" : " " + report.unit;
  if (report.quantised && report.largest_shift > 0)
    notes.push_back(fmt::format("coordinates rounded to a step of {}{}, by at most {:.3g}{}", report.step, unit, report.largest_shift, unit));
  if (std::string changes = scene::changes_text(report); !changes.empty()) notes.push_back(std::move(changes));
  return notes;
}

}  // namespace sightline::hidden_lines
