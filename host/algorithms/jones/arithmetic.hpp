// The integers of three widths that masks and lines are computed with. A view uses the narrowest width that is
// sufficient.
//
// A sight plane has components up to m. In perspective it is used unchanged as a triple (line); in orthographic views its
// image is the triple, with two components up to m and one up to c. The images of two planes cross in their cross product
// (ray). On which side of a third plane the crossing lies is the sign of a dot product below 6 m m max(m, c). The value of a
// plane at a vertex of the scene, at most 2^19 from the eye, is below 3 * 2^19 m + c. So:
//   narrow: everything in 64 bits;  medium: planes in 64, rays and signs in 128;
//   wide: planes and their values in 128, rays and signs in WideIntegers. A sign is tried in doubles first: an entry is
//         right to four units in the last place, so a sum that exceeds 2^-46 of the magnitudes of its terms has the right
//         sign. Such filters pay only where the exact computation takes several words.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/geometry/integer.hpp"
#include "host/geometry/predicates.hpp"
#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::jones {

template <class Number>
struct Triple {
  std::array<Number, 3> part{};
};

// Planes in 64 bits, rays in 64 or 128.
template <class RayNumber>
struct DirectArithmetic {
  using Number = std::int64_t;
  using Line = Triple<std::int64_t>;
  using Ray = Triple<RayNumber>;

  static Line line(const std::array<Number, 3>& parts) { return {parts}; }
  static Ray meet(const Line& u, const Line& v) {
    const auto minor = [&](std::size_t i, std::size_t j) {
      return RayNumber{u.part[i]} * v.part[j] - RayNumber{u.part[j]} * v.part[i];
    };
    return {{minor(1, 2), minor(2, 0), minor(0, 1)}};
  }
  static bool is_zero(const Ray& ray) { return ray.part[0] == 0 && ray.part[1] == 0 && ray.part[2] == 0; }
  static int side(const Line& line, const Ray& ray) {
    return geometry::sign(line.part[0] * ray.part[0] + line.part[1] * ray.part[1] +
                          line.part[2] * ray.part[2]);
  }
};

using NarrowArithmetic = DirectArithmetic<std::int64_t>;
using MediumArithmetic = DirectArithmetic<geometry::Int128>;

struct WideArithmetic {
  using Number = geometry::Int128;
  // The bits of a part of a line, which is at most m or c. The value v of a plane of the complex is below 2^62 at every
  // point (visible_edges.cpp), so the components k of its normal are below 2^62 / 2^18; those of the camera's forward are
  // below 2^15, and below 2^17 together. So m = 2 k v or 2 k k 2^17 is below 2^107, and c = 2 k v 2^17 below 2^124.
  static constexpr unsigned part_bits = 124;
  using Part = geometry::WideInteger<part_bits>;
  struct Line {
    std::array<Number, 3> part{};
    std::array<double, 3> near{};
  };
  struct Ray {
    std::array<geometry::WideInteger<2 * part_bits + 1>, 3> part{};
    std::array<double, 3> near{};
  };

  static Line line(const std::array<Number, 3>& parts) {
    Line line{parts, {}};
    for (std::size_t i = 0; i < 3; ++i) line.near[i] = static_cast<double>(parts[i]);
    return line;
  }
  static Ray meet(const Line& u, const Line& v) {
    const auto minor = [&](std::size_t i, std::size_t j) {
      return Part(u.part[i]) * Part(v.part[j]) - Part(u.part[j]) * Part(v.part[i]);
    };
    Ray ray{{minor(1, 2), minor(2, 0), minor(0, 1)}, {}};
    for (std::size_t i = 0; i < 3; ++i) ray.near[i] = ray.part[i].to_double();
    return ray;
  }
  static bool is_zero(const Ray& ray) {
    return ray.part[0].sign() == 0 && ray.part[1].sign() == 0 && ray.part[2].sign() == 0;
  }
  static int side(const Line& line, const Ray& ray) {
    double sum = 0;
    double magnitude = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double term = line.near[i] * ray.near[i];
      sum += term;
      magnitude += std::fabs(term);
    }
    constexpr double certain = 0x1p-46;
    if (std::fabs(sum) > certain * magnitude) return sum > 0 ? 1 : -1;
    return (Part(line.part[0]) * ray.part[0] + Part(line.part[1]) * ray.part[1] +
            Part(line.part[2]) * ray.part[2])
        .sign();
  }
};

}  // namespace sightline::algorithms::jones
