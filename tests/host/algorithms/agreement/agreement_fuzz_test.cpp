// Random scenes from random cameras by the oracle, `exact`, native Jones by grid and by BSP, and every other algorithm of the
// table of lines: they must agree as that table says. A difference is shrunk and saved as a scene file, whose camera is the one
// that shows it.
//
// Algorithms may reject scenes and views beforehand, and faces that pass through each other, which are common in random scenes,
// when they find them. The test counts how often each algorithm draws, so that rejecting is not a way to pass. Fast by default;
// SIGHTLINE_FUZZ_SCENES=n tries n scenes, SIGHTLINE_FUZZ_SEED=s starts at seed s.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/registry/lines.hpp"
#include "host/base/file.hpp"
#include "host/scene/read/poly_file.hpp"
#include "tests/host/algorithms/agreement/agreement.hpp"
#include "tests/host/algorithms/agreement/random_scene.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/shrink_scene.hpp"

namespace sightline::algorithms {
namespace {

std::uint32_t number_from(const char* variable, std::uint32_t otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : otherwise;
}

// The command that shows the difference again.
std::string save_scene(const scene::PolyScene& scene, std::uint32_t seed) {
  const std::string file = "disagreement-" + std::to_string(seed) + ".json";
  const auto text = scene::write_poly(scene, scene::PolyFormat::json);
  if (!base::write_file_atomically(file, *text)) return "not saved: " + file;
  return "sightline compare " + file;
}

struct Share {
  std::uint32_t drawn = 0;
  std::uint32_t views = 0;
};
using Shares = std::map<std::string_view, Share>;

// An algorithm that Everyone does not draw, and the reason.
struct Exclusion {
  std::string_view algorithm;
  std::string_view reason;
};
constexpr std::array exclusions{
    Exclusion{"exact", "the others are compared with it"},
    Exclusion{"oracle", "Agreement compares it with exact"},
    Exclusion{"jones", "Agreement compares it with exact, on cells of a grid and of a BSP"},
};

bool is_excluded(const registry::LineAlgorithm& algorithm) {
  return std::any_of(exclusions.begin(), exclusions.end(),
                     [&](const Exclusion& row) { return row.algorithm == algorithm.name; });
}

class Everyone {
 public:
  explicit Everyone(const scene::PolyScene& scene) : scene_(scene), agreement_(scene) {
    for (const registry::LineAlgorithm& algorithm : registry::line_algorithms()) {
      if (is_excluded(algorithm)) continue;
      if (algorithm.why_not(scene)) continue;
      auto made = algorithm.prepare(scene);
      if (made) others_.emplace_back(&algorithm, std::move(made->view));
    }
  }

  // Empty if all algorithms that draw the view agree.
  std::string differences(const scene::PolyCamera& camera, Shares& shares) {
    std::string text = agreement_.differences(camera);
    const picture::LinePicture exact = exact::visible_edges(scene_, camera);
    for (const auto& [algorithm, view] : others_) {
      if (algorithm->why_not_seen(scene_, camera)) continue;
      Share& share = shares[algorithm->name];
      ++share.views;
      const auto seen = view(camera);
      if (!seen) {
        if (seen.error().found.find("pass through each other") == std::string::npos)
          text += seen.error().message() + "\n";
        continue;
      }
      ++share.drawn;
      if (!registry::agrees(*algorithm, seen->picture, exact, scene_, camera))
        text += std::string(algorithm->name) + ": not the picture of exact\n";
    }
    return text;
  }

 private:
  const scene::PolyScene& scene_;
  Agreement agreement_;
  std::vector<std::pair<const registry::LineAlgorithm*, decltype(registry::PreparedScene::view)>> others_;
};

TEST(AgreementFuzz, AllAlgorithmsAgreeOnRandomScenes) {
  constexpr int views = 8;
  const std::uint32_t first = number_from("SIGHTLINE_FUZZ_SEED", 1);
  const std::uint32_t scenes = number_from("SIGHTLINE_FUZZ_SCENES", tests::effort(60U, 15U));
  std::uint32_t looked = 0;
  Shares shares;
  for (std::uint32_t seed = first; seed - first < scenes; ++seed) {
    RandomScene random(seed);
    Everyone everyone(random.scene());
    for (int view = 0; view < views && random.look(); ++view, ++looked) {
      if (everyone.differences(random.scene().camera, shares).empty()) continue;
      const scene::PolyScene small = tests::shrink_scene(random.scene(), [](const scene::PolyScene& scene) {
        Shares of_shrinking;
        return !Everyone(scene).differences(scene.camera, of_shrinking).empty();
      });
      ADD_FAILURE() << "seed " << seed << ", view " << view << "; again: " << save_scene(small, seed) << "\n"
                    << Everyone(small).differences(small.camera, shares);
      break;
    }
  }
  EXPECT_GT(looked, 6 * scenes);
  const auto all = registry::line_algorithms();
  EXPECT_EQ(shares.size(), all.size() - static_cast<std::size_t>(std::count_if(all.begin(), all.end(), is_excluded)));
  for (const auto& [name, share] : shares) {
    EXPECT_GT(2 * share.drawn, share.views) << name;
    EXPECT_GT(20 * share.views, looked) << name;
  }
}

}  // namespace
}  // namespace sightline::algorithms
