// Grid files: the three forms, and every kind of damage named by line and column.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "host/scene/heights/read_grid.hpp"

namespace sightline::scene {
namespace {

HeightGrid grid_of(std::string_view text) {
  const auto result = read_height_grid(text, "grid.txt");
  if (!result) {
    ADD_FAILURE() << result.error().message(base::MessageStyle::position);
    return {};
  }
  return *result;
}

std::string error_of(std::string_view text) {
  const auto result = read_height_grid(text, "grid.txt");
  if (!result) return result.error().message(base::MessageStyle::position);
  return "no error";
}

const std::vector<double> one_to_six{1, 2, 3, 4, 5, 6};

TEST(ReadHeightGrid, SeparatorsAndLineEnds) {
  for (const char* text :
       {"1,2,3\n4,5,6\n", "1;2;3\r\n4;5;6\r\n", "1 2 3\n4 5 6", "\t1  2\t3 \n 4 5 6\n", "1 , 2,3\n4,5 ,6",
        "# a grid; of six\n1,2,3 # near\n\n4,5,6\n\n", "\xEF\xBB\xBF+1,2e0,3.\n4,.5e1,6\n"}) {
    const HeightGrid grid = grid_of(text);
    EXPECT_EQ(grid.heights, one_to_six) << text;
    EXPECT_EQ(grid.points(), 3U);
    EXPECT_EQ(grid.slices(), 2U);
    EXPECT_EQ(grid.range, (Interval{1, 6}));
    EXPECT_EQ(grid.domain_x, (Interval{0, 2}));
    EXPECT_EQ(grid.x, (std::vector<double>{-1, 0, 1}));
  }
}

TEST(ReadHeightGrid, NumbersTooNearZeroAreZero) {
  EXPECT_EQ(grid_of("1e-400,-1e-999\n5e-324,1\n").heights, (std::vector<double>{0, 0, 5e-324, 1}));
  EXPECT_NE(error_of("1e400,0\n0,1\n"), "no error");
}

// Different in the file, the same in [-1, 1].
TEST(ReadHeightGrid, PlacesThatCoincide) {
  EXPECT_NE(error_of("0 0 1\n1e-30 0 2\n1 0 3\n2 0 3\n\n0 5 4\n1e-30 5 5\n1 5 6\n2 5 3\n")
                .find("grid.txt:2:1: found x = 1e-30, too close to the 0 before it"),
            std::string::npos);
  EXPECT_NE(error_of("2 0 1\n1 0 2\n1e-30 0 3\n0 0 3\n\n2 5 4\n1 5 5\n1e-30 5 6\n0 5 3\n")
                .find("grid.txt:4:1: found x = 0, too close to the 1e-30 before it"),
            std::string::npos);
}

TEST(ReadHeightGrid, UndefinedHeights) {
  const HeightGrid grid = grid_of("1 nan\nNaN 4\n");
  EXPECT_TRUE(std::isnan(grid.height(1, 0)));
  EXPECT_TRUE(std::isnan(grid.height(0, 1)));
  EXPECT_EQ(grid.range, (Interval{1, 4}));
  EXPECT_EQ(error_of("nan nan\nnan nan\n"),
            "grid.txt: found a grid without any defined height, expected at least one");
}

// Blocks of constant x (gnuplot's own habit) and of constant y, in either direction.
TEST(ReadHeightGrid, Points) {
  const HeightGrid by_y = grid_of("0 0 1\n1 0 2\n4 0 3\n\n0 5 4\n1 5 5\n4 5 6\n");
  EXPECT_EQ(by_y.heights, one_to_six);
  EXPECT_EQ(by_y.x, (std::vector<double>{-1, -0.5, 1}));
  EXPECT_EQ(by_y.domain_x, (Interval{0, 4}));
  EXPECT_EQ(by_y.domain_z, (Interval{0, 5}));
  const HeightGrid by_x = grid_of("0 0 1\n0 5 4\n\n1 0 2\n1 5 5\n\n\n4 0 3\n4 5 6\n");
  EXPECT_EQ(by_x.heights, one_to_six);
  EXPECT_EQ(by_x.x, by_y.x);
  const HeightGrid falling = grid_of("# x y z\n4 5 6\n1 5 5\n0 5 4\n\n4 0 3\n1 0 2\n0 0 1\n");
  EXPECT_EQ(falling.heights, one_to_six);
  // Three columns without blank lines are a matrix.
  EXPECT_EQ(grid_of("0 0 1\n1 0 2\n4 0 3\n").slices(), 3U);
}

TEST(ReadHeightGrid, DamagedPoints) {
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n\n0 5 4\n"),
            "grid.txt:4:1: found a block of 1 points, expected 2 as in the first block");
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n\n0 5 4\n1 5 5\n2 5 6\n"),
            "grid.txt:6:1: found a block of 3 points, expected 2 as in the first block");
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n\n0 5 4\n1.5 5 5\n"),
            "grid.txt:5:1: found x = 1.5, expected 1 as in line 2");
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n\n0 5 4\n1 6 5\n"), "grid.txt:5:3: found y = 6, expected 5 as in line 4");
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n\n0 0 4\n1 0 5\n"),
            "grid.txt:4:3: found y = 0, expected more than the 0 before it");
  EXPECT_EQ(error_of("0 0 1\n2 0 2\n1 0 2\n\n0 1 1\n2 1 2\n1 1 2\n"),
            "grid.txt:3:1: found x = 1, expected more than the 2 before it");
  EXPECT_EQ(error_of("0 0 1\n1 1 2\n\n0 5 4\n1 6 5\n"),
            "grid.txt:2:1: found a block in which x and y both change, expected one of them constant");
  EXPECT_NE(error_of("0 0 1\n\n1 0 2\n\n0 5 4\n"), "no error");
  EXPECT_NE(error_of("nan 0 1\nnan 1 2\n\n0 0 4\n0 1 2\n"), "no error");
  EXPECT_NE(error_of("0 0 1\n5e-324 0 2\n\n0 5 4\n5e-324 5 5\n"), "no error");
}

