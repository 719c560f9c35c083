// All algorithms compared with each other on the common scenes, one test per pair and scene; and the comparison must detect the
// differences that it exists to detect.
#include "host/compare/cross_check.hpp"
#include "host/compare/stripes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "host/algorithms/registry/heights.hpp"
#include "host/base/result.hpp"
#include "host/compare/cross_check_compare.hpp"
#include "host/compare/turning.hpp"
#include "host/compare/willis_8080.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/eye_place.hpp"

namespace sightline::compare {
namespace {

std::size_t pair_count() {
  return participants().size() * (participants().size() - 1) / 2;
}

// The cross-check of a scene, by its number in common_scene_names, computed once.
const SceneCrossCheck& agreement_of(std::size_t scene) {
  static std::map<std::size_t, SceneCrossCheck> known;
  const auto found = known.find(scene);
  if (found != known.end()) return found->second;
  return known.emplace(scene, cross_check(common_scene(common_scene_names()[scene]))).first->second;
}

// A scene's number, and a pair's in SceneCrossCheck::cells.
class AgreementOn : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  static void expect_agreement(std::size_t scene_number, std::size_t pair) {
    const CrossCheckCell& cell = agreement_of(scene_number).cells[pair];
    const CommonScene scene = common_scene(common_scene_names()[scene_number]);
    std::size_t listed_views = 0;
    for (const CrossCheckView& view : scene.views) {
      listed_views += !listed_reason(cell.first, scene.name, view.camera.perspective) &&
                      !listed_reason(cell.second, scene.name, view.camera.perspective) && !why_incomparable(cell.first, cell.second);
    }
    EXPECT_EQ(cell.state, listed_views > 0 ? CrossCheckState::agrees : CrossCheckState::not_applicable)
        << cell.first << " and " << cell.second << ", " << scene.name << ", " << cell.text;
    EXPECT_EQ(cell.views, listed_views) << cell.text;
    EXPECT_FALSE(cell.text.empty());
  }
};

std::string agreement_name(const testing::TestParamInfo<std::tuple<std::size_t, std::size_t>>& info) {
  auto [scene, pair] = info.param;
  std::string name(common_scene_names()[scene]);
  std::size_t first = 0;
  for (std::size_t others = participants().size() - 1; pair >= others; pair -= others--) ++first;
  name += "_" + std::string(participants()[first].name) + "_" +
          std::string(participants()[first + 1 + pair].name);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

TEST_P(AgreementOn, APair) {
  expect_agreement(std::get<0>(GetParam()), std::get<1>(GetParam()));
}
INSTANTIATE_TEST_SUITE_P(Agreement, AgreementOn,
                         testing::Combine(testing::Range(std::size_t{0}, common_scene_names().size()),
                                          testing::Range(std::size_t{0}, pair_count())),
                         agreement_name);

TEST(CommonScenes, AreValidAndParallelViewsBeginInFrontOfThem) {
  for (const std::string_view name : common_scene_names()) {
    const CommonScene scene = common_scene(name);
    EXPECT_EQ(scene.name, name);
    EXPECT_TRUE(check_poly_scene(scene.scene).empty()) << name;
    for (const CrossCheckView& view : scene.views) {
      EXPECT_FALSE(eye_error(scene.scene, view.camera)) << name;
      for (const scene::PolyPoint& p : scene.scene.vertices) {
        if (view.camera.perspective) continue;
        const auto ahead =
            geometry::dot(geometry::vector_of(view.camera.forward), geometry::difference(p, view.camera.eye));
        EXPECT_GT(ahead, 0) << name;
      }
    }
  }
}

// The sight line of a pixel passes through its middle; the window must agree.
TEST(CommonScenes, SightLinesArePixels) {
  for (const std::string_view name : {"C1", "C5", "C9"}) {
    for (const CrossCheckView& view : common_scene(name).views) {
      for (const auto& [column, row] : {std::pair{0, 0}, {17, 200}, {255, 255}, {128, 3}}) {
        const auto [from, along] = view.sight(column, row);
        scene::PolyPoint p = from;
        for (std::size_t a = 0; a < 3; ++a) p[a] += static_cast<std::int32_t>(along[a]);
        const picture::PixelPoint place = view.place(p);
        EXPECT_NEAR(place.x, column, 1e-6);
        EXPECT_NEAR(place.y, row, 1e-6);
      }
    }
  }
}

// The names of all registries, and of the programs on the 8080 and the PDP-7 that draw scenes.
std::set<std::string_view> registered_names() {
  std::set<std::string_view> names;
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms()) names.insert(algorithm.name);
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms()) names.insert(algorithm.name);
  for (const registry::HeightAlgorithm& algorithm : registry::height_algorithms()) names.insert(algorithm.name);
  names.insert(stripes_name);
  names.insert(willis_on_8080().name);
  names.insert(turn_name);
  for (const std::string_view name : {jones_pdp7_name, jones_no_eae_name, jones_twin_name, skala_8080_name}) names.insert(name);
  return names;
}

