// A lesson as JSON and as a page, and the stage on which it is drawn.
#include "host/explain/lesson.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/json.hpp"
#include "host/explain/lesson_page.hpp"
#include "host/explain/stage.hpp"

namespace sightline::explain {
namespace {

Lesson small_lesson(const std::string& scene) {
  Lesson lesson{"exact", "A title with \"quotes\"", scene, {{"The image", {-1, -2}, {3, 4}, true}}, {}};
  Steps steps(lesson);
  steps.count("lines", 1);
  steps.add("First.", "section 2",
            {{0, "a", {line(Look::seen, {{0.123456, 1}, {-0.00001, 2.5}}), text(Look::now, {1, 2}, "x < y"), label(Look::other, {3, 4}, "face 5")}}});
  steps.count("lines", 2);
  steps.add("Second.", "", {{0, "a", {}}, {0, "b", {area(Look::mask, {{0, 0}, {1, 0}, {0, 1}}), dot(Look::plain, {5, 6})}}});
  return lesson;
}

TEST(LessonJson, HasAllPartsOfTheLesson) {
  const auto json = base::parse_json(json_of(small_lesson("house")), "lesson");
  ASSERT_TRUE(json);
  EXPECT_EQ(*json->find("schema")->text(), "sightline/explain/1");
  EXPECT_EQ(*json->find("title")->text(), "A title with \"quotes\"");
  const auto& sheet = (*json->find("sheets"))[0];
  EXPECT_EQ(sheet.find("stretched")->boolean(), true);
  EXPECT_EQ((*sheet.find("low"))[1].number(), -2);
  ASSERT_EQ(json->find("steps")->size(), 2U);
  const auto& first = (*json->find("steps"))[0];
  EXPECT_EQ(first.find("counts")->find("lines")->integer(), 1);
  EXPECT_EQ((*json->find("steps"))[1].find("counts")->find("lines")->integer(), 2);
  const auto& mark = (*(*first.find("layers"))[0].find("marks"))[0];
  EXPECT_EQ(mark.dump(), R"(["line","seen",0.1235,1,0,2.5])");
  EXPECT_EQ((*(*first.find("layers"))[0].find("marks"))[1].dump(), R"(["text","now",1,2,"x < y"])");
  EXPECT_EQ((*(*first.find("layers"))[0].find("marks"))[2].dump(), R"(["label","other",3,4,"face 5"])");
}

TEST(LessonPage, NoTextInALessonEndsItsScript) {
  const std::string page = page_of(small_lesson("</script><script>alert(1)//"));
  std::size_t scripts = 0;
  for (std::size_t at = page.find("</script"); at != std::string::npos; at = page.find("</script", at + 1)) ++scripts;
  EXPECT_EQ(scripts, 2U);
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_NE(page.find("makePlayer"), std::string::npos);
  // The contents of the page are the lesson.
  const std::size_t begin = page.find("id=\"lesson\">") + 12;
  const auto json = base::parse_json(page.substr(begin, page.find("</script", begin) - begin), "page");
  ASSERT_TRUE(json);
  EXPECT_EQ(*json->find("scene")->text(), "</script><script>alert(1)//");
}

TEST(LessonSteps, StopAtTheLimit) {
  Lesson lesson;
  Steps steps(lesson);
  std::size_t added = 0;
  while (steps.add("again", "", {})) ++added;
  EXPECT_EQ(lesson.steps.size(), most_steps);
  EXPECT_EQ(added, most_steps - 1);
  EXPECT_FALSE(steps.add("again", "", {}));
  EXPECT_EQ(lesson.steps.size(), most_steps);
  EXPECT_NE(lesson.steps.back().caption, "again");
}

scene::PolyScene two_points(scene::PolyPoint a, scene::PolyPoint b) {
  scene::PolyScene scene;
  scene.vertices = {a, b, {0, 0, 100}, {100, 0, 100}, {0, 100, 100}};
  scene.bodies = {{"", true, {{{2, 3, 4}, {}}}}};
  return scene;
}

TEST(ImageStage, ClipsLinesBehindTheEye) {
  const scene::PolyScene scene = two_points({0, 0, -50}, {0, 10, 50});
  const ImageStage stage(scene, {true, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_TRUE(stage.line_in_image({0, 0, -1}, {5, 5, -10}).empty());
  const auto cut = stage.line_in_image(space(scene.vertices[0]), space(scene.vertices[1]));
  ASSERT_EQ(cut.size(), 2U);
  EXPECT_NEAR(cut[1][1], 0.2, 1e-12);  // the far end is complete: 10 / 50
  EXPECT_GT(cut[0][1], cut[1][1]);     // the near end is where the line crosses the plane in front of the eye
}

TEST(ImageStage, IsThePictureOfTheCamera) {
  const scene::PolyScene scene = two_points({0, 0, 0}, {1, 0, 0});
  const ImageStage perspective(scene, {true, {10, 0, 0}, {0, 0, 2}, {3, 0, 0}, {0, 5, 0}});
  const auto seen = perspective.line_in_image({20, 30, 100}, {20, 30, 200});
  EXPECT_NEAR(seen[0][0], 0.1, 1e-12);
  EXPECT_NEAR(seen[0][1], 0.3, 1e-12);
  const ImageStage parallel(scene, {false, {10, 0, 0}, {0, 0, 2}, {3, 0, 0}, {0, 5, 0}});
  EXPECT_NEAR(parallel.line_in_image({20, 30, -500}, {0, 0, 0})[0][0], 10, 1e-12);
}

// A scene behind the eye gives an empty sheet, which can be drawn all the same.
TEST(ImageStage, IsEmptyForASceneBehindTheEye) {
  const scene::PolyScene scene = two_points({0, 0, 0}, {1, 0, 0});
  const ImageStage stage(scene, {true, {0, 0, 500}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_TRUE(stage.wire_frame().empty());
  std::vector<Mark> marks;
  stage.add_face(marks, Look::plain, scene.bodies[0].faces[0]);
  EXPECT_TRUE(marks.empty());
  const Sheet sheet = stage.sheet("The image");
  EXPECT_LT(sheet.low[0], sheet.high[0]);
  EXPECT_LT(sheet.low[1], sheet.high[1]);
}

TEST(ImageStage, CutsAnOutlineThatPassesTheEye) {
  const scene::PolyScene scene = two_points({0, 0, 0}, {1, 0, 0});
  const ImageStage stage(scene, {true, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  const std::vector<Space> square{{-1, -1, 50}, {1, -1, 50}, {1, -1, -50}, {-1, -1, -50}};
  const std::vector<Point> outline = stage.outline_in_image(square);
  ASSERT_EQ(outline.size(), 4U);
  for (const Point& p : outline) EXPECT_LE(p[1], -1.0 / 50 + 1e-12) << "below the horizon, and no nearer than the far side";
}

TEST(LessonJson, NamesEveryStyle) {
  std::set<std::string_view> names;
  for (int look = 0; look <= static_cast<int>(Look::mask); ++look) {
    EXPECT_FALSE(name_of(static_cast<Look>(look)).empty());
    names.insert(name_of(static_cast<Look>(look)));
  }
  EXPECT_EQ(names.size(), 8U);
  // The player knows all of them.
  std::string player;
  for (const auto& [name, content] : player_files())
    if (name == "player.js") player = content;
  for (const std::string_view name : names) EXPECT_NE(player.find(std::string(name) + ": ["), std::string::npos) << name;
}

TEST(LessonJson, RoundsToFourDigitsAndKeepsSpecialValues) {
  Lesson lesson = small_lesson("a\\b\n\"c\"\u00e9");
  lesson.sheets[0].high = {1e9 + 0.5, 0.00005};
  const auto json = base::parse_json(json_of(lesson), "lesson");
  ASSERT_TRUE(json);
  EXPECT_EQ(*json->find("scene")->text(), "a\\b\n\"c\"\u00e9");
  EXPECT_EQ((*(*json->find("sheets"))[0].find("high"))[0].number(), 1e9 + 0.5);
  EXPECT_EQ((*(*json->find("sheets"))[0].find("high"))[1].number(), 0.0001);
}

TEST(CutOutline, KeepsTheRequestedSide) {
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(cut_outline(square, 1, 0, 1).size(), 4U);
  for (const Point& p : cut_outline(square, 1, 0, 1)) EXPECT_GE(p[0], 1);
  EXPECT_TRUE(cut_outline(square, 1, 0, 5).empty());
  EXPECT_EQ(cut_outline(square, 1, 1, 7).size(), 3U);
  EXPECT_EQ(cut_outline(square, 0, 0, -1), square);
}

}  // namespace
}  // namespace sightline::explain
