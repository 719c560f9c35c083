// Only this file decides the order of events with long integers.
#include "host/algorithms/plantinga/direction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host/geometry/wide_integer.hpp"

namespace sightline::algorithms::plantinga {
namespace {

using geometry::WideInteger;

constexpr double pi = std::numbers::pi;

// The sign of p + q sqrt(d); d is not negative.
template <unsigned p_bits, unsigned q_bits, unsigned d_bits>
int sign_of(const WideInteger<p_bits>& p, const WideInteger<q_bits>& q, const WideInteger<d_bits>& d) {
  const int sp = p.sign();
  const int sq = d.sign() == 0 ? 0 : q.sign();
  if (sp == 0 || sq == 0 || sp == sq) return sp != 0 ? sp : sq;
  return sp * (p * p - q * q * d).sign();
}

// The sign of p + q sqrt(d) + r sqrt(e), by squaring twice.
template <unsigned p_bits, unsigned q_bits, unsigned d_bits>
int sign_of(const WideInteger<p_bits>& p, const WideInteger<q_bits>& q, const WideInteger<d_bits>& d,
            const WideInteger<q_bits>& r, const WideInteger<d_bits>& e) {
  const int first = sign_of(p, q, d);
  const int second = e.sign() == 0 ? 0 : r.sign();
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  const auto rest = p * p + q * q * d - r * r * e;
  return first * sign_of(rest, (p * q).template shifted<1>(), d);
}

using Coefficient = WideInteger<coefficient_bits>;
constexpr unsigned discriminant_bits = 2 * coefficient_bits + 3;
using Discriminant = WideInteger<discriminant_bits>;

// X = x + root sqrt(d), Z = z, all times a positive factor; root is -1, 0 or 1.
struct Surd {
  Coefficient x;
  int root = 0;
  Discriminant d;
  WideInteger<coefficient_bits + 1> z;
};

template <unsigned bits>
WideInteger<bits> times(int sign, const WideInteger<bits>& n) {
  return sign == 0 ? WideInteger<bits>() : sign < 0 ? -n : n;
}

Discriminant discriminant(const QuadraticForm& form) {
  const Coefficient xz(form.xz);
  return xz * xz - (Coefficient(form.xx) * Coefficient(form.zz)).shifted<2>();
}

Surd surd_of(const Direction& direction) {
  const QuadraticForm& form = direction.form;
  if (direction.rational) return {Coefficient(form.xx), 0, {}, Coefficient(form.zz)};
  return {times(-direction.side, Coefficient(form.xz)), direction.root * direction.side, discriminant(form),
          times(direction.side, Coefficient(form.xx).shifted<1>())};
}

// n = fraction 2^exponent, with |fraction| in [1/2, 1), rounded towards 0; both 0 for 0.
struct Leading {
  double fraction = 0;
  int exponent = 0;
};
template <unsigned bits>
Leading leading(const WideInteger<bits>& n) {
  constexpr unsigned digits = 53;
  const unsigned length = n.length();
  const unsigned lost = length > digits ? length - digits : 0;
  const WideInteger<bits> magnitude = n.negative() ? -n : n;
  const auto top = static_cast<double>(magnitude.shifted_down(lost).template narrow<digits>().to_int128());
  const double fraction = std::ldexp(top, -static_cast<int>(length - lost));
  return {n.negative() ? -fraction : fraction, static_cast<int>(length)};
}

// atan2 of two long integers, each rounded to a double after scaling both.
template <unsigned x_bits, unsigned z_bits>
double angle_of(const WideInteger<x_bits>& x, const WideInteger<z_bits>& z) {
  const Leading fx = leading(x);
  const Leading fz = leading(z);
  const int largest = fx.fraction == 0   ? fz.exponent
                      : fz.fraction == 0 ? fx.exponent
                                         : std::max(fx.exponent, fz.exponent);
  const auto scaled = [largest](const Leading& f) {
    return std::ldexp(f.fraction, std::max(f.exponent - largest, -1000));
  };
  return std::atan2(scaled(fx), scaled(fz));
}

// The direction times 2^bits: z exact, the error of x less than 1. The root part of x, sqrt(d 2^(2 bits)), is below
// 2^(105.5 + bits).
template <unsigned bits>
struct Approximation {
  WideInteger<coefficient_bits + 3 + bits> x;
  WideInteger<coefficient_bits + 1 + bits> z;
};
template <unsigned bits>
Approximation<bits> approximation(const Direction& direction) {
  const Surd surd = surd_of(direction);
  const auto root = geometry::square_root(surd.d.shifted<2 * bits>());
  return {surd.x.shifted<bits>() + times(surd.root, root), surd.z.shifted<bits>()};
}

// Sufficient bits for the root of a form: coefficients are below 2^104, so X, even if nearly 0, is above 2^-105 of the
// form.
constexpr unsigned root_bits = 192;

Direction wide_rational(Int128 x, Int128 z) {
  const Int128 divisor = geometry::common_divisor(x, z);
  Direction direction;
  direction.form = {x / divisor, 0, z / divisor};
  direction.angle = angle_of(Coefficient(direction.form.xx), Coefficient(direction.form.zz));
  return direction;
}

void append_with_opposite(std::vector<Direction>& directions, const Direction& direction) {
  directions.push_back(direction);
  directions.push_back(opposite(direction));
}

// The simplest fraction p / q with low < p / q < high, 0 <= low < high, within the precision of doubles.
std::array<double, 2> simplest_between(double low, double high, int depth) {
  const double whole = std::floor(low);
  if (whole + 1 < high || depth == 0) return {whole + 1, 1};
  if (low == whole) {
    const double q = std::floor(1 / (high - whole)) + 1;
    return {whole * q + 1, q};
  }
  const auto [q, p] = simplest_between(1 / (high - whole), 1 / (low - whole), depth - 1);
  return {whole * q + p, q};
}

// (x : z) rotated by `quarters` right angles.
Sight rotate(Sight s, int quarters) {
  for (int i = 0; i < ((quarters % 4) + 4) % 4; ++i) s = {s.z, -s.x};
  return s;
}

// The angle from a to that of s, in [0, 2 pi).
double ahead(double a, const Sight& s) {
  const double d = std::atan2(static_cast<double>(s.x), static_cast<double>(s.z)) - a;
  return d < 0 ? d + 2 * pi : d;
}

}  // namespace

int compare(const Direction& a, const Direction& b) {
  if (a.angle < b.angle - 2 * angle_error) return -1;
  if (a.angle > b.angle + 2 * angle_error) return 1;
  if (a == b) return 0;
  // Nearly the same direction: decided by the sign of the turn from a to b.
  const Surd s = surd_of(a);
  const Surd t = surd_of(b);
  return sign_of(s.x * t.z - t.x * s.z, times(s.root, t.z), s.d, times(-t.root, s.z), t.d);
}

Direction rational_direction(Int128 x, Int128 z) {
  const Int128 divisor = geometry::common_divisor(x, z);
  Direction direction;
  direction.form = {x / divisor, 0, z / divisor};
  direction.angle =
      std::atan2(static_cast<double>(direction.form.xx), static_cast<double>(direction.form.zz));
  return direction;
}

Direction opposite(const Direction& direction) {
  Direction other = direction;
  if (direction.rational) {
    other.form = {-direction.form.xx, 0, -direction.form.zz};
    other.angle = std::atan2(static_cast<double>(other.form.xx), static_cast<double>(other.form.zz));
  } else {
    other.side = static_cast<std::int8_t>(-direction.side);
    other.angle = direction.angle > 0 ? direction.angle - pi : direction.angle + pi;
  }
  return other;
}

std::vector<Direction> roots_of(const LinearForm& form) {
  std::vector<Direction> directions;
  if (form.x != 0 || form.z != 0)
    append_with_opposite(directions, rational_direction(form.z, -Int128{form.x}));
  return directions;
}

std::vector<Direction> roots_of(const QuadraticForm& given) {
  std::vector<Direction> directions;
  QuadraticForm form = given;
  const Int128 divisor = geometry::common_divisor(geometry::common_divisor(form.xx, form.xz), form.zz);
  if (divisor == 0) return directions;
  const Int128 by = form.xx < 0 ? -divisor : divisor;
  form = {form.xx / by, form.xz / by, form.zz / by};
  if (form.xx == 0) {  // Z (xz X + zz Z)
    if (form.xz == 0) return directions;
    append_with_opposite(directions, rational_direction(1, 0));
    append_with_opposite(directions, rational_direction(form.zz, -form.xz));
    return directions;
  }
  const Discriminant d = discriminant(form);
  if (d.sign() <= 0) return directions;
  const auto root = geometry::square_root(d);
  if ((root * root - d).sign() == 0) {
    // The form is a product of two integer factors, whose coefficients divide xx and zz: below 2^104 in lowest terms.
    for (const int sign : {-1, 1}) {
      append_with_opposite(directions, wide_rational(sign * root.to_int128() - form.xz, 2 * form.xx));
    }
    return directions;
  }
  for (const int sign : {-1, 1}) {
    Direction direction{false, static_cast<std::int8_t>(sign), 1, form, 0};
    const auto near = approximation<root_bits>(direction);
    direction.angle = angle_of(near.x, near.z);
    append_with_opposite(directions, direction);
  }
  return directions;
}

int sign_at(const Direction& direction, const LinearForm& form) {
  const auto x = static_cast<double>(form.x);
  const auto z = static_cast<double>(form.z);
  const double value = x * std::sin(direction.angle) + z * std::cos(direction.angle);
  const double error = 2 * angle_error * (std::abs(x) + std::abs(z));
  if (value > error) return 1;
  if (value < -error) return -1;
  const Surd s = surd_of(direction);
  const WideInteger<63> wx(form.x);
  const WideInteger<63> wz(form.z);
  return sign_of(wx * s.x + wz * s.z, times(s.root, wx), s.d);
}

std::optional<Sight> sight_between(const Direction& a, const Direction& b) {
  constexpr double margin = 4 * angle_error;
  const double apart = b.angle - a.angle;
  if (std::abs(apart) <= 2 * margin) return std::nullopt;
  const double width = apart > 0 ? apart : apart + 2 * pi;
  const double middle = a.angle + width / 2;
  Sight sight;
  if (width > 1e-4) {
    // Not the simplest fraction: such a direction would look along edges and faces aligned with the axes.
    constexpr double scale = 0x1p20;
    sight = {std::lround(scale * std::sin(middle)), std::lround(scale * std::cos(middle))};
  } else {
    const int quarters = static_cast<int>(std::lround(middle / (pi / 2)));
    const double turn = middle - quarters * (pi / 2);
    const double low = std::tan(std::abs(turn) - width / 4);
    const double high = std::tan(std::abs(turn) + width / 4);
    if (low < 0) {
      sight = rotate({0, 1}, quarters);
    } else {
      const auto [p, q] = simplest_between(low, high, 60);
      if (!(p < static_cast<double>(sight_limit) && q < static_cast<double>(sight_limit)))
        return std::nullopt;
      const Sight found{static_cast<std::int64_t>(turn < 0 ? -p : p), static_cast<std::int64_t>(q)};
      sight = rotate(found, quarters);
    }
  }
  const double after = ahead(a.angle, sight);
  if (!(after > margin && after < width - margin)) return std::nullopt;
  return sight;
}

// The sum of both, scaled to about equal length. It lies between them if enough bits of them are known:
//
// Let s = (X, Z) and t be the two directions, with |X| < 2^106 and |Z| < 2^105, and let E = X_s Z_t - X_t Z_s,
// which is positive. E = p + q sqrt(d) + r sqrt(e) with integers, |p| < 2^210, |q sqrt(d)| and |r sqrt(e)| <
// 2^210.5. The product of E and its conjugates (other signs of the roots: four, two or one numbers in all) is
// a norm, an integer, and none of them is 0. Each is below 2^212, so E > 2^-636.
//
// The approximations differ from 2^bits s and 2^bits t by less than 1 in X. They have between bits + 1 and bits
// + 107 bits in X and Z together, so one of them is shifted by at most 106. The turn from s to the sum is then
// 2^bits E times the factor of t, with an error below 2^105 times the sum of both factors: positive if 2^bits E >
// 2^105 (2^106 + 1), which holds for 848 bits and more. The same holds for the turn from the sum to t.
WideSight wide_sight_between(const Direction& a, const Direction& b) {
  constexpr unsigned bits = 848;
  static_assert(wide_sight_bits == bits + 108);
  WideSight s;
  WideSight t;
  const auto length = [](const WideSight& v) {
    const auto magnitude = [](const auto& n) { return n.negative() ? -n : n; };
    return (magnitude(v.x) + magnitude(v.z)).length();
  };
  const auto take = [](WideSight& v, const Approximation<bits>& near) {
    v.x = near.x;
    v.z = near.z;
  };
  take(s, approximation<bits>(a));
  take(t, approximation<bits>(b));
  const unsigned s_length = length(s);
  const unsigned t_length = length(t);
  WideSight& shorter = s_length < t_length ? s : t;
  const unsigned by = s_length < t_length ? t_length - s_length : s_length - t_length;
  shorter = {shorter.x.shifted_within(by), shorter.z.shifted_within(by)};
  return {(s.x + t.x).narrow<wide_sight_bits>(), (s.z + t.z).narrow<wide_sight_bits>()};
}

}  // namespace sightline::algorithms::plantinga
