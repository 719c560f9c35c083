// PDF and DXF read back by the rules of their formats: every line is at its position on the paper.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "host/picture/dxf.hpp"
#include "host/picture/pdf.hpp"
#include "tests/support/read_drawing.hpp"

namespace sightline::picture {
namespace {

using tests::DrawnLines;

const Paper a_sheet{120, 90, 10, 0.3};

VectorDrawing three_lines() {
  VectorDrawing drawing;
  drawing.width = 50;  // two millimetres each, one across
  drawing.height = 70;
  drawing.layers = {{"silhouette", {0, 0, 0}}, {"crease (30)", {200, 0, 0}}};
  drawing.points = {{0, 0}, {50, 0}, {50, 70}, {10, 10}, {20, 30}, {25, 35}, {1, 1}, {2, 1}, {2, 2}};
  drawing.lines = {{0, 0, 3}, {1, 3, 2}, {1, 5, 1}};
  drawing.facets = {{6, 3, {128, 128, 128}}};
  return drawing;
}

const DrawnLines expected_lines{{{10, 10}, {110, 10}, {110, 80}}, {{30, 20}, {50, 40}}, {{60, 45}}};

// Layers without lines are in no file, and the others have the same numbers in all files.
TEST(VectorDrawings, LayersWithoutLinesAreOmitted) {
  VectorDrawing drawing = three_lines();
  drawing.layers = {{"flat", {1, 1, 1}}, drawing.layers[0], {"border", {2, 2, 2}}, drawing.layers[1], {"hidden", {3, 3, 3}}};
  for (DrawingLine& line : drawing.lines) line.layer = line.layer == 0 ? 1 : 3;
  drawing.lines.push_back({2, 0, 0});
  const VectorDrawing left = without_empty_layers(drawing);
  ASSERT_EQ(left.layers.size(), 2U);
  EXPECT_EQ(left.layers[0].label, "silhouette");
  EXPECT_EQ(left.layers[1].label, "crease (30)");
  EXPECT_EQ(left.layers[1].colour, (Colour{200, 0, 0}));
  EXPECT_EQ(left.lines, three_lines().lines);
  EXPECT_EQ(svg_of(left, a_sheet, "t"), svg_of(three_lines(), a_sheet, "t"));
  EXPECT_EQ(pdf_of(left, a_sheet, "t"), pdf_of(three_lines(), a_sheet, "t"));
  EXPECT_EQ(dxf_of(left, a_sheet), dxf_of(three_lines(), a_sheet));
  EXPECT_TRUE(without_empty_layers(VectorDrawing{10, 10, {{"a", {}}}, {}, {}, {}}).layers.empty());
}

// The middle of the ink of an upright line in its row, in pixels.
double middle_of_ink(const Image& image, int row) {
  double ink = 0;
  double sum = 0;
  for (int column = 0; column < image.width; ++column) {
    const double dark = 255 - image.pixels[image.index(column, row)];
    ink += dark;
    sum += dark * (column + 0.5);
  }
  return sum / ink;
}

// A4 at 150 dots per inch is not a whole number of pixels: lines are at their position on the paper, to a hundredth of a
// millimetre.
TEST(VectorDrawings, ASheetHasTheSamePixelsForEveryMillimetre) {
  VectorDrawing sheet;
  sheet.width = 210;
  sheet.height = 297;
  sheet.layers = {{"visible", {0, 0, 0}}};
  constexpr double dots = 150 / 25.4;
  for (const float x : {10.0F, 100.0F, 200.0F}) {
    sheet.points = {{x, 20}, {x, 280}};
    sheet.lines = {{0, 0, 2}};
    const Image image = image_of(sheet, {1240, 1754, 0.2 * dots, dots});
    EXPECT_NEAR(middle_of_ink(image, 877) / dots, double{x}, 0.01);
  }
}

TEST(Pdf, ObjectsMatchTheTableAndLinesThePaper) {
  const std::string pdf = pdf_of(three_lines(), a_sheet, "a (drawing)");
  EXPECT_EQ(pdf, pdf_of(three_lines(), a_sheet, "a (drawing)"));
  ASSERT_EQ(pdf.substr(0, 8), "%PDF-1.5");
  const std::size_t start = pdf.rfind("startxref\n");
  ASSERT_NE(start, std::string::npos);
  const auto table = static_cast<std::size_t>(std::atol(pdf.c_str() + start + 10));
  ASSERT_EQ(pdf.substr(table, 5), "xref\n");
  std::istringstream rows(pdf.substr(table + 5));
  int first = 0;
  int count = 0;
  rows >> first >> count;
  EXPECT_EQ(count, 1 + 5 + 2);
  for (int i = 0; i < count; ++i) {
    std::string place;
    std::string generation;
    std::string kind;
    rows >> place >> generation >> kind;
    EXPECT_EQ(place.size(), 10U);
    if (i == 0) continue;
    const std::string begins = std::to_string(i) + " 0 obj\n";
    EXPECT_EQ(pdf.substr(static_cast<std::size_t>(std::atol(place.c_str())), begins.size()), begins);
  }
  const std::size_t stream = pdf.find("stream\n") + 7;
  const auto length = static_cast<std::size_t>(std::atol(pdf.c_str() + pdf.find("/Length ") + 8));
  EXPECT_EQ(pdf.substr(stream + length, 9), "endstream");
  EXPECT_NE(pdf.find("/MediaBox [0 0 340.157 255.118]"), std::string::npos);  // 120 and 90 mm in points
  EXPECT_NE(pdf.find("/Name (crease \\(30\\))"), std::string::npos);
  const DrawnLines lines = tests::lines_of_pdf(pdf);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], (std::vector<std::pair<double, double>>{{12, 11}, {14, 11}, {14, 12}}));  // the facet
  EXPECT_EQ(lines[1], expected_lines[0]);
  EXPECT_EQ(lines[2], expected_lines[1]);
  EXPECT_EQ(lines[3], (std::vector<std::pair<double, double>>{{60, 45}, {60, 45}}));
}

