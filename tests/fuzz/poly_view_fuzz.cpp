// Any bytes as a scene with its camera: all algorithms with exact visible edges agree on every valid scene that is small
// enough for the oracle.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/poly_json.hpp"
#include "tests/host/algorithms/agreement/agreement.hpp"

namespace {

constexpr std::size_t most_corners = 150;

std::size_t corners_of(const sightline::scene::PolyScene& scene) {
  std::size_t corners = 0;
  for (const auto& body : scene.bodies) {
    for (const auto& face : body.faces) {
      corners += face.outline.size();
      for (const auto& hole : face.holes) corners += hole.size();
    }
  }
  return corners;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sightline;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto result = scene::read_poly_json(text, "fuzz");
  if (!result || corners_of(*result) > most_corners || !scene::check_poly_scene(*result).empty() ||
      scene::eye_error(*result, result->camera))
    return 0;
  const std::string differences = algorithms::Agreement(*result).differences(result->camera);
  if (differences.empty()) return 0;
  std::fputs(differences.c_str(), stderr);
  std::abort();
}
