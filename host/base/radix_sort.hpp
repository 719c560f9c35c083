// Sorts many entries by some bits of a number of each, in linear time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/base/threads.hpp"

namespace sightline::base {

// Sorts by the bits `low` to `high` - 1 of key_of(entry), an unsigned number; entries that agree in these keep their order. Each of
// `jobs` threads counts and moves the entries of one part.
template <class Entry, class KeyOf>
void radix_sort(std::vector<Entry>& entries, unsigned low, unsigned high, KeyOf key_of, unsigned jobs = 1) {
  constexpr unsigned digit_bits = 11;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  std::vector<Entry> sorted(entries.size());
  for (unsigned shift = low; shift < high; shift += digit_bits) {
    const std::size_t mask = (std::size_t{1} << std::min(digit_bits, high - shift)) - 1;
    const auto digit_of = [&](const Entry& entry) { return static_cast<std::size_t>(key_of(entry) >> shift) & mask; };
    std::vector<std::array<std::size_t, digits>> places(jobs);  // of the next entry with each digit in each part
    for_parts(jobs, entries.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++places[part][digit_of(entries[i])];
    });
    std::size_t place = 0;
    for (std::size_t digit = 0; digit < digits; ++digit)
      for (auto& of_part : places) place += std::exchange(of_part[digit], place);
    for_parts(jobs, entries.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      auto& next = places[part];
      for (std::size_t i = begin; i < end; ++i) sorted[next[digit_of(entries[i])]++] = entries[i];
    });
    entries.swap(sorted);
  }
}

}  // namespace sightline::base
