#include "host/base/short_list.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sightline::base {
namespace {

std::vector<int> items(const ShortList<int, 3>& list) {
  return {list.begin(), list.end()};
}

TEST(ShortList, EqualsAVectorBelowAndAboveItsInlineCapacity) {
  ShortList<int, 3> list;
  std::vector<int> expected;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(items(list), expected);
    EXPECT_EQ(list.size(), expected.size());
    EXPECT_EQ(list.empty(), expected.empty());
    list.push_back(7 * i);
    expected.push_back(7 * i);
    EXPECT_EQ(list[list.size() - 1], 7 * i);
  }
}

TEST(ShortList, ACopyIsAList) {
  for (const int count : {2, 3, 4, 9}) {
    ShortList<int, 3> list;
    for (int i = 0; i < count; ++i) list.push_back(i);
    ShortList<int, 3> copy = list;
    copy[0] = 100;
    copy.push_back(200);
    EXPECT_EQ(list[0], 0);
    EXPECT_EQ(list.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(copy[0], 100);
    EXPECT_EQ(copy[1], 1);
    EXPECT_EQ(copy[static_cast<std::size_t>(count)], 200);
  }
}

TEST(ShortList, IsEmptyAfterClear) {
  ShortList<int, 3> list;
  for (int i = 0; i < 9; ++i) list.push_back(i);
  list.clear();
  EXPECT_TRUE(list.empty());
  for (int i = 0; i < 5; ++i) list.push_back(-i);
  EXPECT_EQ(items(list), (std::vector<int>{0, -1, -2, -3, -4}));
}

}  // namespace
}  // namespace sightline::base
