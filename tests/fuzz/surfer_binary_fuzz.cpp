// Any bytes as a binary Surfer grid: see grid_fuzz.hpp.
#include "tests/fuzz/grid_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sightline::fuzz::fuzz_grid(data, size, sightline::scene::is_surfer_binary, sightline::scene::read_surfer_binary);
  return 0;
}
