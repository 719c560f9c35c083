// The algorithms that draw a function of two variables as vectors, one row each.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/algorithms/skala/figure.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::registry {

struct HeightAlgorithm {
  std::string_view name;
  std::string_view description;  // and its source
  // Why the algorithm cannot draw it; empty if it can.
  std::optional<std::string> (*why_not)(const scene::HeightGrid& grid, const algorithms::skala::View& view);
  // Facets far to near.
  picture::VectorDrawing (*draw)(const scene::HeightGrid& grid, const algorithms::skala::View& view);
  // The drawing as a figure for a page.
  algorithms::skala::Figure (*figure)(std::span<const scene::HeightGrid> grids, const algorithms::skala::View& view, const algorithms::skala::FigureOptions& options);
};

[[nodiscard]] std::span<const HeightAlgorithm> height_algorithms();
// Null if there is none of that name.
[[nodiscard]] const HeightAlgorithm* find_height_algorithm(std::string_view name);

}  // namespace sightline::registry
