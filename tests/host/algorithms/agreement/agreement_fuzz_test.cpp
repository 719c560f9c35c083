// Random scenes from random cameras by the oracle, `exact` and native Jones, grid and BSP: equal by ==. A
// difference is shrunk and saved as a scene file, its own camera the one it shows from.
//
// Fast by default; SIGHTLINE_FUZZ_SCENES=n tries n scenes, SIGHTLINE_FUZZ_SEED=s those from seed s on.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "host/harness/shrink_scene.hpp"
#include "host/picture/file_io.hpp"
#include "host/scene/poly_file.hpp"
#include "tests/host/algorithms/agreement/agreement.hpp"
#include "tests/host/algorithms/agreement/random_scene.hpp"

namespace sightline::algorithms {
namespace {

std::uint32_t number_from(const char* variable, std::uint32_t otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : otherwise;
}

// What to run to see the difference again.
std::string saved(const scene::PolyScene& scene, std::uint32_t seed) {
  const std::string file = "disagreement-" + std::to_string(seed) + ".json";
  const auto text = scene::write_poly(scene, scene::PolyFormat::json);
  if (!picture::write_file_atomically(file, std::get<std::string>(text))) return "not saved: " + file;
  return "sightline compare " + file;
}

TEST(AgreementFuzz, RandomScenesAreSeenAlikeByAll) {
  constexpr int views = 8;
  const std::uint32_t first = number_from("SIGHTLINE_FUZZ_SEED", 1);
  const std::uint32_t scenes = number_from("SIGHTLINE_FUZZ_SCENES", 60);
  std::uint32_t looked = 0;
  for (std::uint32_t seed = first; seed - first < scenes; ++seed) {
    RandomScene random(seed);
    Agreement agreement(random.scene());
    for (int view = 0; view < views && random.look(); ++view, ++looked) {
      if (agreement.differences(random.scene().camera).empty()) continue;
      const scene::PolyScene small = harness::shrunk(random.scene(), [](const scene::PolyScene& scene) {
        return !Agreement(scene).differences(scene.camera).empty();
      });
      ADD_FAILURE() << "seed " << seed << ", view " << view << "; again: " << saved(small, seed) << "\n"
                    << Agreement(small).differences(small.camera);
      break;
    }
  }
  EXPECT_GT(looked, 6 * scenes);
}

}  // namespace
}  // namespace sightline::algorithms
