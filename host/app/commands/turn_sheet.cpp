#include "host/app/commands/turn_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace sightline::app {

TurnSheet::TurnSheet(const scene::PolyScene& scene, int size) : size_(size) {
  double reach = 1;
  double low = 0;
  double high = 0;
  bool first = true;
  for (const scene::PolyPoint& v : scene.vertices) {
    reach = std::max(reach, std::hypot(static_cast<double>(v[0]), static_cast<double>(v[2])));
    low = first ? static_cast<double>(v[1]) : std::min(low, static_cast<double>(v[1]));
    high = first ? static_cast<double>(v[1]) : std::max(high, static_cast<double>(v[1]));
    first = false;
  }
  middle_ = (low + high) / 2;
  scale_ = 0.47 * size / std::max(reach, (high - low) / 2);
}

TurnSheet::TurnSheet(const scene::PolyScene& scene, int size, const registry::EyeCircle& circle) : size_(size) {
  double reach = 1;
  for (const scene::PolyPoint& v : scene.vertices) {
    std::array<double, 3> d{};
    for (std::size_t i = 0; i < 3; ++i) d[i] = static_cast<double>(v[i] - circle.about[i]);
    reach = std::max(reach, std::hypot(d[0], d[1], d[2]));
  }
  const auto eye = std::hypot(static_cast<double>(circle.eye[0]), static_cast<double>(circle.eye[1]), static_cast<double>(circle.eye[2]));
  if (circle.perspective) reach /= std::sqrt(1 - reach * reach / (eye * eye));
  scale_ = 0.47 * size / reach;
}

picture::Image TurnSheet::image_of(const std::vector<registry::TurnLine>& lines) const {
  picture::VectorDrawing drawing;
  drawing.width = size_;
  drawing.height = size_;
  drawing.layers = {{"visible", {0, 0, 0}}};
  for (const registry::TurnLine& line : lines) {
    drawing.lines.push_back({0, static_cast<std::uint32_t>(drawing.points.size()), 2});
    drawing.points.push_back(point(line.u0, line.v0));
    drawing.points.push_back(point(line.u1, line.v1));
  }
  return picture::image_of(drawing, {size_, size_, 1.2});
}

picture::DrawingPoint TurnSheet::point(double u, double v) const {
  return {static_cast<float>(size_ / 2.0 + scale_ * u), static_cast<float>(size_ / 2.0 + scale_ * (v - middle_))};
}

}  // namespace sightline::app
