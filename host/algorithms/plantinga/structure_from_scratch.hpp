// Hidden-line removal of one edge from scratch, for any kind of view. edge_structure.hpp describes the result.
//
// The image line of the edge AB separates the corners of a face. A side that crosses the line does so at a / (a - b),
// where a and b are the values at A and B of the line through the side. The crossings, in
// order, are the ends of the parts that the face covers, whatever its shape and holes. For the left side of the edge a
// corner on the line counts as to its right, for the right side as to its left.
//
// A view says on which side of the line a point is and gives a and b; a FlatView for directions of sight without a y
// component, in u = x Z - z X and v = y. (circle_structure.cpp has the view from a point.)
//
// Sizes of a FlatView, with coordinates below 2^18: u has 19 bits more than a sight, the value of a line at a corner 40
// bits more, an end of a hidden part 41 bits more; comparing two ends takes twice as many.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/trace.hpp"

namespace sightline::algorithms::plantinga {

// For sights below 2^21 (sight_limit).
struct DirectArithmetic {
  using Sight = std::int64_t;
  using Across = std::int64_t;  // u
  using Number = std::int64_t;  // an end of a hidden part: 62 bits
  [[nodiscard]] static Int128 product(Number a, Number b) { return Int128{a} * b; }
  // A coordinate or a difference of two; a component of a face's normal; the value of a face's plane at a vertex.
  [[nodiscard]] static std::int64_t length(std::int64_t n) { return n; }
  [[nodiscard]] static std::int64_t normal(std::int64_t n) { return n; }
  [[nodiscard]] static std::int64_t depth(std::int64_t n) { return n; }
};

// For sights below 2^bits.
template <unsigned bits>
struct WideArithmetic {
  using Sight = geometry::WideInteger<bits>;
  using Across = geometry::WideInteger<bits + 20>;
  using Number = geometry::WideInteger<bits + 42>;
  [[nodiscard]] static auto product(const Number& a, const Number& b) { return a * b; }
  [[nodiscard]] static auto length(std::int64_t n) { return geometry::WideInteger<19>(n); }
  [[nodiscard]] static auto normal(std::int64_t n) { return geometry::WideInteger<40>(n); }
  [[nodiscard]] static auto depth(std::int64_t n) { return geometry::WideInteger<61>(n); }
};

// The view along (x, 0, z).
template <class Arithmetic>
class FlatView {
 public:
  using Number = typename Arithmetic::Number;
  using Sight = typename Arithmetic::Sight;

  FlatView(const Sight& x, const Sight& z) : x_(x), z_(z) {}

  static auto depth(std::int64_t n) { return Arithmetic::depth(n); }
  // Compares p / q and r / s; q and s are not negative.
  static int compare(const Number& p, const Number& q, const Number& r, const Number& s) {
    const auto left = Arithmetic::product(p, s);
    const auto right = Arithmetic::product(r, q);
    return left < right ? -1 : (right < left ? 1 : 0);
  }

  // The sign of the face's normal towards the viewer. `corner`: a vertex of the face.
  [[nodiscard]] int facing(const RotatedFace& face, const Vector3& /*corner*/) const {
    return geometry::sign(x_ * Arithmetic::normal(face.normal[0]) + z_ * Arithmetic::normal(face.normal[2]));
  }
  // Sets the edge. False if its image is a point.
  bool set_edge(const Vector3& a, const Vector3& b) {
    a_ = &a;
    b_ = &b;
    au_ = u_of(a);
    bu_ = u_of(b);
    du_ = bu_ - au_;
    dy_ = b[1] - a[1];
    return geometry::sign(du_) != 0 || dy_ != 0;
  }
  void set_corner_count(std::size_t count) { us_.resize(count); }
  // The side of the edge's line on which corner number i is, positive to the left.
  int side(std::size_t i, const Vector3& p) {
    us_[i] = u_of(p);
    return geometry::sign(du_ * length(p[1] - (*a_)[1]) - (us_[i] - au_) * length(dy_));
  }
  // Whether a corner on the line stays there as the scene turns.
  [[nodiscard]] bool stays(const Vector3& /*corner*/) const { return dy_ == 0; }
  // The values at the edge's ends of the line through corners number i and j.
  [[nodiscard]] auto values(std::size_t i, const Vector3& p, std::size_t j, const Vector3& q) const {
    const auto u = us_[j] - us_[i];
    const auto y = length(q[1] - p[1]);
    return std::pair{u * length((*a_)[1] - p[1]) - (au_ - us_[i]) * y, u * length((*b_)[1] - p[1]) - (bu_ - us_[i]) * y};
  }

 private:
  using Across = typename Arithmetic::Across;
  static auto length(std::int64_t n) { return Arithmetic::length(n); }
  [[nodiscard]] Across u_of(const Vector3& p) const { return z_ * length(p[0]) - x_ * length(p[2]); }

