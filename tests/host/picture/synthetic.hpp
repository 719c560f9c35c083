// A drawing computed arithmetically, for tests that need strokes but no display: a cube in oblique view, every point 1.5 us after
// the one
// before, as Type 340 vectors would light it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "emulators/core/stroke.hpp"

namespace sightline::tests {

inline constexpr std::int64_t point_nanoseconds = 1500;

// Appends the nearest lattice points of a straight line, including both ends; returns the time after it.
inline std::int64_t append_line(std::vector<core::Stroke>& strokes, std::int64_t ns, std::array<int, 2> from,
                                std::array<int, 2> to, int intensity) {
  const int steps = std::max(std::abs(to[0] - from[0]), std::abs(to[1] - from[1]));
  const auto along = [steps](int a, int b, int step) {
    return steps == 0 ? a : a + (2 * (b - a) * step + (b >= a ? steps : -steps)) / (2 * steps);
  };
  for (int step = 0; step <= steps; ++step, ns += point_nanoseconds) {
    core::Stroke stroke;
    stroke.time = core::at_nanoseconds(ns);
    stroke.x = static_cast<std::uint16_t>(along(from[0], to[0], step));
    stroke.y = static_cast<std::uint16_t>(along(from[1], to[1], step));
    stroke.intensity = static_cast<std::uint8_t>(intensity);
    strokes.push_back(stroke);
  }
  return ns;
}

// One pass of the cube starting at `ns`.
inline std::vector<core::Stroke> cube_pass(std::int64_t ns, int intensity) {
  constexpr std::array<std::array<int, 2>, 8> corner{
      {{230, 200}, {630, 200}, {630, 600}, {230, 600}, {420, 420}, {820, 420}, {820, 820}, {420, 820}}};
  constexpr std::array<std::pair<std::size_t, std::size_t>, 12> edges{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  std::vector<core::Stroke> strokes;
  for (const auto& [a, b] : edges) ns = append_line(strokes, ns + 45000, corner[a], corner[b], intensity);
  return strokes;
}

}  // namespace sightline::tests
