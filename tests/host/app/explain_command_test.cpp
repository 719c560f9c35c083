// `sightline explain`: its files, its help, and usage errors.
#include <filesystem>
#include <sstream>

#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"
#include "tests/support/effort.hpp"

namespace sightline::test {
namespace {

using nlohmann::json;

constexpr const char* algorithms[] = {"exact", "jones", "skala", "montani-re", "willis", "plantinga"};

class ExplainCommand : public CommandLine {
 protected:
  void expect_failure(const Arguments& arguments, int exit_code, std::string_view message) {
    Arguments all{"explain"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ran ran = sightline(all);
    EXPECT_EQ(ran.exit_code, exit_code) << message << '\n' << ran.err;
    EXPECT_TRUE(has(ran.err, message)) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(files(), std::vector<std::string>{}) << "nothing may be written";
  }
};

TEST_F(ExplainCommand, WritesJsonOfTheSchema) {
  const Ran ran = sightline({"explain", "exact", "house", "-o", "steps.json"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(files(), std::vector<std::string>{"steps.json"});
  const json lesson = json::parse(read("steps.json"));
  EXPECT_EQ(lesson.at("schema"), "sightline/explain/1");
  EXPECT_EQ(lesson.at("algorithm"), "exact");
  EXPECT_EQ(lesson.at("scene"), "house");
  EXPECT_GT(lesson.at("steps").size(), 20U);
  for (const json& step : lesson.at("steps"))
    for (const json& layer : step.at("layers")) EXPECT_LT(layer.at("sheet").get<std::size_t>(), lesson.at("sheets").size());
}

TEST_F(ExplainCommand, EveryAlgorithmWritesAPageWithTheLessonOfTheJson) {
  for (const std::string algorithm : algorithms) {
    const std::string scene = algorithm == "skala" ? "sinc" : "boxes-3";
    const Ran ran = sightline({"explain", algorithm, scene, "-o", "-"});
    ASSERT_EQ(ran.exit_code, 0) << algorithm << ": " << ran.err;
    const json lesson = json::parse(ran.out);
    EXPECT_EQ(lesson.at("algorithm"), algorithm);
    EXPECT_EQ(lesson.at("scene"), scene);
    ASSERT_EQ(sightline({"explain", algorithm, scene, "-o", "steps.html"}).exit_code, 0) << algorithm;
    const std::string page = read("steps.html");
    EXPECT_TRUE(page.starts_with("<!doctype html>")) << algorithm;
    EXPECT_FALSE(has(page, "http://") || has(page, "https://")) << algorithm << ": needs no network";
    const std::size_t begin = page.find("id=\"lesson\">") + 12;
    EXPECT_EQ(json::parse(page.substr(begin, page.find("</script", begin) - begin)), lesson) << algorithm;
  }
}

TEST_F(ExplainCommand, GivesTheSameBytesEveryTime) {
  for (const char* const algorithm : {"jones", "plantinga"}) {
    const Arguments arguments{"explain", algorithm, "house", "-o", "-"};
    EXPECT_EQ(sightline(arguments).out, sightline(arguments).out) << algorithm;
  }
}

TEST_F(ExplainCommand, ReadsASceneFromStandardInputAndTheCameraFromOptions) {
  const std::string tent = "OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const Ran above = sightline({"explain", "exact", "-", "--orthographic", "0,-1,0", "-o", "-"}, tent);
  const Ran aside = sightline({"explain", "exact", "-", "--orthographic", "-1,-2,-3", "-o", "-"}, tent);
  ASSERT_EQ(above.exit_code, 0) << above.err;
  ASSERT_EQ(aside.exit_code, 0) << aside.err;
  EXPECT_NE(json::parse(above.out).at("steps"), json::parse(aside.out).at("steps"));
}

TEST_F(ExplainCommand, HeightsFromAnExpression) {
  const Ran ran = sightline({"explain", "skala", "--function", "x*z", "--points", "5", "--slices", "4", "-o", "-"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(json::parse(ran.out).at("scene"), "x*z");
}

TEST_F(ExplainCommand, ReportsErrors) {
  expect_failure({"exact", "house", "-o", "steps.txt"}, 2, "ends in .json or .html, or - for JSON");
  expect_failure({"exact", "house"}, 2, "--output is required");
  expect_failure({"house", "jones", "-o", "steps.json"}, 2, "found \"house\" before jones, expected after it, as in `explain jones house`");
  expect_failure({"exact", "no_such_scene", "-o", "steps.json"}, 5, "no_such_scene: no such file");
  expect_failure({"exact", "house", "-o", "no/such/folder/steps.json"}, 5, "no/such/folder/steps.json");
  expect_failure({"nothing", "house", "-o", "steps.json"}, 2, "exact, jones, skala, montani-re, willis, plantinga");
  expect_failure({"exact", "house", "--orthographic", "0,0,0", "-o", "steps.json"}, 2, "--orthographic");
  expect_failure({"skala", "no_such_function", "-o", "steps.json"}, 5, "no function of that name");
  expect_failure({"skala", "sinc", "--elevate", "91", "-o", "steps.json"}, 2, "--elevate");
}

TEST_F(ExplainCommand, SendsAGridToSkala) {
  write("hills.csv", "1,2,3\n4,5,6\n7,8,9\n");
  const Ran ran = sightline({"explain", "jones", "hills.csv", "-o", "steps.json"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "hills.csv: found a grid of heights, expected a scene for jones; `sightline explain skala hills.csv` takes it")) << ran.err;
  EXPECT_EQ(sightline({"explain", "skala", "hills.csv", "-o", "steps.json"}).exit_code, 0);
}

TEST_F(ExplainCommand, AnImpossibleLessonLeavesNoFile) {
  expect_failure({"plantinga", "boxes-100", "-o", "steps.json"}, 4, "boxes-100: plantinga: the scene has 1200 edges");
  expect_failure({"willis", "boxes-200", "-o", "steps.html"}, 4, "boxes-200");
}

TEST_F(ExplainCommand, AFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  send_stdout_to("/dev/full");
  const Ran ran = sightline({"explain", "exact", "house", "-o", "-"});
  EXPECT_EQ(ran.exit_code, 5) << ran.err;
}

// The examples in the help of each algorithm and in the common help run.
TEST_F(ExplainCommand, ExamplesOfTheHelpRun) {
  NEEDS_OPTIMISED_CODE();
  std::vector<Arguments> pages{{"explain", "--help"}};
  for (const char* const algorithm : algorithms) pages.push_back({"explain", algorithm, "--help"});
  for (const Arguments& page : pages) {
    const Ran help = sightline(page);
    ASSERT_EQ(help.exit_code, 0) << help.err;
    std::istringstream lines(help.out.substr(help.out.find("Examples:")));
    std::size_t run = 0;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("  sightline explain ")) continue;
      if (line.ends_with("\\")) {
        std::string rest;
        std::getline(lines, rest);
        line = line.substr(0, line.size() - 1) + rest;
      }
      Arguments arguments;
      std::istringstream words(line);
      for (std::string word; words >> word;) {
        std::erase(word, '"');
        arguments.push_back(word);
      }
      arguments.erase(arguments.begin());
      const Ran ran = sightline(arguments);
      EXPECT_EQ(ran.exit_code, 0) << line << '\n' << ran.err;
      ++run;
    }
    EXPECT_GE(run, 2U) << help.out;
  }
}

}  // namespace
}  // namespace sightline::test
