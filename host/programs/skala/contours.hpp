// Contours on a surface as a command stream (Skala 1985, section 5; the printed algorithm 5.1 is lost).
//
// Every cell is two flat triangles, divided by the diagonal between its side corners. A contour is tested against
// everything nearer than its triangle and hides nothing; then the triangle's far edges extend the masks. Levels ascend, so
// where several contours share a dot, the highest is shown. A height equal to a level counts as above it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/programs/skala/projection.hpp"
#include "host/programs/skala/stream_chain.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/programs/skala/commands.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::programs::skala {

// The colours of the levels, lowest first, repeating. White is for margins and silhouette.
inline constexpr std::array<int, 6> contour_colours{1, 3, 2, 6, 4, 5};
inline constexpr int margin_colour = 7;

// Heights of the levels between the ends of the range: low + k (high - low) / (count + 1), k = 1 .. count.
// None if the range is empty.
[[nodiscard]] std::vector<double> contour_levels(scene::Interval range, int count);

// The line in which the contour of a level crosses a triangle.
struct ContourPiece {
  Vertex from;
  Vertex to;
};

// Corners must be defined. `crossed` is false if all corners are on one side of the level.
struct ContourCrossing {
  bool crossed = false;
  ContourPiece piece;
};
[[nodiscard]] ContourCrossing contour_crossing(const scene::HeightGrid& grid, const Projection& projection,
                                               const std::array<GridIndex, 3>& triangle, double level);

[[nodiscard]] std::vector<std::uint8_t> contour_stream(const scene::HeightGrid& grid, const View& view, const Output& output = {});

}  // namespace sightline::programs::skala
