// Colours of heights: lighter with every step, so that a grey print stays readable.
#include "host/picture/height_colours.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sightline::picture {
namespace {

// Rec. 709 luma.
double lightness(Colour colour) {
  return 0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue;
}

TEST(HeightColours, AreLighterWithHeight) {
  for (int i = 0; i < 128; ++i) {
    EXPECT_LT(lightness(height_colour(i / 128.0)), lightness(height_colour((i + 1) / 128.0))) << i;
    EXPECT_LT(lightness(height_line_colour(i / 128.0)), lightness(height_colour(i / 128.0))) << i;
  }
}

TEST(HeightColours, AreClampedToTheRange) {
  EXPECT_EQ(height_colour(-1), height_colour(0));
  EXPECT_EQ(height_colour(2), height_colour(1));
  EXPECT_EQ(height_colour(std::nan("")), height_colour(0));
}

}  // namespace
}  // namespace sightline::picture
