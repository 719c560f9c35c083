// The points that a Type 340 lights for a display file of Jones's program: decoded from its words alone, every vector by
// the rate multiplier pulse by pulse. The start of a vector is dark; every pulse from the first step on flashes.
#pragma once

#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/word.hpp"
#include "emulators/type340/vector_generator.hpp"
#include "host/programs/jones/twin/arithmetic.hpp"

namespace sightline::programs::jones {

inline void add_vector_points(core::Word18 word, ScreenPoint& beam, std::vector<ScreenPoint>& points) {
  const auto dy = static_cast<std::uint8_t>(word.field(3, 9)),
             dx = static_cast<std::uint8_t>(word.field(11, 17));
  type340::RateMultiplier multiplier;
  bool moved = false;
  for (int pulse = 0; pulse < type340::pulses_of_vector(dx, dy); ++pulse) {
    const auto step = multiplier.count(dx, dy);
    if (step.x) beam.x += word.bit(10) ? -1 : 1;
    if (step.y) beam.y += word.bit(2) ? -1 : 1;
    moved = moved || step.x || step.y;
    if (moved && word.bit(1)) points.push_back(beam);
  }
}

inline std::vector<ScreenPoint> drawn_points(const std::vector<core::Word18>& words) {
  enum : std::uint32_t { parameter = 0, point = 1, vector = 4 };
  std::vector<ScreenPoint> points;
  ScreenPoint beam;
  std::uint32_t mode = parameter;
  for (const core::Word18 word : words) {
    if (mode == vector) {
      add_vector_points(word, beam, points);
      if (word.bit(0)) mode = parameter;
      continue;
    }
    if (mode == parameter && word.bit(7)) break;
    if (mode == point) {
      (word.bit(1) ? beam.y : beam.x) = static_cast<std::int32_t>(word.field(8, 17));
      if (word.bit(7)) points.push_back(beam);
    }
    mode = word.field(2, 4);
  }
  return points;
}

inline std::vector<ScreenPoint> points_of(const std::vector<core::Stroke>& strokes) {
  std::vector<ScreenPoint> points;
  for (const core::Stroke& stroke : strokes) points.push_back({stroke.x, stroke.y});
  return points;
}

}  // namespace sightline::programs::jones