  Sight x_;
  Sight z_;
  const Vector3* a_ = nullptr;
  const Vector3* b_ = nullptr;
  Across au_{}, bu_{};
  decltype(Across{} - Across{}) du_{};
  std::int64_t dy_ = 0;
  std::vector<Across> us_;
};

template <class View, class Listener = NoListener>
class FromScratch {
  using Number = typename View::Number;

 public:
  struct Fraction {
    Number part;
    Number whole;  // positive; or 0 for plus or minus infinity
  };
  struct SeenPiece {
    Piece piece;
    Fraction low;
    Fraction high;
  };

  FromScratch(const RotationModel& model, View view, Listener listener = Listener())
      : model_(model), view_(std::move(view)), listener_(listener) {}

  // Whether the last edge was compared with its occluders.
  [[nodiscard]] bool compared() const { return compared_; }

  std::vector<SeenPiece> pieces_of(EdgeIndex edge, const std::vector<Occluder>& occluders) {
    edge_ = edge;
    const picture::LineEdge& ends = model_.edges()[edge];
    compared_ = view_.set_edge(model_.vertices()[ends.from], model_.vertices()[ends.to]) && faces_viewer();
    if (!compared_) return {};
    left_.clear();
    right_.clear();
    for (const Occluder& occluder : occluders) cast(occluder);
    unite(left_);
    unite(right_);
    return rest_of(hidden_from_both_sides());
  }

 private:
  // A hidden part: the open interval between two ends.
  struct Hidden {
    Fraction low;
    Fraction high;
    End low_end;
    End high_end;
  };
  struct Cut {
    Fraction at;
    End end;
  };

  static int compare(const Fraction& a, const Fraction& b) { return View::compare(a.part, a.whole, b.part, b.whole); }
  static Fraction start() { return {Number(0), Number(1)}; }
  static Fraction finish() { return {Number(1), Number(1)}; }

  [[nodiscard]] int facing(FaceIndex face) const {
    return view_.facing(model_.faces()[face], corner(model_.corners(face)[0]));
  }
  [[nodiscard]] const Vector3& corner(const Corner& of) const { return model_.vertices()[of.vertex]; }

  // Whether the edge belongs to a face of a solid that is turned to the viewer, or to no solid.
  [[nodiscard]] bool faces_viewer() const {
    for (const Incidence& incidence : model_.faces_at(edge_)) {
      if (model_.faces()[incidence.face].sheet || facing(incidence.face) >= 0) return true;
    }
    return false;
  }

  void cast(const Occluder& occluder) {
    if (facing(occluder.face) != occluder.side) return;
    const auto corners = model_.corners(occluder.face);
    view_.set_corner_count(corners.size());
    sides_.resize(corners.size());
    bool above = false;
    bool below = false;
    bool on = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      sides_[i] = view_.side(i, corner(corners[i]));
      above = above || sides_[i] > 0;
      below = below || sides_[i] < 0;
      on = on || sides_[i] == 0;
    }
    // For the left side, a corner on the line counts as to the right of it; for the right side, as to the left.
    const bool left = above && (below || on);
    const bool right = below && (above || on);
    if (left) cover(occluder, 0, left_);
    if (right && on) cover(occluder, -1, right_);
    if (right && !on && !cuts_.empty()) append_hidden(occluder, right_);
  }

