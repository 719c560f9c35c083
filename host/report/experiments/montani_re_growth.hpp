// How the work of a view grows with the scene: Montani and Re's algorithm, exact and in stripes of a pixel, and
// `exact`, with the quantities that their paper counts: faces, and pairs of faces that overlap in X.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// A generated scene from its own camera, in perspective, on 1024 x 1024 pixels. Times of this computer are empty
// without Context::host_times.
struct GrowthView {
  std::string family;
  std::size_t size = 0;
  std::size_t faces = 0;  // faces that take part: not turned away, not edge-on
  double y_complexity = 0;
  std::uint64_t pairs = 0;  // pairs that overlap in X, which tests 2 to 6 decide
  std::uint64_t relations = 0;
  std::uint64_t sides_seen = 0;  // in stripes of a pixel
  std::uint64_t silhouette_sides = 0;
  std::optional<double> exact_build_ms = {};
  std::optional<double> stripes_ms = {};
  std::optional<double> exact_ms = {};
};

// Growth exponents of the views of a family: over faces, and of one time over pairs.
struct GrowthExponents {
  std::string family;
  std::size_t from_faces = 0;
  std::size_t to_faces = 0;
  std::optional<double> pairs = {};
  std::optional<double> relations = {};
  std::optional<double> exact_build = {};
  std::optional<double> stripes = {};
  std::optional<double> exact = {};
  std::optional<double> exact_build_over_pairs = {};
};

struct MontaniReGrowth {
  std::vector<GrowthView> views;
  std::vector<GrowthExponents> exponents;
};

[[nodiscard]] MontaniReGrowth montani_re_growth(const Context& context);

// The exponent of y = c x^exponent, by least squares of logarithms. Points with y = 0 are left out. Empty if fewer
// than `fewest` points remain.
[[nodiscard]] std::optional<double> growth_exponent(const std::vector<std::pair<double, double>>& points, std::size_t fewest);

class Page;
struct MontaniReTables;
void montani_re_timing(Page& page, const MontaniReGrowth& growth, const MontaniReTables& tables);

}  // namespace sightline::report
