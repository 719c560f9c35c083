// The forms of edges in doubles with error bounds: they answer the most frequent questions of the search for potential
// events where the answer is certain.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "host/algorithms/plantinga/candidate_filter.hpp"
#include "host/algorithms/plantinga/potential_events.hpp"

namespace sightline::algorithms::plantinga {

inline constexpr double rounding = 1e-15;

struct NearForm {
  double x = 0;
  double z = 0;

  [[nodiscard]] double at(const NearDirection& v) const { return x * v.x + z * v.z; }
};

inline NearForm near(const LinearForm& form) {
  return {static_cast<double>(form.x), static_cast<double>(form.z)};
}

inline double size_of(const NearForm& form) {
  return std::abs(form.x) + std::abs(form.z);
}

// An edge that may cross the current edge, and its forms relative to it.
struct Line {
  EdgeIndex edge = 0;
  Crossing exact;
  NearForm n, d, m;
  double n_size = 0, d_size = 0, m_size = 0;
  int order = 0;  // sign of (p1 - p2) . (a1 x a2): the line is nearer where D has the other sign
  std::int64_t low = 0, high = 0;
};

// The crossing of a line and the edge in one direction.
struct Meeting {
  double s = 0;         // parameter on the edge
  double error = 0;     // of s
  bool within = false;  // within both, as far as doubles can decide
};

inline Meeting meeting_of(const Line& line, const NearDirection& v) {
  const double d = std::abs(line.d.at(v));
  const double off = v.error + rounding;
  const double sign = line.d.at(v) < 0 ? -1 : 1;
  Meeting meeting;
  meeting.error = d > 0 ? off * (line.n_size + line.m_size + line.d_size) / d : 1;
  if (!(meeting.error < 1e-2)) return {0.5, 1, true};  // nearly parallel: nothing is certain
  meeting.s = sign * line.n.at(v) / d;
  const double other = sign * line.m.at(v) / d;
  const double slack = meeting.error + 1e-9;
  meeting.within = meeting.s > -slack && meeting.s < 1 + slack && other > -slack && other < 1 + slack;
  return meeting;
}

inline bool surely_farther(const Line& line, const NearDirection& v) {
  const double d = line.d.at(v);
  return std::abs(d) > (v.error + rounding) * line.d_size * 4 && line.order * d > 0;
}

// Directions in a range of angles, 0 to 2 pi wide; empty if the width is negative.
struct Sector {
  double from = 0;
  double width = -1;

  // Has no branches.
  [[nodiscard]] bool meets(const Sector& other) const {
    const double turn = other.from - from;
    constexpr std::array<double, 2> round{0, 2 * std::numbers::pi};
    const double ahead = turn + round[turn < 0 ? 1 : 0];
    return (static_cast<unsigned>(ahead <= width) |
            static_cast<unsigned>(2 * std::numbers::pi - ahead <= other.width)) != 0;
  }
};

// All directions in which the line crosses the edge, ends included, and is not farther: where N, D - N, M and D - M have
// the sign of D, and D has the sign for which the line is nearer. A little wider because it is computed in doubles; all
// directions if these do not decide.
inline Sector sector_of(const Line& line) {
  constexpr double pi = std::numbers::pi;
  constexpr double margin = 1e-6;
  constexpr Sector whole{0, 2 * pi};
  if (line.d_size == 0 || line.order == 0) return whole;
  // A form is not negative within a quarter turn to both sides of this angle.
  const auto middle_of = [&line](std::int64_t x, std::int64_t z) {
    const double sign = line.order > 0 ? -1 : 1;
    return std::atan2(sign * static_cast<double>(x), sign * static_cast<double>(z));
  };
  const Crossing& forms = line.exact;
  const double middle = middle_of(forms.d.x, forms.d.z);
  double low = -pi / 2;
  double high = pi / 2;
  const std::array<LinearForm, 4> others{forms.n, LinearForm{forms.d.x - forms.n.x, forms.d.z - forms.n.z}, forms.m,
                                         LinearForm{forms.d.x - forms.m.x, forms.d.z - forms.m.z}};
  for (const LinearForm& form : others) {
    if (form.x == 0 && form.z == 0) continue;
    double turn = middle_of(form.x, form.z) - middle;
    if (turn > pi) turn -= 2 * pi;
    if (turn < -pi) turn += 2 * pi;
    if (std::abs(turn) > pi - margin) return whole;  // two opposite directions along one line
    if (turn > 0) low = std::max(low, turn - pi / 2);
    if (turn < 0) high = std::min(high, turn + pi / 2);
  }
  double from = middle + low - margin;
  if (from < 0) from += 2 * pi;
  if (from < 0) from += 2 * pi;
  return {from, high - low + 2 * margin};
}

inline NearDirection near(const Direction& direction) {
  return {std::sin(direction.angle), std::cos(direction.angle), 4 * angle_error};
}

inline NearDirection turned_round(const NearDirection& v) {
  return {-v.x, -v.z, v.error};
}

}  // namespace sightline::algorithms::plantinga