  // Finds the cuts of the face with the line, where values up to `threshold` are to the right, and the parts hidden by
  // it.
  void cover(const Occluder& occluder, int threshold, std::vector<Hidden>& hidden) {
    const auto corners = model_.corners(occluder.face);
    cuts_.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t j = corners[i].next;
      if ((sides_[i] > threshold) == (sides_[j] > threshold)) continue;
      cuts_.push_back({cut_of(corners, i, j, sides_[i] > threshold), end_of(corners, i, j)});
    }
    std::sort(cuts_.begin(), cuts_.end(), [](const Cut& p, const Cut& q) {
      const int order = compare(p.at, q.at);
      return order != 0 ? order < 0 : p.end.bits < q.end.bits;
    });
    append_hidden(occluder, hidden);
  }

  // Where the side from corner i to corner j crosses the edge's line; `falling`: from its left to its right. In perspective the
  // point seen there may be beyond the end of the line at infinity: then the cut is at plus or minus infinity. (With E, A, B
  // and the corners P and Q, the point of PQ is E + (b (A - E) - a (B - E)) / (side of P - side of Q).)
  Fraction cut_of(std::span<const Corner> corners, std::size_t i, std::size_t j, bool falling) const {
    const auto [a, b] = view_.values(i, corner(corners[i]), j, corner(corners[j]));
    const Number whole = a - b;
    const int sign = geometry::sign(whole);
    if (sign != (falling ? -1 : 1)) return {Number((geometry::sign(a) < 0) == falling ? 1 : -1), Number(0)};
    if (sign < 0) return {-a, -whole};
    return {a, whole};
  }

  // The end at a side of the face. If a corner on the edge's line stays there, that end is a contact.
  End end_of(std::span<const Corner> corners, std::size_t i, std::size_t j) const {
    if (sides_[i] == 0 && view_.stays(corner(corners[i]))) return End::of(EndKind::contact, corners[i].vertex);
    if (sides_[j] == 0 && view_.stays(corner(corners[j]))) return End::of(EndKind::contact, corners[j].vertex);
    return End::of(EndKind::junction, corners[i].side);
  }

  // Appends every second interval between cuts, clipped to the edge and to the half-space behind the face.
  void append_hidden(const Occluder& occluder, std::vector<Hidden>& hidden) {
    const End passage = End::of(EndKind::passage, occluder.face);
    Fraction first = start();
    Fraction last = finish();
    const auto from = View::depth(occluder.from);
    const auto to = View::depth(occluder.to);
    if (occluder.from >= 0) first = {from, from - to};
    if (occluder.to >= 0) last = {-from, to - from};
    for (std::size_t i = 0; i + 1 < cuts_.size(); i += 2) {
      Hidden part{cuts_[i].at, cuts_[i + 1].at, cuts_[i].end, cuts_[i + 1].end};
      if (compare(part.low, first) < 0) {
        part.low = first;
        part.low_end = passage;
      }
      if (compare(part.high, last) > 0) {
        part.high = last;
        part.high_end = passage;
      }
      if (compare(part.low, part.high) >= 0) continue;
      listener_.hides(edge_, occluder.face, part.low, part.high);
      hidden.push_back(std::move(part));
    }
  }

  // Sorts the intervals and joins those that overlap or touch, because an isolated point is not drawn.
  static void unite(std::vector<Hidden>& hidden) {
    std::sort(hidden.begin(), hidden.end(), [](const Hidden& p, const Hidden& q) {
      const int order = compare(p.low, q.low);
      return order != 0 ? order < 0 : p.low_end.bits < q.low_end.bits;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < hidden.size(); ++i) {
      if (kept == 0 || compare(hidden[kept - 1].high, hidden[i].low) < 0) {
        if (kept != i) hidden[kept] = std::move(hidden[i]);
        ++kept;
        continue;
      }
      const int order = compare(hidden[kept - 1].high, hidden[i].high);
      if (order < 0) {
        hidden[kept - 1].high = hidden[i].high;
        hidden[kept - 1].high_end = hidden[i].high_end;
      } else if (order == 0) {
        hidden[kept - 1].high_end.bits = std::min(hidden[kept - 1].high_end.bits, hidden[i].high_end.bits);
      }
    }
    hidden.resize(kept, Hidden{start(), start(), {}, {}});
  }

  std::vector<Hidden> hidden_from_both_sides() const {
    std::vector<Hidden> both;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < left_.size() && j < right_.size()) {
      const Hidden& l = left_[i];
      const Hidden& r = right_[j];
      Hidden part = l;
      const int low = compare(l.low, r.low);
      const int high = compare(l.high, r.high);
      if (low < 0 || (low == 0 && r.low_end.bits < l.low_end.bits)) part.low_end = r.low_end;
      if (low < 0) part.low = r.low;
      if (high > 0 || (high == 0 && r.high_end.bits < l.high_end.bits)) part.high_end = r.high_end;
      if (high > 0) part.high = r.high;
      if (compare(part.low, part.high) < 0) both.push_back(std::move(part));
      if (high <= 0) ++i;
      if (high >= 0) ++j;
    }
    return both;
  }

  std::vector<SeenPiece> rest_of(const std::vector<Hidden>& hidden) const {
    const picture::LineEdge& ends = model_.edges()[edge_];
    std::vector<SeenPiece> seen;
    Fraction at = start();
    End end = End::of(EndKind::vertex, ends.from);
    for (const Hidden& part : hidden) {
      if (compare(at, part.low) < 0) seen.push_back({{end, part.low_end}, at, part.low});
      at = part.high;
      end = part.high_end;
    }
    if (compare(at, finish()) < 0) {
      seen.push_back({{end, End::of(EndKind::vertex, ends.to)}, at, finish()});
    }
    return seen;
  }

  const RotationModel& model_;
  View view_;
  [[no_unique_address]] Listener listener_;
  EdgeIndex edge_ = 0;
  bool compared_ = false;
  std::vector<int> sides_;
  std::vector<Cut> cuts_;
  std::vector<Hidden> left_;
  std::vector<Hidden> right_;
};

}  // namespace sightline::algorithms::plantinga
