// The number types with which the twin of Jones's program calculates on the screen: words of the PDP-7, words of another
// length, and floating point. The search, the masks and the clip are templates over them.
//
// A number type gives: Coordinate, one coordinate on the screen; Distance, for products of two differences of coordinates;
// and the operations of firmware/pdp7/jones/SPECIFICATION.md (sections 1 to 3) whose result depends on the length of a
// word, on the fraction bits, or on rounding. FixedPoint with 18 bits, three fraction bits and rounding is the machine's
// arithmetic. Nothing here throws or stops: a result that does not fit a word becomes 0 and sets overflowed, and the search
// ends the view with a status.
//
// Coordinates in space are always integers, as in the data.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "host/geometry/integer.hpp"
#include "host/programs/jones/specification.hpp"

namespace sightline::programs::jones {

inline constexpr std::int32_t largest_in_space = 1 << 30;  // for words that hold more

// The ratio in which a line is cut: 0 <= num <= den, den > 0.
template <class Coordinate>
struct Share {
  Coordinate num, den;
};

// Two's complement words, coordinates with fraction bits; products in double words.
// Single must hold word_bits + 1 bits and Distance 2 word_bits + 1.
template <class Single, class Double>
class FixedPoint {
 public:
  using Coordinate = Single;
  using Distance = Double;

  // word_bits: 12..36. fraction_bits: 0..8. truncate: quotients are truncated and points rounded down where the program
  // otherwise rounds half up.
  explicit constexpr FixedPoint(int word_bits = machine_word_bits, int fraction_bits = machine_fraction_bits,
                                bool truncate = false)
      : word_bits_(word_bits), fraction_bits_(fraction_bits), truncate_(truncate) {}

  [[nodiscard]] int word_bits() const { return word_bits_; }
  [[nodiscard]] int fraction_bits() const { return fraction_bits_; }
  [[nodiscard]] bool truncate() const { return truncate_; }
  [[nodiscard]] bool overflowed() const { return overflowed_; }

  // The largest number of a word, as far as space needs it.
  [[nodiscard]] std::int32_t largest() const {
    return word_bits_ > 30 ? largest_in_space : (std::int32_t{1} << (word_bits_ - 1)) - 1;
  }

  // A sum in space. The machine's words wrap, as TAD does; others report a result that does not fit.
  [[nodiscard]] std::int32_t sum(std::int64_t value) {
    if (word_bits_ == machine_word_bits) {
      constexpr std::int64_t wrap = std::int64_t{1} << machine_word_bits;
      const std::int64_t low = value & (wrap - 1);
      return static_cast<std::int32_t>(low >= wrap / 2 ? low - wrap : low);
    }
    if (value >= -largest() - 1 && value <= largest()) return static_cast<std::int32_t>(value);
    overflowed_ = true;
    return 0;
  }

  [[nodiscard]] Single word(Double value) {
    return static_cast<Single>(limited(value, Double{1} << (word_bits_ - 1)));
  }
  [[nodiscard]] Double double_word(Double value) { return limited(value, Double{1} << (2 * word_bits_ - 1)); }

  // MULDIV of the specification, for a, b >= 0, c > 0, none above 2^word_bits; nullopt if the quotient does not fit a word
  // (the divide overflow of the machine).
  [[nodiscard]] std::optional<Single> muldiv(Single a, Single b, Single c) const {
    const Double dividend = Double{a} * b + (truncate_ ? 0 : c / 2);
    if ((dividend >> word_bits_) >= c) return std::nullopt;
    return static_cast<Single>(dividend / c);
  }

  // The ratio for distances of unlike sign.
  [[nodiscard]] Share<Single> share_of(Double dp, Double dq) {
    Double num = dp < 0 ? -dp : dp;
    Double den = double_word(num + (dq < 0 ? -dq : dq));
    while (den >= Double{1} << (word_bits_ - 1)) {
      num >>= 1;
      den >>= 1;
    }
    if (den == 0) return {0, 1};  // only after an overflow
    return {word(num), word(den)};
  }

  // The point of the screen, relative to the centre.
  [[nodiscard]] std::int32_t point(Single coordinate) const {
    const Double half = truncate_ || fraction_bits_ == 0 ? 0 : Double{1} << (fraction_bits_ - 1);
    return static_cast<std::int32_t>((Double{coordinate} + half) >> fraction_bits_);
  }
  [[nodiscard]] double points(Single coordinate) const {
    return std::ldexp(static_cast<double>(coordinate), -fraction_bits_);
  }

