// Decides which edges of a scene are drawn and as which kind: silhouettes, creases and boundaries, but not the net of
// triangles.
//
// Two faces at an edge are in one plane if they belong to one surface (PolyScene::surfaces) or, in a scene without
// surfaces, if they are coplanar. An edge between them is only chosen if all edges are. Whether a surface is turned to
// the eye is decided for the whole surface, by the sum of its faces' areas and a corner of its largest face; edge-on
// counts as turned away. Where faces cross, a face that is turned away hides the line. Angles are those between the
// surfaces' planes in the coordinates of the file.
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

// An edge of several kinds has the first of them.
enum class EdgeKind : std::uint8_t {
  silhouette,  // between a face turned to the eye and one turned away
  junction,    // of three or more faces
  boundary,    // of one face
  crease,      // between two faces that bend by more than the angle
  border,      // between two materials
  intersection,  // where two faces cross: PolyScene::crossings
  wire,        // a line of no face, or one between two faces that is none of the above
  flat,        // all other edges: drawn only if all are
};
inline constexpr std::size_t edge_kind_count = 8;
inline constexpr std::array<std::string_view, edge_kind_count> edge_kind_names{"silhouette", "junction",     "boundary", "crease",
                                                                              "border",     "intersection", "wire",     "flat"};

struct EdgeChoice {
  std::array<bool, edge_kind_count> kinds{true, true, true, true, true, true, true, false};
  double crease = 30;  // degrees

  // Whether all edges are drawn, flat ones included.
  [[nodiscard]] bool all() const { return kinds[static_cast<std::size_t>(EdgeKind::flat)]; }
};

// "all", "feature", or names of kinds separated by commas; junctions are always included. nullopt for anything else.
[[nodiscard]] std::optional<EdgeChoice> edge_choice_named(std::string_view text);

// The edges chosen for one camera, ascending.
struct ChosenEdges {
  std::vector<LineEdge> edges;
  std::vector<EdgeKind> kinds;
  // By edge: 1 if all its surfaces belong to solids and are turned away, so that it is hidden.
  std::vector<std::uint8_t> turned_away;
  // By edge: the surfaces that it belongs to, whose faces do not hide it. Empty in a scene without surfaces.
  std::vector<std::uint32_t> first_surface = {0};  // by edge, and the end of the last one
  std::vector<std::uint32_t> surfaces;

  [[nodiscard]] std::span<const std::uint32_t> surfaces_at(std::size_t edge) const {
    return std::span(surfaces).subspan(first_surface[edge], first_surface[edge + 1] - first_surface[edge]);
  }
  // Number of edges by kind.
  [[nodiscard]] std::array<std::size_t, edge_kind_count> counts() const;
};

// The part of a choice that does not depend on the camera.
class EdgeChooser {
 public:
  // The scene must outlive the chooser. `jobs` threads; the result is the same for any number.
  EdgeChooser(const scene::PolyScene& scene, const EdgeChoice& choice, unsigned jobs = 1);

  [[nodiscard]] ChosenEdges at(const scene::PolyCamera& camera) const;

 private:
  struct Surface {
    geometry::Vector3 normal{};  // twice its area, as a vector
    scene::VertexIndex on = 0;  // a corner of its largest face
    bool solid = false;
  };

  // Of each surface: 1 if it faces the eye, -1 if it is turned away, 0 if it is seen from the side.
  struct Facing {
    std::int8_t sign = 0;
    bool away = false;  // of a solid, and not to the eye
  };

  void find_surfaces();
  // Without surfaces in the scene, each face is a surface.
  [[nodiscard]] std::uint32_t surface_of(std::uint32_t face) const { return scene_.surfaces.empty() ? face : scene_.surface_of[face]; }
  [[nodiscard]] const std::array<double, 3>& direction(std::uint32_t surface) const {
    return scene_.surfaces.empty() ? directions_[surface] : scene_.surfaces[surface].normal;
  }
  [[nodiscard]] std::vector<Facing> facing_of(const scene::PolyCamera& camera) const;
  // The chosen ones of the edges `begin` to `end` - 1.
  [[nodiscard]] ChosenEdges chosen_of(const std::vector<Facing>& facing, std::size_t begin, std::size_t end) const;
  [[nodiscard]] EdgeKind kind_without_eye(std::size_t edge) const;
  [[nodiscard]] bool bends(std::uint32_t a, std::uint32_t b, bool agree) const;

  const scene::PolyScene& scene_;
  EdgeChoice choice_;
  unsigned jobs_;
  scene::EdgeTable edges_;
  std::vector<Surface> surfaces_;
  std::vector<std::array<double, 3>> directions_;  // of the faces' normals, of length 1; empty if the scene has surfaces
  double least_cosine_ = 1;                        // between surfaces that do not bend more than the angle
  std::vector<EdgeKind> kinds_;  // without an eye
  std::vector<std::array<std::uint32_t, 2>> wires_on_;  // PolyScene::wires_on by edge number; ascending
};

// The pieces of a picture that belong to these edges.
[[nodiscard]] LinePicture only(const LinePicture& picture, const ChosenEdges& chosen);

}  // namespace sightline::picture
