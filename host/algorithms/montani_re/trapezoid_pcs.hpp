// Parallel Connected Stripes for arbitrary edges: bands of varying height whose sides are pieces of lines of the image,
// both exact. The set operations are those of the lattice form: sides are processed from west to east, and the result has
// a side where membership changes. If sides cross inside a band, the band is split there.
//
// Every region has its own breakpoints (its corners and the crossings that set operations find). Stripes common to the
// whole scene would make the size grow quadratically.
//
// Invariants: bands ascend and do not overlap; the sides of a band ascend from west to east and do not cross inside it;
// their number is even and not 0; adjacent bands differ in their sides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/algorithms/montani_re/image.hpp"

namespace sightline::algorithms::montani_re {

struct Side {
  std::uint32_t line = 0;
  bool own = false;  // a piece of an edge of the region itself, not of another region that cut it

  friend bool operator==(const Side&, const Side&) = default;
};

struct Band {
  Ordinate low;
  Ordinate high;
  std::uint32_t first = 0;  // into the sides
  std::uint32_t count = 0;
};

struct TrapezoidPcs {
  std::vector<Band> bands;
  std::vector<Side> sides;

  [[nodiscard]] std::span<const Side> sides_of(const Band& band) const {
    return {sides.data() + band.first, band.count};
  }
  [[nodiscard]] bool empty() const { return bands.empty(); }
};

// Appends a band above all others, or extends the last band if the new one continues it with the same sides. Does nothing
// if there are no sides.
void append_band(const Image& image, TrapezoidPcs& pcs, const Ordinate& low, const Ordinate& high,
                 std::span<const Side> sides);

// The region of rings of lines by the even-odd rule; horizontal lines are omitted. All sides are own.
[[nodiscard]] TrapezoidPcs trapezoid_pcs(const Image& image, std::span<const std::uint32_t> lines);

// The same for a convex polygon whose inside is to the east of the lines with a positive inner side, and to the west of
// the others.
[[nodiscard]] TrapezoidPcs convex_pcs(const Image& image, std::span<const std::uint32_t> lines,
                                      std::span<const std::int8_t> inner_sides);

enum class Operation { unite, intersect, subtract };

// Whether a point belongs to the result, given whether it is in a and in b.
[[nodiscard]] constexpr bool in_result(Operation operation, bool in_a, bool in_b) {
  switch (operation) {
    case Operation::unite: return in_a || in_b;
    case Operation::intersect: return in_a && in_b;
    case Operation::subtract: return in_a && !in_b;
  }
  return false;
}

// Replaces a by the result, in which a side is own if it is one of a's own sides. Using one combiner for many operations
// is faster than calling combine() each time.
class Combiner {
 public:
  Combiner(const Image& image, Operation operation);

  void operator()(TrapezoidPcs& a, const TrapezoidPcs& b);

 private:
  // A side, and its abscissas at the lower and the upper end of the merged part.
  struct Member {
    Side side;
    bool of_a = false;
    Abscissa at_from;
    Abscissa at_high;
  };

  static constexpr std::size_t inside_a = 1;
  static constexpr std::size_t inside_b = 2;
  static constexpr std::uint32_t coincides_bit = std::uint32_t{1} << 31;

  void run(const TrapezoidPcs& a_pcs, const TrapezoidPcs& b_pcs);
  // Copies the bands of one region where the other one has none.
  void copy(const TrapezoidPcs& pcs, std::size_t begin, std::size_t end);
  void append(const Ordinate& low, const Ordinate& high, std::span<const Side> a, std::span<const Side> b);
  void merge(const Ordinate& from, const Ordinate& high);
  // The lowest crossing of two sides between the ends, if there is one.
  [[nodiscard]] bool find_crossing(const Ordinate& high, Ordinate& lowest) const;
  [[nodiscard]] std::span<const Side> toggle(const Ordinate& from, const Ordinate& high);
  [[nodiscard]] bool coincides(std::size_t k, const Ordinate& from, const Ordinate& high) const;
  // Member k of the row.
  [[nodiscard]] const Member& member(std::size_t k) const { return apart_[row_[k] & ~coincides_bit]; }
  [[nodiscard]] int order_at_from(const Member& one, const Member& other, const Ordinate& from) const {
    return image_.order_at(one.side.line, one.at_from, other.side.line, other.at_from, from);
  }
  [[nodiscard]] int order_at_high(const Member& one, const Member& other, const Ordinate& high) const {
    return image_.order_at(one.side.line, one.at_high, other.side.line, other.at_high, high);
  }

  const Image& image_;
  Operation operation_;
  std::array<bool, 4> kept_{};  // by inside_a and inside_b
  TrapezoidPcs result_;
  std::size_t a_count_ = 0;
  std::size_t count_ = 0;
  // Their memory is reused; the first `count_` entries are valid.
  std::vector<Member> apart_;       // the sides of a, then those of b
  std::vector<std::uint32_t> row_;  // indices into apart_, from west to east; may have coincides_bit
  std::vector<Side> out_;
};
[[nodiscard]] TrapezoidPcs combine(const Image& image, const TrapezoidPcs& a, const TrapezoidPcs& b,
                                   Operation operation);

// Connected parts. Parts that touch only in a point are separate.
[[nodiscard]] std::vector<TrapezoidPcs> components(const Image& image, const TrapezoidPcs& pcs);

// In floating point.
[[nodiscard]] double area(const Image& image, const TrapezoidPcs& pcs);

}  // namespace sightline::algorithms::montani_re
