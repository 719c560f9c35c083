#include "host/algorithms/exact/image_grid.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/radix_sort.hpp"
#include "host/base/threads.hpp"

namespace sightline::algorithms::exact {
namespace {

constexpr double cells_an_occluder = 0.25;
constexpr double most_cells_a_side = 1024;
constexpr std::uint32_t most_entries_per_occluder = 32;  // on average

template <class Visit>
void for_cells(const ImageGrid::Cells& cells, std::uint32_t side, Visit visit) {
  for (std::uint32_t row = cells.low[1]; row <= cells.high[1]; ++row)
    for (std::uint32_t column = cells.low[0]; column <= cells.high[0]; ++column)
      visit(std::size_t{row} * side + column);
}

}  // namespace

ImageGrid::ImageGrid(std::span<const ImageBounds> bounds, std::span<const std::uint32_t> depths, unsigned jobs) {
  side_ = static_cast<std::uint32_t>(
      std::clamp(std::sqrt(static_cast<double>(bounds.size()) * cells_an_occluder), 1.0, most_cells_a_side));
  // Occluders that cover much of the image are entered in many cells each; then the grid gets fewer cells.
  const std::uint64_t most = std::uint64_t{most_entries_per_occluder} * bounds.size() + 4096;
  while (side_ > 1 && entries_needed(bounds) > most) side_ /= 2;
  for (std::uint32_t cell = 0; cell < side_; ++cell)
    first_steps_.push_back(static_cast<std::uint16_t>(((cell << 15) + side_ - 1) / side_));
  sort_by_depth(depths, jobs);
  // Each part counts its own entries, so that in each cell they follow those of earlier parts.
  const std::size_t cells = std::size_t{side_} * side_;
  std::vector<std::vector<std::uint32_t>> fill(jobs);
  base::for_parts(jobs, order_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    fill[part].assign(cells, 0);
    for (std::size_t i = begin; i < end; ++i)
      for_cells(cells_of(bounds[order_[i]]), side_, [&](std::size_t cell) { ++fill[part][cell]; });
  });
  starts_.resize(cells + 1);
  std::uint32_t next = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    starts_[cell] = next;
    for (std::vector<std::uint32_t>& part : fill) {
      const std::uint32_t count = part[cell];
      part[cell] = next;
      next += count;
    }
  }
  starts_[cells] = next;
  bounds_.resize(next);
  ranks_.resize(next);
  base::for_parts(jobs, order_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const ImageBounds& box = bounds[order_[i]];
      const std::uint64_t numbers = packed({box.low[0], box.low[1], last_minus(box.high[0]), last_minus(box.high[1])});
      for_cells(cells_of(box), side_, [&](std::size_t cell) {
        const std::uint32_t at = fill[part][cell]++;
        bounds_[at] = numbers;
        ranks_[at] = static_cast<std::uint32_t>(i);
      });
    }
  });
}

// Nearest first, equal depths by number.
void ImageGrid::sort_by_depth(std::span<const std::uint32_t> depths, unsigned jobs) {
  struct Key {
    std::uint32_t depth = 0;
    std::uint32_t occluder = 0;
  };
  std::vector<Key> keys(depths.size());
  for (std::uint32_t i = 0; i < depths.size(); ++i) keys[i] = {depths[i], i};
  base::radix_sort(keys, 0, 32, [](const Key& key) { return key.depth; }, jobs);
  order_.resize(keys.size());
  depths_.resize(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    order_[i] = keys[i].occluder;
    depths_[i] = keys[i].depth;
  }
  if (depths_.empty()) return;
  // One bucket for about four occluders, or up to two per occluder if there are few.
  const std::uint32_t range = depths_.back() - depths_.front();
  while (bucket_shift_ < 31 && range >> bucket_shift_ > depths_.size() / 4) ++bucket_shift_;
  buckets_.assign((range >> bucket_shift_) + 2, static_cast<std::uint32_t>(depths_.size()));
  for (std::size_t i = depths_.size(); i-- > 0;)
    buckets_[(depths_[i] - depths_.front()) >> bucket_shift_] = static_cast<std::uint32_t>(i);
  for (std::size_t b = buckets_.size() - 1; b-- > 0;) buckets_[b] = std::min(buckets_[b], buckets_[b + 1]);
}

std::uint64_t ImageGrid::entries_needed(std::span<const ImageBounds> bounds) const {
  std::uint64_t entries = 0;
  for (const ImageBounds& box : bounds) {
    const Cells cells = cells_of(box);
    entries += std::uint64_t{cells.high[0] - cells.low[0] + 1} * (cells.high[1] - cells.low[1] + 1);
  }
  return entries;
}

}  // namespace sightline::algorithms::exact
