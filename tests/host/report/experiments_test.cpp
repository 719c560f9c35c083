// The experiments' records: that they hold the rows promised, what must be true of any run, and that the data files
// read the keys that are there.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <thread>

#include "host/report/html_page.hpp"
#include "host/report/layout.hpp"
#include "host/report/make_report.hpp"
#include "host/report/table_text.hpp"

namespace sightline::report {
namespace {

Context quiet() {
  Context context;
  context.host_times = false;
  context.jobs = std::max(1U, std::thread::hardware_concurrency());
  return context;
}

const Results& results() {
  static const Results made = [] {
    auto outcome = run_experiments({}, quiet());
    if (!outcome) ADD_FAILURE() << outcome.error().message;
    return outcome ? *std::move(outcome) : Results();
  }();
  return made;
}

const RowSet& set(const std::string& experiment, const std::string& name) {
  return results().at(experiment).at(name);
}

double number(const RowSet& rows, std::size_t row, std::string_view key) {
  const auto value = rows.at(row, key).number();
  EXPECT_TRUE(value) << key << row;
  return value.value_or(0);
}

TEST(Experiments, AndDataFilesHaveTheSameKeys) {
  for (const std::string& line : mismatches(read_layout(layout_files()), results())) ADD_FAILURE() << line;
}

TEST(Experiments, HaveAllScenesAndFunctions) {
  const RowSet& views = set("jones-views", "views");
  ASSERT_EQ(views.size(), 10U);
  for (std::size_t row = 0; row < views.size(); row += 2) {
    EXPECT_EQ(views.at(row, "scene"), views.at(row + 1, "scene"));
    EXPECT_GT(number(views, row + 1, "second_view_s"), 2 * number(views, row, "second_view_s"))
        << "the EAE multiplies and divides far quicker than a program";
    EXPECT_EQ(views.at(row, "pieces"), views.at(row + 1, "pieces"));
    EXPECT_GE(number(views, row, "second_view_s"), number(views, row, "first_view_s"))
        << "the display takes cycles from the second view";
    for (const char* const picture : {"screen", "phosphor"})
      EXPECT_GT(std::get<Picture>(views.at(row, picture).kind()).bytes.size(), 100U) << picture << row;
  }
  const RowSet& pictures = set("skala-pictures", "pictures");
  EXPECT_EQ(pictures.size(), 24U);
  for (std::size_t row = 0; row < pictures.size(); ++row)
    EXPECT_GT(std::get<Picture>(pictures.at(row, "raster").kind()).bytes.size(), 100U) << row;
  EXPECT_EQ(set("skala-pictures", "curves").size(), 8U);
}

// Fig. 6 gives the layout: what the words of all openings come to is counted apart from the assembler.
TEST(Experiments, TheLayoutOfFigure6IsTheProgramsOwn) {
  const RowSet& elements = set("jones-views", "elements");
  ASSERT_EQ(elements.size(), 5U);
  for (std::size_t row = 0; row < elements.size(); ++row)
    EXPECT_EQ(elements.at(row, "opening_words"), elements.at(row, "opening_words_counted")) << row;
}

TEST(Experiments, NoSceneNeedsMoreThanThereIs) {
  const RowSet& views = set("jones-views", "views");
  for (std::size_t row = 0; row < views.size(); ++row) {
    EXPECT_EQ(views.at(row, "core_words"), Value(8192));
    EXPECT_LE(number(views, row, "used_words"), 8192);
    EXPECT_GE(number(views, row, "used_words"),
              number(views, row, "program_words") + number(views, row, "scene_words"));
    EXPECT_LE(number(views, row, "file_words"), number(views, row, "file_room_words"));
    EXPECT_LE(number(views, row, "stack_words"), number(views, row, "stack_room_words"));
    EXPECT_LE(number(views, row, "cells_read"), number(views, row, "cells"));
    EXPECT_GE(number(views, row, "visits"), number(views, row, "cells_read"));
    EXPECT_LE(number(views, row, "depth"), number(views, row, "cells"));
    EXPECT_GT(number(views, row, "stolen_cycles"), 0);
  }
  const RowSet& memory = set("skala-pictures", "memory");
  for (const char* const picture : {"lines_bytes", "surface_bytes", "contours_bytes"}) {
    double sum = 0;
    for (std::size_t row = 0; row + 1 < memory.size(); ++row) sum += number(memory, row, picture);
    EXPECT_LE(sum, number(memory, memory.size() - 1, picture)) << picture;
  }
}

// "Cells to which access is not gained in this way are never even considered."
TEST(Experiments, UnseenRoomsCostTheMachineNothing) {
  const RowSet& corridors = set("jones-views", "corridors");
  ASSERT_EQ(corridors.size(), 4U);
  for (const std::size_t row : {0U, 2U}) {
    EXPECT_EQ(corridors.at(row, "cells"), Value(8));
    EXPECT_EQ(corridors.at(row + 1, "cells"), Value(32));
    for (const char* const same : {"cells_read", "visits", "instructions", "view_s"})
      EXPECT_EQ(corridors.at(row, same), corridors.at(row + 1, same)) << same;
  }
}

TEST(Experiments, ABuildingBesideTheHouseChangesNothingButTheNumberOfCells) {
  const RowSet& house = set("jones-unseen", "house");
  ASSERT_EQ(house.size(), 4U);
  double cells = 0;
  for (std::size_t row = 0; row < house.size(); ++row) {
    EXPECT_GT(number(house, row, "cells"), cells);
    cells = number(house, row, "cells");
    EXPECT_GT(cells, number(house, row, "rooms"));
    // Of the house there are 64 rooms and what lies around them.
    EXPECT_LT(number(house, row, "cells_seen"), 100);
    for (const char* const same : {"cells_seen", "visits", "segments"})
      EXPECT_EQ(house.at(row, same), house.at(0, same)) << same;
  }
}

// What is computed exactly has no error, and what fits its words has one that falls with fraction bits.
TEST(Experiments, ErrorsFallWithFractionBits) {
  const RowSet& machine = set("jones-accuracy", "machine");
  ASSERT_EQ(machine.size(), 4U * 2 * 4);
  for (std::size_t row = 0; row < machine.size(); row += 4)
    EXPECT_LT(number(machine, row + 3, "l_sym_per_cent"), number(machine, row, "l_sym_per_cent")) << row;
  const RowSet& numbers = set("jones-numbers", "numbers");
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    if (numbers.at(row, "study") == Value("exact") || numbers.at(row, "arithmetic") == Value("double")) {
      EXPECT_EQ(number(numbers, row, "l_sym_per_cent"), 0) << row;
    }
  }
}

// At tolerance 0 every view at a random angle is exact; what is joined or shown longer is wrong in more views.
TEST(Experiments, TurnsAreExactWithoutATolerance) {
  EXPECT_EQ(set("plantinga-turns", "models").size(), 5U);
  for (const char* const how : {"tolerances", "steps"}) {
    const RowSet& rows = set("plantinga-accuracy", how);
    const std::size_t each = rows.size() / 2;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (number(rows, row, "degrees") == 0) {
        EXPECT_EQ(number(rows, row, "topo_per_cent"), 0);
      }
      if (row % each == 0) continue;
      EXPECT_GE(number(rows, row, "topo_per_cent"), number(rows, row - 1, "topo_per_cent")) << how << row;
    }
  }
}

