// The data files of the report: expressions, texts with thresholds, tables, plots and galleries made of records, and
// what is said of files that cannot be used.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/layout.hpp"
#include "host/report/render.hpp"
#include "host/report/table_text.hpp"
#include "host/report/text.hpp"

namespace sightline::report {
namespace {

RowSet views() {
  RowSet rows;
  rows.add({{"scene", "house"}, {"eae", true}, {"view_s", 0.5}, {"words", 7000}, {"host_ns", 10}});
  rows.add({{"scene", "house"}, {"eae", false}, {"view_s", 2.0}, {"words", 7001}, {"host_ns", {}}});
  rows.add({{"scene", "street"}, {"eae", true}, {"view_s", 1.5}, {"words", 8000}, {"host_ns", 30}});
  return rows;
}

Scope page() {
  static const RowSet set = views();
  Scope scope;
  scope.set_named = [](std::string_view name) { return name == "views" ? &set : nullptr; };
  return scope;
}

Value value(std::string_view text) {
  return Expression(text).value(page());
}

std::string refusal(std::string_view text) {
  try {
    static_cast<void>(value(text));
  } catch (const Wrong& wrong) {
    return wrong.what();
  }
  return "nothing wrong";
}

TEST(ReportExpressions, TakeValuesOfRows) {
  EXPECT_EQ(value("views.view_s.max"), Value(2.0));
  EXPECT_EQ(value("views.words.min"), Value(7000));
  EXPECT_EQ(value("views.words.sum"), Value(22001));
  EXPECT_EQ(value("views.view_s.mean"), Value(4.0 / 3));
  EXPECT_EQ(value("views.scene.distinct"), Value(2));
  EXPECT_EQ(value("views.scene.last"), Value("street"));
  EXPECT_EQ(value("views.rows"), Value(3));
  EXPECT_EQ(value("views[view_s >= 1].rows"), Value(2));
  EXPECT_EQ(value("views[scene = 'house' and eae = 'no'].view_s"), Value(2.0));
  EXPECT_EQ(value("views[not (scene = 'house' or words < 8000)].words"), Value(8000));
}

TEST(ReportExpressions, Compute) {
  EXPECT_EQ(value("1 + 2 * 3 - 4"), Value(3));
  EXPECT_EQ(value("(1 + 2) * -3"), Value(-9));
  EXPECT_EQ(value("7 / 2"), Value(3.5));
  EXPECT_EQ(value("1 / 0"), Value());
  EXPECT_EQ(value("abs(-2.5)"), Value(2.5));
  EXPECT_EQ(value("min(3, max(1, 2))"), Value(2));
  EXPECT_EQ(value("100 * (views.view_s.max - views.view_s.min) / views.view_s.min"), Value(300.0));
  EXPECT_EQ(value("2 > 1 and not 2 <= 1"), Value(1));
  EXPECT_EQ(value("'a' < 'b'"), Value(1));
}

// What was not measured is not 0, and nothing holds of it.
TEST(ReportExpressions, WhatIsMissingStaysMissing) {
  EXPECT_EQ(value("views.host_ns.min"), Value(10)) << "of those that are there";
  EXPECT_EQ(value("views[eae = 'no'].host_ns + 1"), Value());
  EXPECT_EQ(value("views[eae = 'no'].host_ns <= 100"), Value(0));
  EXPECT_EQ(value("views[eae = 'no'].host_ns is missing"), Value(1));
  EXPECT_EQ(value("views[scene = 'none'].view_s.max"), Value());
}

TEST(ReportExpressions, SayWhatIsWrong) {
  EXPECT_EQ(refusal("views.vew_s.max"),
            "views.vew_s.max: found no key \"vew_s\" in the records, expected one of scene, eae, view_s, words, host_ns");
  EXPECT_NE(refusal("views.view_s").find("views.view_s: found 3 rows, expected 1; choose with [...]"), std::string::npos);
  EXPECT_NE(refusal("views.view_s.most").find("found .most, expected one of min, max"), std::string::npos);
  EXPECT_NE(refusal("rooms.rows").find("found no \"rooms\" among the sets"), std::string::npos);
  EXPECT_NE(refusal("1 +").find("expected a name or a number"), std::string::npos);
  EXPECT_NE(refusal("1 2").find("found \"2\", expected an operator or the end"), std::string::npos);
  EXPECT_NE(refusal("(1").find("expected \")\""), std::string::npos);
  EXPECT_NE(refusal("views.scene.max").find("found words, expected numbers"), std::string::npos);
  EXPECT_NE(refusal("'a").find("a text does not end"), std::string::npos);
  EXPECT_NE(refusal("round(1)").find("expected abs(x)"), std::string::npos);
}

Said said(std::string_view text) {
  return Text(text).said(page());
}

TEST(ReportTexts, HoldValues) {
  EXPECT_EQ(said("{views.view_s.min:1} to {views.view_s.max:3} s").text, "0.5 to 2.000 s");
  EXPECT_EQ(said("{views.view_s.mean} of {views.rows}").text, "1.333 of 3");
  EXPECT_EQ(said("bars | and ||").text, "bars | and |");
  EXPECT_EQ(said("{views[scene = 'none'].view_s.max}").text, "\u2013");
}

TEST(ReportTexts, ChooseByThresholds) {
  EXPECT_EQ(said("{if views.view_s.max <= 2 | fast | slow}").text, "fast");
  EXPECT_EQ(said("{if views.view_s.max < 2 | fast | slow: {views.view_s.max:0} s}").text, "slow: 2 s");
  EXPECT_EQ(said("{if 1 > 2 | a | {if 2 > 1 | b || | c}}").text, "b |");
}

TEST(ReportTexts, AThresholdThatFailsIsSaid) {
  const Said holds = said("Views take seconds. {if views.view_s.max <= 2 | None takes more than two.}");
  EXPECT_EQ(holds, Said("Views take seconds. None takes more than two."));
  const Said fails = said("Views take seconds. {if views.view_s.max <= 1 and views.rows = 3 | None takes more than one.}");
  EXPECT_EQ(fails.text, "Views take seconds. ");
  ASSERT_EQ(fails.failed.size(), 1U);
  EXPECT_EQ(fails.failed[0],
            "\"None takes more than one.\" needs views.view_s.max <= 1 and views.rows = 3; here views.view_s.max is 2, "
            "views.rows is 3");
}

TEST(ReportTexts, SayWhatIsWrong) {
  const auto wrong = [](std::string_view text) -> std::string {
    try {
      return Text(text, "a.json: blocks[1]").said(page()).text;
    } catch (const Wrong& problem) {
      return problem.what();
    }
  };
  EXPECT_EQ(wrong("{views.rows"), "a.json: blocks[1]: \"{views.rows\": a brace is not closed");
  EXPECT_EQ(wrong("views}"), "a.json: blocks[1]: \"}\": a brace was not opened");
  EXPECT_NE(wrong("{views.rows:x}").find("expected the number of places"), std::string::npos);
  EXPECT_NE(wrong("{if views.rows}").find("expected a condition and one or two texts"), std::string::npos);
  EXPECT_NE(wrong("{rooms.rows}").find("a.json: blocks[1]: rooms.rows: found no \"rooms\""), std::string::npos);
}

constexpr std::string_view report_file =
    R"({"title": "Report", "introduction": ["Hello"], "parts": [{"number": 1, "title": "One"}],
  "sections": [{"id": "one", "title": "One", "paper": "p", "chapters": [{"chapter": "a", "part": 1}]}]})";
