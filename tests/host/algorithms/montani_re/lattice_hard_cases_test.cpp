// Those of the hard cases M7 to M18 that are regions on the lattice. A region contains the points inside an odd number of its
// chains.
// The areas and loops of exact regions are compared with stripes of one step, and with counted squares.
//
// A file has one chain per line: the name of the region, the starting point, links (0 east, 1 north-east,
// ... 7 south-east).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "tests/host/algorithms/montani_re/lattice_pcs.hpp"
#include "tests/host/scene/hard_case_files.hpp"

namespace sightline::algorithms::montani_re {
namespace {

using Loops = std::vector<std::vector<LatticePoint>>;

enum class Take { first, both, either, less };  // A; A and B; A or B; A less B

struct Region {
  std::vector<OwnedChain> chains;

  [[nodiscard]] LatticePcs pcs() const {
    std::vector<FreemanChain> views;
    for (const OwnedChain& chain : chains) views.push_back({chain.start, chain.links});
    const auto made = lattice_pcs(views);
    EXPECT_TRUE(made) << "a chain does not close";
    return made.value_or(LatticePcs{});
  }
  // A point in sixths of a step whose coordinates differ from those of all corners.
  [[nodiscard]] bool holds(const LatticePoint& place) const {
    constexpr std::array<LatticePoint, 8> steps{
        {{6, 0}, {6, 6}, {0, 6}, {-6, 6}, {-6, 0}, {-6, -6}, {0, -6}, {6, -6}}};
    bool odd = false;
    for (const OwnedChain& chain : chains) {
      LatticePoint from{6 * chain.start.x, 6 * chain.start.y};
      for (const char link : chain.links) {
        const LatticePoint& step = steps[static_cast<std::size_t>(link - '0')];
        const LatticePoint to{from.x + step.x, from.y + step.y};
        if ((from.y > place.y) != (to.y > place.y) && from.x + step.x * (place.y - from.y) / step.y > place.x)
          odd = !odd;
        from = to;
      }
    }
    return odd;
  }
};

struct Pair {
  Region a, b;
};

Pair regions_of(const std::string& file) {
  Pair pair;
  std::istringstream text(scene::hard_case_text(file));
  OwnedChain chain;
  for (char name = 0; text >> name >> chain.start.x >> chain.start.y >> chain.links;)
    (name == 'A' ? pair.a : pair.b).chains.push_back(chain);
  EXPECT_TRUE(text.eof()) << file;
  return pair;
}

LatticePcs combine_regions(const Pair& pair, Take take) {
  switch (take) {
    case Take::first: return pair.a.pcs();
    case Take::both: return intersect(pair.a.pcs(), pair.b.pcs());
    case Take::either: return unite(pair.a.pcs(), pair.b.pcs());
    case Take::less: return subtract(pair.a.pcs(), pair.b.pcs());
  }
  return {};
}

Loops loops_of(const LatticePcs& pcs) {
  Loops loops;
  for (const LatticeLoop& loop : boundary_of(pcs)) loops.push_back(loop.corners);
  return loops;
}

constexpr std::int32_t frame = 128;  // steps; no corner is farther

// For a face whose sides cross anywhere, in stripes of one step.
StripePcs in_stripes(const LatticePcs& pcs) {
  FaceSetBuilder builder(false);
  Rings rings;
  for (const auto& loop : loops_of(pcs)) {
    auto& ring = rings.emplace_back();
    for (const LatticePoint& p : loop) ring.push_back(builder.add_vertex({p.x, p.y, 0}));
  }
  builder.add_face(rings, 0, 0);
  const FaceSet set = builder.take();
  return stripe_pcs(set.image, set.faces[0].pcs, {{0.5, 0.5}, {0, 0}, frame, frame}, 16);
}

double area_of(const StripePcs& pcs) {
  double sixteenths = 0;
  for (const auto& stripe : pcs.stripes) {
    for (const StripeBand& band : stripe) {
      for (std::size_t k = 0; k + 1 < band.sides.size(); k += 2) {
        const auto across = [&](std::int32_t at) {
          return static_cast<double>(band.sides[k + 1].at(at) - band.sides[k].at(at)) / (16 * 65536);
        };
        sixteenths += (band.high - band.low) * (across(band.low) + across(band.high)) / 2;
      }
    }
  }
  return sixteenths / 16;
}

double area_in_stripes(const Pair& pair, Take take) {
  const StripePcs a = in_stripes(pair.a.pcs());
  if (take == Take::first) return area_of(a);
  const Operation operation = take == Take::both     ? Operation::intersect
                              : take == Take::either ? Operation::unite
                                                     : Operation::subtract;
  return area_of(combine(a, in_stripes(pair.b.pcs()), operation));
}

// Whether the middle of each quarter of each square is inside; a quarter is two eighths.
std::int64_t counted_eighths(const Pair& pair, Take take) {
  constexpr std::array<LatticePoint, 4> quarters{{{3, 1}, {5, 3}, {3, 5}, {1, 3}}};
  std::int64_t eighths = 0;
  for (std::int32_t y = 0; y < frame; ++y) {
    for (std::int32_t x = 0; x < frame; ++x) {
      for (const LatticePoint& quarter : quarters) {
        const LatticePoint place{6 * x + quarter.x, 6 * y + quarter.y};
        const bool a = pair.a.holds(place);
        if (!a && take != Take::either) continue;
        const bool b = take != Take::first && pair.b.holds(place);
        if (take == Take::first || (take == Take::both && b) || (take == Take::either && (a || b)) ||
            (take == Take::less && !b))
          eighths += 2;
      }
    }
  }
  return eighths;
}

// stripes_differ: the largest error, in square steps, of stripes of one step where sides cross inside a step.
void expect_region(const std::string& file, Take take, double area, std::size_t loop_count,
                   double stripes_differ = 0) {
  SCOPED_TRACE(file);
  const Pair pair = regions_of(file);
  const LatticePcs result = combine_regions(pair, take);
  const Loops loops = loops_of(result);
  EXPECT_EQ(static_cast<double>(eightfold_area(result)), 8 * area);
  EXPECT_EQ(static_cast<double>(counted_eighths(pair, take)), 8 * area);
  EXPECT_EQ(loops.size(), loop_count);
  EXPECT_EQ(lattice_pcs_of_half_steps(loops), result);
  EXPECT_EQ(std::abs(area_in_stripes(pair, take) - area), stripes_differ);
}

TEST(LatticeHardCases, M7HolesInHoles) {
  expect_region("M7.txt", Take::first, 10000 - 6400 + 3600 - 1600 + 400, 5);
}
TEST(LatticeHardCases, M8HolesThatTouch) {
  expect_region("M8.txt", Take::less, 400 - 64, 1);
  expect_region("M8-pair.txt", Take::either, 16, 2);
}
TEST(LatticeHardCases, M10NoEdgeBetweenUnitedRectangles) {
  expect_region("M10.txt", Take::either, 100, 1);
}
// Sides that cross inside a stripe: the doubled lattice is exact; stripes of one step are off by 1/256.
TEST(LatticeHardCases, M11SidesThatCrossInsideASquare) {
  expect_region("M11.txt", Take::first, 0.5, 1);
  expect_region("M11.txt", Take::both, 0.25, 1, 1.0 / 256);
  expect_region("M11.txt", Take::either, 0.75, 1, 1.0 / 256);
  expect_region("M11.txt", Take::less, 0.25, 1, 1.0 / 256);
}
TEST(LatticeHardCases, M12SidesThatMeetAtAStripesEnd) {
  expect_region("M12.txt", Take::first, 1, 1);
}
TEST(LatticeHardCases, M18RegionsOfFigure1) {
  expect_region("M18.txt", Take::first, 22, 1);
  expect_region("M18.txt", Take::either, 44, 3);
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