TEST(Dxf, EntitiesHaveLayersOfTheTable) {
  const std::string dxf = dxf_of(three_lines(), a_sheet);
  std::istringstream text(dxf);
  std::vector<std::pair<int, std::string>> groups;
  for (std::string code, value; std::getline(text, code) && std::getline(text, value);)
    groups.emplace_back(std::atoi(code.c_str()), value);
  ASSERT_GT(groups.size(), 20U);
  EXPECT_EQ(groups.back(), std::pair(0, std::string("EOF")));
  EXPECT_EQ(groups[3], std::pair(1, std::string("AC1009")));
  std::map<std::string, int> layers;
  std::string entity;
  std::string of;
  for (const auto& [code, value] : groups) {
    if (code == 0) entity = value;
    if (entity == "LAYER" && code == 2) of = value;
    if (entity == "LAYER" && code == 62) layers[of] = std::atoi(value.c_str());
    if (code == 8) {
      EXPECT_TRUE(layers.contains(value)) << value;
    }
  }
  EXPECT_EQ(layers, (std::map<std::string, int>{{"1-SILHOUETTE", 7}, {"2-CREASE__30_", 1}}));
  EXPECT_EQ(tests::lines_of_dxf(dxf), expected_lines);
}

// A layer of dashed lines has a linetype with the drawing's dash and gap, and unbroken lines.
TEST(Dxf, DashedLayersHaveALinetype) {
  VectorDrawing drawing = three_lines();
  drawing.layers[1].dash = 4;  // drawing units across: two millimetres each
  const std::string dxf = dxf_of(drawing, a_sheet);
  EXPECT_NE(dxf.find("  2\nDASHED\n 70\n64\n  3\n__ __ __ __\n 72\n65\n 73\n2\n 40\n14.000\n 49\n8.000\n 49\n-6.000\n"),
            std::string::npos);
  EXPECT_NE(dxf.find("2-CREASE__30_\n 70\n64\n 62\n1\n  6\nDASHED\n"), std::string::npos);
  EXPECT_NE(dxf.find("1-SILHOUETTE\n 70\n64\n 62\n7\n  6\nCONTINUOUS\n"), std::string::npos);
  EXPECT_EQ(tests::lines_of_dxf(dxf), expected_lines);
}

