// The experiments' data: that they hold the rows promised, and what must be true of any run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "host/report/experiments/jones_accuracy.hpp"
#include "host/report/experiments/jones_unseen.hpp"
#include "host/report/experiments/jones_views.hpp"
#include "host/report/experiments/montani_re_growth.hpp"
#include "host/report/experiments/montani_re_tables.hpp"
#include "host/report/experiments/plantinga_accuracy.hpp"
#include "host/report/experiments/plantinga_turns.hpp"
#include "host/report/experiments/skala_pictures.hpp"
#include "host/report/experiments/willis_order.hpp"
#include "host/report/experiments/willis_times.hpp"
#include "host/report/html_page.hpp"
#include "host/report/make_report.hpp"

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

TEST(Experiments, HaveAllScenesAndFunctions) {
  const auto& views = results().of<JonesViews>().views;
  ASSERT_EQ(views.size(), 10U);
  for (std::size_t i = 0; i < views.size(); i += 2) {
    const JonesView& with_eae = views[i];
    const JonesView& without = views[i + 1];
    EXPECT_EQ(with_eae.scene, without.scene);
    EXPECT_GT(without.second_view_s, 2 * with_eae.second_view_s) << "the EAE multiplies and divides far quicker than a program";
    EXPECT_EQ(with_eae.pieces, without.pieces);
    EXPECT_GE(with_eae.second_view_s, with_eae.first_view_s) << "the display takes cycles from the second view";
    ASSERT_TRUE(with_eae.screen && with_eae.phosphor) << with_eae.scene;
    EXPECT_GT(with_eae.screen->bytes.size(), 100U) << with_eae.scene;
    EXPECT_GT(with_eae.phosphor->bytes.size(), 100U) << with_eae.scene;
  }
  const auto& skala = results().of<SkalaPictures>();
  EXPECT_EQ(skala.pictures.size(), 24U);
  for (const SkalaPicture& picture : skala.pictures)
    EXPECT_GT(picture.raster.bytes.size(), 100U) << picture.function << ' ' << picture.picture;
  EXPECT_EQ(skala.curves.size(), 8U);
}

// Fig. 6 gives the layout: what the words of all openings come to is counted apart from the assembler.
TEST(Experiments, TheLayoutOfFigure6IsTheProgramsOwn) {
  const auto& elements = results().of<JonesViews>().elements;
  ASSERT_EQ(elements.size(), 5U);
  for (const JonesElements& of_scene : elements) EXPECT_EQ(of_scene.opening_words, of_scene.opening_words_counted) << of_scene.scene;
}

TEST(Experiments, NoSceneNeedsMoreThanThereIs) {
  for (const JonesView& view : results().of<JonesViews>().views) {
    EXPECT_LE(view.used_words, 8192U);
    EXPECT_GE(view.used_words, view.program_words + view.scene_words);
    EXPECT_LE(view.file_words, view.file_room_words);
    EXPECT_LE(view.stack_words, view.stack_room_words);
    EXPECT_LE(view.cells_read, view.cells);
    EXPECT_GE(view.visits, view.cells_read);
    EXPECT_LE(view.depth, view.cells);
    EXPECT_GT(view.stolen_cycles, 0U);
  }
  const auto& memory = results().of<SkalaPictures>().memory;
  ASSERT_FALSE(memory.empty());
  for (const auto bytes : {&SkalaMemory::lines_bytes, &SkalaMemory::surface_bytes, &SkalaMemory::contours_bytes}) {
    std::size_t used = 0;
    for (std::size_t i = 0; i + 1 < memory.size(); ++i) used += memory[i].*bytes;
    EXPECT_LE(used, memory.back().*bytes);
  }
}