TEST(ReadHeightGrid, DamagedFields) {
  EXPECT_EQ(error_of("x,y\n3,4\n"), "grid.txt: found 1 line of 2 fields, expected at least two of two");
  EXPECT_EQ(error_of("1,2\nx,y\n"), "grid.txt:2:1: found 'x', expected a finite number or nan");
  EXPECT_EQ(error_of("1,b\n3,4\n"), "grid.txt:1:3: found 'b', expected a finite number or nan");
  EXPECT_EQ(error_of("1 2\n3 4x\n"), "grid.txt:2:3: found '4x', expected a finite number or nan");
  EXPECT_EQ(error_of("1 2\n3 4,5\n"), "grid.txt:2:1: found '3 4', expected a finite number or nan");
  EXPECT_EQ(error_of("1;2\n3;\"4\n"), "grid.txt:2:3: found a quotation mark without its second, expected one on the same line");
  for (const char* field :
       {"inf", "-inf", "1e999", "0x10", "1 2", "--1", "+-1", "1e", "?", "\"1\"2", "n/a/n", "\x01"})
    EXPECT_EQ(error_of(std::string("1,2\n3,") + field + "\n").substr(0, 13), "grid.txt:2:3:") << field;
  EXPECT_EQ(error_of("\x01,\x02\n3,4\n").substr(0, 13), "grid.txt:1:1:");
}

// --- what spreadsheets and statistics programs write

TEST(ReadHeightGrid, MissingCellsAreHoles) {
  for (const char* text : {"1,,3\n4,5,\n", "1;NA;3\n4;5;n/a\n", "1\tNULL\t3\n4\t5\t\n", "1,nan,3,\n4,5,,\n", "a,b,c\n1,,3\n4,5,\n"}) {
    const HeightGrid grid = grid_of(text);
    ASSERT_EQ(grid.points(), 3U) << text;
    ASSERT_EQ(grid.slices(), 2U) << text;
    EXPECT_TRUE(std::isnan(grid.height(1, 0)) && std::isnan(grid.height(2, 1))) << text;
    EXPECT_EQ(grid.height(2, 0), 3) << text;
    EXPECT_EQ(grid.height(1, 1), 5) << text;
    EXPECT_EQ(grid.range, (Interval{1, 5})) << text;
  }
  // The first cell is missing: the first column does not rise, so that it is no table.
  const HeightGrid first = grid_of(",2,3\n4,5,6\n1,8,9\n2,3,4\n");
  EXPECT_EQ(first.points(), 3U);
  EXPECT_TRUE(std::isnan(first.height(0, 0)));
}

