#include "host/base/parallel.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace sightline::base {
namespace {

TEST(InOrder, EveryResultOnceAndInOrder) {
  for (const unsigned jobs : {1U, 2U, 7U}) {
    std::vector<std::uint64_t> taken;
    OrderedWork<std::uint64_t> work;
    work.first = 5;
    work.last = 1005;
    work.jobs = jobs;
    work.make = [](std::uint64_t n) { return n * n; };
    work.take = [&](std::uint64_t n, std::uint64_t result) {
      EXPECT_EQ(result, n * n);
      taken.push_back(n);
    };
    work.go_on = [] { return true; };
    run_in_order(work);
    ASSERT_EQ(taken.size(), 1000U);
    for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_EQ(taken[i], 5 + i);
  }
}

TEST(InOrder, StopsOnRequestAndPropagatesExceptions) {
  std::uint64_t count = 0;
  OrderedWork<int> work;
  work.last = std::uint64_t{1} << 40;
  work.jobs = 2;
  work.make = [](std::uint64_t) { return 1; };
  work.take = [&](std::uint64_t, int) { ++count; };
  work.go_on = [&] { return count < 50; };
  run_in_order(work);
  EXPECT_EQ(count, 50U);
  work.go_on = [] { return true; };
  work.make = [](std::uint64_t n) -> int { return n < 70 ? 1 : throw std::runtime_error("made"); };
  EXPECT_THROW(run_in_order(work), std::runtime_error);
  work.make = [](std::uint64_t) { return 1; };
  work.take = [](std::uint64_t n, int) { n < 7 ? void() : throw std::runtime_error("taken"); };
  EXPECT_THROW(run_in_order(work), std::runtime_error);
}

}  // namespace
}  // namespace sightline::base