// The printed Table 1: in five rows events are edges times events an edge. In the row Grid they are not (hard case
// P22), so nothing should be tuned to it.
TEST(ReportPapers, OnlyTheRowGridDisagreesWithItself) {
  const Layout layout = read_layout(layout_files());
  const RowSet& printed = layout.paper_tables.at("plantinga_table_1");
  ASSERT_EQ(printed.size(), 6U);
  for (std::size_t row = 0; row < printed.size(); ++row) {
    const double average = number(printed, row, "events") / number(printed, row, "edges");
    EXPECT_EQ(std::abs(average - number(printed, row, "per_edge")) > 0.0501, printed.at(row, "model") == Value("grid")) << row;
  }
}

// Without the 90-degree rule nothing is wrong where no pair of surfaces is left over; with it, something is. Between the
// first cut and the last the error may rise, too: a cut makes pairs that were none before.
TEST(Experiments, WillisCutsUntilNothingIsLeftOverAndThenNothingIsWrong) {
  const RowSet& models = set("willis-order", "models");
  ASSERT_EQ(models.size(), 16U * 9);
  double wrong_by_rule = 0;
  for (std::size_t row = 0; row < models.size(); ++row) {
    const bool rule = models.at(row, "rule90") == Value("on");
    if (row % 9 > 0) {
      EXPECT_GE(number(models, row, "pieces"), number(models, row - 1, "pieces")) << row;
    }
    if (row % 9 == 8) {
      EXPECT_EQ(models.at(row, "left_over"), Value(0)) << row << ": else nothing was shown";
    }
    if (models.at(row, "left_over") != Value(0)) continue;
    if (rule) wrong_by_rule += number(models, row, "lines_wrong");
    if (rule) continue;
    EXPECT_EQ(models.at(row, "lines_wrong"), Value(0)) << row;
    EXPECT_EQ(models.at(row, "points_wrong"), Value(0)) << row;
  }
  EXPECT_GT(wrong_by_rule, 0);
  // With nothing cut.
  EXPECT_GT(number(models, 0, "lines_wrong_percent"), 0.02);
  EXPECT_LT(number(models, 0, "lines_wrong_percent"), 2);
  const RowSet& pictures = set("willis-order", "pictures");
  ASSERT_EQ(pictures.size(), 3U);
  EXPECT_GT(number(pictures, 0, "wrong_inside"), 0);
  EXPECT_EQ(pictures.at(2, "wrong_inside"), Value(0));
  const RowSet& frames = set("willis-times", "frames");
  for (std::size_t row = 0; row < frames.size(); ++row) {
    EXPECT_EQ(frames.at(row, "left_over"), Value(0)) << row;
    EXPECT_LE(number(frames, row, "distances"), number(frames, row, "pieces")) << row;
  }
}

