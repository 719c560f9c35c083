#include "tests/host/algorithms/montani_re/lattice_pcs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "host/algorithms/montani_re/boundary_trace.hpp"

namespace sightline::algorithms::montani_re {
namespace {

constexpr std::array<LatticePoint, 8> steps{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

struct PlacedSide {
  std::int32_t y = 0;
  LatticeSide side;
};

bool before(const LatticeSide& a, const LatticeSide& b) {
  const std::int32_t middle_a = a.bottom + a.top;
  const std::int32_t middle_b = b.bottom + b.top;
  return middle_a != middle_b ? middle_a < middle_b : a.bottom < b.bottom;
}

// Equal sides cancel in pairs.
LatticePcs from_sides(std::vector<PlacedSide> sides) {
  std::sort(sides.begin(), sides.end(), [](const PlacedSide& a, const PlacedSide& b) {
    return a.y != b.y ? a.y < b.y : before(a.side, b.side);
  });
  LatticePcs pcs;
  for (const PlacedSide& placed : sides) {
    auto& stripes = pcs.half_stripes;
    if (stripes.empty() || stripes.back().y != placed.y) {
      if (!stripes.empty() && stripes.back().sides.empty()) stripes.pop_back();
      stripes.push_back({placed.y, {}});
    }
    auto& row = stripes.back().sides;
    if (!row.empty() && row.back() == placed.side) {
      row.pop_back();
    } else {
      row.push_back(placed.side);
    }
  }
  if (!pcs.half_stripes.empty() && pcs.half_stripes.back().sides.empty()) pcs.half_stripes.pop_back();
  return pcs;
}

// The sides of a line of a lattice direction, both ends in half steps.
void append_line(LatticePoint from, LatticePoint to, std::vector<PlacedSide>& sides) {
  if (from.y > to.y) std::swap(from, to);
  const std::int32_t slope = (to.x > from.x ? 1 : 0) - (to.x < from.x ? 1 : 0);
  for (std::int32_t k = 0; k < to.y - from.y; ++k) {
    sides.push_back({from.y + k, {from.x + slope * k, from.x + slope * (k + 1)}});
  }
}

const std::vector<LatticeSide>& sides_at(const LatticePcs& pcs, std::size_t index, std::int32_t y,
                                         const std::vector<LatticeSide>& none) {
  return index < pcs.half_stripes.size() && pcs.half_stripes[index].y == y ? pcs.half_stripes[index].sides
                                                                           : none;
}

// Both lists are ordered from west to east; the result has a side wherever `keep` changes.
template <class Keep>
std::vector<LatticeSide> combine(const std::vector<LatticeSide>& a, const std::vector<LatticeSide>& b,
                                 Keep keep) {
  std::vector<LatticeSide> result;
  bool in_a = false;
  bool in_b = false;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    const LatticeSide side = j == b.size() || (i < a.size() && before(a[i], b[j])) ? a[i] : b[j];
    const bool kept = keep(in_a, in_b);
    if (i < a.size() && a[i] == side) in_a = !in_a, ++i;
    if (j < b.size() && b[j] == side) in_b = !in_b, ++j;
    if (keep(in_a, in_b) != kept) result.push_back(side);
  }
  return result;
}

template <class Keep>
LatticePcs combine(const LatticePcs& a, const LatticePcs& b, Keep keep) {
  static const std::vector<LatticeSide> none;
  LatticePcs result;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.half_stripes.size() || j < b.half_stripes.size()) {
    const bool only_b = i == a.half_stripes.size();
    const bool only_a = j == b.half_stripes.size();
    const std::int32_t y = only_b   ? b.half_stripes[j].y
                           : only_a ? a.half_stripes[i].y
                                    : std::min(a.half_stripes[i].y, b.half_stripes[j].y);
    auto sides = combine(sides_at(a, i, y, none), sides_at(b, j, y, none), keep);
    if (!only_b && a.half_stripes[i].y == y) ++i;
    if (!only_a && b.half_stripes[j].y == y) ++j;
    if (!sides.empty()) result.half_stripes.push_back({y, std::move(sides)});
  }
  return result;
}

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

LatticeLoop join_lines(const std::vector<std::uint32_t>& loop, const std::vector<Line>& lines) {
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

std::optional<LatticePcs> lattice_pcs(std::span<const FreemanChain> chains) {
  std::vector<PlacedSide> sides;
  for (const FreemanChain& chain : chains) {
    LatticePoint at{2 * chain.start.x, 2 * chain.start.y};
    const LatticePoint start = at;
    for (const char digit : chain.links) {
      if (digit < '0' || digit > '7') return std::nullopt;
      const LatticePoint step = steps[static_cast<std::size_t>(digit - '0')];
      const LatticePoint next{at.x + 2 * step.x, at.y + 2 * step.y};
      append_line(at, next, sides);
      at = next;
    }
    if (at != start) return std::nullopt;
  }
  return from_sides(std::move(sides));
}

LatticePcs lattice_pcs_of_half_steps(std::span<const std::vector<LatticePoint>> loops) {
  std::vector<PlacedSide> sides;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      append_line(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1], sides);
    }
  }
  return from_sides(std::move(sides));
}

std::optional<std::vector<LatticeStripe>> whole_stripes(const LatticePcs& pcs) {
  std::vector<LatticeStripe> whole;
  for (std::size_t i = 0; i < pcs.half_stripes.size(); i += 2) {
    const LatticeStripe& lower = pcs.half_stripes[i];
    if (lower.y % 2 != 0 || i + 1 == pcs.half_stripes.size()) return std::nullopt;
    const LatticeStripe& upper = pcs.half_stripes[i + 1];
    if (upper.y != lower.y + 1 || upper.sides.size() != lower.sides.size()) return std::nullopt;
    LatticeStripe stripe{lower.y / 2, {}};
    for (std::size_t k = 0; k < lower.sides.size(); ++k) {
      const LatticeSide& below = lower.sides[k];
      const LatticeSide& above = upper.sides[k];
      const bool straight = below.top == above.bottom && below.type() == above.type();
      if (!straight || below.bottom % 2 != 0) return std::nullopt;
      stripe.sides.push_back({below.bottom / 2, above.top / 2});
    }
    whole.push_back(std::move(stripe));
  }
  return whole;
}

LatticePcs unite(const LatticePcs& a, const LatticePcs& b) {
  return combine(a, b, [](bool in_a, bool in_b) { return in_a || in_b; });
}

LatticePcs intersect(const LatticePcs& a, const LatticePcs& b) {
  return combine(a, b, [](bool in_a, bool in_b) { return in_a && in_b; });
}

LatticePcs subtract(const LatticePcs& a, const LatticePcs& b) {
  return combine(a, b, [](bool in_a, bool in_b) { return in_a && !in_b; });
}

std::int64_t eightfold_area(const LatticePcs& pcs) {
  std::int64_t area = 0;
  for (const LatticeStripe& stripe : pcs.half_stripes) {
    for (std::size_t i = 0; i + 1 < stripe.sides.size(); i += 2) {
      const LatticeSide& west = stripe.sides[i];
      const LatticeSide& east = stripe.sides[i + 1];
      area += std::int64_t{east.bottom} + east.top - west.bottom - west.top;
    }
  }
  return area;
}

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
  for (const auto& loop : trace_boundary(pieces)) loops.push_back(join_lines(loop, lines));
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
