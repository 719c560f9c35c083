#include "host/algorithms/montani_re/lattice_boundary.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

#include "host/algorithms/montani_re/boundary_trace.hpp"

namespace sightline::algorithms::montani_re {
namespace {

struct Line {
  LatticePoint from;
  LatticePoint to;
};

// 0 east, 1 north-east, ... 7 south-east.
std::int64_t heading(const LatticePoint& from, const LatticePoint& to) {
  const auto sign = [](std::int32_t n) { return (n > 0 ? 1 : 0) - (n < 0 ? 1 : 0); };
  constexpr std::array<std::array<std::int64_t, 3>, 3> table{{{5, 6, 7}, {4, -1, 0}, {3, 2, 1}}};
  return table[static_cast<std::size_t>(sign(to.y - from.y) + 1)]
              [static_cast<std::size_t>(sign(to.x - from.x) + 1)];
}

// The horizontal pieces on the line y: toggled by the ends of the sides above and below it.
void append_horizontal(std::int32_t y, const LatticeStripe* above, const LatticeStripe* below,
                       std::vector<Line>& lines) {
  struct End {
    std::int32_t x = 0;
    bool above = false;
  };
  std::vector<End> ends;
  if (above != nullptr) {
    for (const LatticeSide& side : above->sides) ends.push_back({side.bottom, true});
  }
  if (below != nullptr) {
    for (const LatticeSide& side : below->sides) ends.push_back({side.top, false});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.x < b.x; });
  bool in_above = false;
  bool in_below = false;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    (ends[i].above ? in_above : in_below) ^= true;
    const LatticePoint west{ends[i].x, y};
    const LatticePoint east{ends[i + 1].x, y};
    if (west.x == east.x || in_above == in_below) continue;
    lines.push_back(in_above ? Line{west, east} : Line{east, west});
  }
}

std::vector<Line> boundary_lines(const LatticePcs& pcs) {
  std::vector<Line> lines;
  const LatticeStripe* below = nullptr;
  for (const LatticeStripe& stripe : pcs.half_stripes) {
    if (below != nullptr && below->y + 1 != stripe.y) {
      append_horizontal(below->y + 1, nullptr, below, lines);
      below = nullptr;
    }
    append_horizontal(stripe.y, &stripe, below, lines);
    for (std::size_t k = 0; k < stripe.sides.size(); ++k) {
      const LatticePoint low{stripe.sides[k].bottom, stripe.y};
      const LatticePoint high{stripe.sides[k].top, stripe.y + 1};
      lines.push_back(k % 2 == 0 ? Line{high, low} : Line{low, high});
    }
    below = &stripe;
  }
  if (below != nullptr) append_horizontal(below->y + 1, nullptr, below, lines);
  return lines;
}

LatticeLoop joined(const std::vector<std::uint32_t>& loop, const std::vector<Line>& lines) {
  LatticeLoop result;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Line& arriving = lines[loop[i == 0 ? loop.size() - 1 : i - 1]];
    const Line& leaving = lines[loop[i]];
    if (heading(arriving.from, arriving.to) != heading(leaving.from, leaving.to)) {
      result.corners.push_back(leaving.from);
    }
  }
  return result;
}

}  // namespace

std::int64_t LatticeLoop::eightfold_area() const {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const LatticePoint& p = corners[i];
    const LatticePoint& q = corners[i + 1 == corners.size() ? 0 : i + 1];
    area += std::int64_t{p.x} * q.y - std::int64_t{q.x} * p.y;
  }
  return area;
}

std::vector<LatticeLoop> boundary_of(const LatticePcs& pcs) {
  const std::vector<Line> lines = boundary_lines(pcs);
  std::vector<LatticePoint> points;
  for (const Line& line : lines) points.push_back(line.from);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto number = [&points](const LatticePoint& p) {
    return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
  };
  std::vector<BoundaryPiece> pieces;
  for (const Line& line : lines) {
    pieces.push_back(
        {number(line.from), number(line.to), heading(line.from, line.to), heading(line.to, line.from)});
  }
  std::vector<LatticeLoop> loops;
  for (const auto& loop : trace_boundary(pieces)) loops.push_back(joined(loop, lines));
  return loops;
}

std::optional<OwnedChain> chain_of(const LatticeLoop& loop) {
  for (const LatticePoint& p : loop.corners) {
    if (p.x % 2 != 0 || p.y % 2 != 0) return std::nullopt;
  }
  OwnedChain chain;
  if (loop.corners.empty()) return chain;
  chain.start = {loop.corners[0].x / 2, loop.corners[0].y / 2};
  for (std::size_t i = 0; i < loop.corners.size(); ++i) {
    const LatticePoint& p = loop.corners[i];
    const LatticePoint& q = loop.corners[i + 1 == loop.corners.size() ? 0 : i + 1];
    const auto length = static_cast<std::size_t>(std::max(std::abs(q.x - p.x), std::abs(q.y - p.y)) / 2);
    chain.links.append(length, static_cast<char>('0' + heading(p, q)));
  }
  return chain;
}

}  // namespace sightline::algorithms::montani_re
