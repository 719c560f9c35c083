// The exact image of a solid on the screen of the turn program: the reference for its pictures.
#pragma once

#include <array>
#include <cstdint>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::turn {

// An angle of the machine, with 2^18 to a turn, in radians.
[[nodiscard]] double radians(std::uint32_t angle);

class ScreenView {
 public:
  // The scene must stand on the axis (stand_on_axis).
  explicit ScreenView(const scene::PolyScene& standing);

  // A camera that looks at the scene turned by this angle. Cameras are whole numbers below 2^15, so this is the nearest
  // such direction: usually about 10^-9 of a radian away, at most 2^-16 (near multiples of an eighth of a turn).
  [[nodiscard]] static scene::PolyCamera camera(std::uint32_t angle) { return camera_at(radians(angle)); }
  [[nodiscard]] static scene::PolyCamera camera_at(double turn);  // radians
  // The position on the screen, in points of the display, of a point of the scene in the scene's units.
  [[nodiscard]] std::array<double, 2> place(const std::array<double, 3>& point, std::uint32_t angle) const;

 private:
  double scale_;
  double middle_;
};

}  // namespace sightline::programs::turn
