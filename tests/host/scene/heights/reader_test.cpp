// Grid files: the three forms, and every kind of error with line and column.
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
       {"1,2,3\n4,5,6\n", "1;2;3\r\n4;5;6\r\n", "1 2 3\n4 5 6", "\t1  2\t3 \n 4 5 6\n", "1 , 2,3\n4,5 ,6", "1 2 3\r4 5 6\r",
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
  EXPECT_NE(error_of("0 0 1\n1e-30 0 2\n1 0 3\n2 0 3\n0 5 4\n1e-30 5 5\n1 5 6\n2 5 3\n")
                .find("grid.txt:2:1: found a second point at x = 1e-30, y = 0 with the height 2, expected one height for each place; the first is 1 in line 1"),
            std::string::npos);
  EXPECT_NE(error_of("at,0,1e-30,1\n0,1,2,3\n1,4,5,6\n").find("grid.txt: found places that are too close to each other"), std::string::npos);
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

// Blocks are points: a position without a point is a hole, and a note says so.
TEST(ReadHeightGrid, IncompleteBlocks) {
  const HeightGrid three = grid_of("0 0 1\n1 0 2\n\n0 5 4\n");
  EXPECT_EQ(three.note, "read as x y z in columns, a grid of 2 x 2, 1 place without a point");
  EXPECT_TRUE(std::isnan(three.height(1, 1)));
  const HeightGrid five = grid_of("0 0 1\n1 0 2\n\n0 5 4\n1 5 5\n2 5 6\n");
  EXPECT_EQ(five.note, "read as x y z in columns, a grid of 3 x 2, 1 place without a point");
  EXPECT_TRUE(std::isnan(five.height(2, 0)));
  EXPECT_EQ(five.height(2, 1), 6);
  EXPECT_EQ(grid_of("0 0 1\n4 0 3\n1 0 2\n\n0 5 4\n4 5 6\n1 5 5\n").heights, one_to_six);
}

TEST(ReadHeightGrid, DamagedPoints) {
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n0 5 4\n1.5 5 5\n"),
            "grid.txt: found 4 scattered points with 3 different values of x and 2 of y, no grid of columns and rows, expected a point at most places of a grid; "
            "use --triangulate; use --layout matrix if each line is a row of heights");
  const std::string net = "grid.txt: found 2 blocks of points that form no grid: a parametric surface, expected heights over a grid: in each block x or y is the same; "
                          "sightline draw skala draws it";
  for (const char* text : {"0 0 1\n1 0 2\n\n0 5 4\n1.5 5 5\n", "0 0 1\n1 0 2\n\n0 0 4\n1 0 5\n", "0 0 1\n1 1 2\n\n0 5 4\n1 6 5\n", "0 0 1\n0 1 2\n\n1 0 4\n2 1 2\n"})
    EXPECT_EQ(error_of(text), net) << text;
  EXPECT_EQ(error_of("0 0 1\n1 1 2\n\n0 5 4\n1 6 5\n2 7 6\n"),
            "grid.txt:4:1: found block 2 of 3 points, expected 2 as in the first block; points of a surface are a grid of columns and rows, or blocks of equal length "
            "between blank lines; others need --triangulate");
  EXPECT_EQ(error_of("nan 0 1\nnan 1 2\n\n0 0 4\n0 1 2\n"), "grid.txt:1:1: found no x, expected a number; only a height may be missing");
  // An upright sheet.
  EXPECT_EQ(error_of("0 0 0\n0 1 0\n\n0 0 1\n0 1 1\n\n1 0 1\n1 1 1\n"),
            "grid.txt: found 3 blocks of points that form no grid: a parametric surface, expected heights over a grid: in each block x or y is the same; "
            "sightline draw skala draws it");
  EXPECT_NE(error_of("0 0 1\n5e-324 0 2\n\n0 5 4\n5e-324 5 5\n"), "no error");
}

