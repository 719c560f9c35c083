// Any bytes as each of the grid formats: a grid with as many heights as places, all of them finite or holes, or an error with a message.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "host/scene/heights/grid_formats.hpp"

namespace {

using namespace sightline;

void use(const base::Result<scene::HeightGrid>& grid) {
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const scene::GridFormat& format : scene::grid_formats()) {
    static_cast<void>(format.recognises(bytes, "fuzz"));
    use(format.read(bytes, "fuzz"));
  }
  // A tile has one size: its bytes are these, again and again.
  if (size != 128) return 0;
  std::string tile;
  constexpr std::size_t tile_size = 2 * 1201 * 1201;
  while (tile.size() < tile_size) tile += bytes;
  tile.resize(tile_size);
  use(scene::read_hgt_grid(tile, "n" + std::string(bytes.substr(0, 6)) + ".hgt"));
  return 0;
}