TEST(ReadHeightGrid, DecimalCommasAndQuotes) {
  EXPECT_EQ(grid_of("1,5;2\n-3;4,25\n").heights, (std::vector<double>{1.5, 2, -3, 4.25}));
  EXPECT_EQ(grid_of("\"1\",\"2\"\n\"3\", \"4\"\n").heights, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(error_of("1,5,5;2\n-3;4\n"), "grid.txt:1:1: found '1,5,5', expected a finite number or nan");
}

TEST(ReadHeightGrid, Tables) {
  const HeightGrid grid = grid_of("y\\x,10,20,40\n3,1,2,3\n1,4,5,\n");
  EXPECT_EQ(grid.domain_x, (Interval{10, 40}));
  EXPECT_EQ(grid.domain_z, (Interval{1, 3}));
  EXPECT_DOUBLE_EQ(grid.x[1], -1 + 2 * 10.0 / 30);
  EXPECT_EQ(grid.height(0, 0), 4);
  EXPECT_EQ(grid.height(2, 1), 3);
  EXPECT_TRUE(std::isnan(grid.height(2, 0)));
  EXPECT_EQ(grid_of(",1,2,3\n10,1,2,3\n20,4,5,6\n").heights, one_to_six);
  EXPECT_EQ(error_of("at,1,3,2\n10,1,2,3\n20,4,5,6\n"),
            "grid.txt:1:4: found a first line of places that do not rise or fall, expected places that rise or fall from one to the next");
  EXPECT_EQ(error_of("at,1,2,3\n10,1,2,3\n10,4,5,6\n").substr(0, 13), "grid.txt:2:1:");
  EXPECT_EQ(error_of("at,1,2,3\n10,1,2,3\n20,4,5\n"), "grid.txt:3:7: found 3 fields, expected 4 as in line 1");
}

TEST(ReadHeightGrid, PointsInAnyOrder) {
  for (const char* text : {"x,y,z\n4,5,6\n0,0,1\n1,5,5\n0,5,4\n4,0,3\n1,0,2\n", "name,Z,Y,X\n7,6,5,4\n7,1,0,0\n7,5,5,1\n7,4,5,0\n7,3,0,4\n7,2,0,1\n",
                           "4 5 6\n0 0 1\n1 5 5\n0 5 4\n4 0 3\n1 0 2\n", "a b c\n4 5 6\n0 0 1\n1 5 5\n0 5 4\n4 0 3\n1.0000000001 0 2\n",
                           "Lon;Lat;Elevation\n4;5;6\n0;0;1\n1;5;5\n0;5;4\n4;0;3\n1;0;2\n"}) {
    const HeightGrid grid = grid_of(text);
    EXPECT_EQ(grid.heights, one_to_six) << text;
    EXPECT_EQ(grid.x, (std::vector<double>{-1, -0.5, 1})) << text;
    EXPECT_EQ(grid.domain_z, (Interval{0, 5})) << text;
  }
  const HeightGrid named = grid_of("X,Y,Depth\n0,0,1\n1,0,2\n0,1,\n");
  EXPECT_EQ(named.names, (std::array<std::string, 3>{"X", "Y", "Depth"}));
  EXPECT_TRUE(std::isnan(named.height(0, 1)) && std::isnan(named.height(1, 1)));
}

TEST(ReadHeightGrid, ColumnsAskedFor) {
  const auto read = [](std::string_view text, std::vector<std::string> columns) {
    const auto result = read_height_grid(text, "grid.txt", {std::move(columns)});
    return result ? std::to_string(result->height(1, 0)) : result.error().message(base::MessageStyle::position);
  };
  const std::string_view text = "time,east,north,t\n0,0,0,1\n0,1,0,2\n0,0,1,3\n0,1,1,4\n";
  EXPECT_EQ(read(text, {"East", "north", "T"}), "2.000000");
  EXPECT_EQ(read(text, {"3", "2", "4"}), "3.000000");
  EXPECT_EQ(read(text, {"east", "north", "u"}), "grid.txt: found no column u, expected one of time, east, north, t, or a number from 1 to 4");
  EXPECT_EQ(read("0 0 1\n1 0 2\n0 1 3\n", {"1", "2", "4"}), "grid.txt: found no column 4, expected a number from 1 to 3");
  EXPECT_EQ(read("0 0 1\n1 0 2\n0 1 3\n", {"1", "2", "3"}), "2.000000");
}

TEST(ReadHeightGrid, DamagedPointsInAnyOrder) {
  EXPECT_EQ(error_of("x,y,z\n0,0,1\n1,1,2\n0,0,3\n"),
            "grid.txt:4:1: found a second point at x = 0, y = 0, expected one point for each place; the first is in line 2");
  EXPECT_EQ(error_of("x,y,z\n0,0,1\n1,,2\n0,1,3\n"), "grid.txt:3:3: found no y, expected a number; only a height may be missing");
  EXPECT_EQ(error_of("x,y,z\n0,0,1\n1,2\n"), "grid.txt:3:4: found 2 fields, expected 3 as in line 1");
  EXPECT_EQ(error_of("x,y,z\n0,0,1\n0,1,2\n"), "grid.txt: found one value of x on every line, expected at least two");
  std::string anywhere = "x,y,z\n";
  for (int i = 0; i < 9; ++i) anywhere += std::to_string(i) + "." + std::to_string(i) + "," + std::to_string(8 - i) + ",1\n";
  EXPECT_EQ(error_of(anywhere), "grid.txt: found 9 points on a grid of 9 by 9 places, expected points on a grid, a quarter of its places or more");
}

TEST(ReadHeightGrid, DamagedShapes) {
  EXPECT_EQ(error_of("1 2 3\n4 5\n"), "grid.txt:2:4: found 2 fields, expected 3 as in line 1");
  EXPECT_EQ(error_of("1 2\n4 5 6\n"), "grid.txt:2:5: found 3 fields, expected 2 as in line 1");
  EXPECT_EQ(error_of("1 2 3\n"), "grid.txt: found 1 line of 3 fields, expected at least two of two");
  EXPECT_EQ(error_of("1\n2\n3\n"), "grid.txt: found 3 lines of 1 field, expected at least two of two");
  for (const char* nothing : {"", "\n\n", "# only a comment\n", " \t\r\n"})
    EXPECT_EQ(error_of(nothing), "grid.txt: found no line of numbers, expected at least two");
  std::string wide;
  for (int i = 0; i < 1025; ++i) wide += "0 ";
  EXPECT_EQ(error_of(wide + "\n" + wide),
            "grid.txt:1:2049: found more than 1024 fields, expected at most 1024");
  std::string tall;
  for (int i = 0; i < 1025; ++i) tall += "0 0\n";
  EXPECT_NE(error_of(tall).find("1025 slices of 2 points, expected at most 1024"), std::string::npos);
}

TEST(LoadHeightGrid, FilesThatAreNone) {
  const auto missing = load_height_grid("/nowhere/grid.csv");
  EXPECT_EQ(missing.error().message(base::MessageStyle::position), "/nowhere/grid.csv: found no such file");
  const auto folder = load_height_grid(SIGHTLINE_TEST_DATA);
  EXPECT_NE(folder.error().message(base::MessageStyle::position).find("directory"), std::string::npos);
}

TEST(LoadHeightGrid, OfTheTestData) {
  const auto csv = load_height_grid(SIGHTLINE_TEST_DATA "/heights/terrain.csv");
  ASSERT_TRUE(csv) << csv.error().message(base::MessageStyle::position);
  const auto points = load_height_grid(SIGHTLINE_TEST_DATA "/heights/terrain-points.dat");
  ASSERT_TRUE(points) << points.error().message(base::MessageStyle::position);
  EXPECT_EQ(csv->heights, points->heights);
  EXPECT_EQ(csv->slices(), 10U);
  EXPECT_EQ(csv->points(), 12U);
}

}  // namespace
}  // namespace sightline::scene
