// The space before the eye in five pyramids, for views in which a face reaches from before the eye to behind
// it: one straight ahead, |x| <= 2 z and |y| <= 2 z, and four to the sides, such as |y| <= 2 x and 0 <= z <=
// x. In each the image is a rectangle, to which all faces are clipped (window.hpp). They overlap, so that
// what lies on the border of one is well inside another.
//
// A pyramid's frame is the camera's with its axes exchanged, so that sizes stay as they are. Frames may be
// mirrored, which does not change hidden lines.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/algorithms/montani_re/faces.hpp"

namespace sightline::algorithms::montani_re {

// X, Y and Z of the frame are these of the camera's x (right), y (up), z (forward); the last one backwards if
// `turned`.
struct PyramidFrame {
  std::array<std::uint8_t, 3> axes{0, 1, 2};
  bool turned = false;
};

[[nodiscard]] bool before_eye(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                              scene::VertexIndex vertex);
// Body and face of the first that may be seen and reaches from before the eye to behind it.
[[nodiscard]] std::optional<std::array<std::size_t, 2>> face_past_eye(const scene::PolyScene& scene,
                                                                      const scene::PolyCamera& camera);

// What is seen in a window; everything if there is none, and then no face reaches past the eye
// (precondition). Vertices keep the scene's numbers.
[[nodiscard]] FaceSet faces_seen(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                 const PyramidFrame& frame = {}, const WindowBounds* window = nullptr);

// All that is before the eye: one set without a window where that will do, else one of every pyramid that
// holds something. The scene is a checked one (precondition).
[[nodiscard]] std::vector<FaceSet> faces_before_eye(const scene::PolyScene& scene,
                                                    const scene::PolyCamera& camera);

}  // namespace sightline::algorithms::montani_re