TEST(ReadHeightGrid, DamagedFields) {
  EXPECT_EQ(error_of("x,y\n3,4\n"), "grid.txt:1:1: found the columns x, y, expected one called z or height; use --xyz x,y,NAME to name the column of heights");
  EXPECT_EQ(error_of("a,b\n3,4\n"), "grid.txt: found 1 line of 2 fields, expected at least two of two");
  EXPECT_EQ(error_of("1,2\nx,y\n"), "grid.txt:2:1: found 'x', expected a finite number or nan");
  EXPECT_EQ(error_of("1,b\n3,4\n"), "grid.txt:1:3: found 'b', expected a finite number or nan");
  EXPECT_EQ(error_of("1 2\n3 4x\n"), "grid.txt:2:3: found '4x', expected a finite number or nan");
  EXPECT_EQ(error_of("1 2\n3 4,5\n"), "grid.txt:2:1: found '3 4', expected one number between two commas; where fractions have a comma, semicolons must separate the numbers");
  EXPECT_EQ(error_of("1;2\n3;\"4\n"), "grid.txt:2:3: found a quotation mark without its second, expected one on the same line");
  for (const char* field :
       {"inf", "-inf", "1e999", "0x10", "1 2", "--1", "+-1", "1e", "?", "\"1\"2", "n/a/n", "\x01"})
    EXPECT_EQ(error_of(std::string("1,2\n3,") + field + "\n").substr(0, 13), "grid.txt:2:3:") << field;
  EXPECT_EQ(error_of("\x01,\x02\n3,4\n").substr(0, 13), "grid.txt:1:1:");
}

// --- Output of spreadsheets and statistics programs

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
  // The first cell is missing: the first column does not ascend, so it is not a table.
  const HeightGrid first = grid_of(",2,3\n4,5,6\n4,8,9\n");
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

TEST(ReadHeightGrid, RequestedColumns) {
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
            "grid.txt:4:1: found a second point at x = 0, y = 0 with the height 3, expected one height for each place; the first is 1 in line 2; leave out one of them");
  EXPECT_EQ(error_of("x,y,z\n0,0,1\n1,,2\n0,1,3\n"), "grid.txt:3:3: found no y, expected a number; only a height may be missing");
  EXPECT_EQ(error_of("x,y,z\n0,0,1\n1,2\n"), "grid.txt:3:4: found 2 fields, expected 3 as in line 1");
  EXPECT_EQ(error_of("x,y,z\n0,0,1\n0,1,2\n"), "grid.txt: found 2 points with the same x, expected at least two different values of x");
  std::string anywhere = "x,y,z\n";
  for (int i = 0; i < 9; ++i) anywhere += std::to_string(i) + "." + std::to_string(i) + "," + std::to_string(8 - i) + ",1\n";
  EXPECT_EQ(error_of(anywhere),
            "grid.txt: found 9 scattered points with 9 different values of x and 9 of y, no grid of columns and rows, expected a point at most places of a grid; "
            "use --triangulate");
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
            "grid.txt: found 2 slices of 1025 points, expected at most 1024 of 1024; --thin 2 takes every 2nd point");
  std::string tall;
  for (int i = 0; i < 1025; ++i) tall += "0 0\n";
  EXPECT_NE(error_of(tall).find("1025 slices of 2 points, expected at most 1024"), std::string::npos);
}

// --- Determination of the layout

std::string note_of(std::string_view text, const GridFileOptions& options = {}) {
  const auto result = read_height_grid(text, "grid.txt", options);
  return result ? result->note : result.error().message(base::MessageStyle::position);
}

// Whether a note says that the layout was guessed.
TEST(GridLayouts, GuessesAreReported) {
  EXPECT_EQ(note_of("1,3,3\n4,5,6\n"), "read as a matrix of 2 rows and 3 columns");
  EXPECT_EQ(note_of("1,2,3\n4,5,6\n", {{}, GridLayout::matrix}), "");
  EXPECT_EQ(note_of("at,1,2\n0,5,6\n1,7,8\n"), "");
  EXPECT_EQ(note_of(",1,2\n0,5,6\n1,7,8\n"), "read as a table of 2 rows and 2 columns, with its places in the first line and column");
  EXPECT_EQ(note_of("x,y,z\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n"), "");
  EXPECT_EQ(note_of("0,0,1\n1,0,2\n0,1,3\n1,1,4\n"), "read as x y z in columns, a grid of 2 x 2");
  EXPECT_EQ(note_of("0,0,1\n1,0,2\n0,1,3\n1,1,4\n", {{}, GridLayout::points}), "");
  EXPECT_EQ(note_of("0,0,1\n1,0,2\n0,1,3\n1,1,4\n", {{"1", "2", "3"}}), "");
}

