#include "host/base/radix_sort.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace sightline::base {
namespace {

struct Entry {
  std::uint64_t key = 0;
  std::size_t place = 0;

  friend bool operator==(const Entry&, const Entry&) = default;
};

TEST(RadixSort, SortsAsAStableSortByTheBitsGivenWithEachNumberOfThreads) {
  std::mt19937_64 random(7);
  for (const std::size_t count : {0U, 1U, 2U, 5U, 1000U, 20'000U}) {
    for (const auto& [low, high] : {std::pair{0U, 32U}, {32U, 59U}, {56U, 64U}, {0U, 64U}, {5U, 6U}}) {
      std::vector<Entry> entries;
      // Few different keys, so that the order of equal ones counts.
      for (std::size_t i = 0; i < count; ++i) entries.push_back({(random() % 300) * 0x0123456789abcdefU, i});
      std::vector<Entry> expected = entries;
      const auto bits_of = [first = low, count_of = high - low](const Entry& entry) {
        return count_of == 64 ? entry.key : (entry.key >> first) % (std::uint64_t{1} << count_of);
      };
      std::stable_sort(expected.begin(), expected.end(), [&](const Entry& a, const Entry& b) { return bits_of(a) < bits_of(b); });
      for (const unsigned jobs : {1U, 2U, 3U, 7U}) {
        std::vector<Entry> sorted = entries;
        radix_sort(sorted, low, high, [](const Entry& entry) { return entry.key; }, jobs);
        EXPECT_EQ(sorted, expected) << count << " entries, bits " << low << " to " << high << ", " << jobs << " threads";
      }
    }
  }
}

}  // namespace
}  // namespace sightline::base
