// What the plots of speed against error have in common.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "host/report/plot.hpp"

namespace sightline::harness::report {

inline constexpr std::string_view emulated_title = "time on the emulated machine";
inline constexpr std::string_view host_title = "time on this computer";

// "L_sym" of "wrong length, L_sym": plots of one thing by several measures have titles of their own.
[[nodiscard]] inline std::string_view symbol_of(std::string_view measure_title) {
  const std::size_t comma = measure_title.rfind(", ");
  return comma == std::string_view::npos ? measure_title : measure_title.substr(comma + 2);
}

// Adds the figure; the error, if it could not be drawn.
[[nodiscard]] inline std::optional<ReportError> add_figure(std::vector<Block>& blocks, const Plot& plot) {
  auto figure = draw_plot(plot);
  if (!figure) return std::move(figure.error());
  blocks.emplace_back(std::move(*figure));
  return std::nullopt;
}

}  // namespace sightline::harness::report
