// The octal core image: its format, and every error in it.
#include "tools/image/octal.hpp"

#include <gtest/gtest.h>

namespace sightline::image {
namespace {

using core::Word18;

TEST(OctalImage, WordsFollowOneAnotherAndAddressesAreSet) {
  const auto read = read_octal("000001 777777\r\n 17776:\n\t123456 00005:000007 000010", "a");
  ASSERT_TRUE(read);
  const CoreImage expected{
      {{0, Word18(1)}, {1, Word18(0777777)}, {017776, Word18(0123456)}, {5, Word18(7)}, {6, Word18(010)}},
      {}};
  EXPECT_EQ(read.value(), expected);
}

TEST(OctalImage, BeginsAtTheGivenAddress) {
  const auto read = read_octal("000001", "a", 0200);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read.value().words.contains(0200));
}

TEST(OctalImage, LaterWordsReplace) {
  const auto read = read_octal("000001 0: 000002", "a");
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value().words.at(0), Word18(2));
}

TEST(OctalImage, IsWrittenEightToALine) {
  CoreImage image;
  for (std::uint32_t i = 0; i < 9; ++i) image.words[010 + i] = Word18(i);
  image.words[017777] = Word18(0777777);
  EXPECT_EQ(write_octal(image),
            "00010: 000000 000001 000002 000003 000004 000005 000006 000007\n00020: 000010\n17777: 777777\n");
  EXPECT_EQ(write_octal(CoreImage{}), "");
}

struct Damage {
  const char* text;
  const char* message;
};

TEST(OctalImage, ErrorsHaveLineAndColumn) {
  const std::vector<Damage> damages{
      {"000001\n 12345", "f:2:2: error: found '12345', expected a word of six octal digits"},
      {"1234567", "f:1:1: error: found '1234567', expected a word of six octal digits"},
      {"000008", "f:1:1: error: found '000008', expected a word of six octal digits"},
      {"lac 5", "f:1:1: error: found 'lac', expected a word of six octal digits"},
      {"-00001", "f:1:1: error: found '-00001', expected a word of six octal digits"},
      {"000001 :", "f:1:8: error: found ':', expected an address of one to five octal digits and ':'"},
      {"100000:", "f:1:1: error: found '100000:', expected an address of one to five octal digits and ':'"},
      {"18:", "f:1:1: error: found '18:', expected an address of one to five octal digits and ':'"},
      {"77777: 000001 000002",
       "f:1:15: error: found a word after address 77777, expected the end of the image"},
      {"\x01\x80xxxxxxxxxxxxxxxxxxxxxxxx",
       "f:1:1: error: found '??xxxxxxxxxxxxxxxxxx...', expected a word of six octal digits"}};
  for (const Damage& damage : damages) {
    const auto read = read_octal(damage.text, "f");
    ASSERT_FALSE(read) << damage.text;
    EXPECT_EQ(read.error().message(base::MessageStyle::compiler), damage.message);
  }
}

}  // namespace
}  // namespace sightline::image
