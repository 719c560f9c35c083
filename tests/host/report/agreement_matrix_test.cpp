// Part 5: a cell for every pair, and failures by name.
#include <gtest/gtest.h>

#include <vector>

#include "host/report/agreement/matrix.hpp"
#include "host/report/agreement/pictures.hpp"

namespace sightline::harness::report {
namespace {

// A matrix of two scenes, of which the second has one cell that differs and one that was not run.
std::vector<AgreedScene> two_scenes() {
  std::vector<AgreedScene> scenes;
  for (const char* name : {"C5", "C8"}) {
    const compare::CommonScene scene = compare::common_scene(name);
    scenes.push_back({scene, compare::cross_check(scene)});
  }
  compare::CrossCheckCell& differs = scenes[1].agreement.cells[0];
  differs.state = compare::CrossCheckState::differs;
  differs.text = "view 2: edge 1-2: here and there";
  scenes[1].agreement.cells[1].state = compare::CrossCheckState::not_run;
  return scenes;
}

TEST(AgreementMatrix, SaysOfEveryPairWhatItDid) {
  const auto scenes = two_scenes();
  const Table table = agreement_matrix(scenes);
  ASSERT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.columns[2].key, "c8");
  ASSERT_EQ(table.rows.size(), 21U);
  EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "exact and oracle");
  EXPECT_EQ(std::get<Verdict>(table.rows[0][1]), (Verdict{true, "pieces"}));
  EXPECT_EQ(std::get<Verdict>(table.rows[0][2]), (Verdict{false, "differs"}));
  EXPECT_EQ(std::get<Verdict>(table.rows[1][2]), (Verdict{false, "not run"}));
  EXPECT_EQ(std::get<std::string>(table.rows[2][1]), "n/a");                          // exact and skala
  EXPECT_EQ(std::get<Verdict>(table.rows[8][1]), (Verdict{true, "pieces, pixels"}));  // oracle and montani-re
}

TEST(AgreementMatrix, FailuresAreNamed) {
  const auto scenes = two_scenes();
  const Table table = agreement_failures(scenes);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "C8");
  EXPECT_EQ(std::get<std::string>(table.rows[0][1]), "exact and oracle");
  EXPECT_EQ(std::get<std::string>(table.rows[0][2]), "view 2: edge 1-2: here and there");
  EXPECT_FALSE(scenes[1].agreement.agrees());
  EXPECT_TRUE(agreement_failures({scenes.data(), 1}).rows.empty());
}

TEST(AgreementMatrix, TheStripShowsEveryPictureThereIs) {
  const compare::CommonScene scene = compare::common_scene("C5");
  const auto strip = agreement_strip(scene, compare::cross_check(scene));
  ASSERT_TRUE(strip);
  EXPECT_EQ(strip->caption,
            "From the left: exact, oracle, oracle (faces), jones, montani-re, montani-re (faces), willis, "
            "plantinga.");
}

}  // namespace
}  // namespace sightline::harness::report
