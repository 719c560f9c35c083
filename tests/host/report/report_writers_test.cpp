// The page, CSV and JSON of a small report.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/base/file.hpp"
#include "host/report/html_page.hpp"
#include "host/report/table_text.hpp"
#include "tests/host/report/sample_report.hpp"

namespace sightline::report {
namespace {

// A reader of RFC 4180, by its grammar: records of fields; rejects text outside the grammar.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> records(1, {""});
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"' && records.back().back().empty()) {
      for (++at;; ++at) {
        if (at >= text.size()) throw std::runtime_error("a quoted field does not end");
        if (text[at] == '"' && (at + 1 >= text.size() || text[at + 1] != '"')) break;
        if (text[at] == '"') ++at;
        records.back().back() += text[at];
      }
      if (at + 1 < text.size() && text[at + 1] != ',' && text[at + 1] != '\r')
        throw std::runtime_error("text after a quoted field");
    } else if (text[at] == ',') {
      records.back().emplace_back();
    } else if (text.compare(at, 2, "\r\n") == 0) {
      ++at;
      if (at + 1 < text.size()) records.push_back({""});
    } else if (text[at] == '\r' || text[at] == '\n' || text[at] == '"') {
      throw std::runtime_error("a bare quotation mark or line end");
    } else {
      records.back().back() += text[at];
    }
  }
  return records;
}

TEST(ReportCsv, IsReadBackByTheRulesOfRfc4180) {
  const auto records = read_csv(csv_text(sample_table()));
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[0], (std::vector<std::string>{"name", "count", "view_s", "host_ns", "right"}));
  EXPECT_EQ(records[1], (std::vector<std::string>{nasty, "1048576", "0.1", "1000000000", "yes"}));
  EXPECT_EQ(records[2], (std::vector<std::string>{"plain", "-12", "", "0.5", "no, 3 px"}));
  EXPECT_EQ(records[3], (std::vector<std::string>{"", "0", "", "2", ""}));
}

TEST(ReportJson, CarriesEveryCellByItsKey) {
  const auto document = nlohmann::json::parse(json_text(sample_table()));
  EXPECT_EQ(document["schema"], "sightline/table/1");
  EXPECT_EQ(document["columns"][2]["unit"], "s");
  ASSERT_EQ(document["rows"].size(), 3U);
  EXPECT_EQ(document["rows"][0]["name"], nasty);
  EXPECT_EQ(document["rows"][0]["view_s"], 0.1);
  EXPECT_EQ(document["rows"][1]["right"]["good"], false);
  EXPECT_TRUE(document["rows"][2]["view_s"].is_null());
}

TEST(ReportJson, ShowsInvalidUtf8AsFarAsPossible) {
  Table table = sample_table();
  table.rows[0][0] = std::string("\xff");
  EXPECT_EQ(nlohmann::json::parse(json_text(table))["rows"][0]["name"], "\uFFFD");
}

TEST(ReportCells, AreShownForPeople) {
  EXPECT_EQ(cell_text(std::int64_t{1234}), "1234");
  EXPECT_EQ(cell_text(std::int64_t{1048576}), "1\u202f048\u202f576");
  EXPECT_EQ(cell_text(std::int64_t{-123456}), "-123\u202f456");
  EXPECT_EQ(cell_text(Real{2.0 / 3, 3}), "0.667");
  EXPECT_EQ(cell_text(Real{-1234567.25, 1}), "-1\u202f234\u202f567.2");
  EXPECT_EQ(cell_text(Real{1004004, 0}), "1\u202f004\u202f004");
  EXPECT_EQ(cell_text(Real{1234.5, 2}), "1234.50");
  EXPECT_EQ(cell_text(Real{0.000012345}), "1.234e-05");
  EXPECT_EQ(cell_text(Cell{}), "\u2013");
}

