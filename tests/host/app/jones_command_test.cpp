// `sightline jones`: views, pictures, figures, and errors.
#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"
#include "tests/support/effort.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

class JonesCommand : public sightline::test::CommandLine {
 protected:
  static json scene_of(const std::string& name) {
    std::ifstream stream(SIGHTLINE_SOURCE_DIR "/host/scene/read/builtin/" + name + ".json");
    return json::parse(stream);
  }
  json report(Arguments arguments) {
    arguments.insert(arguments.begin(), "jones");
    arguments.push_back("--json");
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.exit_code == 0 ? json::parse(ran.out) : json{};
  }
  [[nodiscard]] bool is_png(const std::string& name) const {
    return read(name).starts_with("\x89PNG\r\n\x1a\n");
  }
};

TEST_F(JonesCommand, WritesPicturesAndReportsTheCost) {
  const Ran ran = sightline({"jones", "house", "-o", "pictures"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* line :
       {"view 1", "view 2", "status           complete", "instructions", "cells read       3 of 3, 4 visits",
        "openings tested", "lines clipped", "segments", "display words", "of 8192 words", "refresh"}) {
    EXPECT_TRUE(has(ran.out, line)) << line << '\n' << ran.out;
  }
  EXPECT_TRUE(is_png("pictures/house.png"));
  EXPECT_TRUE(is_png("pictures/house-phosphor.png"));
  EXPECT_TRUE(has(read("pictures/house.svg"), "<svg"));
}

TEST_F(JonesCommand, FilmsLinesThatAreAddedAtOnce) {
  const Ran ran = sightline({"jones", "house", "--immediate", "-o", "pictures"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "pictures/house.apng")) << ran.out;
  EXPECT_TRUE(is_png("pictures/house.apng"));
  // The number of frames is in the chunk acTL. A view of less than two seconds has 50.
  const std::string movie = read("pictures/house.apng");
  const std::size_t chunk = movie.find("acTL");
  ASSERT_NE(chunk, std::string::npos);
  const auto frames = static_cast<unsigned char>(movie[chunk + 7]);
  EXPECT_EQ(frames, 50);
  ASSERT_EQ(sightline({"jones", "house", "-o", "others"}).exit_code, 0);
  EXPECT_FALSE(exists("others/house.apng"));
}

TEST_F(JonesCommand, JsonFields) {
  const json r = report({"roberts"});
  EXPECT_EQ(r.at("schema"), "sightline/jones/1");
  EXPECT_EQ(r.at("scene"), "roberts");
  EXPECT_EQ(r.at("eae"), true);
  EXPECT_EQ(r.at("eye"), scene_of("roberts").at("default_view"));
  EXPECT_EQ(r.at("cells"), scene_of("roberts").at("cells").size());
  EXPECT_LE(r.at("core_words_used").get<int>(), 8192);
  const double rate = r.at("refreshes_per_second").get<double>();
  EXPECT_GT(rate, 1.0);
  EXPECT_EQ(r.at("flicker").get<bool>(), rate < 30.0);
  ASSERT_EQ(r.at("views").size(), 2U);
  for (const json& view : r.at("views")) {
    EXPECT_EQ(view.at("status"), "complete");
    for (const char* field : {"emulated_ns", "instructions", "cells_read", "visits", "openings_tested",
                              "lines_clipped", "segments", "display_words"}) {
      EXPECT_GT(view.at(field).get<std::int64_t>(), 0) << field;
    }
  }
  EXPECT_EQ(r.at("views")[0].at("segments"), r.at("views")[1].at("segments"));
  ASSERT_EQ(r.at("pictures").size(), 3U);
  for (const json& picture : r.at("pictures")) EXPECT_TRUE(exists(picture.get<std::string>()));
}

TEST_F(JonesCommand, TheSameBytesEveryTime) {
  NEEDS_OPTIMISED_CODE();
  const Ran first = sightline({"jones", "house", "--json", "-o", "out"});
  const std::string picture = read("out/house-phosphor.png");
  EXPECT_EQ(sightline({"jones", "house", "--json", "-o", "out"}).out, first.out);
  EXPECT_EQ(read("out/house-phosphor.png"), picture);
}

TEST_F(JonesCommand, WithoutTheEaeTheSamePictureTakesLonger) {
  NEEDS_OPTIMISED_CODE();
  const json with = report({"house", "--eae", "-o", "with"});
  const json without = report({"house", "--no-eae", "-o", "without"});
  EXPECT_EQ(without.at("eae"), false);
  EXPECT_GT(without.at("views")[1].at("emulated_ns").get<std::int64_t>(),
            with.at("views")[1].at("emulated_ns").get<std::int64_t>());
  EXPECT_EQ(without.at("views")[1].at("display_words"), with.at("views")[1].at("display_words"));
}

TEST_F(JonesCommand, AnotherPlaceScaleAndMode) {
  NEEDS_OPTIMISED_CODE();
  const json scene = scene_of("corridor8");
  const json& box = scene.at("cells").at(1);
  const json& low = box.contains("box") ? box.at("box").at(0) : box.at(0);
  const std::string at = std::to_string(low[0].get<int>() + 100) + "," +
                         std::to_string(low[1].get<int>() + 100) + "," +
                         std::to_string(low[2].get<int>() + 100);
  const json there = report({"corridor8", "--at", at});
  EXPECT_EQ(there.at("eye")[2], low[2].get<int>() + 100);
  const json wide = report({"corridor8", "--scale", "256"}), near = report({"corridor8", "--scale", "2048"});
  EXPECT_NE(wide.at("views")[1], near.at("views")[1]);
  const json mono = report({"house"}), pair = report({"house", "--stereo"}),
             at_once = report({"house", "--immediate"});
  EXPECT_GT(pair.at("views")[1].at("visits"), mono.at("views")[1].at("visits"));
  EXPECT_EQ(at_once.at("views")[1].at("segments"), mono.at("views")[1].at("segments"));
  EXPECT_EQ(report({"house", "--views", "4"}).at("views").size(), 4U);
}

TEST_F(JonesCommand, ASwitchScriptMovesTheEye) {
  NEEDS_OPTIMISED_CODE();
  write("right.txt", "0 200000\n");
  const json still = report({"corridor8", "--views", "6"});
  const json moved = report({"corridor8", "--views", "6", "--switches", "right.txt"});
  EXPECT_EQ(still.at("views")[0].at("display_words"), moved.at("views")[0].at("display_words"));
  EXPECT_NE(still.at("views")[5].at("emulated_ns"), moved.at("views")[5].at("emulated_ns"));
  write("wrong.txt", "0 200000\nsoon 1\n");
  const Ran wrong = sightline({"jones", "house", "--switches", "wrong.txt", "-o", "none"});
  EXPECT_EQ(wrong.exit_code, 4);
  EXPECT_TRUE(has(wrong.err, "wrong.txt:2")) << wrong.err;
  EXPECT_FALSE(exists("none"));
}

TEST_F(JonesCommand, AWalkFromCellToCell) {
  const Ran ran = sightline({"jones", "house", "--walk", "left 100 in 380, up 9999, in 1", "--check"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "eye 480,160,20 in cell 0\n")) << ran.out;
  EXPECT_TRUE(has(ran.out, "eye 380,160,401 in cell 2\n")) << ran.out;  // through the door
  EXPECT_TRUE(has(ran.out, "eye 380,249,401 in cell 2, stopped by a wall along y\n")) << ran.out;
  EXPECT_TRUE(has(ran.out, "eye 380,249,402 in cell 2\n")) << ran.out;
  EXPECT_TRUE(is_png("out/house.png"));
  const json walk = report({"house", "--no-eae", "--walk", "in 9999 right 9999"});
  EXPECT_EQ(walk.at("walk"), true);
  ASSERT_EQ(walk.at("views").size(), 2U);
  EXPECT_EQ(walk.at("views")[0].at("stopped"), json::array());
  EXPECT_EQ(walk.at("views")[1].at("stopped"), json({"x", "z"}));
  EXPECT_EQ(walk.at("views")[1].at("eye"), json({599, 160, 399}));
  EXPECT_EQ(walk.at("views")[1].at("cell"), 0);
  const json still = report({"house", "--at", "599,160,399"});
  EXPECT_EQ(still.at("walk"), false);
  EXPECT_FALSE(still.at("views")[1].contains("cell"));
  EXPECT_EQ(still.at("views")[1].at("display_words"), walk.at("views")[1].at("display_words"));
}

TEST_F(JonesCommand, AViewThatTurns) {
  const Ran ran = sightline({"jones", "house", "--turn", "-90", "--walk", "in 100, turn-right 90 in 50", "--check"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "eye 480,160,20 in cell 0, 270 degrees\n")) << ran.out;
  EXPECT_TRUE(has(ran.out, "eye 380,160,20 in cell 0, 270 degrees\n")) << ran.out;
  EXPECT_TRUE(has(ran.out, "eye 380,160,70 in cell 0, 0 degrees\n")) << ran.out;
  const json turned = report({"house", "--no-eae", "--turn", "45", "--stereo"});
  EXPECT_EQ(turned.at("rotation"), true);
  EXPECT_EQ(turned.at("views")[1].at("angle"), 45);
  EXPECT_EQ(report({"house"}).at("rotation"), false);
  for (const char* degrees : {"361", "1.5", "x", ""}) {
    const Ran wrong = sightline({"jones", "house", "--turn", degrees});
    EXPECT_EQ(wrong.exit_code, 2) << degrees;
    EXPECT_TRUE(has(wrong.err, "--turn")) << wrong.err;
  }
  const Ran large = sightline({"jones", "street4", "--turn", "10"});
  EXPECT_EQ(large.exit_code, 4);
  EXPECT_TRUE(has(large.err, "115 words too many")) << large.err;
}

TEST_F(JonesCommand, AWalkByTheSwitches) {
  NEEDS_OPTIMISED_CODE();
  write("in.txt", "0 20000\n");
  const json walk = report({"corridor8", "--walk", "switches", "--switches", "in.txt", "--views", "60"});
  EXPECT_GE(walk.at("views")[59].at("cell").get<int>(), 0);
  EXPECT_GT(walk.at("views")[59].at("eye")[2].get<int>(), walk.at("views")[0].at("eye")[2].get<int>());
}

TEST_F(JonesCommand, WrongWalks) {
  for (const Arguments& wrong : {Arguments{"house", "--walk", "north 5"}, Arguments{"house", "--walk", "in 5,"}, Arguments{"house", "--walk", "in 5 out 5"},
                                 Arguments{"house", "--walk", ""}, Arguments{"house", "--walk", "in 5", "--views", "3"}, Arguments{"house", "--walk", "in 5", "--switches", "x"}}) {
    Arguments arguments{"jones"};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << wrong[2] << ran.err;
    EXPECT_TRUE(has(ran.err, "--walk")) << ran.err;
    EXPECT_FALSE(exists("out"));
  }
  const Ran on_a_plane = sightline({"jones", "house", "--walk", "in 5", "--at", "250,120,620"});
  EXPECT_EQ(on_a_plane.exit_code, 4);
  EXPECT_TRUE(has(on_a_plane.err, "too close to the faces of cell")) << on_a_plane.err;
}

TEST_F(JonesCommand, TheCheckAddsOnlyAMessage) {
  const Ran plain = sightline({"jones", "house", "--scale", "700", "--json"});
  const Ran checked = sightline({"jones", "house", "--scale", "700", "--json", "--check"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_EQ(checked.out, plain.out);
  EXPECT_TRUE(has(checked.err, "checked: equal to the same program in C++")) << checked.err;
  EXPECT_FALSE(has(plain.err, "checked")) << plain.err;
  // A person at the switches moves the eye; the twin does not follow.
  write("right.txt", "0 200000\n");
  EXPECT_EQ(sightline({"jones", "house", "--switches", "right.txt", "--check"}).exit_code, 2);
}

TEST_F(JonesCommand, AnEyeInASolidOrOutsideIsAnError) {
  const json solid = scene_of("roberts").at("solids").at(0);
  std::string inside;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    inside +=
        (axis == 0 ? "" : ",") + std::to_string((solid[0][axis].get<int>() + solid[1][axis].get<int>()) / 2);
  }
  for (const std::string& at : {inside, std::string("16000,16000,16000")}) {
    const Ran ran = sightline({"jones", "roberts", "--at", at});
    EXPECT_EQ(ran.exit_code, 4) << at;
    EXPECT_TRUE(has(ran.err, "roberts")) << ran.err;
    EXPECT_TRUE(ran.out.empty());
    EXPECT_FALSE(exists("out"));
  }
}

TEST_F(JonesCommand, WrongArguments) {
  for (const Arguments& wrong :
       {Arguments{"house", "--scale", "63"}, Arguments{"house", "--scale", "4097"},
        Arguments{"house", "--scale", "big"}, Arguments{"house", "--at", "1,2"},
        Arguments{"house", "--views", "0"}, Arguments{"house", "--nonsense"}, Arguments{}}) {
    Arguments arguments{"jones"};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << (wrong.empty() ? "" : wrong.back());
    EXPECT_FALSE(ran.err.empty());
    EXPECT_FALSE(exists("out"));
  }
}

TEST_F(JonesCommand, AFolderThatCannotBeMade) {
  write("file", "");
  const Ran ran = sightline({"jones", "house", "-o", "file/pictures"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_TRUE(has(ran.err, "file/pictures")) << ran.err;
}

// Input that `draw jones` takes and the old program does not: the error names `draw jones`.
TEST_F(JonesCommand, ScenesWithoutCells) {
  write("tent.off", "OFF\n4 4 0\n0 0 0\n9 1 0\n4 9 1\n3 2 9\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  ASSERT_EQ(sightline({"scene", "convert", "tent.off", "-o", "tent.json"}).exit_code, 0);
  ASSERT_EQ(sightline({"scene", "decompose", "tent.off", "-o", "tent.cells.json"}).exit_code, 0);
  for (const char* scene : {"tent.off", "tent.json", "tent.cells.json", "rooms-3"}) {
    for (const Arguments& arguments : {Arguments{"jones", scene}, Arguments{"scene", "tape", scene}}) {
      const Ran ran = sightline(arguments);
      EXPECT_EQ(ran.exit_code, scene == std::string("rooms-3") ? 2 : 4) << ran.err;
      EXPECT_TRUE(has(ran.err, std::string(scene) + ": found ")) << ran.err;
      EXPECT_TRUE(has(ran.err, "`sightline draw jones` takes all scenes")) << ran.err;
      EXPECT_EQ(ran.out, "");
    }
  }
}

TEST_F(JonesCommand, ScenesThatAreNoScenes) {
  json scene = scene_of("house");
  scene["cells"].push_back(scene["cells"][0]);
  scene["cell_lines"].push_back(json::array());
  write("overlap.json", scene.dump());
  const Ran overlap = sightline({"jones", "overlap.json"});
  EXPECT_EQ(overlap.exit_code, 4);
  EXPECT_TRUE(has(overlap.err, "overlap.json")) << overlap.err;
  write("half.json", scene_of("house").dump().substr(0, 400));
  EXPECT_EQ(sightline({"jones", "half.json"}).exit_code, 4);
  const Ran missing = sightline({"jones", "missing.json"});
  EXPECT_NE(missing.exit_code, 0);
  EXPECT_TRUE(has(missing.err, "missing.json")) << missing.err;
  EXPECT_FALSE(exists("out"));
}

}  // namespace
