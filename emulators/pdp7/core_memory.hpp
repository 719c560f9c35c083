// Core memory of 4096 to 32768 words. An address outside it reads 0 and ignores writes.
//
// All 32768 words are allocated in the host, those outside held at zero, so that a read needs no test.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../core/word.hpp"
#include "state.hpp"

namespace sightline::pdp7 {

// Marks above the 18 bits of a word. A run that is watched for places sets them when it begins and takes them off when it ends;
// its bus, its data breaks and what it shows its observer come across them, and nobody else. A fetch pays nothing for them, because they lie beside the bits
// that choose the code of an instruction; nor do most that read into AC, because they lie above L, where an Accumulator may have
// anything.
namespace core_mark {
inline constexpr unsigned first_bit = 19, bits = 3;
inline constexpr std::uint32_t asked = 1U << first_bit;  // the boundary before the instruction here
inline constexpr std::uint32_t read = asked << 1;        // an access that reads, but for the fetch of an instruction
inline constexpr std::uint32_t written = asked << 2;
inline constexpr std::uint32_t any = asked | read | written;
}  // namespace core_mark

class CoreMemory {
 public:
  // `words` is 4096, 8192, 16384 or 32768; anything larger is taken as 32768.
  explicit CoreMemory(std::uint32_t words)
      : words_(words < most_words ? words : most_words), contents_(most_words) {}

  [[nodiscard]] std::uint32_t size() const { return words_; }
  [[nodiscard]] core::Word18 read(Address a) const { return contents_[a & address_mask].without_marks(); }
  void write(Address a, core::Word18 word) {
    if ((a & address_mask) < words_) contents_[a & address_mask] = word;
  }

  // In a run that sets marks: they stay.
  void write_under_marks(Address a, core::Word18 word) {
    if ((a & address_mask) < words_) put_under_marks(contents_[a & address_mask], word);
  }
  static void put_under_marks(core::Word18& cell, core::Word18 word) {
    cell = core::Word18::with_marks((cell.value() & core_mark::any) | word.value());
  }
  // Sets marks, or takes all off, at any of the 32768 addresses.
  void mark(Address a, std::uint32_t marks) {
    core::Word18& cell = contents_[a & address_mask];
    cell = core::Word18::with_marks(cell.value() | marks);
  }
  void unmark(Address a) { contents_[a & address_mask] = read(a); }
  // The same from the end of this core on, up to `end`.
  void mark_outside(Address end) {
    for (Address a = words_; a < end; ++a) mark(a, core_mark::written);
  }
  void unmark_outside(Address end) {
    for (Address a = words_; a < end; ++a) unmark(a);
  }

  // The 32768 words; only the first size() may be written.
  [[nodiscard]] core::Word18* data() { return contents_.data(); }
  [[nodiscard]] const core::Word18* data() const { return contents_.data(); }

  // Core as it is found at power-on: arbitrary, here the words of a seeded sequence (SplitMix64).
  void randomise(std::uint64_t seed) {
    for (std::uint32_t a = 0; a < words_; ++a) {
      seed += 0x9e3779b97f4a7c15U;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
      contents_[a] = core::Word18(static_cast<std::uint32_t>((z ^ (z >> 31)) >> 40));
    }
  }

  template <class Visitor>
  void visit_state(Visitor& visit) {
    visit.words("words", std::span<core::Word18>(contents_).first(words_));
  }

 private:
  static constexpr std::uint32_t most_words = 32768;

  std::uint32_t words_;
  std::vector<core::Word18> contents_;
};

}  // namespace sightline::pdp7
