// Interval sets compared with a set of single points.
#include "host/geometry/interval_set.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace sightline::geometry {
namespace {

TEST(IntervalSet, KeepsEndsOfRemovedIntervalsAndDropsSinglePoints) {
  IntervalSet set(0, 1);
  set.subtract(Rational(1, 4), Rational(1, 2));
  EXPECT_TRUE(set.contains(Rational(1, 4)));
  EXPECT_TRUE(set.contains(Rational(1, 2)));
  EXPECT_FALSE(set.contains(Rational(1, 3)));
  set.subtract(Rational(1, 2), Rational(3, 4));
  IntervalSet expected(0, Rational(1, 4));
  expected.unite(Rational(3, 4), 1);
  EXPECT_EQ(set, expected);
}

TEST(IntervalSet, EmptyOperandsChangeNothing) {
  IntervalSet set(0, 1);
  set.subtract(Rational(1, 2), Rational(1, 2));
  set.subtract(Rational(3, 4), Rational(1, 4));
  set.unite(2, 2);
  EXPECT_EQ(set, IntervalSet(0, 1));
  EXPECT_TRUE(IntervalSet(1, 1).empty());
  set.intersect(1, 0);
  EXPECT_TRUE(set.empty());
}

// Unit steps of [0, 32] as bits: the same operations on both must cover the same steps.
TEST(IntervalSet, AgreesWithUnitStepsUnderRandomOperations) {
  constexpr int steps = 32;
  std::mt19937 random(7);
  for (int round = 0; round < 500; ++round) {
    IntervalSet set(0, steps);
    std::array<bool, steps> covered;
    covered.fill(true);
    for (int operation = 0; operation < 12; ++operation) {
      const int low = static_cast<int>(random() % (steps + 1));
      const int high = static_cast<int>(random() % (steps + 1));
      const unsigned kind = random() % 8;
      if (kind < 4)
        set.subtract(low, high);
      else if (kind < 7)
        set.unite(low, high);
      else
        set.intersect(low, high);
      for (int s = 0; s < steps; ++s) {
        const bool inside = low <= s && s < high;
        bool& bit = covered[static_cast<std::size_t>(s)];
        bit = kind < 4 ? bit && !inside : kind < 7 ? bit || inside : bit && inside;
      }
      for (int s = 0; s < steps; ++s) {
        ASSERT_EQ(set.contains(Rational(2 * s + 1, 2)), covered[static_cast<std::size_t>(s)]);
      }
      for (std::size_t i = 0; i < set.intervals().size(); ++i) {
        ASSERT_LT(set.intervals()[i].low, set.intervals()[i].high);
        if (i > 0) {
          ASSERT_LT(set.intervals()[i - 1].high, set.intervals()[i].low);
        }
      }
    }
  }
}

class RandomSets {
 public:
  Rational end() {
    return {static_cast<std::int64_t>(random_() % 41) - 20, static_cast<std::int64_t>(random_() % 6) + 1};
  }
  IntervalSet set() {
    IntervalSet result;
    for (std::size_t i = random_() % 5; i-- > 0;) result.unite(end(), end());
    return result;
  }

 private:
  std::mt19937 random_{1985};
};

TEST(IntervalSet, SatisfiesTheLawsOfTheHeader) {
  RandomSets sets;
  const Rational least(-100);
  const Rational most(100);
  for (int i = 0; i < 2000; ++i) {
    const IntervalSet start = sets.set();
    const Rational a = sets.end(), b = sets.end(), c = sets.end(), d = sets.end();
    const auto after = [&start](auto... operations) {
      IntervalSet set = start;
      (operations(set), ...);
      return set;
    };
    const auto subtract = [](const Rational& low, const Rational& high) {
      return [low, high](IntervalSet& set) { set.subtract(low, high); };
    };
    const auto unite = [](const Rational& low, const Rational& high) {
      return [low, high](IntervalSet& set) { set.unite(low, high); };
    };
    const auto intersect = [](const Rational& low, const Rational& high) {
      return [low, high](IntervalSet& set) { set.intersect(low, high); };
    };
    EXPECT_EQ(after(subtract(a, b), subtract(a, b)), after(subtract(a, b)));
    EXPECT_EQ(after(unite(a, b), unite(a, b)), after(unite(a, b)));
    EXPECT_EQ(after(intersect(a, b), intersect(a, b)), after(intersect(a, b)));
    EXPECT_EQ(after(subtract(a, b), subtract(c, d)), after(subtract(c, d), subtract(a, b)));
    EXPECT_EQ(after(unite(a, b), unite(c, d)), after(unite(c, d), unite(a, b)));
    EXPECT_EQ(after(intersect(a, b), intersect(c, d)), after(intersect(c, d), intersect(a, b)));
    if (a < b) {
      EXPECT_EQ(after(intersect(a, b)), after(subtract(least, a), subtract(b, most)));
      EXPECT_EQ(after(unite(a, b), intersect(a, b)), IntervalSet(a, b));
    }
    EXPECT_EQ(after(unite(a, b), subtract(a, b)), after(subtract(a, b)));
  }
}

}  // namespace
}  // namespace sightline::geometry
