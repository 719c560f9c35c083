// Any bytes as a 3MF archive: see poly_fuzz.hpp.
#include "tests/fuzz/poly_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sightline::fuzz::fuzz_poly(data, size, sightline::scene::PolyFormat::threemf);
  return 0;
}
