// Animated PNG: the chunks follow the specification, and each frame, put into a separate PNG, equals the input picture. The PNG
// reader
// checks CRCs by its own code.
#include "host/picture/apng.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/base/file.hpp"

namespace sightline::picture {
namespace {

struct Chunk {
  std::string type;
  base::Bytes data;
};

std::uint32_t number(const base::Bytes& bytes, std::size_t at, std::size_t size = 4) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes.at(at + i);
  return value;
}

std::vector<Chunk> chunks_of(const base::Bytes& bytes) {
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t length = number(bytes, at);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    chunks.push_back({std::string(begin + 4, begin + 8),
                      base::Bytes(begin + 8, begin + 8 + static_cast<std::ptrdiff_t>(length))});
    at += length + 12;
  }
  return chunks;
}

Image picture(int width, int height, int seed) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>((i * 7 + static_cast<std::size_t>(seed) * 31) % 251);
  return image;
}

base::Bytes animation(int frames, FrameTime time = {}, std::uint32_t plays = 0) {
  ApngWriter writer(time, plays, {{"Title", "test"}});
  for (int i = 0; i < frames; ++i) EXPECT_TRUE(writer.add(picture(20, 10, i)));
  const auto bytes = writer.finish();
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : base::Bytes();
}

TEST(Apng, ChunksInOrder) {
  const auto chunks = chunks_of(animation(3, {2, 50}, 5));
  std::string order;
  for (const Chunk& chunk : chunks) order += chunk.type + " ";
  EXPECT_EQ(order, "IHDR tEXt acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
  EXPECT_EQ(chunks[2].data, (base::Bytes{0, 0, 0, 3, 0, 0, 0, 5}));
  EXPECT_EQ(chunks[3].data,
            (base::Bytes{0, 0, 0, 0, 0, 0, 0, 20, 0, 0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 50, 0, 0}));
  // fcTL and fdAT are numbered together.
  for (std::size_t i = 5; i < 9; ++i) EXPECT_EQ(number(chunks[i].data, 0), i - 4);
}

// The reader takes the first frame from the file unchanged; it skips unknown chunks, but checks the codes of all that it reads.
TEST(Apng, FirstFrameIsThePicture) {
  const auto file = decode_png(animation(2), "animation");
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(file->image, picture(20, 10, 0));
}

TEST(Apng, EveryFrameIsComplete) {
  const base::Bytes bytes = animation(4);
  int frame = 0;
  for (const Chunk& chunk : chunks_of(bytes)) {
    if (chunk.type != "fdAT") continue;
    ++frame;
    // The same frame as a still picture has this IDAT.
    const auto still = encode_png(picture(20, 10, frame));
    ASSERT_TRUE(still);
    for (const Chunk& part : chunks_of(*still))
      EXPECT_TRUE(part.type != "IDAT" || part.data == base::Bytes(chunk.data.begin() + 4, chunk.data.end()))
          << frame;
  }
  EXPECT_EQ(frame, 3);
}

// Computes the code bit by bit from its definition; each chunk's code must be that over its type and data.
TEST(Apng, CodesOfAllChunks) {
  const base::Bytes bytes = animation(2);
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t length = number(bytes, at);
    std::uint32_t code = 0xFFFFFFFFU;
    for (std::size_t i = at + 4; i < at + 8 + length; ++i) {
      code ^= bytes[i];
      for (int bit = 0; bit < 8; ++bit) code = (code >> 1) ^ ((code & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    EXPECT_EQ(~code, number(bytes, at + 8 + length)) << at;
    at += length + 12;
  }
  // The IEND code, which is the same in every PNG.
  EXPECT_EQ(number(bytes, bytes.size() - 4), 0xAE426082U);
}

TEST(Apng, RejectsUnsuitablePictures) {
  ApngWriter writer;
  EXPECT_FALSE(writer.finish());
  EXPECT_FALSE(writer.add(Image()));
  ASSERT_TRUE(writer.add(picture(20, 10, 0)));
  const auto wrong = writer.add(picture(20, 11, 0));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message(), "APNG: frame 1: 20 by 11, expected 20 by 10 as the first one");
  EXPECT_EQ(writer.frames(), 1U);
}

}  // namespace
}  // namespace sightline::picture
