// Core memory of 4096 to 32768 words. An address outside it reads 0 and ignores writes.
//
// The host allocates all 32768 words and keeps those outside at zero, so that a read needs no test.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../core/state_visitor.hpp"
#include "../core/word.hpp"
#include "state.hpp"

namespace sightline::pdp7 {

class CoreMemory {
 public:
  // `words` is 4096, 8192, 16384 or 32768; anything larger is taken as 32768.
  explicit CoreMemory(std::uint32_t words)
      : words_(words < most_words ? words : most_words), contents_(most_words) {}

  [[nodiscard]] std::uint32_t size() const { return words_; }
  [[nodiscard]] core::Word18 read(Address a) const { return contents_[a & address_mask]; }
  void write(Address a, core::Word18 word) {
    if ((a & address_mask) < words_) contents_[a & address_mask] = word;
  }

  // The 32768 words; only the first size() may be written.
  [[nodiscard]] core::Word18* data() { return contents_.data(); }
  [[nodiscard]] const core::Word18* data() const { return contents_.data(); }

  // Core contents at power-on: arbitrary, here the words of a seeded sequence (SplitMix64).
  void randomise(std::uint64_t seed) {
    for (std::uint32_t a = 0; a < words_; ++a) {
      seed += 0x9e3779b97f4a7c15U;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
      contents_[a] = core::Word18(static_cast<std::uint32_t>((z ^ (z >> 31)) >> 40));
    }
  }

  void visit_state(core::StateVisitor& visit) {
    visit.words("words", std::span<core::Word18>(contents_).first(words_));
  }

 private:
  static constexpr std::uint32_t most_words = 32768;

  std::uint32_t words_;
  std::vector<core::Word18> contents_;
};

}  // namespace sightline::pdp7
