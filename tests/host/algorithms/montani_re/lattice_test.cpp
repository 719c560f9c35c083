// Stripes on the lattice: Table 1 of the paper entry by entry, conversion to chains and back, set operations compared with four
// bits
// per square, outlines and holes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "tests/host/algorithms/montani_re/tetrakis.hpp"

namespace sightline::algorithms::montani_re {
namespace {

// Figure 1 is illegible; these chains, with the paper's starting points, give Table 1.
const std::array<FreemanChain, 3> figure_1{{{{6, 11}, "6666666664222222253666666642222222220710"},
                                            {{12, 2}, "22231222344466666666602222076660"},
                                            {{11, 8}, "23466601"}}};

std::string row_of(const LatticeStripe& stripe) {
  std::string row;
  for (const LatticeSide& side : stripe.sides) {
    row += std::to_string(side.abscissa()) + '(' + std::to_string(static_cast<int>(side.type())) + ") ";
  }
  return row;
}

TEST(LatticePcs, Table1) {
  const std::string low = "2(2) 3(2) 5(2) 6(2) 8(2) 9(2) 11(2) 12(2) ";
  const std::map<int, std::string> table{{10, "2(2) 3(3) 4(1) 6(2) 8(2) 11(3) "},
                                         {9, "2(2) 6(2) 8(2) 9(2) 10(3) 12(2) "},
                                         {8, "2(2) 3(2) 3(3) 4(1) 5(2) 6(2) 8(2) 9(2) 11(2) 12(2) "},
                                         {7, "2(2) 3(2) 5(2) 6(2) 8(2) 9(2) 10(1) 12(2) "},
                                         {6, "2(2) 3(2) 5(2) 6(2) 8(2) 11(1) "},
                                         {5, "2(2) 3(2) 5(2) 6(2) 8(2) 9(2) 10(3) 11(3) "},
                                         {4, low},
                                         {3, low},
                                         {2, low}};
  const auto stripes = whole_stripes(lattice_pcs(figure_1).value());
  ASSERT_TRUE(stripes.has_value());
  std::map<int, std::string> ours;
  for (const LatticeStripe& stripe : *stripes) ours[stripe.y] = row_of(stripe);
  EXPECT_EQ(ours, table);
}

TEST(LatticePcs, ChainsOfFigure1RoundTrip) {
  const LatticePcs pcs = lattice_pcs(figure_1).value();
  const auto loops = boundary_of(pcs);
  ASSERT_EQ(loops.size(), 3U);
  std::vector<std::int64_t> areas;
  std::vector<OwnedChain> chains;
  for (const LatticeLoop& loop : loops) {
    areas.push_back(loop.eightfold_area() / 8);
    chains.push_back(chain_of(loop).value());
  }
  std::sort(areas.begin(), areas.end());
  EXPECT_EQ(areas, (std::vector<std::int64_t>{-5, 22, 27}));
  std::vector<FreemanChain> given;
  std::size_t links = 0;
  for (const OwnedChain& chain : chains) {
    given.push_back({chain.start, chain.links});
    links += chain.links.size();
  }
  EXPECT_EQ(links, 40U + 32U + 8U);
  EXPECT_EQ(lattice_pcs(given), pcs);
}

TEST(LatticePcs, ChainsThatDoNotCloseAreErrors) {
  const std::array<FreemanChain, 1> open{{{{0, 0}, "0022"}}};
  const std::array<FreemanChain, 1> strange{{{{0, 0}, "0248"}}};
  EXPECT_FALSE(lattice_pcs(open).has_value());
  EXPECT_FALSE(lattice_pcs(strange).has_value());
}

TEST(LatticePcs, TwoThousandSetOperations) {
  EXPECT_EQ(wrong_set_operations(1985, 667), 0);
}

TEST(LatticePcs, RandomSetsRoundTrip) {
  RandomPolygons random(3);
  for (int round = 0; round < 300; ++round) {
    const LatticePcs pcs = pcs_of(random.polygons());
    std::vector<std::vector<LatticePoint>> loops;
    std::int64_t area = 0;
    for (const LatticeLoop& loop : boundary_of(pcs)) {
      loops.push_back(loop.corners);
      area += loop.eightfold_area();
    }
    ASSERT_EQ(lattice_pcs_of_half_steps(loops), pcs) << round;
    ASSERT_EQ(area, eightfold_area(pcs)) << round;
  }
}

LatticePcs square(std::int32_t low, std::int32_t high) {
  return lattice_pcs_of_half_steps(std::vector<std::vector<LatticePoint>>{
      {{2 * low, 2 * low}, {2 * high, 2 * low}, {2 * high, 2 * high}, {2 * low, 2 * high}}});
}

// M8: a hole whose corner touches the outline, and two that touch each other.
TEST(LatticePcs, HolesThatTouch) {
  const auto diamond = [](std::int32_t x, std::int32_t y, std::int32_t r) {
    return lattice_pcs_of_half_steps(std::vector<std::vector<LatticePoint>>{
        {{2 * (x - r), 2 * y}, {2 * x, 2 * (y - r)}, {2 * (x + r), 2 * y}, {2 * x, 2 * (y + r)}}});
  };
  const LatticePcs touched = subtract(subtract(square(0, 20), diamond(10, 4, 4)), diamond(10, 12, 4));
  EXPECT_EQ(eightfold_area(touched), 8 * (400 - 32 - 32));
  for (const LatticeStripe& stripe : touched.half_stripes) {
    for (std::size_t k = 0; k + 1 < stripe.sides.size(); ++k) EXPECT_NE(stripe.sides[k], stripe.sides[k + 1]);
    if (stripe.y < 32) {
      EXPECT_EQ(stripe.sides.size(), 4U) << stripe.y;
    }
  }
  std::int64_t area = 0;
  for (const LatticeLoop& loop : boundary_of(touched)) area += loop.eightfold_area();
  EXPECT_EQ(area, eightfold_area(touched));
  // Two diamonds corner to corner are two loops, not one of figure eight.
  const auto pair = boundary_of(unite(diamond(5, 5, 2), diamond(9, 5, 2)));
  ASSERT_EQ(pair.size(), 2U);
  EXPECT_EQ(pair[0].corners.size(), 4U);
}

// M10 to M12
TEST(LatticePcs, JoinsAndCrossings) {
  const auto rectangle = [](std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
    return lattice_pcs_of_half_steps(std::vector<std::vector<LatticePoint>>{
        {{2 * x0, 2 * y0}, {2 * x1, 2 * y0}, {2 * x1, 2 * y1}, {2 * x0, 2 * y1}}});
  };
  EXPECT_EQ(unite(rectangle(0, 0, 10, 5), rectangle(0, 5, 10, 10)), square(0, 10));
  // "/" from x = 0 and "\" from x = 1 cross in the middle of the square.
  const std::vector<std::vector<LatticePoint>> rising{{{0, 0}, {2, 2}, {0, 2}}};
  const std::vector<std::vector<LatticePoint>> falling{{{2, 0}, {2, 2}, {0, 2}}};
  const LatticePcs a = lattice_pcs_of_half_steps(rising);
  const LatticePcs b = lattice_pcs_of_half_steps(falling);
  EXPECT_EQ(eightfold_area(a), 4);
  EXPECT_EQ(eightfold_area(intersect(a, b)), 2);
  EXPECT_EQ(eightfold_area(unite(a, b)), 6);
  EXPECT_FALSE(whole_stripes(intersect(a, b)).has_value());
  // "/" from 0 and "\" from 2 meet at (1, 1), the end of their stripe.
  const std::array<FreemanChain, 1> roof{{{{0, 0}, "0035"}}};
  const auto stripes = whole_stripes(lattice_pcs(roof).value());
  ASSERT_TRUE(stripes.has_value());
  ASSERT_EQ(stripes->size(), 1U);
  EXPECT_EQ((*stripes)[0].sides, (std::vector<LatticeSide>{{0, 1}, {2, 1}}));
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
