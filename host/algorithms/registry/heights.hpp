// The table of the algorithms that draw a function of two variables as vectors.
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
  std::string_view description;  // includes the source
  // Why the algorithm cannot draw the view; nullopt if it can.
  std::optional<std::string> (*why_not)(const scene::HeightGrid& grid, const algorithms::skala::View& view);
  // Facets are ordered from far to near.
  picture::VectorDrawing (*draw)(const scene::HeightGrid& grid, const algorithms::skala::View& view);
  // The drawing, laid out as a figure for a page.
  algorithms::skala::Figure (*figure)(std::span<const scene::HeightGrid> grids, const algorithms::skala::View& view, const algorithms::skala::FigureOptions& options);
};

[[nodiscard]] std::span<const HeightAlgorithm> height_algorithms();
// Null if no algorithm has this name.
[[nodiscard]] const HeightAlgorithm* find_height_algorithm(std::string_view name);

}  // namespace sightline::registry
