#include "host/programs/turn/screen_view.hpp"

#include <cmath>
#include <numbers>

#include "host/algorithms/plantinga/rotation_model.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/programs/turn/tape.hpp"

namespace sightline::programs::turn {

double radians(std::uint32_t angle) { return angle * 2 * std::numbers::pi / (1U << 18); }

ScreenView::ScreenView(const scene::PolyScene& standing) {
  const algorithms::plantinga::RotationModel model(standing);
  scale_ = points_per_unit(model);
  middle_ = static_cast<double>(twice_middle(model)) / 2;
}

namespace {

// The fraction nearest to r, 0 to 1, with a denominator below 2^15: the better of the last convergent with such a
// denominator and the mediant before the next one.
std::array<std::int64_t, 2> nearest_fraction(double r) {
  constexpr std::int64_t most = 32767;
  constexpr std::int64_t one = std::int64_t{1} << 52;
  std::int64_t n = std::llround(r * static_cast<double>(one));
  std::int64_t d = one;
  std::array<std::int64_t, 2> before{0, 1};
  std::array<std::int64_t, 2> last{1, 0};
  while (d != 0) {
    const std::int64_t whole = n / d;
    if (before[1] + whole * last[1] > most) {
      const std::int64_t times = (most - before[1]) / last[1];
      const std::array<std::int64_t, 2> mediant{before[0] + times * last[0], before[1] + times * last[1]};
      const auto distance = [r](const std::array<std::int64_t, 2>& f) {
        return std::abs(static_cast<double>(f[0]) / static_cast<double>(f[1]) - r);
      };
      return distance(mediant) < distance(last) ? mediant : last;
    }
    const std::array<std::int64_t, 2> next{before[0] + whole * last[0], before[1] + whole * last[1]};
    before = last;
    last = next;
    const std::int64_t rest = n - whole * d;
    n = d;
    d = rest;
  }
  return last;
}

}  // namespace

scene::PolyCamera ScreenView::camera_at(double turn) {
  const double x = std::sin(turn);
  const double z = std::cos(turn);
  const bool steep = std::abs(x) > std::abs(z);
  const auto [small, large] = nearest_fraction(steep ? std::abs(z / x) : std::abs(x / z));
  const std::int64_t across = steep ? large : small;
  const std::int64_t along = steep ? small : large;
  return algorithms::plantinga::camera_of({x < 0 ? -across : across, z < 0 ? -along : along});
}

std::array<double, 2> ScreenView::place(const std::array<double, 3>& point, std::uint32_t angle) const {
  constexpr double centre = 512;
  const double turn = radians(angle);
  return {centre + scale_ * (point[0] * std::cos(turn) - point[2] * std::sin(turn)), centre + scale_ * (point[1] - middle_)};
}

}  // namespace sightline::programs::turn
