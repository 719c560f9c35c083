// Why each part of an edge is hidden: for each side of the edge's image line, the faces that hide it there.
#pragma once

#include <cstdint>
#include <vector>

#include "host/base/watch.hpp"
#include "host/geometry/rational.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::exact {

struct EdgeMesh;

// An interval of an edge that one face hides from one side. Of a crossing, the ends are rounded to multiples of 2^-60.
struct Witness {
  // Instead of a face: this part is behind the eye.
  static constexpr std::uint32_t behind_eye = ~0U;

  geometry::Rational low;
  geometry::Rational high;     // greater than low
  std::uint32_t face = 0;      // numbered over all bodies from 0

  friend bool operator==(const Witness&, const Witness&) = default;
};

struct EdgeProof {
  enum class Reason : std::uint8_t {
    witnesses,    // it is visible except where it is hidden from both sides
    // All of it is hidden by its own solid, whose faces (or surfaces) at the edge are turned away. The witnesses may then leave parts
    // over, because faces of the edge's own surfaces are none.
    turned_away,
    point,        // it is seen end-on
  };

  picture::LineEdge edge;
  Reason reason = Reason::witnesses;
  // Ascending by both ends. They may overlap; no witness can be left out. What no witness covers is visible from that
  // side. Left of the edge is the side where the plane through the eye and the edge is positive: EdgeSight::side.
  std::vector<Witness> left;
  std::vector<Witness> right;
};

// Like visible_edges on one thread. `proofs` receives a proof for each edge of the mesh, or for each chosen one, in
// ascending order.
[[nodiscard]] picture::LinePicture visible_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                                                 const picture::ChosenEdges* chosen, std::vector<EdgeProof>& proofs,
                                                 const base::Watch& watch = {});

}  // namespace sightline::algorithms::exact
