// `sightline draw willis`: pictures, plans, flights, inseparable faces, and usage errors.
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;

// Two sheets that touch along an edge, one turned out of the other's plane; a third sheet far behind them.
constexpr std::string_view walls = R"({"vertices":
  [[0,-10,0],[0,10,0],[10,10,0],[10,-10,0],[20,10,5],[20,-10,5],[-90,-10,90],[-90,10,90],[90,10,90],[90,-10,90]],
  "bodies": [{"sheet": true, "faces": [[0,1,2,3]]}, {"sheet": true, "faces": [[3,2,4,5]]},
             {"sheet": true, "faces": [[6,7,8,9]]}],
  "camera": {"eye": [12,0,-9], "forward": [0,0,1], "right": [1,0,0], "up": [0,1,0]}})";

class WillisCommand : public sightline::test::CommandLine {
 protected:
  sightline::test::Ran draw(const std::string& scene, const std::string& output, const Arguments& more = {}) {
    Arguments all{"draw", "willis", scene, "-o", output};
    all.insert(all.end(), more.begin(), more.end());
    return sightline(all);
  }
  json summary(const std::string& scene, const std::string& output, Arguments more = {}) {
    more.emplace_back("--json");
    const auto ran = draw(scene, output, more);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.exit_code == 0 ? json::parse(ran.out) : json();
  }
  // The number of different colours.
  std::set<std::uint32_t> colours(const std::string& file) {
    const auto png = sightline::picture::read_png(path(file).string());
    std::set<std::uint32_t> found;
    if (!png) return found;
    const auto& image = png->image;
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i + channels <= image.pixels.size(); i += channels) {
      std::uint32_t colour = 0;
      for (std::size_t c = 0; c < channels; ++c) colour = colour << 8 | image.pixels[i + c];
      found.insert(colour);
    }
    return found;
  }
  void expect_refused(int exit_code, const std::string& scene, const std::string& output,
                      const Arguments& more, std::string_view what) {
    const auto ran = draw(scene, output, more);
    EXPECT_EQ(ran.exit_code, exit_code) << what << ": " << ran.err;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
    EXPECT_FALSE(exists(output)) << what;
  }
};

TEST_F(WillisCommand, APictureOfTheDisplaysSizeAndOfAnother) {
  const json made = summary("boxes-5", "a.png");
  EXPECT_EQ(made["schema"], "sightline/draw/1");
  EXPECT_EQ(made["algorithm"], "willis");
  EXPECT_EQ(made["model"]["surfaces"], 30);
  EXPECT_EQ(made["model"]["residual"], 0);
  EXPECT_TRUE(made["not_separated"].empty());
  EXPECT_GT(made["counts"]["distances"], 0);
  const auto png = sightline::picture::read_png(path("a.png").string());
  ASSERT_TRUE(png);
  EXPECT_EQ(png->image.width, 512);
  EXPECT_EQ(png->image.height, 512);
  EXPECT_GT(colours("a.png").size(), 5U);
  ASSERT_EQ(draw("boxes-5", "b.png", {"--pixels", "90x70"}).exit_code, 0);
  EXPECT_EQ(sightline::picture::read_png(path("b.png").string())->image.width, 90);
  ASSERT_EQ(draw("boxes-5", "again.png").exit_code, 0);
  EXPECT_EQ(read("a.png"), read("again.png"));
}

TEST_F(WillisCommand, OutlinesAreBlackOnWhite) {
  ASSERT_EQ(draw("boxes-5", "lines.png", {"--picture", "lines"}).exit_code, 0);
  EXPECT_EQ(colours("lines.png"), (std::set<std::uint32_t>{0, 0xFF}));
}

TEST_F(WillisCommand, APlanNeedsFewerPieces) {
  const json space = summary("prisms-9", "space.png");
  const json plan = summary("prisms-9", "plan.png", {"--plan"});
  EXPECT_LT(plan["model"]["pieces"], space["model"]["pieces"]);
  EXPECT_EQ(plan["model"]["surfaces"], 36) << "four walls of each";
  EXPECT_EQ(space["model"]["surfaces"], 54);
  expect_refused(4, "town-12", "t.png", {"--plan"}, "between the feet and the tops of all walls");
  expect_refused(4, "triangles-5", "t.png", {"--plan"}, "body 0 face 0");
}

