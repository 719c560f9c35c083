// Laws of every lesson, on scenes of every kind.
#include <gtest/gtest.h>

#include <map>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/explain/explain.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::explain {
namespace {

scene::LoadedScene loaded(const std::string& name) {
  auto found = scene::named_scene(name);
  EXPECT_TRUE(found && *found) << name;
  return *scene::load_scene(std::move(**found));
}

scene::PolyCamera parallel() { return {false, {0, 0, 0}, {50, -30, 86}, {86, 0, -50}, {30 * 50, 86 * 86 + 50 * 50, 30 * 86}}; }

// Sheets that exist, marks that are whole, captions, and counts with the same names throughout that never fall.
void expect_lawful(const Lesson& lesson, const std::string& what) {
  ASSERT_GT(lesson.steps.size(), 3U) << what;
  EXPECT_LE(lesson.steps.size(), most_steps) << what;
  EXPECT_FALSE(lesson.title.empty());
  for (const Sheet& sheet : lesson.sheets) {
    EXPECT_FALSE(sheet.title.empty()) << what;
    for (std::size_t a = 0; a < 2; ++a) EXPECT_LT(sheet.low[a], sheet.high[a]) << what << ": " << sheet.title;
  }
  std::size_t silent = 0;
  for (std::size_t n = 0; n < lesson.steps.size(); ++n) {
    const Step& step = lesson.steps[n];
    EXPECT_GT(step.caption.size(), 15U) << what << ", step " << n;
    EXPECT_EQ(step.caption.back(), '.') << what << ": " << step.caption;
    EXPECT_EQ(step.caption.find("  "), std::string::npos) << what << ": " << step.caption;
    silent += step.changes.empty() ? 1 : 0;
    ASSERT_EQ(step.counts.size(), lesson.steps.front().counts.size()) << what << ", step " << n;
    for (std::size_t c = 0; c < step.counts.size(); ++c) EXPECT_EQ(step.counts[c].name, lesson.steps.front().counts[c].name);
    for (const Layer& layer : step.changes) {
      ASSERT_LT(layer.sheet, lesson.sheets.size()) << what << ": " << layer.name;
      EXPECT_FALSE(layer.name.empty());
      for (const Mark& mark : layer.marks) {
        const bool one = mark.kind == Mark::Kind::dot || mark.kind == Mark::Kind::text;
        EXPECT_TRUE(one ? mark.points.size() == 1 : mark.points.size() >= 2) << what << ", step " << n << ", " << layer.name;
        for (const Point& p : mark.points) EXPECT_TRUE(p[0] == p[0] && p[1] == p[1]) << what << ", step " << n << ", " << layer.name;
      }
    }
  }
  EXPECT_LE(silent, 2U) << what << ": steps that change nothing";
}

class Lessons : public testing::TestWithParam<std::string> {};

TEST_P(Lessons, AreLawfulOnEveryScene) {
  const Explainer& explainer = *find_explainer(GetParam());
  if (explainer.heights != nullptr) {
    for (const scene::HeightFunction& function : scene::height_functions()) {
      for (const double rotation : {0.0, 30.0, 200.0}) {
        const auto lesson = explainer.heights(scene::sample(function, {9, 7}), rotation, 25);
        ASSERT_TRUE(lesson) << function.name;
        expect_lawful(*lesson, std::string(function.name));
      }
    }
    return;
  }
  for (const char* const name : {"house", "roberts", "street4", "boxes-4", "bricks-3", "triangles-3", "town-3", "rooms-1"}) {
    const scene::LoadedScene source = loaded(name);
    for (const scene::PolyCamera& camera : {source.scene.camera, parallel()}) {
      const auto lesson = explainer.scene(source.scene, camera, source.decomposition ? &source.decomposition->complex : nullptr);
      if (!lesson) {
        EXPECT_GT(lesson.error().message().size(), 20U) << name;
        continue;
      }
      expect_lawful(*lesson, std::string(name) + (camera.perspective ? "" : ", parallel"));
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Each, Lessons, testing::Values("exact", "jones", "skala", "montani-re", "willis", "plantinga"),
                         [](const auto& each) { return each.param == "montani-re" ? "montani_re" : each.param; });

// What a lesson of lines ends with is the picture of `exact`, piece for piece; Montani and Re draw lines that lie on each other once.
TEST(Lessons, EndWithThePicture) {
  for (const char* const name : {"house", "roberts", "boxes-4", "bricks-3"}) {
    const scene::LoadedScene source = loaded(name);
    const auto picture = algorithms::exact::visible_edges(source.scene, source.scene.camera);
    for (const char* const algorithm : {"exact", "jones"}) {
      const auto lesson = find_explainer(algorithm)->scene(source.scene, source.scene.camera, nullptr);
      ASSERT_TRUE(lesson) << algorithm << ' ' << name;
      std::map<std::string, std::vector<Mark>> layers;
      for (const Step& step : lesson->steps)
        for (const Layer& layer : step.changes)
          if (layer.sheet == 0) layers[layer.name] = layer.marks;
      EXPECT_EQ(layers["seen"].size(), picture.pieces.size()) << algorithm << ' ' << name;
    }
  }
}

TEST(Explainers, AreTheFiveOfThePapersAndExact) {
  ASSERT_EQ(explainers().size(), 6U);
  for (const Explainer& explainer : explainers()) {
    EXPECT_TRUE((explainer.scene == nullptr) != (explainer.heights == nullptr)) << explainer.algorithm;
    EXPECT_EQ(find_explainer(explainer.algorithm), &explainer);
  }
  EXPECT_EQ(find_explainer("nothing"), nullptr);
}

TEST(Lessons, RefuseWhatCannotBeFollowed) {
  const scene::LoadedScene large = loaded("boxes-200");
  EXPECT_FALSE(find_explainer("willis")->scene(large.scene, large.scene.camera, nullptr));
  EXPECT_FALSE(find_explainer("plantinga")->scene(large.scene, large.scene.camera, nullptr));
}

}  // namespace
}  // namespace sightline::explain
