#include "host/algorithms/plantinga/circle_structure.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "host/algorithms/plantinga/near_vector.hpp"
#include "host/algorithms/plantinga/structure_from_scratch.hpp"

namespace sightline::algorithms::plantinga {
namespace {

using geometry::Int128;
using Wide3 = std::array<Int128, 3>;

// The view from a place of the circle, for FromScratch.
//
// With e(P) the vector from P to the eye, the side of a corner P of the line of AB is the sign of (P - A) . (e(A) x (B - A)),
// and the value at A of the line through P and Q is (A - P) . (e(P) x (Q - P)). Sizes, with coordinates below 2^18 and D as in
// eye_circle.hpp: e is below 2^23 D, e(A) x (B - A) below 2^43 D, a value below 2^64 D, and D at most 2^61.
//
// Signs are found in doubles where these are certain.
class CircleView {
 public:
  using Number = Int128;

  CircleView(const EyeCircle& circle, const CirclePlace& place) : circle_(circle), eye_(eye_at(circle, place)) {
    for (std::size_t i = 0; i < 3; ++i) near_turned_[i] = static_cast<double>(eye_.turned[i]);
    near_weight_ = static_cast<double>(eye_.weight);
    eye_size_ = 4 * size_of(near_turned_);  // in perspective, all vertices are nearer to `about` than the eye
  }

  static Int128 depth(std::int64_t n) { return n; }
  static int compare(Int128 p, Int128 q, Int128 r, Int128 s) {
    const double x = static_cast<double>(p) / static_cast<double>(q);
    const double y = static_cast<double>(r) / static_cast<double>(s);
    if (std::abs(x - y) > certain * (std::abs(x) + std::abs(y))) return x < y ? -1 : 1;
    using Wide = geometry::WideInteger<126>;
    return (Wide(p) * Wide(s) - Wide(r) * Wide(q)).sign();
  }

  [[nodiscard]] int facing(const RotatedFace& face, const Vector3& corner) const {
    const Near3 near = near_to_eye(corner);
    const Near3 normal = near_of(face.normal);
    const double value = plantinga::dot(normal, near);
    const double size = (std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2])) * eye_size_;
    if (std::abs(value) > certain * size) return value > 0 ? 1 : -1;
    return geometry::sign(dot(face.normal, to_eye(corner)));
  }

  bool set_edge(const Vector3& a, const Vector3& b) {
    a_ = &a;
    b_ = &b;
    plane_ = cross(to_eye(a), minus(b, a));
    for (std::size_t i = 0; i < 3; ++i) near_plane_[i] = static_cast<double>(plane_[i]);
    plane_size_ = size_of(near_plane_);
    return plane_[0] != 0 || plane_[1] != 0 || plane_[2] != 0;
  }
  void set_corner_count(std::size_t) {}
  int side(std::size_t, const Vector3& p) const {
    const Vector3 d = minus(p, *a_);
    const Near3 near = near_of(d);
    const double value = plantinga::dot(near, near_plane_);
    // The plane's parts are exact but for their rounding to doubles.
    if (std::abs(value) > certain * (std::abs(near[0]) + std::abs(near[1]) + std::abs(near[2])) * plane_size_)
      return value > 0 ? 1 : -1;
    return geometry::sign(dot(d, plane_));
  }
  // Whether the plane of the edge and the corner contains the whole circle of the eye.
  [[nodiscard]] bool stays(const Vector3& corner) const {
    return form_of(circle_, geometry::cross(minus(*b_, *a_), minus(corner, *a_)), *a_).size() == 0;
  }
  [[nodiscard]] std::pair<Int128, Int128> values(std::size_t, const Vector3& p, std::size_t, const Vector3& q) const {
    const Wide3 plane = cross(to_eye(p), minus(q, p));
    return {dot(minus(*a_, p), plane), dot(minus(*b_, p), plane)};
  }

 private:
  static constexpr double certain = 0x1p-44;