constexpr std::string_view papers_file = R"({"papers": [{"id": "p", "authors": ["A. Author"], "year": 1971, "title": "T",
  "in": "J", "claims": {"time": {"place": "abstract", "quote": "a second", "figure": 1, "unit": "s"},
  "rows": {"place": "Fig. 1", "says": "some rows", "figure": [2, 4]}},
  "tables": {"table_1": {"place": "Table 1", "keys": ["scene", "words"], "rows": [["house", 7000], ["street", 8001]]}}}]})";

Layout layout_of(std::string_view chapter) {
  const std::vector<std::pair<std::string_view, std::string_view>> files{
      {"report.json", report_file}, {"papers.json", papers_file}, {"a.json", chapter}};
  return read_layout(files);
}

std::string chapter_of(const std::string& blocks) {
  return R"({"sets": {"views": "jones.views", "printed": "papers.table_1"}, "blocks": [)" + blocks + "]}";
}

Figure sketch(const Plot& plot) {
  std::string text;
  for (const Curve& curve : plot.curves) {
    text += curve.name + ":";
    for (const PlotPoint& point : curve.points)
      text += " " + shown_text(Real{point.x}) + "," + shown_text(Real{point.y}) + point.label;
    text += ";";
  }
  return {plot.id, plot.title, plot.caption, text, "image/svg+xml", {}};
}