bool excludes(const NotApplicable& exclusion, std::string_view who, const CommonScene& scene) {
  if (exclusion.who != who || !scene.name.starts_with(exclusion.scenes)) return false;
  return exclusion.views == NotApplicable::Views::all ||
         std::all_of(scene.views.begin(), scene.views.end(),
                     [](const CrossCheckView& view) { return view.camera.perspective; });
}

// All pairs of the registries' algorithms on all scenes, without pairs with an excluded algorithm.
TEST(CommonScenes, EveryPairRunsThatIsNotExcluded) {
  const std::set<std::string_view> names = registered_names();
  EXPECT_EQ(participants().size(), names.size());
  std::set<const NotApplicable*> used;
  for (const std::string_view scene_name : common_scene_names()) {
    const CommonScene scene = common_scene(scene_name);
    std::vector<std::string_view> taking_part;
    for (const std::string_view who : names) {
      bool excluded = false;
      for (const NotApplicable& exclusion : not_applicable()) {
        if (!excludes(exclusion, who, scene)) continue;
        excluded = true;
        used.insert(&exclusion);
      }
      if (!excluded) taking_part.push_back(who);
    }
    EXPECT_GE(taking_part.size(), 5U) << scene.name;
    std::size_t pairs = taking_part.size() * (taking_part.size() - 1) / 2;
    // Skala's program has two partners.
    if (std::find(taking_part.begin(), taking_part.end(), skala_8080_name) != taking_part.end()) pairs -= taking_part.size() - 1 - 2;
    EXPECT_EQ(listed_cells(scene), pairs) << scene.name;
  }
  for (const NotApplicable& exclusion : not_applicable()) {
    EXPECT_TRUE(used.contains(&exclusion)) << exclusion.who << ": excluded from nothing";
    EXPECT_FALSE(exclusion.reason.empty()) << exclusion.who;
  }
}

// For each measure between two algorithms: the largest fraction of its bound in any scene and view.
std::map<std::string, double> parts_of_bounds(std::string_view first, std::string_view second) {
  std::map<std::string, double> parts;
  for (std::size_t scene = 0; scene < common_scene_names().size(); ++scene)
    for (const CrossCheckCell& cell : agreement_of(scene).cells)
      if (cell.first == first && cell.second == second)
        for (const CheckedDistance& distance : cell.distances) parts[distance.what] = std::max(parts[distance.what], distance.found / distance.bound);
  return parts;
}

// No bound is so wide that it has no effect: half of it would be too small, for lit points a third.
TEST(BoundsOfMachines, AreNeededWithEveryNumberOfFractionBits) {
  const auto parts = parts_of_bounds("exact", jones_pdp7_name);
  ASSERT_EQ(parts.size(), 8U);
  for (const std::string bits : {"f=0", "f=1", "f=2", "f=3"}) {
    EXPECT_GT(parts.at(bits), 1.0 / 2) << bits;
    EXPECT_GT(parts.at(bits + " lit"), 1.0 / 3) << bits;
  }
}

TEST(BoundsOfMachines, AreNeededOnEveryDevice) {
  const auto parts = parts_of_bounds("oracle", skala_8080_name);
  EXPECT_EQ(parts.size(), 20U);
  for (const auto& [what, part] : parts) EXPECT_GT(part, 0.4) << what;
}

std::vector<registry::LineAlgorithm> tables_with(std::string_view name,
                                                void (*change)(registry::LineAlgorithm&)) {
  std::vector<registry::LineAlgorithm> lines(registry::line_algorithms().begin(),
                                            registry::line_algorithms().end());
  for (registry::LineAlgorithm& algorithm : lines)
    if (algorithm.name == name) change(algorithm);
  return lines;
}

// Exactly the applicable cells of `name` are in that state.
void expect_only(const SceneCrossCheck& agreement, std::string_view name, CrossCheckState state) {
  EXPECT_FALSE(agreement.agrees());
  for (const CrossCheckCell& cell : agreement.cells) {
    if (cell.state == CrossCheckState::not_applicable) continue;
    const bool concerned = cell.first == name || cell.second == name;
    EXPECT_EQ(cell.state, concerned ? state : CrossCheckState::agrees)
        << cell.first << " and " << cell.second << ": " << cell.text;
  }
}

