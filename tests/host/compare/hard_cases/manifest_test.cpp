// The manifest of the hard cases: it is read completely, damage is reported with file and position, its inputs and the tests that
// it
// names exist. Also the search for a first failure, on builds that fail at given values.
#include "host/compare/hard_cases/manifest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "host/compare/hard_cases/first_failures.hpp"
#include "host/compare/hard_cases/case_images.hpp"
#include "host/compare/hard_cases/run_case.hpp"
#include "host/compare/hard_cases/runner.hpp"

namespace sightline::compare {
namespace {

constexpr std::string_view file = "manifest.json";

Manifest manifest() {
  const auto read = read_manifest(hard_case_text(file), file);
  if (!read) ADD_FAILURE() << read.error().message();
  return read ? *read : Manifest{};
}

TEST(HardCaseManifest, HasEveryCase) {
  std::map<std::string, std::set<std::string>> ids;
  std::size_t cases = 0;
  for (const HardCaseGroup& group : manifest().groups) {
    cases += group.cases.size();
    for (const HardCase& hard : group.cases) ids[group.id].insert(hard.id);
  }
  EXPECT_GE(cases, 129U);
  for (const auto& [group, letter, last] : {std::tuple{"jones", "J", 17},
                                            {"skala", "S", 16},
                                            {"willis", "W", 16},
                                            {"montani-re", "M", 18},
                                            {"plantinga", "P", 22}}) {
    for (int i = 1; i <= last; ++i)
      EXPECT_TRUE(ids[group].contains(letter + std::to_string(i))) << letter << i;
  }
}

// Every file belongs to a case, every case's input exists, and its method is known.
TEST(HardCaseManifest, InputsAndMethodsExist) {
  std::set<std::string> used{std::string(file)};
  for (const HardCaseGroup& group : manifest().groups) {
    for (const HardCase& hard : group.cases) {
      used.insert(hard.input);
      if (hard.input != "octants" && !hard.input.empty()) {
        EXPECT_FALSE(hard_case_text(hard.input).empty()) << hard.input;
      }
      for (const std::string& method : hard.run) EXPECT_TRUE(is_method(method)) << hard.id << ' ' << method;
      for (const auto& [method, text] : hard.found)
        EXPECT_NE(std::find(hard.run.begin(), hard.run.end(), method), hard.run.end())
            << hard.id << ' ' << method;
    }
  }
  for (const auto& [name, text] : hard_case_files()) EXPECT_TRUE(used.contains(std::string(name))) << name;
}

// The tests that the page names exist: their names occur in the sources.
TEST(HardCaseManifest, NamedTestsExist) {
  std::string sources;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(SIGHTLINE_SOURCE_DIR "/tests/host")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream stream(entry.path());
    sources.append(std::istreambuf_iterator<char>(stream), {});
  }
  std::size_t named = 0;
  for (const HardCaseGroup& group : manifest().groups) {
    for (const HardCase& hard : group.cases) {
      for (const std::string& test : hard.tests) {
        ++named;
        const std::size_t dot = test.find('.');
        ASSERT_NE(dot, std::string::npos) << test;
        EXPECT_NE(sources.find("TEST(" + test.substr(0, dot) + ", " + test.substr(dot + 1) + ")"),
                  std::string::npos)
            << hard.id << ": there is no test " << test;
      }
    }
  }
  EXPECT_GT(named, 70U);
}

std::string refusal(std::string from, std::string to) {
  std::string text(hard_case_text(file));
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const auto read = read_manifest(text, file);
  EXPECT_FALSE(read) << to;
  return read ? "" : read.error().message();
}

TEST(HardCaseManifest, DamageIsReportedWithFileAndPosition) {
  EXPECT_EQ(refusal("\"id\": \"J1\"", "\"id\": 1"),
            "manifest.json: groups[0].cases[0].id: expected a string of up to 400 printable ASCII "
            "characters, found 1");
  EXPECT_NE(refusal("\"section\": ", "\"chapter\": ").find("manifest.json: groups[0].cases[0]: "),
            std::string::npos);
  EXPECT_NE(
      refusal("\"mask_sides\": 4", "\"mask_sides\": -4").find("groups[0].cases[4].expect.counts.mask_sides"),
      std::string::npos);
  EXPECT_NE(refusal("\"family\": \"x\"", "\"family\": \"y\"").find("expected one of x, z, both, auto"),
            std::string::npos);
  EXPECT_NE(refusal("\"search\": \"bisect\"", "\"search\": \"bisection\"").find("families[0].search"),
            std::string::npos);
  EXPECT_NE(refusal("\"left_over\"", "\"left\"").find(".expect: found \"left\", expected refused, "),
            std::string::npos);
  const std::string half = std::string(hard_case_text(file).substr(0, 5000));
  const auto read = read_manifest(half, file);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().file, file);
}

