// The step to which a file's coordinates are rounded: rules in poly_import.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

struct Quantisation {
  bool as_it_is = false;  // integers: step 1
  double step = 1;        // a power of two, or of ten below 1
  PolyOrigin origin{};

  // n steps in the file's unit, the nearest double.
  [[nodiscard]] double value_of(std::int64_t n) const;
};

// The values are finite. An eye, in the unit of the file, is given a place within the limit. With `jobs` threads; the result is the
// same for any number.
[[nodiscard]] Quantisation quantisation_of(const std::vector<std::array<double, 3>>& vertices,
                                           const std::optional<std::array<double, 3>>& eye = {}, unsigned jobs = 1);

// The nearest multiple of the step (halves away from 0), less the origin: exact, as the multiples have 53 bits at
// most. Below poly_coordinate_limit for every value that quantisation_of has seen.
[[nodiscard]] std::int32_t quantised(double value, const Quantisation& quantisation, std::size_t axis);

}  // namespace sightline::scene
