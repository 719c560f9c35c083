// The column oracle on pictures small enough to verify by eye.
#include "host/algorithms/oracle/column_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace sightline::algorithms::oracle {
namespace {

using enum SegmentRole;

// The rows of a column from y = 0 up, '#' lit.
std::string column(const std::bitset<raster_columns>& lit, std::size_t rows = 12) {
  std::string text;
  for (std::size_t y = 0; y < rows; ++y) text += lit.test(y) ? '#' : '.';
  return text;
}

// A dot in column 3, or a vertical run.
Chain run(std::int64_t depth, int from, int to, SegmentRole role = draw) {
  return {0, {{3, from, depth, none}, {3, to, depth, role}}};
}

std::string lit(const std::vector<Chain>& chains) {
  return column(column_picture(chains, 0).lit[3]);
}

TEST(ColumnOracle, SegmentsRoundAwayFromTheirLeftEnd) {
  EXPECT_EQ(segment_dots(0, 0, 4, 2), (std::vector<RasterDot>{{0, 0}, {1, 1}, {2, 1}, {3, 2}, {4, 2}}));
  EXPECT_EQ(segment_dots(4, 2, 0, 0), (std::vector<RasterDot>{{4, 2}, {3, 2}, {2, 1}, {1, 1}, {0, 0}}));
  EXPECT_EQ(segment_dots(0, 2, 4, 0), (std::vector<RasterDot>{{0, 2}, {1, 1}, {2, 1}, {3, 0}, {4, 0}}));
  EXPECT_EQ(segment_dots(2, 4, 0, 0), (std::vector<RasterDot>{{2, 4}, {2, 3}, {1, 2}, {1, 1}, {0, 0}}));
  EXPECT_EQ(segment_dots(5, 5, 5, 5), (std::vector<RasterDot>{{5, 5}}));
}

TEST(ColumnOracle, OrderIsByDepthWhateverTheOrderGiven) {
  std::vector<Chain> chains{run(10, 4, 4), run(20, 8, 8), run(30, 6, 6), run(40, 2, 9)};
  std::sort(chains.begin(), chains.end(),
            [](const Chain& a, const Chain& b) { return a.vertices[0].y < b.vertices[0].y; });
  EXPECT_EQ(lit(chains), "..###...##..");
  for (Chain& chain : chains)
    for (ChainVertex& vertex : chain.vertices) vertex.depth = -vertex.depth;
  EXPECT_EQ(lit(chains), "..########..");
}

TEST(ColumnOracle, RankDecidesWhereDepthDoesNot) {
  Chain a = run(10, 4, 4);
  Chain b = run(12, 2, 6, mask);
  a.rank = 1;
  EXPECT_EQ(column(column_picture({a, b}, 1).lit[3]), "....#.......");
  EXPECT_EQ(column(column_picture({a, b}, 2).lit[3]), "............");
}

TEST(ColumnOracle, DepthIsTakenInTheColumn) {
  // The chains exchange order between column 0 and column 6; in column 3 the first is nearer by 1.
  const Chain rising{0, {{0, 4, 0, none}, {6, 4, 18, draw}}};
  const Chain falling{0, {{0, 5, 20, none}, {6, 5, 0, mask}}};
  const auto picture = column_picture({falling, rising}, 0);
  EXPECT_TRUE(picture.lit[3].test(4));
  EXPECT_TRUE(picture.lit[6].test(4));
  const Chain cover{0, {{0, 2, 1, none}, {0, 8, 1, mask}, {6, 8, 1, mask}, {6, 2, 1, mask}}};
  const auto covered = column_picture({cover, rising}, 0);
  EXPECT_TRUE(covered.lit[0].test(4));
  EXPECT_FALSE(covered.lit[6].test(4));
}

TEST(ColumnOracle, RolesDifferInInkAndHiding) {
  EXPECT_EQ(lit({run(1, 3, 8, mask), run(2, 0, 11)}), "###......###");
  EXPECT_EQ(lit({run(1, 3, 8, mask), run(2, 0, 11, test)}), "#####..#####");
  EXPECT_EQ(lit({run(1, 3, 8, test), run(2, 5, 5)}), "...######...");
}

// As `run`, in another column.
Chain run_at(int x, std::int64_t depth, int from, int to, SegmentRole role) {
  return {0, {{x, from, depth, none}, {x, to, depth, role}}};
}

TEST(ColumnOracle, TestedPiecesAreVisibleNextToLowerColumns) {
  const Chain cover = run_at(3, 10, 0, 11, mask);
  const Chain tested = run(20, 1, 10, test);
  EXPECT_EQ(lit({cover, tested}), ".#........#.");
  // The last row of the adjacent hull makes it visible, an inner row does not.
  EXPECT_EQ(lit({cover, run_at(2, 10, 4, 8, mask), tested}), ".####...###.");
  EXPECT_EQ(lit({cover, run_at(4, 10, 4, 8, mask), tested}), ".####...###.");
  EXPECT_EQ(lit({cover, run_at(4, 10, 4, 7, mask), run_at(2, 10, 5, 11, mask), tested}), ".#####.####.");
  // A farther hull, one two columns away, or one that is only tested has no effect.
  EXPECT_EQ(lit({cover, run_at(2, 30, 4, 8, mask), tested}), ".#........#.");
  EXPECT_EQ(lit({cover, run_at(5, 10, 4, 8, mask), tested}), ".#........#.");
  EXPECT_EQ(lit({cover, run_at(2, 10, 4, 8, test), tested}), ".#........#.");
  // Nor has it an effect on a line that hides.
  EXPECT_EQ(lit({cover, run_at(2, 10, 4, 8, mask), run(20, 1, 10, draw)}), "............");
}

TEST(ColumnOracle, SurfacesAreFilledBetweenPieces) {
  EXPECT_EQ(lit({run(1, 2, 2, shade), run(2, 7, 7, shade)}), "..######....");
  EXPECT_EQ(lit({run(1, 2, 2, shade), run(2, 7, 7, rim)}), "..#....#....");
  EXPECT_EQ(lit({run(1, 2, 2, rim), run(2, 7, 7, shade)}), "..######....");
  // Piece 3 enters below the strip and leaves above it: filled where it enters.
  EXPECT_EQ(lit({run(1, 4, 4, rim), run(2, 6, 6, rim), run(3, 1, 9, shade)}), ".####.####..");
  EXPECT_EQ(lit({run(1, 4, 6, mask), run(2, 5, 5, shade), run(3, 9, 9, shade)}), ".......###..");
}

TEST(ColumnOracle, SilhouettesAreRecordsThatEnd) {
  const auto folds = [](std::initializer_list<int> heights) {
    std::vector<Chain> chains;
    for (const int y : heights) chains.push_back(run(static_cast<std::int64_t>(chains.size()), y, y, mask));
    return column(column_picture(chains, 0).silhouette[3]);
  };
  EXPECT_EQ(folds({5, 9, 8}), "............");
  EXPECT_EQ(folds({5, 9, 7}), ".........#..");
  EXPECT_EQ(folds({5, 7, 5, 9, 6, 10}), ".......#.#..");
  EXPECT_EQ(folds({5, 2, 4}), "..#.........");
  EXPECT_EQ(folds({9, 5, 6}), "............");
  // A steep piece ends a record only where a later piece lies completely below it.
  EXPECT_EQ(
      column(column_picture({run(0, 2, 2, mask), run(1, 5, 9, mask), run(2, 4, 4, mask)}, 0).silhouette[3]),
      "............");
  EXPECT_EQ(
      column(column_picture({run(0, 2, 2, mask), run(1, 5, 9, mask), run(2, 3, 3, mask)}, 0).silhouette[3]),
      ".........#..");
}

TEST(ColumnOracle, OutlineIsClosed) {
  const Chain block{0, {{3, 2, 0, none}, {3, 5, 0, mask}, {4, 5, 0, mask}, {4, 2, 0, mask}}};
  const auto picture = column_picture({block}, 0);
  EXPECT_EQ(column(picture.outline[3]), "..####......");
  EXPECT_EQ(column(picture.outline[4]), "..####......");
  EXPECT_EQ(picture.hull[4]->low, 2);
  EXPECT_FALSE(picture.hull[5].has_value());
}

}  // namespace
}  // namespace sightline::algorithms::oracle
