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
#include <span>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/algorithms/exact/hidden_part.hpp"
#include "host/algorithms/exact/view.hpp"

namespace sightline::algorithms::exact {

class EdgeShadow {
 public:
  explicit EdgeShadow(const View& view) : view_(view) {}

  // Begins another edge, of which nothing is hidden yet but what lies behind the eye. False if it is seen as a point.
  [[nodiscard]] bool begin(const picture::LineEdge& edge);
  // Adds what a face hides. True once the whole edge is hidden.
  bool add(const Occluder& occluder);
  // Appends what is seen.
  void append_visible(std::vector<picture::LinePiece>& pieces) const;

 private:
  // The plane of sight through a side of a face that crosses the plane of the edge, at the edge's ends: positive where
  // the crossing is ahead.
  struct Crossing {
    std::int64_t at_start = 0;
    std::int64_t at_end = 0;

    [[nodiscard]] bool ahead_at_start() const { return at_start > 0 || (at_start == 0 && at_end > 0); }
    [[nodiscard]] bool ahead_at_end() const { return at_end > 0 || (at_end == 0 && at_start > 0); }
  };

  // `right` and `left`: the corners of the side, by their side of the plane of the edge.
  [[nodiscard, gnu::always_inline]] Crossing crossing(const Vector& right, const Vector& left) const;
  void cast_corners(const Occluder& occluder, const HiddenInterval& beyond);
  void cast_four(const Occluder& occluder, const HiddenInterval& beyond, unsigned to_left, bool left, bool right);
  void cast(const Occluder& occluder, const HiddenInterval& beyond, std::int64_t threshold, bool left, bool right);
  void hide_where(bool inside, std::span<const Fraction> changes, const HiddenInterval& beyond, bool left, bool right);
  void hide(const HiddenInterval& interval, bool left, bool right);

  const View& view_;
  picture::LineEdge edge_;
  Vector a_{};
  Vector b_{};
  Plane plane_{};  // through the eye and the edge, positive to the left of it as seen
  bool split_ = false;  // the two sides differ; until then left_ stands for both
  HiddenPart left_;
  HiddenPart right_;
  std::vector<std::int64_t> sides_;  // of the corners of the face at hand against the edge
  std::vector<Fraction> changes_;
};

}  // namespace sightline::algorithms::exact
