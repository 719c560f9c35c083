// Part 3 of the report: no case is missing, and what claims to be exact is right in every one.
#include "host/report/hard_cases/hard_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "host/report/hard_cases/jones.hpp"
#include "host/report/hard_cases/segments.hpp"
#include "host/report/hard_cases/skala.hpp"
#include "host/report/html_page.hpp"
#include "host/report/table_text.hpp"

namespace sightline::harness::report {
namespace {

const Section& section() {
  static const Section made = [] {
    auto outcome = hard_cases({});
    if (!outcome) ADD_FAILURE() << outcome.error().message;
    return outcome.has_value() ? std::move(*outcome) : Section{};
  }();
  return made;
}

const Table& table(const std::string& id) {
  for (const Block& block : section().blocks) {
    if (const auto* const found = std::get_if<Table>(&block); found != nullptr && found->id == id)
      return *found;
  }
  static const Table none;
  ADD_FAILURE() << "no table " << id;
  return none;
}

std::size_t column(const Table& table, const std::string& key) {
  const auto found =
      std::find_if(table.columns.begin(), table.columns.end(), [&](const Column& c) { return c.key == key; });
  EXPECT_NE(found, table.columns.end()) << key;
  return static_cast<std::size_t>(found - table.columns.begin());
}

std::map<std::string, std::string> rows_by_case(const Table& table) {
  std::map<std::string, std::string> rows;
  for (const auto& row : table.rows) rows[shown_text(row[0])] += shown_text(row[1]) + " ";
  return rows;
}

bool good(const Cell& cell) {
  return std::holds_alternative<Verdict>(cell) && std::get<Verdict>(cell).good;
}

// Cases whose cell is not a judgement: the reason must be said.
std::set<std::string> not_applicable(const Table& table, const std::string& key) {
  std::set<std::string> cases;
  const std::size_t at = column(table, key);
  for (const auto& row : table.rows) {
    if (std::holds_alternative<Verdict>(row[at])) {
      EXPECT_TRUE(good(row[at])) << shown_text(row[0]) << ' ' << shown_text(row[1]) << ", " << key << ": "
                                 << shown_text(row[at]);
    } else {
      EXPECT_TRUE(shown_text(row[at]).starts_with("not applicable: ")) << shown_text(row[1]) << ", " << key;
      cases.insert(shown_text(row[1]));
    }
  }
  return cases;
}

using Files = std::set<std::string>;

TEST(HardCases, EveryOneHasItsRow) {
  const auto jones = rows_by_case(table("hard-cases-jones"));
  for (int i = 1; i <= 17; ++i) EXPECT_TRUE(jones.contains("J" + std::to_string(i))) << i;
  EXPECT_EQ(jones.size(), 17U);
  const auto skala = rows_by_case(table("hard-cases-skala"));
  for (int i = 1; i <= 16; ++i) EXPECT_TRUE(skala.contains("S" + std::to_string(i))) << i;
  EXPECT_EQ(skala.size(), 16U);
}

TEST(HardCases, ExactBuildsOfCellsAndOpeningsAreRight) {
  const Table& jones = table("hard-cases-jones");
  EXPECT_EQ(not_applicable(jones, "native"), Files{});
  // An eye on a face.
  EXPECT_EQ(not_applicable(jones, "exact"), Files{"J3.json"});
  EXPECT_EQ(not_applicable(jones, "oracle"), Files{"J3.json"});
}

TEST(HardCases, NativeSlicesAreRight) {
  const Table& skala = table("hard-cases-skala");
  EXPECT_EQ(not_applicable(skala, "native"),
            (Files{"S4.txt", "S5.txt", "S6.txt", "as described", "S8-backwards.txt", "S10.txt", "S13.txt",
                   "S13.csv", "S14.txt"}));
  EXPECT_EQ(not_applicable(skala, "oracle"), (Files{"S5.csv", "S10.csv", "S13.csv"}));
}

// The program and its twin may be wrong, but not differently.
TEST(HardCases, ProgramsAreTheirTwins) {
  for (const char* id : {"hard-cases-jones", "hard-cases-skala"}) {
    const Table& cases = table(id);
    const std::size_t guest = column(cases, "guest");
    for (const auto& row : cases.rows)
      EXPECT_EQ(shown_text(row[guest]).find("not its twin"), std::string::npos) << shown_text(row[1]);
  }
}

// What the small machines cost, measured: a window that rounds to nothing, commands in the wrong order.
TEST(HardCases, ProgramsDifferWhereTheirNumbersEnd) {
  std::set<std::string> differ;
  for (const char* id : {"hard-cases-jones", "hard-cases-skala"}) {
    const Table& cases = table(id);
    const std::size_t guest = column(cases, "guest");
    for (const auto& row : cases.rows) {
      if (std::holds_alternative<Verdict>(row[guest]) && !good(row[guest])) differ.insert(shown_text(row[1]));
    }
  }
  EXPECT_EQ(differ, (std::set<std::string>{"J11.json", "S8-backwards.txt"}));
}

TEST(HardCases, NativeJonesNeverFailsWithinItsCoordinates) {
  const Table& families = table("hard-cases-jones-first-failures");
  const std::size_t build = column(families, "build");
  const std::size_t what = column(families, "what");
  std::size_t native = 0;
  for (const auto& row : families.rows) {
    if (shown_text(row[build]) != "native Jones") continue;
    ++native;
    EXPECT_TRUE(good(row[what])) << shown_text(row[0]) << ": " << shown_text(row[what]);
  }
  EXPECT_EQ(native, 4U);
}

// Half a row of rounding is half of 1 / (difference of slopes) columns.
TEST(HardCases, CrossingsAreWithinTheirBound) {
  const Table& families = table("hard-cases-skala-first-failures");
  const std::size_t bound = column(families, "off_by_bound");
  for (const auto& row : families.rows) EXPECT_EQ(shown_text(row[bound]), "none") << shown_text(row[1]);
}

TEST(HardCases, EveryInputIsInThePage) {
  std::set<std::string> listed;
  for (const Block& block : section().blocks) {
    if (const auto* const listing = std::get_if<Listing>(&block)) {
      EXPECT_FALSE(listing->text.empty()) << listing->file;
      EXPECT_TRUE(listed.insert(listing->file).second) << listing->file;
    }
  }
  for (const JonesHardCase& hard : jones_hard_cases()) EXPECT_TRUE(listed.contains(std::string(hard.file)));
  for (const SkalaHardCase& hard : skala_hard_cases())
    EXPECT_TRUE(hard.file.empty() || listed.contains(std::string(hard.file))) << hard.file;
  for (const auto& [file, text] : hard_case_files()) EXPECT_TRUE(listed.contains(std::string(file))) << file;
}

TEST(HardCases, AListingIsShownAndCanBeSaved) {
  Report report;
  report.sections.push_back({"s", "S", {Listing{"a", "a.txt", "x < y\n"}}});
  const std::string page = html_page(report);
  EXPECT_NE(page.find("<details id=\"a\"><summary>a.txt</summary>"), std::string::npos);
  EXPECT_NE(page.find("<a download=\"a.txt\" href=\"data:text/plain;base64,eCA8IHkK\">"), std::string::npos);
  EXPECT_NE(page.find("<pre>x &lt; y\n</pre>"), std::string::npos);
}

// The judge of lines must be able to say no.
TEST(HardCases, SegmentsAreSeenWholeInPartOrNotAtAll) {
  scene::PolyScene scene;
  scene.vertices = {{0, 0, 5}, {10, 0, 5}, {20, 0, 5}, {0, 7, 5}};
  const SceneSegment segment{{20, 0, 5}, {0, 0, 5}};
  picture::LinePicture picture;
  EXPECT_EQ(seen_of(segment, picture, scene), SegmentSeen::nothing);
  picture.pieces = {{{0, 1}, 0, 1}, {{0, 3}, 0, 1}, {{1, 2}, 0, {1, 3}}};
  EXPECT_EQ(seen_of(segment, picture, scene), SegmentSeen::in_part);
  picture.pieces.push_back({{1, 2}, {1, 3}, 1});
  EXPECT_EQ(seen_of(segment, picture, scene), SegmentSeen::whole);
  EXPECT_EQ(seen_of({{0, 1, 5}, {20, 1, 5}}, picture, scene), SegmentSeen::nothing);
}

}  // namespace
}  // namespace sightline::harness::report