std::vector<Block> rendered(const std::string& blocks, bool host_times = true) {
  const Layout layout = layout_of(chapter_of(blocks));
  RowSet rows = views();
  rows = RowSet();
  const RowSet all = views();
  for (std::size_t i = 0; i < all.size(); ++i)
    rows.add({{"scene", all.at(i, "scene")},
              {"eae", all.at(i, "eae")},
              {"view_s", all.at(i, "view_s")},
              {"words", all.at(i, "words")},
              {"host_ns", all.at(i, "host_ns")},
              {"screen", Picture{"image/png", {1, 2}, true}}});
  const Results results{{"jones", {{"views", rows}}}};
  return render(layout.chapters.at("a"), layout, results, {host_times, sketch});
}

template <class B>
B only(const std::vector<Block>& blocks) {
  EXPECT_EQ(blocks.size(), 1U);
  return std::get<B>(blocks.at(0));
}

std::string refused(const std::string& blocks) {
  try {
    static_cast<void>(rendered(blocks));
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.error().kind, ErrorKind::bad_input);
    return failure.error().message;
  }
  return "nothing wrong";
}

constexpr const char* sample_table_layout = R"({"table": "views", "title": "Views of {views.scene.distinct} scenes",
  "from": "views", "where": "words > 7000", "columns": [{"key": "scene", "title": "Scene"},
  {"key": "view_ms", "title": "View", "unit": "ms", "places": 1, "value": "1000 * view_s"},
  {"key": "host_ns", "title": "Host", "host": true},
  {"key": "as_printed", "title": "As printed", "must": "words = printed[scene = outer.scene].words",
   "good": "equal", "bad": "differs: {words}"}],
  "notes": ["{views.rows} rows.", {"host": true, "text": "Of this computer."}]})";

TEST(ReportTables, AreMadeOfRows) {
  const auto table = only<Table>(rendered(sample_table_layout));
  EXPECT_EQ(table.title, "Views of 2 scenes");
  EXPECT_EQ(csv_text(table),
            "scene,view_ms,host_ns,as_printed\r\nhouse,2000,,differs: 7001\r\nstreet,1500,30,differs: 8000\r\n");
  EXPECT_EQ(shown_text(table.rows[0][1]), "2000.0");
  ASSERT_EQ(table.notes.size(), 2U);
  EXPECT_EQ(table.notes[0].text, "3 rows.");
}

TEST(ReportTables, LoseWhatIsOfThisComputer) {
  const auto table = only<Table>(rendered(sample_table_layout, false));
  EXPECT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.rows[0].size(), 3U);
  EXPECT_EQ(table.notes.size(), 1U);
  EXPECT_TRUE(rendered(R"({"paragraph": "Fast.", "host": true})", false).empty());
}

TEST(ReportTables, TurnRowsIntoColumns) {
  const auto table = only<Table>(rendered(R"({"table": "t", "title": "T", "from": "views",
    "columns": [{"key": "scene", "title": "Scene"}],
    "pivot": {"key": "eae_{eae}", "title": "EAE: {eae}", "value": "view_s"}})"));
  EXPECT_EQ(csv_text(table), "scene,eae_yes,eae_no\r\nhouse,0.5,2\r\nstreet,1.5,\r\n");
  EXPECT_EQ(table.columns[2].title, "EAE: no");
}

TEST(ReportTables, WithoutRowsMayBeLeftOut) {
  EXPECT_TRUE(rendered(R"({"table": "t", "title": "T", "from": "views", "where": "view_s > 9", "only_with_rows": true,
    "columns": [{"key": "scene", "title": "Scene"}]})")
                  .empty());
}

