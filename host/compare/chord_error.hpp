// The error of drawing a function by straight lines between its samples: the distance of the function's curve along a
// slice from the chord between two consecutive samples, where the chord is visible. It is a property of the samples,
// so it is not an error of any method.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "host/compare/height_truth.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

// Samples the same function over the same domain at another size. Empty if there is nothing between samples: a grid
// from a file, a function of the grid's indices.
using HeightSampler = std::function<scene::HeightGrid(scene::GridSize)>;

struct ChordError {
  double greatest = 0;      // points of the screen
  std::size_t between = 0;  // places tried between two samples; the smaller number of the directions x and z
};

// Empty without a sampler, or if the grid is too large to be sampled four times as densely (largest_grid). `lines`
// are those of the grid and the view. Undefined heights between samples are skipped.
[[nodiscard]] std::optional<ChordError> chord_error(const HeightLines& lines, const scene::HeightGrid& grid,
                                                    const algorithms::skala::View& view, const HeightSampler& sampler);

}  // namespace sightline::compare
