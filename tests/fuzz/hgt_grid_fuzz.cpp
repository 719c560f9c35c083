// Any bytes as an SRTM tile: see grid_fuzz.hpp. A tile has one of two sizes, and takes long to read: 128 bytes become one if their sum is a
// multiple of eight. The first seven are its name, the others its heights, again and again.
#include "tests/fuzz/grid_fuzz.hpp"

#include <numeric>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  if (size != 128 || std::accumulate(data, data + size, 0U) % 8 != 0) {
    fuzz::fuzz_grid(data, size, scene::is_hgt_grid, scene::read_hgt_grid);
    return 0;
  }
  constexpr std::size_t tile_size = 2 * 1201 * 1201;
  constexpr std::size_t name_size = 7;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  std::string tile;
  while (tile.size() < tile_size) tile += bytes.substr(name_size);
  tile.resize(tile_size);
  static_cast<void>(scene::is_hgt_grid(tile, "fuzz"));
  fuzz::use(scene::read_hgt_grid(tile, bytes.substr(0, name_size) + ".hgt"));
  return 0;
}