TEST(ReportPage, EscapesEverythingThatIsSaid) {
  EXPECT_EQ(escape_html("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  EXPECT_EQ(escape_html("caf\u00e9 \u2013 \U0001F600"), "caf\u00e9 \u2013 \U0001F600");
  // A lone byte, an overlong slash, a surrogate, a cut character, a control.
  EXPECT_EQ(escape_html("\xff"), "\uFFFD");
  EXPECT_EQ(escape_html("\xc0\xaf"), "\uFFFD\uFFFD");
  EXPECT_EQ(escape_html("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(escape_html("a\xe2\x82"), "a\uFFFD\uFFFD");
  EXPECT_EQ(escape_html(std::string_view("\0\x7f", 2)), "\uFFFD\uFFFD");
  const std::string page = html_page(sample_report());
  EXPECT_EQ(page.find("<b>\"A"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;&quot;A &amp; B&quot;, &#39;C&#39;&lt;/b&gt;"), std::string::npos);
}

// The examples of RFC 4648, section 10.
TEST(ReportPage, HoldsPicturesAsDataUris) {
  const auto base64 = [](std::string_view text) {
    return data_uri("x/y", base::Bytes(text.begin(), text.end()));
  };
  EXPECT_EQ(base64(""), "data:x/y;base64,");
  EXPECT_EQ(base64("f"), "data:x/y;base64,Zg==");
  EXPECT_EQ(base64("fo"), "data:x/y;base64,Zm8=");
  EXPECT_EQ(base64("foo"), "data:x/y;base64,Zm9v");
  EXPECT_EQ(base64("foob"), "data:x/y;base64,Zm9vYg==");
  EXPECT_EQ(base64("foobar"), "data:x/y;base64,Zm9vYmFy");
  EXPECT_EQ(data_uri("x/y", {0xFB, 0xFF, 0xFE}), "data:x/y;base64,+//+");
}

TEST(ReportPage, IsSelfContainedAndLinksToItsParts) {
  const std::string page = html_page(sample_report());
  EXPECT_EQ(page.find("http"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  for (std::size_t at = page.find("src=\""); at != std::string::npos; at = page.find("src=\"", at + 1))
    EXPECT_EQ(page.compare(at + 5, 5, "data:"), 0);
  for (const char* const id : {"sample-part", "sample", "figure", "gallery"}) {
    EXPECT_NE(page.find(std::string("href=\"#") + id + "\""), std::string::npos) << id;
    EXPECT_NE(page.find(std::string("id=\"") + id + "\""), std::string::npos) << id;
  }
  EXPECT_NE(page.find("href=\"tables/sample.csv\""), std::string::npos);
  EXPECT_NE(page.find("href=\"tables/sample.json\""), std::string::npos);
  EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
  EXPECT_NE(page.find("@media print"), std::string::npos);
}

TEST(ReportPage, IsTheSameTwice) {
  EXPECT_EQ(html_page(sample_report()), html_page(sample_report()));
}

TEST(ReportPage, FoldsSections) {
  Report report = sample_report();
  std::get<Table>(report.sections[0].blocks[2]).folded = true;
  const std::string page = html_page(report);
  EXPECT_NE(page.find("<details><summary><h4 id=\"sample\">"), std::string::npos);
  EXPECT_EQ(html_page(sample_report()).find("<details><summary><h4"), std::string::npos);
}

TEST(ReportPage, KeepsHeadingsAndRowNamesVisible) {
  const std::string page = html_page(sample_report());
  EXPECT_NE(page.find("thead th { position: sticky; top: 0"), std::string::npos);
  EXPECT_NE(page.find("tbody th { position: sticky; left: 0"), std::string::npos);
  EXPECT_NE(page.find("<tr><th scope=\"row\">plain</th><td"), std::string::npos);
  EXPECT_NE(page.find("<details class=\"chapter\" id=\"chapter\"><summary><h3>A heading</h3></summary>"), std::string::npos);
}

// Without a filter all cards are shown; a filter hides those of other tables, by style alone.
TEST(ReportPage, ShowsRowsAsCardsWithFilters) {
  const std::string page = html_page(sample_report());
  EXPECT_NE(page.find("<article class=\"card right\">\n<h4>A</h4>"), std::string::npos);
  EXPECT_NE(page.find("<article class=\"card wrong\">\n<h4>B</h4>"), std::string::npos);
  EXPECT_NE(page.find("<dt>Right</dt><dd class=\"bad\">no</dd>"), std::string::npos);
  EXPECT_NE(page.find("section:has(#show-cards-sample:checked) .cards:not(#cards-cards-sample) { display: none; }"), std::string::npos);
  EXPECT_NE(page.find("id=\"show-cards-sample\"> &lt;b&gt;"), std::string::npos);
  std::size_t details = 0;
  std::size_t ends = 0;
  for (std::size_t at = page.find("<details"); at != std::string::npos; at = page.find("<details", at + 1)) ++details;
  for (std::size_t at = page.find("</details>"); at != std::string::npos; at = page.find("</details>", at + 1)) ++ends;
  EXPECT_EQ(details, ends);
  Report other = sample_report();
  other.sections[0].blocks.pop_back();
  EXPECT_EQ(html_page(other).find("<form"), std::string::npos);
}

TEST(ReportPage, ReportsFailedClaims) {
  Report report = sample_report();
  std::get<Table>(report.sections[0].blocks[2]).notes = {CheckedText("It is fast.", {"\"It is small.\" needs x < 1; here x is 2"})};
  const std::string page = html_page(report);
  EXPECT_NE(page.find("1 of the page's statements"), std::string::npos) << page.substr(0, 9000);
  EXPECT_NE(page.find("<p class=\"bad\">Not in this run: &quot;It is small.&quot; needs x &lt; 1; here x is 2</p>"),
            std::string::npos);
  EXPECT_EQ(html_page(sample_report()).find("statements do not hold"), std::string::npos);
}

}  // namespace
}  // namespace sightline::report
