// Random images through every format and back.
#include <gtest/gtest.h>

#include <random>

#include "tests/support/effort.hpp"
#include "tools/image/octal.hpp"
#include "tools/image/tape.hpp"

namespace sightline::image {
namespace {

using core::Word18;

class Images {
 public:
  explicit Images(unsigned seed) : random_(seed) {}

  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

  // Runs of words with gaps, below `limit`, with or without a start address.
  CoreImage sparse(std::uint32_t limit) {
    CoreImage image;
    for (std::uint32_t run = 1 + below(5); run > 0; --run) add_run(image, below(limit), limit);
    if (below(2) == 0) image.start = below(limit);
    return image;
  }

  CoreImage contiguous() {
    CoreImage image;
    const std::uint32_t bank = below(4) << 13;
    add_run(image, bank + below(017000), bank + 020000);
    if (below(2) == 0) image.start = bank + below(020000);
    return image;
  }

 private:
  void add_run(CoreImage& image, std::uint32_t from, std::uint32_t limit) {
    for (std::uint32_t n = 1 + below(100); n > 0 && from < limit; --n)
      image.words[from++] = Word18(below(01000000));
  }

  std::mt19937 random_;
};

TEST(RoundTrip, Octal) {
  Images images(1);
  for (int i = 0; i < 300; ++i) {
    CoreImage image = images.sparse(0100000);
    image.start.reset();  // the text has none
    const std::string text = write_octal(image);
    const auto read = read_image(Tape(text.begin(), text.end()), "t", {});
    ASSERT_TRUE(read);
    ASSERT_EQ(read.value(), image);
  }
}

TEST(RoundTrip, Rim) {
  Images images(2);
  for (int i = 0; i < 300; ++i) {
    const CoreImage image = images.sparse(017762);
    const auto tape = write_rim(image, "t");
    ASSERT_TRUE(tape);
    const auto read = read_image(tape.value(), "t", {});
    ASSERT_TRUE(read) << read.error().message(base::MessageStyle::compiler);
    ASSERT_EQ(read.value(), image);
  }
}

TEST(RoundTrip, Hri) {
  Images images(3);
  for (int i = 0; i < 300; ++i) {
    const CoreImage image = images.contiguous();
    const auto tape = write_hri(image, "t");
    ASSERT_TRUE(tape);
    const auto read = read_image(tape.value(), "t", image.words.begin()->first);
    ASSERT_TRUE(read) << read.error().message(base::MessageStyle::compiler);
    ASSERT_EQ(read.value(), image);
  }
}

// A hole 8 lost anywhere in a word is an error. (It cannot be detected at once in the first line of a word without data, which
// becomes blank feed and shifts the words after it.)
TEST(RoundTrip, ALostHole8IsDetected) {
  Images images(4);
  for (int i = 0; i < tests::effort(20, 3); ++i) {
    const Tape tape = write_rim(images.sparse(017762), "t").value();
    std::size_t first = 0;
    while (tape[first] == 0) ++first;
    std::size_t end = tape.size();
    while (tape[end - 1] == 0) --end;
    end -= 3;  // the word after the last one is not read
    for (std::size_t lost = first; lost < end; ++lost) {
      Tape damaged = tape;
      damaged[lost] &= 0177;
      const bool becomes_feed = damaged[lost] == 0 && (lost - first) % 3 == 0;
      const bool becomes_leader = lost == first;
      if (!becomes_feed && !becomes_leader) {
        ASSERT_FALSE(read_rim(damaged, "t")) << "line " << lost;
      }
    }
  }
}

}  // namespace
}  // namespace sightline::image
