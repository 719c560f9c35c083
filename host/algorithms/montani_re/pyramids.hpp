// Divides the space in front of the eye into five pyramids, for views with a face that is partly in front of and partly
// behind the eye: one straight ahead, |x| <= 2 z and |y| <= 2 z, and four to the sides, such as |y| <= 2 x and 0 <= z <=
// x. In each, the image is a rectangle, to which all faces are clipped (window.hpp). The pyramids overlap, so that
// whatever lies on the border of one is well inside another.
//
// A pyramid's frame is the camera's frame with axes exchanged, so sizes do not change. A frame may be mirrored, which
// does not change hidden lines.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/algorithms/montani_re/faces.hpp"

namespace sightline::algorithms::montani_re {

// The camera axes (0 right, 1 up, 2 forward) that are X, Y and Z of the frame. If `turned`, Z has the opposite sign.
struct PyramidFrame {
  std::array<std::uint8_t, 3> axes{0, 1, 2};
  bool turned = false;
};

[[nodiscard]] bool before_eye(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                              scene::VertexIndex vertex);
// Body and face of the first face that may be seen and is partly in front of and partly behind the eye.
[[nodiscard]] std::optional<std::array<std::size_t, 2>> face_past_eye(const scene::PolyScene& scene,
                                                                      const scene::PolyCamera& camera);

// The faces seen in a window, or all faces if there is no window; then no face may reach behind the eye (precondition).
// Vertices keep the scene's numbers.
[[nodiscard]] FaceSet faces_seen(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                 const PyramidFrame& frame = {}, const WindowBounds* window = nullptr);

// Everything in front of the eye: one set without a window if possible, otherwise one set for every pyramid that contains
// something. Precondition: the scene is checked.
[[nodiscard]] std::vector<FaceSet> faces_before_eye(const scene::PolyScene& scene,
                                                    const scene::PolyCamera& camera);

}  // namespace sightline::algorithms::montani_re
