// Grid formats that say what they are, byte by byte after their documentation, and what makes a file larger or smaller than its grid.
#include "host/scene/heights/grid_formats.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "host/scene/heights/read_grid.hpp"

namespace sightline::scene {
namespace {

std::string error_of(const std::string& bytes, const std::string& name = "grid", const GridFileOptions& options = {}) {
  const auto result = read_height_grid(bytes, name, options);
  return result ? "no error" : result.error().message(base::MessageStyle::position);
}

HeightGrid grid_of(const std::string& bytes, const std::string& name = "grid", const GridFileOptions& options = {}) {
  const auto result = read_height_grid(bytes, name, options);
  if (result) return *result;
  ADD_FAILURE() << result.error().message(base::MessageStyle::position);
  return HeightGrid{{0}, {0}, {0}, {}, {}, {}};
}

// --- Surfer 6 in binary

template <class Unsigned>
std::string little_endian(Unsigned value) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xFFU);
  return bytes;
}

std::string surfer(std::uint16_t columns, std::uint16_t rows, const std::vector<double>& limits, const std::vector<float>& heights) {
  std::string bytes = "DSBB" + little_endian(columns) + little_endian(rows);
  for (const double limit : limits) bytes += little_endian(std::bit_cast<std::uint64_t>(limit));
  for (const float height : heights) bytes += little_endian(std::bit_cast<std::uint32_t>(height));
  return bytes;
}

const std::vector<double> limits{10, 14, 20, 21, 1, 6};

TEST(SurferBinary, RowsFromSouthToNorth) {
  const std::string bytes = surfer(3, 2, limits, {1, 2, 3.5F, 4, 1.70141e38F, 6});
  EXPECT_EQ(bytes.size(), 80U);
  const HeightGrid grid = grid_of(bytes);
  ASSERT_EQ(grid.points(), 3U);
  ASSERT_EQ(grid.slices(), 2U);
  EXPECT_EQ(grid.domain_x, (Interval{10, 14}));
  EXPECT_EQ(grid.domain_z, (Interval{20, 21}));
  EXPECT_EQ(grid.height(2, 0), 3.5);
  EXPECT_EQ(grid.height(0, 1), 4);
  EXPECT_TRUE(std::isnan(grid.height(1, 1)));
  EXPECT_EQ(grid.range, (Interval{1, 6})) << "of the heights, not of the header";
  EXPECT_EQ(grid.note, "");
}

TEST(SurferBinary, Damaged) {
  const std::vector<float> six{1, 2, 3, 4, 5, 6};
  const std::string whole = surfer(3, 2, limits, six);
  EXPECT_EQ(error_of("DSBB"), "grid:byte 4: found the end of the file, expected a header of 56 bytes of a binary Surfer grid");
  EXPECT_EQ(error_of(whole.substr(0, 79)), "grid:byte 79: found the end of the file, expected 80 bytes for 2 rows of 3 heights");
  EXPECT_EQ(error_of(whole + "1234"), "grid:byte 84: found the end of the file, expected 80 bytes for 2 rows of 3 heights");
  EXPECT_EQ(error_of(surfer(1, 2, limits, six)), "grid:byte 4: found 1 columns, expected 2 or more");
  EXPECT_EQ(error_of(surfer(3, 0, limits, six)), "grid:byte 6: found 0 rows, expected 2 or more");
  EXPECT_EQ(error_of(surfer(3, 0xFFFF, limits, six)), "grid:byte 6: found -1 rows, expected 2 or more");
  EXPECT_EQ(error_of(surfer(32767, 32767, limits, six)), "grid:byte 80: found the end of the file, expected 4294705212 bytes for 32767 rows of 32767 heights");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of(surfer(3, 2, {14, 10, 20, 21, 1, 6}, six)), "grid: found places from 14 to 10, expected places that rise, of finite numbers");
  EXPECT_NE(error_of(surfer(3, 2, {10, nan, 20, 21, 1, 6}, six)), "no error");
  EXPECT_NE(error_of(surfer(3, 2, {10, 14, 20, infinity, 1, 6}, six)), "no error");
  EXPECT_EQ(error_of(surfer(3, 2, {10, 14, 20, 21, nan, nan}, six)), "no error") << "the heights say their range";
  EXPECT_EQ(error_of(surfer(3, 2, limits, {1, 2, 3, 4, -std::numeric_limits<float>::infinity(), 6})), "grid:byte 72: found an infinite height, expected a number, or 1.70141e38 for a hole");
  EXPECT_TRUE(std::isnan(grid_of(surfer(3, 2, limits, {1, 2, 3, 4, std::numeric_limits<float>::quiet_NaN(), 6})).height(1, 1)));
}

