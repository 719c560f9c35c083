// Lattice regions as four bits per square, an independent representation: the diagonals cut every square into a south, east,
// north
// and west triangle, and a lattice region contains each triangle completely or not at all. For a polygon this is determined by
// the
// crossings of a ray, for stripes by counting sides.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "tests/host/algorithms/montani_re/lattice_pcs.hpp"

namespace sightline::algorithms::montani_re {

inline constexpr int tetrakis_side = 14;  // squares a row
using Tetrakis = std::array<std::uint8_t, tetrakis_side * tetrakis_side>;

// A point inside each triangle, in twelfths of a step from the square's corner.
inline constexpr std::array<std::array<int, 2>, 4> triangle_points{{{6, 2}, {10, 5}, {6, 10}, {2, 5}}};

struct LatticePolygon {
  std::vector<LatticePoint> corners;  // in whole steps
};

// Even-odd, with a ray to the west; the points' ordinates differ from those of all corners.
inline Tetrakis tetrakis_of(const std::vector<LatticePolygon>& polygons) {
  Tetrakis bits{};
  for (std::size_t square = 0; square < bits.size(); ++square) {
    const int x = static_cast<int>(square) % tetrakis_side;
    const int y = static_cast<int>(square) / tetrakis_side;
    for (std::size_t t = 0; t < 4; ++t) {
      const int px = 12 * x + triangle_points[t][0];
      const int py = 12 * y + triangle_points[t][1];
      for (const LatticePolygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
          const LatticePoint& a = polygon.corners[i];
          const LatticePoint& b = polygon.corners[(i + 1) % polygon.corners.size()];
          if ((12 * a.y > py) == (12 * b.y > py)) continue;
          // slopes are -1, 0, 1 or infinite, so that the quotient is whole
          const int cross_x = 12 * a.x + (b.x - a.x) * (py - 12 * a.y) / (b.y - a.y);
          if (cross_x < px) bits[square] = static_cast<std::uint8_t>(bits[square] ^ (1U << t));
        }
      }
    }
  }
  return bits;
}

inline Tetrakis tetrakis_of(const LatticePcs& pcs) {
  Tetrakis bits{};
  for (const LatticeStripe& stripe : pcs.half_stripes) {
    const int y = stripe.y / 2;
    for (std::size_t t = 0; t < 4; ++t) {
      const int height = triangle_points[t][1] - (stripe.y % 2 == 0 ? 0 : 6);  // in sixths of the half stripe
      if (height < 0 || height > 6) continue;
      for (const LatticeSide& side : stripe.sides) {
        const int side_x = 6 * side.bottom + height * (side.top - side.bottom);
        for (int x = 0; x < tetrakis_side; ++x) {
          auto& square = bits[static_cast<std::size_t>(y * tetrakis_side + x)];
          if (side_x < 12 * x + triangle_points[t][0]) square = static_cast<std::uint8_t>(square ^ (1U << t));
        }
      }
    }
  }
  return bits;
}

class RandomPolygons {
 public:
  explicit RandomPolygons(std::uint32_t seed) : dice_(seed) {}

  // It may cross and overlap itself: the even-odd rule defines the inside.
  LatticePolygon polygon() {
    for (;;) {
      LatticePolygon p{{{below(tetrakis_side + 1), below(tetrakis_side + 1)}}};
      bool inside = true;
      const int count = 3 + below(7);
      for (int i = 0; i < count; ++i) inside = step(p, below(3) - 1, below(3) - 1, 1 + below(5)) && inside;
      const LatticePoint last = p.corners.back();
      const int dx = p.corners[0].x - last.x;
      const int dy = p.corners[0].y - last.y;
      const int diagonal = std::min(std::abs(dx), std::abs(dy));
      step(p, dx < 0 ? -1 : 1, dy < 0 ? -1 : 1, diagonal);
      if (inside) return p;
    }
  }
  std::vector<LatticePolygon> polygons() {
    std::vector<LatticePolygon> all{polygon()};
    if (below(2) == 1) all.push_back(polygon());
    return all;
  }
  int below(int n) { return static_cast<int>(dice_() % static_cast<std::uint32_t>(n)); }

 private:
  static bool step(LatticePolygon& p, int dx, int dy, int length) {
    const LatticePoint at = p.corners.back();
    p.corners.push_back({at.x + dx * length, at.y + dy * length});
    const LatticePoint& to = p.corners.back();
    return to.x >= 0 && to.x <= tetrakis_side && to.y >= 0 && to.y <= tetrakis_side;
  }
  std::mt19937 dice_;
};

inline LatticePcs pcs_of(const std::vector<LatticePolygon>& polygons) {
  std::vector<std::vector<LatticePoint>> loops;
  for (const LatticePolygon& polygon : polygons) {
    auto& loop = loops.emplace_back();
    for (const LatticePoint& p : polygon.corners) loop.push_back({2 * p.x, 2 * p.y});
  }
  return lattice_pcs_of_half_steps(loops);
}

// The number of wrong results among `rounds` times three set operations.
inline int wrong_set_operations(std::uint32_t seed, int rounds) {
  RandomPolygons random(seed);
  int wrong = 0;
  for (int round = 0; round < rounds; ++round) {
    const auto one = random.polygons();
    const auto other = random.polygons();
    const LatticePcs a = pcs_of(one);
    const LatticePcs b = pcs_of(other);
    const Tetrakis bits_a = tetrakis_of(one);
    const Tetrakis bits_b = tetrakis_of(other);
    Tetrakis both{};
    Tetrakis either{};
    Tetrakis first{};
    for (std::size_t i = 0; i < both.size(); ++i) {
      both[i] = bits_a[i] & bits_b[i];
      either[i] = bits_a[i] | bits_b[i];
      first[i] = static_cast<std::uint8_t>(bits_a[i] & ~bits_b[i]);
    }
    wrong += (tetrakis_of(unite(a, b)) != either ? 1 : 0) + (tetrakis_of(intersect(a, b)) != both ? 1 : 0) +
             (tetrakis_of(subtract(a, b)) != first ? 1 : 0);
  }
  return wrong;
}

}  // namespace sightline::algorithms::montani_re
