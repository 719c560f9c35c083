// A view of a scene in the form that the stripes program takes: the faces turned to the eye, projected and clipped to the
// picture on this computer, corners in 1/256 dot with a depth, each plane as four whole numbers. If the host finds the
// priority, the native algorithm orders the faces and cuts cycles; no other visibility is computed here.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/algorithms/registry/faces.hpp"
#include "host/base/result.hpp"
#include "host/programs/stripes/face_stripes.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::programs::stripes {

// Dots from the left and from the bottom are `left + scale x` and `bottom + scale y` of an image point (PolyCamera).
struct View {
  scene::PolyCamera camera;
  double scale = 127;
  double left = 127.5;
  double bottom = 127.5;
};

// `window` has at least 255 columns and lines; the picture is its lower left part.
[[nodiscard]] View view_of(const scene::PolyCamera& camera, const registry::FaceWindow& window);
// All of the scene before the camera, or `extent` across (as in registry::face_window).
[[nodiscard]] View view_of(const scene::PolyScene& scene, const scene::PolyCamera& camera, std::optional<double> extent = {});

struct SceneFace {
  std::uint32_t number = 0;  // over all bodies, from 1
  std::uint32_t body = 0;
  std::uint32_t index = 0;  // in it
  std::uint8_t level = 1;   // 1 to 7, by how the face is turned to a lamp behind the eye's left shoulder
  CornerRings rings;
  std::int32_t a = 0;  // a X + b Y + c Z - d is positive behind the plane; c > 0
  std::int32_t b = 0;
  std::int32_t c = 1;
  std::int32_t d = 0;
};

struct ProjectedScene {
  std::vector<SceneFace> faces;  // nearest first if the host found the priority
  std::uint64_t cuts = 0;        // by the host: cuts of cycles, and parts cut off faces that hide each other in different places
  std::uint64_t mutual_parts = 0;  // those of the cuts that are such parts
  bool clipped = false;          // parts of faces are outside the picture
};

// The scene must have been checked, and the eye of a perspective camera must be in free space. Error: the priority is
// requested and faces pass through each other.
[[nodiscard]] base::Result<ProjectedScene> project_scene(const scene::PolyScene& scene, const View& view, bool with_priority);

}  // namespace sightline::programs::stripes