// --- headers of ASCII grids that lie

TEST(GridHeaders, Absurd) {
  const std::string rest = "\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3 4\n";
  for (const char* count : {"0", "1", "-2", "2.5", "1e3", "nan", "inf", "99999999999999999999", "32768"})
    EXPECT_EQ(error_of("ncols " + std::string(count) + rest).substr(0, 9), "grid:1:7:") << count;
  // More than any file has: found where the file ends, without memory for it.
  EXPECT_EQ(error_of("ncols 32767\nnrows 32767\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3 4\n"), "grid:7:1: found the end of the file, expected a height");
  EXPECT_EQ(error_of("DSAA\n32767 32767\n0 1\n0 1\n0 1\n1 2 3 4\n"), "grid:7:1: found the end of the file, expected a height");
  for (const char* size : {"0", "-1", "nan", "inf", "1e999", "x"})
    EXPECT_EQ(error_of("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize " + std::string(size) + "\n1 2 3 4\n").substr(0, 10), "grid:5:10:") << size;
  for (const char* corner : {"nan", "inf", "-", "1e400"})
    EXPECT_EQ(error_of("ncols 2\nnrows 2\nxllcorner " + std::string(corner) + "\nyllcorner 0\ncellsize 1\n1 2 3 4\n").substr(0, 10), "grid:3:11:") << corner;
  // Steps that a double cannot tell apart, or beyond its range.
  EXPECT_NE(error_of("ncols 2\nnrows 2\nxllcorner 1e300\nyllcorner 0\ncellsize 1\n1 2 3 4\n"), "no error");
  EXPECT_NE(error_of("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1e308\n1 2 3 4 5 6\n"), "no error");
  EXPECT_NE(error_of("DSAA\n2 2\n0 0\n0 1\n0 1\n1 2 3 4\n"), "no error");
  EXPECT_NE(error_of("DSAA\n2 2\n-1e308 1e309\n0 1\n0 1\n1 2 3 4\n"), "no error");
  EXPECT_EQ(error_of("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n-9999 -9999 -9999 -9999\n"), "grid: found a grid without any defined height, expected at least one");
}

TEST(GridHeaders, KeysInAnyOrder) {
  EXPECT_EQ(grid_of("cellsize 2\nNODATA_value 4\nyllcorner 0\nxllcorner 0\nnrows 2\nncols 2\n1 2 3 4\n").domain_x, (Interval{1, 3}));
  EXPECT_EQ(error_of("dx dy\n1 2\n3 4\n"), "no error") << "a heading of two columns";
}

// --- SRTM

std::string tile(std::size_t side, const std::string& north_west = std::string(2, '\0')) {
  std::string bytes(2 * side * side, '\0');
  bytes.replace(0, 2, north_west);
  return bytes;
}

TEST(HgtGrid, NorthWestFirst) {
  std::string bytes = tile(1201, "\x01\x02");
  bytes[2 * 1200] = '\xFF';  // the north-east corner: -2
  bytes[2 * 1200 + 1] = '\xFE';
  bytes[bytes.size() - 2] = '\x80';  // the south-east corner: no height
  const HeightGrid grid = grid_of(bytes, "tiles/N47E011.hgt", {.thin = 600});
  ASSERT_EQ(grid.points(), 3U);
  EXPECT_EQ(grid.height(0, 2), 0x0102);
  EXPECT_EQ(grid.height(2, 2), -2);
  EXPECT_TRUE(std::isnan(grid.height(2, 0)));
  EXPECT_EQ(grid.domain_x, (Interval{11, 12}));
  EXPECT_EQ(grid.domain_z, (Interval{47, 48}));
  EXPECT_EQ(grid.note, "every 600th point of 1201 x 1201 is taken, a grid of 3 x 3");
  EXPECT_EQ(grid_of(bytes, "s08w079.HGT", {.thin = 600}).domain_x, (Interval{-79, -78}));
  EXPECT_EQ(grid_of(bytes, "s08w079.HGT", {.thin = 600}).domain_z, (Interval{-8, -7}));
  EXPECT_EQ(grid_of(bytes, "-", {.thin = 600}).domain_x, (Interval{0, 1})) << "told by its size";
  EXPECT_EQ(error_of(bytes, "N47E011.hgt"), "N47E011.hgt: found 1201 slices of 1201 points, expected at most 1024 of 1024; --thin 2 takes every 2nd point");
}

