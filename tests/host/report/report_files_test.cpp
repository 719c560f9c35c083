// A report on disk: its files, and the files that remain after a failure.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "host/base/file.hpp"
#include "host/report/html_page.hpp"
#include "host/report/write_report.hpp"
#include "tests/host/report/sample_report.hpp"

namespace sightline::report {
namespace {

namespace files = std::filesystem;

class ReportFiles : public testing::Test {
 protected:
  ReportFiles() {
    folder_ = files::path(testing::TempDir()) /
              (std::string("report-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    files::remove_all(folder_);
    files::create_directories(folder_);
  }
  ~ReportFiles() override { files::remove_all(folder_); }

  [[nodiscard]] std::set<std::string> found() const {
    std::set<std::string> names;
    for (const auto& entry : files::recursive_directory_iterator(folder_))
      names.insert(files::relative(entry.path(), folder_).string());
    return names;
  }

  files::path folder_;
};

std::string text_of(const files::path& path) {
  const auto bytes = base::read_file(path.string());
  return bytes ? std::string(bytes->begin(), bytes->end()) : "no " + path.string();
}

TEST_F(ReportFiles, AreThePageAndTheTables) {
  const auto written = write_report(sample_report(), (folder_ / "new" / "deep").string());
  ASSERT_TRUE(written);
  EXPECT_EQ(found(), (std::set<std::string>{"new", "new/deep", "new/deep/index.html", "new/deep/tables",
                                            "new/deep/tables/cards-sample.csv", "new/deep/tables/cards-sample.json",
                                            "new/deep/tables/sample.csv", "new/deep/tables/sample.json"}));
  EXPECT_EQ(written->front(), (folder_ / "new/deep/index.html").string());
  EXPECT_EQ(text_of(folder_ / "new/deep/index.html"), html_page(sample_report()));
}

TEST_F(ReportFiles, AFileInTheWayIsAnErrorThatNamesIt) {
  ASSERT_TRUE(base::write_file_atomically((folder_ / "taken").string(), std::string_view("mine")));
  const std::string directory = (folder_ / "taken").string();
  for (const auto& error :
       {prepare_directory(directory).error(), write_report(sample_report(), directory).error()}) {
    EXPECT_EQ(error.kind, base::ErrorKind::io);
    EXPECT_NE(error.message().find(directory), std::string::npos) << error.message();
  }
  EXPECT_EQ(found(), (std::set<std::string>{"taken"}));
}

TEST_F(ReportFiles, NothingRemainsIfOneCannotBeWritten) {
  // Folders where the page should be and where a table should be.
  files::create_directories(folder_ / "a" / "index.html");
  files::create_directories(folder_ / "b" / "tables" / "sample.json");
  const auto before = found();
  for (const char* const name : {"a", "b"}) {
    const auto written = write_report(sample_report(), (folder_ / name).string());
    ASSERT_FALSE(written) << name;
    EXPECT_EQ(written.error().kind, base::ErrorKind::io);
    EXPECT_EQ(found(), before) << name;
  }
  EXPECT_FALSE(prepare_directory((folder_ / "a").string()));
  EXPECT_EQ(found(), before);
}

TEST_F(ReportFiles, AnOlderReportIsReplaced) {
  ASSERT_TRUE(write_report(sample_report(), folder_.string()));
  Report other = sample_report();
  other.sections[0].blocks.pop_back();
  ASSERT_TRUE(write_report(other, folder_.string()));
  EXPECT_EQ(text_of(folder_ / "index.html"), html_page(other));
}

TEST_F(ReportFiles, TheOutputOfAPartIsChecked) {
  const auto refused = [&](auto&& change) {
    Report report = sample_report();
    change(report.sections[0]);
    const auto written = write_report(report, folder_.string());
    return written ? std::string("written") : written.error().message();
  };
  const auto table = [](Section& section) -> Table& { return std::get<Table>(section.blocks[2]); };
  EXPECT_EQ(refused([&](Section& section) { table(section).rows[1].pop_back(); }),
            "sample: row 2: found 4 cells, expected 5");
  EXPECT_EQ(refused([&](Section& section) { table(section).id = "../sample"; }),
            "id \"../sample\": expected a-z, 0-9 and -");
  EXPECT_EQ(refused([&](Section& section) { table(section).id = "figure"; }),
            "id figure: found twice in the report, expected a different id of every section, chapter, table, plot and picture");
  EXPECT_EQ(refused([&](Section& section) { table(section).columns[1].key = "name"; }),
            "sample: two columns name");
  EXPECT_TRUE(found().empty());
}

}  // namespace
}  // namespace sightline::report
