#include "host/algorithms/willis/spans.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "host/geometry/vector.hpp"
#include "host/picture/camera_view.hpp"

namespace sightline::algorithms::willis {

namespace {

constexpr double overlap = 1e-6;  // of pieces of a face, in points
constexpr double nearest = 1e-3;  // scene units in front of the eye, where surfaces are clipped

using SpaceVector = geometry::RealVector;

struct ImagePoint {
  double x = 0;
  double y = 0;
};

// Right, up and forward distance of a point from the eye.
class Eye {
 public:
  explicit Eye(const scene::PolyCamera& camera) : perspective_(camera.perspective), eye_(geometry::real_vector(camera.eye)) {
    const picture::CameraView view(camera);
    axes_ = {view.axis(0), view.axis(1), view.axis(2)};
  }

  [[nodiscard]] SpaceVector seen(const SpaceVector& p) const {
    const SpaceVector d = geometry::difference(p, eye_);
    return {geometry::dot(axes_[0], d), geometry::dot(axes_[1], d), geometry::dot(axes_[2], d)};
  }
  [[nodiscard]] bool perspective() const { return perspective_; }
  [[nodiscard]] ImagePoint image(const SpaceVector& seen) const {
    const double depth = perspective_ ? seen[2] : 1;
    return {seen[0] / depth, seen[1] / depth};
  }

 private:
  bool perspective_;
  SpaceVector eye_;
  std::array<SpaceVector, 3> axes_{};
};

SpaceVector in_scene(const Point& p) {
  return {static_cast<double>(p[0]) / lattice_unit, static_cast<double>(p[1]) / lattice_unit,
          static_cast<double>(p[2]) / lattice_unit};
}

class SpanMaker {
 public:
  SpanMaker(const Model& model, const scene::PolyCamera& camera, const ImageWindow& window, FrameSpans& frame)
      : model_(model), eye_(camera), window_(window), frame_(frame) {}

  void add(std::uint32_t piece, std::uint32_t priority) {
    outline(model_.pieces[piece]);
    if (image_.size() < 3) return;
    const auto [low, high] = std::minmax_element(
        image_.begin(), image_.end(), [](const ImagePoint& a, const ImagePoint& b) { return a.y < b.y; });
    const int first = line_from(low->y, window_.height);
    const int last = line_from(high->y + 2 * overlap, window_.height);  // exclusive
    if (first >= last) return;
    const auto first_span = static_cast<std::uint32_t>(frame_.spans.size());
    bool any = false;
    for (int line = first; line < last; ++line) {
      const Span span = span_at(std::clamp(line + 0.5, low->y, high->y));
      any |= span.from < span.to;
      frame_.spans.push_back(span);
    }
    if (!any) {
      frame_.spans.resize(first_span);
      return;
    }
    frame_.surfaces.push_back({piece, model_.pieces[piece].face, priority, static_cast<std::uint32_t>(first),
                               first_span, static_cast<std::uint32_t>(last - first)});
  }

 private:
  // The first line or column whose point is at or after `at`, minus the overlap.
  static int line_from(double at, int size) {
    return static_cast<int>(std::clamp(std::ceil(at - 0.5 - overlap), 0.0, static_cast<double>(size)));
  }

  // The outline in points of the picture, without the part behind the eye.
  void outline(const Surface& s) {
    corners_.clear();
    if (model_.plan) {
      for (const auto& [end, height] : {std::pair{0, s.low}, {1, s.low}, {1, s.high}, {0, s.high}}) {
        SpaceVector corner = in_scene(s.points[static_cast<std::size_t>(end)]);
        corner[model_.vertical] = height;
        corners_.push_back(eye_.seen(corner));
      }
    } else {
      for (const Point& p : s.points) corners_.push_back(eye_.seen(in_scene(p)));
    }
    image_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const SpaceVector& p = corners_[i];
      const SpaceVector& q = corners_[(i + 1) % corners_.size()];
      if (!eye_.perspective() || p[2] >= nearest) put(p);
      if (eye_.perspective() && (p[2] < nearest) != (q[2] < nearest)) put(clipped(p, q));
    }
  }

