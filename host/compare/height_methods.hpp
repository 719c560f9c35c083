// The methods that draw a function of two variables on the 256 by 256 points of Skala's raster board: Skala's program on its 8080,
// the twin of that program, the native algorithm, and the oracle that decides each column of the screen by depth alone.
//
// All draw the same view, contours without silhouettes unless it asks for them. A point counts as lit or not; colours and greys are
// not distinguished. The native algorithm draws vectors: these are put on the same points.
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
  picture::PixelGrid dots;  // 1 where lit; empty of a native surface, which is of facets
  std::optional<picture::VectorDrawing> drawing;  // of the native algorithm
  std::string fault;  // of a program that failed, or whose picture is not its twin's; empty: none
  std::optional<core::TStates> drawing_time;  // of a program on its machine
};

struct HeightMethod {
  std::string_view name;
  std::string_view description;  // and its source
  // Why the method cannot draw it; empty if it can.
  std::optional<std::string> (*why_not)(const scene::HeightGrid& grid, const algorithms::skala::View& view);
  // A picture, of what the method has one of (precondition).
  HeightPicture (*draw)(const scene::HeightGrid& grid, const algorithms::skala::View& view);
};

// The oracle's dots, with the polygon around all that hides, which contours of the program have, or without.
[[nodiscard]] picture::PixelGrid oracle_dots(const scene::HeightGrid& grid, const algorithms::skala::View& view, bool outline);

// guest, twin, native, oracle.
[[nodiscard]] std::span<const HeightMethod> height_methods();
// Null if there is none of that name.
[[nodiscard]] const HeightMethod* find_height_method(std::string_view name);

}  // namespace sightline::compare
