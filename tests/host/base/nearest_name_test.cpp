#include "host/base/nearest_name.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sightline::base {
namespace {

const std::vector<std::string> commands{"demo", "report", "jones", "skala", "draw", "compare", "spin", "disasm"};

// Computed by hand; "ca" to "abc" is 3 because no place is changed twice.
TEST(EditDistance, OfKnownPairs) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("jnoes", "jones"), 1U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);
}

// All texts of up to three letters from an alphabet of two: the laws of a distance that hold with swaps, too.
TEST(EditDistance, IsSymmetricAndZeroForEqualTextsOnly) {
  std::vector<std::string> texts{""};
  for (std::size_t n = 0; n < texts.size() && texts[n].size() < 3; ++n)
    for (const char c : {'a', 'b'}) texts.push_back(texts[n] + c);
  ASSERT_EQ(texts.size(), 15U);
  for (const std::string& a : texts) {
    for (const std::string& b : texts) {
      EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
      EXPECT_EQ(edit_distance(a, b) == 0, a == b) << a << " " << b;
      EXPECT_LE(edit_distance(a, b), std::max(a.size(), b.size()));
    }
  }
}

TEST(NearestName, IsNearOrAbsent) {
  EXPECT_EQ(nearest_name("jons", commands), "jones");
  EXPECT_EQ(nearest_name("comapre", commands), "compare");
  EXPECT_EQ(nearest_name("dis", commands), "disasm");
  EXPECT_EQ(nearest_name("jones", commands), "jones");
  EXPECT_EQ(nearest_name("frobnicate", commands), "");
  EXPECT_EQ(nearest_name("x", commands), "");
  EXPECT_EQ(nearest_name("", commands), "");
  EXPECT_EQ(nearest_name("jones", {}), "");
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'a'), commands), "");
}

TEST(NearestName, DidYouMean) {
  EXPECT_EQ(did_you_mean("skalla", commands), "did you mean \"skala\"?");
  EXPECT_EQ(did_you_mean("frobnicate", commands), "");
}

}  // namespace
}  // namespace sightline::base
