// The part of one edge that one face hides, computed from signs alone.
//
// Let e be the edge and x a point of it. The side PQ of a face crosses the plane through the eye and e in Z
// iff P and Q are on different sides of it, and Z is then seen ahead of x along e iff
//   sign(side(P, Q, x)) * sign(side(e, Q) - side(e, P)) > 0
// (Binet and Cauchy: the difference of products that places Z is a product of these two). The face covers x iff an odd
// number of its crossings is ahead, even if part of the face is behind the eye. It hides x iff it covers x and x is
// beyond its plane. Along e, "ahead" changes for a crossing where side(P, Q, x) vanishes, at a / (a - b), a and b being
// its values at the ends of e. For the left side of e, a vertex in the plane of e counts as to the right; for the right
// side, as to the left.
//
// All of this also holds for homogeneous coordinates of positive weight. Therefore crossings of the scene, whose ends are
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

// An edge of the scene relative to the eye. Values of planes at its ends fit in 64 bits.
class EdgeSight {
 public:
  using Number = std::int64_t;

  explicit EdgeSight(const View& view) : view_(view) {}

  // Returns false if the edge is seen end-on, as a point.
  [[nodiscard]] bool begin(std::uint32_t edge);
  [[nodiscard]] const picture::LineEdge& edge() const { return edge_; }
  // The value at a point of the plane through the eye and the edge: positive to the left of the edge as seen.
  [[nodiscard]] Number side(const Vector& p) const { return plane_.at(p); }
  // The values of a plane at both ends.
  [[nodiscard]] std::array<Number, 2> at_ends(const Plane& plane) const { return {plane.at(a_), plane.at(b_)}; }
  [[nodiscard]] geometry::Rational place(const Fraction<Number>& f) const { return {f.numerator, f.denominator}; }
  void append(const Fraction<Number>& low, const Fraction<Number>& high, std::vector<picture::LinePiece>& pieces) const {
    pieces.push_back({edge_, place(low), place(high)});
  }

 private:
  const View& view_;
  picture::LineEdge edge_;
  Vector a_{};
  Vector b_{};
  Plane plane_{};
};

// A line in which two planes meet. Each end is where a third plane cuts a side of a face, so it is a fraction; the value
// of a plane there, times the denominator of the end, has up to 121 bits. Parameters are projective: (1 - s) and s are
// weights of the numerators. Only the ends of visible pieces are divided.
class LineSight {
 public:
  using Number = geometry::Int128;

  explicit LineSight(const View& view) : view_(view) {}

  [[nodiscard]] bool begin(std::uint32_t edge);
  [[nodiscard]] const picture::LineEdge& edge() const { return edge_; }
  // A combination of the two planes that is zero at the eye: a (B at the eye) - b (A at the eye); in orthographic views
  // the same with the direction of sight.
  [[nodiscard]] Number side(const Vector& p) const {
    return Number{planes_[0].at(p)} * factors_[0] + Number{planes_[1].at(p)} * factors_[1];
  }
  [[nodiscard]] std::array<Number, 2> at_ends(const Plane& plane) const { return {ends_[0].value(plane), ends_[1].value(plane)}; }
  // The parameter from one end of the line to the other, rounded to a multiple of 2^-60.
  [[nodiscard]] geometry::Rational place(const Fraction<Number>& f) const;
  // Pieces that become empty by rounding are left out, and pieces that become adjacent are joined.
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

  // Starts another edge: only its part behind the eye is hidden. Returns false if the edge is seen end-on.
  [[nodiscard]] bool begin(std::uint32_t edge);
  // Adds what a face hides. Returns true once the whole edge is hidden.
  bool add(const Occluder& occluder);
  // Appends the visible pieces.
  void append_visible(std::vector<picture::LinePiece>& pieces) const;

  // What was hidden since begin(), if a log is kept: first the part behind the eye, then by each face.
  struct LogEntry {
    Interval interval;
    bool left = false;
    bool right = false;
  };
  void keep_log() { keeps_log_ = true; }
  [[nodiscard]] const std::vector<LogEntry>& log() const { return log_; }
  [[nodiscard]] geometry::Rational place(const Place& place) const { return sight_.place(place); }

 private:
  // The values at the edge's ends of the plane of sight through a side that crosses the plane of the edge: positive where
  // the crossing is ahead.
  struct Crossing {
    Number at_start = 0;
    Number at_end = 0;

    [[nodiscard]] bool ahead_at_start() const { return at_start > 0 || (at_start == 0 && at_end > 0); }
    [[nodiscard]] bool ahead_at_end() const { return at_end > 0 || (at_end == 0 && at_start > 0); }
  };

  // `right` and `left`: the side's corners to the right and to the left of the plane of the edge.
  [[nodiscard, gnu::always_inline]] Crossing crossing(const Vector& right, const Vector& left) const;
  void cast_corners(const Occluder& occluder, const Interval& beyond);
  void cast_four(const Occluder& occluder, const Interval& beyond, unsigned to_left, bool left, bool right);
  void cast(const Occluder& occluder, const Interval& beyond, const Number& threshold, bool left, bool right);
  void hide_where(bool inside, std::span<const Place> changes, const Interval& beyond, bool left, bool right);
  void hide(const Interval& interval, bool left, bool right);

  const View& view_;
  Sight sight_;
  bool split_ = false;  // the hidden parts differ between the two sides; until then left_ holds for both
  HiddenPart<Number> left_;
  HiddenPart<Number> right_;
  std::vector<Number> sides_;  // of the current face's corners, relative to the edge
  std::vector<Place> changes_;
  bool keeps_log_ = false;
  std::vector<LogEntry> log_;
};

extern template class EdgeShadow<EdgeSight>;
extern template class EdgeShadow<LineSight>;

}  // namespace sightline::algorithms::exact
