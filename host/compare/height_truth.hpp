// The truly visible parts of the lines of a height picture, as vectors: the reference for native pictures by the
// line metrics, where the column oracle (host/algorithms/oracle/column_oracle.hpp) is the one for rasters.
//
// A line of the picture is a side of a cell, or a contour's way across half a cell; where it is seen is
// found by depth alone, with no order, mask or column: at a place of the screen it is hidden iff of the
// lines of the surface that are nearer on the same vertical one lies above it and one lies below. In between
// everything is linear, so the hidden parts are intervals, found pair by pair. On a surface without holes
// this is exactly the occluder; of slices it is the occluder of Skala's method.
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

// Cells are divided between the corners at their sides, as seen: from the least x and z to the greatest if
// this is so, else across. Where two corners are as near as each other, as the native algorithm takes them.
[[nodiscard]] bool rising_diagonals(const programs::skala::SineCosine& turn);

// The lines of a picture of lines or contours in 255 x 255 units, with what is seen of them.
class HeightLines {
 public:
  // The grid is a whole one of at least two by two, the view without zoom (preconditions).
  // What lies behind something nearer by no more than `grazing` units of the screen counts as seen.
  HeightLines(const scene::HeightGrid& grid, const algorithms::skala::View& view, double grazing = 0);

  [[nodiscard]] const std::vector<picture::ReferenceLine>& lines() const { return lines_; }
  // The samples that lines() join, by their numbers; none of a contour.
  using Side = std::array<programs::skala::GridIndex, 2>;
  [[nodiscard]] const std::vector<std::optional<Side>>& sides() const { return sides_; }
  // Pieces of a native drawing of the same view, each with the line it is on; pieces that are on none get a
  // number no line has.
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
  // Sides of cells, and halves of cells with the contours on them: occluders are kept, what is inked
  // returned.
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

// Which cell of a height grid is seen at each of the 256 by 256 points, by comparing depths: the reference
// for native pictures of surfaces, which are facets painted from far to near.
//
// A cell is two flat triangles, divided between the corners at its sides as seen. Cells are numbered from 1,
// x first; 0 is where there is no surface. A point on a side may be either cell's.

// Places nearer than this, in dots, are one: those of a native drawing are multiples of far less.
inline constexpr double same_place = 0.02;

// The grid is a whole one of at least two by two, the view without zoom (preconditions of both).
[[nodiscard]] picture::PixelGrid nearest_cells(const scene::HeightGrid& grid,
                                               const algorithms::skala::View& view);
// The topmost facet of a native drawing of the same view, by the cell it lies on; a facet that lies on none
// is numbered behind all cells.
[[nodiscard]] picture::PixelGrid painted_cells(const scene::HeightGrid& grid, const algorithms::skala::View& view,
                                               const picture::VectorDrawing& drawing);

}  // namespace sightline::compare
