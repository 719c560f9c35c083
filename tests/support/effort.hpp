// How much of a long loop a test runs: all of it where code is optimised, a part where checks in every
// instruction make it ten to fifty times slower. What a case is tested for is the same in both.
#pragma once

namespace sightline::tests {

// Whether this is a release build: optimised, without assertions and sanitizers.
[[nodiscard]] inline bool optimised() {
#ifdef NDEBUG
  return true;
#else
  return false;
#endif
}

template <class Value>
[[nodiscard]] Value effort(Value whole, Value part) {
  return optimised() ? whole : part;
}

}  // namespace sightline::tests

// The first line of a test that runs whole machines or programs for long, of which shorter tests run every part:
// under checks it would take minutes and find nothing more.
#define NEEDS_OPTIMISED_CODE()        \
  if (!sightline::tests::optimised()) \
  GTEST_SKIP() << "runs only where code is optimised"
