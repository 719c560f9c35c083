// The parts' tables: that they hold the rows promised, and what must be true of any run.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "host/report/scene_needs/scene_needs.hpp"
#include "host/report/timing/papers.hpp"

namespace sightline::harness::report {
namespace {

using Tables = std::map<std::string, Table>;

Tables tables_of(const Section& section) {
  Tables tables;
  for (const Block& block : section.blocks)
    if (const auto* const table = std::get_if<Table>(&block)) tables.emplace(table->id, *table);
  return tables;
}

Context quiet() {
  Context context;
  context.host_times = false;
  return context;
}

const Section& timing() {
  static const Section section = *timing_against_papers(quiet());
  return section;
}

const Section& needs() {
  static const Section section = *scene_needs(quiet());
  return section;
}

std::size_t place_of(const Table& table, std::string_view key) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& column) { return column.key == key; });
  if (found == table.columns.end()) throw std::out_of_range(table.id + " has no column " + std::string(key));
  return static_cast<std::size_t>(found - table.columns.begin());
}

const Cell& cell(const Table& table, std::size_t row, std::string_view key) {
  return table.rows.at(row).at(place_of(table, key));
}

std::int64_t number(const Table& table, std::size_t row, std::string_view key) {
  return std::get<std::int64_t>(cell(table, row, key));
}

double real(const Table& table, std::size_t row, std::string_view key) {
  return std::get<Real>(cell(table, row, key)).value;
}

// The words under which the papers' numbers stand in them.
TEST(ReportTiming, HasEveryNumberOfThePapersAndSaysWhatComesOfIt) {
  const Tables tables = tables_of(timing());
  std::string said;
  for (const char* const id : {"jones-paper-times", "jones-paper-sizes", "skala-paper"}) {
    const Table& table = tables.at(id);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      EXPECT_FALSE(std::get<std::string>(cell(table, row, "place")).empty()) << id << row;
      EXPECT_FALSE(std::get<std::string>(cell(table, row, "comparison")).empty()) << id << row;
      said += std::get<std::string>(cell(table, row, "says")) + "\n";
    }
  }
  for (const char* const words :
       {"a few seconds\"", "order of a few seconds", "show the computing time in seconds", "several minutes",
        "sixteen frames per second", "8192 18-bit words", "1.75 microseconds", "eight sense switches",
        "opening-element", "cell-element", "stereoscopic pair", "2 sec. approximately", "about 15% slower",
        "256x256 points", "8 colours", "3MHz", "1024 columns"})
    EXPECT_NE(said.find(words), std::string::npos) << words;
}

TEST(ReportTiming, HasAllScenesAndFunctions) {
  const Tables tables = tables_of(timing());
  const Table& views = tables.at("jones-views");
  ASSERT_EQ(views.rows.size(), 10U);
  for (std::size_t row = 0; row < views.rows.size(); row += 2) {
    EXPECT_EQ(cell(views, row, "scene"), cell(views, row + 1, "scene"));
    EXPECT_GT(real(views, row + 1, "second_view_s"), 2 * real(views, row, "second_view_s"))
        << "the EAE multiplies and divides far quicker than a program";
    EXPECT_EQ(number(views, row, "pieces"), number(views, row + 1, "pieces"));
    EXPECT_GE(real(views, row, "second_view_s"), real(views, row, "first_view_s"))
        << "the display takes cycles from the second view";
  }
  EXPECT_EQ(tables.at("skala-functions").rows.size(), 24U);
  EXPECT_EQ(tables.at("skala-long-slices").rows.size(), 8U);
}

TEST(ReportTiming, ShowsEveryRun) {
  std::map<std::string, std::size_t> pictures;
  for (const Block& block : timing().blocks) {
    const auto* const gallery = std::get_if<Gallery>(&block);
    if (gallery == nullptr) continue;
    pictures[gallery->id] = gallery->figures.size();
    for (const Figure& figure : gallery->figures) {
      EXPECT_EQ(figure.media_type, "image/png");
      EXPECT_GT(figure.bytes.size(), 100U) << figure.id;
      EXPECT_FALSE(figure.alternative.empty()) << figure.id;
    }
  }
  EXPECT_EQ(pictures,
            (std::map<std::string, std::size_t>{
                {"jones-phosphor", 5}, {"jones-screens", 5}, {"skala-rasters", 24}, {"willis-pictures", 3}}));
}

