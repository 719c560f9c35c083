// Any bytes as glTF, or as GLB if they begin like that: see poly_fuzz.hpp.
#include "tests/fuzz/poly_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bool glb = std::string_view(reinterpret_cast<const char*>(data), size).starts_with("glTF");
  sightline::fuzz::fuzz_poly(data, size, glb ? sightline::scene::PolyFormat::glb : sightline::scene::PolyFormat::gltf);
  return 0;
}
