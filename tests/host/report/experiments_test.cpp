// What experiments measure: properties of every run, and of the report made from it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <thread>

#include "host/compare/scenes.hpp"
#include "host/report/experiments/comparison.hpp"
#include "host/report/experiments/hard_cases.hpp"
#include "host/report/experiments/opening.hpp"
#include "host/report/experiments/overview.hpp"
#include "host/report/experiments/plantinga_accuracy.hpp"
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
    if (!outcome) ADD_FAILURE() << outcome.error().message();
    return outcome ? *std::move(outcome) : Results();
  }();
  return made;
}

const JonesViews& jones() {
  return results().of<JonesViews>();
}
const SkalaPictures& skala() {
  return results().of<SkalaPictures>();
}

TEST(Experiments, HaveAllScenesAndFunctions) {
  ASSERT_EQ(jones().views.size(), 10U);
  for (const JonesView& with : jones().of(true)) {
    const JonesView& without = jones().view(with.scene, false);
    EXPECT_GT(without.second_view_s, 2 * with.second_view_s) << "the EAE multiplies and divides far quicker than a program";
    EXPECT_EQ(with.pieces, without.pieces);
    EXPECT_GE(with.second_view_s, with.first_view_s) << "the display takes cycles from the second view";
    for (const auto& picture : {with.screen, with.phosphor}) {
      ASSERT_TRUE(picture) << with.scene;
      EXPECT_GT(picture->bytes.size(), 100U) << with.scene;
    }
  }
  EXPECT_EQ(skala().pictures.size(), 24U);
  for (const SkalaPicture& row : skala().pictures) EXPECT_GT(row.raster.bytes.size(), 100U) << row.function;
  EXPECT_EQ(skala().curves.size(), 8U);
}

// Fig. 6 gives the layout: the number of words for all openings is counted independently of the assembler.
TEST(Experiments, TheLayoutOfFigure6IsTheProgramsOwn) {
  ASSERT_EQ(jones().elements.size(), 5U);
  for (const JonesElements& row : jones().elements) EXPECT_EQ(row.opening_words, row.opening_words_counted) << row.scene;
}

TEST(Experiments, NoSceneExceedsTheCapacity) {
  for (const JonesView& view : jones().views) {
    EXPECT_LE(view.used_words, 8192U);
    EXPECT_GE(view.used_words, view.program_words + view.scene_words);
    EXPECT_LE(view.file_words, view.file_room_words);
    EXPECT_LE(view.stack_words, 450U);
    EXPECT_LE(view.cells_read, view.cells);
    EXPECT_GE(view.visits, view.cells_read);
    EXPECT_LE(view.depth, view.cells);
    EXPECT_GT(view.stolen_cycles, 0U);
  }
  const std::span<const SkalaMemory> parts(skala().memory.begin(), skala().memory.end() - 1);
  for (const auto bytes : {&SkalaMemory::lines_bytes, &SkalaMemory::surface_bytes, &SkalaMemory::contours_bytes}) {
    std::size_t sum_of_parts = 0;
    for (const SkalaMemory& part : parts) sum_of_parts += part.*bytes;
    EXPECT_LE(sum_of_parts, 65536U);
  }
}

// "Cells to which access is not gained in this way are never even considered."
TEST(Experiments, InvisibleRoomsCostTheMachineNothing) {
  const auto& corridors = jones().corridors;
  ASSERT_EQ(corridors.size(), 4U);
  for (const std::size_t row : {0U, 2U}) {
    const JonesCorridor& small = corridors[row];
    const JonesCorridor& large = corridors[row + 1];
    EXPECT_EQ(small.cells, 8U);
    EXPECT_EQ(large.cells, 32U);
    EXPECT_EQ(small.cells_read, large.cells_read);
    EXPECT_EQ(small.visits, large.visits);
    EXPECT_EQ(small.instructions, large.instructions);
    EXPECT_EQ(small.view_s, large.view_s);
  }
}

TEST(Experiments, ABuildingNextToTheHouseOnlyChangesTheNumberOfCells) {
  const auto& house = results().of<JonesUnseen>().house;
  ASSERT_EQ(house.size(), 4U);
  std::size_t cells = 0;
  for (const JonesHouse& row : house) {
    EXPECT_GT(row.cells, cells);
    cells = row.cells;
    EXPECT_GT(cells, row.rooms);
    // The house has 64 rooms and the cells around them.
    EXPECT_LT(row.cells_seen, 100U);
    EXPECT_EQ(row.cells_seen, house[0].cells_seen);
    EXPECT_EQ(row.visits, house[0].visits);
    EXPECT_EQ(row.segments, house[0].segments);
  }
}