  static double size_of(const Near3& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }
  static Int128 dot(const Vector3& a, const Wide3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Wide3 cross(const Wide3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  [[nodiscard]] Wide3 to_eye(const Vector3& p) const {
    Wide3 e = eye_.turned;
    if (eye_.weight != 0) {
      for (std::size_t i = 0; i < 3; ++i) e[i] += Int128{eye_.weight} * (circle_.about[i] - p[i]);
    }
    return e;
  }
  // Each part within 2^-51 eye_size_.
  [[nodiscard]] Near3 near_to_eye(const Vector3& p) const {
    Near3 e = near_turned_;
    for (std::size_t i = 0; i < 3; ++i) e[i] += near_weight_ * static_cast<double>(circle_.about[i] - p[i]);
    return e;
  }

  const EyeCircle& circle_;
  ExactEye eye_;
  Near3 near_turned_{};
  double near_weight_ = 0;
  double eye_size_ = 0;
  const Vector3* a_ = nullptr;
  const Vector3* b_ = nullptr;
  Wide3 plane_{};
  Near3 near_plane_{};
  double plane_size_ = 0;
};

using CircleScratch = FromScratch<CircleView>;

// The quotient of two numbers, in lowest terms.
geometry::Rational rational(Int128 part, Int128 whole) {
  const Int128 divisor = geometry::common_divisor(part, whole);
  part /= divisor;
  whole /= divisor;
  assert(geometry::magnitude(part) >> 63 == 0 && geometry::magnitude(whole) >> 63 == 0);
  return {static_cast<std::int64_t>(part), static_cast<std::int64_t>(whole)};
}

geometry::Rational parameter_of(const RotationModel& model, const CircleView& view, EdgeIndex edge, const End& end) {
  const Segment e = model.segment(edge);
  const auto crossing = [&](const Vector3& p, const Vector3& q) {
    const auto [a, b] = view.values(0, p, 0, q);
    return std::pair{a, Int128{a - b}};
  };
  switch (end.kind()) {
    case EndKind::vertex: return end.index() == model.edges()[edge].from ? 0 : 1;
    case EndKind::passage: {
      const Vector3& on = model.vertices()[model.corners(end.index())[0].vertex];
      const Vector3& normal = model.faces()[end.index()].normal;
      const std::int64_t from = geometry::dot(normal, minus(e.from, on));
      return {from, from - geometry::dot(normal, minus(e.to, on))};
    }
    case EndKind::contact: {
      // The vertex is on the image of the edge, so any line through it that leaves that image crosses the edge there.
      const Vector3& p = model.vertices()[end.index()];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Vector3 q = p;
        q[axis] += 1;
        const auto [part, whole] = crossing(p, q);
        if (whole != 0) return rational(part, whole);
      }
      break;
    }
    case EndKind::junction: break;
  }
  const Segment g = model.segment(end.index());
  const auto [part, whole] = crossing(g.from, g.to);
  return rational(part, whole);
}

}  // namespace

EdgeStructure structure_at(const RotationModel& model, const EyeCircle& circle, EdgeIndex edge,
                           const std::vector<Occluder>& occluders, const CirclePlace& place) {
  CircleScratch scratch(model, {circle, place});
  EdgeStructure structure;
  for (const auto& seen : scratch.pieces_of(edge, occluders)) structure.push_back(seen.piece);
  return structure;
}

picture::LinePicture visible_edges(const RotationModel& model, const EyeCircle& circle, const CirclePlace& place) {
  CircleScratch scratch(model, {circle, place});
  picture::LinePicture picture;
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
    for (const auto& seen : scratch.pieces_of(edge, model.occluders_from_anywhere(edge))) {
      picture.pieces.push_back({model.edges()[edge], rational(seen.low.part, seen.low.whole), rational(seen.high.part, seen.high.whole)});
    }
  }
  return picture;
}

void append_pieces(const RotationModel& model, const EyeCircle& circle, EdgeIndex edge, const EdgeStructure& structure,
                   const CirclePlace& place, std::vector<picture::LinePiece>& pieces) {
  CircleView view(circle, place);
  const Segment e = model.segment(edge);
  static_cast<void>(view.set_edge(e.from, e.to));
  for (const Piece& piece : structure) {
    pieces.push_back({model.edges()[edge], parameter_of(model, view, edge, piece.low), parameter_of(model, view, edge, piece.high)});
  }
}

}  // namespace sightline::algorithms::plantinga