// A segment shorter than a thousandth of a millimetre is omitted, alone or within a line.
TEST(VectorDrawings, NoSegmentHasLengthZeroInAFile) {
  VectorDrawing drawing;
  drawing.width = 100;
  drawing.height = 70;
  drawing.layers = {{"one", {}}};
  drawing.points = {{1, 1}, {1.0001F, 1}, {5, 1}, {5, 1.0002F}, {5, 5}, {7, 7}, {7.0001F, 7}, {8, 8}};
  drawing.lines = {{0, 0, 5}, {0, 5, 2}, {0, 7, 1}};
  const DrawnLines expected{{{11, 11}, {15, 11}, {15, 15}}};
  const auto without_dots = [](DrawnLines lines) {
    if (!lines.empty()) lines.pop_back();
    return lines;
  };
  EXPECT_EQ(without_dots(tests::lines_of_svg(svg_of(drawing, a_sheet, "t"), a_sheet.height)), expected);
  EXPECT_EQ(without_dots(tests::lines_of_pdf(pdf_of(drawing, a_sheet, "t"))), expected);
  EXPECT_EQ(without_dots(tests::lines_of_dxf(dxf_of(drawing, a_sheet))), expected);
}

// Rounding errors of relative coordinates do not accumulate: after thousands of them a line is at its position.
TEST(Svg, LinesAreAtTheirPositionOnThePaper) {
  VectorDrawing drawing;
  drawing.width = 50;
  drawing.height = 70;
  drawing.layers = {{"one", {}}};
  DrawnLines expected;
  std::mt19937 dice(5);
  for (int n = 0; n < 40; ++n) {
    const auto first = static_cast<std::uint32_t>(drawing.points.size());
    expected.emplace_back();
    for (int k = 0; k < 300; ++k) {
      drawing.points.push_back({static_cast<float>(dice() % 50001) / 1000, static_cast<float>(dice() % 70001) / 1000});
      expected.back().push_back({10 + 2 * double{drawing.points.back().x}, 10 + double{drawing.points.back().y}});
    }
    drawing.lines.push_back({0, first, 300});
  }
  const std::string svg = svg_of(drawing, a_sheet, "lines");
  const DrawnLines read = tests::lines_of_svg(svg, a_sheet.height);
  ASSERT_EQ(read.size(), expected.size());
  for (std::size_t n = 0; n < read.size(); ++n) {
    ASSERT_EQ(read[n].size(), expected[n].size());
    for (std::size_t k = 0; k < read[n].size(); ++k) {
      EXPECT_NEAR(read[n][k].first, expected[n][k].first, 0.00051);
      EXPECT_NEAR(read[n][k].second, expected[n][k].second, 0.00051);
    }
  }
}

// Many lines share paths, and are the same lines.
TEST(Svg, VeryManyLinesShareAPath) {
  VectorDrawing drawing;
  drawing.width = 50;
  drawing.height = 70;
  drawing.layers = {{"one", {}}};
  constexpr std::uint32_t count = 100'050;
  for (std::uint32_t n = 0; n < count; ++n) {
    drawing.points.push_back({static_cast<float>(n % 50), static_cast<float>(n / 50 % 70)});
    drawing.points.push_back({static_cast<float>(n % 50), static_cast<float>(n / 50 % 70) + 0.5F});
    drawing.lines.push_back({0, 2 * n, n % 3 == 0 ? 1U : 2U});
  }
  const std::string svg = svg_of(drawing, a_sheet, "lines");
  std::size_t paths = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) ++paths;
  EXPECT_EQ(paths, (count + 63) / 64);
  const DrawnLines read = tests::lines_of_svg(svg, a_sheet.height);
  ASSERT_EQ(read.size(), count);
  for (const std::uint32_t n : {1U, 63U, 64U, 65U, 77'777U, count - 1}) {
    EXPECT_NEAR(read[n][0].first, 10 + 2 * (n % 50) - (n % 3 == 0 ? 0.01 : 0), 1e-6) << n;
    EXPECT_NEAR(read[n][0].second, 10 + n / 50 % 70, 1e-6) << n;
  }
}

}  // namespace
}  // namespace sightline::picture