// The vertical is the scene's, in any camera direction: this camera is among the roofs and looks more down than forward.
TEST_F(WillisCommand, ThePlanAndTheFlightOfASteepView) {
  const Arguments steep{"--eye", "9973,701,-4001", "--look-at", "9973,-20000,9000"};
  Arguments plan = steep;
  plan.emplace_back("--plan");
  EXPECT_EQ(summary("prisms-9", "steep.png", plan)["model"]["surfaces"], 36);
  expect_refused(4, "prisms-9", "t.png", {"--plan", "--vertical", "z"}, "body 0 face 0");
  expect_refused(4, "prisms-9", "t.png", {"--plan", "--eye", "9973,9701,-4001"},
                 "found y = 9701, expected 0 to ");

  // The frames of a flight are level pictures: about another axis, the flight would have reached the ground.
  Arguments flight = steep;
  flight.insert(flight.end(), {"--frames", "6", "--pixels", "40x40"});
  EXPECT_EQ(draw("prisms-9", "level.apng", flight).exit_code, 0);
  EXPECT_EQ(draw("prisms-9", "same.apng", {"--eye", "9973,701,-4001", "--frames", "6", "--pixels", "40x40"})
                .exit_code,
            0);
  EXPECT_EQ(read("level.apng"), read("same.apng")) << "a flight looks at the middle of the scene";
}

TEST_F(WillisCommand, ResidualPairsAreNamedAndDrawnAllTheSame) {
  const auto uncut = draw("boxes-8", "c.png", {"--depth", "0", "--json"});
  EXPECT_EQ(uncut.exit_code, 0);
  EXPECT_TRUE(has(uncut.err,
                  "warning: body 0 (box 0) face 0 and body 2 (box 2) face 0 could not be separated: the "
                  "limit of depth\n"))
      << uncut.err;
  const json made = json::parse(uncut.out);
  EXPECT_EQ(made["model"]["pieces"], 48);
  EXPECT_EQ(made["not_separated"].size(), made["model"]["residual"]);
  EXPECT_TRUE(exists("c.png"));
  const json cut = summary("boxes-8", "d.png", {"--depth", "12"});
  EXPECT_TRUE(cut["not_separated"].empty());
  EXPECT_GT(cut["model"]["pieces"], 48);
}

TEST_F(WillisCommand, MoreThanTenPairsAreCounted) {
  const auto ran = draw("town-40", "t.png", {"--depth", "0"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(has(ran.err, "more pairs of faces that could not be separated")) << ran.err;
}

TEST_F(WillisCommand, TouchingWallsAreOrderedByOrderCells) {
  write("walls.json", walls);
  const json made = summary("walls.json", "w.png", {"--plan", "--field", "90", "--pixels", "64x64"});
  EXPECT_GT(made["model"]["order_cells"], 1);
  EXPECT_EQ(made["model"]["residual"], 0);
  EXPECT_GE(colours("w.png").size(), 3U);
}

TEST_F(WillisCommand, AFlightIsAnAnimatedPng) {
  const json made = summary("boxes-5", "f.apng", {"--frames", "7", "--pixels", "60x40"});
  EXPECT_EQ(made["output"], "f.apng");
  const std::string file = read("f.apng");
  ASSERT_TRUE(file.starts_with("\x89PNG\r\n\x1a\n"));
  const std::size_t control = file.find("acTL");
  ASSERT_NE(control, std::string::npos);
  EXPECT_EQ(file.substr(control + 4, 8), std::string("\0\0\0\7\0\0\0\0", 8))
      << "seven frames, repeated";
  std::size_t frames = 0;
  for (std::size_t at = file.find("fcTL"); at != std::string::npos; at = file.find("fcTL", at + 1)) ++frames;
  EXPECT_EQ(frames, 7U);
  expect_refused(2, "boxes-5", "g.apng", {"--orthographic", "0,0,1"}, "expected perspective for a flight");
  expect_refused(2, "boxes-5", "g.apng", {"--frames", "0"}, "--frames");
}

TEST_F(WillisCommand, WrongUsageAndBadInput) {
  expect_refused(2, "boxes-5", "g.svg", {}, ".png or, for a flight, .apng");
  expect_refused(2, "boxes-5", "g.png", {"--depth", "-1"}, "--depth");
  expect_refused(2, "boxes-5", "g.png", {"--depth", "deep"}, "--depth");
  expect_refused(2, "boxes-5", "g.png", {"--pixels", "0x9"}, "1 to 8192");
  expect_refused(2, "boxes-5", "g.png", {"--field", "200"}, "--field");
  expect_refused(2, "boxes-5", "g.png", {"--picture", "none"}, "--picture");
  expect_refused(5, "boxes-5", "nowhere/g.png", {}, "cannot write");
  expect_refused(5, "missing.json", "g.png", {}, "missing.json");
  write("broken.json", "{\"vertices\": [[0,0,0]], \"bodies\": [");
  expect_refused(4, "broken.json", "g.png", {}, "broken.json");
  write("walls.json", walls);
  expect_refused(4, "walls.json", "g.png", {"--eye", "5,0,0", "--look-at", "5,0,90"}, "on this face");
  EXPECT_EQ(files(), (std::vector<std::string>{"broken.json", "walls.json"}));
}

}  // namespace
