// How the work of a view grows with the scene: Montani and Re's algorithm, exact and in stripes of a pixel,
// and `exact`, beside what their paper counts: faces, and pairs of faces that overlap in X.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "host/report/records.hpp"

namespace sightline::report {

// The exponent of y = c x^exponent, by least squares of logarithms; 0 for fewer than two points.
[[nodiscard]] double growth_exponent(const std::vector<std::pair<double, double>>& points);
// Of `key` over the key `over` in some rows; values that are missing or 0 are left out, and none is there of
// fewer than `fewest` others.
[[nodiscard]] Value growth_exponent(const RowSet& rows, std::size_t from, std::size_t to,
                                    std::string_view key, std::string_view over, std::size_t fewest = 3);

// Generated scenes of one family and these sizes: a row each is added to "views", and one of exponents to
// "exponents". Times are missing if `rounds` is 0; scenes of 10000 and more are timed once.
void add_montani_re_growth(Records& records, std::string_view family, std::span<const std::size_t> sizes,
                           int rounds, const std::function<void(std::string_view)>& progress);

}  // namespace sightline::report
