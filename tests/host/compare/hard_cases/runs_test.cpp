// Every row of the manifest is run by all methods that it names, with the recorded results; families fail first at the recorded
// value.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/willis/model.hpp"
#include "host/compare/hard_cases/first_failures.hpp"
#include "host/compare/hard_cases/manifest.hpp"
#include "host/compare/hard_cases/run_case.hpp"
#include "host/compare/hard_cases/runner.hpp"
#include "host/compare/hard_cases/willis_views.hpp"

namespace sightline::compare {
namespace {

Manifest manifest() {
  const auto read = read_manifest(hard_case_text("manifest.json"), "manifest.json");
  if (!read) ADD_FAILURE() << read.error().message();
  return read ? *read : Manifest{};
}

class HardCaseRuns : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(, HardCaseRuns,
                         testing::Values("jones", "skala", "willis", "montani-re", "plantinga"),
                         [](const auto& group) {
                           return group.param == "montani-re" ? std::string("montani_re") : group.param;
                         });

// Correct, or wrong exactly as recorded; a method that does not apply says so.
TEST_P(HardCaseRuns, GiveWhatTheManifestRecords) {
  for (const HardCaseGroup& group : manifest().groups) {
    if (group.id != GetParam()) continue;
    for (const HardCase& hard : group.cases)
      for (const MethodOutcome& method : run_case(hard).methods)
        EXPECT_TRUE(method.as_recorded) << hard.id << ' ' << hard.input << ", " << method.method << ": " << method.text;
  }
}

// The case with one expectation changed; `what` names it.
struct ChangedCase {
  std::string what;
  HardCase hard;
};

std::vector<ChangedCase> changed_expectations(const HardCase& hard) {
  std::vector<ChangedCase> changed;
  const auto add = [&](const std::string& what) -> Expectation& {
    changed.push_back({what, hard});
    return changed.back().hard.expect;
  };
  for (const auto& [name, value] : hard.expect.counts) add(name).counts[name] = value + 1;
  for (std::size_t i = 0; i < hard.expect.areas.size(); ++i) add("areas").areas[i] += 1;
  for (const SceneSegment& segment : hard.expect.seen) add("seen").hidden.push_back(segment);
  for (const SceneSegment& segment : hard.expect.hidden) add("hidden").seen.push_back(segment);
  if (hard.expect.through) add("through").through = {{97, 98}};
  if (hard.expect.dots) ++*add("dots").dots;
  if (hard.expect.refused) add("refused").refused = false;
  if (hard.expect.program_refuses) add("program_refuses").program_refuses = false;
  if (hard.expect.eye_refused) add("eye_refused").eye_refused = false;
  if (hard.expect.left_over) add("left_over").left_over = false;
  return changed;
}

// An expectation that no method checks would always pass.
TEST_P(HardCaseRuns, EveryExpectationIsChecked) {
  for (const HardCaseGroup& group : manifest().groups) {
    if (group.id != GetParam()) continue;
    for (const HardCase& hard : group.cases) {
      for (ChangedCase& changed : changed_expectations(hard)) {
        CaseRun run(std::move(changed.hard), load_input(hard));
        const bool noticed = std::any_of(hard.run.begin(), hard.run.end(), [&](const std::string& method) {
          return !hard.found.contains(method) && run.run(method).good == false;
        });
        EXPECT_TRUE(noticed) << hard.id << ' ' << hard.input << ": " << changed.what;
      }
    }
  }
}

// The method measures the distance of a piece to its first corner. Any other corner must also give correct pictures.
TEST(WillisCorners, AnyCornerMayGiveTheDistance) {
  namespace views = sightline::compare;
  std::size_t cases = 0;
  for (const HardCaseGroup& group : manifest().groups) {
    if (group.id != "willis") continue;
    for (const HardCase& hard : group.cases) {
      const auto input = load_input(hard);
      ASSERT_TRUE(input) << hard.id;
      const scene::PolyScene& scene = *input->scene;
      algorithms::willis::ModelOptions options;
      options.plan = hard.options.faces.plan;
      options.rules.rule90 = hard.options.faces.rule90;
      if (hard.options.faces.oval) options.rules.shape = algorithms::willis::BoundaryShape::oval;
      options.order_cells = hard.options.faces.order_cells;
      const auto model = algorithms::willis::make_model(scene, options);
      ASSERT_TRUE(model) << hard.id;
      auto cameras = views::cameras_around(scene, scene.camera.eye[1]);
      if (!hard.expect.eye_refused) cameras.insert(cameras.begin(), scene.camera);
      const views::TrueFaces truth(scene, std::move(cameras), 128);
      EXPECT_EQ(truth.errors_of(*model).wrong_inside, 0U) << hard.id << ' ' << hard.input;
      ++cases;
    }
  }
  EXPECT_GT(cases, 20U);
}

TEST(HardCaseFamilies, FailFirstAsRecorded) {
  for (const Family& family : manifest().families) {
    const auto results = run_family(family);
    ASSERT_TRUE(results) << results.error().message();
    ASSERT_EQ(results->size(), family.builds.size());
    for (const FamilyResult& result : *results) {
      const SearchResult& search = result.search;
      EXPECT_TRUE(result.as_recorded) << family.id << " " << family.generator << ", " << result.build << ": "
                                      << (search.first ? fmt::format("fails at {}: {}", search.tried[*search.first].first,
                                                                     *search.tried[*search.first].second.fault)
                                                       : "does not fail");
    }
  }
}

}  // namespace
}  // namespace sightline::compare
