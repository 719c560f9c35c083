// Shared by the lockstep tests of both machines: how much to run, and a checksum of all bus cycles.
//
//   SIGHTLINE_LOCKSTEP=N         N instructions in each test
//   SIGHTLINE_LOCKSTEP_SEED=S    the first seed, for a long run in pieces
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace sightline::tests {

// The number of instructions: SIGHTLINE_LOCKSTEP in the environment, or `otherwise`.
inline std::uint64_t lockstep_instructions(std::uint64_t otherwise) {
  const char* const asked = std::getenv("SIGHTLINE_LOCKSTEP");  // NOLINT(concurrency-mt-unsafe)
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : otherwise;
}

// The first seed: SIGHTLINE_LOCKSTEP_SEED in the environment, or `otherwise`.
inline std::uint64_t lockstep_seed(std::uint64_t otherwise) {
  const char* const asked = std::getenv("SIGHTLINE_LOCKSTEP_SEED");  // NOLINT(concurrency-mt-unsafe)
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : otherwise;
}

// Two sequences of cycles with equal sums count as equal.
class CycleSum {
 public:
  template <class... Values>
  void add(Values... values) {
    (add_one(static_cast<std::uint64_t>(values)), ...);
    ++count;
  }
  // A cycle in two words; every bit affects the sum.
  void add_cycle(std::uint64_t time, std::uint64_t rest) {
    add_one(time * 0x9e3779b97f4a7c15U ^ rest);
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

// Counts the executed instructions that the program itself has written.
class WrittenWords {
 public:
  explicit WrittenWords(std::size_t addresses) : written_(addresses) {}
  void write(std::size_t address) { written_[address] = 1; }
  void fetch(std::size_t address) { fetched_ += written_[address]; }
  [[nodiscard]] std::uint64_t fetched() const { return fetched_; }

 private:
  std::vector<std::uint8_t> written_;
  std::uint64_t fetched_ = 0;
};

}  // namespace sightline::tests
