// `sightline turn`: its files, its table and its JSON; models that do not fit; the tape of `spin --tape`.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "nlohmann/json.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class TurnCommand : public sightline::test::CommandLine {};

const std::string models = std::string(SIGHTLINE_SOURCE_DIR) + "/host/examples/turn/";

TEST_F(TurnCommand, WritesItsPicturesAndItsTable) {
  const Ran ran = sightline({"turn", models + "cube.off", "--frames", "6", "-o", "p"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* text : {"edges            12, 8 vertices", "words of core", "hidden lines", "wire frame", "time of a picture 0.", " of that of a wire frame", "measured         the first 6 of the "})
    EXPECT_TRUE(has(ran.out, text)) << text << '\n' << ran.out;
  for (const char* file : {"p/cube-turn.apng", "p/cube-turn-phosphor.png", "p/cube-turn.strokes"}) EXPECT_TRUE(exists(file)) << file;
}

// When tilted, coordinates are 13 times as large and must stay below 2^18 steps, here of 0.1: 2016.49 units of the file.
TEST_F(TurnCommand, AModelThatIsTooLargeToBeTilted) {
  write("large.off",
        "OFF\n8 6 0\n0 0 0\n5000.1 0 0\n5000.1 9 0\n0 9 0\n0 0 9\n5000.1 0 9\n5000.1 9 9\n0 9 9\n"
        "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  const Ran ran = sightline({"turn", "large.off", "-o", "p"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "vertex 0,0,0 is 2500 from the middle of the model along x, tilted, expected less than 2016.49")) << ran.err;
}

TEST_F(TurnCommand, WritesJson) {
  const Ran ran = sightline({"turn", models + "block.off", "--no-eae", "--frames", "6", "--json", "-o", "p"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const json document = json::parse(ran.out);
  for (const char* field :
       {"edges", "events", "core_words", "frames_per_second_mean", "frames_per_second_worst", "wire_frames_per_second_mean",
        "cost_against_wire_frame", "t_junctions_mean", "waiting_fraction", "refreshes_per_second"})
    EXPECT_TRUE(document.at(field).is_number()) << field;
  EXPECT_EQ(document.at("edges"), 24);
  EXPECT_EQ(document.at("eae"), false);
  EXPECT_LE(document.at("core_words").get<int>(), 8192);
}

TEST_F(TurnCommand, TheCheckAddsOnlyAMessage) {
  const Ran plain = sightline({"turn", models + "cube.off", "--frames", "20", "-o", "p"});
  const Ran checked = sightline({"turn", models + "cube.off", "--frames", "20", "-o", "p", "--check"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_EQ(checked.out, plain.out);
  EXPECT_TRUE(has(checked.err, "checked: equal to the same program in C++")) << checked.err;
  EXPECT_FALSE(has(plain.err, "checked")) << plain.err;
}

TEST_F(TurnCommand, ReportsTheExcessWordsOfAModel) {
  const Ran ran = sightline({"turn", "grid", "--level"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "words too many for 8K of core beside the program")) << ran.err;
  EXPECT_TRUE(has(ran.err, "--memory 32k")) << ran.err;
}

TEST_F(TurnCommand, SpinPunchesTheTape) {
  const Ran ran = sightline({"spin", models + "cube.off", "--step", "90", "--tape", "cube.tape", "-o", "cube.apng"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(exists("cube.tape"));
  const Ran large = sightline({"spin", models + "cube.off", "--step", "90", "--tape", "t", "--memory", "12k", "-o", "c.apng"});
  EXPECT_NE(large.exit_code, 0);
}

}  // namespace
