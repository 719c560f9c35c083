// All algorithms against each other on the common scenes of polyhedra, and that the comparison notices what
// it is there to notice.
#include "host/compare/cross_check.hpp"
#include "host/compare/stripes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "host/algorithms/registry/heights.hpp"
#include "host/base/result.hpp"
#include "host/compare/cross_check_compare.hpp"
#include "host/compare/turning.hpp"
#include "host/compare/willis_8080.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/model/eye_place.hpp"
#include "tests/host/compare/cross_check_suite.hpp"

namespace sightline::compare {
namespace {

TEST_P(AgreementOn, Polyhedra) {
  expect_agreement(std::get<0>(GetParam()), std::get<1>(GetParam()));
}
INSTANTIATE_TEST_SUITE_P(Agreement, AgreementOn,
                         testing::Combine(testing::Range(std::size_t{0}, polyhedra_count()),
                                          testing::Range(std::size_t{0}, pair_count())),
                         agreement_name);

TEST(CommonScenes, ArePossibleAndParallelViewsBeginBeforeThem) {
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

// The sight line of a pixel goes through its middle, and the window says the same.
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
std::set<std::string_view> registered() {
  std::set<std::string_view> names;
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms()) names.insert(algorithm.name);
  for (const registry::FaceAlgorithm& algorithm : registry::face_algorithms()) names.insert(algorithm.name);
  for (const registry::HeightMethod& method : registry::height_methods())
    if (!method.algorithm.empty()) names.insert(method.algorithm);
  names.insert(stripes_name);
  names.insert(willis_on_8080().name);
  names.insert(turn_name);
  return names;
}

bool excludes(const NotApplicable& exclusion, std::string_view who, const CommonScene& scene) {
  if (exclusion.who != who || !scene.name.starts_with(exclusion.scenes)) return false;
  return exclusion.views == NotApplicable::Views::all ||
         std::all_of(scene.views.begin(), scene.views.end(),
                     [](const CrossCheckView& view) { return view.camera.perspective; });
}

// All pairs of the registries' algorithms on all scenes, less those with an excluded one.
TEST(CommonScenes, EveryPairRunsThatIsNotExcluded) {
  const std::set<std::string_view> names = registered();
  EXPECT_EQ(participants().size(), names.size());
  std::set<const NotApplicable*> used;
  for (const std::string_view scene_name : common_scene_names()) {
    const CommonScene scene = common_scene(scene_name);
    std::size_t taking_part = 0;
    for (const std::string_view who : names) {
      bool excluded = false;
      for (const NotApplicable& exclusion : not_applicable()) {
        if (!excludes(exclusion, who, scene)) continue;
        excluded = true;
        used.insert(&exclusion);
      }
      taking_part += excluded ? 0 : 1;
    }
    EXPECT_GE(taking_part, 5U) << scene.name;
    EXPECT_EQ(listed_cells(scene), taking_part * (taking_part - 1) / 2) << scene.name;
  }
  for (const NotApplicable& exclusion : not_applicable()) {
    EXPECT_TRUE(used.contains(&exclusion)) << exclusion.who << ": excluded from nothing";
    EXPECT_FALSE(exclusion.reason.empty()) << exclusion.who;
  }
}

std::vector<registry::LineAlgorithm> tables_with(std::string_view name,
                                                void (*change)(registry::LineAlgorithm&)) {
  std::vector<registry::LineAlgorithm> lines(registry::line_algorithms().begin(),
                                            registry::line_algorithms().end());
  for (registry::LineAlgorithm& algorithm : lines)
    if (algorithm.name == name) change(algorithm);
  return lines;
}

// Exactly the cells of `name` that are listed to run are in that state.
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

// One end of one piece of the second view moved by a little, for each kind of comparison.
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

// A face that is shown where another one is, in nine pixels.
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