// "Cells to which access is not gained in this way are never even considered."
TEST(Experiments, UnseenRoomsCostTheMachineNothing) {
  const auto& corridors = results().of<JonesViews>().corridors;
  ASSERT_EQ(corridors.size(), 4U);
  for (const std::size_t i : {0U, 2U}) {
    const JonesCorridor& small = corridors[i];
    const JonesCorridor& large = corridors[i + 1];
    EXPECT_EQ(small.cells, 8U);
    EXPECT_EQ(large.cells, 32U);
    EXPECT_EQ(small.cells_read, large.cells_read);
    EXPECT_EQ(small.visits, large.visits);
    EXPECT_EQ(small.instructions, large.instructions);
    EXPECT_EQ(small.view_s, large.view_s);
  }
}

TEST(Experiments, ABuildingBesideTheHouseChangesNothingButTheNumberOfCells) {
  const auto& house = results().of<JonesUnseen>().house;
  ASSERT_EQ(house.size(), 4U);
  std::size_t cells = 0;
  for (const JonesHouse& row : house) {
    EXPECT_GT(row.cells, cells);
    cells = row.cells;
    EXPECT_GT(cells, row.rooms);
    // Of the house there are 64 rooms and what lies around them.
    EXPECT_LT(row.cells_seen, 100U);
    EXPECT_EQ(row.cells_seen, house.front().cells_seen);
    EXPECT_EQ(row.visits, house.front().visits);
    EXPECT_EQ(row.segments, house.front().segments);
  }
}

// What is computed exactly has no error, and what fits its words has one that falls with fraction bits.
TEST(Experiments, ErrorsFallWithFractionBits) {
  const auto& builds = results().of<JonesAccuracy>().builds;
  ASSERT_EQ(builds.size(), 4U * 2 * 4);
  for (std::size_t i = 0; i < builds.size(); i += 4)
    EXPECT_LT(builds[i + 3].computed.symmetric_per_cent(), builds[i].computed.symmetric_per_cent()) << i;
  for (const JonesNumber& number : results().of<JonesNumbers>().numbers)
    if (number.study == "exact" || number.arithmetic == "double") {
      EXPECT_EQ(number.error.symmetric_per_cent(), 0) << number.scene << ' ' << number.arithmetic;
    }
}

// At tolerance 0 every view at a random angle is exact; what is joined or shown longer is wrong in more views.
TEST(Experiments, TurnsAreExactWithoutATolerance) {
  EXPECT_EQ(results().of<PlantingaTurns>().models.size(), 5U);
  const auto& measured = results().of<PlantingaAccuracy>();
  const auto rises = [](const auto& rows) {
    ASSERT_FALSE(rows.empty());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].degrees == 0) {
        EXPECT_EQ(rows[i].topo_per_cent, 0) << rows[i].model;
      }
      if (i > 0 && rows[i].model == rows[i - 1].model) {
        EXPECT_GE(rows[i].topo_per_cent, rows[i - 1].topo_per_cent) << rows[i].model << ' ' << rows[i].degrees;
      }
    }
  };
  rises(measured.tolerances);
  rises(measured.steps);
}

// The printed Table 1: in five rows events are edges times events an edge. In the row Grid they are not (hard case
// P22), so nothing should be tuned to it.
TEST(ReportPapers, OnlyTheRowGridDisagreesWithItself) {
  const PrintedTable& printed = Papers::of_program().table("plantinga_table_1");
  ASSERT_EQ(printed.rows.size(), 6U);
  for (std::size_t row = 0; row < printed.rows.size(); ++row) {
    const double average = printed.number(row, "events") / printed.number(row, "edges");
    EXPECT_EQ(std::abs(average - printed.number(row, "per_edge")) > 0.0501, printed.text(row, "model") == "grid") << row;
  }
}

