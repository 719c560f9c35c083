// Overlays: the colours of the cases, a legend, and text that is the same on all platforms.
#include "host/picture/overlay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>


namespace sightline::picture {
namespace {

std::array<int, 3> pixel(const Image& image, int column, int row) {
  const std::size_t at = image.index(column, row);
  return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
}

constexpr std::array<int, 3> white{255, 255, 255};
constexpr std::array<int, 3> grey{110, 110, 110};
constexpr std::array<int, 3> orange{213, 94, 0};
constexpr std::array<int, 3> blue{0, 90, 200};

// Pixels near (column, row) that have the colour.
int count_near(const Image& image, int column, int row, const std::array<int, 3>& colour) {
  int count = 0;
  for (int y = row - 3; y <= row + 3; ++y)
    for (int x = column - 3; x <= column + 3; ++x) count += pixel(image, x, y) == colour ? 1 : 0;
  return count;
}

TEST(Overlay, OfLinesHasTheThreeColours) {
  const LineDifference difference{
      {{{100, 100}, {300, 100}}}, {{{100, 500}, {300, 500}}}, {{{100, 900}, {300, 900}}}};
  const Overlay overlay = overlay_of(difference, {0, 0}, {1023, 1023}, {"house: guest"});
  const Image image = overlay_image(overlay);
  EXPECT_EQ(image.width, 1027);
  EXPECT_EQ(image.height, 1123);
  EXPECT_GT(count_near(image, 200, 1024 - 100, grey), 0) << "y counts up";
  EXPECT_GT(count_near(image, 200, 1024 - 500, orange), 0);
  EXPECT_GT(count_near(image, 200, 1024 - 900, blue), 0);
  EXPECT_EQ(count_near(image, 400, 1024 - 500, white), 49);
  const std::string svg = overlay_svg(overlay, "a <b>");
  for (const char* part : {"agreed", "missing", "extra", "legend", "#d55e00", "a &lt;b&gt;"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
}

TEST(Overlay, OfPixelsHasTheThreeColours) {
  PixelGrid truth(64, 64);
  PixelGrid drawn(64, 64);
  for (int column = 10; column < 20; ++column) truth.set(column, 5, 1), drawn.set(column, 5, 1);
  truth.set(40, 20, 1);
  drawn.set(50, 60, 1);
  truth.set(30, 30, 2);
  drawn.set(30, 30, 3);
  const Image image = overlay_image(overlay_of(truth, drawn, {"sinc"}));
  const auto middle = [](int point) { return point * 16 + 8; };
  ASSERT_EQ(image.width, 1038) << "a pen of 13 and 7 pixels around";
  EXPECT_EQ(pixel(image, 7 + middle(15), 1031 - middle(5)), grey);
  EXPECT_EQ(pixel(image, 7 + middle(40), 1031 - middle(20)), orange);
  EXPECT_EQ(pixel(image, 7 + middle(50), 1031 - middle(60)), blue);
  EXPECT_EQ(pixel(image, 7 + middle(30), 1031 - middle(30)), blue) << "lit in both, but not alike";
  EXPECT_EQ(pixel(image, 7 + middle(5), 1031 - middle(5)), white);
}

}  // namespace
}  // namespace sightline::picture