TEST(HgtGrid, OneSecond) {
  EXPECT_EQ(error_of(tile(3601), "N47E011.hgt"), "N47E011.hgt: found 3601 slices of 3601 points, expected at most 1024 of 1024; --thin 4 takes every 4th point");
  EXPECT_EQ(grid_of(tile(3601), "N47E011.hgt", {.thin = 4}).points(), 901U);
  const HeightGrid fitted = grid_of(tile(3601), "N47E011.hgt", {.thin_to_fit = true});
  EXPECT_EQ(fitted.heights, grid_of(tile(3601), "N47E011.hgt", {.thin = 4}).heights);
  EXPECT_EQ(fitted.note, "every 4th point of 3601 x 3601 is taken, a grid of 901 x 901");
}

TEST(HgtGrid, OtherSizes) {
  for (const std::string& bytes : {std::string(), std::string("x"), tile(1201).substr(1), tile(1201) + "x", tile(1200)}) {
    EXPECT_EQ(error_of(bytes, "N47E011.hgt"), "N47E011.hgt: found " + std::to_string(bytes.size()) +
                                                  " bytes, expected an SRTM tile: 2884802 bytes (1201 x 1201 heights) or 25934402 (3601 x 3601); "
                                                  "if it is compressed, unpack it; other sizes are no HGT files");
  }
}

// --- holes and thinning

TEST(GridOptions, Nodata) {
  EXPECT_TRUE(std::isnan(grid_of("1 -7\n3 4\n", "grid", {.nodata = -7}).height(1, 0)));
  EXPECT_EQ(grid_of("1 -7\n3 4\n", "grid", {.nodata = -7}).range, (Interval{1, 4}));
  // Besides those of the format; of points the height alone.
  const HeightGrid esri = grid_of("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n-9999 0\n1 2\n", "grid", {.nodata = 0});
  EXPECT_TRUE(std::isnan(esri.height(0, 1)) && std::isnan(esri.height(1, 1)));
  const HeightGrid points = grid_of("0 0 0\n1 0 2\n0 1 3\n1 1 4\n", "grid", {.nodata = 0});
  EXPECT_TRUE(std::isnan(points.height(0, 0)));
  EXPECT_EQ(points.domain_x, (Interval{0, 1}));
  EXPECT_TRUE(std::isnan(grid_of("1 -3.4028234663852886e38\n3 4\n", "grid", {.nodata = -3.40282e38}).height(1, 0)));
  EXPECT_EQ(error_of("1 1\n1 1\n", "grid", {.nodata = 1}), "grid: found a grid without any defined height, expected at least one");
}

TEST(GridOptions, Thinned) {
  // Heights 10 y + x on 7 x 5 places of distance 1.
  std::string text = "ncols 7\nnrows 5\nxllcenter 0\nyllcenter 0\ncellsize 1\n";
  for (int y = 4; y >= 0; --y)
    for (int x = 0; x < 7; ++x) text += std::to_string(10 * y + x) + " ";
  const HeightGrid third = grid_of(text, "grid", {.thin = 3});
  EXPECT_EQ(third.heights, (std::vector<double>{0, 3, 6, 30, 33, 36}));
  EXPECT_EQ(third.domain_x, (Interval{0, 6}));
  EXPECT_EQ(third.domain_z, (Interval{0, 3}));
  EXPECT_EQ(third.x, (std::vector<double>{-1, 0, 1}));
  EXPECT_EQ(third.z, (std::vector<double>{-1, 1}));
  EXPECT_EQ(third.note, "every 3rd point of 7 x 5 is taken, a grid of 3 x 2");
  EXPECT_EQ(grid_of(text, "grid", {.thin = 99}).heights, (std::vector<double>{0, 6, 40, 46})) << "two of each stay";
  EXPECT_EQ(grid_of(text, "grid", {.thin = 1}).heights.size(), 35U);
  EXPECT_EQ(grid_of(text, "grid", {.thin = 1}).note, "");
  // Places at any distances: 0 1 10 11 becomes 0 10.
  const HeightGrid table = grid_of("at,0,1,10,11\n0,1,2,3,4\n5,6,7,8,9\n", "grid", {.thin = 2});
  EXPECT_NEAR(table.domain_x.high, 10, 1e-12);
  EXPECT_EQ(table.heights, (std::vector<double>{1, 3, 6, 8}));
}

