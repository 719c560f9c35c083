// See complex_lines.hpp.
#include "host/scene/model/complex_lines.hpp"

#include <algorithm>

namespace sightline::scene {
namespace {

constexpr std::size_t recent_parts = 4096;

std::size_t hash(const ComplexLine& line) {
  std::uint64_t hash = 0;
  for (const std::int64_t number :
       {line.low.numerator(), line.low.denominator(), line.high.numerator(), line.high.denominator()})
    hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>(hash >> 52);
}

static_assert(recent_parts == std::size_t{1} << (64 - 52));

}  // namespace

std::uint32_t ComplexLines::part_of(const ComplexLine& line) {
  const Part part{line.low, line.high};
  if (part == parts_.front()) return 0;
  if (recent_.empty()) recent_.assign(recent_parts, 0);
  std::uint32_t& recent = recent_[hash(line)];
  if (parts_[recent] != part) {
    recent = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back(part);
  }
  return recent;
}

void ComplexLines::sort_by_edge(std::size_t first, std::size_t end) {
  const auto place = [this](std::size_t i) { return lines_.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto before = [](const Line& a, const Line& b) { return a.edge < b.edge; };
  if (!std::is_sorted(place(first), place(end), before)) std::sort(place(first), place(end), before);
}

}  // namespace sightline::scene
