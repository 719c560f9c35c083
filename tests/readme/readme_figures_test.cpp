// The figures in host/manual/findings.md, section "The papers, and what we found", are those that the commands named there print,
// to the last place. README.md repeats some of them, and shows the table and the plot of `sightline demo`. The sentences below have
// # in the place of figures: the texts alone contain the figures. What the papers say, and how a command is called, is not measured:
// EveryFigureIsTested lists it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/host/app/command_line.hpp"

namespace sightline::test {
namespace {

using nlohmann::json;
using Figures = std::vector<std::string>;

constexpr const char* papers = "The papers, and what we found";
constexpr std::string_view default_views = "the default views of five scenes take # to # s with the EAE and # to # s without it";
constexpr std::string_view default_errors =
    "On the screen # to # % of the visible length differs, none of it by more than a point";
constexpr std::string_view random_times =
    "From 1,000 random camera positions in street4 a view takes # s in the median and # s at most, and without the EAE # and # s";
constexpr std::string_view random_errors = "From 4,000 camera positions # views are wrong by more than a point; the worst is wrong in # of # points";
constexpr std::string_view flight_8 =
    "orders # pieces of a town and loads their priorities, with coordinates of 8 bits, # times a second (worst frame #) on a "
    "flight of # "
    "frames, and # times (worst #) if the same path takes 60 frames";
constexpr std::string_view flight_16 = "With coordinates of 16 bits it reaches # times (worst #), or # times (worst #) for the 92 nearest pieces";
constexpr std::string_view flight_facing = "all # pieces with 16 bits are shown # times (worst #; `--bits 16 --facing`)";
constexpr std::string_view normals = "wrong: # of # pairs contradict it";
constexpr std::string_view baselines = "a frame has # to # points on lines of sight for each distance, but only # to # nodes of a BSP tree";
constexpr std::string_view pairs = "that product grows with the power # to # of the number of faces";
constexpr std::string_view stripes = "which have sixty visible faces, on a raster board in # s, and twenty touching bricks in # s";
constexpr std::string_view lines = "| lines, 60 slices of 33 points | # to # | # to # | # to # | # to # |";
constexpr std::string_view long_lines = "| lines, 30 slices of 256 points | # to # | # to # | # to # | # to # |";
constexpr std::string_view surfaces = "| surfaces, 60 slices of 33 points | # to # | # to # | # to # | # to # |";
constexpr std::string_view contours = "| contours, 33 slices of 33 points | # to # | # to # | # to # | # to # |";
constexpr std::string_view contour_dots = "of the # dots of sinc, # are more than a point from any visible contour";
constexpr std::string_view events = "those made here after its description have # to #";
constexpr std::string_view block = "| block of # edges | #, # | # | #, # | # |";
constexpr std::string_view roberts = "| roberts, a notched block of # edges | #, # | # | #, # | # |";
constexpr std::string_view star = "| star of # edges | #, # | # | #, # | # |";
constexpr std::array sentences{default_views, default_errors, random_times, random_errors, flight_8,   flight_16,
                               flight_facing, normals,       baselines,      pairs,          stripes,      lines,         long_lines, surfaces,
                               contours,      contour_dots,   events,       roberts,       block,         star};

std::string replaced(const std::string& text, const char* pattern, const char* by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

std::string text_of(const std::string& file) {
  std::ifstream stream(std::string(SIGHTLINE_SOURCE_DIR) + '/' + file);
  std::stringstream whole;
  whole << stream.rdbuf();
  return whole.str();
}

// The section of the file with this title, every stretch of white space one blank.
std::string section(const std::string& file, const std::string& title) {
  const std::string text = text_of(file);
  const std::size_t begin = text.find("## " + title + '\n');
  const std::size_t end = text.find("\n## ", begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  return replaced(text.substr(begin, end - begin), "\\s+", " ");
}

std::regex pattern_of(std::string_view sentence) {
  const std::string literal = replaced(std::string(sentence), R"([|().+*?\[\]\\])", R"(\$&)");
  return std::regex(replaced(literal, "#", R"(([-+]?[0-9][0-9,]*(?:\.[0-9]+)?))"));
}

std::string shown(double value, int places) {
  return fmt::format("{:.{}f}", value, places);
}

std::string count(std::int64_t value) {  // 2,484
  std::string digits = fmt::format("{}", value);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

class ReadmeFigures : public CommandLine {
 protected:
  // What the command prints with --json. findings.md shows each word of `command` as code; `unnamed` are further arguments.
  json run(const std::string& command, const Arguments& unnamed = {}) {
    std::istringstream words(command);
    Arguments arguments;
    for (std::string word; words >> word;) {
      EXPECT_TRUE(std::regex_search(text_, std::regex("`([^`]*[ /])?" + word + "[ `]")))
          << word << " of " << command << ": not named";
      if (word.starts_with("host/")) word = std::string(SIGHTLINE_SOURCE_DIR) + '/' + word;
      arguments.push_back(word);
    }
    return run(arguments, unnamed);
  }
  json run(Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.emplace_back("--json");
    const Ran ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out);
  }

  void expect_figures(std::string_view sentence, const Figures& measured) const {
    std::smatch found;
    ASSERT_TRUE(std::regex_search(text_, found, pattern_of(sentence))) << "findings.md does not say: " << sentence;
    ASSERT_EQ(found.size(), measured.size() + 1) << sentence;
    for (std::size_t i = 0; i < measured.size(); ++i)
      EXPECT_EQ(found[i + 1].str(), measured[i]) << "findings.md, figure " << i + 1 << " of: " << sentence;
  }

  const std::string text_ = section("host/manual/findings.md", papers);
};

// Least and greatest of what has been added.
struct Range {
  std::vector<double> values;

  void add(double value) { values.push_back(value); }
  void write(Figures& figures, int places) const {
    figures.push_back(shown(*std::min_element(values.begin(), values.end()), places));
    figures.push_back(shown(*std::max_element(values.begin(), values.end()), places));
  }
  // In whole per cent, with the sign.
  void write_signed(Figures& figures) const {
    figures.push_back(fmt::format("{:+.0f}", *std::min_element(values.begin(), values.end())));
    figures.push_back(fmt::format("{:+.0f}", *std::max_element(values.begin(), values.end())));
  }
};

TEST_F(ReadmeFigures, JonesFromTheDefaultViews) {
  Figures times;
  Figures errors;
  for (const std::string option : {"", " --no-eae"}) {
    const json compared =
        run("compare house roberts street4 corridor8 corridor32" + option, {"--methods", "jones-pdp7", "--no-host-times"});
    Range seconds;
    Range wrong;
    for (const json& row : compared.at("table")) {
      EXPECT_EQ(row.at("method"), "jones-pdp7");
      seconds.add(row.at("emulated_s").at("median"));
      wrong.add(row.at("wrong_percent").at("median"));
      EXPECT_EQ(row.at("far").at("greatest"), 0) << row;
    }
    EXPECT_EQ(seconds.values.size(), 5U);
    seconds.write(times, 2);
    if (option.empty()) wrong.write(errors, 1);
  }
  expect_figures(default_views, times);
  expect_figures(default_errors, errors);
}

TEST_F(ReadmeFigures, JonesFromRandomEyes) {
  Figures times;
  for (const std::string option : {"", " --no-eae"}) {
    const json atlas = run("atlas street4 --views 1000" + option);
    for (const char* what : {"median", "greatest"}) times.push_back(shown(atlas.at("emulated_seconds").at(what), 2));
  }
  expect_figures(random_times, times);
  const json atlas = run("atlas street4 --views 4000");
  const double all = atlas.at("views").at(atlas.at("worst").at("view").get<std::size_t>()).at("true_length");
  expect_figures(random_errors, {count(atlas.at("wrong")), shown(atlas.at("wrong_points").at("greatest"), 0),
                                 count(static_cast<std::int64_t>(all + 0.5))});
}

TEST_F(ReadmeFigures, WillisInFlight) {
  const auto add = [](Figures& figures, const json& flight) {
    figures.push_back(shown(flight.at("frames_per_second_mean"), 1));
    figures.push_back(shown(flight.at("frames_per_second_worst"), 1));
  };
  const json slow = run("flight town-20");
  Figures of_8{count(slow.at("pieces"))};
  add(of_8, slow);
  of_8.push_back(count(slow.at("frames")));
  add(of_8, run("flight town-20 --frames 60"));
  expect_figures(flight_8, of_8);
  Figures of_16;
  add(of_16, run("flight town-20 --bits 16"));
  add(of_16, run("flight town-20 --bits 16 --pieces 92"));
  expect_figures(flight_16, of_16);
  const json facing = run("flight town-20 --bits 16 --facing");
  Figures of_facing{count(facing.at("pieces"))};
  add(of_facing, facing);
  expect_figures(flight_facing, of_facing);
}

TEST_F(ReadmeFigures, StripesOnTheBoard) {
  Figures seconds;
  for (const std::string scene : {"boxes-20", "bricks-20"}) {
    const json drawn = run("stripes " + scene);
    EXPECT_EQ(drawn.at("faces"), 60);
    seconds.push_back(shown(drawn.at("receiving_seconds").get<double>() + drawn.at("priority_seconds").get<double>() +
                                drawn.at("drawing_seconds").get<double>(),
                            1));
  }
  expect_figures(stripes, seconds);
}

TEST_F(ReadmeFigures, SkalaOnBothBoards) {
  const std::vector<std::pair<std::string_view, std::string>> pictures{
      {lines, "lines sinc"},
      {long_lines, "lines sinc --slices 30 --points 256 --rotate 0"},
      {surfaces, "surface sinc"},
      {contours, "contours sinc"}};
  for (const auto& [sentence, picture] : pictures) {
    Figures figures;
    for (const std::string board : {"", " --device alt256"}) {
      Range seconds;
      Range cost;
      for (const std::string function : {"sinc", "rogers", "peaks", "franke", "saddle", "cosr", "step", "rosen"}) {
        json drawn;
        if (function == "sinc") {
          drawn = run("skala " + picture + board);
        } else {
          std::istringstream words("skala " + replaced(picture, "sinc", function.c_str()) + board);
          Arguments arguments;
          for (std::string word; words >> word;) arguments.push_back(word);
          drawn = run(arguments, {});
        }
        seconds.add(drawn.at("seconds"));
        cost.add(drawn.at("visibility_cost_per_cent"));
      }
      seconds.write(figures, 2);
      cost.write_signed(figures);
    }
    expect_figures(sentence, figures);
  }
}

TEST_F(ReadmeFigures, SkalasContours) {
  const json compared = run("compare sinc --picture contours", {"--no-host-times"});
  const json& guest = compared.at("scenes").at(0).at("pictures").at(0);
  ASSERT_EQ(guest.at("name"), "skala-8080");
  expect_figures(contour_dots, {count(guest.at("unrounded").at("dots")), count(guest.at("unrounded").at("dots_beyond_1"))});
}

TEST_F(ReadmeFigures, SolidsTurning) {
  for (const auto& [sentence, model] : {std::pair(roberts, "roberts"), std::pair(block, "block.off"), std::pair(star, "star.off")}) {
    Figures figures;
    for (const bool eae : {true, false}) {
      const bool built_in = sentence == roberts;
    Arguments arguments{"turn", built_in ? std::string(model) : std::string(SIGHTLINE_SOURCE_DIR) + "/host/examples/turn/" + model};
      if (!eae) arguments.emplace_back("--no-eae");
      const json turn = run(arguments, {});
      if (eae) figures.push_back(count(turn.at("edges")));
      figures.push_back(shown(turn.at("frames_per_second_mean"), 0));
      figures.push_back(shown(turn.at("frames_per_second_worst"), 0));
      figures.push_back(shown(turn.at("cost_against_wire_frame"), 2));
    }
    expect_figures(sentence, figures);
  }
}

TEST_F(ReadmeFigures, FromTheReport) {
  const std::filesystem::path report = std::filesystem::path(command_of_this_build()).parent_path() / "sightline-report";
  if (!std::filesystem::exists(report)) GTEST_SKIP() << "this build has no report";
  const Ran ran = sightline({"report", "--part", "1", "--no-host-times", "-o", "one"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  // The row of a table whose text in this column contains these words.
  const auto row = [this](const std::string& table, const char* column, const char* words) {
    const json rows = json::parse(read("one/tables/" + table + ".json")).at("rows");
    for (const json& one : rows)
      if (one.at(column).get<std::string>().find(words) != std::string::npos) return one;
    ADD_FAILURE() << table << " has no row of " << words;
    return json();
  };
  const auto both = [](const json& claim) {
    return Figures{shown(claim.at("here_least"), 1), shown(claim.at("here_greatest"), 1)};
  };
  expect_figures(events, both(row("plantinga-claims", "unit", "events an edge")));
  expect_figures(pairs, both(row("montani-re-paper", "unit", "exponent of N Y over N")));
  const json points = row("willis-paper", "unit", "points, distances");
  Figures of_distances = both(row("willis-paper", "unit", "nodes, distances"));
  of_distances.insert(of_distances.begin(), {count(std::lround(points.at("here_least").get<double>())), count(std::lround(points.at("here_greatest").get<double>()))});
  expect_figures(baselines, of_distances);
  std::smatch found;
  const std::string contradicted =
      replaced(row("willis-paper", "says", "their normals").at("comparison").get<std::string>(), "\u202f", "");
  ASSERT_TRUE(std::regex_search(contradicted, found, std::regex("([0-9]+) of ([0-9]+) pairs"))) << contradicted;
  expect_figures(normals, {count(std::stoll(found[1].str())), count(std::stoll(found[2].str()))});
}

// Without commands, quotations and titles the text has no figure but these: settings, the machines' names and what the papers say.
void expect_no_figure(std::string rest) {
  for (const char* part : {"`[^`]*`", "\"[^\"]*\"", "\\*\\*[^*]*\\*\\*"}) rest = replaced(rest, part, "");
  for (const char* known : {"PDP-7", "8080", "3 MHz", "2\\.45 GHz", "EF9365", "ALT-256",                        // machines
                            "25 frames a second for hundreds", "within 90 degrees", "about 2 s", "costs 15 %",  // the papers
                            "fewer than 16\\.3 events"})
    rest = replaced(rest, known, "");
  std::smatch found;
  EXPECT_FALSE(std::regex_search(rest, found, std::regex("[^.]*[0-9][^.]*"))) << "no test of: " << found.str();
}

// The table of README.md: for each method the least and the greatest emulated time and difference of the views of `sightline demo`, and
// in how many of them something is wrong. The plot is that of the page which the command writes.
TEST_F(ReadmeFigures, TableAndPlotOfTheDemo) {
  const json demo = run(Arguments{"demo", "--no-host-times", "-o", "demo"}, {});
  const std::string readme = section("README.md", "How fast, how wrong");
  for (const auto& [title, method, picture] : {std::tuple("Jones 1971, PDP-7, lines", "jones-pdp7", "lines"),
                                               std::tuple("Willis 1977, 8080, faces", "willis-8080", "faces"),
                                               std::tuple("Montani and Re 1985, 8080, faces", "stripes-8080", "faces"),
                                               std::tuple("Montani and Re 1985, 8080, pen plotter", "stripes-8080 pen", "lines"),
                                               std::tuple("Skala 1985, 8080, dots", "skala-8080", "dots"),
                                               std::tuple("Plantinga, Seales and Dyer 1990, PDP-7, lines", "turn-pdp7", "lines"),
                                               std::tuple("exact, this computer, lines", "exact", "lines")}) {
    Range seconds;
    Range different;
    int views = 0;
    int wrong = 0;
    for (const json& row : demo.at("table")) {
      if (row.at("method") != method || row.at("picture") != picture) continue;
      if (row.contains("emulated_s")) seconds.add(row.at("emulated_s").at("median"));
      different.add(row.at("wrong_percent").at("median"));
      views += row.at("views").get<int>();
      wrong += row.at("views").get<int>() - row.at("right").get<int>();
    }
    ASSERT_GT(views, 0) << method;
    std::string expected = fmt::format("| {} | ", title);
    const auto add = [&expected](const Range& range, int places) {
      Figures figures;
      range.write(figures, places);
      expected += fmt::format("{} to {} | ", figures[0], figures[1]);
    };
    if (seconds.values.empty()) expected += "depends on the computer | ";
    else add(seconds, 3);
    add(different, 2);
    expected += std::string_view(picture) == "dots" ? "not counted |" : fmt::format("{} of {} |", wrong, views);
    EXPECT_NE(readme.find(expected), std::string::npos) << "README.md has no row " << expected;
  }
  std::string plot = text_of("tests/data/report/time-error.svg");
  ASSERT_TRUE(plot.ends_with("</svg>\n"));
  plot.pop_back();
  EXPECT_NE(read("demo/index.html").find(plot), std::string::npos) << "the plot is not that of demo/index.html";
}

// A figure of the papers' section in README.md is in a sentence of findings.md, which the tests above check.
TEST_F(ReadmeFigures, TheReadmeRepeatsFindings) {
  std::string rest = section("README.md", papers);
  ASSERT_FALSE(rest.empty());
  for (const std::string_view sentence : {default_views, normals}) {
    std::smatch here;
    std::smatch there;
    ASSERT_TRUE(std::regex_search(rest, here, pattern_of(sentence))) << "README.md does not say: " << sentence;
    ASSERT_TRUE(std::regex_search(text_, there, pattern_of(sentence))) << "findings.md does not say: " << sentence;
    EXPECT_EQ(here.str(), there.str());
    rest = std::regex_replace(rest, pattern_of(sentence), "");
  }
  expect_no_figure(rest);
}

TEST_F(ReadmeFigures, EveryFigureIsTested) {
  std::string rest = text_;
  for (const std::string_view sentence : sentences) rest = std::regex_replace(rest, pattern_of(sentence), "");
  expect_no_figure(rest);
}

}  // namespace
}  // namespace sightline::test
