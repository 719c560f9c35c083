// Every status of the twin: when a view ends, and what it shows then.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

#include "host/programs/jones/twin/twin.hpp"
#include "tests/host/programs/jones/core.hpp"
#include "tests/host/programs/jones/drawing.hpp"

namespace sightline::programs::jones {
namespace {

// A frame is pushed for each level when the search goes deeper; under a rectangle it takes 9 words.
TEST(JonesTwinStatus, StackOverflow) {
  const TwinView full = view_of(grazing_doorways(50));
  EXPECT_EQ(full.status, Status::complete);
  EXPECT_EQ(full.counts.depth, 51);
  EXPECT_EQ(full.counts.stack_words, 450);
  const TwinView over = view_of(grazing_doorways(51));
  EXPECT_EQ(over.status, Status::stack_overflow);
  EXPECT_EQ(over.counts.depth, 51);
  EXPECT_TRUE(decode(over).well_formed);
}

TEST(JonesTwinStatus, SlopedEdgesTakeFourWordsOfAFrame) {
  // Openings in a wall to the right of the eye: on the screen their upper and lower sides are sloped.
  const auto to_the_right = [](std::int32_t x) {
    return TestChain{
        x, -x / 2, 2 * x, {{false, 2, x}, {false, 3, 2 * x}, {false, 2, -x}, {false, 3, -2 * x}}};
  };
  const auto words = [&](std::vector<TestOpening> openings) {
    const TwinView view = view_of(TestCore({{}, {}, {}, {}}, openings));
    EXPECT_EQ(view.status, Status::complete);
    EXPECT_EQ(view.counts.visits, openings.size() + 1);
    return view.counts.stack_words;
  };
  EXPECT_EQ(words({}), 0);
  EXPECT_EQ(words({{0, 1, to_the_right(20)}}), 9) << "the window alone: the mask in use is not on the stack";
  EXPECT_EQ(words({{0, 1, to_the_right(20)}, {1, 2, to_the_right(30)}}), 9 + 17);
  EXPECT_EQ(words({{0, 1, to_the_right(20)}, {1, 2, to_the_right(30)}, {2, 3, to_the_right(40)}}),
            9 + 17 + 17);
}

// The search tests first whether a mask is empty, then the depth, then the capacity of the stack.
TEST(JonesTwinStatus, DepthComesBeforeTheStack) {
  TestCore core = grazing_doorways(51);
  core.put(TestCore::header + 1, 51);
  EXPECT_EQ(view_of(core).status, Status::deeper_than_cells);
  TestCore touching({{}, {}, {}},
                    {{0, 1, doorway(100, -20, 0, -20, 20)}, {1, 2, doorway(200, 0, 20, -20, 20)}});
  touching.put(TestCore::header + 1, 2);
  EXPECT_EQ(view_of(touching).status, Status::complete);
}

TEST(JonesTwinStatus, DisplayFileOverflowLeavesRoomForTheStop) {
  TestChain chain{0, 0, 100, {}};
  for (int i = 0; i < 600; ++i) {
    chain.vectors.push_back({true, 1, i % 2 ? -10 : 10});
    chain.vectors.push_back({false, 2, i % 2 ? -10 : 10});
  }
  const TwinView view = view_of(TestCore({chain}, {}));
  EXPECT_EQ(view.status, Status::display_file_overflow);
  EXPECT_EQ(view.counts.pieces, 345U) << "four words each in 1384, less the first and the stop";
  EXPECT_EQ(view.display_file.size(), 1382U);
  EXPECT_TRUE(decode(view).well_formed);
}

TEST(JonesTwinStatus, TooManyMaskVertices) {
  // Stairs: `steps` steps up and to the right, then back along the outside.
  const auto view = [](int steps, bool split, bool actual) {
    TestChain ring{-20, -20, 100, {{false, 1, 40}, {false, 2, 40}}};
    for (int i = 0; i < steps; ++i) {
      ring.vectors.push_back({false, 1, i + 1 < steps ? -2 : -40 + 2 * (steps - 1)});
      ring.vectors.push_back({false, 2, i + 1 < steps ? -2 : -40 + 2 * (steps - 1)});
    }
    if (split) {
      ring.vectors[0].magnitude = 20;
      ring.vectors.insert(ring.vectors.begin(), {false, 1, 20});
    }
    for (TestVector& vector : ring.vectors) vector.actual = actual;
    return view_of(TestCore({{}, {}}, {{0, 1, ring}}));
  };
  const auto status = [&](int steps, bool split) { return view(steps, split, false).status; };
  EXPECT_EQ(status(7, false), Status::complete) << "16 corners";
  EXPECT_EQ(status(7, true), Status::too_many_mask_vertices) << "17 corners";
  EXPECT_EQ(status(8, false), Status::too_many_mask_vertices) << "18 corners";
  // Corner 17 is the end of the 16th side, which is drawn before.
  EXPECT_EQ(view(7, true, true).status, Status::too_many_mask_vertices);
  EXPECT_EQ(view(7, true, true).counts.pieces, 16U);
  EXPECT_EQ(view(7, false, true).counts.pieces, 16U);
}

TEST(JonesTwinStatus, DeeperThanTheNumberOfCells) {
  TestCore core({{}, {}}, {{0, 1, doorway(100, -20, 20, -20, 20)}});
  core.put(TestCore::header + 1, 1);
  EXPECT_EQ(view_of(core).status, Status::deeper_than_cells);
}

TEST(JonesTwinStatus, BadDataElement) {
  EXPECT_EQ(view_of(TestCore({{0, 0, 100, {{false, 0, 10}}}}, {})).status, Status::bad_data_element);
  const auto ring_status = [](std::vector<TestVector> vectors) {
    return view_of(TestCore({{}, {}}, {{0, 1, {0, 0, 100, std::move(vectors)}}})).status;
  };
  EXPECT_EQ(ring_status({}), Status::bad_data_element);
  EXPECT_EQ(ring_status({{false, 1, 10}, {false, 1, -10}}), Status::bad_data_element);
  EXPECT_EQ(ring_status({{false, 1, 10}, {false, 0, 10}}), Status::bad_data_element);
  EXPECT_EQ(ring_status({{false, 1, 10}, {false, 2, 10}, {true, 0, -10}}), Status::bad_data_element);
}

// An opening that is neither crossed nor drawn is not walked: only the words read by the scan for its plane matter.
TEST(JonesTwinStatus, ASkippedOpeningIsNotWalked) {
  const auto behind = [](std::vector<TestVector> vectors) {
    return view_of(TestCore({{}, {}}, {{0, 1, {0, 0, -5, std::move(vectors)}}})).status;
  };
  EXPECT_EQ(behind({{false, 1, 10}, {false, 2, 10}, {false, 0, -10}}), Status::complete);
  EXPECT_EQ(behind({{false, 1, 10}, {false, 2, 10}, {true, 0, -10}}), Status::bad_data_element);
  EXPECT_EQ(behind({{false, 1, 10}, {false, 2, 10}, {false, 0, 5}, {true, 1, 5}}), Status::bad_data_element);
  EXPECT_EQ(behind({{false, 1, 10}, {false, 0, 10}, {false, 2, 10}}), Status::bad_data_element);
  EXPECT_EQ(behind({{false, 0, 10}, {false, 2, 10}}), Status::bad_data_element);
  EXPECT_EQ(behind({{false, 1, 10}, {false, 1, -10}}), Status::bad_data_element);
  EXPECT_EQ(behind({}), Status::bad_data_element);
}

TEST(JonesTwinStatus, ArithmeticOverflowCannotComeFromAScene) {
  // Projected points are inside the bound, so the farthest corner at the largest scale can still be divided.
  Parameters parameters;
  parameters.scale = 4096;
  const TwinView view = view_of(
      TestCore(
          {{-16000,
            -16000,
            near_z,
            {{true, 1, 16383}, {true, 2, 16383}, {true, 3, 16383}, {true, 1, 16383}, {true, 3, -16383}}}},
          {}),
      parameters);
  EXPECT_EQ(view.status, Status::complete);
  EXPECT_LE(view.counts.largest_coordinate, 1 << 15);
}

TEST(JonesTwinStatus, GivesUpOnAListWithoutEnd) {
  TestCore core({{}}, {});
  core.put(TestCore::header + 11 + 4, 0);  // an entry that is not the last, and zeros in all of core
  Parameters parameters;
  parameters.limit = 1000;
  EXPECT_NE(view_of(core, parameters).status, Status::complete);
}

TEST(JonesTwinStatus, AnyCoreEndsWithSomeStatus) {
  std::mt19937 engine(7);
  std::set<Status> seen;
  for (int i = 0; i < 2000; ++i) {
    TestCore core({{}}, {});
    for (std::uint32_t at = 0; at < core_words; ++at) core.put(at, static_cast<std::uint32_t>(engine()));
    core.put(TestCore::header, static_cast<std::uint32_t>(engine()));
    for (std::uint32_t at = 3; at < core_words; at += 4) core.put(at, engine() % 8);
    Parameters parameters;
    parameters.limit = 20000;
    const TwinView view = run_twin(core.words, static_cast<std::uint32_t>(engine()) & 017777, parameters);
    seen.insert(view.status);
    EXPECT_LE(view.display_file.size(), display_file_words);
    EXPECT_TRUE(decode(view).well_formed);
  }
  EXPECT_GT(seen.size(), 1U);
}

}  // namespace
}  // namespace sightline::programs::jones
