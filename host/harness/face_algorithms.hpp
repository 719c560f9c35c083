// The algorithms that say for every point of a raster which face is seen there, behind one door; those that
// draw lines have a table of their own (algorithms.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/picture/pixel_metrics.hpp"
#include "host/scene/cell_scene.hpp"
#include "host/scene/poly_scene.hpp"

namespace sightline::harness {

struct FaceCount {
  std::string_view name;
  std::uint64_t value = 0;
};

// What of the image plane (PolyCamera) is shown: x at column `left + scale x`, y at line `top - scale y`.
struct FaceWindow {
  int width = 512;
  int height = 512;
  double scale = 256;
  double left = 256;
  double top = 256;
};

struct FaceView {
  picture::PixelGrid faces;  // number of the face over all bodies + 1, 0 where there is none
  std::vector<FaceCount> counts;
};

// One view of a prepared scene. The eye of a camera in perspective is in free space (precondition). One view
// at a time.
using FaceViews =
    std::function<std::variant<FaceView, scene::SceneError>(const scene::PolyCamera&, const FaceWindow&)>;

struct PreparedFaces {
  FaceViews view;
  std::vector<FaceCount> counts;       // of what was made of the scene
  std::vector<std::string> not_solved;  // what may be drawn wrongly, by name; empty: nothing
};

struct FaceOptions {
  std::optional<int> depth;  // the algorithm's own knob: cuts of one surface
  bool plan = false;         // walls only, seen from among them
  std::size_t vertical = 1;  // axis, for plan
  bool rule90 = false;       // the paper's rule that normals be within 90 degrees
};

struct FaceAlgorithm {
  std::string_view name;
  std::string_view description;  // and its source
  // What all views of a scene share. The scene is a checked one (precondition), and outlives what is prepared.
  std::variant<PreparedFaces, scene::SceneError> (*prepare)(const scene::PolyScene& scene,
                                                            const FaceOptions& options);
};

[[nodiscard]] std::span<const FaceAlgorithm> face_algorithms();
// Null if there is none of that name.
[[nodiscard]] const FaceAlgorithm* find_face_algorithm(std::string_view name);

// As windows of the algorithms: straight ahead, `extent` (degrees, or scene units without perspective) across
// the shorter side; or around all of the scene.
[[nodiscard]] FaceWindow face_window(const scene::PolyScene& scene, const scene::PolyCamera& camera, int width,
                                     int height, std::optional<double> extent);

}  // namespace sightline::harness
