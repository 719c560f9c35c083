// One frame of a turning scene: the image of every visible piece (equations 1 to 5a of Plantinga, Seales and Dyer 1990),
// or of every whole edge (the wire frame, for comparison).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/eye_circle.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"

namespace sightline::algorithms::plantinga {

// In scene units: u = x cos - z sin to the right, v = y up. On a circle of the eye, the axes of the image are those of a viewer who
// looks from the eye at angle 0 to `about`, with y up, and before whom the scene turns; in perspective, lengths are those at
// the distance of `about`.
struct ImageLine {
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};
// In scene units, in space.
struct SpaceLine {
  std::array<double, 3> from{};
  std::array<double, 3> to{};
};

// The image at one angle of a circle.
class CircleImage {
 public:
  // Precondition: the eye is not straight above or below `about`.
  CircleImage(const EyeCircle& circle, double angle);

  struct Place {
    double u, v;
    double depth;  // from the eye, in units of the distance of `about`; 1 in parallel projection
  };
  [[nodiscard]] Place of(const std::array<double, 3>& p) const;

 private:
  std::array<double, 3> about_;
  std::array<double, 3> right_;
  std::array<double, 3> up_;
  std::array<double, 3> deeper_{};  // 0 in parallel projection
};

class FrameMaker {
 public:
  explicit FrameMaker(const RotationModel& model);
  // Precondition: the eye is not straight above or below `about`.
  FrameMaker(const RotationModel& model, const EyeCircle& circle);

  // The view of the graph at an angle between the adjacent events. T-junctions of edges that are nearly parallel in the
  // image are kept within their edge. `lines` is overwritten.
  void visible(const EdgeStructureGraph& graph, double angle, std::vector<ImageLine>& lines);
  void wire(double angle, std::vector<ImageLine>& lines);
  // The same pieces before rotation, for a display that rotates and projects them itself (the paper's 3-D vector drawing
  // hardware): only the ends of pieces are computed. Precondition: not in perspective.
  void visible_in_space(const EdgeStructureGraph& graph, double angle, std::vector<SpaceLine>& lines);

  // Computes the image of every vertex at an angle. visible and wire call it.
  void place(double angle);
  // The parameter of an end of a piece on the image of its edge, from 0 at the edge's first vertex to 1 at its second, at the
  // angle given to place(). In parallel projection, it is that on the edge.
  [[nodiscard]] double parameter_of(EdgeIndex edge, const End& end) const;

 private:
  struct Point {
    double x, y, z;
  };
  struct Ends {
    std::uint32_t from, to;
  };
  struct Place {
    double u, v;
  };
  struct Plane {
    Point normal;
    double offset;
  };
  // An end of a piece that is not a vertex.
  struct Inner {
    std::uint32_t end_of_line;  // twice the line's number, plus 1 for the high end
    EdgeIndex edge;
    End end;
  };
  // Resizes `lines` to one line per piece, sets the ends of each that are vertices by put(line, from, to), and records
  // the other ends.
  template <class Lines, class Put>
  void put_vertices(const EdgeStructureGraph& graph, Lines& lines, Put put);
  [[nodiscard]] double passage_of(EdgeIndex edge, FaceIndex face) const;
  [[nodiscard]] double junction_of(EdgeIndex edge, EdgeIndex other) const;
  [[nodiscard]] double contact_of(EdgeIndex edge, std::uint32_t vertex) const;
  // The parameter on the image of an edge of the point with a parameter on the edge.
  [[nodiscard]] double image_parameter(EdgeIndex edge, double at) const;

  std::optional<EyeCircle> circle_;
  std::vector<Point> points_;
  std::vector<Ends> edges_;
  std::vector<Plane> planes_;  // by face
  std::vector<Place> places_;
  std::vector<double> depths_;  // on a circle in perspective: from the eye, in units of the distance of `about`; otherwise empty
  std::vector<Inner> inner_;  // the first inner_count_ entries are valid
  std::size_t inner_count_ = 0;
};

}  // namespace sightline::algorithms::plantinga
