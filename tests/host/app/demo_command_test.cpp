// `sightline demo`: both machines on everything they come with, as a table and as JSON. Each run takes seconds.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class DemoCommand : public sightline::test::CommandLine {};

TEST_F(DemoCommand, PrintsTheTablesAndWritesThePictures) {
  const Ran ran = sightline({"demo", "-o", "pictures"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  std::istringstream lines(ran.out);
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    for (const char* scene : {"house ", "roberts ", "street4 ", "corridor8 ", "corridor32 "})
      rows += line.starts_with(scene);
  }
  EXPECT_EQ(rows, 10 + 2 + 3 + 5) << "computed with and without the EAE, turned, in stripes, and compared\n" << ran.out;
  EXPECT_FALSE(has(ran.out, "DIFFERS")) << ran.out;
  for (const char* text : {"Jones 1971 on the PDP-7", "a few seconds", "Skala 1985 on the 8080", "about 2 s",
                           "about 15 %", "CalComp 565", "A solid turning on the PDP-7", "scenes in stripes"})
    EXPECT_TRUE(has(ran.out, text)) << text << '\n' << ran.out;
  // What the line on the paper's 15 % says of two functions is what their rows say: T-states added to a point, of those
  // of the point.
  struct {
    double added = 0, point = 0;
    char function[32] = "";
  } least, most;
  const std::string line = ran.out.substr(std::min(ran.out.find("Why not"), ran.out.size()));
  ASSERT_EQ(std::sscanf(line.c_str(),
                        "Why not 15 %%: the test adds %lf T-states to the %lf of a point of %31s (%*f %% are hidden, not drawn), "
                        "%lf to the %lf of %31s",
                        &least.added, &least.point, least.function, &most.added, &most.point, most.function),
            6)
      << ran.out;
  for (const auto& said : {least, most}) {
    double percent = 0;
    const std::size_t row = ran.out.find(std::string("\n") + said.function);
    ASSERT_NE(row, std::string::npos) << said.function;
    ASSERT_EQ(std::sscanf(ran.out.c_str() + row, " %*s %*f %lf %%", &percent), 1) << ran.out;
    EXPECT_NEAR(said.added / said.point, percent / 100, 0.015) << said.function;
  }
  for (const char* name : {"sinc", "rogers", "peaks", "franke", "saddle", "cosr", "step", "rosen"}) {
    EXPECT_TRUE(has(ran.out, std::string("\n") + name));
    for (const char* picture : {"-lines.png", "-surface.png", "-contours.png"})
      EXPECT_TRUE(exists("pictures/" + std::string(name) + picture));
  }
  EXPECT_TRUE(exists("pictures/rogers-calcomp.hpgl"));
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path("pictures"))) {
    ++pictures;
    EXPECT_GT(entry.file_size(), 1000U) << entry.path();
  }
  // Five scenes in three ways; eight functions in three ways and one plot in three; three scenes in stripes.
  EXPECT_EQ(pictures, 5 * 3 + 8 * 3 + 3 + 3);
}

TEST_F(DemoCommand, AsJsonInAFolderOfAnyName) {
  const Ran ran = sightline({"demo", "--json", "-o", "f\xFF"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const json document = json::parse(ran.out);
  EXPECT_EQ(document.at("pictures"), "f\xEF\xBF\xBD");
  ASSERT_EQ(document.at("views").size(), 10U);
  for (const json& view : document.at("views")) {
    EXPECT_EQ(view.at("status"), "complete");
    EXPECT_LE(view.at("core_words_used").get<int>(), 8192);
  }
  ASSERT_EQ(document.at("turns").size(), 4U);
  ASSERT_EQ(document.at("flights").size(), 4U);
  for (const json& flight : document.at("flights")) EXPECT_GE(flight.at("frames_per_second_mean").get<double>(), flight.at("bits") == 8 ? 23 : 12);
  for (const json& turn : document.at("turns")) EXPECT_GT(turn.at("frames_per_second_worst").get<double>(), 15);
  ASSERT_EQ(document.at("skala").size(), 8U);
  for (const json& row : document.at("skala"))
    EXPECT_GT(row.at("lines").at("t_states").get<std::int64_t>(), 0);
  ASSERT_EQ(document.at("stripes").size(), 4U);
  for (const json& row : document.at("stripes")) EXPECT_GT(row.at("drawing_seconds").get<double>(), 0.1);
  EXPECT_GT(document.at("skala_plot").at("seconds").get<double>(), 10.0);
  EXPECT_EQ(document.at("compared").at("agrees"), true);
  EXPECT_EQ(document.at("compared").at("scenes").size(), 5U + 8U);
}

}  // namespace
