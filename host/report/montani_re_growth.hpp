// How the work of a view grows with the scene: Montani and Re's algorithm, exact and in stripes of a pixel,
// and `exact`, beside what their paper counts: faces, and pairs of faces that overlap in X.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::harness::report {

struct MontaniReSize {
  std::size_t size = 0;     // of the generated scene
  std::uint64_t faces = 0;  // that take part: not turned away, not edge-on
  std::uint64_t pairs = 0;  // that overlap in X: tests 2 to 6 are for these
  std::uint64_t relations = 0;
  std::uint64_t sides_seen = 0;        // in stripes of a pixel, 1024 x 1024
  std::uint64_t silhouette_sides = 0;  // of the last silhouette
  // Nanoseconds of a view; 0 if not timed.
  double native_ns = 0;
  double stripes_ns = 0;
  double exact_ns = 0;

  // The average number of faces that one face overlaps in X: the paper's Y_complexity.
  [[nodiscard]] double overlapped() const {
    return faces > 0 ? 2 * static_cast<double>(pairs) / static_cast<double>(faces) : 0;
  }
};

struct MontaniReGrowth {
  std::string_view family;  // of generated scenes
  std::vector<MontaniReSize> sizes;
};

// Without times if `rounds` is 0; scenes of 10000 and more are timed once.
[[nodiscard]] MontaniReGrowth montani_re_growth(std::string_view family, std::span<const std::size_t> sizes,
                                                int rounds,
                                                const std::function<void(std::string_view)>& progress);

// The exponent of y = c x^exponent, by least squares of logarithms; 0 for fewer than two points.
[[nodiscard]] double growth_exponent(const std::vector<std::pair<double, double>>& points);

// Of a member of all sizes, over their faces.
template <class Value>
[[nodiscard]] double exponent_over_faces(const MontaniReGrowth& growth, Value MontaniReSize::*value) {
  std::vector<std::pair<double, double>> points;
  for (const MontaniReSize& size : growth.sizes)
    points.emplace_back(static_cast<double>(size.faces), static_cast<double>(size.*value));
  return growth_exponent(points);
}

}  // namespace sightline::harness::report
