// Checks a drawing for correct visibility by a ray caster in doubles that shares no code with the product.
//
// The edges to draw are determined from the mesh alone: lines of the file, edges of one face, edges of three or more faces,
// edges whose faces bend by more than 30 degrees, and edges whose faces are on the same side of the edge in the image. Seeded
// samples on these edges are visible if no face is between them and the eye. Each visible sample must be on a visible stroke.
// Samples of visible strokes, projected back to the source edges of the stroke, must not all be hidden. No stroke overlaps
// another.
//
// The product rounds vertices to a grid. Samples are therefore skipped where a shift of a vertex by `rounding` could change the
// result: near the outline of a face in the image, or near a face in space. Edges are skipped if such a shift, or the precision
// of the file, could change their kind, or if a foreign vertex is so near that mending may merge the two. Borders between
// materials and lines in which faces cross are only checked for not being hidden.
//
// The position of the image on the paper is not taken from the product: scale and shift minimise the distances of the stroke ends
// from the lines of their source edges, and the largest remaining distance is checked as well.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/plain_mesh.hpp"

namespace sightline::tests {

using Point2 = std::array<double, 2>;

// As in --json: the image of a point at d = p - eye is right.d / |right| and up.d / |up|, in perspective divided by
// forward.d / |forward|.
struct PlainView {
  bool perspective = false;
  Point3 eye{};
  Point3 forward{};
  Point3 right{};
  Point3 up{};
};

// One line of --strokes.
struct PlainStroke {
  Point2 from{};  // in mm from the bottom left corner of the paper
  Point2 to{};
  bool hidden = false;
  std::string kind;
  std::vector<std::array<Point3, 2>> edges;  // in the unit of the file
};

// From the documents of `sightline draw --json` and --strokes. Both throw exceptions of nlohmann::json.
[[nodiscard]] PlainView view_of_json(const std::string& document);
[[nodiscard]] std::vector<PlainStroke> strokes_of_lines(const std::string& lines);

struct RayReport {
  std::size_t feature_edges = 0;   // edges that must be drawn
  std::size_t unclear_edges = 0;   // edges of uncertain kind
  std::size_t samples = 0;         // on feature edges
  std::size_t visible = 0;         // of these, certainly visible
  std::size_t undrawn = 0;         // of these, not on a stroke
  std::size_t stroke_samples = 0;  // on visible strokes
  std::size_t hidden_drawn = 0;    // of these, certainly hidden
  std::size_t dash_samples = 0;    // on hidden strokes
  std::size_t visible_dashed = 0;  // of these, certainly visible
  std::size_t off_edge = 0;        // samples of strokes on none of their source edges
  std::size_t drawn_twice = 0;     // samples of strokes, visible or hidden, that another stroke also draws
  double scale = 0;                // mm for one unit of the image
  double residual = 0;             // in mm: the largest distance of an end of a stroke from its source edge
  double allowed_residual = 0;
  std::vector<std::string> faults;  // descriptions of the first faults, with their position in the file and on the paper

  [[nodiscard]] bool good() const {
    return undrawn == 0 && hidden_drawn == 0 && visible_dashed == 0 && off_edge == 0 && drawn_twice == 0 &&
           residual <= allowed_residual;
  }
};

// The same seed gives the same samples. In perspective the eye must be outside the mesh and all of the mesh in front of it.
[[nodiscard]] RayReport check_by_rays(const PlainMesh& mesh, const PlainView& view, const std::vector<PlainStroke>& strokes,
                                      std::uint32_t seed);

}  // namespace sightline::tests
