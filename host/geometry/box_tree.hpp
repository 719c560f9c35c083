// Finds the boxes that intersect a query: a binary tree in which each node has the bounds of its subtree.
//
// Law: the boxes visited are those that a test of every box finds, each once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/geometry/box.hpp"

namespace sightline::geometry {

// Whether a segment has a point in a box or within `margin` of it in each coordinate.
[[nodiscard]] inline bool segment_meets(const Point& from, const Point& to, const Box& box, double margin) {
  double begin = 0;
  double end = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const double low = box.low[a] - margin - from[a];
    const double high = box.high[a] + margin - from[a];
    const double along = double(to[a]) - from[a];
    if (along == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    begin = std::max(begin, (along > 0 ? low : high) / along);
    end = std::min(end, (along > 0 ? high : low) / along);
  }
  return begin <= end;
}

class BoxTree {
 public:
  // Copies the boxes. Takes n log n time.
  explicit BoxTree(std::span<const Box> boxes) : boxes_(boxes.begin(), boxes.end()) {
    order_.reserve(boxes_.size());
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) order_.push_back(i);
    around_.resize(boxes_.size());
    build(0, order_.size(), 0);
  }

  // Calls visit(number) for every box that has a point (including its surface) in common with `query`. The order is
  // unspecified, but reproducible.
  template <class Visit>
  void for_each_touching(const Box& query, Visit visit) const {
    for_each_that([&query](const Box& box) { return touch(box, query); }, visit);
  }
  // The same for boxes for which `meets` is true. Precondition: if it is true for a box, it is true for every box that
  // contains it.
  template <class Meets, class Visit>
  void for_each_that(const Meets& meets, Visit visit) const {
    search(0, order_.size(), meets, visit);
  }

 private:
  [[nodiscard]] static bool touch(const Box& a, const Box& b) {
    bool common = true;
    for (std::size_t i = 0; i < 3; ++i) common = common && a.low[i] <= b.high[i] && b.low[i] <= a.high[i];
    return common;
  }

  // The node of order_[begin, end) is its middle element; the elements before and after it are its subtrees.
  void build(std::size_t begin, std::size_t end, std::size_t axis) {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      const std::int64_t sum_a = std::int64_t{boxes_[a].low[axis]} + boxes_[a].high[axis];
      const std::int64_t sum_b = std::int64_t{boxes_[b].low[axis]} + boxes_[b].high[axis];
      return sum_a != sum_b ? sum_a < sum_b : a < b;
    });
    Box around = boxes_[order_[begin]];
    for (std::size_t i = begin; i < end; ++i) {
      const Box& box = boxes_[order_[i]];
      for (std::size_t a = 0; a < 3; ++a) {
        around.low[a] = std::min(around.low[a], box.low[a]);
        around.high[a] = std::max(around.high[a], box.high[a]);
      }
    }
    around_[middle] = around;
    build(begin, middle, (axis + 1) % 3);
    build(middle + 1, end, (axis + 1) % 3);
  }

  template <class Meets, class Visit>
  void search(std::size_t begin, std::size_t end, const Meets& meets, Visit& visit) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    if (!meets(around_[middle])) return;
    search(begin, middle, meets, visit);
    if (meets(boxes_[order_[middle]])) visit(order_[middle]);
    search(middle + 1, end, meets, visit);
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Box> around_;  // by position in order_
};

}  // namespace sightline::geometry