  // Gives the same point for both directions of an edge.
  static SpaceVector clipped(const SpaceVector& p, const SpaceVector& q) {
    const SpaceVector& a = p[2] < q[2] ? p : q;
    const SpaceVector& b = p[2] < q[2] ? q : p;
    const double t = (nearest - a[2]) / (b[2] - a[2]);
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), nearest};
  }

  void put(const SpaceVector& seen) {
    const ImagePoint p = eye_.image(seen);
    image_.push_back({window_.left + window_.scale * p.x, window_.top - window_.scale * p.y});
  }

  [[nodiscard]] Span span_at(double y) const {
    double left = static_cast<double>(window_.width) + 1;
    double right = -1;
    for (std::size_t i = 0; i < image_.size(); ++i) {
      const ImagePoint& p = image_[i];
      const ImagePoint& q = image_[i + 1 == image_.size() ? 0 : i + 1];
      if ((y < p.y && y < q.y) || (y > p.y && y > q.y)) continue;
      double x = p.x;
      if (p.y != q.y) x += (q.x - p.x) * ((y - p.y) / (q.y - p.y));
      left = std::min(left, x);
      right = std::max(right, x);
      if (p.y == q.y) {
        left = std::min(left, q.x);
        right = std::max(right, q.x);
      }
    }
    const int from = line_from(left, window_.width);
    const int to = line_from(right + 2 * overlap, window_.width);
    return {static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(std::max(from, to))};
  }

  const Model& model_;
  Eye eye_;
  const ImageWindow& window_;
  FrameSpans& frame_;
  std::vector<SpaceVector> corners_;
  std::vector<ImagePoint> image_;
};

}  // namespace

ImageWindow window_ahead(const scene::PolyCamera& camera, int width, int height, double extent) {
  const double across = camera.perspective ? 2 * std::tan(extent / 2 * (std::numbers::pi / 180)) : extent;
  return {width, height, std::min(width, height) / across, width / 2.0, height / 2.0};
}

ImageWindow window_around(const scene::PolyScene& scene, const scene::PolyCamera& camera, int width,
                          int height) {
  const Eye eye(camera);
  std::array<double, 2> low{1, 1};
  std::array<double, 2> high{-1, -1};
  bool any = false;
  for (const scene::PolyPoint& p : scene.vertices) {
    const SpaceVector seen = eye.seen(in_scene(on_lattice(p)));
    if (camera.perspective && seen[2] < nearest) continue;
    const ImagePoint image = eye.image(seen);
    const std::array<double, 2> at{image.x, image.y};
    for (std::size_t a = 0; a < 2; ++a) {
      const double kept = camera.perspective ? std::clamp(at[a], -1.0, 1.0) : at[a];
      low[a] = any ? std::min(low[a], kept) : kept;
      high[a] = any ? std::max(high[a], kept) : kept;
    }
    any = true;
  }
  if (!any) return window_ahead(camera, width, height, camera.perspective ? 90 : 1);
  constexpr double margin = 0.96;
  const auto fit = [&](int size, std::size_t a) { return margin * size / std::max(high[a] - low[a], 1e-9); };
  const double scale = std::min(fit(width, 0), fit(height, 1));
  return {width, height, scale, width / 2.0 - scale * (low[0] + high[0]) / 2,
          height / 2.0 + scale * (low[1] + high[1]) / 2};
}

void make_spans(const Model& model, std::span<const std::uint32_t> order, const scene::PolyCamera& camera,
                const ImageWindow& window, FrameSpans& frame) {
  frame.surfaces.clear();
  frame.spans.clear();
  SpanMaker maker(model, camera, window, frame);
  for (std::size_t i = 0; i < order.size(); ++i) maker.add(order[i], static_cast<std::uint32_t>(i + 1));
}

picture::PixelGrid resolve_priorities(const FrameSpans& frame, const ImageWindow& window) {
  picture::PixelGrid faces(window.width, window.height);
  // Later surfaces have higher priority.
  for (const SurfaceSpans& surface : frame.surfaces) {
    for (std::uint32_t i = 0; i < surface.line_count; ++i) {
      const Span& span = frame.spans[surface.first_span + i];
      const int row = window.height - 1 - static_cast<int>(surface.first_line + i);
      const auto begin = faces.values.begin() + static_cast<std::ptrdiff_t>(faces.index(0, row));
      std::fill(begin + span.from, begin + span.to, surface.face + 1);
    }
  }
  return faces;
}

picture::PixelGrid outlines(const picture::PixelGrid& faces) {
  picture::PixelGrid lines(faces.width, faces.height);
  for (int row = 0; row < faces.height; ++row) {
    for (int column = 0; column < faces.width; ++column) {
      const std::uint32_t here = faces.at(column, row);
      const bool change =
          (column > 0 && faces.at(column - 1, row) != here) || (row > 0 && faces.at(column, row - 1) != here);
      if (change) lines.set(column, row, 1);
    }
  }
  return lines;
}

}  // namespace sightline::algorithms::willis
