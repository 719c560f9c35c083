// Drops potential events that cannot change the picture. The filter works in doubles and keeps every uncertain event.
//
// A potential event happens at a point of its farthest edge. It has no effect if that point, with a margin for all
// rounding errors, is hidden by another face, or if an edge that would have to hide is not a contour: the faces on its
// two sides both hide, or neither does (asp specification, section 4). Ineffective events that the filter keeps are
// dropped later, when the structures before and after turn out to be equal.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/plantinga/rotation_model.hpp"

namespace sightline::algorithms::plantinga {

// A direction of unit length, X = sin, Z = cos, and a bound of its error.
struct NearDirection {
  double x = 0;
  double z = 1;
  double error = 0;
};

// The faces in doubles, divided into convex parts. Shared by all edges of a model.
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
  // The corners of a convex part, counterclockwise seen from outside.
  [[nodiscard]] std::span<const Point> part(std::uint32_t index) const {
    return {points_.data() + part_start_[index], points_.data() + part_start_[index + 1]};
  }
  // Whether p is inside the image of a part of the face by more than the margin. `side`: the side of the face towards the
  // viewer.
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

  // Whether the point at parameter s of the edge, with error ds, is certainly hidden.
  [[nodiscard]] bool hidden(double s, double ds, const NearDirection& v);
  // Whether the other edge is certainly not the boundary of anything hidden.
  [[nodiscard]] bool no_contour(EdgeIndex other, const NearDirection& v) const;

 private:
  const RotationModel& model_;
  const ConvexParts& parts_;
  const std::vector<Occluder>& occluders_;
  ConvexParts::Point from_;
  ConvexParts::Point along_;
  double length_ = 0;
  std::size_t last_ = 0;  // the occluder that hid the last point: likely to hide the next one
};

}  // namespace sightline::algorithms::plantinga
