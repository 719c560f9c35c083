// `sightline atlas`: the same bytes from any number of threads, its output, and usage errors.
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::Arguments;
using sightline::test::has;

class AtlasCommand : public sightline::test::CommandLine {
 protected:
  void expect_error(const Arguments& arguments, int code, std::string_view what) {
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, code) << ran.err;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(files(), std::vector<std::string>{});
  }
};

TEST_F(AtlasCommand, IsTheSameFromAnyNumberOfThreads) {
  const auto atlas = [this](const char* jobs) {
    const auto ran = sightline({"atlas", "house", "--lattice", "7,5", "--json", "--jobs", jobs});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.out + read("out/house-atlas.png");
  };
  const std::string one = atlas("1");
  EXPECT_TRUE(one.starts_with("{\n  \"schema\": \"sightline/atlas/1\"")) << one.substr(0, 100);
  EXPECT_EQ(atlas("2"), one);
  EXPECT_EQ(atlas("7"), one);
}

TEST_F(AtlasCommand, SaysWhatIsWrongAndHowToSeeIt) {
  const auto right = sightline({"atlas", "house", "--lattice", "1,1"});
  EXPECT_EQ(right.exit_code, 0) << right.err;
  EXPECT_TRUE(has(right.out, "eyes: a lattice of 1 x 1 at y = 160")) << right.out;
  EXPECT_TRUE(
      has(right.out, "eyes in free space 1, in a solid or at a wall 0; views wrong by more than a point 0\n"))
      << right.out;
  EXPECT_TRUE(has(right.out, "slowest view  sightline jones house --eye ")) << right.out;
  EXPECT_TRUE(has(right.out, "picture out/house-atlas.png")) << right.out;
  EXPECT_FALSE(has(right.out, "worst view")) << right.out;
  // A printed command can be pasted, for any file name of the scene.
  std::filesystem::create_directory(path("a b"));
  std::filesystem::copy_file(std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "host/scene/read/builtin/house.json", path("a b/house.json"));
  const auto named = sightline({"atlas", "a b/house.json", "--lattice", "1,1"});
  EXPECT_TRUE(has(named.out, "slowest view  sightline jones 'a b/house.json' --eye ")) << named.out << named.err;
  // View 25 is a wrong one.
  const auto wrong = sightline({"atlas", "street4", "--views", "26", "-o", "maps"});
  EXPECT_EQ(wrong.exit_code, 0) << wrong.err;
  EXPECT_TRUE(has(wrong.out, "sightline compare street4 --eye 138,194,1178\n")) << wrong.out;
  EXPECT_TRUE(has(wrong.out, "mask corner")) << wrong.out;
  EXPECT_TRUE(exists("maps/street4-atlas.png"));
}

TEST_F(AtlasCommand, EyesInSolidsAreLeftOutAndCounted) {
  // The first house on the left is x -500 to -200, z 400 to 700; some eyes of this lattice are in it.
  const auto ran = sightline({"atlas", "street4", "--lattice", "5,15", "--no-eae", "--fraction", "2"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_FALSE(has(ran.out, "in free space 75,")) << ran.out;
  EXPECT_FALSE(has(ran.out, "in a solid or at a wall 0;")) << ran.out;
  EXPECT_TRUE(has(ran.out, "--no-eae --fraction 2")) << ran.out;
}

TEST_F(AtlasCommand, WrongUsage) {
  expect_error({"atlas"}, 2, "SCENE");
  expect_error({"atlas", "street44"}, 5, "did you mean \"street4\"?");
  expect_error({"atlas", "nowhere.json"}, 5, "nowhere.json");
  expect_error({"atlas", "boxes-5"}, 2, "expected a scene of cells");
  expect_error({"atlas", "house", "--lattice", "5"}, 2, "--lattice: found \"5\", expected NX,NZ");
  expect_error({"atlas", "house", "--lattice", "0,5"}, 2, "--lattice: found \"0,5\"");
  expect_error({"atlas", "house", "--lattice", "1001,5"}, 2, "from 1 to 1000");
  expect_error({"atlas", "house", "--height", "40000"}, 2, "--height");
  expect_error({"atlas", "house", "--views", "0"}, 2, "--views");
  expect_error({"atlas", "house", "--views", "5", "--lattice", "5,5"}, 2, "--lattice");
  expect_error({"atlas", "house", "--views", "5", "--height", "5"}, 2, "--height");
  expect_error({"atlas", "house", "--seed", "5"}, 2, "--views");
  expect_error({"atlas", "house", "--fraction", "4"}, 2, "--fraction");
  expect_error({"atlas", "house", "--height", "30000"}, 4, "house: found no eye in free space");
}

TEST_F(AtlasCommand, DamagedScenes) {
  write("s.json", R"({"name": "s", "outer": [[0,0,0],[9,9,9]], "cells": 3})");
  const auto ran = sightline({"atlas", "s.json", "-o", "to"});
  EXPECT_EQ(ran.exit_code, 4) << ran.err;
  EXPECT_TRUE(has(ran.err, "s.json: ")) << ran.err;
  EXPECT_FALSE(exists("to"));
}

TEST_F(AtlasCommand, AFolderThatCannotBeWritten) {
  write("file", "");
  const auto ran = sightline({"atlas", "house", "--lattice", "2,2", "-o", "file"});
  EXPECT_EQ(ran.exit_code, 5) << ran.err;
  EXPECT_EQ(ran.out, "");
}

TEST_F(AtlasCommand, AnInterruptedRunLeavesNoFiles) {
  const auto ran =
      sightline({"atlas", "corridor32", "--views", "100000"}, "", std::chrono::milliseconds(1500));
  EXPECT_EQ(ran.exit_code, 130) << ran.err;
  EXPECT_TRUE(has(ran.err, "no picture is written")) << ran.err;
  EXPECT_FALSE(exists("out/corridor32-atlas.png"));
}

}  // namespace
