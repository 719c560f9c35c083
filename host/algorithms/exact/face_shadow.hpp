// The part of one edge that one face hides, computed from signs alone.
//
// Let e be the edge and x a point of it. The side PQ of a face crosses the plane through the eye and e in Z
// iff P and Q are on different sides of it, and Z is then seen ahead of x along e iff
//   sign(side(P, Q, x)) * sign(side(e, Q) - side(e, P)) > 0
// (Binet and Cauchy: the difference of products that places Z is a product of these two). The face covers x
// iff an odd number of its crossings is ahead, whatever part of it lies behind the eye; it hides x iff x is
// moreover beyond its plane. Walking along e, "ahead" changes for a crossing where side(P, Q, x) vanishes, at
// a / (a - b), a and b being its values at the ends of e. From the left of e, a vertex on the plane of e
// counts as to the right, from the right as to the left.
#pragma once

#include <cstdint>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/algorithms/exact/hidden_part.hpp"
#include "host/algorithms/exact/view.hpp"

namespace sightline::algorithms::exact {

class EdgeShadow {
 public:
  explicit EdgeShadow(const View& view) : view_(view) {}

  // Begins another edge, of which nothing is hidden yet but what lies behind the eye.
  void begin(std::uint32_t edge);
  // Adds what a face hides. True once the whole edge is hidden.
  bool add(const Occluder& occluder);
  // Appends what is seen.
  void append_visible(std::vector<picture::LinePiece>& pieces) const;

 private:
  void cast(const Occluder& occluder, const HiddenInterval& beyond, std::int64_t threshold, bool left,
            bool right);
  void hide(const HiddenInterval& interval, bool left, bool right);

  const View& view_;
  std::uint32_t edge_ = 0;
  Vector a_{};
  Vector b_{};
  Plane plane_{};
  bool split_ = false;  // the two sides differ; until then left_ stands for both
  HiddenPart left_;
  HiddenPart right_;
  std::vector<std::int64_t> sides_;  // of the corners of the face at hand against the edge
  std::vector<Fraction> changes_;
};

}  // namespace sightline::algorithms::exact
