// Lettering: every character exists, differs from all others and stays in its box.
#include "host/picture/lettering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace sightline::picture {
namespace {

std::string every_sign() {
  std::string all;
  for (char c = ' '; c <= '~'; ++c) all += c;
  return all;
}

VectorDrawing drawn(const std::string& text, double height = 6, TextDirection direction = {}) {
  VectorDrawing drawing;
  append_text(drawing, 0, 0, 0, height, text, direction);
  return drawing;
}

TEST(Lettering, EveryCharacterIsWithinItsBox) {
  for (const char c : every_sign()) {
    const std::string sign(1, c);
    VectorDrawing drawing;
    EXPECT_EQ(append_text(drawing, 0, 10, 20, 6, sign), 10 + text_width(6, sign));
    for (const DrawingPoint& p : drawing.points)
      EXPECT_TRUE(p.x >= 10 && p.x <= 10 + text_width(6, sign) && p.y >= 18 && p.y <= 27) << c;
    EXPECT_EQ(drawing.lines.empty(), c == ' ') << c;
    for (const DrawingLine& line : drawing.lines) {
      EXPECT_GT(line.count, 0U) << c;
      EXPECT_LE(line.first + line.count, drawing.points.size()) << c;
    }
  }
}

// A character has its stated width: its strokes reach both sides.
TEST(Lettering, CharactersFillTheirWidth) {
  for (const char c : every_sign()) {
    const auto points = drawn(std::string(1, c)).points;
    if (points.empty() || (c >= '0' && c <= '9')) continue;
    const auto [left, right] = std::minmax_element(points.begin(), points.end(), [](DrawingPoint a, DrawingPoint b) { return a.x < b.x; });
    EXPECT_EQ(right->x, text_width(6, std::string(1, c))) << c;
    EXPECT_EQ(left->x, 0) << c;
  }
}

TEST(Lettering, CharactersDiffer) {
  const std::string all = every_sign();
  for (const char a : all)
    for (const char b : all) EXPECT_EQ(drawn(std::string(1, a)).points == drawn(std::string(1, b)).points, a == b) << a << b;
  EXPECT_EQ(drawn("\n").points, drawn("\xe4").points);
}

TEST(Lettering, DigitsHaveOneWidth) {
  for (char c = '1'; c <= '9'; ++c) EXPECT_EQ(text_width(6, std::string(1, c)), text_width(6, "0"));
}

// Strokes of the characters follow each other; those of a turned text are turned.
TEST(Lettering, TextConsistsOfItsCharacters) {
  const VectorDrawing whole = drawn("Qgy 8");
  VectorDrawing parts;
  double x = 0;
  for (const char c : std::string("Qgy 8")) x = append_text(parts, 0, x, 0, 6, std::string(1, c)) + 2;
  EXPECT_EQ(whole.points, parts.points);
  EXPECT_EQ(text_width(12, "Qgy 8"), 2 * (x - 2));
  const VectorDrawing upwards = drawn("Qgy 8", 6, {0, 1});
  ASSERT_EQ(upwards.points.size(), whole.points.size());
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    EXPECT_EQ(upwards.points[i].x, -whole.points[i].y);
    EXPECT_EQ(upwards.points[i].y, whole.points[i].x);
  }
}

// Small letters without an ascender end at two thirds of a capital; g, j, p, q and y extend below the line, and so do , ; _ and
// $.
TEST(Lettering, HeightsOfSmallLetters) {
  for (char c = 'a'; c <= 'z'; ++c) {
    const auto points = drawn(std::string(1, c)).points;
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), [](DrawingPoint a, DrawingPoint b) { return a.y < b.y; });
    EXPECT_EQ(high->y, std::string("bdfhijklt").find(c) == std::string::npos ? 4 : 6) << c;
    EXPECT_EQ(low->y, std::string("gjpqy").find(c) == std::string::npos ? 0 : -2) << c;
  }
}

}  // namespace
}  // namespace sightline::picture
