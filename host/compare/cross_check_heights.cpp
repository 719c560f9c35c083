// Functions of two variables among the common scenes. See cross_check_scenes.hpp.
//
// With X, Z odd from -31 to 31, D = 7 X + 24 Z and a height k of -3720 .. 3720, a point's place on the screen
// is 40 (24 X - 7 Z) and c k + 8 s D, its depth 8 c D - s k, s and c the sine and cosine of the elevation in
// fifths: 31000 times Skala's projection of x = X / 31, z = Z / 31, h = k / 3720, in whole numbers.
#include <cmath>
#include <numbers>

#include "host/compare/cross_check_scenes.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::compare {
namespace {

constexpr std::size_t side = 32;
constexpr double highest = 3720;

double degrees(double sine) {
  return std::asin(sine) * 180 / std::numbers::pi;
}

// Heights to whole numbers between -highest and highest.
void quantise(scene::HeightGrid& grid) {
  const scene::Interval range = scene::finite_range(grid.heights);
  for (double& h : grid.heights) {
    const double part = (h - range.low) / (range.high - range.low);
    h = std::floor(highest * (2 * part - 1) + 0.5);
  }
  grid.range = {-highest, highest};
}

}  // namespace

CommonScene height_scene(std::string_view name, std::string_view title, std::string_view function,
                         std::int32_t sine, std::int32_t cosine) {
  scene::HeightGrid grid = sample(*scene::height_function(function), {side, side});
  quantise(grid);
  CommonScene common{name, title, {}, {}, false, {}, {}};
  scene::PolyScene& scene = common.scene;
  scene.name = function;
  const auto odd = [](std::size_t i) { return 2 * static_cast<std::int32_t>(i) - 31; };
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      const std::int32_t d = 7 * odd(i) + 24 * odd(j);
      const auto k = static_cast<std::int32_t>(grid.height(i, j));
      scene.vertices.push_back(
          {40 * (24 * odd(i) - 7 * odd(j)), cosine * k + 8 * sine * d, 8 * cosine * d - sine * k});
    }
  }
  scene::PolyBody body{"surface", true, {}};
  for (std::size_t j = 0; j + 1 < side; ++j) {
    for (std::size_t i = 0; i + 1 < side; ++i) {
      // Divided between the corners at the sides, as Skala's cells are: one triangle is before the other.
      const auto near = static_cast<scene::VertexIndex>(j * side + i);
      const scene::VertexIndex beside = near + 1;
      const scene::VertexIndex behind = near + side;
      body.faces.push_back({{near, beside, behind}, {}});
      body.faces.push_back({{beside, behind + 1, behind}, {}});
    }
  }
  scene.bodies.push_back(std::move(body));
  common.views = {parallel_view(scene, 0, 1, 1, 512)};
  scene.camera = common.views[0].camera;
  common.heights = std::move(grid);
  common.height_view.subject = algorithms::skala::Subject::surface;
  common.height_view.rotation = -degrees(7.0 / 25);
  common.height_view.elevation = degrees(sine / 5.0);
  return common;
}

}  // namespace sightline::compare
