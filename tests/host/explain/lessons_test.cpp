// Laws of every lesson, on scenes of every kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/explain/explain.hpp"
#include "host/explain/stage.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/model/eye_place.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/load.hpp"
#include "tests/host/explain/load_scene.hpp"

namespace sightline::explain {
namespace {

scene::PolyCamera parallel() { return {false, {0, 0, 0}, {50, -30, 86}, {86, 0, -50}, {30 * 50, 86 * 86 + 50 * 50, 30 * 86}}; }

// Sheets exist, marks are complete, there are captions, and counts have the same names throughout and never decrease.
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
        const bool one = mark.kind == Mark::Kind::dot || mark.kind == Mark::Kind::text || mark.kind == Mark::Kind::label;
        EXPECT_TRUE(one ? mark.points.size() == 1 : mark.points.size() >= 2) << what << ", step " << n << ", " << layer.name;
        for (const Point& p : mark.points) EXPECT_TRUE(p[0] == p[0] && p[1] == p[1]) << what << ", step " << n << ", " << layer.name;
      }
    }
  }
  EXPECT_LE(silent, 2U) << what << ": steps that change nothing";
}

class Lessons : public testing::TestWithParam<std::string> {};

TEST_P(Lessons, SatisfyTheLawsOnEveryScene) {
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
    const scene::LoadedScene source = load_scene(name);
    for (const scene::PolyCamera& camera : {source.scene.camera, parallel()}) {
      const auto cells = scene::own_cells(source);
      const auto lesson = explainer.scene(source.scene, camera, cells ? &*cells : nullptr);
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

// A lesson of lines ends with the picture of `exact`, piece by piece; Montani and Re draw coincident lines once.
TEST(Lessons, EndWithThePicture) {
  for (const char* const name : {"house", "roberts", "boxes-4", "bricks-3"}) {
    const scene::LoadedScene source = load_scene(name);
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

// The contents of all layers of a sheet after each step.
template <class Look>
void for_each_state(const Lesson& lesson, std::size_t sheet, Look look) {
  std::map<std::string, std::vector<Mark>> layers;
  for (const Step& step : lesson.steps) {
    for (const Layer& layer : step.changes)
      if (layer.sheet == sheet) layers[layer.name] = layer.marks;
    look(step, layers);
  }
}

std::uint64_t count_of(const Step& step, const std::string& name) {
  for (const Count& count : step.counts)
    if (count.name == name) return count.value;
  ADD_FAILURE() << "no count " << name;
  return 0;
}

// The lesson of a scene of cells uses the scene's cells: the search visits what the program on the PDP-7 visits in a field of 127
// degrees. (In its default field of 90 degrees street4 takes two visits less: the search has no window.)
TEST(Lessons, OfJonesVisitTheCellsThatTheProgramVisits) {
  for (const std::string name : {"house", "roberts", "corridor8", "corridor32", "street4"}) {
    const scene::LoadedScene source = load_scene(name);
    const auto cells = scene::own_cells(source);
    ASSERT_TRUE(cells) << name;
    const auto lesson = find_explainer("jones")->scene(source.scene, source.scene.camera, &*cells);
    ASSERT_TRUE(lesson) << name;
    programs::jones::Order order;
    order.eye = source.scene.camera.eye;
    order.views = 1;
    order.scale = 256;
    const auto outcome = programs::jones::run(*source.cells, {}, order);
    ASSERT_TRUE(outcome) << name;
    const Step& last = lesson->steps.back();
    EXPECT_EQ(count_of(last, "cells of the scene"), source.cells->cells.size()) << name;
    EXPECT_EQ(count_of(last, "cells entered"), outcome->view().distinct_cells) << name;
    EXPECT_EQ(count_of(last, "visits"), outcome->view().visits) << name;
    const std::size_t cell = *scene::locate(*source.cells, source.scene.camera.eye);
    EXPECT_TRUE(lesson->steps[1].caption.starts_with("The eye is in cell " + std::to_string(cell) + ".")) << lesson->steps[1].caption;
    EXPECT_TRUE(lesson->steps[0].caption.find("joined by " + std::to_string(source.cells->openings.size()) + " portals") != std::string::npos)
        << lesson->steps[0].caption;
  }
}

// The state of house at the end of Jones's lesson: no cell waits and none belongs to the step. Before that every portal that a
// visit
// meets is in exactly one count, and a step names those that lead back towards the eye.
TEST(Lessons, OfJonesCountEveryPortalOnce) {
  for (const std::string name : {"house", "street4", "boxes-3"}) {
    const scene::LoadedScene source = load_scene(name);
    const auto lesson = explain_scene(*find_explainer("jones"), source, source.scene.camera);
    ASSERT_TRUE(lesson) << name;
    std::uint64_t portals = 0, told = 0, named_away = 0;
    std::vector<std::size_t> waiting;
    for_each_state(*lesson, 1, [&](const Step& step, std::map<std::string, std::vector<Mark>>& layers) {
      const auto number_before = [&](std::string_view words) {
        const std::size_t end = step.caption.find(words);
        return end == std::string::npos ? 0UL : std::stoul(step.caption.substr(step.caption.rfind(' ', end - 1) + 1));
      };
      portals += number_before(" portals to other cells");
      told = count_of(step, "portals with a part in the mask") + count_of(step, "portals outside the mask") + count_of(step, "portals turned away");
      if (step.caption.find("turned away.") != std::string::npos) ++named_away;
      waiting.push_back(0);
      for (const auto& [layer, marks] : layers) {
        for (const Mark& mark : marks) {
          if (mark.kind != Mark::Kind::area) continue;
          waiting.back() += mark.look == Look::waiting ? 1 : 0;
          if (&step == &lesson->steps.back()) {
            EXPECT_EQ(mark.look, Look::seen) << name << ": " << layer << " at the end";
          }
        }
      }
    });
    EXPECT_EQ(waiting.back(), 0U) << name;
    if (name == "boxes-3") continue;  // the eye is outside
    EXPECT_EQ(told, portals) << name;
    EXPECT_GT(named_away, 1U) << name;
    EXPECT_GT(*std::max_element(waiting.begin(), waiting.end()), 1U) << name;
  }
  // By hand, from the plan of the house: from cell 1 the doors to cells 0 and 2 lead back, and both other rooms wait after cell
  // 0.
  const scene::LoadedScene house = load_scene("house");
  const auto lesson = explain_scene(*find_explainer("jones"), house, house.scene.camera);
  std::size_t last_first = 0;
  for (std::size_t n = 0; n < lesson->steps.size(); ++n) {
    if (lesson->steps[n].caption.find("Of the cells that wait the last one comes first") == std::string::npos) continue;
    ++last_first;
    EXPECT_TRUE(lesson->steps[n].caption.starts_with("Cell 1 is entered.")) << lesson->steps[n].caption;
    EXPECT_EQ(lesson->steps[n + 2].caption, "Portals 0 and 2 lead back towards the eye: turned away.");
  }
  EXPECT_EQ(last_first, 1U);
}

// Lines drawn by a step lie within its mask, and the sheet is the field of the program on the PDP-7: 90 degrees.
TEST(Lessons, OfJonesDrawLinesWithinTheMask) {
  for (const std::string name : {"house", "street4"}) {
    const scene::LoadedScene source = load_scene(name);
    const auto lesson = explain_scene(*find_explainer("jones"), source, source.scene.camera);
    ASSERT_TRUE(lesson) << name;
    EXPECT_EQ(lesson->sheets[0].low, (Point{-1, -1})) << name;
    EXPECT_EQ(lesson->sheets[0].high, (Point{1, 1})) << name;
    std::size_t drawn = 0;
    for_each_state(*lesson, 0, [&](const Step& step, std::map<std::string, std::vector<Mark>>& layers) {
      if (step.caption.find("clipped to the mask: ") == std::string::npos) return;
      if (layers["mask"].empty()) return;  // off the sheet
      const std::vector<Point>& mask = layers["mask"].front().points;
      double area = 0;
      for (std::size_t i = 0; i < mask.size(); ++i) {
        const Point& p = mask[i];
        const Point& q = mask[(i + 1) % mask.size()];
        area += p[0] * q[1] - q[0] * p[1];
      }
      for (const Mark& mark : layers["line"]) {
        EXPECT_EQ(mark.look, Look::now) << name << ": " << step.caption;
        ++drawn;
        if (lesson->sheets[0].low == *std::min_element(mask.begin(), mask.end())) continue;  // bounded by the sheet, not the mask
        for (const Point& at : mark.points)
          for (std::size_t i = 0; i < mask.size(); ++i) {
            const Point& p = mask[i];
            const Point& q = mask[(i + 1) % mask.size()];
            // The border of the sheet is not a side of the mask.
            if ((p[0] == q[0] && std::abs(p[0]) == 1) || (p[1] == q[1] && std::abs(p[1]) == 1)) continue;
            const double left = (q[0] - p[0]) * (at[1] - p[1]) - (q[1] - p[1]) * (at[0] - p[0]);
            EXPECT_GE(area > 0 ? left : -left, -1e-9) << name << ": " << step.caption;
          }
      }
    });
    EXPECT_GT(drawn, 30U) << name;
  }
}

// If the eye is outside, the lines in the outer walls have a mask, and no cell is named before one is entered.
TEST(Lessons, OfJonesFromOutsideHaveAMaskFirst) {
  const scene::LoadedScene boxes = load_scene("boxes-3");
  const auto perspective = explain_scene(*find_explainer("jones"), boxes, boxes.scene.camera);
  ASSERT_TRUE(perspective);
  bool inside = false;
  for_each_state(*perspective, 0, [&](const Step& step, std::map<std::string, std::vector<Mark>>& layers) {
    inside |= step.caption.find(" is entered.") != std::string::npos;  // then its mask may be off the sheet
    EXPECT_TRUE(inside || step.caption.find("mask") == std::string::npos || !layers["mask"].empty()) << step.caption;
  });
  const scene::LoadedScene source = load_scene("house");
  const auto lesson = explain_scene(*find_explainer("jones"), source, parallel());
  ASSERT_TRUE(lesson);
  bool entered = false, mask = false;
  std::size_t outer = 0;
  for (const Step& step : lesson->steps) {
    for (const Layer& layer : step.changes)
      if (layer.sheet == 0 && layer.name == "mask") mask = !layer.marks.empty();
    entered |= step.caption.find(" is entered.") != std::string::npos;
    if (step.caption.find("lines ") == std::string::npos || entered) continue;
    EXPECT_EQ(step.caption.find("ines of cell"), std::string::npos) << step.caption;
    if (step.caption.starts_with("The lines in the outer walls")) {
      ++outer;
      EXPECT_TRUE(mask);
    }
  }
  EXPECT_EQ(outer, 1U);
}

// The arrow of the plan is the viewing direction, whichever axis points up on the sheet.
TEST(PlanStage, HasAnArrowInTheDirectionOfView) {
  const scene::PolyScene scene = load_scene("boxes-3").scene;
  for (const bool perspective : {true, false}) {
    const scene::PolyCamera camera{perspective, {10, 20, 30}, {70, 0, 71}, {71, 0, -70}, {0, 1, 0}};
    const PlanStage ground(scene, camera);
    const auto arrow = ground.arrow();
    ASSERT_EQ(arrow.size(), 2U);
    const Point& from = arrow[0].points[0];
    const Point& to = arrow[0].points[1];
    const Point ahead = ground.at({10 + 70, 20, 30 + 71});
    const Point eye = ground.at({10, 20, 30});
    const double across = (to[0] - from[0]) * (ahead[1] - eye[1]) - (to[1] - from[1]) * (ahead[0] - eye[0]);
    EXPECT_NEAR(across, 0, 1e-6);
    EXPECT_GT((to[0] - from[0]) * (ahead[0] - eye[0]) + (to[1] - from[1]) * (ahead[1] - eye[1]), 0);
    if (perspective) {
      EXPECT_EQ(from, eye);
    }
  }
}

// A lesson at its size limit ends the search there, with a message.
TEST(Lessons, OfJonesStopAtTheLimit) {
  const scene::LoadedScene source = load_scene("boxes-40");
  const auto lesson = explain_scene(*find_explainer("jones"), source, source.scene.camera);
  ASSERT_TRUE(lesson);
  EXPECT_EQ(lesson->cut, lesson->steps.size() == most_steps);
  EXPECT_TRUE(lesson->cut);
}

// A lesson of a turn begins and ends with the picture of `exact`, and passes every event once.
TEST(Lessons, OfATurnBeginAndEndWithTheExactPicture) {
  for (const char* const name : {"house", "roberts", "boxes-4", "triangles-8"}) {
    scene::PolyScene scene = load_scene(name).scene;
    scene.camera = {false, {0, 0, 0}, {-271, 0, 314}, {314, 0, 271}, {0, 1, 0}};
    const auto picture = algorithms::exact::visible_edges(scene, scene.camera);
    const auto lesson = find_explainer("plantinga")->scene(scene, scene.camera, nullptr);
    ASSERT_TRUE(lesson) << name;
    std::size_t initial = 0, events = 0, most = 0;
    std::vector<Mark> last;
    for_each_state(*lesson, 0, [&](const Step& step, std::map<std::string, std::vector<Mark>>& layers) {
      if (step.caption.starts_with("The initial picture")) initial = layers["seen"].size();
      if (step.caption.starts_with("Event ")) {
        EXPECT_EQ(count_of(step, "events passed"), ++events) << name;
        EXPECT_FALSE(layers["edge"].empty() && layers["cause"].empty()) << name << ": " << step.caption;
      }
      // Between events the complete graph is drawn.
      if (step.caption.starts_with("The structure stays")) {
        EXPECT_EQ(layers["seen"].size(), count_of(step, "pieces seen")) << name;
      }
      if (step.caption.starts_with("The turn is complete")) last = layers["seen"];
      most = count_of(step, "events");
    });
    EXPECT_EQ(initial, picture.pieces.size()) << name;
    EXPECT_EQ(last.size(), picture.pieces.size()) << name;
    EXPECT_EQ(events, most) << name;
    EXPECT_LE(lesson->steps.size(), 400U) << name;
    for (const Count& count : lesson->steps.back().counts)
      if (count.name != "pieces seen") {
        for (std::size_t i = 1; i < lesson->steps.size(); ++i)
          EXPECT_GE(count_of(lesson->steps[i], count.name), count_of(lesson->steps[i - 1], count.name)) << name << ", step " << i;
      }
  }
}

// The last steps show the scene as `exact` does from a place between two events, from above and in perspective.
TEST(Lessons, OfATurnEndWithOtherTurns) {
  for (const char* const name : {"house", "roberts", "boxes-4", "triangles-8"}) {
    scene::PolyScene scene = load_scene(name).scene;
    scene.camera = {false, {0, 0, 0}, {-271, 0, 314}, {314, 0, 271}, {0, 1, 0}};
    const auto lesson = find_explainer("plantinga")->scene(scene, scene.camera, nullptr);
    ASSERT_TRUE(lesson) << name;
    const scene::PolyPoint middle = scene::bounds_of(scene).middle();
    std::map<std::string, double> angles;
    for_each_state(*lesson, 1, [&](const Step& step, std::map<std::string, std::vector<Mark>>& layers) {
      for (const Mark& mark : layers["sight"]) std::sscanf(mark.text.c_str(), "viewer at %lf degrees", &angles[step.caption]);
    });
    std::size_t turns = 0;
    for_each_state(*lesson, 0, [&](const Step& step, std::map<std::string, std::vector<Mark>>& layers) {
      const bool above = step.caption.starts_with("Here the axis is vertical again");
      const bool perspective = step.caption.starts_with("\"Perspective projection");
      turns += above || perspective || step.caption.starts_with("\"Other rotations");
      if (!above && !perspective) return;
      const double angle = angles.at(step.caption) * std::numbers::pi / 180;
      double radius = 1;
      for (const scene::PolyPoint& p : scene.vertices)
        radius = std::max(radius, std::hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]));
      const auto part = [&](double length, double direction) { return static_cast<std::int32_t>(std::lround(length * direction)); };
      scene::PolyCamera camera{perspective, {}, {part(-20000, std::sin(angle)), -10000, part(-20000, std::cos(angle))}, {}, {}};
      const double far = std::round(2 * radius);
      if (perspective)
        camera.eye = {middle[0] + part(far, std::sin(angle)), middle[1] + part(far, 0.5), middle[2] + part(far, std::cos(angle))};
      camera.right = {camera.forward[2], 0, -camera.forward[0]};
      const auto [x, y, z] = camera.forward;
      camera.up = std::abs(z) > std::abs(x) ? scene::PolyPoint{0, z, -y} : scene::PolyPoint{-y, x, 0};
      const auto picture = algorithms::exact::visible_edges(scene, camera);
      EXPECT_EQ(layers["seen"].size(), picture.pieces.size()) << name << ": " << step.caption;
      EXPECT_EQ(count_of(step, "pieces seen"), picture.pieces.size()) << name;
    });
    EXPECT_EQ(turns, 3U) << name;
  }
}

// The chart explains the colours of the occurring groups of events, as many as the caption counts.
TEST(Lessons, OfATurnExplainTheEventsThatOccur) {
  std::size_t with_less = 0;
  for (const char* const name : {"house", "boxes-2", "boxes-3", "triangles-8"}) {
    const scene::LoadedScene source = load_scene(name);
    const auto lesson = explain_scene(*find_explainer("plantinga"), source, source.scene.camera);
    ASSERT_TRUE(lesson) << name;
    for (const Step& step : lesson->steps) {
      if (!step.caption.starts_with("The event list of a full turn")) continue;
      const bool edge_on = step.caption.find("at 0 events a face") == std::string::npos;
      const bool vertices = step.caption.find("at 0 a vertex") == std::string::npos;
      const bool three = step.caption.find("at 0 three edges") == std::string::npos;
      std::string shown;
      for (const Layer& layer : step.changes)
        if (layer.name == "legend")
          for (const Mark& mark : layer.marks) shown += mark.text + '\n';
      EXPECT_EQ(shown.find("plane edge-on") != std::string::npos, edge_on) << name << shown;
      EXPECT_EQ(shown.find("EV: ") != std::string::npos, vertices) << name << shown;
      EXPECT_EQ(shown.find("EEE: ") != std::string::npos, three) << name << shown;
      with_less += edge_on && vertices && three ? 0 : 1;
    }
  }
  EXPECT_GT(with_less, 0U);
}

// The picture is the camera's and not its mirror image, for any handedness of right, up and forward.
TEST(Lessons, OfATurnAreNotMirrored) {
  for (const char* const name : {"house", "boxes-3"}) {
    const scene::PolyScene scene = load_scene(name).scene;
    for (const int hand : {1, -1}) {
      const scene::PolyCamera camera{false, {0, 0, 0}, {-271, 0, 314}, {314 * hand, 0, 271 * hand}, {0, 1, 0}};
      const auto lesson = find_explainer("plantinga")->scene(scene, camera, nullptr);
      ASSERT_TRUE(lesson) << name;
      const ImageStage stage(scene, camera);
      const std::vector<Mark> wire = stage.wire_frame();
      const Layer& drawn = lesson->steps[0].changes[0];
      ASSERT_EQ(drawn.name, "wire");
      ASSERT_EQ(drawn.marks.size(), wire.size());
      // The same except for a shift.
      const double shift = drawn.marks[0].points[0][0] - wire[0].points[0][0];
      for (std::size_t i = 0; i < wire.size(); ++i)
        for (std::size_t end = 0; end < 2; ++end)
          EXPECT_NEAR(drawn.marks[i].points[end][0] - wire[i].points[end][0], shift, 1e-6)
              << name << ", hand " << hand << ", line " << i;
    }
  }
}

TEST(Lessons, OfAPerspectiveCameraNameTheUsedPartOfIt) {
  const scene::LoadedScene source = load_scene("house");
  const auto perspective = find_explainer("plantinga")->scene(source.scene, source.scene.camera, nullptr);
  ASSERT_TRUE(perspective);
  EXPECT_NE(perspective->steps[0].caption.find("horizontal direction"), std::string::npos);
  const scene::PolyCamera level{false, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  const auto parallel_one = find_explainer("plantinga")->scene(source.scene, level, nullptr);
  ASSERT_TRUE(parallel_one);
  EXPECT_EQ(parallel_one->steps[0].caption.find("horizontal direction"), std::string::npos);
  // From straight above there is no horizontal direction: one is chosen.
  const scene::PolyCamera above{false, {0, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_TRUE(find_explainer("plantinga")->scene(source.scene, above, nullptr));
}

TEST(Lessons, ExistForEveryBuiltInSceneOrAnErrorSaysWhyNot) {
  std::size_t made = 0;
  for (const std::string_view name : scene::builtin_scene_names()) {
    const scene::LoadedScene source = load_scene(std::string(name));
    const auto lesson = find_explainer("exact")->scene(source.scene, source.scene.camera, nullptr);
    if (lesson) {
      expect_lawful(*lesson, std::string(name));
      ++made;
    } else {
      EXPECT_GT(lesson.error().message().size(), 20U) << name;
    }
  }
  EXPECT_GT(made, 3U);
}

TEST(Explainers, AreTheFiveOfThePapersAndExact) {
  ASSERT_EQ(explainers().size(), 6U);
  for (const Explainer& explainer : explainers()) {
    EXPECT_TRUE((explainer.scene == nullptr) != (explainer.heights == nullptr)) << explainer.algorithm;
    EXPECT_EQ(find_explainer(explainer.algorithm), &explainer);
  }
  EXPECT_EQ(find_explainer("nothing"), nullptr);
}

TEST(Lessons, RejectUnsuitableScenes) {
  const scene::LoadedScene large = load_scene("boxes-200");
  EXPECT_FALSE(find_explainer("willis")->scene(large.scene, large.scene.camera, nullptr));
  EXPECT_FALSE(find_explainer("plantinga")->scene(large.scene, large.scene.camera, nullptr));
}

}  // namespace
}  // namespace sightline::explain
