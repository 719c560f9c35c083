#include "host/picture/line_picture_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "host/geometry/predicates.hpp"
#include "host/geometry/vector.hpp"
#include "host/scene/model/face_cut.hpp"

namespace sightline::picture {
namespace {

using geometry::cross;
using geometry::difference;
using geometry::dot;
using geometry::Int128;
using geometry::Rational;
using geometry::sign;
using geometry::vector_of;
using Vector = geometry::Vector3;

// The value at parameter s of a linear quantity that is a at s = 0 and b at s = 1, times the denominator of s.
Int128 along(std::int64_t a, std::int64_t b, const Rational& s) {
  return Int128{a} * (s.denominator() - s.numerator()) + Int128{b} * s.numerator();
}

ImageRatio reduce(const ImageRatio& ratio) {
  if (ratio.denominator == 0) return ratio;
  const Int128 divisor = geometry::common_divisor(ratio.numerator, ratio.denominator);
  return {ratio.numerator / divisor, ratio.denominator / divisor};
}

// An edge in the camera's frame: right, up and forward of both ends.
struct EdgeImage {
  std::array<Vector, 2> ends;

  EdgeImage(const LineEdge& edge, const scene::PolyScene& scene, const scene::PolyCamera& camera)
      : ends{seen(scene.vertices[edge.from], camera), seen(scene.vertices[edge.to], camera)} {}

  static Vector seen(const scene::PolyPoint& vertex, const scene::PolyCamera& camera) {
    const Vector p = difference(vertex, camera.eye);
    return {dot(vector_of(camera.right), p), dot(vector_of(camera.up), p), dot(vector_of(camera.forward), p)};
  }

  [[nodiscard]] Int128 at(std::size_t axis, const Rational& s) const {
    return along(ends[0][axis], ends[1][axis], s);
  }

