// The approval helper must be able to fail, and a failure must name the file to check.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/approve_png.hpp"

namespace sightline::tests {
namespace {

class Approve : public testing::Test {
 protected:
  void SetUp() override {
    if (approving()) GTEST_SKIP() << "would approve its own wrong answers";
  }
};

std::string failure(const testing::AssertionResult& verdict) {
  return verdict ? "" : verdict.failure_message();
}

picture::Image three_points() {
  picture::Image image(4, 3, 1);
  image.pixels[image.index(0, 0)] = 255;
  image.pixels[image.index(1, 1)] = 255;
  image.pixels[image.index(2, 2)] = 255;
  return image;
}

TEST(Approved, EqualBytesPass) {
  EXPECT_TRUE(matches_approved("first line\nsecond line\n", "support/two_lines.txt"));
}

TEST(Approved, EqualPicturesPass) {
  EXPECT_TRUE(matches_approved_png(three_points(), "support/three_points.png"));
}

TEST_F(Approve, OtherBytesFailAndAreKept) {
  const std::string received = "first line\nsecond lime\n";
  const std::string message = failure(matches_approved(received, "support/two_lines.txt"));
  EXPECT_NE(message.find("first difference at byte 20 (line 2)"), std::string::npos) << message;
  EXPECT_NE(message.find(received_path("support/two_lines.txt").string()), std::string::npos) << message;
  EXPECT_EQ(read_whole(received_path("support/two_lines.txt")), received);
  EXPECT_NE(failure(matches_approved("first line\n", "support/two_lines.txt")), "");
}

TEST_F(Approve, NothingApprovedYetFails) {
  const std::string message = failure(matches_approved("x", "support/never_approved.txt"));
  EXPECT_NE(message.find("nothing is approved yet"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(approved_path("support/never_approved.txt")));
}

TEST_F(Approve, PicturesFailWithAPictureOfTheDifference) {
  picture::Image other = three_points();
  other.pixels[other.index(1, 1)] = 0;
  other.pixels[other.index(3, 0)] = 255;
  other.pixels[other.index(3, 1)] = 255;
  const std::string message = failure(matches_approved_png(other, "support/three_points.png"));
  EXPECT_NE(message.find("1 pixels missing (red), 2 extra (green)"), std::string::npos) << message;
  const std::string path = received_path("support/three_points.png.difference.png").string();
  EXPECT_NE(message.find(path), std::string::npos) << message;
  const auto shown = picture::read_png(path);
  ASSERT_TRUE(shown) << shown.error().message();
  const auto colour = [&](int column, int row) {
    const auto first =
        shown->image.pixels.begin() + static_cast<std::ptrdiff_t>(shown->image.index(column, row));
    return std::vector<int>(first, first + 3);
  };
  EXPECT_EQ(colour(0, 0), (std::vector{255, 255, 255}));
  EXPECT_EQ(colour(1, 1), (std::vector{255, 0, 0}));
  EXPECT_EQ(colour(3, 0), (std::vector{0, 255, 0}));
  EXPECT_EQ(colour(0, 1), (std::vector{0, 0, 0}));
}

TEST(PictureDifference, SizesMayDiffer) {
  const auto difference = picture_difference(picture::Image(2, 1, 1), picture::Image(1, 2, 3));
  EXPECT_EQ(difference.image.width, 2);
  EXPECT_EQ(difference.image.height, 2);
  EXPECT_EQ(difference.missing, 1);
  EXPECT_EQ(difference.extra, 1);
}

}  // namespace
}  // namespace sightline::tests
