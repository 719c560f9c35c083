// One frame of a turning scene: the image of every visible piece (equations 1 to 5a of Plantinga, Seales and
// Dyer 1990), and of every edge whole, the wire frame it is measured against.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"

namespace sightline::algorithms::plantinga {

// In scene units: u = x cos - z sin to the right, v = y up.
struct ImageLine {
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};
// In scene units, in space.
struct SpaceLine {
  std::array<double, 3> from{};
  std::array<double, 3> to{};
};

class FrameMaker {
 public:
  explicit FrameMaker(const RotationModel& model);

  // The graph's view at an angle between the events around it. T-junctions of edges that are nearly parallel
  // in the image are kept within their edge. `lines` is overwritten.
  void visible(const EdgeStructureGraph& graph, double angle, std::vector<ImageLine>& lines);
  void wire(double angle, std::vector<ImageLine>& lines);
  // The same pieces before they are turned, for a display that turns and projects them itself (the paper's
  // 3-D vector drawing hardware): only where they end is computed.
  void visible_in_space(const EdgeStructureGraph& graph, double angle, std::vector<SpaceLine>& lines);

  // Every vertex at an angle. visible and wire do this first.
  void place(double angle);
  // Where on the edge a piece of it ends, at the angle of the last place: 0 at its first vertex, 1 at its
  // second.
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
  // An end of a piece that is no vertex.
  struct Inner {
    std::uint32_t end_of_line;  // twice the line's number, and 1 more for the high end
    EdgeIndex edge;
    End end;
  };
  // Makes room for a line a piece, gives each piece the number of a line and its two vertices, and remembers
  // the ends that are none.
  template <class Lines, class Put>
  void put_vertices(const EdgeStructureGraph& graph, Lines& lines, Put put);
  [[nodiscard]] double passage_of(EdgeIndex edge, FaceIndex face) const;
  [[nodiscard]] double junction_of(EdgeIndex edge, EdgeIndex other) const;
  [[nodiscard]] double contact_of(EdgeIndex edge, std::uint32_t vertex) const;

  std::vector<Point> points_;
  std::vector<Ends> edges_;
  std::vector<Plane> planes_;  // of faces
  std::vector<Place> places_;
  std::vector<Inner> inner_;  // the first inner_count_ of them
  std::size_t inner_count_ = 0;
};

}  // namespace sightline::algorithms::plantinga
