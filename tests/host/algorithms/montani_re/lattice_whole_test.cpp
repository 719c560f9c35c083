// The 72,000 set operations that only an optimised build does in reasonable time.
#include <gtest/gtest.h>

#include "tests/host/algorithms/montani_re/tetrakis.hpp"

namespace sightline::algorithms::montani_re {
namespace {

TEST(LatticePcsWhole, SeventyTwoThousandSetOperations) {
  EXPECT_EQ(wrong_set_operations(72, 24000), 0);
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