// gnuplot's nonuniform matrix: the number of columns, positions along x; a position along y before each row.
TEST(GridLayouts, NonuniformMatrix) {
  const std::string said = "read as a table of 2 rows and 3 columns, with its places in the first line and column";
  const HeightGrid grid = grid_of("3 0 1 4\n5 4 5 6\n0 1 2 3\n");
  EXPECT_EQ(grid.note, said);
  EXPECT_EQ(grid.heights, one_to_six);
  EXPECT_EQ(grid.x, (std::vector<double>{-1, -0.5, 1}));
  EXPECT_EQ(grid.domain_z, (Interval{0, 5}));
  // Descending positions, separated by tabs.
  EXPECT_EQ(grid_of("3\t4\t1\t0\n0\t3\t2\t1\n5\t6\t5\t4\n").heights, one_to_six);
  // Some programs write 0 instead of the number.
  EXPECT_EQ(grid_of("0 10 20 30\n200 7 8 9\n210 7 8 9\n220 1 2 3\n").domain_x, (Interval{10, 30}));
  // A slope is a matrix; its corner is the first height.
  EXPECT_EQ(note_of("0 1 2 3\n1 2 3 4\n2 3 4 5\n3 4 5 6\n"), "read as a matrix of 4 rows and 4 columns; if its first line and column are places, use --layout table");
  EXPECT_EQ(note_of("2 3 5\n4 2 3\n4 8 9\n"), "read as a matrix of 3 rows and 3 columns") << "the column is not monotone";
  EXPECT_EQ(note_of("3 0 1 4\n5 4 5 6\n0 1 2 3\n", {{}, GridLayout::matrix}), "");
  EXPECT_EQ(note_of("9 0 1 4\n5 4 5 6\n0 1 2 3\n", {{}, GridLayout::table}), "");
  EXPECT_EQ(note_of("9 0 1 1\n5 4 5 6\n0 1 2 3\n", {{}, GridLayout::table}),
            "grid.txt:1:3: found a first line of places that do not rise or fall, expected places that rise or fall from one to the next");
  EXPECT_EQ(note_of("9 0 1 1\n", {{}, GridLayout::table}), "grid.txt: found one line of numbers, expected a line of places along x and two or more below it");
}

TEST(GridLayouts, FurtherColumns) {
  const HeightGrid four = grid_of("4 5 6 9\n0 0 1 9\n1 5 5 9\n0 5 4 9\n4 0 3 9\n1 0 2 9\n");
  EXPECT_EQ(four.heights, one_to_six);
  EXPECT_EQ(four.note, "read as x y z in columns, a grid of 3 x 2, column 4 left out");
  EXPECT_EQ(note_of("0;0;1;255;0;0\n1;0;2;255;0;0\n0;1;3;255;0;0\n1;1;4;255;0;0\n"), "read as x y z in columns, a grid of 2 x 2, columns 4 to 6 left out");
  EXPECT_EQ(grid_of("x,y,z,r\n0,0,1,7\n1,0,2,7\n4,0,3,7\n0,5,4,7\n1,5,5,7\n4,5,6,7\n").heights, one_to_six);
  // Blocks of gnuplot with a colour in the fourth column.
  EXPECT_EQ(grid_of("0 0 1 9\n0 5 4 9\n\n1 0 2 9\n1 5 5 9\n\n4 0 3 9\n4 5 6 9\n").heights, one_to_six);
  EXPECT_EQ(grid_of("Easting (m),Northing (m),Depth [m]\n0,0,1\n1,0,2\n4,0,3\n0,5,4\n1,5,5\n4,5,6\n").heights, one_to_six);
  EXPECT_EQ(error_of("x,y,t,err\n0,0,1,7\n1,0,2,7\n0,1,3,7\n1,1,3,7\n"),
            "grid.txt:1:1: found the columns x, y, t, err, expected one called z or height; use --xyz x,y,NAME to name the column of heights");
}

