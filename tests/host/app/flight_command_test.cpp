// `sightline flight`: its files, its table and its JSON; models that do not fit.
#include <gtest/gtest.h>

#include <string>

#include "nlohmann/json.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class FlightCommand : public sightline::test::CommandLine {};

TEST_F(FlightCommand, WritesItsPicturesAndItsTable) {
  const Ran ran = sightline({"flight", "town-5", "--frames", "6", "-o", "p"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* text : {"pieces           43, of 30 surfaces", "frames/s shown          25.00       25.00", "wrong orders", "wrong pixels     0, in 0 of 6"})
    EXPECT_TRUE(has(ran.out, text)) << text << '\n' << ran.out;
  for (const char* file : {"p/town-5-flight.apng", "p/town-5-flight.png", "p/town-5-flight.csv"}) EXPECT_TRUE(exists(file)) << file;
}

TEST_F(FlightCommand, WritesJson) {
  for (const char* bits : {"8", "12", "16"}) {
    const Ran ran = sightline({"flight", "prisms-5", "--plan", "--bits", bits, "--pieces", "20", "--frames", "5", "--json", "-o", "p"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json document = json::parse(ran.out);
    for (const char* field : {"frames_per_second_mean", "frames_per_second_worst", "computed_per_second_mean", "t_states_mean", "wrong_orders", "pairs",
                              "distance_error"})
      EXPECT_TRUE(document.at(field).is_number()) << field;
    EXPECT_EQ(document.at("pieces"), 20);
    EXPECT_EQ(document.at("bits"), std::stoi(bits));
    EXPECT_EQ(document.at("wrong_points"), 0);
  }
}

TEST_F(FlightCommand, TestsWhichPiecesFaceTheCamera) {
  const Ran ran = sightline({"flight", "town-5", "--facing", "--check", "--frames", "6", "-o", "p"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* text : {"facing test      3 directions", "facing pieces hidden: 0", "pieces with a key", "pieces turned", "wrong pixels     0, in 0 of 6"})
    EXPECT_TRUE(has(ran.out, text)) << text << '\n' << ran.out;
  EXPECT_TRUE(has(read("p/town-5-flight.csv"), "wrong_points,pieces_with_key,pieces_appeared,pieces_vanished\n")) << read("p/town-5-flight.csv");
  const Ran plain = sightline({"flight", "town-5", "--frames", "6", "--json", "-o", "q"});
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  EXPECT_FALSE(json::parse(plain.out).contains("facing_test"));
  // The pictures are the same.
  EXPECT_EQ(read("p/town-5-flight.png"), read("q/town-5-flight.png"));
  for (const char* bits : {"8", "12", "16"}) {
    const Ran json_run = sightline({"flight", "prisms-5", "--plan", "--facing", "--bits", bits, "--frames", "5", "--json", "-o", "p"});
    ASSERT_EQ(json_run.exit_code, 0) << json_run.err;
    const json document = json::parse(json_run.out);
    const json& test = document.at("facing_test");
    EXPECT_EQ(test.at("hidden_facing_pieces"), 0);
    EXPECT_GT(test.at("directions"), 0);
    EXPECT_GT(test.at("facing_error"), 0);
    EXPECT_LT(test.at("pieces_with_key_most"), document.at("pieces"));
    EXPECT_GE(test.at("pieces_with_key_most"), test.at("pieces_with_key_mean"));
    EXPECT_GE(test.at("pieces_turned_most"), test.at("pieces_turned_mean"));
  }
}

TEST_F(FlightCommand, ReportsTheExcessPiecesOfAModelAndSeparatesTouchingSolids) {
  const Ran ran = sightline({"flight", "town-60", "-o", "p"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "town-60: 719 pieces, 464 more than the machine holds; body")) << ran.err;
  EXPECT_TRUE(has(ran.err, "--pieces")) << ran.err;
  const Ran facing = sightline({"flight", "town-60", "--facing", "-o", "p"});
  EXPECT_EQ(facing.exit_code, 4);
  EXPECT_TRUE(has(facing.err, "town-60: 719 pieces, turned to 3 directions and their opposites, 468 more than the machine holds")) << facing.err;
  // Touching solids are separated by planes.
  const Ran cells = sightline({"flight", "touch-2", "--json", "-o", "p"});
  ASSERT_EQ(cells.exit_code, 0) << cells.err;
  EXPECT_GT(json::parse(cells.out).at("planes"), 0);
  EXPECT_EQ(json::parse(cells.out).at("wrong_points"), 0);
  const Ran plan = sightline({"flight", "boxes-5", "--plan", "-o", "p"});
  EXPECT_EQ(plan.exit_code, 4);
  EXPECT_TRUE(has(plan.err, "between the feet and the tops")) << plan.err;
}

}  // namespace
