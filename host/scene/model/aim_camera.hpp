// Cameras with a given direction of view: three orthogonal integer vectors below 2^15, as PolyCamera needs
// them, as near to the given direction as such vectors come.
//
// With the horizontal part of the direction as whole numbers (p, q) and r = p p + q q, the vectors
// forward = (p m, n, q m), right = (q, 0, -p) and up = (-p n, r m, -q n), y vertical, are orthogonal for any
// whole m and n. Of all p, q, m, n that keep every component below 2^15 those are taken whose forward is
// nearest to the direction: never more than 0.3 degrees away, and exact where it can be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

inline constexpr std::int32_t camera_vector_limit = 1 << 15;

// How a scene's coordinates are meant: which axis is the vertical, and whether right, up and forward turn as
// x, y and z do (as in cell scenes, where z points away) or the other way round (as in OFF and OBJ files).
struct SceneFrame {
  std::size_t vertical = 1;  // 0, 1, 2 = x, y, z
  bool downwards = false;    // up is the axis' negative end
  bool forward_is_z = false;

  friend bool operator==(const SceneFrame&, const SceneFrame&) = default;
};

// What the scene's own camera says: its up, and the turn of its vectors.
[[nodiscard]] SceneFrame frame_of(const PolyCamera& camera);

// From eye towards eye + direction; direction is not zero, its components are below 2^20 (precondition). Up
// is as near to the vertical as it can be; for a direction along the vertical, the next axis is to the right.
[[nodiscard]] PolyCamera aimed_camera(const SceneFrame& frame, const PolyPoint& eye,
                                      const PolyPoint& direction, bool perspective = true);

// The same with up as near as it can be to `up`, which is not along the direction. Both of any length but 0. Where both
// are multiples of small whole vectors, and so are the right and the upright that follow from them, the camera has
// exactly these. Otherwise it is that of aimed_camera if up is the vertical, else the nearest of the rotations that have
// small enough vectors of integers (those of quaternions of integers), rarely more than 0.3 degrees away.
[[nodiscard]] PolyCamera turned_camera(const SceneFrame& frame, const PolyPoint& eye,
                                       const std::array<double, 3>& direction, const std::array<double, 3>& up,
                                       bool perspective = true);

// The angle between the direction of a camera and another one, in degrees.
[[nodiscard]] double angle_to(const PolyCamera& camera, const std::array<double, 3>& direction);

// A direction of any length but 0 as aimed_camera takes them: exactly, if it has at most six decimals and fits.
[[nodiscard]] PolyPoint direction_of(const std::array<double, 3>& direction);

// The directions of a scene as somebody who stands before it has them.
struct SceneSides {
  std::array<double, 3> right{};
  std::array<double, 3> up{};
  std::array<double, 3> away{};
};
[[nodiscard]] SceneSides sides_of(const SceneFrame& frame);

// From outside the scene's bounds onto their middle, in this direction; orthographic if no such eye keeps below
// poly_coordinate_limit, or if that is asked for.
[[nodiscard]] PolyCamera camera_outside(const SceneFrame& frame, const PolyScene& scene,
                                        const std::array<double, 3>& direction, bool perspective);

// From outside the scene's bounds onto their middle, from above, one side and the front; orthographic if no
// such eye keeps below poly_coordinate_limit.
[[nodiscard]] PolyCamera three_quarter_camera(const SceneFrame& frame, const PolyScene& scene);

}  // namespace sightline::scene
