// Records of the cross-check: a cell for every pair, failures by name, and every picture there is.
#include <gtest/gtest.h>

#include "host/report/experiment.hpp"
#include "host/report/experiments/cross_check.hpp"

namespace sightline::report {
namespace {

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

TEST(CrossCheck, SaysOfEveryPairWhatItDid) {
  const RowSet& cells = two_scenes().at("cells");
  constexpr std::size_t pairs = 21;
  ASSERT_EQ(cells.size(), 2 * pairs);
  EXPECT_EQ(cells.at(0, "pair"), Value("exact and oracle"));
  EXPECT_EQ(cells.at(0, "verdict"), Value(Verdict{true, "pieces"}));
  EXPECT_EQ(cells.at(2, "verdict"), Value("n/a")) << "exact and skala";
  EXPECT_EQ(cells.at(8, "verdict"), Value(Verdict{true, "pieces, pixels"})) << "oracle and montani-re";
  EXPECT_EQ(cells.at(pairs, "column"), Value("c8"));
  EXPECT_EQ(cells.at(pairs, "verdict"), Value(Verdict{false, "differs"}));
  EXPECT_EQ(cells.at(pairs + 1, "verdict"), Value(Verdict{false, "not run"}));
}

TEST(CrossCheck, FailuresAreNamed) {
  const RowSet& failures = two_scenes().at("failures");
  ASSERT_EQ(failures.size(), 2U);
  EXPECT_EQ(failures.at(0, "scene"), Value("C8"));
  EXPECT_EQ(failures.at(0, "pair"), Value("exact and oracle"));
  EXPECT_EQ(failures.at(0, "first"), Value("view 2: edge 1-2: here and there"));
  const RowSet& scenes = two_scenes().at("scenes");
  EXPECT_EQ(scenes.at(0, "result"), Value(Verdict{true, "all agree"}));
  EXPECT_EQ(scenes.at(1, "result"), Value(Verdict{false, "not all agree"}));
}

TEST(CrossCheck, TheStripShowsEveryPictureThereIs) {
  const RowSet& pictures = two_scenes().at("pictures");
  EXPECT_EQ(pictures.at(0, "methods"),
            Value("exact, oracle, oracle (faces), jones, montani-re, montani-re (faces), willis, plantinga"));
  EXPECT_EQ(pictures.at(0, "pictures"), Value(8));
}

}  // namespace
}  // namespace sightline::report
