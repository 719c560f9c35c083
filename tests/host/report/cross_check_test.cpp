// Records of the cross-check: a cell for every pair, failures by name, and every picture there is.
#include <gtest/gtest.h>

#include "host/report/experiment.hpp"
#include "host/report/experiments/cross_check.hpp"

namespace sightline::report {
namespace {

constexpr std::string_view first_pair = "exact and jones";

// Two scenes, of which the second has one cell that differs and one that was not run.
const Records& two_scenes() {
  static const Records made = [] {
    Records records;
    const compare::CommonScene first = compare::common_scene("C5");
    add_cross_check(records, first, compare::cross_check(first));
    const compare::CommonScene second = compare::common_scene("C8");
    compare::SceneCrossCheck agreement = compare::cross_check(second);
    agreement.cells[0].state = compare::CrossCheckState::differs;
    agreement.cells[0].text = "view 2: edge 1-2: here and there";
    agreement.cells[1].state = compare::CrossCheckState::not_run;
    add_cross_check(records, second, agreement);
    return records;
  }();
  return made;
}

Value verdict_of(std::string_view scene, std::string_view pair) {
  const RowSet& cells = two_scenes().at("cells");
  for (std::size_t row = 0; row < cells.size(); ++row)
    if (cells.at(row, "column") == Value(scene) && cells.at(row, "pair") == Value(pair)) return cells.at(row, "verdict");
  return Value("no such pair");
}

TEST(CrossCheck, SaysOfEveryPairWhatItDid) {
  const std::size_t all = compare::participants().size();
  EXPECT_EQ(two_scenes().at("cells").size(), 2 * (all * (all - 1) / 2));
  EXPECT_EQ(verdict_of("c5", "exact and oracle"), Value(Verdict{true, "pieces"}));
  EXPECT_EQ(verdict_of("c5", "exact and skala"), Value("n/a"));
  EXPECT_EQ(verdict_of("c5", "montani-re and oracle"), Value(Verdict{true, "pieces, pixels"}));
  EXPECT_EQ(verdict_of("c8", first_pair), Value(Verdict{false, "differs"}));
  EXPECT_EQ(verdict_of("c8", "exact and montani-re"), Value(Verdict{false, "not run"}));
}

TEST(CrossCheck, FailuresAreNamed) {
  const RowSet& failures = two_scenes().at("failures");
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_EQ(failures.at(0, "scene"), Value("C8"));
  EXPECT_EQ(failures.at(0, "pair"), Value(first_pair));
  EXPECT_EQ(failures.at(0, "first"), Value("view 2: edge 1-2: here and there"));
  const RowSet& scenes = two_scenes().at("scenes");
  EXPECT_EQ(scenes.at(0, "result"), Value(Verdict{true, "all agree"}));
  EXPECT_EQ(scenes.at(1, "result"), Value(Verdict{false, "not all agree"}));
}

TEST(CrossCheck, EveryMethodHasAPicture) {
  const RowSet& pictures = two_scenes().at("pictures");
  std::string methods;
  for (std::size_t row = 0; row < pictures.size(); ++row)
    if (pictures.at(row, "scene") == Value("C5")) methods += std::string(*pictures.at(row, "method").text()) + ";";
  EXPECT_EQ(methods, "exact;jones;montani-re;montani-re (faces);oracle;oracle (faces);plantinga;willis;stripes-8080;willis-8080;turn-pdp7;");
}

}  // namespace
}  // namespace sightline::report