Trial failing_from(double value, double from) {
  Trial trial;
  if (value >= from) trial.fault = "too large";
  return trial;
}

TEST(FirstFailures, AreFoundByTryingEachAndByBisection) {
  std::vector<double> values;
  for (int i = 1; i <= 100; ++i) values.push_back(i);
  for (double from = 1; from <= 101; ++from) {
    std::size_t attempts = 0;
    const auto attempt = [&](double value) {
      ++attempts;
      return failing_from(value, from);
    };
    for (const bool bisect : {false, true}) {
      attempts = 0;
      const SearchResult found = find_first_failure(values, bisect, attempt);
      ASSERT_EQ(found.first.has_value(), from <= 100) << from;
      if (found.first) {
        EXPECT_EQ(found.tried[*found.first].first, from);
      }
      EXPECT_EQ(found.tried.size(), attempts);
      EXPECT_LE(attempts, bisect ? 14U : 100U);
      EXPECT_TRUE(std::is_sorted(found.tried.begin(), found.tried.end(),
                                 [](const auto& a, const auto& b) { return a.first < b.first; }));
    }
  }
}

// The judge of lines must be able to say no.
TEST(HardCaseRunner, SegmentsAreVisibleCompletelyPartlyOrNotAtAll) {
  scene::PolyScene scene;
  scene.vertices = {{0, 0, 5}, {10, 0, 5}, {20, 0, 5}, {0, 7, 5}};
  const SceneSegment segment{{{20, 0, 5}, {0, 0, 5}}};
  picture::LinePicture picture;
  EXPECT_EQ(seen_of(segment, picture, scene), SegmentSeen::nothing);
  picture.pieces = {{{0, 1}, 0, 1}, {{0, 3}, 0, 1}, {{1, 2}, 0, {1, 3}}};
  EXPECT_EQ(seen_of(segment, picture, scene), SegmentSeen::in_part);
  picture.pieces.push_back({{1, 2}, {1, 3}, 1});
  EXPECT_EQ(seen_of(segment, picture, scene), SegmentSeen::whole);
  EXPECT_EQ(seen_of({{{0, 1, 5}, {20, 1, 5}}}, picture, scene), SegmentSeen::nothing);
}

// So must the runner: with a changed expectation every kind of case fails.
TEST(HardCaseRunner, FindsUnexpectedResults) {
  const auto finding = [](HardCase hard, const char* method) {
    return CaseRun(hard, load_input(hard)).run(method);
  };
  HardCase cells;
  cells.input = "J5.json";
  cells.expect.counts = {{"cells", 2}};
  EXPECT_EQ(finding(cells, "jones").text, "right");
  cells.expect.counts = {{"cells", 3}};
  EXPECT_EQ(finding(cells, "jones").text, "differs: cells 2, not 3");
  EXPECT_EQ(finding(cells, "twin").text, "differs: cells 2, not 3");
  cells.expect.refused = true;
  EXPECT_EQ(finding(cells, "jones").text, "accepted");
  HardCase sheets;
  sheets.input = "M1.json";
  sheets.expect.areas = {200, 200, 399};
  EXPECT_EQ(finding(sheets, "montani-re").text, "differs: seen areas 200, 200, 400");
  EXPECT_EQ(finding(sheets, "oracle").text, "differs: seen areas 200, 200, 400");
  HardCase grid;
  grid.input = "S1.csv";
  grid.options.view.elevation = 30;
  grid.expect.dots = 1;
  EXPECT_TRUE(finding(grid, "twin").text.starts_with("differs: ")) << finding(grid, "twin").text;
  HardCase commands;
  commands.input = "S4.txt";
  EXPECT_EQ(finding(commands, "twin").text, "differs: 0 dots missing, 201 too many");
  HardCase none;
  none.input = "J0.json";
  EXPECT_EQ(finding(none, "jones").good, false);
}

