// Montani and Re in the report: the paper's tables come out, and the measures of stripes know a square and say no
// where they must.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <variant>

#include "host/report/lattice_chains.hpp"
#include "host/report/montani_re_growth.hpp"
#include "host/report/montani_re_pixels.hpp"
#include "host/report/speed_error/montani_re.hpp"
#include "host/report/table_text.hpp"
#include "host/report/timing/montani_re.hpp"

namespace sightline::harness::report {
namespace {

Context quiet() {
  Context context;
  context.host_times = false;
  return context;
}

bool good(const Cell& cell) {
  return std::holds_alternative<Verdict>(cell) && std::get<Verdict>(cell).good;
}

TEST(MontaniReChains, AreReadByRegionAndRefusedByLine) {
  const auto read = read_chains("A 1 2 0246\nB 3 4 1357 # diamond\nA 0 0 0246\n", "two.txt");
  const auto& regions = *read;
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions.at("A").size(), 2U);
  EXPECT_EQ(regions.at("B").front().start, (algorithms::montani_re::LatticePoint{3, 4}));
  for (const char* const text :
       {"A 1 2", "A x 2 0246", "A 1 2 0248", "A -1 2 0246", "A 1 99999999999999999999 0"}) {
    const auto wrong = read_chains(text, "wrong.txt");
    ASSERT_FALSE(wrong) << text;
    EXPECT_NE(wrong.error().message().find("wrong.txt: line 1: found "), std::string::npos)
        << wrong.error().message();
  }
}

TEST(MontaniReTables, ThePapersTablesComeOut) {
  const auto made = timing_of_montani_re(quiet());
  std::map<std::string, std::size_t> rows;
  for (const Block& block : *made) {
    const auto* const table = std::get_if<Table>(&block);
    if (table == nullptr) continue;
    rows[table->id] = table->rows.size();
    for (const auto& row : table->rows) {
      ASSERT_EQ(row.size(), table->columns.size()) << table->id;
      if (table->id.starts_with("montani-re-table-")) {
        EXPECT_TRUE(good(row.back())) << table->id << ' ' << shown_text(row[0]);
      }
    }
  }
  EXPECT_EQ(rows, (std::map<std::string, std::size_t>{{"montani-re-paper", 6},
                                                      {"montani-re-table-1", 9},
                                                      {"montani-re-table-3", 7},
                                                      {"montani-re-table-4", 2},
                                                      {"montani-re-growth", 4},
                                                      {"montani-re-exponents", 2}}));
}

TEST(MontaniReGrowth, ExponentsOfPowersAreTheirs) {
  EXPECT_NEAR(growth_exponent({{1, 5}, {10, 50 * std::sqrt(10)}, {100, 5000}}), 1.5, 1e-12);
  EXPECT_EQ(growth_exponent({{1, 5}}), 0);
}

TEST(MontaniReStripes, TheBoundaryOfARectangleIsItsSides) {
  using algorithms::montani_re::StripeBand;
  using algorithms::montani_re::StripePcs;
  // From x = 2 to 5, y = 3 to 5, in stripes of a pixel.
  constexpr std::int64_t pixel = 65536;
  const StripeBand band{0, 16, {{2 * pixel, 2 * pixel}, {5 * pixel, 5 * pixel}}};
  StripePcs pcs{3, {{band}, {band}}};
  EXPECT_DOUBLE_EQ(square_pixels(pcs, 16), 6);
  double length = 0;
  double lowest = 1e9;
  const auto boundary = boundary_of(pcs, 16);
  EXPECT_EQ(boundary.size(), 6U) << "two sides a stripe, one below, one above";
  for (const picture::PixelSegment& s : boundary) {
    length += std::hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    lowest = std::min({lowest, s.a.y, s.b.y});
  }
  EXPECT_DOUBLE_EQ(length, 10);
  EXPECT_DOUBLE_EQ(lowest, 2.5) << "middles of pixels are at whole numbers";
  // A hole in the upper stripe: its sides, and its lower end.
  pcs.stripes[1][0].sides = {
      {2 * pixel, 2 * pixel}, {3 * pixel, 3 * pixel}, {4 * pixel, 4 * pixel}, {5 * pixel, 5 * pixel}};
  EXPECT_EQ(boundary_of(pcs, 16).size(), 2U + 1 + 4 + 1 + 2);
}

TEST(MontaniReStripes, ErrorFallsWithThicknessAndIsNothingForTheExactBuild) {
  MontaniReMeasure order;
  order.scenes = {"boxes"};  // nothing in it is lower than half a stripe: that would be lost
  order.scene_size = 8;
  order.raster = 128;
  order.rounds = 0;
  const auto curves = measure_montani_re(order, quiet());
  ASSERT_EQ(curves.size(), 1U);
  for (const MontaniReCurve& curve : curves) {
    ASSERT_EQ(curve.points.size(), 7U);
    EXPECT_GT(curve.true_length, 500);
    for (std::size_t i = 0; i < 6; ++i) {
      const MontaniRePoint& point = curve.points[i];
      EXPECT_LT(point.usual, 0.5 * point.thickness + 0.01) << curve.scene << ' ' << point.thickness;
      EXPECT_GT(point.usual, 0.1 * point.thickness) << curve.scene << ' ' << point.thickness;
      if (point.thickness <= 1) {
        EXPECT_EQ(point.inside, 0) << curve.scene << ' ' << point.thickness;
        EXPECT_EQ(point.symmetric(), 0) << curve.scene << ' ' << point.thickness;
      }
    }
    EXPECT_GT(curve.points[0].symmetric(), 1);
    EXPECT_GT(curve.points[0].mismatch(), 8 * curve.points[5].mismatch());
    const MontaniRePoint& exact = curve.points.back();
    EXPECT_EQ(exact.thickness, 0);
    EXPECT_EQ(exact.mismatch(), 0) << curve.scene;
    EXPECT_LT(exact.hausdorff, 1e-6) << curve.scene;
    EXPECT_NEAR(static_cast<double>(curve.points[5].sides) / static_cast<double>(curve.points[4].sides), 2,
                0.1);
  }
}

}  // namespace
}  // namespace sightline::harness::report
