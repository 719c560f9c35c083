// What the lockstep tests of both machines share: how much to run, and a sum of all bus cycles.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace sightline::tests {

// Instructions: SIGHTLINE_LOCKSTEP in the environment, or `otherwise`.
inline std::uint64_t lockstep_instructions(std::uint64_t otherwise) {
  const char* const asked = std::getenv("SIGHTLINE_LOCKSTEP");  // NOLINT(concurrency-mt-unsafe)
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : otherwise;
}

// Two sequences of cycles with the same sum are taken to be the same.
class CycleSum {
 public:
  template <class... Values>
  void add(Values... values) {
    (add_one(static_cast<std::uint64_t>(values)), ...);
    ++count;
  }
  std::uint64_t sum = 0x9e3779b97f4a7c15U;
  std::uint64_t count = 0;
  friend bool operator==(const CycleSum&, const CycleSum&) = default;

 private:
  void add_one(std::uint64_t value) {
    sum = (sum ^ value) * 0xff51afd7ed558ccdU;
    sum ^= sum >> 29;
  }
};

}  // namespace sightline::tests
