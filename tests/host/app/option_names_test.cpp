// One name per option in all subcommands: the eye, a generated scene, --eae, a picture by its name; older names are still
// accepted.
#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"
#include "tests/support/effort.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

class OptionNames : public sightline::test::CommandLine {
 protected:
  // Both must print and write the same, and something.
  void expect_same(const Arguments& one, const Arguments& other) {
    const Ran a = sightline(one);
    const Ran b = sightline(other);
    EXPECT_EQ(a.exit_code, 0) << a.err;
    EXPECT_FALSE(a.out.empty());
    EXPECT_EQ(a.out, b.out);
  }
  void expect_usage_error(const Arguments& arguments, std::string_view what) {
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << what;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
  }
};

TEST_F(OptionNames, TheEye) {
  NEEDS_OPTIMISED_CODE();
  const std::string eye = "110,50,40";
  expect_same({"jones", "house", "--json", "--at", eye}, {"jones", "house", "--json", "--eye", eye});
  expect_same({"scene", "tape", "house", "--at", eye}, {"scene", "tape", "house", "--eye", eye});
  expect_same({"compare", "boxes-2", "--view", "5000,4000,6000", "--no-host-times"},
              {"compare", "boxes-2", "--eye", "5000,4000,6000", "--no-host-times"});
  EXPECT_NE(sightline({"scene", "tape", "house", "--eye", eye}).out,
            sightline({"scene", "tape", "house"}).out);
}

TEST_F(OptionNames, SizeOfATurnInPixels) {
  ASSERT_EQ(sightline({"spin", "boxes-1", "--step", "90", "--size", "64", "-o", "a.apng"}).exit_code, 0);
  ASSERT_EQ(sightline({"spin", "boxes-1", "--step", "90", "--pixels", "64", "-o", "b.apng"}).exit_code, 0);
  EXPECT_EQ(read("a.apng"), read("b.apng"));
}

TEST_F(OptionNames, CellDecompositionHasItsFormerName) {
  expect_same({"scene", "decompose", "boxes-3"}, {"scene", "compartment", "boxes-3"});
}

TEST_F(OptionNames, GeneratedScenesAreScenesEverywhere) {
  ASSERT_EQ(sightline({"scene", "generate", "boxes", "3", "--seed", "7", "-o", "file.json"}).exit_code, 0);
  expect_same({"scene", "info", "boxes-3-7"}, {"scene", "info", "file.json"});
  EXPECT_TRUE(has(sightline({"scene", "check", "boxes-3-7"}).out, "boxes-3-7: a possible scene"));
  expect_same({"scene", "convert", "boxes-3-7"}, {"scene", "convert", "file.json"});
  for (const char* action : {"info", "check", "convert"})
    expect_usage_error({"scene", action, "boxes-0"}, "found 0, expected 1..");
  // An existing file of that name takes precedence.
  write("boxes-3", "nothing");
  EXPECT_EQ(sightline({"scene", "check", "boxes-3"}).exit_code, 4);
  EXPECT_EQ(sightline({"scene", "check", "bushes-3"}).exit_code, 5);
}

TEST_F(OptionNames, WithAndWithoutTheEae) {
  NEEDS_OPTIMISED_CODE();
  for (const Arguments& command :
       {Arguments{"jones", "house", "--json"},
        Arguments{"sweep", "roberts", "--views", "1", "--guest", "--algorithm", "exact"}}) {
    Arguments with = command;
    with.emplace_back("--eae");
    Arguments without = command;
    without.emplace_back("--no-eae");
    expect_same(command, with);
    EXPECT_EQ(sightline(without).exit_code, 0);
    with.emplace_back("--no-eae");
    expect_usage_error(with, "--no-eae");
  }
  EXPECT_NE(sightline({"jones", "house", "--json"}).out,
            sightline({"jones", "house", "--json", "--no-eae"}).out);
  expect_usage_error({"compare", "house", "--eae", "--no-eae"}, "--no-eae");
}

TEST_F(OptionNames, PicturesAndSlicesByNamesOnly) {
  expect_usage_error({"draw", "skala", "sinc", "--picture", "2", "-o", "s.svg"}, "{lines,surface,contours}");
  expect_usage_error({"draw", "skala", "sinc", "--along", "1", "-o", "s.svg"}, "{x,z,both}");
  expect_usage_error({"compare", "sinc", "--picture", "2"}, "{lines,surface,contours}");
  EXPECT_TRUE(files().empty());
}

TEST_F(OptionNames, DrawSkalaReportsWhatItDrew) {
  const Ran ran = sightline({"draw", "skala", "saddle", "--picture", "contours", "--points", "9", "--slices",
                             "11", "--json", "-o", "s.svg"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const json document = json::parse(ran.out);
  EXPECT_EQ(document.at("schema"), "sightline/draw/1");
  EXPECT_EQ(document.at("algorithm"), "skala");
  EXPECT_EQ(document.at("picture"), "contours");
  EXPECT_EQ(document.at("slices"), 11);
  EXPECT_EQ(document.at("points"), 9);
  EXPECT_EQ(document.at("output"), "s.svg");
  EXPECT_GT(document.at("counts").at("lines"), 8);
}

TEST_F(OptionNames, TheSamePictureBySlicesOfAName) {
  const auto drawn = [this](const Arguments& more) {
    Arguments arguments{"draw", "skala", "sinc", "--points", "20", "--slices", "20", "-o", "s.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(sightline(arguments).exit_code, 0);
    return read("s.svg");
  };
  const std::string x = drawn({"--along", "x"});
  const std::string z = drawn({"--along", "z"});
  EXPECT_TRUE(has(x, "lines along x") && !has(x, "lines along z"));
  EXPECT_TRUE(has(z, "lines along z") && !has(z, "lines along x"));
  const std::string both = drawn({"--along", "both"});
  EXPECT_TRUE(has(both, "lines along x") && has(both, "lines along z"));
  EXPECT_EQ(drawn({}), drawn({"--picture", "lines"}));
}

TEST_F(OptionNames, ARunNeedsAProgram) {
  expect_usage_error({"run", "pdp7"}, "run pdp7: needs a PROGRAM or --load FILE");
  expect_usage_error({"run", "i8080"}, "run i8080: needs a PROGRAM or --load FILE");
  expect_usage_error({"monitor", "pdp7"}, "monitor pdp7: needs a PROGRAM or --load FILE");
}

TEST_F(OptionNames, AViewOutsideATurnIsAnError) {
  const auto refused = [this](const Arguments& view, const char* reason) {
    Arguments arguments{"draw", "plantinga", "boxes-2", "-o", "p.svg"};
    arguments.insert(arguments.end(), view.begin(), view.end());
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 4);
    EXPECT_TRUE(has(ran.err, reason)) << ran.err;
    EXPECT_FALSE(exists("p.svg"));
  };
  refused({}, "parallel projections only");
  refused({"--orthographic", "1,1,1"}, "parallel to y = 0");
  EXPECT_EQ(sightline({"draw", "plantinga", "boxes-2", "--orthographic", "3,0,4", "-o", "p.svg"}).exit_code,
            0);
}

}  // namespace
