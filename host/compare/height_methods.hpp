// The methods that draw a function of two variables on the 256 by 256 points of Skala's raster board: Skala's program
// on its 8080, its twin, the native algorithm, and the oracle that decides each column of the screen by depth alone.
//
// All draw the same view; contours have no silhouettes unless requested. A point counts as lit or not; colours and
// greys are not distinguished. The native algorithm draws vectors, which are put on the same points.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "emulators/core/tstates.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

struct HeightPicture {
  picture::PixelGrid dots;  // 1 where lit; empty for a native surface, which consists of facets
  std::optional<picture::VectorDrawing> drawing;  // of the native algorithm
  std::string fault;  // of a program that failed or differs from its twin; else empty
  std::optional<core::TStates> drawing_time;  // of a program on its machine
};

struct HeightMethod {
  std::string_view name;
  std::string_view description;  // and its source
  // Why the method cannot draw the view; empty if it can.
  std::optional<std::string> (*why_not)(const scene::HeightGrid& grid, const algorithms::skala::View& view);
  // Draws a view for which why_not is empty (precondition).
  HeightPicture (*draw)(const scene::HeightGrid& grid, const algorithms::skala::View& view);
};

// The oracle's dots; with `outline`, including the polygon around the occluders that the program adds to contours.
[[nodiscard]] picture::PixelGrid oracle_dots(const scene::HeightGrid& grid, const algorithms::skala::View& view, bool outline);

// guest, twin, native, oracle.
[[nodiscard]] std::span<const HeightMethod> height_methods();
// Null if there is no such method.
[[nodiscard]] const HeightMethod* find_height_method(std::string_view name);

}  // namespace sightline::compare
