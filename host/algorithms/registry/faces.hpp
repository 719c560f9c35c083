// The table of the algorithms that find the visible face at every point of a raster. Algorithms that draw lines are in
// lines.hpp.
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

// The shown part of the image plane (PolyCamera): x is at column `left + scale x`, y at line `top - scale y`.
struct FaceWindow {
  int width = 512;
  int height = 512;
  double scale = 256;
  double left = 256;
  double top = 256;
};

struct FaceView {
  picture::PixelGrid faces;  // number of the face over all bodies + 1; 0: no face
  std::vector<FaceCount> counts;
};

// The visible region of one face as closed polygons: outlines counterclockwise, holes clockwise. In pixels from the
// bottom left of the window, y upwards.
struct FaceRegion {
  std::uint32_t face = 0;  // as in FaceView
  std::vector<std::vector<picture::PixelPoint>> loops;
};

struct FaceRegions {
  std::vector<FaceRegion> regions;  // they do not overlap
  std::vector<FaceCount> counts;
};

// One view of a prepared scene. Precondition: the eye of a perspective camera is in free space. Not thread-safe.
using FaceViews = std::function<base::Result<FaceView>(const scene::PolyCamera&, const FaceWindow&)>;
using FaceRegionViews = std::function<base::Result<FaceRegions>(const scene::PolyCamera&, const FaceWindow&)>;

// Part of a pixel, in column and row (from the bottom), that a face (as in FaceView) covers; `whole` is all of the pixel. A pixel
// may be told in several parts. What no face covers is background.
struct FacePart {
  std::uint32_t face = 0;
  int column = 0;
  int row = 0;
  std::int64_t part = 0;
  std::int64_t whole = 1;
};
// One view with parts of pixels: calls the function with all parts, and returns the counts of the view.
using FaceCoverageViews = std::function<base::Result<std::vector<FaceCount>>(
    const scene::PolyCamera&, const FaceWindow&, const std::function<void(const FacePart&)>&)>;

struct PreparedFaces {
  FaceViews view;
  FaceCoverageViews coverage;           // empty if the algorithm has no parts of pixels
  FaceRegionViews regions;              // empty if the algorithm computes pixels only
  std::vector<FaceCount> counts;        // about the preparation of the scene
  std::vector<std::string> not_solved;  // what may be drawn wrongly, by name
};

// Stripe thicknesses of Montani and Re's algorithm, in pixels.
inline constexpr std::array<double, 6> stripe_thicknesses{8, 4, 2, 1, 0.5, 0.25};

// Each algorithm reads its own options.
struct FaceOptions {
  // Willis
  std::optional<int> depth;  // most cuts of one surface
  bool plan = false;         // walls only, seen by an eye among them
  std::size_t vertical = 1;  // the vertical axis, for plan
  bool rule90 = false;       // apply the paper's rule that normals be within 90 degrees
  bool oval = false;         // the boundary is an oval instead of two circles
  bool order_cells = true;   // false: order by distance only
  std::optional<std::size_t> most_pairs;  // limit of pairs of pieces to be separated; scenes that need more are rejected
  // Montani and Re
  double stripe = 1;  // thickness, one of stripe_thicknesses; regions ignore it
  bool one_silhouette =
      false;  // subtract all nearer faces as one region; the first of coplanar faces then has the shared part
};

struct FaceAlgorithm {
  std::string_view name;
  std::string_view description;  // includes the source
  // Computes the data that all views of a scene share. Preconditions: the scene is checked and outlives the result.
  base::Result<PreparedFaces> (*prepare)(const scene::PolyScene& scene, const FaceOptions& options);
  MeshTime mesh_time = {};
};

[[nodiscard]] std::span<const FaceAlgorithm> face_algorithms();
// Null if no algorithm has this name.
[[nodiscard]] const FaceAlgorithm* find_face_algorithm(std::string_view name);

// The window of the algorithms: straight ahead, `extent` (degrees, or scene units in parallel projection) across the
// shorter side; or around the whole scene.
[[nodiscard]] FaceWindow face_window(const scene::PolyScene& scene, const scene::PolyCamera& camera,
                                     int width, int height, std::optional<double> extent);

}  // namespace sightline::registry
