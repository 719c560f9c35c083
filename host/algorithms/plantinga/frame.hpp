// One frame of a turning scene: the image of every visible piece (equations 1 to 5a of Plantinga, Seales and
// Dyer 1990), and of every edge whole, the wire frame it is measured against.
#pragma once

#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/rotation_model.hpp"

namespace sightline::algorithms::plantinga {

// In scene units: u = x cos - z sin to the right, v = y up.
struct ImageLine {
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};

class FrameMaker {
 public:
  explicit FrameMaker(const RotationModel& model);

  // The graph's view at an angle between the events around it. T-junctions of edges that are nearly parallel
  // in the image are kept within their edge. `lines` is filled anew.
  void visible(const EdgeStructureGraph& graph, double angle, std::vector<ImageLine>& lines);
  void wire(double angle, std::vector<ImageLine>& lines);

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
  void place(double angle);
  [[nodiscard]] Place place_of(EdgeIndex edge, const End& end) const;
  [[nodiscard]] double passage_of(EdgeIndex edge, FaceIndex face) const;

  std::vector<Point> points_;
  std::vector<Ends> edges_;
  std::vector<Plane> planes_;  // of faces
  std::vector<Place> places_;
};

}  // namespace sightline::algorithms::plantinga