TEST(Experiments, MontaniAndResTablesComeOut) {
  const Layout layout = read_layout(layout_files());
  const auto same = [&](const char* of, const char* key, const char* table, const char* printed_key) {
    const RowSet& here = set("montani-re-tables", of);
    const RowSet& printed = layout.paper_tables.at(table);
    ASSERT_EQ(here.size(), printed.size()) << table;
    // Table 1 begins at the top.
    const bool upwards = here.place_of("y") && here.at(0, "y") != printed.at(0, "y");
    for (std::size_t row = 0; row < here.size(); ++row)
      EXPECT_EQ(here.at(upwards ? here.size() - 1 - row : row, key), printed.at(row, printed_key)) << table << row;
  };
  same("stripes", "substripes", "montani_re_table_1", "substripes");
  same("stripes", "sides", "montani_re_table_1", "sides");
  same("relations", "hides", "montani_re_table_3", "nmin");
  same("relations", "hidden_by", "montani_re_table_3", "nmax");
  same("relations", "relations", "montani_re_table_3", "relations");
  same("steps", "front", "montani_re_table_4", "front");
  same("steps", "back", "montani_re_table_4", "back");
  same("list", "list", "montani_re_list", "list");
  const RowSet& cycles = set("montani-re-tables", "cycles");
  for (std::size_t row = 0; row < cycles.size(); ++row) EXPECT_EQ(cycles.at(row, "right"), Value("yes")) << row;
  EXPECT_EQ(set("montani-re-growth", "views").size(), 6U);
}

