// Willis in parts 1 and 2 of the report: the paper's numbers are all there, nothing is wrong where no pair of
// surfaces is left over, and the 90-degree rule costs what it must.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "host/report/speed_error/willis.hpp"
#include "host/report/table_text.hpp"
#include "host/report/timing/willis.hpp"
#include "host/report/timing/willis_pictures.hpp"

namespace sightline::harness::report {
namespace {

Context quiet() {
  Context context;
  context.host_times = false;
  return context;
}

std::map<std::string, Table> tables_of(const Outcome<std::vector<Block>>& made) {
  std::map<std::string, Table> tables;
  for (const Block& block : *made) {
    const auto* const table = std::get_if<Table>(&block);
    if (table == nullptr) continue;
    for (const auto& row : table->rows) EXPECT_EQ(row.size(), table->columns.size()) << table->id;
    tables.emplace(table->id, *table);
  }
  return tables;
}

std::int64_t number(const Table& table, std::size_t row, std::string_view key) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].key == key) return std::get<std::int64_t>(table.rows.at(row).at(i));
  throw std::out_of_range(std::string(key));
}

TEST(WillisTiming, HasThePapersNumbersAndWhatTheRuleCosts) {
  const auto tables = tables_of(timing_of_willis(quiet()));
  std::string said;
  for (const auto& row : tables.at("willis-paper").rows)
    said += shown_text(row[1]) + ' ' + shown_text(row[2]) + '\n';
  for (const char* const words :
       {"25 per second\" 25\n", "about 2%\" 1.69\n", "about 65%\" 65.28\n", "5.1416"})
    EXPECT_NE(said.find(words), std::string::npos) << words << " in " << said;
  const Table& scenes = tables.at("willis-scenes");
  for (std::size_t row = 0; row < scenes.rows.size(); ++row) {
    EXPECT_EQ(number(scenes, row, "left_over"), 0) << row;
    EXPECT_LE(number(scenes, row, "distances"), number(scenes, row, "pieces"));
  }
  const Table& rule = tables.at("willis-rule90");
  std::int64_t wrong = 0;
  for (std::size_t row = 0; row + 1 < rule.rows.size(); row += 2) {
    EXPECT_EQ(number(rule, row, "lines_wrong"), 0) << row;
    EXPECT_EQ(number(rule, row, "points_wrong"), 0) << row;
    EXPECT_LE(number(rule, row + 1, "pieces"), number(rule, row, "pieces"));
    EXPECT_LE(number(rule, row + 1, "tests"), number(rule, row, "tests"));
    wrong += number(rule, row + 1, "lines_wrong");
  }
  EXPECT_GT(wrong, 0) << "models without a pair left over, and wrong";
}

// With nothing cut something is wrong in the picture, or it would show nothing; cut, nothing away from edges.
TEST(WillisTiming, PicturesShowWhatIsWrong) {
  const auto made = willis_pictures();
  ASSERT_TRUE(made);
  const auto& figures = made->figures;
  ASSERT_EQ(figures.size(), 3U);
  const auto inside = [](const Figure& figure) {
    constexpr std::string_view before = "points wrong: ";
    return std::stol(figure.caption.text.substr(figure.caption.text.find(before) + before.size()));
  };
  EXPECT_GT(inside(figures.front()), 0) << figures.front().caption.text;
  EXPECT_EQ(inside(figures.back()), 0) << figures.back().caption.text;
}

// Between the first cut and the last the error may rise, too: a cut makes pairs that were none before.
TEST(WillisSpeedError, CutsGoOnUntilNothingIsLeftOverAndThenNothingIsWrong) {
  const auto curves = measure_willis(quiet());
  ASSERT_EQ(curves.size(), 16U);
  for (const WillisCurve& curve : curves) {
    ASSERT_EQ(curve.points.size(), 9U);
    for (std::size_t depth = 1; depth < curve.points.size(); ++depth) {
      EXPECT_GE(curve.points[depth].pieces, curve.points[depth - 1].pieces) << curve.name() << depth;
      if (!curve.rules.rule90 && curve.points[depth].left_over == 0) {
        EXPECT_EQ(curve.points[depth].lines.wrong, 0U) << curve.name() << depth;
        EXPECT_EQ(curve.points[depth].faces.wrong_inside, 0U) << curve.name() << depth;
      }
    }
    EXPECT_EQ(curve.points.back().left_over, 0U) << curve.name() << ": else nothing was shown";
  }
  // A town of the kind whose figures are published, 0.06 and 0.49 % with nothing cut.
  const WillisPoint& uncut = curves[0].points[0];
  const double per_cent =
      100.0 * static_cast<double>(uncut.lines.wrong) / static_cast<double>(uncut.lines.with_two);
  EXPECT_GT(per_cent, 0.02);
  EXPECT_LT(per_cent, 2);
  const auto tables = tables_of(willis_error_blocks(curves));
  EXPECT_EQ(tables.at("willis-speed-error").rows.size(), 16U * 9);
}

}  // namespace
}  // namespace sightline::harness::report
