#include "host/base/text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace sightline::base {
namespace {

TEST(Append, WritesAtTheEnd) {
  std::string text = "at ";
  append(text, "{:05o}: {:>4}", 8, -1);
  EXPECT_EQ(text, "at 00010:   -1");
  append(text, "{}", std::string(1000, 'x'));
  EXPECT_EQ(text, "at 00010:   -1" + std::string(1000, 'x'));
}

TEST(Joined, HasTheSeparatorBetween) {
  EXPECT_EQ(joined(std::vector<std::string>{}, ", "), "");
  EXPECT_EQ(joined(std::vector<std::string>{"one"}, ", "), "one");
  EXPECT_EQ(joined(std::vector<std::string>{"one", "", "three"}, ", "), "one, , three");
  EXPECT_EQ(joined(std::array<int, 2>{-4, 7}, " to "), "-4 to 7");
}

TEST(ByteOrderMark, OfUtf8IsRemovedOnce) {
  EXPECT_EQ(without_byte_order_mark("\xef\xbb\xbfOFF"), "OFF");
  EXPECT_EQ(without_byte_order_mark("\xef\xbb\xbf"), "");
  EXPECT_EQ(without_byte_order_mark("\xef\xbb\xbf\xef\xbb\xbfv"), "\xef\xbb\xbfv");
  EXPECT_EQ(without_byte_order_mark("\xef\xbbv"), "\xef\xbbv");
  EXPECT_EQ(without_byte_order_mark(""), "");
}

TEST(ByteOrderMark, OfUtf16IsRecognised) {
  EXPECT_TRUE(begins_as_utf_16(std::string_view("\xff\xfeO\0", 4)));
  EXPECT_TRUE(begins_as_utf_16(std::string_view("\xfe\xff\0O", 4)));
  EXPECT_TRUE(begins_as_utf_16(std::string_view("\0\0\xfe\xff\0\0\0O", 8)));
  EXPECT_FALSE(begins_as_utf_16("\xef\xbb\xbfOFF"));
  EXPECT_FALSE(begins_as_utf_16("\xff"));
  EXPECT_FALSE(begins_as_utf_16(""));
}

TEST(ShellWord, IsQuotedWhereAShellWouldDivideIt) {
  EXPECT_EQ(shell_word("house"), "house");
  EXPECT_EQ(shell_word("rooms/a-1.json"), "rooms/a-1.json");
  EXPECT_EQ(shell_word("a b/rooms.json"), "'a b/rooms.json'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("$HOME"), "'$HOME'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace sightline::base
