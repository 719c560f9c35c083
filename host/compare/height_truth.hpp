// The visible parts of the lines of a height picture, as vectors: the reference for native pictures by the line
// metrics. The reference for rasters is the column oracle (host/algorithms/oracle/column_oracle.hpp).
//
// A line of the picture is a side of a cell, or the part of a contour in half a cell. Its visible parts are found by
// depth alone, with no order, mask or column: a point of the screen is hidden if, of the surface's lines that are
// nearer on the same vertical, one is above and one is below it. Between their ends all is linear, so the hidden
// parts are intervals, found pair by pair. For a surface without holes this is exact; for slices it is the occlusion
// of Skala's method.
//
// In floating point, without rounding to dots or columns: for measuring. Left out: holes, silhouettes, nets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/programs/skala/projection.hpp"
#include "host/algorithms/skala/view.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/pixel_metrics.hpp"
#include "host/picture/vector_drawing.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::compare {

// How the image divides a cell, between its leftmost and rightmost corner: true if that diagonal runs from the least
// x and z to the greatest. If two corners are equally near, as the native algorithm decides.
[[nodiscard]] bool rising_diagonals(const programs::skala::SineCosine& turn);

// The lines of a picture of lines or contours in 255 x 255 units, with their visible parts.
class HeightLines {
 public:
  // The grid has no holes and at least two by two points, the view no zoom (preconditions). A point that is behind an
  // occluder's edge by at most `grazing` units of the screen counts as visible.
  HeightLines(const scene::HeightGrid& grid, const algorithms::skala::View& view, double grazing = 0);

  [[nodiscard]] const std::vector<picture::ReferenceLine>& lines() const { return lines_; }
  // The samples that lines() join, by their numbers; empty for a contour.
  using Side = std::array<programs::skala::GridIndex, 2>;
  [[nodiscard]] const std::vector<std::optional<Side>>& sides() const { return sides_; }
  // The pieces of a native drawing of the same view, each with its line. A piece on no line gets a number that no
  // line has.
  [[nodiscard]] std::vector<picture::DrawnPiece> pieces_of(const picture::VectorDrawing& drawing) const;

 private:
  struct Ends {
    picture::PixelPoint point;
    double depth = 0;
  };
  struct Edge {
    Ends a;
    Ends b;
  };

  struct LevelEdge {
    Edge edge;
    std::uint32_t level = 0;  // 0: no contour, else 1 + its level
    std::optional<Side> side{};
  };
  class Hidden;

  [[nodiscard]] static Ends ends_of(const programs::skala::Vertex& vertex);
  // Add the sides of cells, and halves of cells with their contours. They store the occluders and return the lines to
  // draw.
  std::vector<LevelEdge> add_sides(const programs::skala::Projection& projection,
                                   const algorithms::skala::View& view);
  std::vector<LevelEdge> add_halves(const scene::HeightGrid& grid,
                                    const programs::skala::Projection& projection,
                                    const std::vector<double>& levels);
  void add_line(const LevelEdge& inked);
  [[nodiscard]] std::vector<picture::LinePart> seen_of(const Edge& line) const;
  [[nodiscard]] picture::LineId line_at(const picture::PixelSegment& piece, std::uint32_t level) const;

  double grazing_;
  std::vector<Edge> hiding_;
  std::vector<std::vector<std::uint32_t>> hiding_in_;  // by column of the screen
  std::vector<picture::ReferenceLine> lines_;
  std::vector<std::uint32_t> levels_;                 // of lines_
  std::vector<std::optional<Side>> sides_;            // of lines_
  std::vector<std::vector<std::uint32_t>> lines_in_;  // by column of the screen
};

// The visible cell of a height grid at each of the 256 by 256 points, by comparing depths: the reference for native
// pictures of surfaces, which are facets painted from far to near.
//
// A cell is two flat triangles, divided between its leftmost and rightmost corner in the image. Cells are numbered
// from 1, x first; 0 means no surface. On a side, either cell is right.

// Points closer than this, in dots, are equal: the coordinates of a native drawing are multiples of far less.
inline constexpr double same_place = 0.02;

// The grid has no holes and at least two by two points, the view no zoom (preconditions of both).
[[nodiscard]] picture::PixelGrid nearest_cells(const scene::HeightGrid& grid,
                                               const algorithms::skala::View& view);
// The topmost facet of a native drawing of the same view, as the number of its cell. A facet on no cell gets a number
// above all cells.
[[nodiscard]] picture::PixelGrid painted_cells(const scene::HeightGrid& grid, const algorithms::skala::View& view,
                                               const picture::VectorDrawing& drawing);

}  // namespace sightline::compare
