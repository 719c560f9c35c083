// Horizon::draw_chain: compares a whole slice with the masks in a few passes over flat arrays, which compilers vectorize.
// A slice has millions of segments of two or three columns each; if they are processed one by one, as Horizon::draw does,
// most of the time is lost on short unpredictable loops.
//
// No two segments of a chain have a column in common. Therefore the masks are raised only at the end, and a segment
// between two columns is compared with the masks from before the chain.
#include <algorithm>
#include <array>

#include "host/algorithms/skala/horizon.hpp"

namespace sightline::algorithms::skala {
namespace {

constexpr std::uint32_t above_top = 1;
constexpr std::uint32_t below_bottom = 1U << 16;  // exceeds any number of columns

// Compilers vectorize loops of known length.
constexpr std::size_t columns_at_once = 16;

// Replaces each mask[i] by choose(mask[i], heights[i]). Precondition: the two do not overlap.
template <class Choose>
void merge_heights(float* __restrict mask, const float* __restrict heights, std::size_t count, Choose choose) {
  std::size_t i = 0;
  for (; i + columns_at_once <= count; i += columns_at_once)
    for (std::size_t k = 0; k < columns_at_once; ++k) mask[i + k] = choose(mask[i + k], heights[i + k]);
  for (; i < count; ++i) mask[i] = choose(mask[i], heights[i]);
}

// Sets flags for each column: whether its height is above the top mask or below the bottom mask by more than the slack.
void flag_columns(std::uint32_t* __restrict flags, const float* heights, const float* top, const float* bottom, std::size_t count,
                  float slack) {
  const auto flag = [=](std::size_t i) {
    const std::uint32_t above = heights[i] - top[i] > slack ? above_top : 0U;
    const std::uint32_t below = bottom[i] - heights[i] > slack ? below_bottom : 0U;
    return above | below;
  };
  std::size_t i = 0;
  for (; i + columns_at_once <= count; i += columns_at_once)
    for (std::size_t k = 0; k < columns_at_once; ++k) flags[i + k] = flag(i + k);
  for (; i < count; ++i) flags[i] = flag(i);
}

}  // namespace

// A segment crosses the columns after the last one not right of its left end, up to the last one not right of its right
// end.
void Horizon::measure_chain(std::span<const Vertex> chain) {
  const std::size_t count = chain.size();
  vertex_columns_.resize(count);
  slopes_.resize(count);
  const auto last = static_cast<float>(columns_ - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const float x = chain[i].x;
    const float within = x < last ? x : last;
    vertex_columns_[i] = x < 0 ? -1 : static_cast<std::int32_t>(within);
  }
  // If two vertices are one above the other, the slope is not a number; the segment has no columns.
  for (std::size_t i = 0; i + 1 < count; ++i)
    slopes_[i] = (chain[i + 1].y - chain[i].y) / (chain[i + 1].x - chain[i].x);
}

// Computes the chain's heights from left to right in blocks of columns. What a segment writes beyond its last column is
// overwritten by the next segment.
void Horizon::trace_chain(std::span<const Vertex> chain, bool leftwards) {
  float* const heights = heights_.data();
  const auto trace = [&](Vertex left, std::int32_t before, std::int32_t last, float slope) {
    for (std::int32_t column = before + 1; column <= last; column += static_cast<std::int32_t>(block)) {
      for (std::int32_t k = 0; k < static_cast<std::int32_t>(block); ++k)
        heights[column + k] = left.y + (static_cast<float>(column + k) - left.x) * slope;
    }
  };
  const std::size_t segments = chain.size() - 1;
  if (leftwards) {
    for (std::size_t i = segments; i-- > 0;)
      trace(chain[i + 1], vertex_columns_[i + 1], vertex_columns_[i], slopes_[i]);
  } else {
    for (std::size_t i = 0; i < segments; ++i)
      trace(chain[i], vertex_columns_[i], vertex_columns_[i + 1], slopes_[i]);
  }
}

void Horizon::compare_chain(Columns columns) {
  const auto first = static_cast<std::size_t>(columns.first);
  const auto count = static_cast<std::size_t>(columns.last - columns.first + 1);
  const float* const heights = heights_.data() + first;
  const float* const top = top_.data() + first;
  const float* const bottom = bottom_.data() + first;
  std::uint32_t* const before = seen_before_.data() + first;
  std::array<std::uint32_t, 64> flags;
  std::uint32_t sum = 0;
  for (std::size_t begin = 0; begin < count; begin += flags.size()) {
    const std::size_t length = std::min(flags.size(), count - begin);
    flag_columns(flags.data(), heights + begin, top + begin, bottom + begin, length, usual_slack);
    for (std::size_t i = 0; i < length; ++i) {
      before[begin + i] = sum;
      sum += flags[i];
    }
  }
  before[count] = sum;
}

void Horizon::ink_chain(std::span<const Vertex> chain, bool leftwards, const Wake& wake) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Vertex from = chain[i];
    const Vertex to = chain[i + 1];
    const std::int32_t before = vertex_columns_[leftwards ? i + 1 : i];
    const std::int32_t last = vertex_columns_[leftwards ? i : i + 1];
    if (before >= last) {
      first_own_ = pieces_.size();
      narrow(from, to, usual_slack, wake);
      continue;
    }
    const std::uint32_t seen =
        seen_before_[static_cast<std::size_t>(last + 1)] - seen_before_[static_cast<std::size_t>(before + 1)];
    if (seen == 0) continue;
    const auto count = static_cast<std::uint32_t>(last - before);
    if (seen % below_bottom == count || seen / below_bottom == count) {
      see(from, to);
    } else {
      first_own_ = pieces_.size();
      mixed(leftwards ? to : from, leftwards ? from : to, {before + 1, last}, leftwards, usual_slack);
    }
  }
}

void Horizon::raise_chain(Columns columns, bool leftwards, Wake& wake) {
  const auto first = static_cast<std::size_t>(columns.first);
  const auto count = static_cast<std::size_t>(columns.last - columns.first + 1);
  const std::size_t end = leftwards ? first : first + count - 1;
  wake = {static_cast<int>(end), top_[end], bottom_[end]};
  merge_heights(top_.data() + first, heights_.data() + first, count, [](float a, float b) { return std::max(a, b); });
  merge_heights(bottom_.data() + first, heights_.data() + first, count, [](float a, float b) { return std::min(a, b); });
}

bool Horizon::draw_chain(std::span<const Vertex> chain, Wake& wake) {
  pieces_.clear();
  if (chain.size() < 2) return false;
  const bool leftwards = chain.back().x < chain.front().x;
  measure_chain(chain);
  trace_chain(chain, leftwards);
  const Columns columns{(leftwards ? vertex_columns_.back() : vertex_columns_.front()) + 1,
                        leftwards ? vertex_columns_.front() : vertex_columns_.back()};
  const bool crosses = columns.first <= columns.last;
  if (crosses) compare_chain(columns);
  ink_chain(chain, leftwards, wake);
  if (crosses) raise_chain(columns, leftwards, wake);
  return !pieces_.empty();
}

}  // namespace sightline::algorithms::skala
