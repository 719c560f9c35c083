// Results of the cross-check: a cell for every pair, failures by name, and all pictures.
#include <gtest/gtest.h>

#include "host/report/experiments/cross_check.hpp"

namespace sightline::report {
namespace {

constexpr std::string_view first_pair = "exact and jones";

// Two scenes; the second has one cell that differs and one that was not run.
const CrossCheck& two_scenes() {
  static const CrossCheck made = [] {
    CrossCheck checked;
    const compare::CommonScene first = compare::common_scene("C5");
    checked.add(first, compare::cross_check(first));
    const compare::CommonScene second = compare::common_scene("C8");
    compare::SceneCrossCheck agreement = compare::cross_check(second);
    agreement.cells[0].state = compare::CrossCheckState::differs;
    agreement.cells[0].text = "view 2: edge 1-2: here and there";
    agreement.cells[1].state = compare::CrossCheckState::not_run;
    checked.add(second, agreement);
    return checked;
  }();
  return made;
}

Cell verdict_of(std::string_view scene, std::string_view pair) {
  for (const PairVerdict& cell : two_scenes().cells)
    if (cell.scene == scene && cell.pair == pair) return cell.verdict;
  return std::string("no such pair");
}

TEST(CrossCheck, ReportsTheResultOfEveryPair) {
  const std::size_t all = compare::participants().size();
  EXPECT_EQ(two_scenes().cells.size(), 2 * (all * (all - 1) / 2));
  EXPECT_EQ(verdict_of("C5", "exact and oracle"), Cell(Verdict{true, "pieces"}));
  EXPECT_EQ(verdict_of("C5", "exact and skala"), Cell(std::string("n/a")));
  EXPECT_EQ(verdict_of("C5", "montani-re and oracle"), Cell(Verdict{true, "pieces, pixels"}));
  EXPECT_EQ(verdict_of("C8", first_pair), Cell(Verdict{false, "differs"}));
  EXPECT_EQ(verdict_of("C8", "exact and montani-re"), Cell(Verdict{false, "not run"}));
}

TEST(CrossCheck, FailuresAreNamed) {
  const std::vector<PairFailure>& failures = two_scenes().failures;
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_EQ(failures[0].scene, "C8");
  EXPECT_EQ(failures[0].pair, first_pair);
  EXPECT_EQ(failures[0].first, "view 2: edge 1-2: here and there");
  ASSERT_EQ(two_scenes().scenes.size(), 2U);
  EXPECT_TRUE(two_scenes().scenes[0].good);
  EXPECT_FALSE(two_scenes().scenes[1].good);
  EXPECT_FALSE(two_scenes().agrees());
  EXPECT_EQ(two_scenes().run(), two_scenes().scenes[0].listed + two_scenes().scenes[1].listed - 1) << "one cell was not run";
}

TEST(CrossCheck, EveryMethodHasAPicture) {
  std::string methods;
  for (const MethodPicture& picture : two_scenes().pictures)
    if (picture.scene == "C5") methods += picture.method + ";";
  EXPECT_EQ(methods, "exact;jones;montani-re;montani-re (faces);oracle;oracle (faces);plantinga;willis;stripes-8080;willis-8080;turn-pdp7;");
}

}  // namespace
}  // namespace sightline::report
