// The common part of the incremental plotters: a position counted in steps, and the mark that the pen makes there.
//
// A Stroke holds coordinates of 0 to 65535; a position outside cannot be drawn, and the plotter counts it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "../core/stroke.hpp"
#include "../core/time.hpp"

namespace sightline::devices {

struct PlotterPlace {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend constexpr bool operator==(const PlotterPlace&, const PlotterPlace&) = default;
};

// One step along an unlimited axis; the count saturates.
[[nodiscard]] constexpr std::int32_t step_coordinate(std::int32_t from, std::int32_t by) {
  using Range = std::numeric_limits<std::int32_t>;
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(std::int64_t{from} + by, Range::min(), Range::max()));
}

// Draws the mark at `place`. Returns false if a Stroke cannot hold it.
inline bool mark(core::StrokeBuffer& strokes, PlotterPlace place, core::Instant when) {
  constexpr std::int32_t largest = 0xFFFF;
  if (place.x < 0 || place.x > largest || place.y < 0 || place.y > largest) return false;
  if (strokes.wanted())
    strokes.put({when, static_cast<std::uint16_t>(place.x), static_cast<std::uint16_t>(place.y), 7, 0});
  return true;
}

}  // namespace sightline::devices
