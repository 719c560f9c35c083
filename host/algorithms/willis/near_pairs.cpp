#include "host/algorithms/willis/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sightline::algorithms::willis {

namespace {

class Grid {
 public:
  explicit Grid(std::span<const ReachingBox> boxes) : boxes_(boxes) {
    lay_out();
    std::vector<std::uint32_t> counts(cells_[0] * cells_[1] * cells_[2] + 1);
    for (const ReachingBox& box : boxes_) for_cells(box, 0, [&](std::size_t cell) { ++counts[cell + 1]; });
    for (std::size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
    first_ = counts;
    members_.resize(counts.back());
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
      for_cells(boxes_[i], 0, [&](std::size_t cell) { members_[counts[cell]++] = i; });
  }

  [[nodiscard]] std::vector<NumberPair> pairs() const {
    std::vector<NumberPair> pairs;
    std::vector<std::uint32_t> seen(boxes_.size(), ~std::uint32_t{0});
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
      const double reach = std::sqrt(static_cast<double>(boxes_[i].squared_reach)) + 1;
      for_cells(boxes_[i], static_cast<std::int64_t>(reach), [&](std::size_t cell) {
        for (std::uint32_t m = first_[cell]; m < first_[cell + 1]; ++m) {
          const std::uint32_t j = members_[m];
          if (j == i || seen[j] == i) continue;
          seen[j] = i;
          // Only the box that reaches farther reports the pair, because the other may not find it.
          const bool mine = boxes_[i].squared_reach > boxes_[j].squared_reach ||
                            (boxes_[i].squared_reach == boxes_[j].squared_reach && i < j);
          if (mine && near_each_other(boxes_[i], boxes_[j]))
            pairs.emplace_back(std::min(i, j), std::max(i, j));
        }
      });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

 private:
  // Chooses cells about as large as the average box, and not many more cells than boxes.
  void lay_out() {
    Point high{};
    double sizes = 0;
    low_ = boxes_[0].low;
    high = boxes_[0].high;
    for (const ReachingBox& box : boxes_) {
      std::int64_t size = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        low_[a] = std::min(low_[a], box.low[a]);
        high[a] = std::max(high[a], box.high[a]);
        size = std::max(size, std::int64_t{box.high[a]} - box.low[a]);
      }
      sizes += static_cast<double>(size);
    }
    const auto count = static_cast<double>(boxes_.size());
    std::int64_t extent = 0;
    for (std::size_t a = 0; a < 3; ++a) extent = std::max(extent, std::int64_t{high[a]} - low_[a]);
    cell_ = 1 + static_cast<std::int64_t>(
                    std::max(sizes / count, static_cast<double>(extent) / (2 * std::cbrt(count))));
    for (std::size_t a = 0; a < 3; ++a)
      cells_[a] = static_cast<std::size_t>((std::int64_t{high[a]} - low_[a]) / cell_ + 1);
  }

  template <class Visit>
  void for_cells(const ReachingBox& box, std::int64_t reach, Visit&& visit) const {
    std::array<std::size_t, 3> from{};
    std::array<std::size_t, 3> to{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto cell = [&](std::int64_t at) {
        return static_cast<std::size_t>(
            std::clamp<std::int64_t>((at - low_[a]) / cell_, 0, static_cast<std::int64_t>(cells_[a]) - 1));
      };
      from[a] = cell(box.low[a] - reach);
      to[a] = cell(box.high[a] + reach);
    }
    for (std::size_t x = from[0]; x <= to[0]; ++x)
      for (std::size_t y = from[1]; y <= to[1]; ++y)
        for (std::size_t z = from[2]; z <= to[2]; ++z) visit((x * cells_[1] + y) * cells_[2] + z);
  }

  std::span<const ReachingBox> boxes_;
  Point low_{};
  std::int64_t cell_ = 1;
  std::array<std::size_t, 3> cells_{1, 1, 1};
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> members_;
};

}  // namespace

ReachingBox box_of(const Surface& s) {
  ReachingBox box{s.points[0], s.points[0], squared_diameter(s.points)};
  for (const Point& p : s.points) {
    for (std::size_t a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], p[a]);
      box.high[a] = std::max(box.high[a], p[a]);
    }
  }
  return box;
}

bool near_each_other(const ReachingBox& a, const ReachingBox& b) {
  Vector3 gap{};
  for (std::size_t i = 0; i < 3; ++i) {
    gap[i] =
        std::max<std::int64_t>({0, std::int64_t{a.low[i]} - b.high[i], std::int64_t{b.low[i]} - a.high[i]});
  }
  return squared_length(gap) <= std::max(a.squared_reach, b.squared_reach);
}

std::vector<NumberPair> near_pairs(std::span<const ReachingBox> boxes) {
  if (boxes.empty()) return {};
  return Grid(boxes).pairs();
}

}  // namespace sightline::algorithms::willis
