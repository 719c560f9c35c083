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

}  // namespace
}  // namespace sightline::base
