// The functions that write chapters: selected and summed rows, tables, claims, plots, and papers.json.
#include "host/report/page.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/html_page.hpp"
#include "host/report/rows.hpp"

namespace sightline::report {
namespace {

struct View {
  std::string scene;
  bool eae = true;
  int words = 0;
  double view_s = 0;
  std::optional<double> host_ns;
};

const std::vector<View> views{{"house", true, 7000, 0.5, {}}, {"house", false, 7001, 2, {}}, {"street", true, 8000, 1.5, 30.0}};

const Papers& papers() {
  static const Papers sample(
      R"({"papers": [{"id": "p", "authors": ["A. Author", "B. Other"], "year": 1971, "title": "T", "in": "J",
    "claims": {"time": {"place": "abstract", "figure": 1, "unit": "s", "quote": "a second"},
      "rows": {"place": "2", "figure": [2, 4], "says": "some rows"}, "none": {"place": "3", "says": "no figure"}},
    "tables": {"t": {"place": "Table 1", "keys": ["scene", "words"], "rows": [["house", 3], ["street", 4.5]]}}}]})");
  return sample;
}

template <class Block, class Write>
Block only(Write write, bool host_times = true) {
  Page page(host_times, papers());
  write(page);
  const auto blocks = std::move(page).blocks();
  EXPECT_EQ(blocks.size(), 1U);
  return std::get<Block>(blocks.at(0));
}

std::string refused(const std::function<void()>& work) {
  try {
    work();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind, base::ErrorKind::bad_input);
    return error.message();
  }
  return "nothing was refused";
}

TEST(ReportRows, AreChosenAndSummed) {
  const auto house = where(views, equals(&View::scene, "house"));
  EXPECT_EQ(house.size(), 2U);
  EXPECT_EQ(where(house, equals(&View::eae, false)).front().get().words, 7001);
  EXPECT_EQ(least(views, &View::view_s), 0.5);
  EXPECT_EQ(greatest(house, &View::words), 7001);
  EXPECT_EQ(sum(views, &View::words), 22001);
  EXPECT_DOUBLE_EQ(mean(views, &View::view_s), 4.0 / 3);
  EXPECT_EQ(distinct(views, &View::scene), 2U);
  EXPECT_EQ(count(views, [](const View& view) { return view.view_s > 1; }), 2U);
  EXPECT_EQ(&only(views, equals(&View::words, 8000)), &views[2]);
}

TEST(ReportRows, AbsentValuesAreSkipped) {
  EXPECT_EQ(values(views, &View::host_ns), std::vector<double>{30});
  EXPECT_EQ(greatest(views, &View::host_ns), 30);
  EXPECT_THROW(static_cast<void>(least(where(views, equals(&View::eae, false)), &View::host_ns)), std::logic_error);
  EXPECT_THROW(static_cast<void>(only(views, equals(&View::scene, "house"))), std::logic_error);
  EXPECT_THROW(static_cast<void>(only(views, equals(&View::scene, "barn"))), std::logic_error);
}

TEST(ReportTexts, ShowNumbersWithTheirPlaces) {
  EXPECT_EQ(text_of(0.126, 2), "0.13");
  EXPECT_EQ(text_of(3), "3");
  EXPECT_EQ(text_of(3, 1), "3.0");
  EXPECT_EQ(text_of(true), "yes");
  EXPECT_EQ(text_of(std::optional<double>()), "\u2013");
}

void table_of_views(Page& page) {
  std::vector<CheckedText> notes{"3 rows."};
  if (page.host_times()) notes.emplace_back("Of this computer.");
  page.table("views", "Views", where(views, [](const View& view) { return view.words > 7000; }),
             {{"scene", "Scene", &View::scene},
              {"view_ms", "View", "ms", [](const View& view) { return 1000 * view.view_s; }, 1},
              {"host_ns", "Host", "ns", &View::host_ns, Real::as_needed, host_time},
              {"small", "Small",
               [](const View& view) {
                 return Verdict{view.words < 8000, view.words < 8000 ? "yes" : "too large"};
               }}},
             {notes, true});
}