 private:
  [[nodiscard]] Double limited(Double value, Double limit) {
    if (-limit <= value && value < limit) return value;
    overflowed_ = true;
    return 0;
  }

  int word_bits_;
  int fraction_bits_;
  bool truncate_;
  bool overflowed_ = false;
};

// Coordinates are points of the screen. A float holds every coordinate in space that an 18-bit word holds.
template <class Real>
class FloatingPoint {
 public:
  using Coordinate = Real;
  using Distance = Real;

  [[nodiscard]] static int word_bits() { return 36; }  // used only for the bound
  [[nodiscard]] static int fraction_bits() { return 0; }
  [[nodiscard]] static bool truncate() { return false; }
  [[nodiscard]] bool overflowed() const { return overflowed_; }
  [[nodiscard]] static std::int32_t largest() { return largest_in_space; }

  [[nodiscard]] std::int32_t sum(std::int64_t value) {
    if (value >= -largest_in_space && value <= largest_in_space) return static_cast<std::int32_t>(value);
    overflowed_ = true;
    return 0;
  }
  [[nodiscard]] static Real word(Real value) { return value; }
  [[nodiscard]] static Real double_word(Real value) { return value; }
  [[nodiscard]] static std::optional<Real> muldiv(Real a, Real b, Real c) { return a * b / c; }
  [[nodiscard]] static Share<Real> share_of(Real dp, Real dq) {
    const Real num = std::abs(dp);
    return {num, num + std::abs(dq)};
  }
  [[nodiscard]] static std::int32_t point(Real coordinate) {
    return static_cast<std::int32_t>(std::floor(coordinate + Real(0.5)));
  }
  [[nodiscard]] static double points(Real coordinate) { return static_cast<double>(coordinate); }

 private:
  bool overflowed_ = false;
};

using ShortWords = FixedPoint<std::int32_t, std::int64_t>;     // up to 30 bits; the machine's type
using LongWords = FixedPoint<std::int64_t, geometry::Int128>;  // up to 36 bits

// The roundings of a view on the screen: of the ends of its lines, of the corners of its openings, and of the corners where
// masks intersect.
enum class Rounding : std::uint8_t { line_ends, opening_corners, mask_corners };
inline constexpr int roundings = 3;

// Words of 36 bits with 8 fraction bits, in which selected roundings are those of the machine: a quotient is a multiple of
// the machine's unit, and a ratio has 17 bits. With all of them the pieces are the machine's; with some, a difference in
// the picture is caused by these. Statuses are those of 36 bits.
class MixedWords : public LongWords {
 public:
  static constexpr int fine_bits = 8;

  // machine_bits: fraction bits of the machine, 0..3. convex_masks: omits corners at which rounding has made a mask
  // concave.
  MixedWords(int machine_bits, bool truncate, const std::array<bool, roundings>& of_machine, bool convex_masks = false)
      : LongWords(36, fine_bits, truncate),
        unit_(std::int64_t{1} << (fine_bits - machine_bits)),
        of_machine_(of_machine),
        convex_masks_(convex_masks) {}

  [[nodiscard]] bool convex_masks() const { return convex_masks_; }

  // The following operations round these numbers of the view.
  void enter(Rounding rounding) { coarse_ = of_machine_[static_cast<std::size_t>(rounding)]; }

  [[nodiscard]] std::optional<std::int64_t> muldiv(std::int64_t a, std::int64_t b, std::int64_t c) const {
    if (!coarse_) return LongWords::muldiv(a, b, c);
    const Distance dividend = Distance{a} * b + (truncate() ? Distance{0} : Distance{c / 2} * unit_);
    return static_cast<std::int64_t>(dividend / (Distance{c} * unit_)) * unit_;
  }
  [[nodiscard]] Share<std::int64_t> share_of(Distance dp, Distance dq) {
    Share<std::int64_t> share = LongWords::share_of(dp, dq);
    while (coarse_ && share.den >= std::int64_t{1} << (machine_word_bits - 1)) {
      share.num >>= 1;
      share.den >>= 1;
    }
    return share;
  }

 private:
  std::int64_t unit_;
  std::array<bool, roundings> of_machine_;
  bool convex_masks_;
  bool coarse_ = false;
};
using SingleFloat = FloatingPoint<float>;
using DoubleFloat = FloatingPoint<double>;

}  // namespace sightline::programs::jones
