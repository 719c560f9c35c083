// The algorithms that say for every point of a raster which face is seen there, behind one door; those that
// draw lines have a table of their own (lines.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/registry/mesh_time.hpp"
#include "host/base/result.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::registry {

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

// What is seen of one face, as closed lines: outlines counterclockwise, holes clockwise. From the bottom left
// of the window, in its pixels, y upwards.
struct FaceRegion {
  std::uint32_t face = 0;  // as in FaceView
  std::vector<std::vector<picture::PixelPoint>> loops;
};

struct FaceRegions {
  std::vector<FaceRegion> regions;  // they do not overlap
  std::vector<FaceCount> counts;
};

// One view of a prepared scene. The eye of a camera in perspective is in free space (precondition). One view
// at a time.
using FaceViews = std::function<base::Result<FaceView>(const scene::PolyCamera&, const FaceWindow&)>;
using FaceRegionViews = std::function<base::Result<FaceRegions>(const scene::PolyCamera&, const FaceWindow&)>;

struct PreparedFaces {
  FaceViews view;
  FaceRegionViews regions;              // empty if the algorithm has pixels only
  std::vector<FaceCount> counts;        // of what was made of the scene
  std::vector<std::string> not_solved;  // what may be drawn wrongly, by name; empty: nothing
};

// Stripes of Montani and Re's, in pixels.
inline constexpr std::array<double, 6> stripe_thicknesses{8, 4, 2, 1, 0.5, 0.25};

// Every algorithm reads its own.
struct FaceOptions {
  // Willis
  std::optional<int> depth;  // cuts of one surface
  bool plan = false;         // walls only, seen from among them
  std::size_t vertical = 1;  // axis, for plan
  bool rule90 = false;       // the paper's rule that normals be within 90 degrees
  bool oval = false;         // the boundary is the oval, not two circles
  bool order_cells = true;   // false: distance alone
  std::optional<std::size_t> most_pairs;  // of pieces to be kept apart; a scene that needs more is refused
  // Montani and Re
  double stripe = 1;  // thickness, one of those above; regions have none
  bool one_silhouette =
      false;  // of regions: of all faces in front; what coplanar ones share is then the first's
};

struct FaceAlgorithm {
  std::string_view name;
  std::string_view description;  // and its source
  // What all views of a scene share. The scene is a checked one (precondition), and outlives what is
  // prepared.
  base::Result<PreparedFaces> (*prepare)(const scene::PolyScene& scene, const FaceOptions& options);
  MeshTime mesh_time = {};
};

[[nodiscard]] std::span<const FaceAlgorithm> face_algorithms();
// Null if there is none of that name.
[[nodiscard]] const FaceAlgorithm* find_face_algorithm(std::string_view name);

// As windows of the algorithms: straight ahead, `extent` (degrees, or scene units without perspective) across
// the shorter side; or around all of the scene.
[[nodiscard]] FaceWindow face_window(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                     int width, int height, std::optional<double> extent);

}  // namespace sightline::registry