// Words are skipped in unused columns.
TEST(GridLayouts, ColumnsOfWords) {
  const std::string_view text = "name,x,y,z\na,0,0,1\nb,1,0,2\nc,4,0,3\nd,0,5,4\ne,1,5,5\nf,4,5,6\n";
  EXPECT_EQ(grid_of(text).heights, one_to_six);
  EXPECT_EQ(note_of(text, {{"y", "x", "name"}}), "grid.txt:2:1: found 'a', expected a finite number or nan");
  EXPECT_EQ(error_of("x,y,z,t\n0,0,1,a\n1,0,b,c\n0,1,2,d\n"), "grid.txt:3:5: found 'b', expected a finite number or nan");
  EXPECT_EQ(note_of("0 0 1 a\n1 0 2 a\n0 1 3 a\n1 1 4 b\n"), "read as x y z in columns, a grid of 2 x 2, column 4 left out");
  EXPECT_EQ(note_of("0 0 1 a\n1 0 2 a\n0 1 3 a\n1 1 4 b\n", {{}, GridLayout::points}), "");
  EXPECT_EQ(note_of("0 0 1 a\n1 0 2 a\n0 1 3 a\n1 1 4 b\n", {{}, GridLayout::matrix}).substr(0, 13), "grid.txt:1:7:");
}

// A surface as written by "set table" of gnuplot: the type of each point follows it.
TEST(GridLayouts, WordsAfterPoints) {
  const HeightGrid grid = grid_of("# x y z type\n0 0 1  i\n5 0 2  i\n\n0 3 4  o\n5 3 nan  u\n");
  EXPECT_EQ(grid.domain_x, (Interval{0, 5}));
  EXPECT_EQ(grid.domain_z, (Interval{0, 3}));
  EXPECT_TRUE(std::isnan(grid.heights.at(3)));
  EXPECT_EQ(grid.note, "read as x y z in columns, a grid of 2 x 2, column 4 left out");
  EXPECT_EQ(error_of("1 2 3 4 5\n1 2 3 4 x\n"), "grid.txt:2:9: found 'x', expected a finite number or nan");
  EXPECT_EQ(error_of("0 0 1 i\n5 0 x i\n0 3 4 i\n5 3 4 i\n"), "grid.txt:1:7: found 'i', expected a finite number or nan");
}

TEST(GridLayouts, RepeatedPoints) {
  const HeightGrid grid = grid_of("0 0 1\n1 0 2\n4 0 3\n0 5 4\n1 5 5\n4 5 6\n1 5 5\n0 0 1\n");
  EXPECT_EQ(grid.heights, one_to_six);
  EXPECT_EQ(grid.note, "read as x y z in columns, a grid of 3 x 2, 2 repeated points left out");
  EXPECT_EQ(note_of("x,y,z\n0,0,1\n1,0,\n0,1,3\n1,1,3\n1,0,\n"), "1 repeated point left out");
  EXPECT_EQ(error_of("0 0 1\n1 0 2\n4 0 3\n0 5 4\n1 5 5\n4 5 6\n1 5 7\n"),
            "grid.txt:7:1: found a second point at x = 1, y = 5 with the height 7, expected one height for each place; the first is 5 in line 5; leave out one of them; "
            "use --layout matrix if each line is a row of heights");
  // Two scans of all positions, with different heights: never a matrix.
  EXPECT_NE(error_of("0 0 1\n1 0 2\n0 5 3\n1 5 4\n0 0 5\n1 0 6\n0 5 7\n1 5 8\n").find("grid.txt:5:1: found a second point"), std::string::npos);
}

TEST(GridLayouts, FewColumnsAreNotAMatrix) {
  const std::string scattered = " different values of x and ";
  EXPECT_NE(error_of("0.1 3.2 1\n2.5 0.3 2\n1.7 1.9 4\n0.4 2.2 3\n").find("found 4 scattered points with 4" + scattered), std::string::npos);
  std::string four;
  for (int i = 0; i < 13; ++i) four += std::to_string(i * i % 23) + "." + std::to_string(i) + "," + std::to_string(i * i * i % 29) + ".5,3,4\n";
  EXPECT_NE(error_of(four).find("found 13 scattered points"), std::string::npos);
  EXPECT_EQ(note_of(four, {{}, GridLayout::matrix}), "");
  EXPECT_NE(error_of("0,1,0\n0,2,0\n0,3,0\n0,4,0\n").find("found 4 points with the same x"), std::string::npos);
  EXPECT_EQ(error_of("0 5 1\n1 5 2\n2 5 3\n3 5 2\n4 5 1\n5 5 1\n6 5 1\n7 5 0\n8 5 1\n9 5 1\n"),
            "grid.txt: found 10 points with the same y, expected at least two different values of y; use --layout matrix if each line is a row of heights");
  // Scattered points are not a grid with holes, whether the layout is named or requested.
  EXPECT_NE(error_of("x,y,z\n0,3,1\n1,2,1\n2,0,1\n3,1,1\n").find("found 4 scattered points"), std::string::npos);
  EXPECT_NE(note_of("0,3,1\n1,2,1\n2,0,1\n", {{"1", "2", "3"}}).find("found 3 scattered points"), std::string::npos);
  EXPECT_EQ(note_of("1 2\n3 4\n", {{}, GridLayout::points}), "grid.txt: found 2 lines of 2 fields, expected three or more: x, y and height");
}