TEST(ReportTables, AreMadeOfRows) {
  const auto table = only<Table>(table_of_views);
  EXPECT_EQ(csv_text(table), "scene,view_ms,host_ns,small\r\nhouse,2000,,yes\r\nstreet,1500,30,too large\r\n");
  EXPECT_EQ(cell_text(table.rows[0][1]), "2000.0");
  EXPECT_EQ(table.columns[1].unit, "ms");
  EXPECT_EQ(table.rows[1][3], Cell(Verdict{false, "too large"}));
  EXPECT_TRUE(table.folded);
  EXPECT_EQ(table.notes.size(), 2U);
}

TEST(ReportTables, OmitHostTimesOnRequest) {
  const auto table = only<Table>(table_of_views, false);
  EXPECT_EQ(csv_text(table), "scene,view_ms,small\r\nhouse,2000,yes\r\nstreet,1500,too large\r\n");
  EXPECT_EQ(table.notes.size(), 1U);
}

TEST(ReportTables, TurnRowsIntoColumns) {
  const auto table = only<Table>([](Page& page) {
    page.table("t", "T", views, {{"scene", "Scene", &View::scene}}, {},
               Pivot<View>{[](const View& view) { return std::string(view.eae ? "eae_yes" : "eae_no"); },
                           [](const View& view) { return std::string(view.eae ? "with" : "without"); }, "s",
                           [](const View& view) { return as_cell(view.view_s); }});
  });
  EXPECT_EQ(csv_text(table), "scene,eae_yes,eae_no\r\nhouse,0.5,2\r\nstreet,1.5,\r\n");
  EXPECT_EQ(table.columns[2].title, "without");
}

TEST(ReportClaims, AreShownNextToTheMeasurements) {
  const auto table = only<Table>([](Page& page) {
    page.claims("paper", "P",
                {{"p.time", least_and_greatest(views, &View::view_s), 2, "all", "near"},
                 {"p.rows", one_figure(views.size()), Real::as_needed, "", page.claim(views.size() > 4, "more than 4", "3")},
                 {"p.none"}});
  });
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[0], (std::vector<Cell>{std::string("abstract"), std::string("\"a second\""), Real{0.5, 2}, Real{2, 2},
                                              std::string("s"), Real{0.5}, Real{2}, std::string("all"), std::string("near")}));
  EXPECT_EQ(table.rows[1][1], Cell(std::string("some rows")));
  EXPECT_EQ(table.rows[1][5], Cell(Real{0.75})) << "the smallest here divided by the largest of the paper";
  EXPECT_EQ(table.rows[1][6], Cell(Real{1.5}));
  EXPECT_EQ(table.rows[1][8], Cell(Verdict{false, "not in this run: \"more than 4\"; here 3"}));
  EXPECT_EQ(table.rows[2][2], Cell());
  EXPECT_EQ(table.rows[2][5], Cell());
}

TEST(ReportClaims, ThatDoNotHoldAreSaid) {
  const CheckedText held = "All. " + Page::claim(true, "It holds.") + " End.";
  EXPECT_EQ(held, CheckedText("All. It holds. End."));
  const CheckedText failed = "All. " + Page::claim(false, "It holds.", "3 of 4") + Page::claim(false, "So does this.");
  EXPECT_EQ(failed.text, "All. ");
  EXPECT_EQ(failed.failed, (std::vector<std::string>{"\"It holds.\"; here 3 of 4", "\"So does this.\""}));
  // The page highlights it.
  const Report report{"R", "1", {}, {{"s", "S", {Paragraph{failed}}}}};
  EXPECT_NE(html_page(report).find("<p class=\"bad\">Not in this run: &quot;It holds.&quot;; here 3 of 4</p>"),
            std::string::npos);
}

TEST(ReportPlots, HaveACurveForEachName) {
  Plot plot;
  const auto words = [](const View& view) { return static_cast<double>(view.words); };
  add_curves(plot, views, &View::scene, words, &View::view_s, {[](const View& view) { return view.eae ? "EAE" : ""; }, false});
  add_curves(plot, views, "house", words, &View::host_ns);
  std::string drawn;
  for (const Curve& curve : plot.curves) {
    drawn += curve.name + (curve.line ? ", joined:" : ":");
    for (const PlotPoint& point : curve.points) drawn += " " + text_of(point.x, 0) + "," + text_of(point.y) + point.label;
    drawn += ";";
  }
  EXPECT_EQ(drawn, "house: 7000,0.5EAE 7001,2;street: 8000,1.5EAE;house, joined: 8000,30;");
}

