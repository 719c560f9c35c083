#include "host/guests/turn/screen_view.hpp"

#include <cmath>
#include <numbers>

#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/guests/turn/tape.hpp"

namespace sightline::guests::turn {

double radians(std::uint32_t angle) { return angle * 2 * std::numbers::pi / (1U << 18); }

ScreenView::ScreenView(const scene::PolyScene& standing) {
  const algorithms::plantinga::RotationModel model(standing);
  scale_ = points_per_unit(model);
  middle_ = static_cast<double>(twice_middle(model)) / 2;
}

scene::PolyCamera ScreenView::camera(std::uint32_t angle) {
  constexpr double length = 32767;
  return algorithms::plantinga::camera_of(
      {std::lround(std::sin(radians(angle)) * length), std::lround(std::cos(radians(angle)) * length)});
}

std::array<double, 2> ScreenView::place(const std::array<double, 3>& point, std::uint32_t angle) const {
  constexpr double centre = 512;
  const double turn = radians(angle);
  return {centre + scale_ * (point[0] * std::cos(turn) - point[2] * std::sin(turn)), centre + scale_ * (point[1] - middle_)};
}

}  // namespace sightline::guests::turn
