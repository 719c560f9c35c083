// See direction.hpp. The only place where the order of events is decided by long integers.
#include "host/algorithms/plantinga/direction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/algorithms/plantinga/wide.hpp"

namespace sightline::algorithms::plantinga {
namespace {

constexpr double pi = std::numbers::pi;

int sign_of(const mpz_class& n) {
  return sgn(n);
}

Int128 magnitude(Int128 n) {
  return n < 0 ? -n : n;
}

Int128 common_divisor(Int128 a, Int128 b) {
  a = magnitude(a);
  b = magnitude(b);
  while (b != 0) a = std::exchange(b, a % b);
  return a;
}

// Of p + q sqrt(d), d not negative.
int sign_of(const mpz_class& p, const mpz_class& q, const mpz_class& d) {
  const int sp = sign_of(p);
  const int sq = d == 0 ? 0 : sign_of(q);
  if (sp == 0 || sq == 0 || sp == sq) return sp != 0 ? sp : sq;
  return sp * sign_of(mpz_class(p * p - q * q * d));
}

// Of p + q sqrt(d) + r sqrt(e), by squaring twice.
int sign_of(const mpz_class& p, const mpz_class& q, const mpz_class& d, const mpz_class& r,
            const mpz_class& e) {
  const int first = sign_of(p, q, d);
  const int second = e == 0 ? 0 : sign_of(r);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  const mpz_class rest = p * p + q * q * d - r * r * e;
  return first * sign_of(rest, mpz_class(2 * p * q), d);
}

// X = x + root sqrt(d), Z = z, all times a positive factor.
struct Surd {
  mpz_class x, root, d, z;
};

mpz_class discriminant(const QuadraticForm& form) {
  const mpz_class xz = wide(form.xz);
  return xz * xz - 4 * wide(form.xx) * wide(form.zz);
}

Surd surd_of(const Direction& direction) {
  const QuadraticForm& form = direction.form;
  if (direction.rational) return {wide(form.xx), 0, 0, wide(form.zz)};
  return {-wide(form.xz) * direction.side, direction.root * direction.side, discriminant(form),
          2 * wide(form.xx) * direction.side};
}

// atan2 of two long integers, each rounded to a double after a common scaling.
double angle_of(const mpz_class& x, const mpz_class& z) {
  std::array<long, 2> exponents{};
  const double fx = mpz_get_d_2exp(&exponents[0], x.get_mpz_t());
  const double fz = mpz_get_d_2exp(&exponents[1], z.get_mpz_t());
  const long largest = x == 0 ? exponents[1] : (z == 0 ? exponents[0] : std::max(exponents[0], exponents[1]));
  const auto scaled = [largest](double f, long exponent) {
    return std::ldexp(f, static_cast<int>(std::max(exponent - largest, -1000L)));
  };
  return std::atan2(scaled(fx, exponents[0]), scaled(fz, exponents[1]));
}

// The root with bits to spare: coefficients keep below 2^104, so that X, where it nearly vanishes, is above
// 2^-105 of the form.
constexpr unsigned root_bits = 192;

WideSight approximation(const Direction& direction, unsigned bits) {
  const Surd surd = surd_of(direction);
  const mpz_class root = sqrt(mpz_class(surd.d << (2 * bits)));
  return {(surd.x << bits) + surd.root * root, surd.z << bits};
}

Direction wide_rational(mpz_class x, mpz_class z) {
  const mpz_class divisor = gcd(x, z);
  x /= divisor;
  z /= divisor;
  Direction direction;
  direction.form = {narrow(x), 0, narrow(z)};
  direction.angle = angle_of(x, z);
  return direction;
}

void append_with_opposite(std::vector<Direction>& directions, const Direction& direction) {
  directions.push_back(direction);
  directions.push_back(opposite(direction));
}

// Simplest fraction p / q with low < p / q < high, 0 <= low < high, as well as doubles can tell.
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

// (x : z) turned by `quarters` right angles.
Sight turned(Sight s, int quarters) {
  for (int i = 0; i < ((quarters % 4) + 4) % 4; ++i) s = {s.z, -s.x};
  return s;
}

// The angle from a on to that of s, in [0, 2 pi).
double ahead(double a, const Sight& s) {
  const double d = std::atan2(static_cast<double>(s.x), static_cast<double>(s.z)) - a;
  return d < 0 ? d + 2 * pi : d;
}

}  // namespace

int compare(const Direction& a, const Direction& b) {
  if (a.angle < b.angle - 2 * angle_error) return -1;
  if (a.angle > b.angle + 2 * angle_error) return 1;
  if (a == b) return 0;
  // Nearly the same direction: the turn from a to b tells.
  const Surd s = surd_of(a);
  const Surd t = surd_of(b);
  return sign_of(mpz_class(s.x * t.z - t.x * s.z), mpz_class(s.root * t.z), s.d, mpz_class(-t.root * s.z),
                 t.d);
}

Direction rational_direction(Int128 x, Int128 z) {
  const Int128 divisor = common_divisor(x, z);
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
  const Int128 divisor = common_divisor(common_divisor(form.xx, form.xz), form.zz);
  if (divisor == 0) return directions;
  const Int128 by = form.xx < 0 ? -divisor : divisor;
  form = {form.xx / by, form.xz / by, form.zz / by};
  if (form.xx == 0) {  // Z (xz X + zz Z)
    if (form.xz == 0) return directions;
    append_with_opposite(directions, rational_direction(1, 0));
    append_with_opposite(directions, rational_direction(form.zz, -form.xz));
    return directions;
  }
  const mpz_class d = discriminant(form);
  if (d <= 0) return directions;
  if (mpz_perfect_square_p(d.get_mpz_t()) != 0) {
    const mpz_class root = sqrt(d);
    for (const int sign : {-1, 1}) {
      append_with_opposite(directions, wide_rational(-wide(form.xz) + sign * root, 2 * wide(form.xx)));
    }
    return directions;
  }
  for (const int sign : {-1, 1}) {
    Direction direction{false, static_cast<std::int8_t>(sign), 1, form, 0};
    const WideSight near = approximation(direction, root_bits);
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
  const mpz_class wx(form.x);
  const mpz_class wz(form.z);
  return sign_of(mpz_class(wx * s.x + wz * s.z), mpz_class(wx * s.root), s.d);
}

std::optional<Sight> sight_between(const Direction& a, const Direction& b) {
  constexpr double margin = 4 * angle_error;
  const double apart = b.angle - a.angle;
  if (std::abs(apart) <= 2 * margin) return std::nullopt;
  const double width = apart > 0 ? apart : apart + 2 * pi;
  const double middle = a.angle + width / 2;
  Sight sight;
  if (width > 1e-4) {
    // Not the simplest one: that would look along what is aligned in the scene.
    constexpr double scale = 0x1p20;
    sight = {std::lround(scale * std::sin(middle)), std::lround(scale * std::cos(middle))};
  } else {
    const int quarters = static_cast<int>(std::lround(middle / (pi / 2)));
    const double turn = middle - quarters * (pi / 2);
    const double low = std::tan(std::abs(turn) - width / 4);
    const double high = std::tan(std::abs(turn) + width / 4);
    if (low < 0) {
      sight = turned({0, 1}, quarters);
    } else {
      const auto [p, q] = simplest_between(low, high, 60);
      if (!(p < static_cast<double>(sight_limit) && q < static_cast<double>(sight_limit)))
        return std::nullopt;
      const Sight found{static_cast<std::int64_t>(turn < 0 ? -p : p), static_cast<std::int64_t>(q)};
      sight = turned(found, quarters);
    }
  }
  const double after = ahead(a.angle, sight);
  if (!(after > margin && after < width - margin)) return std::nullopt;
  return sight;
}

WideSight wide_sight_between(const Direction& a, const Direction& b) {
  for (unsigned bits = 256;; bits *= 2) {
    // Both brought to about the same length; then their sum lies between them.
    WideSight s = approximation(a, bits);
    WideSight t = approximation(b, bits);
    const auto length = [](const WideSight& v) {
      return mpz_sizeinbase(mpz_class(abs(v.x) + abs(v.z)).get_mpz_t(), 2);
    };
    const auto s_length = length(s);
    const auto t_length = length(t);
    if (s_length < t_length) {
      s.x <<= t_length - s_length;
      s.z <<= t_length - s_length;
    } else {
      t.x <<= s_length - t_length;
      t.z <<= s_length - t_length;
    }
    const WideSight sum{s.x + t.x, s.z + t.z};
    // Strictly between: a turn to the same side from a to the sum and from the sum to b, exactly.
    const Surd p = surd_of(a);
    const Surd q = surd_of(b);
    const int first = sign_of(mpz_class(sum.x * p.z - p.x * sum.z), mpz_class(-p.root * sum.z), p.d);
    const int second = sign_of(mpz_class(q.x * sum.z - sum.x * q.z), mpz_class(q.root * sum.z), q.d);
    if (first > 0 && second > 0) return sum;
  }
}

}  // namespace sightline::algorithms::plantinga
