// `sightline hard`: lists, runs and draws the hard cases, and usage errors.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::Arguments;
using sightline::test::has;

class HardCommand : public sightline::test::CommandLine {};

TEST_F(HardCommand, ListsTheCases) {
  const auto ran = sightline({"hard", "--list"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "J11  jones      a portal of 1 by 1 at z = 20000: a window of S/20000 [J11.json]\n")) << ran.out;
  EXPECT_TRUE(has(ran.out, "P22  plantinga  ")) << ran.out;
  EXPECT_EQ(sightline({"hard", "J5", "--list"}).out,
            "J5   jones      two windows, X/S in -1/5..0 and 0..1/10, that share a side [J5.json]\n"
            "J5   jones      the same, the first window up to 1/100 [J5-strip.json]\n"
            "J5   jones      the same, windows that share a point [J5-corner.json]\n");
  const auto document = nlohmann::json::parse(sightline({"hard", "--list", "--json"}).out);
  EXPECT_EQ(document["schema"], "sightline/hard/1");
  EXPECT_GE(document["cases"].size(), 129U);
}

TEST_F(HardCommand, RunsACompleteCase) {
  const auto ran = sightline({"hard", "J5-strip", "S8-backwards.txt", "M7"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part : {"J5 (jones, J5-strip.json): ", "\nexpected    a strip in common: the third cell is entered\n", "\nemulated    right\n",
                           "\ncompare     sightline compare J5-strip.json\n",
                           "\nemulated    differs: 0 dots missing, 169 too many (as recorded)\n",
                           "\ntests       LatticeHardCases.M7HolesInHoles\n"})
    EXPECT_TRUE(has(ran.out, part)) << part << '\n' << ran.out;
  EXPECT_FALSE(has(ran.out, "J5-corner")) << ran.out;
}

TEST_F(HardCommand, GivesJson) {
  const auto ran = sightline({"hard", "S11", "--json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto document = nlohmann::json::parse(ran.out);
  EXPECT_EQ(document["as_recorded"], true);
  ASSERT_EQ(document["cases"].size(), 1U);
  EXPECT_EQ(document["cases"][0]["compare"], "sightline compare S11.csv --along x --rotate 0 --elevate 0");
  EXPECT_EQ(document["cases"][0]["methods"].size(), 4U);
  // The guest moves a crossing by more than a column if slopes differ by a quarter.
  ASSERT_EQ(document["families"].size(), 2U);
  EXPECT_EQ(document["families"][0]["builds"][0]["name"], "guest");
  EXPECT_EQ(document["families"][0]["builds"][0]["first_failure"], 4);
}

// A hidden line that is drawn: dark at its place only in the second panel, and blue in the third.
TEST_F(HardCommand, WritesInputsAndPictures) {
  const auto ran = sightline({"hard", "S8-backwards", "P22", "-o", "to"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(read("to/S8-backwards.txt").starts_with("DEVICE 0\n"));
  EXPECT_EQ(files(), (std::vector<std::string>{"to"}));
  const auto png = sightline::picture::read_png(path("to/S8-backwards.png").string());
  ASSERT_TRUE(png);
  ASSERT_EQ(png->image.width, 3 * 256 + 4 * 8);
  // (128, 100) is on the farthest line, behind the roof.
  const auto colour = [&](int panel) {
    const std::size_t at = png->image.index(8 + panel * (256 + 8) + 128, 32 + 255 - 100);
    return std::vector<int>{png->image.pixels[at], png->image.pixels[at + 1], png->image.pixels[at + 2]};
  };
  EXPECT_EQ(colour(0), (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(colour(1), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(colour(2), (std::vector<int>{0, 90, 200}));
}

TEST_F(HardCommand, ReportsErrors) {
  const auto unknown = sightline({"hard", "J55"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(has(unknown.err, "CASE: found \"J55\", expected a case of `sightline hard --list`; did you mean \"J5\"?")) << unknown.err;
  write("file", "");
  EXPECT_EQ(sightline({"hard", "J5", "-o", "file"}).exit_code, 5);
}

}  // namespace
