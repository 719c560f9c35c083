// All algorithms that can against each other on surfaces of functions, as triangles.
#include "tests/host/compare/cross_check_suite.hpp"

namespace sightline::compare {
namespace {

TEST_P(AgreementOn, Heights) {
  expect_agreement(std::get<0>(GetParam()), std::get<1>(GetParam()));
}
INSTANTIATE_TEST_SUITE_P(Agreement, AgreementOn,
                         testing::Combine(testing::Range(polyhedra_count(), common_scene_names().size()),
                                          testing::Range(std::size_t{0}, pair_count())),
                         agreement_name);

}  // namespace
}  // namespace sightline::compare
