// `sightline demo`: both machines on all built-in scenes, in a dozen lines, as a page and as JSON. Each run takes seconds.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::has;
using sightline::test::Ran;

class DemoCommand : public sightline::test::CommandLine {};

// Names of files in attributes of the page, such as src="...".
std::vector<std::string> named_in(const std::string& page, const std::string& attribute) {
  std::vector<std::string> names;
  const std::string start = " " + attribute + "=\"";
  for (std::size_t at = page.find(start); at != std::string::npos; at = page.find(start, at + 1))
    names.push_back(page.substr(at + start.size(), page.find('"', at + start.size()) - at - start.size()));
  return names;
}

TEST_F(DemoCommand, PrintsADozenLinesAndWritesThePageWithItsPictures) {
  const Ran ran = sightline({"demo", "-o", "pictures", "--no-host-times"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_LE(std::count(ran.out.begin(), ran.out.end(), '\n'), 12) << ran.out;
  EXPECT_FALSE(has(ran.out, "WRONG")) << ran.out;
  for (const char* text :
       {"Jones 1971 on the PDP-7: a view in ", "\"a few seconds\"", "% different along lines, points up to ", "still views right in 7 of 7", "right in 5 of 5", "Plantinga 1990 on the PDP-7: ",
        "Willis 1977 on the 8080: ", "Montani and Re 1985 on the 8080: ", "Skala 1985 on the 8080: ", "about 2 s", "about 15 %",
        "CalComp 565", "This computer, exact lines: ", "pictures/index.html"})
    EXPECT_TRUE(has(ran.out, text)) << text << '\n' << ran.out;
  const std::string page = read("pictures/index.html");
  // The line on the paper's 15 % must agree with the rows of its two functions: T-states added per point, relative to T-states
  // per point.
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
    const std::size_t row = page.find(std::string("\n") + said.function);
    ASSERT_NE(row, std::string::npos) << said.function;
    ASSERT_EQ(std::sscanf(page.c_str() + row, " %*s %*f %lf %%", &percent), 1);
    EXPECT_NEAR(said.added / said.point, percent / 100, 0.015) << said.function;
  }
  // The page's links all exist, and the page shows every picture except the drawings for other programs.
  std::set<std::string> named;
  for (const std::string& name : named_in(page, "src")) named.insert(name);
  for (const std::string& name : named_in(page, "href")) EXPECT_TRUE(named.contains(name)) << name;
  for (const std::string& name : named) EXPECT_TRUE(exists("pictures/" + name)) << name;
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path("pictures"))) {
    const std::string name = entry.path().filename().string();
    pictures += name != "index.html";
    EXPECT_GT(entry.file_size(), 300U) << name;
    EXPECT_TRUE(!name.ends_with(".png") || named.contains(name)) << name;
  }
  // Five scenes in four ways; three walks in three; eight functions in four ways and one plot in three; three scenes in stripes, one also
  // with smooth edges; two turns.
  EXPECT_EQ(pictures, 5 * 4 + 3 * 3 + 8 * 4 + 3 + 4 + 2);
  for (const char* text : {"How fast?", "How wrong?", "Against what?", "jones-pdp7", "corridor32", "boxes-8, parallel", "rosen",
                           "turn-pdp7", "<details>", "nothing wrong", ">near 0 %</text>", ">8 of 8</td>", "prefers-color-scheme: dark", "name=\"viewport\"", "class=\"answer-plot\"",
                           "jones-pdp7 without EAE", "A solid turning on the PDP-7", "A walk from cell to cell on the PDP-7", "turning about other axes", "roberts-perspective.apng", "between its samples the function is up to"})
    EXPECT_TRUE(has(page, text)) << text;
  for (const char* text : {"<script", "http://www.example", "https://", ">0 of 8</td>", ">error 0</text>", "time here", " us</", "&#181;"})
    EXPECT_FALSE(has(page, text)) << text;
  // The same bytes again.
  const Ran again = sightline({"demo", "-o", "pictures2", "--no-host-times"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  for (const auto& entry : std::filesystem::directory_iterator(path("pictures"))) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(read("pictures/" + name), read("pictures2/" + name)) << name;
  }
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
  ASSERT_EQ(document.at("walks").size(), 6U);
  for (const json& walk : document.at("walks")) {
    EXPECT_GE(walk.at("cells_entered").get<int>(), walk.at("rotation").get<bool>() ? 2 : 3) << walk;
    EXPECT_LE(walk.at("core_words_used").get<int>(), 8192);
  }
  ASSERT_EQ(document.at("turns").size(), 4U);
  ASSERT_EQ(document.at("circles").size(), 2U);
  for (const json& circle : document.at("circles")) {
    EXPECT_EQ(circle.at("right"), circle.at("frames"));
    EXPECT_GE(circle.at("events").get<int>(), 6) << "faces in three directions, each seen edge-on twice: " << circle;
  }
  ASSERT_EQ(document.at("flights").size(), 4U);
  for (const json& flight : document.at("flights"))
    EXPECT_GE(flight.at("frames_per_second_mean").get<double>(), flight.at("bits") == 8 ? 23 : 12);
  for (const json& turn : document.at("turns")) EXPECT_GT(turn.at("frames_per_second_worst").get<double>(), 15);
  ASSERT_EQ(document.at("skala").size(), 8U);
  for (const json& row : document.at("skala")) EXPECT_GT(row.at("lines").at("t_states").get<std::int64_t>(), 0);
  ASSERT_EQ(document.at("stripes").size(), 5U);
  for (const json& row : document.at("stripes")) EXPECT_GT(row.at("drawing_seconds").get<double>(), 0.1);
  EXPECT_GT(document.at("skala_plot").at("seconds").get<double>(), 10.0);
  EXPECT_EQ(document.at("compared").at("agrees"), true);
  EXPECT_EQ(document.at("compared").at("scenes").size(), 5U + 2U + 8U);
  // The table has all methods of the five papers, and both host and emulated times.
  std::set<std::string> methods;
  for (const json& row : document.at("table")) {
    methods.insert(row.at("method").get<std::string>());
    EXPECT_TRUE(row.at("method") != "exact" || row.at("host_s").at("greatest").get<double>() > 0) << row;
    EXPECT_TRUE(row.at("method") != "jones-pdp7" || row.at("emulated_s").at("greatest").get<double>() > 0) << row;
  }
  for (const char* method : {"jones-pdp7", "exact", "jones", "montani-re", "willis", "plantinga", "turn-pdp7", "willis-8080",
                             "stripes-8080", "skala-8080", "skala"})
    EXPECT_TRUE(methods.contains(method)) << method;
  std::set<std::string> computers;
  for (const json& point : document.at("plot")) computers.insert(point.at("computer").get<std::string>());
  EXPECT_EQ(computers, (std::set<std::string>{"emulated", "this"}));
  // Two lines have no judged picture.
  std::size_t judged = 0;
  for (const json& verdict : document.at("verdicts")) {
    judged += !verdict.at("right").is_null();
    EXPECT_NE(verdict.at("right"), false) << verdict;
    EXPECT_LE(verdict.at("text").get<std::string>().size() + verdict.at("verdict").get<std::string>().size(), 160U) << verdict;
  }
  EXPECT_EQ(judged, document.at("verdicts").size() - 2);
  // Every function has a distance from the lines between its samples.
  for (const json& row : document.at("table"))
    EXPECT_EQ(row.contains("chord"), row.at("method").get<std::string>().starts_with("skala")) << row;
  EXPECT_EQ(document.at("page"), "f\xEF\xBF\xBD/index.html");
}

}  // namespace