// Fig. 6 gives the layout: what the words of all openings come to is counted apart from the assembler.
TEST(ReportTiming, TheLayoutOfFigure6IsTheProgramsOwn) {
  const Table sizes = tables_of(timing()).at("jones-paper-sizes");
  for (std::size_t row = 0; row < sizes.rows.size(); ++row) {
    if (std::get<std::string>(cell(sizes, row, "says")).find("opening-element") == std::string::npos)
      continue;
    EXPECT_EQ(number(sizes, row, "here_least"), number(sizes, row, "here_greatest"));
    return;
  }
  FAIL() << "no row of opening-elements";
}

TEST(ReportNeeds, HoldsEachSceneAgainstWhatThereWas) {
  const Tables tables = tables_of(needs());
  const Table& core = tables.at("jones-core");
  const Table& work = tables.at("jones-work");
  ASSERT_EQ(core.rows.size(), 10U);
  ASSERT_EQ(work.rows.size(), 10U);
  for (std::size_t row = 0; row < core.rows.size(); ++row) {
    EXPECT_EQ(number(core, row, "core_words"), 8192);
    EXPECT_LE(number(core, row, "used_words"), 8192);
    EXPECT_GE(number(core, row, "used_words"),
              number(core, row, "program_words") + number(core, row, "scene_words"));
    EXPECT_LE(number(core, row, "file_words"), number(core, row, "file_room_words"));
    EXPECT_LE(number(core, row, "stack_words"), number(core, row, "stack_room_words"));
    EXPECT_LE(number(work, row, "cells_read"), number(work, row, "cells"));
    EXPECT_GE(number(work, row, "visits"), number(work, row, "cells_read"));
    EXPECT_LE(number(work, row, "depth"), number(work, row, "cells"));
    EXPECT_GT(number(work, row, "stolen_cycles"), 0);
  }
  EXPECT_EQ(tables.at("skala-work").rows.size(), 24U);
  const Table& memory = tables.at("skala-memory");
  for (const char* const picture : {"lines_bytes", "surface_bytes", "contours_bytes"}) {
    std::int64_t sum = 0;
    for (std::size_t row = 0; row + 1 < memory.rows.size(); ++row) sum += number(memory, row, picture);
    EXPECT_LE(sum, number(memory, memory.rows.size() - 1, picture)) << picture;
  }
}

// "Cells to which access is not gained in this way are never even considered."
TEST(ReportNeeds, UnseenRoomsCostTheMachineNothing) {
  const Table guest = tables_of(needs()).at("unseen-guest");
  ASSERT_EQ(guest.rows.size(), 4U);
  for (const std::size_t row : {0U, 2U}) {
    EXPECT_EQ(number(guest, row, "cells"), 8);
    EXPECT_EQ(number(guest, row + 1, "cells"), 32);
    for (const char* const same : {"cells_read", "visits", "instructions"})
      EXPECT_EQ(number(guest, row, same), number(guest, row + 1, same)) << same;
    EXPECT_EQ(real(guest, row, "view_s"), real(guest, row + 1, "view_s"));
  }
}

TEST(ReportNeeds, ABuildingBesideTheHouseChangesNothingButTheNumberOfCells) {
  const Table house = tables_of(needs()).at("unseen-house");
  ASSERT_EQ(house.rows.size(), 4U);
  std::int64_t cells = 0;
  for (std::size_t row = 0; row < house.rows.size(); ++row) {
    EXPECT_GT(number(house, row, "cells"), cells);
    cells = number(house, row, "cells");
    EXPECT_GT(cells, number(house, row, "rooms"));
    // Of the house there are 64 rooms and what lies around them.
    EXPECT_LT(number(house, row, "cells_seen"), 100);
    for (const char* const same : {"cells_seen", "visits", "segments"})
      EXPECT_EQ(number(house, row, same), number(house, 0, same)) << same;
  }
}

}  // namespace
}  // namespace sightline::harness::report
