#include "host/explain/explain.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/explain/exact.hpp"
#include "host/explain/jones.hpp"
#include "host/explain/montani_re.hpp"
#include "host/explain/plantinga.hpp"
#include "host/explain/skala.hpp"
#include "host/explain/willis.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/model/eye_place.hpp"

namespace sightline::explain {
namespace {

constexpr std::array<Explainer, 6> rows{{
    {"exact", "Every edge against the faces that may hide it: the reference, with no paper", explain_exact, nullptr},
    {"jones", "Jones 1971: from cell to cell through portals, with the mask that is left", explain_jones, nullptr},
    {"skala", "Skala 1985: slices from the foreground to the background against two masks", nullptr, explain_skala},
    {"montani-re", "Montani and Re 1985: faces as stripes, in a list by priority", explain_montani_re, nullptr},
    {"willis", "Willis 1977: surfaces cut until their distance from the eye is their order", explain_willis, nullptr},
    {"plantinga", "Plantinga, Seales and Dyer 1990: the events of a full turn", explain_plantinga, nullptr},
}};

// The real lines for this eye as wires, without faces: in Jones's search walls hide because no portal leads through them. Empty
// if the oracle does not accept the scene.
std::optional<scene::PolyScene> real_lines(const scene::CellScene& cells, const scene::PolyCamera& camera) {
  namespace oracle = algorithms::oracle;
  const auto matter = oracle::Matter::of(cells);
  if (!matter) return std::nullopt;
  scene::PolyScene lines;
  lines.name = cells.name;
  lines.camera = camera;
  std::map<scene::PolyPoint, scene::VertexIndex> numbers;
  const auto vertex = [&](const scene::PolyPoint& p) {
    const auto [known, fresh] = numbers.try_emplace(p, static_cast<scene::VertexIndex>(lines.vertices.size()));
    if (fresh) lines.vertices.push_back(p);
    return known->second;
  };
  for (const oracle::RealLine& line : matter->real_lines())
    if (oracle::is_line_for(line, camera.eye)) lines.wires.push_back({vertex(line.from), vertex(line.to)});
  return lines;
}

}  // namespace

base::Result<Lesson> explain_scene(const Explainer& explainer, const scene::LoadedScene& source, const scene::PolyCamera& camera) {
  if (explainer.algorithm == "jones" && source.cells && camera.perspective && scene::locate(*source.cells, camera.eye)) {
    if (const auto lines = real_lines(*source.cells, camera)) {
      const scene::CellComplex cells = scene::complex_of(*source.cells, *lines);
      return explainer.scene(*lines, camera, &cells);
    }
  }
  const std::optional<scene::CellComplex> cells = scene::own_cells(source);
  return explainer.scene(source.scene, camera, cells ? &*cells : nullptr);
}

std::optional<scene::CellComplex> cells_of_search(const scene::LoadedScene& source) {
  if (!source.cells) return scene::own_cells(source);
  const auto lines = real_lines(*source.cells, source.scene.camera);
  scene::CellComplex cells = scene::complex_of(*source.cells, lines ? *lines : source.scene);
  // From inside, the outer box is opaque.
  for (scene::ComplexCell& cell : cells.cells) {
    const auto own = std::span(cells.opening_numbers).subspan(cell.first_opening, cell.opening_count);
    const auto inner = std::stable_partition(own.begin(), own.end(), [&](std::uint32_t n) {
      return cells.openings[n].cells[0] != scene::outside && cells.openings[n].cells[1] != scene::outside;
    });
    cell.opening_count = static_cast<std::uint32_t>(inner - own.begin());
  }
  std::erase_if(cells.openings, [](const scene::ComplexOpening& opening) {
    return opening.cells[0] == scene::outside || opening.cells[1] == scene::outside;
  });
  return cells;
}

std::span<const Explainer> explainers() { return rows; }

const Explainer* find_explainer(std::string_view algorithm) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Explainer& row) { return row.algorithm == algorithm; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace sightline::explain
