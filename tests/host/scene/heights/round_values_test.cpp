// Round values of scales.
#include "host/scene/heights/round_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace sightline::scene {
namespace {

std::string texts(Interval interval, int most) {
  std::string all;
  for (const RoundValue& value : round_values(interval, most)) all += value.text + " ";
  return all;
}

TEST(RoundValues, AreWrittenShort) {
  EXPECT_EQ(texts({-3, 3}, 7), "-3 -2 -1 0 1 2 3 ");
  EXPECT_EQ(texts({-3, 3}, 6), "-2 0 2 ");
  EXPECT_EQ(texts({0, 1}, 6), "0 0.2 0.4 0.6 0.8 1 ");
  EXPECT_EQ(texts({-0.3, 0.3}, 8), "-0.3 -0.2 -0.1 0 0.1 0.2 0.3 ");
  EXPECT_EQ(texts({0, 2500000}, 6), "0 500000 1000000 1500000 2000000 2500000 ");
  EXPECT_EQ(texts({1e9, 1.02e9}, 5), "1e+09 1.005e+09 1.01e+09 1.015e+09 1.02e+09 ");
  EXPECT_EQ(texts({1.1, 1.4}, 2), "1.2 1.4 ");
}

TEST(RoundValues, OfAnEmptyInterval) {
  EXPECT_TRUE(round_values({2, 2}, 5).empty());
  EXPECT_TRUE(round_values({2, 1}, 5).empty());
  EXPECT_TRUE(round_values({0, std::nan("")}, 5).empty());
  EXPECT_TRUE(round_values({0, INFINITY}, 5).empty());
  EXPECT_TRUE(round_values({0, 1}, 0).empty());
  EXPECT_TRUE(round_values({-1e300, 1e300}, 5).empty());
}

// Within the interval, in equal steps of 1, 2 or 5, at most as many as requested, and no smaller step would fit.
TEST(RoundValues, AreAsManyAsFit) {
  std::mt19937 dice(3);
  const auto any = [&] { return (static_cast<double>(dice() % 200001) - 100000) / 100000 * std::pow(10.0, static_cast<int>(dice() % 13) - 6); };
  for (int n = 0; n < 3000; ++n) {
    double low = any();
    double high = any();
    if (high < low) std::swap(low, high);
    if (!(high - low > 1e-6 * std::abs(low))) continue;
    const int most = 2 + static_cast<int>(dice() % 12);
    const auto values = round_values({low, high}, most);
    ASSERT_LE(values.size(), static_cast<std::size_t>(most));
    ASSERT_GE(values.size() * 5 + 4, static_cast<std::size_t>(most) / 2) << low << " " << high;
    for (const RoundValue& value : values) {
      EXPECT_GE(value.value, low - 1e-8 * (high - low));
      EXPECT_LE(value.value, high + 1e-8 * (high - low));
      EXPECT_EQ(std::stod(value.text), value.value) << value.text;
    }
    for (std::size_t i = 2; i < values.size(); ++i)
      EXPECT_NEAR(values[i].value - values[i - 1].value, values[1].value - values[0].value, 1e-9 * (high - low) + 1e-12 * std::abs(high));
  }
}

TEST(MultiplesWithin, AreInside) {
  EXPECT_EQ(multiples_within({-5, 5}, 2.5, 9), (std::vector<double>{-2.5, 0, 2.5}));
  EXPECT_TRUE(multiples_within({-5, 5}, 0.01, 255).empty());
  EXPECT_TRUE(multiples_within({1, 2}, 10, 255).empty());
}

}  // namespace
}  // namespace sightline::scene
