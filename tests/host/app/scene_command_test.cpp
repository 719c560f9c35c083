// `sightline scene`: tape, check, info, list; errors in scenes name file, position and cause.
#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

class SceneCommand : public sightline::test::CommandLine {
 protected:
  static json house() {
    std::ifstream stream(SIGHTLINE_SOURCE_DIR "/host/scene/read/builtin/house.json");
    return json::parse(stream);
  }
};

TEST_F(SceneCommand, ListAndInfo) {
  const Ran list = sightline({"scene", "list"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(list.out, "house\nroberts\nstreet4\ncorridor8\ncorridor32\nsquares\ngrid\nobjects\nbars\ntori\nspring\n");
  EXPECT_EQ(json::parse(sightline({"scene", "list", "--json"}).out).at("scenes").size(), 11U);
  EXPECT_EQ(json::parse(sightline({"scene", "list", "--json"}).out).at("models").size(), 6U);
  const Ran info = sightline({"scene", "info", "house", "--json"});
  EXPECT_EQ(info.exit_code, 0);
  const json r = json::parse(info.out);
  EXPECT_EQ(r.at("schema"), "sightline/scene-info/1");
  EXPECT_EQ(r.at("cells"), house().at("cells").size());
  EXPECT_EQ(r.at("openings"), house().at("openings").size());
  EXPECT_EQ(r.at("default_view"), house().at("default_view"));
  EXPECT_TRUE(has(sightline({"scene", "info", "house"}).out, "of 8192"));
}

TEST_F(SceneCommand, TapeAssembles) {
  for (const char* name : {"house", "roberts", "street4", "corridor8", "corridor32"}) {
    ASSERT_EQ(sightline({"scene", "tape", name, "-o", "scene.s"}).exit_code, 0);
    EXPECT_EQ(read("scene.s"), sightline({"scene", "tape", name}).out);
    write("base.s", "10000/\n");
    const Ran ran = sightline({"asm", "pdp7", "base.s", "scene.s"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
  }
}

TEST_F(SceneCommand, TapeFromAFileAndAnotherPoint) {
  write("mine.json", house().dump());
  EXPECT_EQ(sightline({"scene", "tape", "mine.json"}).out, sightline({"scene", "tape", "house"}).out);
  const json view = house().at("default_view");
  const std::string at = view[0].dump() + "," + view[1].dump() + "," + view[2].dump();
  EXPECT_EQ(sightline({"scene", "tape", "house", "--at", at}).out, sightline({"scene", "tape", "house"}).out);
  const std::string beside =
      std::to_string(view[0].get<int>() + 1) + "," + view[1].dump() + "," + view[2].dump();
  EXPECT_NE(sightline({"scene", "tape", "house", "--at", beside}).out,
            sightline({"scene", "tape", "house"}).out);
}

TEST_F(SceneCommand, APointOutsideOrInsideASolid) {
  const Ran outside = sightline({"scene", "tape", "house", "--at", "-5,3,2", "-o", "out.s"});
  EXPECT_EQ(outside.exit_code, 4);
  EXPECT_TRUE(has(outside.err, "house")) << outside.err;
  EXPECT_TRUE(has(outside.err, "(-5, 3, 2)")) << outside.err;
  EXPECT_FALSE(exists("out.s"));
  for (const char* wrong : {"1,2", "1,2,3,4", "1,2,x", "", "1,2,40000"}) {
    EXPECT_EQ(sightline({"scene", "tape", "house", "--at", wrong}).exit_code, 2) << wrong;
  }
}

TEST_F(SceneCommand, CheckAcceptsTheBuiltInScenes) {
  for (const char* name : {"house", "roberts", "street4", "corridor8", "corridor32"}) {
    const Ran ran = sightline({"scene", "check", name});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_TRUE(has(ran.out, "a possible scene"));
  }
}

TEST_F(SceneCommand, OverlappingCells) {
  json scene = house();
  scene["cells"].push_back(scene["cells"][0]);
  scene["cell_lines"].push_back(json::array());
  write("overlap.json", scene.dump());
  const Ran check = sightline({"scene", "check", "overlap.json"});
  EXPECT_EQ(check.exit_code, 4);
  EXPECT_TRUE(has(check.err, "overlap.json: ")) << check.err;
  EXPECT_TRUE(has(check.err, "overlap")) << check.err;
  const json report = json::parse(sightline({"scene", "check", "--json", "overlap.json"}).out);
  EXPECT_EQ(report.at("possible"), false);
  EXPECT_FALSE(report.at("errors").empty());
  for (const char* command : {"tape", "info"})
    EXPECT_EQ(sightline({"scene", command, "overlap.json"}).exit_code, 4);
}

TEST_F(SceneCommand, AnOpeningThatIsNotShared) {
  json scene = house();
  scene["openings"].erase(scene["openings"].begin());
  write("unshared.json", scene.dump());
  const Ran gone = sightline({"scene", "check", "unshared.json"});
  EXPECT_EQ(gone.exit_code, 4);
  EXPECT_TRUE(has(gone.err, "unshared.json: cell ")) << gone.err;
  scene = house();
  auto& cells = scene["openings"][0]["cells"];
  std::swap(cells[0], cells[1]);
  write("swapped.json", scene.dump());
  const Ran swapped = sightline({"scene", "check", "swapped.json"});
  EXPECT_EQ(swapped.exit_code, 4);
  EXPECT_TRUE(has(swapped.err, "opening 0")) << swapped.err;
}

TEST_F(SceneCommand, FilesThatAreNotScenes) {
  write("cut.json", house().dump().substr(0, 200));
  write("list.json", "[]");
  write("empty.json", "");
  for (const char* file : {"cut.json", "list.json", "empty.json"}) {
    for (const char* command : {"tape", "check", "info"}) {
      const Ran ran = sightline({"scene", command, file});
      EXPECT_EQ(ran.exit_code, 4) << ran.err;
      EXPECT_TRUE(has(ran.err, file)) << ran.err;
    }
  }
  const Ran none = sightline({"scene", "info", "hause"});
  EXPECT_EQ(none.exit_code, 5);
  EXPECT_TRUE(has(none.err, "corridor8")) << none.err;
  EXPECT_EQ(sightline({"scene", "tape", "house", "-o", "no/where.s"}).exit_code, 5);
  EXPECT_EQ(sightline({"scene", "tape"}).exit_code, 2);
  EXPECT_EQ(sightline({"scene", "paint", "house"}).exit_code, 2);
}

}  // namespace
