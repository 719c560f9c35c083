// PNG round trip, errors for damaged files, and files that are written completely or not at all.
#include "host/picture/png.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "host/base/file.hpp"
#include "tests/support/approve.hpp"

namespace sightline::picture {
namespace {

Image noise(int width, int height, int channels) {
  Image image(width, height, channels);
  std::mt19937 random(7);
  for (auto& byte : image.pixels) byte = static_cast<std::uint8_t>(random() & 255U);
  return image;
}

base::Bytes encode_image(const Image& image, const TextEntries& text = {}) {
  auto bytes = encode_png(image, text);
  EXPECT_TRUE(bytes) << bytes.error().message();
  return *bytes;
}

std::string refusal(const base::Bytes& bytes) {
  const auto file = decode_png(bytes, "x.png");
  return file ? "accepted" : file.error().message();
}

// ISO/IEC 15948, 11.3.5.3: pixels per metre across and up, each in four bytes, and 1 for the metre.
TEST(Png, StatesItsSizeOnPaper) {
  const auto sheet = encode_png(noise(4, 3, 1), {}, 150 / 25.4);
  ASSERT_TRUE(sheet);
  const std::string bytes(sheet->begin(), sheet->end());
  const std::size_t at = bytes.find("pHYs");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(bytes.substr(at + 4, 9), std::string("\0\0\x17\x12\0\0\x17\x12\1", 9)) << "5,906 pixels per metre";
  const base::Bytes plain = encode_image(noise(4, 3, 1));
  EXPECT_EQ(std::string(plain.begin(), plain.end()).find("pHYs"), std::string::npos);
}

// A separate directory for each test in the build tree, removed afterwards.
class FileTest : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::current_path() /
                 (std::string("sightline-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (directory_ / name).string(); }
  [[nodiscard]] long files() const {
    return std::distance(std::filesystem::directory_iterator(directory_),
                         std::filesystem::directory_iterator());
  }

  std::filesystem::path directory_;
};

TEST(Png, RoundTrip) {
  for (const int channels : {1, 3}) {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{17, 5}, std::pair{300, 200}}) {
      const Image image = noise(width, height, channels);
      const auto file = decode_png(encode_image(image), "noise");
      ASSERT_TRUE(file) << file.error().message();
      EXPECT_TRUE(file->image == image);
      EXPECT_TRUE(file->text.empty());
    }
  }
}

TEST(Png, TextEntriesAreReadBackAndNoTimeIsWritten) {
  const TextEntries text{{"Title", "roberts"}, {"Comment", "two\nlines"}, {"Empty", ""}};
  const base::Bytes bytes = encode_image(noise(4, 4, 1), text);
  const auto file = decode_png(bytes, "noise");
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(file->text, text);
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()).find("tIME"), std::string::npos);
  EXPECT_EQ(bytes, encode_image(noise(4, 4, 1), text));
}

TEST(Png, RejectsImagesThatCannotBeWritten) {
  EXPECT_FALSE(encode_png(Image()));
  EXPECT_FALSE(encode_png(Image(2, 2, 2)));
  EXPECT_FALSE(encode_png(Image(png_size_limit + 1, 1, 1)));
  Image short_of_pixels(4, 4, 1);
  short_of_pixels.pixels.pop_back();
  EXPECT_FALSE(encode_png(short_of_pixels));
  EXPECT_FALSE(encode_png(Image(1, 1, 1), {{"", "text"}}));
  EXPECT_FALSE(encode_png(Image(1, 1, 1), {{std::string(80, 'k'), "text"}}));
}

TEST(Png, EveryTruncationIsAnError) {
  const base::Bytes bytes = encode_image(noise(9, 7, 3), {{"Title", "x"}});
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_NE(refusal(base::Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length))),
              "accepted")
        << length;
  }
}

TEST(Png, EveryDamagedBitIsAnError) {
  // Every bit of a PNG file is covered by a checksum, by the signature or by the structure of the chunks, except the checksums of
  // chunks
  // that libpng does not read: the text entry's, which is why this file has none.
  const base::Bytes bytes = encode_image(noise(9, 7, 1));
  for (std::size_t i = 0; i < bytes.size() * 8; ++i) {
    base::Bytes damaged = bytes;
    damaged[i / 8] = static_cast<std::uint8_t>(damaged[i / 8] ^ (1U << (i % 8)));
    const auto file = decode_png(damaged, "x.png");
    if (file) {
      EXPECT_TRUE(file->image == noise(9, 7, 1)) << "byte " << i / 8 << " bit " << i % 8;
      EXPECT_GE(i / 8, bytes.size() - 12) << "only the end chunk may stay unread";
    }
  }
}

TEST(Png, ReportsErrors) {
  EXPECT_EQ(refusal({}), "x.png: byte 0: no PNG signature, expected a PNG file");
  base::Bytes bytes = encode_image(noise(2, 2, 1));
  bytes.push_back(0);
  EXPECT_NE(refusal(bytes).find("1 bytes after the last chunk"), std::string::npos);
  bytes = encode_image(noise(2, 2, 1));
  bytes[24] = 16;
  EXPECT_NE(refusal(bytes).find("byte 24: 16 bits of colour type 0"), std::string::npos) << refusal(bytes);
  bytes = encode_image(noise(2, 2, 1));
  bytes[16] = 0x7f;
  EXPECT_NE(refusal(bytes).find("expected 1 to 8192 each way"), std::string::npos) << refusal(bytes);
  const auto missing = read_png("/nonexistent/picture.png");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message().find("/nonexistent/picture.png"), std::string::npos);
  EXPECT_NE(missing.error().message().find("No such file"), std::string::npos);
}

TEST_F(FileTest, PngOnDisk) {
  const Image image = noise(20, 10, 3);
  ASSERT_TRUE(write_png(path("a.png"), image, {{"Title", "a"}}));
  const auto back = read_png(path("a.png"));
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_TRUE(back->image == image);
  const auto bad = write_png(path("b.png"), Image());
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().file, path("b.png"));
  EXPECT_FALSE(std::filesystem::exists(path("b.png")));
}

}  // namespace
}  // namespace sightline::picture
