#include "host/algorithms/skala/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host/algorithms/skala/facing.hpp"

namespace sightline::algorithms::skala {
namespace {

constexpr double edge_slack = 1.0 / 64;  // of a unit of y
// Triangles that share an edge meet in a column; their heights there may differ in the last bit.
constexpr float seam = 1.0F / 4096;

// The part of 0..1 in which a linear difference from `at_0` to `at_1` is positive.
LinePart positive_part(double at_0, double at_1) {
  if (at_0 > 0 && at_1 > 0) return {0, 1};
  if (!(at_0 > 0) && !(at_1 > 0)) return {1, 0};
  const double meets = at_0 / (at_0 - at_1);
  return at_0 > 0 ? LinePart{0, meets} : LinePart{meets, 1};
}

}  // namespace

void Coverage::add(const Surface& surface, bool triangles) {
  for (std::size_t row = 0; row + 1 < surface.rows(); ++row)
    for (std::size_t column = 0; column + 1 < surface.columns(); ++column) {
      if (!cell_defined(surface, row, column)) continue;
      const Vertex& near = surface.at(row, column);
      const Vertex& far = surface.at(row + 1, column + 1);
      const Vertex& beside = surface.at(row, column + 1);
      const Vertex& behind = surface.at(row + 1, column);
      if (triangles) {
        add(std::array{near, beside, behind});
        add(std::array{far, beside, behind});
      } else {
        add(std::array{near, beside, far, behind});
      }
    }
}

void Coverage::add(std::span<const Vertex> outline) {
  const auto [left, right] = std::minmax_element(outline.begin(), outline.end(), [](Vertex a, Vertex b) { return a.x < b.x; });
  const int last = std::min(static_cast<int>(std::floor(right->x)), static_cast<int>(columns_.size()) - 1);
  for (int column = std::max(static_cast<int>(std::ceil(left->x)), 0); column <= last; ++column) {
    const auto x = static_cast<float>(column);
    Interval covered{1e30F, -1e30F};
    const auto take = [&](float y) { covered = {std::min(covered.low, y), std::max(covered.high, y)}; };
    for (std::size_t i = 0; i < outline.size(); ++i) {
      Vertex p = outline[i];
      Vertex q = outline[i + 1 < outline.size() ? i + 1 : 0];
      // Gives the same result for both directions of the line.
      if (q.x < p.x || (q.x == p.x && q.y < p.y)) std::swap(p, q);
      if (p.x > x || q.x < x) continue;
      if (p.x == q.x) {
        take(p.y);
        take(q.y);
      } else {
        take(p.y + (x - p.x) * ((q.y - p.y) / (q.x - p.x)));
      }
    }
    if (covered.low <= covered.high) add(static_cast<std::size_t>(column), covered);
  }
}

Coverage::Saved Coverage::saved(float from, float to) const {
  const auto last = static_cast<int>(columns_.size()) - 1;
  const int first = std::clamp(static_cast<int>(std::floor(from)), 0, last);
  const int end = std::clamp(static_cast<int>(std::ceil(to)), 0, last) + 1;
  return {static_cast<std::size_t>(first), {columns_.begin() + first, columns_.begin() + end}};
}

void Coverage::restore(const Saved& saved) {
  std::copy(saved.columns.begin(), saved.columns.end(), columns_.begin() + static_cast<std::ptrdiff_t>(saved.first));
}

void Coverage::add(std::size_t column, Interval interval) {
  Column& all = columns_[column];
  // Intervals that meet the new one are merged with it.
  const auto first = std::lower_bound(all.begin(), all.end(), interval.low - seam, [](const Interval& each, float low) { return each.high < low; });
  auto last = first;
  for (; last != all.end() && last->low <= interval.high + seam; ++last)
    interval = {std::min(interval.low, last->low), std::max(interval.high, last->high)};
  if (first == last) {
    all.insert(first, interval);
  } else {
    *first = interval;
    all.erase(first + 1, last);
  }
}

const Coverage::Column& Coverage::column(double x) const {
  static const Column nothing;
  if (x < 0 || x >= static_cast<double>(columns_.size())) return nothing;
  return columns_[static_cast<std::size_t>(x)];
}

// Appends the hidden parts of a line between `begin` and `end`, which are between two columns. The ends of intervals are
// interpolated linearly if both columns have the same number of intervals; otherwise those of the nearer column are used.
void Coverage::hide(Vertex from, Vertex to, double begin, double end, std::vector<LinePart>& hidden) const {
  const auto x_at = [&](double t) { return double{from.x} + t * (double{to.x} - double{from.x}); };
  const auto y_at = [&](double t) { return double{from.y} + t * (double{to.y} - double{from.y}); };
  const double left = std::floor((x_at(begin) + x_at(end)) / 2);
  const Column& a = column(left);
  const Column& b = column(left + 1);
  const bool straight = a.size() == b.size();
  if (!straight) {
    const double middle = (begin + end) / 2;
    const bool wide = std::abs(x_at(end) - x_at(begin)) > 0.75;
    for (const auto& [p, q] : {std::pair{begin, wide ? middle : end}, std::pair{wide ? middle : end, end}}) {
      if (!(p < q)) continue;
      const double x = (x_at(p) + x_at(q)) / 2;
      for (const Interval& interval : x - left < 0.5 ? a : b) {
        const LinePart above = positive_part(y_at(p) - interval.low - edge_slack, y_at(q) - interval.low - edge_slack);
        const LinePart below = positive_part(interval.high - y_at(p) - edge_slack, interval.high - y_at(q) - edge_slack);
        const LinePart part{std::max(above.from, below.from), std::min(above.to, below.to)};
        if (part.from < part.to) hidden.push_back({p + part.from * (q - p), p + part.to * (q - p)});
      }
    }
    return;
  }
  const double at_begin = std::clamp(x_at(begin) - left, 0.0, 1.0);
  const double at_end = std::clamp(x_at(end) - left, 0.0, 1.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto low = [&](double x) { return a[i].low + x * (double{b[i].low} - double{a[i].low}); };
    const auto high = [&](double x) { return a[i].high + x * (double{b[i].high} - double{a[i].high}); };
    const LinePart above = positive_part(y_at(begin) - low(at_begin) - edge_slack, y_at(end) - low(at_end) - edge_slack);
    const LinePart below = positive_part(high(at_begin) - y_at(begin) - edge_slack, high(at_end) - y_at(end) - edge_slack);
    const LinePart part{std::max(above.from, below.from), std::min(above.to, below.to)};
    if (part.from < part.to) hidden.push_back({begin + part.from * (end - begin), begin + part.to * (end - begin)});
  }
}

std::vector<LinePart> Coverage::visible(Vertex from, Vertex to) const {
  std::vector<double> cuts{0, 1};
  const double run = double{to.x} - double{from.x};
  if (run != 0) {
    const auto [low, high] = std::minmax(from.x, to.x);
    const double first = std::max(std::floor(double{low}) + 1, 0.0);
    for (double column = first; column < double{high} && column < static_cast<double>(columns_.size()); ++column)
      cuts.push_back((column - double{from.x}) / run);
    std::sort(cuts.begin(), cuts.end());
  }
  std::vector<LinePart> hidden;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    if (cuts[i] < cuts[i + 1]) hide(from, to, cuts[i], cuts[i + 1], hidden);
  std::sort(hidden.begin(), hidden.end(), [](const LinePart& a, const LinePart& b) { return a.from < b.from; });
  std::vector<LinePart> seen;
  double at = 0;
  // Shorter parts are rounding errors between two that meet.
  constexpr double shortest = 1e-6;
  for (const LinePart& part : hidden) {
    if (part.from - at > shortest) seen.push_back({at, part.from});
    at = std::max(at, part.to);
  }
  if (1 - at > shortest) seen.push_back({at, 1});
  return seen;
}

}  // namespace sightline::algorithms::skala