const CrossCheckCell& cell_of(const SceneCrossCheck& agreement, std::string_view first,
                              std::string_view second) {
  const auto found =
      std::find_if(agreement.cells.begin(), agreement.cells.end(),
                   [&](const CrossCheckCell& cell) { return cell.first == first && cell.second == second; });
  EXPECT_NE(found, agreement.cells.end()) << first << " and " << second;
  return *found;
}

TEST(AgreementFails, WhenAnAlgorithmIsMissing) {
  const auto lines = tables_with("plantinga", [](registry::LineAlgorithm& a) { a.name = "other"; });
  expect_only(cross_check(common_scene("C5"), {lines, registry::face_algorithms()}), "plantinga",
              CrossCheckState::not_run);
  std::vector<registry::FaceAlgorithm> faces(registry::face_algorithms().begin(),
                                            registry::face_algorithms().end());
  std::erase_if(faces, [](const registry::FaceAlgorithm& a) { return a.name == "willis"; });
  expect_only(cross_check(common_scene("C5"), {registry::line_algorithms(), faces}), "willis",
              CrossCheckState::not_run);
}

TEST(AgreementFails, WhenAnAlgorithmRefusesAScene) {
  const auto lines = tables_with("jones", [](registry::LineAlgorithm& a) {
    a.why_not = [](const scene::PolyScene&) { return std::optional<std::string>("not today"); };
  });
  const auto agreement = cross_check(common_scene("C5"), {lines, registry::face_algorithms()});
  expect_only(agreement, "jones", CrossCheckState::not_run);
  EXPECT_EQ(cell_of(agreement, "exact", "jones").text, "view 1: jones: not today");
}

// Moves one end of one piece of the second view slightly, for each kind of comparison.
TEST(AgreementFails, WhenAPieceIsShorter) {
  const auto lines = tables_with("montani-re", [](registry::LineAlgorithm& a) {
    a.prepare = [](const scene::PolyScene& scene) -> base::Result<registry::PreparedScene> {
      auto made = registry::find_line_algorithm("exact")->prepare(scene);
      auto& prepared = *made;
      prepared.view = [whole = prepared.view](const scene::PolyCamera& camera) {
        auto seen = whole(camera);
        picture::LinePiece& piece = seen->picture.pieces[7];
        if (camera.forward[0] == 3) piece.low = mediant(piece.low, piece.high);
        return seen;
      };
      return made;
    };
  });
  const CommonScene scene = common_scene("C5");
  const auto agreement = cross_check(scene, {lines, registry::face_algorithms()});
  EXPECT_FALSE(agreement.agrees());
  const CrossCheckCell& cell = cell_of(agreement, "exact", "montani-re");
  EXPECT_EQ(cell.state, CrossCheckState::differs);
  const picture::LinePiece& piece = agreement.pictures[0][1].lines->pieces[7];
  const std::string edge =
      "edge " + std::to_string(piece.edge.from) + "-" + std::to_string(piece.edge.to) + ":";
  EXPECT_TRUE(cell.text.starts_with("view 2: " + edge)) << cell.text;
}

// Shows one face in place of another, in nine pixels.
TEST(AgreementFails, WhenAFaceIsAnother) {
  std::vector<registry::FaceAlgorithm> faces(registry::face_algorithms().begin(),
                                            registry::face_algorithms().end());
  for (registry::FaceAlgorithm& algorithm : faces) {
    if (algorithm.name != "willis") continue;
    algorithm.prepare = [](const scene::PolyScene& scene, const registry::FaceOptions& options) {
      auto made = registry::find_face_algorithm("willis")->prepare(scene, options);
      auto& prepared = *made;
      prepared.view = [view = prepared.view](const scene::PolyCamera& camera,
                                             const registry::FaceWindow& window) {
        auto seen = view(camera, window);
        picture::PixelGrid& grid = seen->faces;
        for (int row = 100; row < 103; ++row)
          for (int column = 60; column < 63; ++column) grid.set(column, row, 99);
        return seen;
      };
      return made;
    };
  }
  const auto agreement = cross_check(common_scene("C8"), {registry::line_algorithms(), faces});
  expect_only(agreement, "willis", CrossCheckState::differs);
}

}  // namespace
}  // namespace sightline::compare