// A record that differs from the result is found: both directions of a case, and of a family's first failure.
TEST(HardCaseRecords, DeviationsAreFound) {
  HardCase hard;
  hard.input = "J5.json";
  hard.run = {"jones"};
  hard.expect.counts = {{"cells", 2}};
  EXPECT_TRUE(run_case(hard).as_recorded());
  hard.found = {{"jones", "differs: cells 2, not 3"}};
  EXPECT_FALSE(run_case(hard).as_recorded());
  hard.expect.counts = {{"cells", 3}};
  EXPECT_TRUE(run_case(hard).as_recorded());
  hard.found.clear();
  EXPECT_FALSE(run_case(hard).as_recorded());

  Family family;
  family.generator = "neighbouring-angles";
  family.values = {20, 21, 22, 23, 24, 25, 26, 27};
  family.builds.emplace_back().method = "angles in single precision";
  const auto first = [&] { return run_family(family)->front(); };
  ASSERT_TRUE(first().search.first.has_value());
  EXPECT_FALSE(first().as_recorded);
  const auto [value, trial] = first().search.tried[*first().search.first];
  family.builds[0].first = trial.shown.value_or(value);
  EXPECT_TRUE(first().as_recorded);
  family.builds[0].first = *family.builds[0].first + 1;
  EXPECT_FALSE(first().as_recorded);
  family.values = {2};
  EXPECT_FALSE(first().as_recorded);
}

picture::Image grey(const std::vector<std::uint8_t>& pixels) {
  picture::Image image(static_cast<int>(pixels.size()), 1, 1);
  image.pixels = pixels;
  return image;
}

// Dark only in the expected picture, only in the found one, in both, in neither.
TEST(HardCasePictures, MarkWhatDiffers) {
  const picture::Image image = side_by_side(grey({0, 255, 0, 255}), grey({255, 0, 0, 255}), "guest");
  ASSERT_EQ(image.channels, 3);
  const auto colour = [&](int column) {
    const std::size_t at = image.index(2 * (4 + 8) + 8 + column, 32);
    return std::vector<int>{image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
  };
  EXPECT_EQ(colour(0), (std::vector<int>{213, 94, 0}));
  EXPECT_EQ(colour(1), (std::vector<int>{0, 90, 200}));
  EXPECT_EQ(colour(2), (std::vector<int>{192, 192, 192}));
  EXPECT_EQ(colour(3), (std::vector<int>{255, 255, 255}));
}

TEST(HardCaseCommands, AreTheInputInTheViewOfTheCase) {
  const auto command = [](std::string_view id, std::string_view input) -> std::string {
    for (const HardCaseGroup& group : manifest().groups)
      for (const HardCase& hard : group.cases)
        if (hard.id == id && hard.input == input) return compare_command(hard);
    return "no such case";
  };
  const auto hard = [](const char* id, const char* input) {
    HardCase named;
    named.id = id;
    named.input = input;
    return hard_command(named);
  };
  EXPECT_EQ(hard("J5", "J5-strip.json"), "sightline hard J5-strip");
  EXPECT_EQ(hard("J9", "house.json"), "sightline hard J9");
  EXPECT_EQ(hard("M1'", "M1-four.json"), "sightline hard M1-four");
  EXPECT_EQ(hard("P22", ""), "sightline hard P22");
  EXPECT_EQ(command("J5", "J5-strip.json"), "sightline compare J5-strip.json");
  EXPECT_EQ(command("J9", "house.json"), "sightline compare house");
  EXPECT_EQ(command("J12", "J12.json"), "sightline compare J12.json --scale 511");
  EXPECT_EQ(command("S11", "S11.csv"), "sightline compare S11.csv --along x --rotate 0 --elevate 0");
  EXPECT_EQ(command("S9", "S9.csv"), "sightline compare S9.csv --both --rotate 0 --elevate 40");
  EXPECT_EQ(command("S16", "S16.csv").substr(0, 40), "sightline compare S16.csv --picture cont");
  EXPECT_EQ(command("S5", "S5.csv"), "sightline compare S5.csv");
  EXPECT_EQ(command("S10", "S10.csv"), "");
  EXPECT_EQ(command("S4", "S4.txt"), "");
  EXPECT_EQ(command("S7", "octants"), "");
}

// Every text among the inputs begins with a description; none is read as a scene or grid.
TEST(HardCaseCommands, TextsAreRecognised) {
  for (const auto& [name, text] : hard_case_files())
    EXPECT_EQ(kind_of_commands(text).empty(), !name.ends_with(".txt")) << name;
  EXPECT_EQ(kind_of_commands("# a comment\nMOVE 10 0\n"), "commands of Skala's program on the 8080");
  EXPECT_EQ(kind_of_commands("vertex 1 2 3\n"), "edges and vertices of a turn");
  EXPECT_EQ(kind_of_commands("A 0 0 0246\n"), "chains around regions");
  EXPECT_EQ(kind_of_commands("x y z\n1 2 3\n"), "");
  EXPECT_EQ(kind_of_commands("A B C D\n1 2 3 4\n"), "");
  EXPECT_EQ(kind_of_commands("# nothing else"), "");
  EXPECT_EQ(kind_of_commands(""), "");
}

}  // namespace
}  // namespace sightline::compare