TEST(GridLayouts, Comments) {
  EXPECT_EQ(grid_of("% from a program for matrices\n1 2 3\n  % 7\n4 5 6\n").heights, one_to_six);
  EXPECT_NE(error_of("1 2%\n3 4\n"), "no error");
}

TEST(GridLayouts, DecimalCommas) {
  EXPECT_EQ(error_of("1,5\t2,5\n3,5\t4,5\n"),
            "grid.txt:1:3: found '5 2', expected one number between two commas; where fractions have a comma, semicolons must separate the numbers");
}

TEST(GridLayouts, BinaryFiles) {
  using namespace std::string_view_literals;
  const std::string wanted = ", expected a grid of heights; save it as text in UTF-8, such as CSV, or as an ESRI ASCII grid";
  EXPECT_EQ(error_of("DSRB\0\0"sv), "grid.txt: found a grid of Surfer 7" + wanted);
  EXPECT_EQ(error_of("II*\0\0"sv), "grid.txt: found a TIFF image" + wanted);
  // Its first line would be a comment.
  EXPECT_EQ(error_of("%PDF-1.4\n1 2\n3 4\n"), "grid.txt: found a PDF document" + wanted);
  EXPECT_EQ(error_of("\xFF\xD8\xFF\xE0"), "grid.txt: found a JPEG image" + wanted);
  EXPECT_EQ(error_of("\xFF\xFE" "1\0"sv), "grid.txt: found text in UTF-16" + wanted);
  EXPECT_EQ(error_of("[[1, 2], [3, 4]]"), "grid.txt: found a list in brackets, such as JSON" + wanted);
  EXPECT_EQ(error_of("1 2\0\n3 4\n"sv), "grid.txt: found binary data" + wanted);
}

// --- Formats that identify themselves

TEST(EsriGrid, PositionsAreTheMiddlesOfCells) {
  const std::string_view cells = "NCOLS 3\nNROWS 2\nXLLCORNER 10\nYLLCORNER 20\nCELLSIZE 2\nNODATA_VALUE -1\n4 -1 6\n1 2\n3\n";
  const HeightGrid grid = grid_of(cells);
  EXPECT_EQ(grid.note, "");
  EXPECT_EQ(grid.domain_x, (Interval{11, 15}));
  EXPECT_EQ(grid.domain_z, (Interval{21, 23}));
  EXPECT_EQ(grid.height(0, 0), 1);
  EXPECT_EQ(grid.height(2, 0), 3);
  EXPECT_EQ(grid.height(0, 1), 4);
  EXPECT_TRUE(std::isnan(grid.height(1, 1)));
  EXPECT_EQ(grid.range, (Interval{1, 6}));
  // -9999 is undefined unless the file gives another value.
  const HeightGrid centres = grid_of("\xEF\xBB\xBFnrows 2\r\nncols 2\r\nyllcenter 0\r\nxllcenter 5\r\ndx 1\r\ndy 3\r\n-9999 nan\r\n1 2\r\n");
  EXPECT_EQ(centres.domain_x, (Interval{5, 6}));
  EXPECT_EQ(centres.domain_z, (Interval{0, 3}));
  EXPECT_TRUE(std::isnan(centres.height(0, 1)) && std::isnan(centres.height(1, 1)));
  EXPECT_EQ(note_of(cells, {{}, GridLayout::matrix}),
            "grid.txt: found an ESRI ASCII grid, whose layout is known, expected a file of numbers; leave out --layout, --xyz and --triangulate");
}

// GDAL writes nan for holes and declares it.
TEST(EsriGrid, NanForUndefinedHeights) {
  const HeightGrid grid = grid_of("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value nan\n-nan 2\n3 4\n");
  EXPECT_EQ(grid.heights[0], 3);
  EXPECT_TRUE(std::isnan(grid.heights[2]));
}

