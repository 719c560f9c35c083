// Which edges of a scene are drawn, and as what: the outline, creases, rims, not the net of triangles.
//
// Two faces at an edge are in one plane if they are of one surface (PolyScene::surfaces), or, in a scene
// without surfaces, if they are coplanar; an edge between them is never chosen unless all are. What faces the
// eye is decided for a surface as a whole, by the sum of its faces' areas and a corner of its largest one;
// edge-on counts as turned away; where faces cross, one that is turned away hides the line. Angles are those
// between the surfaces' planes in the coordinates of the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/geometry/predicates.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/edge_table.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::picture {

// In the order in which an edge that is several of them is named.
enum class EdgeKind : std::uint8_t {
  silhouette,  // between a face turned to the eye and one turned away
  junction,    // of three or more faces
  boundary,    // of one face
  crease,      // between two that bend by more than the angle
  border,      // between two materials
  intersection,  // where two faces cross: PolyScene::crossings
  wire,        // a line of no face, or one between two faces that is none of the above
  flat,        // the others: drawn only where all edges are
};
inline constexpr std::size_t edge_kind_count = 8;
inline constexpr std::array<std::string_view, edge_kind_count> edge_kind_names{"silhouette", "junction",     "boundary", "crease",
                                                                              "border",     "intersection", "wire",     "flat"};

struct EdgeChoice {
  std::array<bool, edge_kind_count> kinds{true, true, true, true, true, true, true, false};
  double crease = 30;  // degrees

  // Creases from nothing on, and what is flat, too.
  [[nodiscard]] bool all() const { return kinds[static_cast<std::size_t>(EdgeKind::flat)]; }
};

// "all", "feature", or names of kinds with commas between them; junctions always belong to it. Empty for anything else.
[[nodiscard]] std::optional<EdgeChoice> edge_choice_named(std::string_view text);

// The edges chosen for one camera, ascending.
struct ChosenEdges {
  std::vector<LineEdge> edges;
  std::vector<EdgeKind> kinds;
  // Of each edge: all its surfaces are those of solids and turned away, so that it is not seen.
  std::vector<std::uint8_t> turned_away;
  // Of each edge: the surfaces at it, whose faces do not hide it; empty in a scene without surfaces.
  std::vector<std::uint32_t> first_surface = {0};  // and where the last one's end
  std::vector<std::uint32_t> surfaces;

  [[nodiscard]] std::span<const std::uint32_t> surfaces_at(std::size_t edge) const {
    return std::span(surfaces).subspan(first_surface[edge], first_surface[edge + 1] - first_surface[edge]);
  }
  // How many of each kind.
  [[nodiscard]] std::array<std::size_t, edge_kind_count> counts() const;
};

// What of a choice does not depend on the camera.
class EdgeChooser {
 public:
  // The scene outlives the chooser.
  EdgeChooser(const scene::PolyScene& scene, const EdgeChoice& choice);

  [[nodiscard]] ChosenEdges at(const scene::PolyCamera& camera) const;

 private:
  struct Surface {
    geometry::Vector3 normal{};  // twice its area, as a vector
    scene::VertexIndex on = 0;
    bool solid = false;
    double largest = -1;  // squared area of the face that `on` belongs to
  };

  void find_surfaces();
  [[nodiscard]] EdgeKind kind_without_eye(std::size_t edge) const;
  [[nodiscard]] bool bends(std::uint32_t a, std::uint32_t b, bool agree) const;

  const scene::PolyScene& scene_;
  EdgeChoice choice_;
  scene::EdgeTable edges_;
  std::vector<std::uint32_t> surface_of_;  // of each face
  std::vector<Surface> surfaces_;
  std::vector<std::array<double, 3>> directions_;  // of the surfaces' normals, of length 1
  double least_cosine_ = 1;                        // between surfaces that do not bend more than the angle
  std::vector<EdgeKind> kinds_;  // without an eye
  std::vector<std::array<std::uint32_t, 2>> wires_on_;  // PolyScene::wires_on, with the number of the edge; ascending
};

// What of a picture is of these edges.
[[nodiscard]] LinePicture only(const LinePicture& picture, const ChosenEdges& chosen);

}  // namespace sightline::picture
