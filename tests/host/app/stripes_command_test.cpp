// `sightline stripes`: its files, its table and its JSON; scenes that do not fit.
#include <gtest/gtest.h>

#include <string>

#include "nlohmann/json.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class StripesCommand : public sightline::test::CommandLine {};

TEST_F(StripesCommand, WritesItsPictureAndItsTable) {
  const Ran ran = sightline({"stripes", "boxes-3", "-o", "p"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* text : {"boxes-3 in stripes on the 8080 at 3 MHz, EF9365 board", "faces            9 turned to the eye", "program ",
                           "priority         by the 8080: ", "drawing          0."})
    EXPECT_TRUE(has(ran.out, text)) << text << '\n' << ran.out;
  EXPECT_TRUE(exists("p/boxes-3-stripes.png"));
}

TEST_F(StripesCommand, DrawsLinesOnThePlotter) {
  const Ran ran = sightline({"stripes", "roberts", "--device", "calcomp", "--priority", "host", "--stripes", "host", "-o", "p"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* text : {"by the host, 0 cuts", "made by the host", "steps down"}) EXPECT_TRUE(has(ran.out, text)) << text << '\n' << ran.out;
  for (const char* file : {"p/roberts-stripes-calcomp.png", "p/roberts-stripes-calcomp.svg", "p/roberts-stripes-calcomp.hpgl"})
    EXPECT_TRUE(exists(file)) << file;
}

TEST_F(StripesCommand, WritesJson) {
  const Ran ran = sightline({"stripes", "roberts", "--stripes", "host", "--json", "-o", "p"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const json document = json::parse(ran.out);
  for (const char* field : {"faces", "program_bytes", "scene_bytes", "polygon_bytes", "stripe_bytes", "receiving_seconds", "priority_seconds",
                            "drawing_seconds", "plotter_seconds", "relations", "cuts", "dots"})
    EXPECT_TRUE(document.at(field).is_number()) << field;
  EXPECT_EQ(document.at("faces"), 10);
  EXPECT_EQ(document.at("stripes_by"), "host");
  EXPECT_EQ(document.at("priority_by"), "8080");
  EXPECT_EQ(document.at("plotter_seconds"), 0);
  EXPECT_LE(document.at("program_bytes").get<int>(), 4096);
  // Pairs of the 10 faces.
  int pairs = 0;
  for (const json& count : document.at("pairs_decided_by_test")) pairs += count.get<int>();
  EXPECT_EQ(pairs, 45);
}

TEST_F(StripesCommand, AntialiasesAndOverwrites) {
  for (const char* option : {"--antialias", "--overwrite"}) {
    const Ran ran = sightline({"stripes", "roberts", option, "--check", "--json", "-o", "p"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json document = json::parse(ran.out);
    EXPECT_EQ(document.at(std::string(option).substr(2)), true);
    EXPECT_LE(document.at("program_bytes").get<int>(), 4096);
    EXPECT_TRUE(exists("p/roberts-stripes-" + std::string(option).substr(2) + ".png"));
    const Ran plotter = sightline({"stripes", "roberts", option, "--device", "calcomp"});
    EXPECT_EQ(plotter.exit_code, 2);
    EXPECT_TRUE(has(plotter.err, std::string(option) + ": found with --device calcomp, expected the raster board")) << plotter.err;
  }
  const Ran host = sightline({"stripes", "roberts", "--antialias", "--stripes", "host"});
  EXPECT_EQ(host.exit_code, 2);
  EXPECT_TRUE(has(host.err, "--antialias: found with --stripes host")) << host.err;
  EXPECT_EQ(sightline({"stripes", "roberts", "--antialias", "--overwrite"}).exit_code, 2);
  const Ran colour = sightline({"stripes", "roberts", "--antialias", "--palette", "colour"});
  EXPECT_EQ(colour.exit_code, 2);
  EXPECT_TRUE(has(colour.err, "--antialias: found with --palette colour, expected grey")) << colour.err;
  EXPECT_TRUE(has(sightline({"stripes", "roberts", "--check", "-o", "p"}).err, "roberts: checked: equal")) << "the check says so";
}

TEST_F(StripesCommand, ReportsScenesThatDoNotFit) {
  const Ran ran = sightline({"stripes", "boxes-30"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "boxes-30: faces: 90 faces are turned to the eye, 26 too many, expected at most 64 for the 8080")) << ran.err;
}

}  // namespace