  [[nodiscard]] ImageRatio ratio(std::size_t axis, const Rational& s, bool perspective) const {
    const Int128 numerator = at(axis, s);
    const Int128 denominator = perspective ? at(2, s) : Int128{s.denominator()};
    return denominator == 0 ? ImageRatio{sign(numerator), 0} : ImageRatio{numerator, denominator};
  }
};

ImageSegment segment_of(const LinePiece& piece, const scene::PolyScene& scene,
                        const scene::PolyCamera& camera) {
  ImageSegment segment;
  segment.line = in_lowest_terms(image_plane(piece.edge, scene, camera));
  const EdgeImage image(piece.edge, scene, camera);
  const Vector& a = image.ends[0];
  const Vector& b = image.ends[1];
  const bool upright = camera.perspective ? Int128{a[0]} * b[2] == Int128{b[0]} * a[2] : a[0] == b[0];
  const std::size_t axis = upright ? 1 : 0;
  const auto ratio = [&](const Rational& s) { return reduce(image.ratio(axis, s, camera.perspective)); };
  segment.low = ratio(piece.low);
  segment.high = ratio(piece.high);
  if (compare(segment.low, segment.high) > 0) std::swap(segment.low, segment.high);
  return segment;
}

// The image of a point of a crossing, not scaled by lengths; its ends are not points of the grid.
std::array<double, 2> crossing_image(const LineEdge& edge, double s, const scene::PolyScene& scene,
                                     const scene::PolyCamera& camera) {
  const geometry::RealVector from = scene::place_of(scene, edge.from);
  const geometry::RealVector to = scene::place_of(scene, edge.to);
  geometry::RealVector d{};
  for (std::size_t a = 0; a < 3; ++a) d[a] = from[a] + s * (to[a] - from[a]) - camera.eye[a];
  const auto along = [&d](const scene::PolyPoint& axis) { return geometry::dot(geometry::real_vector(axis), d); };
  const double over = camera.perspective ? along(camera.forward) : 1;
  return {along(camera.right) / over, along(camera.up) / over};
}

}  // namespace

std::array<std::int64_t, 4> image_plane(const LineEdge& edge, const scene::PolyScene& scene,
                                        const scene::PolyCamera& camera) {
  const scene::PolyPoint& a = scene.vertices[edge.from];
  const scene::PolyPoint& b = scene.vertices[edge.to];
  const Vector normal = camera.perspective ? cross(difference(a, camera.eye), difference(b, camera.eye))
                                           : cross(difference(b, a), vector_of(camera.forward));
  return {normal[0], normal[1], normal[2], camera.perspective ? 0 : dot(normal, vector_of(a))};
}

ImageRatio image_coordinate(const LineEdge& edge, const Rational& parameter, std::size_t axis, const scene::PolyScene& scene,
                            const scene::PolyCamera& camera) {
  return EdgeImage(edge, scene, camera).ratio(axis, parameter, camera.perspective);
}

int compare(const ImageRatio& a, const ImageRatio& b) {
  if (a.denominator == 0 || b.denominator == 0) {
    const int left = a.denominator == 0 ? sign(a.numerator) : 0;
    const int right = b.denominator == 0 ? sign(b.numerator) : 0;
    return left - right;
  }
  ImageRatio x = a;
  ImageRatio y = b;
  for (int direction = 1;; direction = -direction) {
    const auto floor = [](const ImageRatio& r) {
      const Int128 quotient = r.numerator / r.denominator;
      return quotient * r.denominator > r.numerator ? quotient - 1 : quotient;
    };
    const Int128 p = floor(x);
    const Int128 q = floor(y);
    if (p != q) return p < q ? -direction : direction;
    x.numerator -= p * x.denominator;
    y.numerator -= q * y.denominator;
    if (x.numerator == 0 || y.numerator == 0) return direction * (sign(x.numerator) - sign(y.numerator));
    std::swap(x.numerator, x.denominator);
    std::swap(y.numerator, y.denominator);
  }
}

ImageSet image_set(const LinePicture& picture, const scene::PolyScene& scene,
                   const scene::PolyCamera& camera) {
  std::vector<ImageSegment> segments;
  for (const LinePiece& piece : picture.pieces) {
    const ImageSegment segment = segment_of(piece, scene, camera);
    if (compare(segment.low, segment.high) != 0) segments.push_back(segment);
  }
  std::sort(segments.begin(), segments.end(), [](const ImageSegment& a, const ImageSegment& b) {
    return a.line != b.line ? a.line < b.line : compare(a.low, b.low) < 0;
  });
  ImageSet set;
  for (const ImageSegment& segment : segments) {
    if (!set.segments.empty() && set.segments.back().line == segment.line &&
        compare(segment.low, set.segments.back().high) <= 0) {
      ImageSegment& last = set.segments.back();
      if (compare(last.high, segment.high) < 0) last.high = segment.high;
    } else {
      set.segments.push_back(segment);
    }
  }
  return set;
}

double image_length(const LinePicture& picture, const scene::PolyScene& scene,
                    const scene::PolyCamera& camera) {
  const auto length = [](const scene::PolyPoint& v) {
    return std::sqrt(static_cast<double>(dot(vector_of(v), vector_of(v))));
  };
  const double focal = camera.perspective ? length(camera.forward) : 1;
  const std::array<double, 2> scale{focal / length(camera.right), focal / length(camera.up)};
  double total = 0;
  for (const LinePiece& piece : picture.pieces) {
    if (scene::crossing_at(scene, piece.edge.from) != nullptr) {
      const std::array<double, 2> from = crossing_image(piece.edge, piece.low.to_double(), scene, camera);
      const std::array<double, 2> to = crossing_image(piece.edge, piece.high.to_double(), scene, camera);
      total += std::hypot((to[0] - from[0]) * scale[0], (to[1] - from[1]) * scale[1]);
      continue;
    }
    const EdgeImage image(piece.edge, scene, camera);
    const auto coordinate = [&](std::size_t axis, const Rational& s) {
      const Int128 over = camera.perspective ? image.at(2, s) : Int128{s.denominator()};
      return static_cast<double>(image.at(axis, s)) / static_cast<double>(over) * scale[axis];
    };
    total += std::hypot(coordinate(0, piece.high) - coordinate(0, piece.low),
                        coordinate(1, piece.high) - coordinate(1, piece.low));
  }
  return total;
}

}  // namespace sightline::picture
