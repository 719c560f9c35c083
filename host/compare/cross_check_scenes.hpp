// The scenes on which all algorithms are compared with each other, each with its views.
//
// A view is a camera of which the middles of the pixels have whole sight lines, so that the nearest face of
// every pixel is known exactly: its three vectors are of one length, and a direction without perspective has
// a whole one ((3, 4), (5, 12), ...). All directions are level, for Plantinga, Seales and Dyer turn about y.
// Scenes parallel to the axes are tilted, vertices and cameras, by a whole matrix: the tilt is part of the
// scene. Scenes of cells, for Jones's program on the PDP-7, are as they are, and seen along z. Source: the suite's cross-check of
// algorithms, section 2 (C1 to C9, H1, H2).
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
  // Before the eye by more than nothing worth mentioning: it has a place.
  [[nodiscard]] bool has_place(const scene::PolyPoint& point) const;
  // Where such a point is seen, in pixels, the middle of column c and row r at (c, r).
  [[nodiscard]] picture::PixelPoint place(const scene::PolyPoint& point) const;
  // The same of a piece of an edge, as far as it has places.
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
  std::string_view title;  // what it shows, in few words
  scene::PolyScene scene;
  std::vector<CrossCheckView> views;
  bool plan = false;  // walls seen level, of which roofs and floors cannot be seen
  // The function whose surface the scene is, two triangles for each cell, and the same view of it.
  std::optional<scene::HeightGrid> heights;
  algorithms::skala::View height_view;
  // Of a scene of cells: the scene, and its matter, whose solids, walls and wires `scene` has. Its views look along z.
  std::optional<scene::CellScene> cells;
  std::optional<algorithms::oracle::MatterScene> matter;
};

// Polyhedra (C1 ..), functions (H1 ..), scenes of cells (J1 ..).
[[nodiscard]] std::span<const std::string_view> common_scene_names();
// One of those names (precondition).
[[nodiscard]] CommonScene common_scene(std::string_view name);

// A function as triangles that a camera along +z sees as Skala's projection does, turned by -asin(7/25) and
// seen from an elevation with sine and cosine in fifths: (3, 4) or (4, 3).
[[nodiscard]] CommonScene height_scene(std::string_view name, std::string_view title,
                                       std::string_view function, std::int32_t sine, std::int32_t cosine);
// From (p, q) with p p + q q = h h, the whole scene in the picture.
[[nodiscard]] CrossCheckView parallel_view(const scene::PolyScene& scene, std::int32_t p, std::int32_t q,
                                           std::int32_t h, int size = 256);

}  // namespace sightline::compare
