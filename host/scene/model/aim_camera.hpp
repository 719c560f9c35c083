// Cameras with a given direction of view: three orthogonal integer vectors below 2^15, as PolyCamera
// requires, as near to the given direction as such vectors can be.
//
// Let (p, q) be the horizontal part of the direction as integers, and r = p p + q q. For y vertical, the
// vectors forward = (p m, n, q m), right = (q, 0, -p) and up = (-p n, r m, -q n) are orthogonal for any
// integers m and n. Of all p, q, m, n that keep every component below 2^15, those with forward nearest to the
// direction are used: at most 0.3 degrees away, and exact where possible.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

inline constexpr std::int32_t camera_vector_limit = 1 << 15;

// The orientation of a scene's coordinates: which axis is vertical, and whether right, up and forward have
// the handedness of x, y and z (as in cell scenes, where z points away) or the opposite one (as in OFF and
// OBJ files).
struct SceneFrame {
  std::size_t vertical = 1;  // 0, 1, 2 = x, y, z
  bool downwards = false;    // up is the negative end of the axis
  bool forward_is_z = false;

  friend bool operator==(const SceneFrame&, const SceneFrame&) = default;
};

// The frame of the scene's own camera: from its up vector and its handedness.
[[nodiscard]] SceneFrame frame_of(const PolyCamera& camera);

// Looks from `eye` towards eye + direction. The direction is not zero, its components are below 2^20
// (precondition). Up is as near to the vertical as possible; for a direction along the vertical, the next
// axis points right.
[[nodiscard]] PolyCamera aimed_camera(const SceneFrame& frame, const PolyPoint& eye,
                                      const PolyPoint& direction, bool perspective = true);

// The same with up as near as possible to `up`, which is not along the direction. Both have any length but 0.
// If both, and the right and upright vectors that follow, are multiples of small integer vectors, the camera
// has exactly these. Otherwise, if up is the vertical, it is aimed_camera's. Otherwise it is the nearest
// rotation with small enough integer vectors (from integer quaternions), rarely more than 0.3 degrees away.
[[nodiscard]] PolyCamera turned_camera(const SceneFrame& frame, const PolyPoint& eye,
                                       const std::array<double, 3>& direction, const std::array<double, 3>& up,
                                       bool perspective = true);

// The angle between a camera's direction and another direction, in degrees.
[[nodiscard]] double angle_to(const PolyCamera& camera, const std::array<double, 3>& direction);

// A direction of any nonzero length in the form that aimed_camera takes: exact, if it has at most six
// decimals and fits.
[[nodiscard]] PolyPoint direction_of(const std::array<double, 3>& direction);

// The directions of a scene for a viewer in front of it.
struct SceneSides {
  std::array<double, 3> right{};
  std::array<double, 3> up{};
  std::array<double, 3> away{};
};
[[nodiscard]] SceneSides sides_of(const SceneFrame& frame);

// From outside the scene's bounds, looking at their centre in this direction. Orthographic if requested, or
// if no such eye is within poly_coordinate_limit.
[[nodiscard]] PolyCamera camera_outside(const SceneFrame& frame, const PolyScene& scene,
                                        const std::array<double, 3>& direction, bool perspective);

// From outside the scene's bounds, looking at their centre from above, one side and the front. Orthographic
// if no such eye is within poly_coordinate_limit.
[[nodiscard]] PolyCamera three_quarter_camera(const SceneFrame& frame, const PolyScene& scene);

}  // namespace sightline::scene