TEST(EsriGrid, Damaged) {
  const std::string header = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  EXPECT_EQ(error_of(header + "1 2 3\n"), "grid.txt:7:1: found the end of the file, expected a height");
  EXPECT_EQ(error_of(header + "1 2\n3 4\n5 6\n"), "grid.txt:8:1: found '5', expected the end of the file after 4 heights; correct the numbers of columns and rows in the header");
  EXPECT_EQ(error_of(header + "1 2\n3 four\n"), "grid.txt:7:3: found 'four', expected a height");
  EXPECT_EQ(error_of(header + "byteorder LSBFIRST\n1 2\n3 4\n"), "grid.txt:6:1: found 'byteorder', expected a key of an ESRI ASCII grid, such as ncols, or a height");
  EXPECT_EQ(error_of("ncols 1\nnrows 2\n"), "grid.txt:1:7: found '1', expected a number from 2 to 32767");
  EXPECT_EQ(error_of("ncols 2\nncols 2\n"), "grid.txt:2:1: found 'ncols', expected each key once");
  EXPECT_EQ(error_of("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\n1 2 3 4\n"),
            "grid.txt: found an ESRI ASCII grid without cellsize, expected its header before the heights: ncols, nrows, xllcorner, yllcorner, cellsize");
  EXPECT_EQ(error_of("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize -1\n1 2 3 4\n"), "grid.txt:5:10: found '-1', expected the value of cellsize, above 0");
}

TEST(SurferGrid, RowsBeginInTheSouth) {
  const HeightGrid grid = grid_of("DSAA\n3 2\n10 14\n20 21\n1 6\n1 2 3\n\n4 1.70141e+038 6\n");
  EXPECT_EQ(grid.note, "");
  EXPECT_EQ(grid.domain_x, (Interval{10, 14}));
  EXPECT_EQ(grid.domain_z, (Interval{20, 21}));
  EXPECT_EQ(grid.height(2, 0), 3);
  EXPECT_EQ(grid.height(0, 1), 4);
  EXPECT_TRUE(std::isnan(grid.height(1, 1)));
  EXPECT_EQ(error_of("DSAA\n3 2\n10 14\n20 21\n1 6\n1 2 3\n4 5\n"), "grid.txt:8:1: found the end of the file, expected a height");
  EXPECT_EQ(error_of("DSAA\n3 -2\n"), "grid.txt:2:3: found '-2', expected a number of rows from 2 to 32767");
  EXPECT_EQ(error_of("DSAA\n3 2\n10 x\n"), "grid.txt:3:4: found 'x', expected the greatest x");
}

TEST(LoadHeightGrid, FilesThatAreNotGrids) {
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

// The same heights in four layouts: 10 y + x for x 0 to 6 and y 0 to 4, but 60 at (5, 3).
TEST(LoadHeightGrid, OneHillInFourLayouts) {
  for (const char* file : {"xyz-four-columns.xyz", "gnuplot-nonuniform.dat", "esri.asc", "surfer.grd"}) {
    const auto grid = load_height_grid(std::string(SIGHTLINE_TEST_DATA "/heights/") + file);
    ASSERT_TRUE(grid) << grid.error().message(base::MessageStyle::position);
    ASSERT_EQ(grid->points(), 7U) << file;
    ASSERT_EQ(grid->slices(), 5U) << file;
    EXPECT_EQ(grid->domain_x, (Interval{105, 165})) << file;
    EXPECT_EQ(grid->domain_z, (Interval{205, 245})) << file;
    for (std::size_t slice = 0; slice < 5; ++slice)
      for (std::size_t point = 0; point < 7; ++point)
        EXPECT_EQ(grid->height(point, slice), point == 5 && slice == 3 ? 60 : static_cast<double>(10 * slice + point)) << file;
  }
}

TEST(LoadHeightGrid, SurfacesThatAreNotOverAGrid) {
  const auto error = [](const std::string& file) {
    const auto grid = load_height_grid(SIGHTLINE_TEST_DATA "/heights/" + file);
    return grid ? "no error" : grid.error().found;
  };
  EXPECT_EQ(error("xyz-scatter.xyz"), "60 scattered points with 60 different values of x and 60 of y, no grid of columns and rows");
  EXPECT_EQ(error("gnuplot-parametric.dat"), "4 blocks of points that form no grid: a parametric surface");
}

}  // namespace
}  // namespace sightline::scene
