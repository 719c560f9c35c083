// Computes in doubles where a camera sees points, for measuring and drawing, never to decide visibility.
#pragma once

#include <array>
#include <cstddef>

#include "host/geometry/vector.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

// Right, up and forward components from the eye, in units of the scene. Forward is 1 in parallel projection, so dividing
// right and up by it gives the position in the image as PolyCamera defines it.
using SeenPoint = geometry::RealVector;

class CameraView {
 public:
  explicit CameraView(const scene::PolyCamera& camera)
      : perspective_(camera.perspective),
        eye_(geometry::real_vector(camera.eye)),
        directions_{geometry::real_vector(camera.right), geometry::real_vector(camera.up), geometry::real_vector(camera.forward)},
        lengths_{geometry::length(directions_[0]), geometry::length(directions_[1]), geometry::length(directions_[2])} {}

  [[nodiscard]] SeenPoint at(const geometry::RealVector& point) const { return from_eye(geometry::difference(point, eye_)); }
  [[nodiscard]] SeenPoint at(const scene::PolyPoint& point) const { return at(geometry::real_vector(point)); }
  // For a point given relative to the eye.
  [[nodiscard]] SeenPoint from_eye(const geometry::RealVector& d) const {
    return {along(0, d), along(1, d), perspective_ ? along(2, d) : 1};
  }
  // Right, up or forward (0, 1, 2): as given by the camera, and normalized.
  [[nodiscard]] const geometry::RealVector& direction(std::size_t number) const { return directions_[number]; }
  [[nodiscard]] geometry::RealVector axis(std::size_t number) const { return geometry::unit(directions_[number]); }
  // The length of direction(number).
  [[nodiscard]] double length(std::size_t number) const { return lengths_[number]; }

 private:
  // Divides only once: the sum is exact for points of the scene.
  [[nodiscard]] double along(std::size_t number, const geometry::RealVector& d) const {
    return geometry::dot(d, directions_[number]) / lengths_[number];
  }

  bool perspective_;
  geometry::RealVector eye_;
  std::array<geometry::RealVector, 3> directions_;
  std::array<double, 3> lengths_;
};

}  // namespace sightline::picture
