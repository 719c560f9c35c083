// How many rounds a test runs: all of them where code is optimised, a part where unoptimised code and sanitizers make it
// ten to fifty times slower. Both check the same properties.
#pragma once

namespace sightline::tests {

// Whether this is a release build: optimised, without assertions and sanitizers.
[[nodiscard]] inline bool is_optimised() {
#ifdef NDEBUG
  return true;
#else
  return false;
#endif
}

template <class Value>
[[nodiscard]] Value effort(Value whole, Value part) {
  return is_optimised() ? whole : part;
}

}  // namespace sightline::tests

// The first statement of a test that runs whole machines or programs for a long time. Shorter tests run all parts of
// these, so that a run with sanitizers would take minutes and find nothing more.
#define NEEDS_OPTIMISED_CODE()        \
  if (!sightline::tests::is_optimised()) \
  GTEST_SKIP() << "runs only where code is optimised"
