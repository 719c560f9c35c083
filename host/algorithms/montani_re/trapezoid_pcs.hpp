// Parallel Connected Stripes for any edges: bands of their own height, every side a piece of a line of the
// image, both exact. The set operations are those of the lattice form: sides from west to east, a side of the
// result where membership changes; where sides cross inside a band, the band is split there.
//
// Every region has its own breakpoints (its corners and the crossings that set operations found), never
// stripes common to a whole scene: those would make the growth quadratic.
//
// Laws: bands ascend and do not overlap; sides in a band ascend from west to east and do not cross inside it,
// their number is even and not 0; bands that touch differ in their sides.
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
  bool own = false;  // a piece of an edge of the region itself, not a cut made by another

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

// A band above all others; one that goes on where the last one ends, with the same sides, is joined to it.
// Nothing without sides.
void append_band(const Image& image, TrapezoidPcs& pcs, const Ordinate& low, const Ordinate& high,
                 std::span<const Side> sides);

// The region of rings of lines, those that are horizontal left out, by the even-odd rule. All sides are own.
[[nodiscard]] TrapezoidPcs trapezoid_pcs(const Image& image, std::span<const std::uint32_t> lines);

enum class Operation { unite, intersect, subtract };

// Whether a point that is in a or not, in b or not, is in the result.
[[nodiscard]] constexpr bool kept(Operation operation, bool in_a, bool in_b) {
  switch (operation) {
    case Operation::unite: return in_a || in_b;
    case Operation::intersect: return in_a && in_b;
    case Operation::subtract: return in_a && !in_b;
  }
  return false;
}

// a becomes the result. A side is own in it if it is one of a's. One combiner is for many operations in turn,
// which is faster than as many calls of combine().
class Combiner {
 public:
  Combiner(const Image& image, Operation operation);

  void operator()(TrapezoidPcs& a, const TrapezoidPcs& b);

 private:
  struct Member {
    Side side;
    bool of_a = false;
    bool coincides = false;  // with the one before, if that is of the other region
  };

  static constexpr std::size_t inside_a = 1;
  static constexpr std::size_t inside_b = 2;

  void run(const TrapezoidPcs& a_pcs, const TrapezoidPcs& b_pcs);
  void append(const Ordinate& low, const Ordinate& high, std::span<const Side> a, std::span<const Side> b);
  void merge(const Ordinate& from, const Ordinate& high, std::span<const Side> a, std::span<const Side> b);
  void toggle(const Ordinate& from, const Ordinate& high);
  [[nodiscard]] bool coincides(std::size_t k, const Ordinate& from, const Ordinate& high) const;
  [[nodiscard]] const Ordinate* later(const Ordinate& low, const Ordinate* reached) const;
  [[nodiscard]] const Ordinate* earlier(const Ordinate* one, const Ordinate* other) const;

  const Image& image_;
  Operation operation_;
  std::array<bool, 4> kept_{};  // by inside_a and inside_b
  TrapezoidPcs result_;
  std::vector<Member> row_;
  std::vector<Side> out_;
};
[[nodiscard]] TrapezoidPcs combine(const Image& image, const TrapezoidPcs& a, const TrapezoidPcs& b,
                                   Operation operation);

// Connected parts; parts that only touch in a point are apart.
[[nodiscard]] std::vector<TrapezoidPcs> components(const Image& image, const TrapezoidPcs& pcs);

// In floating point.
[[nodiscard]] double area(const Image& image, const TrapezoidPcs& pcs);

}  // namespace sightline::algorithms::montani_re
