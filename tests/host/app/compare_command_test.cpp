// `sightline compare`: tables, JSON, overlays, exit codes, and usage errors.
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"
#include "tests/support/effort.hpp"

namespace {

using sightline::test::Arguments;
using sightline::test::has;

class CompareCommand : public sightline::test::CommandLine {};

// The names of the algorithms that `choose` selects, in the registry's order.
template <class Algorithms, class Choose>
std::vector<std::string> names(const Algorithms& algorithms, Choose choose) {
  std::vector<std::string> chosen;
  for (const auto& algorithm : algorithms)
    if (choose(algorithm)) chosen.emplace_back(algorithm.name);
  return chosen;
}

TEST_F(CompareCommand, ComparesASceneOfCells) {
  const auto ran = sightline({"compare", "house", "-o", "pictures"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part : {"house from ", "\njones-pdp7 ", "\njones-twin ", "\nexact ", "0, exact", "of 3 cells", "a few seconds, 1971",
                           "jones-pdp7 and its twin, the same program in C++, give the same ", "picture pictures/house-compare-jones-pdp7.png",
                           "jones-pdp7 lit "})
    EXPECT_TRUE(has(ran.out, part)) << part << '\n' << ran.out;
  for (const char* file : {"pictures/house-compare-jones-pdp7.png", "pictures/house-compare-jones-twin.svg",
                           "pictures/house-compare-jones-pdp7_points.png"})
    EXPECT_TRUE(exists(file)) << file;
  EXPECT_FALSE(exists("pictures/house-compare-exact.png")) << "nothing differs";
  ASSERT_EQ(sightline({"compare", "house", "--all", "-o", "all"}).exit_code, 0);
  for (const char* file : {"all/house-compare-jones-pdp7.png", "all/house-compare-exact.png"}) EXPECT_TRUE(exists(file)) << file;
  const auto png = sightline::picture::read_png(path("pictures/house-compare-jones-pdp7.png").string());
  ASSERT_TRUE(png);
  EXPECT_EQ(png->image.width, 1027);
  const auto points = sightline::picture::read_png(path("pictures/house-compare-jones-pdp7_points.png").string());
  ASSERT_TRUE(points);
  EXPECT_EQ(points->image.width, 1024);
}

// One table for people and programs: all rows have the same true length; only the machine has emulated time, only the others host
// time.
TEST_F(CompareCommand, HasOneTableOfAllMethods) {
  const auto ran = sightline({"compare", "house", "--no-host-times", "--json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto document = nlohmann::json::parse(ran.out);
  std::map<std::string, nlohmann::json> rows;
  for (const auto& row : document["table"]) {
    EXPECT_FALSE(row.contains("host_s")) << row;
    EXPECT_EQ(row["scene"], "house");
    EXPECT_EQ(row["views"], 1);
    rows[row["method"].get<std::string>() + "/" + row["picture"].get<std::string>()] = row;
  }
  ASSERT_TRUE(rows.contains("jones-pdp7/lines") && rows.contains("jones-twin/lines") && rows.contains("exact/lines") &&
              rows.contains("jones/lines") && rows.contains("montani-re/lines") && rows.contains("stripes-8080/faces"));
  EXPECT_GT(rows["jones-pdp7/lines"]["emulated_s"]["median"], 0.01);
  EXPECT_FALSE(rows["exact/lines"].contains("emulated_s"));
  EXPECT_EQ(rows["jones-pdp7/lines"]["paper"], "a few seconds, 1971");
  // The machine and its twin read the same parts of the scene.
  EXPECT_EQ(rows["jones-pdp7/lines"]["read"], rows["jones-twin/lines"]["read"]);
  EXPECT_EQ(rows["jones-pdp7/lines"]["of_all"], 3);
  std::set<double> lengths;
  for (const auto& picture : document["scenes"][0]["pictures"]) lengths.insert(std::round(1e6 * picture["true_length"].get<double>()));
  EXPECT_EQ(lengths.size(), 1U);
  const auto fewer = sightline({"compare", "house", "--no-host-times", "--json", "--methods", "jones-twin,jones-pdp7", "--fraction", "0", "--no-eae"});
  ASSERT_EQ(fewer.exit_code, 0) << fewer.err;
  const auto chosen = nlohmann::json::parse(fewer.out)["table"];
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_GT(chosen[1]["wrong"]["median"], 2 * rows["jones-twin/lines"]["wrong"]["median"].get<double>()) << "without fraction bits";
  EXPECT_EQ(chosen[1]["wrong"]["median"], chosen[0]["wrong"]["median"]) << "its words are the display's points";
  EXPECT_GT(chosen[0]["emulated_s"]["median"], rows["jones-pdp7/lines"]["emulated_s"]["median"]) << "slower without the EAE";
}

// Random views depend on their seed, and tables of different views differ.
TEST_F(CompareCommand, ComparesRandomViews) {
  const Arguments arguments{"compare", "house", "--views", "3", "--seed", "5", "--no-host-times", "--methods", "exact,jones-pdp7"};
  const auto ran = sightline(arguments);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "house, 3 random views of seed 5")) << ran.out;
  EXPECT_TRUE(has(ran.out, "3 of 3")) << ran.out;
  EXPECT_EQ(sightline(arguments).out, ran.out);
  const auto left_out = sightline({"compare", "house", "--views", "2", "--no-host-times", "--methods", "exact,plantinga,skala"});
  ASSERT_EQ(left_out.exit_code, 0) << left_out.err;
  EXPECT_TRUE(has(left_out.out, "plantinga not compared in 2 of 2 views: ") && has(left_out.out, "skala not compared: ")) << left_out.out;
  Arguments others = arguments;
  others[5] = "6";
  EXPECT_NE(sightline(others).out, ran.out);
  const auto function = sightline({"compare", "saddle", "--points", "9", "--views", "2", "--no-host-times", "--json", "--methods", "skala"});
  ASSERT_EQ(function.exit_code, 0) << function.err;
  const auto table = nlohmann::json::parse(function.out)["table"];
  ASSERT_EQ(table.size(), 1U);
  EXPECT_EQ(table[0]["views"], 2);
}

// The coordinates of the file are multiples of 0.1, which is the scene's step.
TEST_F(CompareCommand, TheEyeIsInTheUnitOfTheFile) {
  write("t.off", "OFF\n4 4 0\n0 0 0\n1.5 0 0\n0 1.5 0\n0 0 1.5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const auto ran = sightline({"compare", "t.off", "--eye", "4.5,3.5,2.25"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "t from 4.5,3.5,2.3")) << ran.out;
  const auto document = nlohmann::json::parse(sightline({"compare", "t.off", "--eye", "4.5,3.5,2.5", "--json"}).out);
  EXPECT_EQ(document["scenes"][0]["eye"], (std::vector<double>{4.5, 3.5, 2.5}));
  EXPECT_EQ(document["scenes"][0]["eye_steps"], (std::vector<int>{45, 35, 25}));
}

TEST_F(CompareCommand, ComparesAFunctionAndPolyhedraAsJson) {
  NEEDS_OPTIMISED_CODE();
  const Arguments arguments{"compare", "sinc", "bricks-10", "--all", "--json", "--no-host-times"};
  const auto ran = sightline(arguments);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto document = nlohmann::json::parse(ran.out);
  EXPECT_EQ(document["schema"], "sightline/compare/2");
  EXPECT_EQ(document["agrees"], true);
  ASSERT_EQ(document["scenes"].size(), 2U);
  EXPECT_EQ(document["scenes"][0]["function"], "sinc");
  EXPECT_EQ(document["scenes"][0]["pictures"][1]["different_inside"], 0);
  EXPECT_EQ(document["scenes"][0]["guest"]["identical_to_twin"], true);
  // The guest's row is not 0 if its own rounding counts.
  EXPECT_GT(document["scenes"][0]["pictures"][0]["unrounded"]["hausdorff_99_9"], 0.5);
  EXPECT_GT(document["scenes"][0]["chord_error"], 0.1);
  EXPECT_EQ(document["scenes"][0]["devices"].size(), 4U);
  EXPECT_TRUE(exists("out/sinc-compare-ef9365_dots.png"));
  EXPECT_EQ(document["scenes"][1]["pictures"][0]["name"], "exact");
  EXPECT_EQ(document["scenes"][1]["pictures"][0]["equal_to_oracle"], true);
  EXPECT_EQ(document["scenes"][1]["pictures"][0]["pieces_different"], 0);
  EXPECT_TRUE(exists("out/sinc-compare-skala.png"));
  EXPECT_TRUE(exists("out/bricks-10-compare-exact.svg"));
  if (sightline::tests::is_optimised()) {
    EXPECT_EQ(sightline(arguments).out, ran.out);
  }
}

TEST_F(CompareCommand, ComparesAUserDefinedFunction) {
  const auto contours = sightline({"compare", "--function", "x*x - z*z", "--domain", "-2:2", "--points", "17",
                                   "--slices", "19", "--picture", "contours", "--levels", "6", "--json"});
  ASSERT_EQ(contours.exit_code, 0) << contours.err;
  const auto document = nlohmann::json::parse(contours.out)["scenes"];
  ASSERT_EQ(document.size(), 1U);
  EXPECT_EQ(document[0]["function"], "x*x - z*z");
  EXPECT_EQ(document[0]["vectors"]["name"], "skala lines");
  EXPECT_GT(document[0]["vectors"]["true_length"], 500);
  EXPECT_LT(document[0]["vectors"]["missing_share"], 0.01);
  EXPECT_TRUE(exists("out/function-compare-skala_lines.svg"));
  const auto surface = sightline({"compare", "saddle", "--picture", "surface", "--points", "9"});
  ASSERT_EQ(surface.exit_code, 0) << surface.err;
  for (const char* part : {"\nskala-8080 ", "\nskala-twin ", "\nskala "})
    EXPECT_TRUE(has(surface.out, part)) << part << surface.out;
  EXPECT_EQ(sightline({"compare", "saddle", "--along", "z", "--rotate", "80", "--points", "9"}).exit_code, 0);
  const auto end_on = sightline({"compare", "saddle", "--along", "z", "--points", "9"});
  EXPECT_EQ(end_on.exit_code, 4);
  EXPECT_TRUE(has(end_on.err, "saddle: the column oracle draws only the slices that are less end-on"))
      << end_on.err;
}

TEST_F(CompareCommand, ComparesFacesByPoints) {
  const auto ran = sightline({"compare", "boxes-5", "--all", "--json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto document = nlohmann::json::parse(ran.out)["scenes"][0];
  std::vector<std::string> filled;
  for (const auto& faces : document["faces"]) {
    filled.push_back(faces["name"]);
    EXPECT_EQ(faces["different_inside"], 0) << faces;
    EXPECT_GT(faces["lit"], 1000);
  }
  auto all_faces = names(sightline::registry::face_algorithms(), [](const auto&) { return true; });
  all_faces.emplace_back("willis-8080");
  all_faces.emplace_back("stripes-8080");
  EXPECT_EQ(filled, all_faces);
  EXPECT_TRUE(exists("out/boxes-5-compare-willis-8080_faces.png"));
  EXPECT_TRUE(exists("out/boxes-5-compare-willis_faces.png"));
  const auto names_of = [](const auto& pictures) {
    std::vector<std::string> names;
    for (const auto& picture : pictures) names.push_back(picture["name"]);
    return names;
  };
  using sightline::registry::line_algorithms;
  using sightline::registry::LineAlgorithm;
  const auto compared = [](const LineAlgorithm& algorithm) { return algorithm.name != "oracle"; };
  EXPECT_EQ(names_of(document["pictures"]), names(line_algorithms(), [&](const LineAlgorithm& algorithm) {
              return compared(algorithm) && algorithm.why_not_view == nullptr;
            }));
  EXPECT_EQ(names_of(document["not_compared"]), names(line_algorithms(), [&](const LineAlgorithm& algorithm) {
              return compared(algorithm) && algorithm.why_not_view != nullptr;
            }));
  // In parallel projection everything applies.
  const auto parallel = sightline({"compare", "boxes-5", "--orthographic", "3,0,4", "--json"});
  ASSERT_EQ(parallel.exit_code, 0) << parallel.err;
  const auto turned = nlohmann::json::parse(parallel.out)["scenes"][0];
  EXPECT_EQ(names_of(turned["pictures"]), names(line_algorithms(), compared));
  EXPECT_EQ(names_of(turned["not_compared"]), std::vector<std::string>{});
  EXPECT_EQ(turned["turn"]["identical_to_twin"], true);
  EXPECT_LT(turned["turn"]["hausdorff"], turned["turn"]["hausdorff_bound"]);
  EXPECT_LT(turned["turn"]["hausdorff"], 3.7);
  EXPECT_EQ(names_of(turned["faces"]), all_faces);
  for (const auto& faces : turned["faces"]) EXPECT_EQ(faces["different_inside"], 0) << faces;
}

// None of this ends the command: applicable methods are compared, and a reason is given for each of the others.
TEST_F(CompareCommand, OmitsMethodsThatDoNotApply) {
  const Arguments arguments{"compare", "sinc", "house", "boxes-2", "--methods", "jones,willis", "--no-host-times"};
  const auto ran = sightline(arguments);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "sinc: nothing to compare\njones not compared: ")) << ran.out;
  EXPECT_TRUE(has(ran.out, "\nhouse from ") && has(ran.out, "\nboxes-2 from ")) << ran.out;
  EXPECT_EQ(ran.out.find("different: "), ran.out.rfind("different: ")) << "the columns are explained once" << ran.out;
  const auto none = sightline({"compare", "sinc", "saddle", "--methods", "jones,willis"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_EQ(none.out, "");
  EXPECT_TRUE(has(none.err, "sinc: jones does not apply: ")) << none.err;
}

TEST_F(CompareCommand, NamesTheErrors) {
  struct Case {
    sightline::test::Arguments arguments;
    int exit_code;
    const char* what;
  };
  write("square.csv", "1,2\n3,nan\n");
  write("bad.off", "OFF\n1\n");
  const std::vector<Case> cases{
      {{"compare", "nowhere"}, 5, "nowhere"},
      {{"compare", "house", "--methods", "jone-pdp7"}, 2, "--methods: found \"jone-pdp7\""},
      {{"compare", "house", "--methods", "jone-pdp7"}, 2, "did you mean \"jones-pdp7\"?"},
      {{"compare", "house", "--fraction", "4"}, 2, "--fraction"},
      {{"compare", "boxes-2", "--fraction", "2"}, 2, "--fraction: found with boxes-2"},
      {{"compare", "house", "--eye", "481,160,-200", "--methods", "exact"}, 4, "outside of the outer box"},
      {{"compare", "house", "--methods", "skala"}, 2, "skala does not apply"},
      {{"compare", "boxes-2", "--methods", "jones-pdp7"}, 2, "jones-pdp7 does not apply"},
      {{"compare", "boxes-2", "--views", "2", "--methods", "plantinga"}, 2, "plantinga does not apply"},
      {{"compare", "house", "--views", "3", "--eye", "480,160,20"}, 2, "--eye: found with --views"},
      {{"compare", "house", "--view", "1,2"}, 2, "--view"},
      {{"compare", "house", "--view", "iso"}, 2, "--view: found with house"},
      {{"compare", "bricks-5", "--view", "sideways"}, 2, "dimetric"},
      {{"compare", "house", "--view", "32000,0,0"}, 4, "house"},
      {{"compare", "house", "--scale", "9"}, 2, "--scale"},
      {{"compare", "sinc", "--view", "1,2,3"}, 2, "--view: found with sinc"},
      {{"compare", "bricks-5", "--scale", "512"}, 2, "--scale: found with bricks-5"},
      {{"compare", "house", "--orthographic", "0,0,1"}, 2, "--orthographic: found with house"},
      {{"compare", "house", "--points", "9"}, 2, "--points or --slices: found with house"},
      {{"compare", "sinc", "--levels", "9"}, 2, "--levels: found without --picture contours"},
      {{"compare", "sinc", "--domain", "1:2"}, 2, "--domain: found without --function"},
      {{"compare", "--function", "x+"}, 2, "x+"},
      {{"compare", "square.csv", "--points", "9"}, 2, "a grid file has its own size"},
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

TEST_F(CompareCommand, ScenesWithOneNameHaveSeparateOverlays) {
  NEEDS_OPTIMISED_CODE();
  std::filesystem::create_directory(path("d1"));
  std::filesystem::create_directory(path("d2"));
  ASSERT_EQ(sightline({"scene", "generate", "boxes", "1", "-o", "d1/a.off"}).exit_code, 0);
  ASSERT_EQ(sightline({"scene", "generate", "boxes", "2", "-o", "d2/a.off"}).exit_code, 0);
  const auto alone = sightline({"compare", "d1/a.off", "--all", "-o", "alone"});
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  const auto both = sightline({"compare", "d1/a.off", "d2/a.off", "--all", "-o", "both"});
  ASSERT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(read("both/a-compare-exact.png"), read("alone/a-compare-exact.png"));
  EXPECT_NE(read("both/a-2-compare-exact.png"), read("alone/a-compare-exact.png"));
  EXPECT_TRUE(has(both.out, "picture both/a-2-compare-exact.png")) << both.out;
}

TEST_F(CompareCommand, PlotsTimeAgainstError) {
  const auto ran = sightline({"compare", "house", "--plot", "house.svg", "--no-host-times", "--methods", "jones-pdp7,exact"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "plot house.svg")) << ran.out;
  const std::string svg = read("house.svg");
  for (const char* part : {"house: time against error", "jones-pdp7 with EAE, 0 bits: ", "jones-pdp7 without EAE, 3 bits: ", "No times of this computer"})
    EXPECT_TRUE(has(svg, part)) << part;
  const struct {
    Arguments arguments;
    const char* what;
    int exit_code;
  } cases[] = {{{"compare", "house", "--plot", "-"}, "--plot: found -, expected a file", 2},
               {{"compare", "house", "--plot", "a.svg", "--views", "2"}, "--plot: found with --views", 2},
               {{"compare", "house", "--plot", "no/such/a.svg"}, "no/such/a.svg", 5},
               {{"compare", "house", "--plot", "a.svg", "--no-host-times", "--methods", "exact"}, "--plot: nothing to plot: no method has", 4}};
  for (const auto& c : cases) {
    const auto failed = sightline(c.arguments);
    EXPECT_EQ(failed.exit_code, c.exit_code) << c.what;
    EXPECT_TRUE(has(failed.err, c.what)) << failed.err;
  }
  EXPECT_FALSE(exists("a.svg"));
}

TEST_F(CompareCommand, ExplainsItself) {
  const auto ran = sightline({"compare", "--help"});
  EXPECT_EQ(ran.exit_code, 0);
  for (const char* part : {"Examples:", "farthest", "NAME-compare-PICTURE.png", "--rotate", "--methods", "Exit codes"})
    EXPECT_TRUE(has(ran.out, part)) << part;
}

}  // namespace
