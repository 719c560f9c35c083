// The whole generated set compared with `exact`, from more cameras than an unoptimised build can draw in reasonable time.
#include <gtest/gtest.h>

#include "tests/host/algorithms/montani_re/agreement.hpp"

namespace sightline::algorithms::montani_re {
namespace {

TEST(MontaniReAgreementWhole, GeneratedSet) {
  for (const auto& [family, agreement] : compare_generated_set(1, 10)) {
    EXPECT_EQ(agreement.first_wrong, "") << family;
    EXPECT_EQ(agreement.equal + agreement.same_image, agreement.views) << family;
  }
}

}  // namespace
}  // namespace sightline::algorithms::montani_re
