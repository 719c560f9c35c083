// Hidden-line removal of one edge from scratch, for any integer type. edge_structure.hpp describes the result.
//
// With u = x Z - z X and v = y, the image line of the edge AB separates the corners of a face. A side that crosses the
// line does so at a / (a - b), where a and b are the values at A and B of the line through the side. The crossings, in
// order, are the ends of the parts that the face covers, whatever its shape and holes. For the left side of the edge a
// corner on the line counts as to its right, for the right side as to its left.
//
// Sizes, with coordinates below 2^18: u has 19 bits more than a sight, the value of a line at a corner 40 bits more, an
// end of a hidden part 41 bits more; comparing two ends takes twice as many.
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

template <class Arithmetic, class Listener = NoListener>
class FromScratch {
  using Number = typename Arithmetic::Number;
  using Across = typename Arithmetic::Across;

 public:
  struct Fraction {
    Number part;
    Number whole;  // positive
  };
  struct SeenPiece {
    Piece piece;
    Fraction low;
    Fraction high;
  };

  using Sight = typename Arithmetic::Sight;
  FromScratch(const RotationModel& model, const Sight& x, const Sight& z, Listener listener = Listener())
      : model_(model), x_(x), z_(z), listener_(listener) {}

  // Whether the last edge was compared with its occluders.
  [[nodiscard]] bool compared() const { return compared_; }

  std::vector<SeenPiece> pieces_of(EdgeIndex edge, const std::vector<Occluder>& occluders) {
    edge_ = edge;
    const picture::LineEdge& ends = model_.edges()[edge];
    a_ = &model_.vertices()[ends.from];
    b_ = &model_.vertices()[ends.to];
    au_ = u_of(*a_);
    bu_ = u_of(*b_);
    du_ = bu_ - au_;
    dy_ = (*b_)[1] - (*a_)[1];
    level_ = dy_ == 0;
    compared_ = (geometry::sign(du_) != 0 || !level_) && faces_viewer();
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

  static auto length(std::int64_t n) { return Arithmetic::length(n); }
  static int compare(const Fraction& a, const Fraction& b) {
    const auto left = Arithmetic::product(a.part, b.whole);
    const auto right = Arithmetic::product(b.part, a.whole);
    return left < right ? -1 : (right < left ? 1 : 0);
  }
  static Fraction start() { return {Number(0), Number(1)}; }
  static Fraction finish() { return {Number(1), Number(1)}; }

  [[nodiscard]] Across u_of(const Vector3& p) const { return z_ * length(p[0]) - x_ * length(p[2]); }
  [[nodiscard]] int facing(const RotatedFace& face) const {
    return geometry::sign(x_ * Arithmetic::normal(face.normal[0]) + z_ * Arithmetic::normal(face.normal[2]));
  }

  // Whether the edge belongs to a face of a solid that is turned to the viewer, or to no solid.
  [[nodiscard]] bool faces_viewer() const {
    for (const Incidence& incidence : model_.faces_at(edge_)) {
      const RotatedFace& face = model_.faces()[incidence.face];
      if (face.sheet || facing(face) >= 0) return true;
    }
    return false;
  }

  void cast(const Occluder& occluder) {
    const RotatedFace& face = model_.faces()[occluder.face];
    if (facing(face) != occluder.side) return;
    const auto corners = model_.corners(occluder.face);
    us_.resize(corners.size());
    sides_.resize(corners.size());
    bool above = false;
    bool below = false;
    bool on = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector3& p = model_.vertices()[corners[i].vertex];
      us_[i] = u_of(p);
      sides_[i] = geometry::sign(du_ * length(p[1] - (*a_)[1]) - (us_[i] - au_) * length(dy_));
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
      cuts_.push_back({cut_of(corners, i, j), end_of(corners, i, j)});
    }
    std::sort(cuts_.begin(), cuts_.end(), [](const Cut& p, const Cut& q) {
      const int order = compare(p.at, q.at);
      return order != 0 ? order < 0 : p.end.bits < q.end.bits;
    });
    append_hidden(occluder, hidden);
  }

  Fraction cut_of(std::span<const Corner> corners, std::size_t i, std::size_t j) const {
    const Vector3& p = model_.vertices()[corners[i].vertex];
    const Vector3& q = model_.vertices()[corners[j].vertex];
    const auto u = us_[j] - us_[i];
    const auto y = length(q[1] - p[1]);
    const auto a = u * length((*a_)[1] - p[1]) - (au_ - us_[i]) * y;
    const auto b = u * length((*b_)[1] - p[1]) - (bu_ - us_[i]) * y;
    const Number whole = a - b;
    if (geometry::sign(whole) < 0) return {-a, -whole};
    return {a, whole};
  }

  // The end at a side of the face. On a level edge, a corner on its line stays there: that end is a contact.
  End end_of(std::span<const Corner> corners, std::size_t i, std::size_t j) const {
    if (level_ && sides_[i] == 0) return End::of(EndKind::contact, corners[i].vertex);
    if (level_ && sides_[j] == 0) return End::of(EndKind::contact, corners[j].vertex);
    return End::of(EndKind::junction, corners[i].side);
  }

  // Appends every second interval between cuts, clipped to the edge and to the half-space behind the face.
  void append_hidden(const Occluder& occluder, std::vector<Hidden>& hidden) {
    const End passage = End::of(EndKind::passage, occluder.face);
    Fraction first = start();
    Fraction last = finish();
    const auto from = Arithmetic::depth(occluder.from);
    const auto to = Arithmetic::depth(occluder.to);
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
  Sight x_;
  Sight z_;
  [[no_unique_address]] Listener listener_;
  EdgeIndex edge_ = 0;
  bool compared_ = false;
  const Vector3* a_ = nullptr;
  const Vector3* b_ = nullptr;
  Across au_{}, bu_{};
  decltype(Across{} - Across{}) du_{};
  std::int64_t dy_ = 0;
  bool level_ = false;
  std::vector<Across> us_;
  std::vector<int> sides_;
  std::vector<Cut> cuts_;
  std::vector<Hidden> left_;
  std::vector<Hidden> right_;
};

}  // namespace sightline::algorithms::plantinga
