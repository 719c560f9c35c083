#include "host/algorithms/registry/heights.hpp"

#include <algorithm>
#include <array>

#include "host/algorithms/skala/draw.hpp"

namespace sightline::registry {

namespace {

namespace skala = algorithms::skala;

std::optional<std::string> why_no_skala(const scene::HeightGrid&, const skala::View& view) {
  if (view.zoom != 1) return "it has no zoom, because its drawings can have any size";
  return std::nullopt;
}

picture::VectorDrawing draw_skala(const scene::HeightGrid& grid, const skala::View& view) { return skala::draw(grid, view); }

skala::Figure skala_figure(std::span<const scene::HeightGrid> grids, const skala::View& view, const skala::FigureOptions& options) {
  return skala::figure(grids, view, options);
}

constexpr std::array height_rows{
    HeightAlgorithm{"skala", "Skala's masks as a modern algorithm: vectors on masks finer than a dot", why_no_skala, draw_skala, skala_figure},
};

}  // namespace

std::span<const HeightAlgorithm> height_algorithms() { return height_rows; }

const HeightAlgorithm* find_height_algorithm(std::string_view name) {
  const auto found = std::find_if(height_rows.begin(), height_rows.end(), [name](const HeightAlgorithm& row) { return row.name == name; });
  return found != height_rows.end() ? &*found : nullptr;
}

}  // namespace sightline::registry
