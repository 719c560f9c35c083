// The scenes of the cross-check, each with its views.
//
// The sight lines through the pixels' centres are integer vectors, so that the nearest face at every pixel is known
// exactly: the camera's three vectors have one integer length, and so does a parallel direction ((3, 4), (5, 12),
// ...). All directions are level, because Plantinga, Seales and Dyer turn about y. Axis-parallel scenes are tilted,
// vertices and cameras, by an integer matrix; the tilt is part of the scene. Scenes of cells, for Jones's program on
// the PDP-7, are not tilted and are seen along z.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/face_raster.hpp"
#include "host/algorithms/oracle/matter_scene.hpp"
#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/geometry/predicates.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

struct CrossCheckView : algorithms::oracle::SquareImage {
  [[nodiscard]] registry::FaceWindow window() const;
  // Whether the point is far enough before the eye to have a place in the image.
  [[nodiscard]] bool has_place(const scene::PolyPoint& point) const;
  // The image of such a point in pixels; the centre of column c and row r is (c, r).
  [[nodiscard]] picture::PixelPoint place(const scene::PolyPoint& point) const;
  // The image of a piece of an edge, as far as it has places.
  [[nodiscard]] std::optional<picture::PixelSegment> place(const scene::PolyPoint& from,
                                                           const scene::PolyPoint& to,
                                                           const picture::LinePart& piece = {}) const;

 private:
  static constexpr double nearest = 1;  // scene units

  [[nodiscard]] std::array<double, 3> in_camera(const scene::PolyPoint& point) const;
  [[nodiscard]] picture::PixelPoint project(const std::array<double, 3>& p) const;
};

struct CommonScene {
  std::string_view name;   // "C1"
  std::string_view title;  // what it shows, in a few words
  scene::PolyScene scene;
  std::vector<CrossCheckView> views;
  bool plan = false;  // level views of walls whose roofs and floors are not visible
  // If the scene is the surface of a function, with two triangles for each cell: the function and the same view of
  // it.
  std::optional<scene::HeightGrid> heights;
  algorithms::skala::View height_view;
  // For a scene of cells: the cells, and their matter, whose solids, walls and wires `scene` has. Its views look
  // along z.
  std::optional<scene::CellScene> cells;
  std::optional<algorithms::oracle::MatterScene> matter;
};

// Polyhedra (C1 ..), functions (H1 ..), scenes of cells (J1 ..).
[[nodiscard]] std::span<const std::string_view> common_scene_names();
// One of those names (precondition).
[[nodiscard]] CommonScene common_scene(std::string_view name);

// A function as triangles, in coordinates in which a camera along +z sees Skala's projection, turned by -asin(7/25),
// from an elevation with sine and cosine in fifths: (3, 4) or (4, 3).
[[nodiscard]] CommonScene height_scene(std::string_view name, std::string_view title,
                                       std::string_view function, std::int32_t sine, std::int32_t cosine);
// Looks from (p, q), where p p + q q = h h; the whole scene is in the picture.
[[nodiscard]] CrossCheckView parallel_view(const scene::PolyScene& scene, std::int32_t p, std::int32_t q,
                                           std::int32_t h, int size = 256);

}  // namespace sightline::compare
