#include "host/scene/heights/surface_net.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace sightline::scene {
namespace {

bool is_finite(const std::array<double, 3>& vertex) {
  return std::all_of(vertex.begin(), vertex.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

std::array<Interval, 3> SurfaceNet::ranges() const {
  std::array<Interval, 3> ranges{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const auto& vertex : vertices)
      if (is_finite(vertex)) values.push_back(vertex[axis]);
    ranges[axis] = finite_range(values);
  }
  return ranges;
}

SurfaceNet thinned(const SurfaceNet& net, std::size_t step) {
  const std::size_t across = std::clamp<std::size_t>(step, 1, net.points - 1);
  const std::size_t along = std::clamp<std::size_t>(step, 1, net.curves - 1);
  SurfaceNet result{(net.points - 1) / across + 1, (net.curves - 1) / along + 1, {}, net.names, net.note};
  for (std::size_t curve = 0; curve < net.curves; curve += along)
    for (std::size_t point = 0; point < net.points; point += across)
      result.vertices.push_back(net.vertices[curve * net.points + point]);
  return result;
}

PolyMesh mesh_of(const SurfaceNet& net, const std::array<double, 3>& halves, std::string_view source) {
  PolyMesh mesh;
  mesh.source = source;
  mesh.name = source;
  mesh.vertical = 1;
  // Scaled doubles: so coarse that the ends of a closed curve, which differ by rounding, are one.
  mesh.precision = 1e-9;
  const std::array<Interval, 3> ranges = net.ranges();
  constexpr std::uint32_t hole = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(net.vertices.size(), hole);
  for (std::size_t i = 0; i < net.vertices.size(); ++i) {
    if (!is_finite(net.vertices[i])) continue;
    number[i] = static_cast<std::uint32_t>(mesh.vertices.size());
    std::array<double, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Interval range = ranges[axis];
      const double half = range.high / 2 - range.low / 2;
      const double middle = range.high / 2 + range.low / 2;
      place[axis] = half >= std::numeric_limits<double>::min() ? (net.vertices[i][axis] - middle) / half * halves[axis] : 0;
    }
    mesh.vertices.push_back({place[0], place[2], place[1]});
  }
  PolyBody sheet;
  const auto add_triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& v = mesh.vertices;
    // A closed net has cells without area, at a pole for instance.
    if (a != hole && b != hole && c != hole && v[a] != v[b] && v[b] != v[c] && v[c] != v[a])
      sheet.faces.push_back({{a, b, c}, {}});
  };
  const auto add_wire = [&](std::uint32_t a, std::uint32_t b) {
    if (a != hole && b != hole && mesh.vertices[a] != mesh.vertices[b]) mesh.wires.push_back({a, b});
  };
  for (std::size_t curve = 0; curve < net.curves; ++curve) {
    for (std::size_t point = 0; point < net.points; ++point) {
      const std::size_t at = curve * net.points + point;
      const bool right = point + 1 < net.points;
      const bool behind = curve + 1 < net.curves;
      if (right) add_wire(number[at], number[at + 1]);
      if (behind) add_wire(number[at], number[at + net.points]);
      if (!right || !behind) continue;
      add_triangle(number[at], number[at + 1], number[at + net.points + 1]);
      add_triangle(number[at], number[at + net.points + 1], number[at + net.points]);
    }
  }
  mesh.bodies.push_back(std::move(sheet));
  return mesh;
}

}  // namespace sightline::scene
