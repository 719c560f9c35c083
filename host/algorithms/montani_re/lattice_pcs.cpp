#include "host/algorithms/montani_re/lattice_pcs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

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

// Equal sides vanish in pairs.
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

// Both lists from west to east; a side of the result is where `keep` changes.
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

LatticeRaster rasterise(const LatticePcs& pcs, LatticePoint origin, std::int32_t width, std::int32_t height) {
  LatticeRaster raster{origin, width, height, {}};
  raster.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const LatticeStripe& stripe : pcs.half_stripes) {
    if (stripe.y % 2 == 0) continue;  // centres lie on the lower sides of the upper halves
    const std::int32_t row = (stripe.y - (stripe.y < 0 ? 1 : 0)) / 2 - origin.y;
    if (row < 0 || row >= height) continue;
    for (std::size_t k = 0; k + 1 < stripe.sides.size(); k += 2) {
      for (std::int32_t i = 0; i < width; ++i) {
        const std::int32_t centre = 2 * (origin.x + i) + 1;
        if (stripe.sides[k].bottom <= centre && centre < stripe.sides[k + 1].bottom) {
          raster.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(i)] = 1;
        }
      }
    }
  }
  return raster;
}

}  // namespace sightline::algorithms::montani_re