TEST(ReportClaims, StandBesideWhatWasMeasured) {
  const auto table = only<Table>(rendered(R"({"claims": "paper", "title": "P", "rows": [
    {"claim": "p.time", "least": "views.view_s.min", "greatest": "views.view_s.max", "places": 2, "condition": "all",
     "comparison": "{if ratio.least >= 0.5 and ratio.greatest <= 2 | within a factor of two | another order}"},
    {"claim": "p.rows", "here": "views.rows", "comparison": "{if here.least > claim.greatest | more than {claim.greatest}}"}]})"));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (std::vector<Cell>{std::string("abstract"), std::string("\"a second\""), Real{0.5, 2},
                                              Real{2, 2}, std::string("s"), Real{0.5}, Real{2}, std::string("all"),
                                              std::string("within a factor of two")}));
  EXPECT_EQ(table.rows[1][1], Cell(std::string("some rows")));
  EXPECT_EQ(table.rows[1][5], Cell(Real{0.75}));
  EXPECT_EQ(table.rows[1][6], Cell(Real{1.5}));
  EXPECT_EQ(table.rows[1][8], Cell(Verdict{false, "not in this run: \"more than 4\" needs here.least > claim.greatest; "
                                                  "here here.least is 3, claim.greatest is 4"}));
}

TEST(ReportPlots, HaveACurveForEachName) {
  const std::string plot = R"({"plot": "p", "title": "T", "caption": "{views.rows} points", "alternative": "A",
    "x": {"title": "x"}, "y": {"title": "y", "unit": "s"},
    "curves": [{"from": "views", "by": "{scene}", "x": "words", "y": "view_s", "label": " {eae}"}]})";
  const auto figure = only<Figure>(rendered(plot));
  EXPECT_EQ(figure.alternative, "house: 7000,0.5 yes 7001,2 no;street: 8000,1.5 yes;");
  EXPECT_EQ(figure.caption.text, "3 points");
}

TEST(ReportPlots, OfFewerThanThreePointsAreLeftOut) {
  EXPECT_TRUE(rendered(R"({"plot": "p", "title": "T", "caption": "", "alternative": "", "x": {"title": "x"},
    "y": {"title": "y"}, "curves": [{"from": "views", "by": "all", "x": "words", "y": "host_ns"}]})")
                  .empty());
}

TEST(ReportGalleries, ShowPicturesOfRows) {
  const auto gallery = only<Gallery>(rendered(R"({"gallery": "g", "title": "G", "from": "views", "where": "eae = 'yes'",
    "image": "screen", "id": "screen-{scene}", "name": "{scene}", "caption": "{view_s:2} s", "alternative": "A"})"));
  ASSERT_EQ(gallery.figures.size(), 2U);
  EXPECT_EQ(gallery.figures[1].id, "screen-street");
  EXPECT_EQ(gallery.figures[1].caption.text, "1.50 s");
  EXPECT_EQ(gallery.figures[1].bytes.size(), 2U);
}

constexpr const char* sample_panel_layout = R"({"panel": "finding", "title": "A view takes {views.view_s.max:1} s", "paper": "p",
  "claim": "p.time", "facts": [["Longest of {views.rows}", "{views.view_s.max / claim.least:0} times"]],
  "text": ["{if views.view_s.max <= claim.greatest | Within the paper's second.}", {"host": true, "text": "Of this computer."}],
  "pictures": [
    {"plot": "small", "title": "T", "caption": "", "alternative": "", "x": {"title": "x"}, "y": {"title": "y"},
      "curves": [{"from": "views", "by": "here", "x": "words", "y": "view_s"}, {"from": "views", "by": "paper", "x": "words", "y": "claim.least"}]},
    {"gallery": "g", "title": "", "from": "views", "where": "words = 8000", "image": "screen", "id": "screen-{scene}",
      "name": "{scene}", "caption": "", "alternative": "A"}]})";

TEST(ReportPanels, HaveTheirPapersFigureBesideOurs) {
  const auto panel = only<Panel>(rendered(sample_panel_layout));
  EXPECT_EQ(panel.title, Said("A view takes 2.0 s"));
  EXPECT_EQ(panel.source, "A. Author: \u201CT\u201D, J, 1971");
  ASSERT_EQ(panel.facts.size(), 2U);
  EXPECT_EQ(panel.facts[0], std::pair(std::string("Longest of 3"), std::string("2 times")));
  EXPECT_EQ(panel.facts[1], std::pair(std::string("The paper (abstract)"), std::string("\"a second\"")));
  ASSERT_EQ(panel.text.size(), 2U);
  EXPECT_EQ(panel.text[0].failed.size(), 1U) << "two seconds are not within one";
  ASSERT_EQ(panel.figures.size(), 2U);
  EXPECT_EQ(panel.figures[0].alternative, "here: 7000,0.5 7001,2 8000,1.5;paper: 7000,1 7001,1 8000,1;");
  EXPECT_EQ(panel.figures[1].id, "screen-street");
  EXPECT_EQ(only<Panel>(rendered(sample_panel_layout, false)).text.size(), 1U);
}

