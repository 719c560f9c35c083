// The methods that draw a function of two variables, all behind one door: Skala's program on its 8080, the
// twin of that program, the native algorithm, and the oracle that decides each column of the screen by depth
// alone.
//
// All draw the same view. On the 256 by 256 points of Skala's raster board a point counts as lit or not;
// colours and greys are not distinguished. The native algorithm draws vectors: these are put on the same points.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/tstates.hpp"
#include "host/algorithms/skala/figure.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/programs/skala/view.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::registry {

// What is wanted, as the native algorithm says it. The others always have rims.
struct HeightView : algorithms::skala::View {
  double zoom = 1;  // > 0, about the middle of the picture
};

struct HeightPicture {
  picture::PixelGrid dots;  // 1 where lit; empty of a native surface, which is of facets
  std::optional<picture::VectorDrawing> drawing;  // of the native algorithm
  std::string fault;  // of a program that stopped, or did not do what its twin does; empty: none
  std::optional<core::TStates> drawing_time;  // of a program on its machine
};

struct HeightMethod {
  std::string_view name;
  std::string_view description;  // and its source
  // Why the method cannot draw it; empty if it can.
  std::optional<std::string> (*why_not)(const scene::HeightGrid& grid, const HeightView& view);
  // A picture, of what the method has one of (precondition).
  HeightPicture (*draw)(const scene::HeightGrid& grid, const HeightView& view);
  // Of a method that draws vectors, facets far to near: its name for `draw` and in the cross-check. Else
  // empty.
  std::string_view algorithm = {};
  // Of the same: the drawing as a figure for a page.
  algorithms::skala::Figure (*figure)(std::span<const scene::HeightGrid> grids, const HeightView& view, const algorithms::skala::FigureOptions& options) = nullptr;
};

// The same view in the terms of the program on the 8080, and back.
[[nodiscard]] programs::skala::View program_view(const HeightView& view);
[[nodiscard]] HeightView height_view(const programs::skala::View& view);

// The oracle's dots, with the polygon around all that hides, which contours of the program have, or without.
[[nodiscard]] picture::PixelGrid oracle_dots(const scene::HeightGrid& grid, const HeightView& view,
                                             bool outline);

// guest, twin, native, oracle.
[[nodiscard]] std::span<const HeightMethod> height_methods();
// Null if there is none of that name.
[[nodiscard]] const HeightMethod* find_height_method(std::string_view name);
// By the name of its algorithm, which is not empty.
[[nodiscard]] const HeightMethod* find_height_algorithm(std::string_view algorithm);

}  // namespace sightline::registry