// Exact computation has no error, and the error of sufficiently long words falls with fraction bits.
TEST(Experiments, ErrorsFallWithFractionBits) {
  const JonesAccuracy& machine = results().of<JonesAccuracy>();
  ASSERT_EQ(machine.builds.size(), 4U * 2 * 4);
  for (const JonesBuild& build : where(machine.builds, equals(&JonesBuild::fraction_bits, 0)))
    EXPECT_LT(machine.build(build.scene, 3, build.rounded).computed.symmetric_per_cent(), build.computed.symmetric_per_cent())
        << build.scene;
  for (const JonesNumber& number : results().of<JonesNumbers>().numbers)
    if (number.study == "exact" || number.arithmetic == "double") {
      EXPECT_LT(number.error.symmetric_per_cent(), 1e-9) << number.scene << ": no more than the noise of the measure";
    }
}

// At tolerance 0 every view at a random angle is exact; joined or extended events make more views wrong.
TEST(Experiments, TurnsAreExactWithoutATolerance) {
  EXPECT_EQ(results().of<PlantingaTurns>().models.size(), 5U);
  const auto grow = [](const auto& rows) {
    ASSERT_FALSE(rows.empty());
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (rows[row].degrees == 0) {
        EXPECT_EQ(rows[row].topo_per_cent, 0);
      }
      if (row == 0 || rows[row].model != rows[row - 1].model) continue;
      EXPECT_GE(rows[row].topo_per_cent, rows[row - 1].topo_per_cent) << row;
    }
  };
  grow(results().of<PlantingaAccuracy>().tolerances);
  grow(results().of<PlantingaAccuracy>().steps);
}

// The printed Table 1: in five rows events equal edges times events per edge. In the row Grid they do not (hard case P22), so
// nothing
// should be fitted to it.
TEST(ReportPapers, OnlyTheRowGridDisagreesWithItself) {
  const PrintedTable& printed = Papers::built_in().table("plantinga_table_1");
  ASSERT_EQ(printed.rows.size(), 6U);
  for (std::size_t row = 0; row < printed.rows.size(); ++row) {
    const double average = printed.number(row, "events") / printed.number(row, "edges");
    EXPECT_EQ(std::abs(average - printed.number(row, "per_edge")) > 0.0501, printed.text(row, "model") == "grid") << row;
  }
}

// Without the 90-degree rule there is no error if there are no residual pairs; with the rule there is. Between the first cut and
// the last
// the error may also rise, because a cut makes new pairs.
TEST(Experiments, WillisWithoutResidualPairsHasNoError) {
  const WillisOrder& willis = results().of<WillisOrder>();
  ASSERT_EQ(willis.models.size(), 16U * 9);
  std::uint64_t wrong_by_rule = 0;
  for (std::size_t row = 0; row < willis.models.size(); ++row) {
    const WillisModel& model = willis.models[row];
    if (row % 9 > 0) {
      EXPECT_GE(model.pieces, willis.models[row - 1].pieces) << row;
    }
    if (row % 9 == 8) {
      EXPECT_EQ(model.left_over, 0U) << row << ": otherwise the test is empty";
    }
    if (model.left_over != 0) continue;
    if (model.rule90) {
      wrong_by_rule += model.lines_wrong;
    } else {
      EXPECT_EQ(model.lines_wrong, 0U) << row;
      EXPECT_EQ(model.points_wrong, 0U) << row;
    }
  }
  EXPECT_GT(wrong_by_rule, 0U);
  // Without cuts.
  EXPECT_GT(willis.models[0].lines_wrong_percent, 0.02);
  EXPECT_LT(willis.models[0].lines_wrong_percent, 2);
  ASSERT_EQ(willis.pictures.size(), 3U);
  EXPECT_GT(willis.pictures[0].wrong_inside, 0U);
  EXPECT_EQ(willis.pictures[2].wrong_inside, 0U);
  for (const WillisFrame& frame : results().of<WillisTimes>().frames) {
    EXPECT_EQ(frame.left_over, 0U) << frame.scene;
    EXPECT_LE(frame.distances, frame.pieces) << frame.scene;
  }
}

