// The exactly visible parts of the edges of a scene, by the method of Jones (1971) in general position:
// cells and openings of any direction, perspective and orthographic views, the eye anywhere in free space.
//
// A cell is seen through a mask, the part of the image left by the openings on the way to it. Its lines are
// clipped to the mask and drawn; through each of its openings that faces the eye, and of which the mask
// leaves an area, the next cell is seen. Invisible cells are never entered, and no work of a view
// grows with their number.
//
// Why this gives the two-sided rule (host/algorithms/oracle/edge_oracle.hpp), lines lying on the boundary of
// a cell and of a mask being drawn:
// - A point x of an edge, not one of the finitely many where anything changes along it, be seen from one
//   side. Then the sight line to it, moved a little to that side, passes cells and openings in their
//   insides until its next step would reach x; so x is on the closure of the last cell, and on that of its
//   mask, which has an area, since it has the directions close by on that side. Faces through x itself do
//   not stop the sight line before it.
// - Conversely let x be on the closure of a cell and of a mask it is seen through. Take a point p of the
//   opening that was passed last, in the inside of the mask, not in one plane with the eye and the edge. The
//   cell is convex: from p to x all is in its closure, and all but x is seen in the inside of the mask. So
//   points as near to x as you like are seen, all on one side of the edge's image: x is seen from that side.
//   Before the first opening there is no mask, and p may be any point of the start cell.
// A mask without an area hides all behind it, an opening seen edge-on is never passed, and both are right:
// what is on its other side is seen, if at all, through other openings.
//
// The paper's program drew each opening's outline and each cell's lines as it met them. Here the union is
// taken for each edge, and the picture is canonical.
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

// What a view took.
struct Counts {
  std::uint64_t visits = 0;           // of cells
  std::uint64_t cells = 0;            // visited, each once
  std::uint64_t openings_tested = 0;  // facing the eye, in a cell visited
  std::uint64_t masks = 0;            // made: of the tested, those with an area left
  std::uint64_t lines_clipped = 0;
  std::uint64_t fragments = 0;    // left by clipping, before they are united
  std::uint64_t depth = 0;        // most openings passed to a cell, plus 1
  std::uint64_t mask_sides = 0;   // most of a mask
  std::uint64_t number_bits = 0;  // in which planes of sight were computed: 64 or 128

  friend bool operator==(const Counts&, const Counts&) = default;
};

struct View {
  picture::LinePicture picture;
  Counts counts;
};

// Why there is no view: what the error of visible_edges says.
inline constexpr std::string_view eye_in_solid = "the eye is inside a solid";
inline constexpr std::string_view eye_too_far = "the eye is beyond the limit of coordinates, 262143";
inline constexpr std::string_view plane_too_long =
    "a plane of the cell complex has coefficients beyond those of planes through points of a scene";
// A sight line does not end, or a line ends where nothing crosses it.
inline constexpr std::string_view no_complex =
    "the cells and openings are no cell complex: they contradict each other";

// Looks at one complex from many eyes, each view as quick as if nothing but what it sees were there. One
// thread at a time; several may share the prepared complex, which must outlive them. Needs memory for each
// cell and each opening.
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

// One view; the complex is prepared for it alone.
[[nodiscard]] base::Result<View> visible_edges(const scene::CellComplex& complex,
                                               const scene::PolyCamera& camera);

// The same, told to somebody step by step (trace.hpp).
class Trace;
[[nodiscard]] base::Result<View> visible_edges(const scene::CellComplex& complex, const scene::PolyCamera& camera, Trace& trace);

}  // namespace sightline::algorithms::jones
