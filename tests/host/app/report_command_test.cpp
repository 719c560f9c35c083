// `sightline report` as a user runs it: the page and tables of one part, and errors.
#include <nlohmann/json.hpp>

#include "tests/host/app/command_line.hpp"

namespace sightline::test {
namespace {

class ReportCommand : public CommandLine {};

TEST_F(ReportCommand, WritesThePageAndTheTablesOfAPart) {
  const Ran ran = sightline({"report", "--part", "1", "--no-host-times", "-o", "one"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, "one/index.html\n");
  const std::string page = read("one/index.html");
  EXPECT_NE(page.find("Jones 1971: every number for time"), std::string::npos);
  EXPECT_EQ(page.find("What the scene needed"), std::string::npos);
  const auto views = nlohmann::json::parse(read("one/tables/jones-views.json"));
  EXPECT_EQ(views["rows"].size(), 10U);
  EXPECT_EQ(views["rows"][0]["scene"], "house");
}

TEST_F(ReportCommand, RejectsAnUnknownPart) {
  const Ran ran = sightline({"report", "--part", "77"});
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_NE(ran.err.find("--part: found 77, expected one of 1, "), std::string::npos) << ran.err;
  EXPECT_TRUE(files().empty());
}

TEST_F(ReportCommand, ReportsAnUnwritableOutputBeforeMeasuring) {
  write("taken", "mine");
  const Ran ran = sightline({"report", "-o", "taken"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_NE(ran.err.find("taken: cannot make a directory"), std::string::npos) << ran.err;
  EXPECT_EQ(read("taken"), "mine");
  EXPECT_EQ(files(), (std::vector<std::string>{"taken"}));
}

}  // namespace
}  // namespace sightline::test
