// The error of drawing a function by straight lines between its samples: how far the curve of the function along a slice
// is from the chord between two neighbouring samples, where that chord is seen. No method that is given the samples can
// do better, so it is no error of any of them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "host/compare/height_truth.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

// The same function over the same domain at another size. Empty where there is nothing between the samples: a grid from a
// file, a function of the grid's indices.
using HeightSampler = std::function<scene::HeightGrid(scene::GridSize)>;

struct ChordError {
  double greatest = 0;      // points of the screen
  std::size_t between = 0;  // places tried between two samples; of the directions x and z, the fewer
};

// Nothing without a sampler, or of a grid too large to be sampled four times as densely (largest_grid). `lines` are those
// of the grid and the view. Undefined heights in between are passed over.
[[nodiscard]] std::optional<ChordError> chord_error(const HeightLines& lines, const scene::HeightGrid& grid,
                                                    const algorithms::skala::View& view, const HeightSampler& sampler);

}  // namespace sightline::compare
