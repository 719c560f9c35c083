// What a solid looks like on the screen of the turning machine, exactly: the reference for its pictures.
#pragma once

#include <array>
#include <cstdint>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::turn {

// Radians of an angle of the machine, of which 2^18 are a turn.
[[nodiscard]] double radians(std::uint32_t angle);

class ScreenView {
 public:
  // The scene stands on the axis (stand_on_axis).
  explicit ScreenView(const scene::PolyScene& standing);

  // Looks at the scene as it is turned at this angle. Cameras are whole numbers below 2^15: it is the nearest such direction, some
  // 10^-9 of a radian away, and at most 2^-16 (beside multiples of an eighth of a turn).
  [[nodiscard]] static scene::PolyCamera camera(std::uint32_t angle) { return camera_at(radians(angle)); }
  [[nodiscard]] static scene::PolyCamera camera_at(double turn);  // radians
  // Where a point of the scene, in its own units, is then on the screen, in points of the display.
  [[nodiscard]] std::array<double, 2> place(const std::array<double, 3>& point, std::uint32_t angle) const;

 private:
  double scale_;
  double middle_;
};

}  // namespace sightline::programs::turn
