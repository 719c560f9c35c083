// Any bytes as an SRTM tile: see grid_fuzz.hpp. A tile has one of two sizes: the first seven bytes are its name, the others its heights,
// again and again. Fewer than nine bytes are a file of a wrong size.
#include "tests/fuzz/grid_fuzz.hpp"

#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  constexpr std::size_t tile_size = 2 * 1201 * 1201;
  constexpr std::size_t name_size = 7;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string name = bytes.substr(0, name_size) + ".hgt";
  std::string tile = bytes;
  if (size >= name_size + 2) {
    tile.clear();
    while (tile.size() < tile_size) tile += bytes.substr(name_size);
    tile.resize(tile_size);
  }
  static_cast<void>(scene::is_hgt_grid(tile, "fuzz"));
  fuzz::use(scene::read_hgt_grid(tile, name));
  return 0;
}
