#include "host/algorithms/jones/cell_index.hpp"

#include <algorithm>
#include <cmath>

#include "host/algorithms/jones/enclosing_box.hpp"

namespace sightline::algorithms::jones {
namespace {

using geometry::Box;

}  // namespace

std::size_t CellIndex::bucket(std::size_t axis, std::int32_t coordinate) const {
  const std::int64_t length = outer_.span(axis).length() + 1;
  const std::int64_t along = std::int64_t{coordinate} - outer_.low[axis];
  return static_cast<std::size_t>(along * static_cast<std::int64_t>(buckets_[axis]) / length);
}

template <class Do>
void CellIndex::for_each_bucket(const Box& box, const Do& act) const {
  std::array<std::size_t, 3> low{};
  std::array<std::size_t, 3> high{};
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = bucket(a, box.low[a]);
    high[a] = bucket(a, box.high[a]);
  }
  std::array<std::size_t, 3> at{};
  for (at[2] = low[2]; at[2] <= high[2]; ++at[2]) {
    for (at[1] = low[1]; at[1] <= high[1]; ++at[1]) {
      for (at[0] = low[0]; at[0] <= high[0]; ++at[0]) act(number_of(at));
    }
  }
}

// Chooses about as many buckets as cells, as nearly cubic as the outer box allows; fewer if cells would be in very many
// buckets.
void CellIndex::choose_buckets(const std::vector<Box>& boxes) {
  constexpr std::size_t most_entries_a_cell = 16;
  double volume = 1;
  for (std::size_t a = 0; a < 3; ++a) volume *= static_cast<double>(outer_.span(a).length() + 1);
  double side = std::cbrt(volume / (static_cast<double>(boxes.size()) + 1));
  for (bool fits = false; !fits; side *= 2) {
    for (std::size_t a = 0; a < 3; ++a) {
      const double wanted = static_cast<double>(outer_.span(a).length()) / side;
      buckets_[a] = wanted < 1 ? 1 : static_cast<std::size_t>(wanted);
    }
    std::size_t entries = 0;
    for (const Box& box : boxes) {
      if (is_empty(box)) continue;
      std::size_t count = 1;
      for (std::size_t a = 0; a < 3; ++a) count *= bucket(a, box.high[a]) - bucket(a, box.low[a]) + 1;
      entries += count;
    }
    fits = entries <= most_entries_a_cell * boxes.size() + 1024 ||
           buckets_ == std::array<std::size_t, 3>{1, 1, 1};
  }
}

CellIndex::CellIndex(const scene::CellComplex& complex, std::span<const geometry::Plane> planes)
    : outer_(complex.outer) {
  std::vector<Box> boxes;
  boxes.reserve(complex.cells.size());
  for (const scene::ComplexCell& cell : complex.cells)
    boxes.push_back(enclosing_box(outer_, planes, complex.bounds_of(cell)));
  choose_buckets(boxes);
  starts_.assign(buckets_[0] * buckets_[1] * buckets_[2] + 1, 0);
  for (const Box& box : boxes) {
    if (!is_empty(box)) for_each_bucket(box, [&](std::size_t b) { ++starts_[b + 1]; });
  }
  for (std::size_t b = 1; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
  entries_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t c = 0; c < boxes.size(); ++c) {
    if (is_empty(boxes[c])) continue;
    for_each_bucket(boxes[c],
                    [&](std::size_t b) { entries_[next[b]++] = static_cast<scene::CellNumber>(c); });
  }
}

std::vector<scene::CellNumber> CellIndex::cells_at(const scene::CellComplex& complex,
                                                   std::span<const geometry::Plane> planes,
                                                   const geometry::Point3& point) const {
  std::vector<scene::CellNumber> cells;
  if (!outer_.contains(point)) return cells;
  const std::size_t b = number_of({bucket(0, point[0]), bucket(1, point[1]), bucket(2, point[2])});
  for (std::uint32_t i = starts_[b]; i < starts_[b + 1]; ++i) {
    const auto bounds = complex.bounds_of(complex.cells[entries_[i]]);
    const auto holds = [&](const scene::HalfSpace& half) { return contains(planes, half, point); };
    if (std::all_of(bounds.begin(), bounds.end(), holds)) cells.push_back(entries_[i]);
  }
  return cells;
}

}  // namespace sightline::algorithms::jones
