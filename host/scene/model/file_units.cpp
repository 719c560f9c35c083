// See file_units.hpp.
#include "host/scene/model/file_units.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/number.hpp"

namespace sightline::scene {

double steps_in_file(std::int64_t n, double step) {
  // Division by 1000 rounds once, multiplication by 0.001 twice.
  const double inverse = std::round(1 / step);
  const bool part_of_one = step < 1 && inverse < 1e15 && 1 / inverse == step;
  return part_of_one ? static_cast<double>(n) / inverse : static_cast<double>(n) * step;
}

double file_coordinate(const PolyScene& scene, const PolyPoint& p, std::size_t axis) {
  return steps_in_file(std::int64_t{p[axis]} + scene.origin[axis], scene.step);
}

std::array<double, 3> file_point(const PolyScene& scene, const PolyPoint& p) {
  return {file_coordinate(scene, p, 0), file_coordinate(scene, p, 1), file_coordinate(scene, p, 2)};
}

std::string file_point_text(const PolyScene& scene, const PolyPoint& p) {
  std::string text;
  for (std::size_t a = 0; a < 3; ++a) {
    if (a > 0) text += ',';
    text += base::shortest_number(file_coordinate(scene, p, a));
  }
  return text;
}

std::optional<PolyPoint> grid_point(const PolyScene& scene, const std::array<double, 3>& in_file) {
  PolyPoint p{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double steps = std::round(in_file[a] / scene.step) - static_cast<double>(scene.origin[a]);
    if (!(std::abs(steps) < poly_coordinate_limit)) return std::nullopt;
    p[a] = static_cast<std::int32_t>(steps);
  }
  return p;
}

double millimetres(std::string_view unit) {
  struct Unit {
    std::string_view name;
    double millimetres;
  };
  constexpr std::array units{Unit{"um", 0.001}, Unit{"mm", 1}, Unit{"cm", 10}, Unit{"m", 1000}, Unit{"inch", 25.4}, Unit{"ft", 304.8}};
  const auto found = std::find_if(units.begin(), units.end(), [unit](const Unit& each) { return each.name == unit; });
  return found == units.end() ? 1 : found->millimetres;
}

}  // namespace sightline::scene