// The claim's figure is known in the panel and nowhere after it.
TEST(ReportPanels, KeepTheirClaimToThemselves) {
  EXPECT_NE(refused(std::string(sample_panel_layout) + R"(, {"paragraph": "{claim.least}"})").find("claim.least"), std::string::npos);
}

TEST(ReportPanels, SayWhatIsWrong) {
  EXPECT_NE(refused(R"({"panel": "a", "title": "T", "paper": "q"})").find("a.json: blocks[0]: found no paper \"q\""), std::string::npos);
  EXPECT_NE(refused(R"({"panel": "a", "title": "T", "claim": "p.size"})").find("a.json: blocks[0]: found no claim \"p.size\""),
            std::string::npos);
  EXPECT_NE(refused(R"({"panel": "a", "title": "T", "facts": [["one"]]})")
                .find("a.json: blocks[0].facts[0]: found 1 texts, expected a label and a value"),
            std::string::npos);
  EXPECT_NE(refused(R"({"panel": "a", "title": "T", "pictures": [{"table": "t"}]})").find("a.json: blocks[0].pictures[0]"),
            std::string::npos);
}

// A card for each row that a pivot leaves, with the pictures that its first row has.
TEST(ReportCards, HaveThePicturesOfTheirRow) {
  constexpr const char* cards = R"({"table": "t", "title": "T", "from": "views", "columns": [{"key": "scene", "title": "Scene"}],
    "pivot": {"key": "eae_{eae}", "title": "{eae}", "value": "view_s"},
    "cards": {"name": "Some", "pictures": [{"image": "screen", "name": "of {words}"}, {"image": "host_ns", "name": "none"}]}})";
  const auto table = only<Table>(rendered(cards));
  EXPECT_EQ(table.cards_name, "Some");
  ASSERT_EQ(table.rows.size(), 2U);
  ASSERT_EQ(table.cards.size(), 2U);
  ASSERT_EQ(table.cards[1].size(), 1U) << "a value that is no picture is left out";
  EXPECT_EQ(table.cards[0][0].title, "of 7000");
  EXPECT_EQ(table.cards[1][0].title, "of 8000");
  EXPECT_NE(refused(R"({"table": "t", "title": "T", "from": "views", "columns": [{"key": "scene", "title": "Scene"}],
    "cards": {"name": "Some", "pictures": [{"image": "sreen", "name": ""}]}})")
                .find("a.json: blocks[0]: found no key \"sreen\""),
            std::string::npos);
}

TEST(ReportListings, ShowTexts) {
  const auto blocks = rendered(R"({"listings": "eae", "from": "views", "id": "l-{words}", "file": "{scene}.txt"})");
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(std::get<Listing>(blocks[1]).file, "house.txt");
  EXPECT_EQ(std::get<Listing>(blocks[1]).text, "no");
}

TEST(ReportBlocks, AreVaried) {
  const auto blocks = rendered(R"({"vary": [{"KEY": "words", "WHAT": "\"words\""}, {"KEY": "view_s", "WHAT": "seconds"}],
    "block": {"paragraph": "{views.$KEY.max} $WHAT"}})");
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(std::get<Paragraph>(blocks[0]).text.text, "8000 \"words\"");
  EXPECT_EQ(std::get<Paragraph>(blocks[1]).text.text, "2 seconds");
}

TEST(ReportData, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(refused(R"({"paragraph": "{views.seconds.max}"})"),
            "a.json: blocks[0].paragraph: views.seconds.max: found no key \"seconds\" in the records, expected one of "
            "scene, eae, view_s, words, host_ns, screen");
  EXPECT_NE(refused(R"({"table": "t", "title": "T", "from": "rooms", "columns": []})").find("a.json: blocks[0]: found no set \"rooms\""),
            std::string::npos);
  EXPECT_NE(refused(R"({"table": "t", "title": "T", "from": "views", "columns": [{"key": "cells", "title": "C"}]})")
                .find("a.json: blocks[0]: column \"cells\": found no such key"),
            std::string::npos);
  EXPECT_NE(refused(R"({"claims": "c", "title": "T", "rows": [{"claim": "p.size", "comparison": ""}]})")
                .find("a.json: blocks[0].rows[0]: found no claim \"p.size\" in papers.json"),
            std::string::npos);
  EXPECT_NE(refused(R"({"gallery": "g", "title": "G", "from": "views", "image": "words", "id": "i", "name": "",
    "caption": "", "alternative": ""})")
                .find("found no picture under \"words\""),
            std::string::npos);
}

