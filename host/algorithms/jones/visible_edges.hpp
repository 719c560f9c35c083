// The exactly visible parts of the edges of a scene, by the method of Jones (1971) in general position: cells and
// openings of any orientation, perspective and orthographic views, the eye anywhere in free space.
//
// A cell is seen through a mask: the part of the image that the openings on the way to it leave. The cell's lines are
// clipped to the mask and drawn. The next cell is seen through each opening that faces the eye and of which the mask
// leaves an area. Invisible cells are never entered, and the work of a view does not grow with their number.
//
// Why this gives the two-sided rule (host/algorithms/oracle/edge_oracle.hpp) if lines on the boundary of a cell and of a
// mask are drawn:
// - Let a point x of an edge be seen from one side, x not one of the finitely many points where anything changes along
//   the edge. Then the sight line to x, moved a little to that side, passes through the interiors of cells and openings
//   until its next step would reach x. So x is in the closure of the last cell and in that of its mask; the mask has an
//   area, because it contains the nearby directions on that side. Faces through x do not stop the sight line before x.
// - Conversely, let x be in the closure of a cell and of a mask through which the cell is seen. Take a point p of the last
//   opening passed, in the interior of the mask, not in one plane with the eye and the edge. The cell is convex: the
//   segment from p to x is in its closure, and all of it except x is seen in the interior of the mask. So points
//   arbitrarily near to x are seen, all on one side of the edge's image: x is seen from that side. Before the first
//   opening there is no mask, and p may be any point of the start cell.
// A mask without an area hides everything beyond it, and an opening seen edge-on is never passed. Both are right: if what
// is beyond is visible at all, it is seen through other openings.
//
// The paper's program drew each opening's outline and each cell's lines as it reached them. Here the union of the pieces
// of each edge is drawn, so the picture does not depend on the order.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "host/algorithms/jones/prepared_complex.hpp"
#include "host/base/result.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/cell_complex.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::jones {

// The work that a view took.
struct Counts {
  std::uint64_t visits = 0;           // of cells
  std::uint64_t cells = 0;            // distinct cells visited
  std::uint64_t openings_tested = 0;  // facing the eye, in visited cells
  std::uint64_t masks = 0;            // tested openings of which an area was left
  std::uint64_t lines_clipped = 0;
  std::uint64_t fragments = 0;    // pieces left by clipping, before the union
  std::uint64_t depth = 0;        // greatest number of openings passed on the way to a cell, plus 1
  std::uint64_t mask_sides = 0;   // greatest number of sides of a mask
  std::uint64_t number_bits = 0;  // bits of the numbers that planes of sight were computed in: 64 or 128

  friend bool operator==(const Counts&, const Counts&) = default;
};

struct View {
  picture::LinePicture picture;
  Counts counts;
};

// The errors of visible_edges: why there is no view.
inline constexpr std::string_view eye_in_solid = "the eye is inside a solid";
inline constexpr std::string_view eye_too_far = "the eye is beyond the limit of coordinates, 262143";
inline constexpr std::string_view plane_too_long =
    "a plane of the cell complex has coefficients beyond those of planes through points of a scene";
// A sight line does not end, or a line ends where nothing crosses it.
inline constexpr std::string_view no_complex =
    "the cells and openings contradict each other: they are not a cell complex";

// Computes views of one complex from many eyes. The time of a view depends only on what it sees. For one thread at a
// time; several Walkers may share the prepared complex, which must outlive them. Takes memory for each cell and each
// opening.
class Walker {
 public:
  explicit Walker(const PreparedComplex& prepared);
  ~Walker();
  Walker(Walker&&) noexcept;
  Walker& operator=(Walker&&) noexcept;

  [[nodiscard]] base::Result<View> visible_edges(const scene::PolyCamera& camera);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Prepares the complex for this view alone.
[[nodiscard]] base::Result<View> visible_edges(const scene::CellComplex& complex,
                                               const scene::PolyCamera& camera);

// The same, reporting each step to `trace` (trace.hpp).
class Trace;
[[nodiscard]] base::Result<View> visible_edges(const scene::CellComplex& complex, const scene::PolyCamera& camera, Trace& trace);

}  // namespace sightline::algorithms::jones