// Without the 90-degree rule nothing is wrong where no pair of surfaces is left over; with it, something is. Between the
// first cut and the last the error may rise, too: a cut makes pairs that were none before.
TEST(Experiments, WillisCutsUntilNothingIsLeftOverAndThenNothingIsWrong) {
  const auto& order = results().of<WillisOrder>();
  const std::vector<WillisModel>& models = order.models;
  ASSERT_EQ(models.size(), 16U * 9);
  std::uint64_t wrong_by_rule = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const WillisModel& model = models[i];
    EXPECT_EQ(model.depth, static_cast<int>(i % 9));
    if (model.depth > 0) {
      EXPECT_GE(model.pieces, models[i - 1].pieces) << i;
    }
    if (model.depth == 8) {
      EXPECT_EQ(model.left_over, 0U) << i << ": else nothing was shown";
    }
    if (model.left_over > 0) continue;
    if (model.rule90) {
      wrong_by_rule += model.lines_wrong;
    } else {
      EXPECT_EQ(model.lines_wrong, 0U) << i;
      EXPECT_EQ(model.points_wrong, 0U) << i;
    }
  }
  EXPECT_GT(wrong_by_rule, 0U);
  // With nothing cut.
  EXPECT_GT(models[0].lines_wrong_percent, 0.02);
  EXPECT_LT(models[0].lines_wrong_percent, 2);
  ASSERT_EQ(order.pictures.size(), 3U);
  EXPECT_GT(order.pictures[0].wrong_inside, 0U);
  EXPECT_EQ(order.pictures[2].wrong_inside, 0U);
  const auto& frames = results().of<WillisTimes>().frames;
  EXPECT_EQ(frames.size(), 8U);
  for (const WillisFrame& frame : frames) {
    EXPECT_EQ(frame.left_over, 0U) << frame.scene;
    EXPECT_LE(frame.distances, frame.pieces) << frame.scene;
  }
}

TEST(Experiments, MontaniAndResTablesComeOut) {
  const auto& tables = results().of<MontaniReTables>();
  const Papers& papers = Papers::of_program();
  const PrintedTable& table_1 = papers.table("montani_re_table_1");
  ASSERT_EQ(tables.stripes.size(), table_1.rows.size());
  for (std::size_t row = 0; row < table_1.rows.size(); ++row) {
    const PrintedStripe& stripe = the(tables.stripes, is(&PrintedStripe::y, table_1.number(row, "y")));
    EXPECT_EQ(static_cast<double>(stripe.substripes), table_1.number(row, "substripes")) << row;
    EXPECT_EQ(stripe.sides, table_1.text(row, "sides")) << row;
  }
  const PrintedTable& table_3 = papers.table("montani_re_table_3");
  ASSERT_EQ(tables.relations.size(), table_3.rows.size());
  for (std::size_t row = 0; row < table_3.rows.size(); ++row) {
    EXPECT_EQ(tables.relations[row].face, table_3.text(row, "face"));
    EXPECT_EQ(tables.relations[row].hides, table_3.number(row, "nmin")) << row;
    EXPECT_EQ(tables.relations[row].hidden_by, table_3.number(row, "nmax")) << row;
    EXPECT_EQ(tables.relations[row].relations, table_3.text(row, "relations")) << row;
  }
  const PrintedTable& table_4 = papers.table("montani_re_table_4");
  ASSERT_EQ(tables.steps.size(), table_4.rows.size());
  for (std::size_t row = 0; row < table_4.rows.size(); ++row) {
    EXPECT_EQ(tables.steps[row].front, table_4.text(row, "front")) << row;
    EXPECT_EQ(tables.steps[row].back, table_4.text(row, "back")) << row;
  }
  EXPECT_EQ(tables.list, papers.table("montani_re_list").text(0, "list"));
  ASSERT_EQ(tables.cycles.size(), 2U);
  for (const FaceCycle& cycle : tables.cycles) EXPECT_TRUE(cycle.right) << cycle.what;
  EXPECT_EQ(results().of<MontaniReGrowth>().views.size(), 6U);
}

// The words under which the papers' numbers stand in them.
TEST(ReportPapers, HaveEveryNumber) {
  std::string said;
  for (const Paper& paper : Papers::of_program().all()) {
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
