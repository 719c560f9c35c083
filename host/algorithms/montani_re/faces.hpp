// The faces of a view as input of the list-priority algorithm: their planes and extents in the camera's frame, and their
// regions in the image.
//
// Left out are faces seen edge-on (they have no area, so they are in no relation), faces of solids that are turned away,
// and faces behind the eye. In perspective, the image of a face that is partly in front of and partly behind the eye runs to
// infinity; then the space in front of the eye is divided into pyramids, each with its own window (pyramids.hpp).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/montani_re/image.hpp"
#include "host/algorithms/montani_re/outline.hpp"
#include "host/algorithms/montani_re/trapezoid_pcs.hpp"
#include "host/algorithms/montani_re/window.hpp"
#include "host/base/result.hpp"
#include "host/base/short_list.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::montani_re {

// numerator / denominator, the denominator positive. Compared in floating point first, and exactly if that is equal.
struct ImageNumber {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  double approximate = 0;
};
[[nodiscard]] int compare(const ImageNumber& a, const ImageNumber& b);

struct Face {
  std::uint32_t body = 0;
  std::uint32_t index = 0;  // in its body
  base::ShortList<std::uint32_t, 6> vertices;
  base::ShortList<std::uint32_t, 6> lines;
  // By line: the sign of a X + b Y + c on the whole image of the face; 0 if both signs occur, or there is a window.
  base::ShortList<std::int8_t, 8> inner_side;
  std::uint32_t first_quad = 0;  // into FaceSet::outlines
  std::uint32_t quads = 0;       // 0 if no line has the whole image on one side
  bool convex = true;            // every line has the whole image on one side
  // normal . p = offset, oriented so that the near side is negative. A component of the normal is twice an area of the
  // face, which is within a square of 2^38: below 2^77. So the offset, and a vertex times the normal, is below 3 * 2^(77
  // + 37), which is less than 2^116.
  static constexpr unsigned normal_bits = 77;
  static constexpr unsigned offset_bits = normal_bits + vertex_bits + 2;
  std::array<geometry::Int128, 3> normal{};
  geometry::Int128 offset = 0;
  std::array<double, 4> approximate_plane{};  // the normal and the offset, each within one part in 2^53
  std::array<ImageNumber, 2> low;  // X, Y
  std::array<ImageNumber, 2> high;
  std::int64_t nearest = 0;  // Z
  std::int64_t farthest = 0;
  TrapezoidPcs pcs;

  // Negative on the near side of the plane, 0 in it.
  [[nodiscard]] int side(const Vertex& p) const {
    const std::array<double, 3> parts{approximate_plane[0] * static_cast<double>(p.x),
                                      approximate_plane[1] * static_cast<double>(p.y),
                                      approximate_plane[2] * static_cast<double>(p.z)};
    const double near_to = parts[0] + parts[1] + parts[2] - approximate_plane[3];
    // Fewer than six roundings of at most 2^-53 of the terms; the bound is more than twice that.
    const double error = 0x1p-49 * (std::abs(parts[0]) + std::abs(parts[1]) + std::abs(parts[2]) +
                                    std::abs(approximate_plane[3]));
    if (std::abs(near_to) > error) return near_to > 0 ? 1 : -1;
    const geometry::Int128 at = normal[0] * p.x + normal[1] * p.y + normal[2] * p.z - offset;
    return (at > 0 ? 1 : 0) - (at < 0 ? 1 : 0);
  }
};

struct FaceSet {
  Image image{false};
  std::vector<Face> faces;
  std::vector<OutlineQuad> outlines;
  std::vector<picture::LineEdge> edges;  // by line of the image: vertices of the image
  std::uint64_t edge_on = 0;             // number of faces left out
  std::vector<std::uint32_t> isolated;       // lines of isolated edges (isolated_edges.hpp)
  std::optional<Window> window;          // the window to which the regions are clipped

  [[nodiscard]] std::span<const OutlineQuad> outline_of(const Face& face) const {
    return {outlines.data() + face.first_quad, face.quads};
  }
};

// What can be concluded about the images of two faces from the sides of lines on which their corners are. For convex
// faces without a window, every pair that is disjoint or covered is recognized.
enum class Placement {
  apart,    // no area in common
  covered,  // the second has all of the first
  mixed     // neither, or not known
};
[[nodiscard]] Placement placement_of(const FaceSet& set, const Face& first, const Face& second);

// Rings of vertices of the image. Each ring is a closed polygon; all are in one plane.
using Rings = std::vector<std::vector<std::uint32_t>>;

class FaceSetBuilder {
 public:
  explicit FaceSetBuilder(bool perspective, std::int64_t divisor = 1) { set_.image = Image(perspective, divisor); }

  // Reserves memory. More vertices and faces may be added.
  void reserve(std::size_t vertices, std::size_t faces);
  std::uint32_t add_vertex(const Vertex& v) { return set_.image.add_vertex(v); }
  // Clips all faces added later to a window; these may reach behind the eye. Precondition: all vertices are added.
  void clip_to(const WindowBounds& bounds);
  // Returns false and adds nothing if the face is seen edge-on or is outside the window. Precondition: without a window
  // all vertices are in front of the eye.
  bool add_face(const Rings& rings, std::uint32_t body, std::uint32_t index);
  // Adds an edge that is compared with each face separately (isolated_edges.hpp).
  void add_isolated_edge(std::uint32_t v, std::uint32_t w);
  [[nodiscard]] FaceSet take();

 private:
  // Returns `none` if the image of the edge is a point or the edge is not in front of the eye.
  [[nodiscard]] std::uint32_t line_between(std::uint32_t v, std::uint32_t w);
  void measure(Face& face) const;
  void find_inner_sides(Face& face) const;
  void add_outline(Face& face);
  [[nodiscard]] TrapezoidPcs whole_pcs(const Face& face) const;

  FaceSet set_;
  std::vector<std::uint32_t> last_line_at_;  // by lower vertex
  std::vector<std::uint32_t> line_before_;   // by line: the preceding line at the same lower vertex
};

// Vertices keep the scene's numbers. Precondition: the scene is checked. The error names a face that is partly in front of
// and partly behind the eye.
[[nodiscard]] base::Result<FaceSet> faces_of(const scene::PolyScene& scene, const scene::PolyCamera& camera);

}  // namespace sightline::algorithms::montani_re