TEST(Experiments, MontaniAndResTablesComeOut) {
  const MontaniReTables& here = results().of<MontaniReTables>();
  const Papers& papers = Papers::built_in();
  const PrintedTable& stripes = papers.table("montani_re_table_1");
  ASSERT_EQ(here.stripes.size(), stripes.rows.size());
  for (std::size_t row = 0; row < stripes.rows.size(); ++row) {
    const PrintedStripe& stripe = only(here.stripes, equals(&PrintedStripe::y, static_cast<std::int32_t>(stripes.number(row, "y"))));
    EXPECT_EQ(static_cast<double>(stripe.substripes), stripes.number(row, "substripes")) << stripe.y;
    EXPECT_EQ(stripe.sides, stripes.text(row, "sides")) << stripe.y;
  }
  const PrintedTable& relations = papers.table("montani_re_table_3");
  ASSERT_EQ(here.relations.size(), relations.rows.size());
  for (std::size_t row = 0; row < relations.rows.size(); ++row) {
    EXPECT_EQ(here.relations[row].face, relations.text(row, "face"));
    EXPECT_EQ(here.relations[row].hides, relations.number(row, "nmin")) << row;
    EXPECT_EQ(here.relations[row].hidden_by, relations.number(row, "nmax")) << row;
    EXPECT_EQ(here.relations[row].relations, relations.text(row, "relations")) << row;
  }
  const PrintedTable& steps = papers.table("montani_re_table_4");
  ASSERT_EQ(here.steps.size(), steps.rows.size());
  for (std::size_t row = 0; row < steps.rows.size(); ++row) {
    EXPECT_EQ(here.steps[row].front, steps.text(row, "front")) << row;
    EXPECT_EQ(here.steps[row].back, steps.text(row, "back")) << row;
  }
  EXPECT_EQ(here.list, papers.table("montani_re_list").text(0, "list"));
  for (const FaceCycle& cycle : here.cycles) EXPECT_TRUE(cycle.right) << cycle.what;
  EXPECT_EQ(results().of<MontaniReGrowth>().views.size(), 6U);
}