TEST(ReportPlots, OfFewerThanThreePointsAreOmitted) {
  Plot plot;
  // A logarithmic axis cannot show a negative position, and equal points are merged.
  plot.curves = {{"a", {{1, 1}, {2, 2}, {2, 2}, {-1, 3}}}};
  Page page(true, papers());
  Panel panel;
  page.plot(plot);
  page.add_plot(panel, plot);
  EXPECT_TRUE(std::move(page).blocks().empty());
  EXPECT_TRUE(panel.figures.empty());
}

TEST(ReportGalleries, ShowPicturesOfRows) {
  const auto gallery = only<Gallery>([](Page& page) {
    page.gallery("g", "G", where(views, equals(&View::eae, true)), [](const View& view) {
      return figure({"image/png", {1, 2}, true}, "screen-" + view.scene, view.scene, text_of(view.view_s, 2) + " s", "A");
    });
  });
  ASSERT_EQ(gallery.figures.size(), 2U);
  EXPECT_EQ(gallery.figures[1].id, "screen-street");
  EXPECT_EQ(gallery.figures[1].caption.text, "1.50 s");
  EXPECT_EQ(gallery.figures[1].bytes.size(), 2U);
  EXPECT_TRUE(gallery.figures[1].pixelated);
}

TEST(ReportPapers, AreQuotedWithTheirPlaces) {
  const Page page(true, papers());
  EXPECT_EQ(papers().paper("p").citation(), "A. Author and B. Other: \u201CT\u201D, J, 1971");
  EXPECT_EQ(page.paper_says("p.time"), std::pair(std::string("The paper (abstract)"), std::string("\"a second\"")));
  EXPECT_EQ(page.paper_says_dated("p.rows"), std::pair(std::string("Author and others, 1971 (2)"), std::string("some rows")));
  EXPECT_EQ(page.paper_figure("p.rows").least, 2);
  EXPECT_EQ(page.paper_figure("p.rows").greatest, 4);
  EXPECT_EQ(papers().table("t").number(1, "words"), 4.5);
  EXPECT_EQ(papers().table("t").text(0, "scene"), "house");
}

TEST(ReportPapers, ReportMissingEntries) {
  const Page page(true, papers());
  EXPECT_EQ(refused([&] { static_cast<void>(page.paper_figure("p.none")); }), "papers.json: claim p.none: found no figure");
  EXPECT_EQ(refused([&] { static_cast<void>(page.paper_figure("p.tine")); }),
            "papers.json: found no claim of p \"tine\"; did you mean \"time\"?");
  EXPECT_EQ(refused([] { static_cast<void>(papers().paper("q")); }), "papers.json: found no paper \"q\"");
  EXPECT_EQ(refused([] { static_cast<void>(papers().table("s")); }), "papers.json: found no table \"s\"");
  EXPECT_EQ(refused([] { static_cast<void>(papers().table("t").number(0, "scene")); }),
            "papers.json: column scene, row 1: expected a number");
}

TEST(ReportPapers, DamagedOnesAreErrorsWithTheirPosition) {
  const auto read = [](std::string_view text) { return refused([text] { const Papers damaged(text); }); };
  EXPECT_NE(read("{").find("papers.json"), std::string::npos);
  EXPECT_NE(read("[]").find("papers"), std::string::npos);
  EXPECT_NE(read(R"({"papers": [{"id": 3, "authors": [], "year": 1971, "title": "", "in": ""}]})").find("papers[0].id"),
            std::string::npos);
  EXPECT_NE(
      read(R"({"papers": [{"id": "p", "authors": [], "year": 1971, "title": "", "in": "", "claims": {"a": {"place": "1"}}}]})")
          .find("papers[0].claims.a"),
      std::string::npos);
  EXPECT_NE(read(R"({"papers": [{"id": "p", "authors": [], "year": 1971, "title": "", "in": "",
                     "tables": {"t": {"keys": ["a", "b"], "rows": [[1]]}}}]})")
                .find("papers[0].tables.t.rows[0]"),
            std::string::npos);
}

}  // namespace
}  // namespace sightline::report
