// The plane of sight through one side of an opening, as a camera sees it.
//
// The side is the line where the planes P (of the opening) and Q (of the side) cross. With p and q their values at the
// eye, P(x) q - Q(x) p vanishes at the eye and on the side, and equals -Q(x) p within the opening's plane. So the side is
// never computed and nothing is divided. In an orthographic view the eye is infinitely far away, opposite to forward: its
// values become p = -P.normal . forward and so on.
//
// Image: in perspective a plane is the line of its normal among the directions of sight. In orthographic views points are
// projected along forward onto the coordinate plane of the axis in which forward is largest; the other two coordinates,
// in the order that keeps left and right, are those of the image.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "host/geometry/predicates.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::jones {

// Not negative at points that are seen on the inner side: normal . point >= offset.
template <class Number>
struct SightPlane {
  std::array<Number, 3> normal{};
  Number offset{};

  [[nodiscard]] Number at(const geometry::Vector3& point) const {
    return normal[0] * point[0] + normal[1] * point[1] + normal[2] * point[2] - offset;
  }
};

class Sight {
 public:
  explicit Sight(const scene::PolyCamera& camera)
      : perspective_(camera.perspective), eye_(camera.eye), forward_(geometry::vector_of(camera.forward)) {
    const std::size_t dropped = geometry::dominant_axis(forward_);
    axes_ = {(dropped + 1) % 3, (dropped + 2) % 3};
    if (forward_[dropped] < 0) axes_ = {axes_[1], axes_[0]};
  }

  [[nodiscard]] bool perspective() const { return perspective_; }
  [[nodiscard]] const geometry::Vector3& forward() const { return forward_; }
  [[nodiscard]] geometry::Vector3 from_eye(const scene::PolyPoint& point) const {
    return geometry::difference(point, eye_);
  }
  // Positive if the eye is on the side the plane's normal points to, 0 if the plane is seen edge-on.
  [[nodiscard]] std::int64_t eye_value(const geometry::Plane& plane) const {
    return perspective_ ? plane.at(eye_) : -geometry::dot(plane.normal, forward_);
  }
  // Whether the edge between two points, given relative to the eye, is seen as a point.
  [[nodiscard]] bool seen_end_on(const geometry::Vector3& a, const geometry::Vector3& b) const {
    if (perspective_) return geometry::is_zero(geometry::cross(a, b));
    return geometry::is_zero(geometry::cross(forward_, {b[0] - a[0], b[1] - a[1], b[2] - a[2]}));
  }

  // The plane of sight through the side of an opening in `plane`; `side` is the other plane through that side. It is not
  // negative where the side's half-space is. Precondition: eye = eye_value(plane) is not 0.
  template <class Number>
  [[nodiscard]] SightPlane<Number> through(const geometry::Plane& plane, std::int64_t eye,
                                           const geometry::Plane& side, bool turned) const {
    const std::int64_t direction = ((eye > 0) != turned) ? 1 : -1;
    const Number p = Number{eye} * direction;
    const Number q = Number{eye_value(side)} * direction;
    SightPlane<Number> sight;
    for (std::size_t a = 0; a < 3; ++a) sight.normal[a] = plane.normal[a] * q - side.normal[a] * p;
    sight.offset =
        perspective_ ? at_eye<Number>(sight.normal) : Number{plane.offset} * q - Number{side.offset} * p;
    return sight;
  }
  // The half-space that is not behind the eye, in perspective.
  template <class Number>
  [[nodiscard]] SightPlane<Number> before_eye() const {
    SightPlane<Number> sight{{forward_[0], forward_[1], forward_[2]}, {}};
    sight.offset = at_eye<Number>(sight.normal);
    return sight;
  }

  template <class Arithmetic>
  [[nodiscard]] typename Arithmetic::Line image(const SightPlane<typename Arithmetic::Number>& plane) const {
    if (perspective_) return Arithmetic::line(plane.normal);
    return Arithmetic::line({plane.normal[axes_[0]], plane.normal[axes_[1]], -plane.offset});
  }

 private:
  template <class Number>
  [[nodiscard]] Number at_eye(const std::array<Number, 3>& normal) const {
    return normal[0] * eye_[0] + normal[1] * eye_[1] + normal[2] * eye_[2];
  }

  bool perspective_;
  geometry::Point3 eye_;
  geometry::Vector3 forward_;
  std::array<std::size_t, 2> axes_{};
};

}  // namespace sightline::algorithms::jones
