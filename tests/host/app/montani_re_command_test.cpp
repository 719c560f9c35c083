// `sightline draw montani-re`: lines, outlines with holes, pixels by stripes, and usage errors.
#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;

class MontaniReCommand : public sightline::test::CommandLine {
 protected:
  json drawn(Arguments arguments) {
    arguments.insert(arguments.begin(), {"draw", "montani-re"});
    arguments.emplace_back("--json");
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out, nullptr, false);
  }
};

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST_F(MontaniReCommand, LinesEqualTheExactEdges) {
  const json summary = drawn({"boxes-9", "-o", "m.svg"});
  EXPECT_EQ(summary["algorithm"], "montani-re");
  EXPECT_GT(summary["counts"]["relations"], 0);
  ASSERT_EQ(sightline({"draw", "exact", "boxes-9", "-o", "e.svg"}).exit_code, 0);
  EXPECT_EQ(read("m.svg"), read("e.svg"));
}

// The eye of these scenes is in a room: faces extend from in front of it to behind it.
TEST_F(MontaniReCommand, LinesFromAmongTheFaces) {
  for (const std::string scene : {"street4", "corridor8", "roberts"}) {
    EXPECT_GT(drawn({scene, "-o", scene + ".svg"})["visible_length"], 1) << scene;
    EXPECT_TRUE(exists(scene + ".svg"));
  }
}

TEST_F(MontaniReCommand, OutlinesWithHoles) {
  write("window.json",
        R"({"vertices": [[0,0,0],[90,0,0],[90,90,0],[0,90,0],[30,30,0],[60,30,0],[60,60,0],[30,60,0],
  [20,20,50],[40,20,50],[40,40,50],[20,40,50]],
  "bodies": [{"sheet": true, "faces": [{"outline": [0,1,2,3], "holes": [[7,6,5,4]]}]},
             {"sheet": true, "faces": [[8,9,10,11]]}],
  "camera": {"perspective": false, "eye": [0,0,-100], "forward": [0,0,1], "right": [1,0,0], "up": [0,1,0]}})");
  const json counts = drawn({"window.json", "--fill", "--size", "110x110", "-o", "w.svg"})["counts"];
  EXPECT_EQ(counts["faces"], 2);
  EXPECT_EQ(counts["regions"], 2);
  EXPECT_EQ(counts["holes"], 1);
  EXPECT_EQ(counts["corners"], 12);
  const std::string svg = read("w.svg");
  EXPECT_TRUE(has(svg, "fill-rule=\"evenodd\""));
  EXPECT_EQ(count(svg, "<path "), 2U);
  EXPECT_EQ(count(svg, "M"), 3U);
  // The frame fills the inside of the paper except its margin; the square behind ends at the hole.
  EXPECT_EQ(count(svg, "Z"), 3U);
  drawn({"window.json", "--fill", "--size", "110x110", "-o", "x.svg"});
  EXPECT_EQ(svg, read("x.svg"));
}

TEST_F(MontaniReCommand, PixelsByStripes) {
  const json thin = drawn({"boxes-9", "--fill", "--pixels", "90x70", "-o", "thin.png"})["counts"];
  const json thick =
      drawn({"boxes-9", "--fill", "--stripe", "8", "--pixels", "90x70", "-o", "thick.png"})["counts"];
  EXPECT_GT(thin["sides"].get<int>(), 4 * thick["sides"].get<int>());
  const auto png = sightline::picture::read_png(path("thin.png").string());
  ASSERT_TRUE(png);
  EXPECT_EQ(png->image.width, 90);
  EXPECT_EQ(png->image.height, 70);
  EXPECT_NE(read("thin.png"), read("thick.png"));
}

// Colours between those of two faces appear only with antialiasing, and only at edges.
TEST_F(MontaniReCommand, AntialiasedPixels) {
  drawn({"boxes-3", "--fill", "--pixels", "90x70", "-o", "hard.png"});
  drawn({"boxes-3", "--fill", "--antialias", "--pixels", "90x70", "-o", "smooth.png"});
  const auto hard = sightline::picture::read_png(path("hard.png").string());
  const auto smooth = sightline::picture::read_png(path("smooth.png").string());
  ASSERT_TRUE(hard && smooth);
  const auto colours = [](const sightline::picture::Image& image) {
    std::set<std::array<std::uint8_t, 3>> all;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) all.insert({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
    return all;
  };
  const auto plain = colours(hard->image);
  EXPECT_LE(plain.size(), 10U);
  EXPECT_GT(colours(smooth->image).size(), 3 * plain.size());
  int same = 0;
  for (std::size_t i = 0; i < hard->image.pixels.size(); ++i) same += hard->image.pixels[i] == smooth->image.pixels[i] ? 1 : 0;
  EXPECT_GT(same, 90 * 70 * 3 * 8 / 10);
}

TEST_F(MontaniReCommand, UsageErrors) {
  const auto expect_usage_error = [&](Arguments arguments, std::string_view what) {
    arguments.insert(arguments.begin(), {"draw"});
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << what;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
    EXPECT_TRUE(files().empty());
  };
  expect_usage_error({"montani-re", "boxes-3", "--fill", "-o", "m.plt"}, ".svg or .png");
  expect_usage_error({"montani-re", "boxes-3", "--fill", "--stripe", "2", "-o", "m.svg"},
                     "--stripe: found without");
  expect_usage_error({"montani-re", "boxes-3", "--fill", "--stripe", "3", "-o", "m.png"}, "--stripe");
  expect_usage_error({"montani-re", "boxes-3", "--stripe", "2", "-o", "m.png"}, "--fill");
  expect_usage_error({"montani-re", "boxes-3", "--fill", "--antialias", "-o", "m.svg"}, "--antialias: found without");
  expect_usage_error({"montani-re", "boxes-3", "--antialias", "-o", "m.png"}, "--fill");
  expect_usage_error({"montani-re", "boxes-3", "--fill", "--hidden", "-o", "m.svg"}, "--hidden");
  expect_usage_error({"exact", "boxes-3", "--fill", "-o", "m.svg"}, "--fill");
}

TEST_F(MontaniReCommand, FacesThatPassThroughEachOtherAreNamed) {
  write("cross.json",
        R"({"vertices": [[0,0,0],[90,0,90],[90,90,90],[0,90,0],[0,0,90],[90,0,0],[90,90,0],[0,90,90]],
  "bodies": [{"sheet": true, "faces": [[0,1,2,3]]}, {"sheet": true, "faces": [[4,5,6,7]]}],
  "camera": {"perspective": false, "eye": [0,0,-100], "forward": [0,0,1], "right": [1,0,0], "up": [0,1,0]}})");
  for (const Arguments& fill : {Arguments{}, Arguments{"--fill"}}) {
    Arguments arguments{"draw", "montani-re", "cross.json", "-o", "c.svg"};
    arguments.insert(arguments.end(), fill.begin(), fill.end());
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 4);
    EXPECT_TRUE(has(ran.err, "face 0 of body 0 and face 0 of body 1 pass through each other")) << ran.err;
    EXPECT_FALSE(exists("c.svg"));
  }
}

}  // namespace
