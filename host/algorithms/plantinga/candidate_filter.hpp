// Drops potential events that cannot change the picture: a filter in doubles that keeps every uncertain event.
//
// A potential event happens at a point of its farthest edge. It has no effect if that point, with a margin
// for all rounding, is hidden by another face, or if an edge that should hide is no contour: between two
// faces that hide on both of its sides, or none (asp specification, section 4). What the filter passes
// by mistake is dropped later, when the structures before and after turn out equal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/algorithms/plantinga/rotation_model.hpp"

namespace sightline::algorithms::plantinga {

// A direction of unit length, X = sin, Z = cos, and how far it may be off.
struct NearDirection {
  double x = 0;
  double z = 1;
  double error = 0;
};

// Faces in doubles, divided into convex parts: shared by all edges of a model.
class ConvexParts {
 public:
  explicit ConvexParts(const RotationModel& model);

  struct Point {
    double x = 0, y = 0, z = 0;
  };
  struct Face {
    std::uint32_t first_part = 0;
    std::uint32_t last_part = 0;
    Point normal;  // unit length
    Point on;      // a corner
    double low = 0, high = 0;
  };

  [[nodiscard]] const Face& face(FaceIndex index) const { return faces_[index]; }
  [[nodiscard]] double size() const { return size_; }
  // p is inside the image of a part of the face by more than the margin. side: of the face that is looked at.
  [[nodiscard]] bool covers(FaceIndex index, int side, const Point& p, const NearDirection& v,
                            double margin) const;

 private:
  std::vector<Face> faces_;
  std::vector<std::uint32_t> part_start_;
  std::vector<Point> points_;
  double size_ = 1;
};

// The filter for one edge.
class CandidateFilter {
 public:
  CandidateFilter(const RotationModel& model, const ConvexParts& parts, EdgeIndex edge,
                  const std::vector<Occluder>& occluders);

  // The point at parameter s of the edge, known to ds, is surely hidden.
  [[nodiscard]] bool hidden(double s, double ds, const NearDirection& v);
  // The other edge surely bounds nothing that is hidden.
  [[nodiscard]] bool no_contour(EdgeIndex other, const NearDirection& v) const;

 private:
  const RotationModel& model_;
  const ConvexParts& parts_;
  const std::vector<Occluder>& occluders_;
  ConvexParts::Point from_;
  ConvexParts::Point along_;
  double length_ = 0;
  std::size_t last_ = 0;  // the occluder that hid last: likely to hide again
};

}  // namespace sightline::algorithms::plantinga
