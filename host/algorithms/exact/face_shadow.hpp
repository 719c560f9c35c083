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
//
// All of this holds for homogeneous coordinates of a positive weight, too: so crossings of the scene, whose ends are
// fractions, are compared with faces exactly, in 128 bits.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/exact/edge_mesh.hpp"
#include "host/algorithms/exact/hidden_part.hpp"
#include "host/algorithms/exact/view.hpp"

namespace sightline::algorithms::exact {

// An edge of the scene before the eye; quantities at its ends fit 64 bits.
class EdgeSight {
 public:
  using Number = std::int64_t;

  explicit EdgeSight(const View& view) : view_(view) {}

  // False if it is seen as a point.
  [[nodiscard]] bool begin(std::uint32_t edge);
  [[nodiscard]] const picture::LineEdge& edge() const { return edge_; }
  // Of a point against the plane through the eye and the edge, positive to the left of it as seen.
  [[nodiscard]] Number side(const Vector& p) const { return plane_.at(p); }
  // Of a plane at the ends.
  [[nodiscard]] std::array<Number, 2> at_ends(const Plane& plane) const { return {plane.at(a_), plane.at(b_)}; }
  void append(const Fraction<Number>& low, const Fraction<Number>& high, std::vector<picture::LinePiece>& pieces) const {
    pieces.push_back({edge_, {low.numerator, low.denominator}, {high.numerator, high.denominator}});
  }

 private:
  const View& view_;
  picture::LineEdge edge_;
  Vector a_{};
  Vector b_{};
  Plane plane_{};
};

// A line in which two planes meet, with ends where a third cuts a side of a face: fractions, so that quantities there, times
// the denominator of the end, have up to 121 bits. Parameters between are projective: (1 - s) and s are weights of the
// numerators; only what is seen in the end is divided.
class LineSight {
 public:
  using Number = geometry::Int128;

  explicit LineSight(const View& view) : view_(view) {}

  [[nodiscard]] bool begin(std::uint32_t edge);
  [[nodiscard]] const picture::LineEdge& edge() const { return edge_; }
  // A combination of the two planes that is zero at the eye: a (B at the eye) - b (A at the eye), and for directions of sight
  // likewise.
  [[nodiscard]] Number side(const Vector& p) const {
    return Number{planes_[0].at(p)} * factors_[0] + Number{planes_[1].at(p)} * factors_[1];
  }
  [[nodiscard]] std::array<Number, 2> at_ends(const Plane& plane) const { return {ends_[0].value(plane), ends_[1].value(plane)}; }
  // Rounded to multiples of 2^-60; what that makes nothing is left out, and what it joins is one piece.
  void append(const Fraction<Number>& low, const Fraction<Number>& high, std::vector<picture::LinePiece>& pieces) const;

 private:
  const View& view_;
  picture::LineEdge edge_;
  std::array<Plane, 2> planes_{};
  std::array<std::int64_t, 2> factors_{};
  std::array<LinePoint, 2> ends_{};
};

template <class Sight>
class EdgeShadow {
 public:
  using Number = typename Sight::Number;
  using Place = Fraction<Number>;
  using Interval = HiddenInterval<Number>;

  explicit EdgeShadow(const View& view) : view_(view), sight_(view) {}

  // Begins another edge, of which nothing is hidden yet but what lies behind the eye. False if it is seen as a point.
  [[nodiscard]] bool begin(std::uint32_t edge);
  // Adds what a face hides. True once the whole edge is hidden.
  bool add(const Occluder& occluder);
  // Appends what is seen.
  void append_visible(std::vector<picture::LinePiece>& pieces) const;

 private:
  // The plane of sight through a side of a face that crosses the plane of the edge, at the edge's ends: positive where
  // the crossing is ahead.
  struct Crossing {
    Number at_start = 0;
    Number at_end = 0;

    [[nodiscard]] bool ahead_at_start() const { return at_start > 0 || (at_start == 0 && at_end > 0); }
    [[nodiscard]] bool ahead_at_end() const { return at_end > 0 || (at_end == 0 && at_start > 0); }
  };

  // `right` and `left`: the corners of the side, by their side of the plane of the edge.
  [[nodiscard, gnu::always_inline]] Crossing crossing(const Vector& right, const Vector& left) const;
  void cast_corners(const Occluder& occluder, const Interval& beyond);
  void cast_four(const Occluder& occluder, const Interval& beyond, unsigned to_left, bool left, bool right);
  void cast(const Occluder& occluder, const Interval& beyond, const Number& threshold, bool left, bool right);
  void hide_where(bool inside, std::span<const Place> changes, const Interval& beyond, bool left, bool right);
  void hide(const Interval& interval, bool left, bool right);

  const View& view_;
  Sight sight_;
  bool split_ = false;  // the two sides differ; until then left_ stands for both
  HiddenPart<Number> left_;
  HiddenPart<Number> right_;
  std::vector<Number> sides_;  // of the corners of the face at hand against the edge
  std::vector<Place> changes_;
};

extern template class EdgeShadow<EdgeSight>;
extern template class EdgeShadow<LineSight>;

}  // namespace sightline::algorithms::exact
