// Shared by the fuzz targets for grid formats: a grid with as many heights as places, all of them finite or holes, or an error with a
// message.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "host/scene/heights/grid_formats.hpp"

namespace sightline::fuzz {

inline void use(const base::Result<scene::HeightGrid>& grid) {
  if (!grid) {
    if (grid.error().message().empty()) std::abort();
    return;
  }
  if (grid->heights.size() != grid->points() * grid->slices() || grid->points() < 2 || grid->slices() < 2) std::abort();
  for (const double height : grid->heights)
    if (std::isinf(height)) std::abort();
  for (const scene::Interval& domain : {grid->domain_x, grid->domain_z})
    if (!std::isfinite(domain.low) || !std::isfinite(domain.high) || !(domain.low < domain.high)) std::abort();
  const scene::HeightGrid fewer = scene::thinned(*grid, 3);
  if (fewer.heights.size() != fewer.points() * fewer.slices()) std::abort();
}

inline void fuzz_grid(const std::uint8_t* data, std::size_t size, decltype(scene::GridFormat::recognises) recognises,
                      decltype(scene::GridFormat::read) read) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  static_cast<void>(recognises(bytes, "fuzz"));
  use(read(bytes, "fuzz"));
}

}  // namespace sightline::fuzz