// The texts with which the papers' numbers occur in them.
TEST(ReportPapers, HaveEveryNumber) {
  std::string said;
  for (const Paper& paper : Papers::built_in().all()) {
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

TEST(ReportRun, StatesNoFailedClaim) {
  const auto report = report_of({}, results(), quiet());
  ASSERT_TRUE(report) << report.error().message();
  const std::string page = html_page(*report);
  EXPECT_EQ(page.find("Not in this run"), std::string::npos) << page.substr(page.find("Not in this run"), 300);
  EXPECT_EQ(page.find("not in this run"), std::string::npos) << page.substr(page.find("not in this run"), 300);
  EXPECT_LT(page.size(), 4'000'000U);
}

// Parts are selected by kind; the opening page belongs to the whole report.
TEST(ReportRun, PartsAreKindsOfChapters) {
  for (const Part& part : report_parts()) {
    std::vector<std::string> expected;
    for (const SectionPlan& section : report_sections())
      if (std::any_of(section.chapters.begin(), section.chapters.end(), equals(&Chapter::part, part.number))) expected.push_back(section.id);
    const auto report = report_of(std::array{part.number}, results(), quiet());
    ASSERT_TRUE(report) << report.error().message();
    std::vector<std::string> found;
    for (const Section& section : report->sections) {
      const auto is_title = [&part](const Block& block) {
        const auto* const heading = std::get_if<Heading>(&block);
        return heading != nullptr && heading->text == part.title;
      };
      EXPECT_EQ(std::count_if(section.blocks.begin(), section.blocks.end(), is_title), 1) << section.id << ": " << part.title;
      found.push_back(section.id);
    }
    EXPECT_EQ(found, expected) << part.title;
    EXPECT_FALSE(expected.empty()) << part.title;
  }
  const auto whole = report_of({}, results(), quiet());
  ASSERT_TRUE(whole);
  const auto& opening = whole->sections.at(0).blocks;
  ASSERT_FALSE(opening.empty());
  const auto* const answers = std::get_if<Opening>(&opening.front());
  ASSERT_NE(answers, nullptr) << "the page begins with the answers";
  EXPECT_EQ(answers->answers.size(), 3U);
  EXPECT_EQ(answers->drawings.size(), 2U);
  EXPECT_EQ(whole->sections.at(1).id, "overview");
  std::size_t methods = 0;
  std::size_t findings = 0;
  for (const Block& block : whole->sections.at(1).blocks) {
    const auto* const panel = std::get_if<Panel>(&block);
    if (panel == nullptr) continue;
    EXPECT_FALSE(panel->figures.empty()) << panel->id << ": has no picture";
    ++(panel->source.empty() ? findings : methods);
  }
  EXPECT_EQ(methods, 5U);
  EXPECT_GE(findings, 8U);
}

// Every chapter of a part has contents; a chapter is found by its id.
TEST(ReportRun, EveryChapterHasTablesOrPictures) {
  for (const SectionPlan& section : report_sections()) {
    for (const Chapter& chapter : section.chapters) {
      if (chapter.takes.empty()) continue;
      Page page(false);
      chapter.write(page, results());
      const auto blocks = std::move(page).blocks();
      EXPECT_TRUE(std::any_of(blocks.begin(), blocks.end(), [](const Block& block) {
        const auto* const panel = std::get_if<Panel>(&block);
        return std::holds_alternative<Table>(block) || (panel != nullptr && !panel->figures.empty());
      })) << chapter.id;
    }
  }
}

// Every case that is run has a picture of the correct result, where there is a picture at all; a wrong result has a separate one.
TEST(Experiments, HardCasesHavePictures) {
  std::size_t without = 0;
  for (const CaseResult& row : results().of<HardCases>().cases) {
    if (count(row.findings, [](const CaseFinding& finding) { return finding.right == false; }) > 0) {
      EXPECT_TRUE(row.wrong) << row.input;
    }
    if (!row.correct && count(row.findings, [](const CaseFinding& finding) { return finding.right == true; }) > 0) ++without;
  }
  EXPECT_LE(without, 12U) << "files that must be rejected";
}

TEST(Comparison, Has24ScenesOf100Views) {
  std::set<std::string> names;
  std::map<std::string, std::size_t> kinds;
  for (const ComparisonScene& scene : results().of<Comparison>().scenes) {
    names.insert(scene.name);
    ++kinds[scene.kind];
    std::map<std::string, std::size_t> views;
    for (const compare::AnswerRow& row : results().of<Comparison>().rows)
      if (row.scene == scene.name && row.picture == "lines") views[row.method] = row.views;
    for (const char* const method : {"exact", "jones", "montani-re"})
      EXPECT_EQ(views[method], 100U) << method << ", " << scene.name;
    EXPECT_EQ(views.contains("plantinga"), scene.kind == "polyhedra") << scene.name;
  }
  EXPECT_EQ(names.size(), 24U);
  EXPECT_EQ(kinds["built-in"], 5U);
  EXPECT_EQ(kinds["rooms"], 10U);
  EXPECT_EQ(kinds["polyhedra"], 9U);
}

TEST(Comparison, ExactMethodsAreExactAndProgramsEqualTheirTwins) {
  for (const compare::AnswerRow& row : results().of<Comparison>().rows) {
    EXPECT_EQ(row.defect, "") << row.method << ", " << row.scene;
    if (row.exact) {
      EXPECT_EQ(row.right, row.views) << row.method << ", " << row.scene;
    }
    EXPECT_FALSE(row.host_seconds) << "not requested";
  }
}

// More doors in the same walls, and every cell of a view is visible at least once.
TEST(Comparison, RoomsAscendByOpenness) {
  double before = 0;
  for (const ComparisonScene& room : results().of<Comparison>().rooms()) {
    EXPECT_EQ(room.walls, 24U);
    EXPECT_GT(*room.openness(), before);
    before = *room.openness();
    EXPECT_GE(room.visits, 1);
  }
  EXPECT_EQ(before, 8);
}

// One row per picture that a method has of a scene, with all methods, and a time for every program on a machine.
TEST(Opening, HasEveryMethod) {
  const OpeningAnswer& answer = results().of<OpeningAnswer>();
  std::set<std::string> methods;
  for (const compare::AnswerRow& row : answer.rows) {
    methods.insert(row.method);
    EXPECT_EQ(row.views, 1U) << row.method << ", " << row.scene;
    EXPECT_FALSE(row.host_seconds) << "not requested";
    const bool on_machine = row.method.find("-pdp7") != std::string::npos || row.method.find("-8080") != std::string::npos;
    EXPECT_EQ(row.emulated_seconds.has_value(), on_machine) << row.method << ", " << row.scene;
  }
  for (const std::string& name : compare::method_names()) EXPECT_TRUE(methods.contains(name)) << name;
  EXPECT_EQ(answer.scenes, 7U);
  EXPECT_EQ(answer.functions, 2U);
  EXPECT_TRUE(std::all_of(answer.plotted.begin(), answer.plotted.end(),
                          [](const compare::PlotPoint& point) { return point.panel == compare::PlotPanel::emulated; }));
}

// Together with other experiments on all processors, and alone on one.
TEST(ReportRun, IsTheSameTwice) {
  constexpr std::array parts{4, 5};
  Context one = quiet();
  one.jobs = 1;
  const auto first = report_of(parts, results(), quiet());
  const auto second = make_report(parts, one);
  ASSERT_TRUE(first) << first.error().message();
  ASSERT_TRUE(second) << second.error().message();
  EXPECT_TRUE(html_page(*first) == html_page(*second));
}

}  // namespace
}  // namespace sightline::report