// --- texts of gnuplot

// gnuplot (set table; splot "file") gives x 0 1 2 and y 0 1 for this file.
TEST(GnuplotGrids, OneHeightALine) {
  const HeightGrid grid = grid_of("1\n2\n3\n\n4\n5\n6\n");
  EXPECT_EQ(grid.heights, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(grid.points(), 3U);
  EXPECT_EQ(grid.domain_x, (Interval{0, 2}));
  EXPECT_EQ(grid.domain_z, (Interval{0, 1}));
  EXPECT_EQ(grid.note, "read as 2 slices of 3 heights, one a line");
  EXPECT_EQ(error_of("1\n2\n3\n\n4\n5\n"), "grid:6:1: found slice 2 of 2 heights, expected 3 as in the first one");
}

SurfaceNet net_of(const std::string& text, const GridFileOptions& options = {}) {
  auto surface = read_height_surface(text, "net", options);
  if (!surface) ADD_FAILURE() << surface.error().message();
  if (surface && std::holds_alternative<SurfaceNet>(*surface)) return std::get<SurfaceNet>(*surface);
  ADD_FAILURE() << "no net";
  return {};
}

TEST(GnuplotGrids, NetOfCurves) {
  const SurfaceNet net = net_of("# x y z\n1 0 0 9\n0 1 0 9\n-1 0 0 9\n\n2 0 1 9\n0 2 NaN 9\n-2 0 1 9\n");
  EXPECT_EQ(net.points, 3U);
  EXPECT_EQ(net.curves, 2U);
  EXPECT_EQ(net.vertices[3], (std::array<double, 3>{2, 0, 1}));
  EXPECT_EQ(net.ranges()[0], (Interval{-2, 2}));
  EXPECT_EQ(net.ranges()[1], (Interval{0, 1})) << "without the hole";
  EXPECT_EQ(net.note, "read as a net of 2 curves of 3 points, column 4 left out");
  EXPECT_EQ(net_of("0 0 0\n1 1 1\n2 0 2\n\n0 1 0\n1 2 1\n2 1 2\n", {.thin = 2}).points, 2U);
}

// A cylinder of 12 sides: the 13th point of each circle is the first one but for rounding.
TEST(GnuplotGrids, MeshOfTheCylinder) {
  const auto surface = load_height_surface(SIGHTLINE_TEST_DATA "/heights/gnuplot-parametric.dat");
  ASSERT_TRUE(surface && std::holds_alternative<SurfaceNet>(*surface));
  const SurfaceNet& net = std::get<SurfaceNet>(*surface);
  EXPECT_EQ(net.points, 13U);
  EXPECT_EQ(net.curves, 4U);
  EXPECT_EQ(net.ranges()[2], (Interval{0, 3}));
  const auto import = import_poly(mesh_of(net, {1, 1, 0.6}, "cylinder"), {.mend = true});
  ASSERT_TRUE(import) << import.error().message();
  EXPECT_EQ(import->scene.vertices.size(), 48U);
  ASSERT_EQ(import->scene.bodies.size(), 1U);
  EXPECT_EQ(import->scene.wires.size(), 4U * 12 + 3 * 12);
  EXPECT_NEAR(bounds_of(import->scene).high[1] * import->scene.step, 0.6, import->scene.step);
}

}  // namespace
}  // namespace sightline::scene
