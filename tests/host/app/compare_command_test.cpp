// `sightline compare`: tables, JSON, overlays, exit codes, and what a user gets wrong.
#include <nlohmann/json.hpp>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::has;

class CompareCommand : public sightline::test::CommandLine {};

TEST_F(CompareCommand, ComparesASceneOfCells) {
  const auto ran = sightline({"compare", "house", "-o", "pictures"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part : {"house from ", "  guest ", "  twin ", "  exact ", "equal to the oracle's",
                           "guest and twin: identical, ", "overlay pictures/house-compare-guest.png, .svg"})
    EXPECT_TRUE(has(ran.out, part)) << part << '\n' << ran.out;
  for (const char* file : {"pictures/house-compare-guest.png", "pictures/house-compare-twin.svg",
                           "pictures/house-compare-exact.png"})
    EXPECT_TRUE(exists(file)) << file;
  const auto png = sightline::picture::read_png(path("pictures/house-compare-guest.png").string());
  ASSERT_TRUE(png);
  EXPECT_EQ(png->image.width, 1027);
}

TEST_F(CompareCommand, ComparesAFunctionAndPolyhedraAsJson) {
  const auto ran = sightline({"compare", "sinc", "bricks-10", "--json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto document = nlohmann::json::parse(ran.out);
  EXPECT_EQ(document["schema"], "sightline/compare/1");
  EXPECT_EQ(document["agrees"], true);
  ASSERT_EQ(document["scenes"].size(), 2U);
  EXPECT_EQ(document["scenes"][0]["function"], "sinc");
  EXPECT_EQ(document["scenes"][0]["pictures"][1]["different_inside"], 0);
  EXPECT_EQ(document["scenes"][0]["guest"]["identical_to_twin"], true);
  EXPECT_EQ(document["scenes"][1]["pictures"][0]["name"], "exact");
  EXPECT_EQ(document["scenes"][1]["pictures"][0]["equal_to_oracle"], true);
  EXPECT_EQ(document["scenes"][1]["pictures"][0]["pieces_different"], 0);
  EXPECT_TRUE(exists("out/sinc-compare-native.png"));
  EXPECT_TRUE(exists("out/bricks-10-compare-exact.svg"));
  EXPECT_EQ(sightline({"compare", "sinc", "bricks-10", "--json"}).out, ran.out);
}

TEST_F(CompareCommand, NamesWhatIsWrong) {
  struct Case {
    sightline::test::Arguments arguments;
    int exit_code;
    const char* what;
  };
  write("square.csv", "1,2\n3,nan\n");
  write("bad.off", "OFF\n1\n");
  const std::vector<Case> cases{
      {{"compare", "nowhere"}, 5, "nowhere"},
      {{"compare", "house", "--view", "1,2"}, 2, "--view"},
      {{"compare", "house", "--view", "32000,0,0"}, 4, "house"},
      {{"compare", "house", "--scale", "9"}, 2, "--scale"},
      {{"compare", "sinc", "--view", "1,2,3"}, 2, "--view: found with sinc"},
      {{"compare", "bricks-5", "--scale", "512"}, 2, "--scale: found with bricks-5"},
      {{"compare", "square.csv"}, 4, "undefined heights"},
      {{"compare", "bad.off"}, 4, "bad.off"},
      {{"compare", "house", "-o", "square.csv/x"}, 5, "square.csv/x"},
  };
  for (const Case& c : cases) {
    const auto ran = sightline(c.arguments);
    EXPECT_EQ(ran.exit_code, c.exit_code) << c.what << '\n' << ran.err;
    EXPECT_TRUE(has(ran.err, c.what)) << ran.err;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"bad.off", "square.csv"}));
}

TEST_F(CompareCommand, ExplainsItself) {
  const auto ran = sightline({"compare", "--help"});
  EXPECT_EQ(ran.exit_code, 0);
  for (const char* part : {"Examples:", "missing, extra", "orange what is missing", "--rotate", "Exit codes"})
    EXPECT_TRUE(has(ran.out, part)) << part;
}

}  // namespace