TEST(ReportData, DamagedFilesAreRefused) {
  EXPECT_NE(refused(R"({"paragraf": "x"})").find("a.json: blocks[0]: expected a paragraph, heading"), std::string::npos);
  EXPECT_NE(refused(R"({"paragraph": 1})").find("a.json: blocks[0].paragraph: found 1, expected a string"), std::string::npos);
  EXPECT_NE(refused(R"({"paragraph": "x", "hots": true})").find("a.json: blocks[0]: found member \"hots\""), std::string::npos);
  EXPECT_NE(refused(R"({"table": "t", "title": "T", "from": "views", "columns": [{"title": "x"}]})")
                .find("a.json: blocks[0].columns[0]: found"),
            std::string::npos);
  EXPECT_NE(refused(R"({"table": "t", "title": "T", "from": "views", "columns": [{"key": "x", "title": "x", "places": 12}]})")
                .find("columns[0].places: found 12, expected 0 to 9"),
            std::string::npos);
  EXPECT_NE(refused(R"({"paragraph": "{1 +}"})").find("a.json: blocks[0].paragraph: \"1 +\""), std::string::npos);
  EXPECT_NE(refused(R"({"paragraph": "x")").find("a.json"), std::string::npos) << "no JSON";
  EXPECT_NE(refused(R"({"heading": "x"})").find("without \"id\""), std::string::npos);
}

TEST(ReportData, SectionsNameWhatIsThere) {
  const auto refusal_of = [](std::string_view section) {
    const std::string report = R"({"title": "R", "parts": [{"number": 1, "title": "One"}], "sections": [)" + std::string(section) + "]}";
    const std::vector<std::pair<std::string_view, std::string_view>> files{
        {"report.json", report}, {"papers.json", papers_file}, {"a.json", R"({"sets": {}, "blocks": []})"}};
    try {
      static_cast<void>(read_layout(files));
    } catch (const Failure& failure) {
      return failure.error().message;
    }
    return std::string("nothing wrong");
  };
  EXPECT_EQ(refusal_of(R"({"id": "s", "title": "S", "chapters": [{"chapter": "a"}, {"chapter": "a", "part": 1}]})"), "nothing wrong");
  EXPECT_EQ(refusal_of(R"({"id": "s", "title": "S", "chapters": [{"chapter": "b", "part": 1}]})"),
            "report.json: section \"s\": found chapter \"b\", expected a file b.json");
  EXPECT_EQ(refusal_of(R"({"id": "s", "title": "S", "chapters": [{"chapter": "a", "part": 2}]})"),
            "report.json: section \"s\": chapter \"a\": found part 2, expected one of \"parts\"");
  EXPECT_EQ(refusal_of(R"({"id": "s", "title": "S", "paper": "q", "chapters": []})"),
            "report.json: section \"s\": found paper \"q\", expected one of papers.json");
}

// Every chapter is in the page, in one place.
TEST(ReportData, EveryChapterIsShownOnce) {
  const Layout layout = read_layout(layout_files());
  std::map<std::string, int> shown;
  for (const SectionLayout& section : layout.sections)
    for (const auto& [chapter, part] : section.chapters) ++shown[chapter];
  for (const auto& [name, chapter] : layout.chapters) EXPECT_EQ(shown[name], 1) << name;
}

TEST(ReportData, ReadsAndGivesTheSameKeys) {
  const Layout layout = layout_of(chapter_of(sample_table_layout));
  const auto lines = mismatches(layout, {{"jones", {{"views", views()}, {"spare", views()}}}});
  ASSERT_FALSE(lines.empty());
  // scene is read of an outer row, of which set is not known.
  EXPECT_EQ(lines[0], "jones.spare: nothing reads key eae");
  const auto gone = mismatches(layout, {});
  EXPECT_EQ(gone.at(0), "a.json: found no records jones.views");
}

// The data files of this program, whatever the records are.
TEST(ReportData, OfThisProgramCanBeRead) {
  EXPECT_NO_THROW(static_cast<void>(read_layout(layout_files())));
}

}  // namespace
}  // namespace sightline::report