// The words under which the papers' numbers stand in them.
TEST(ReportPapers, HaveEveryNumber) {
  const Layout layout = read_layout(layout_files());
  std::string said;
  for (const Paper& paper : layout.papers) {
    EXPECT_FALSE(paper.authors.empty()) << paper.id;
    EXPECT_FALSE(paper.title.empty()) << paper.id;
    for (const auto& [name, claim] : paper.claims) {
      EXPECT_FALSE(claim.place.empty()) << paper.id << '.' << name;
      said += claim.says + "\n";
    }
  }
  for (const char* const words :
       {"a few seconds\"", "order of a few seconds", "show the computing time in seconds", "several minutes",
        "sixteen frames per second", "8192 18-bit words", "1.75 microseconds", "eight sense switches", "opening-element",
        "cell-element", "stereoscopic pair", "2 sec. approximately", "about 15% slower", "256x256 points", "8 colours",
        "3MHz", "1024 columns", "16.3 times the number of edges", "as fast as displaying a wire-frame", "25 per second\"",
        "in the hundreds", "N^2", "about 2%\"", "(pi + 2)L^2", "about 65%\"", "within 90", "low memory", "almost linear",
        "product of N*Y", "at least, three faces", "Figure 10", "or a multiple"})
    EXPECT_NE(said.find(words), std::string::npos) << words;
}

TEST(ReportRun, StatesNothingThatDoesNotHold) {
  const auto report = report_of({}, results(), quiet());
  ASSERT_TRUE(report) << report.error().message;
  const std::string page = html_page(*report);
  EXPECT_EQ(page.find("Not in this run"), std::string::npos) << page.substr(page.find("Not in this run"), 300);
  EXPECT_EQ(page.find("not in this run"), std::string::npos) << page.substr(page.find("not in this run"), 300);
  EXPECT_LT(page.size(), 4'000'000U);
}

// Parts choose by kind; the opening page is of the whole report.
TEST(ReportRun, PartsAreKindsOfChapters) {
  const auto titles = [](std::span<const int> parts) {
    std::vector<std::string> found;
    const auto report = report_of(parts, results(), quiet());
    if (!report) return found;
    for (const Section& section : report->sections)
      for (const Block& block : section.blocks)
        if (const auto* const heading = std::get_if<Heading>(&block)) found.push_back(section.id + ": " + heading->text);
    return found;
  };
  EXPECT_EQ(titles(std::array{4}), (std::vector<std::string>{"jones: Resource usage", "skala: Resource usage"}));
  EXPECT_EQ(titles(std::array{5}), (std::vector<std::string>{"agreement: Cross-check"}));
  const auto whole = report_of({}, results(), quiet());
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->sections.front().id, "overview");
  std::size_t methods = 0;
  std::size_t findings = 0;
  for (const Block& block : whole->sections.front().blocks) {
    const auto* const panel = std::get_if<Panel>(&block);
    if (panel == nullptr) continue;
    EXPECT_FALSE(panel->figures.empty()) << panel->id << ": has no picture";
    ++(panel->source.empty() ? findings : methods);
  }
  EXPECT_EQ(methods, 5U);
  EXPECT_GE(findings, 8U);
}

// Every case that is run has a picture of what is right, where there is a picture at all; a wrong one has its own.
TEST(Experiments, HardCasesHavePictures) {
  const RowSet& runs = set("hard-cases", "runs");
  std::set<std::string> without;
  for (std::size_t row = 0; row < runs.size(); ++row) {
    const bool wrong = runs.at(row, "outcome") == Value("wrong");
    if (wrong) {
      EXPECT_FALSE(runs.at(row, "wrong").missing()) << row;
    }
    if (runs.at(row, "outcome") == Value("right") && runs.at(row, "correct").missing())
      without.insert(std::string(*runs.at(row, "input").text()));
  }
  // Files that must be refused.
  for (const std::string& input : without) EXPECT_NE(input.find_first_of("JMWPS"), std::string::npos) << input;
  EXPECT_LE(without.size(), 12U);
}

// With other experiments on all processors, and by themselves on one.
TEST(ReportRun, IsTheSameTwice) {
  constexpr std::array parts{4, 5};
  Context one = quiet();
  one.jobs = 1;
  const auto first = report_of(parts, results(), quiet());
  const auto second = make_report(parts, one);
  ASSERT_TRUE(first) << first.error().message;
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_TRUE(html_page(*first) == html_page(*second));
}

}  // namespace
}  // namespace sightline::report
