#include "host/programs/turn/precision.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::programs::turn {

namespace {

// Two products truncated to whole numbers, and 2 added for them.
constexpr double product_error = 1.5;
// Two coefficients rounded to whole numbers, times a cosine and a sine.
constexpr double coefficient_error = 0.7072;
constexpr double rounding = 0.5;
// A fraction of an edge is the middle of one of 4096 parts.
constexpr double fraction_error = 1.0 / 8192;

}  // namespace

Precision::Value Precision::form(std::uint32_t address, double angle) const {
  const double a = word(address) - form_word_middle;
  const double b = word(address + 1) - form_word_middle;
  return {a * std::cos(angle) + b * std::sin(angle),
          product_error + coefficient_error + std::hypot(a, b) * rotation_error / (1 << 14)};
}

EndBound Precision::end(std::uint32_t slot, std::uint32_t code, bool second, double angle, double of_picture) const {
  // The forms of the two vertices are adjacent, in the order of their places.
  const std::uint32_t places = word(model_base(tape_.memory) + 5);
  const std::uint32_t forms = word(model_base(tape_.memory) + 4) + 1;
  const auto vertex = [&](std::uint32_t field) { return forms + (word(slot + field) - places); };
  const Value p = form(vertex(1), angle);
  const Value q = form(vertex(2), angle);
  constexpr std::uint32_t coordinate = 01777;
  const double dx = std::abs(q.value - p.value) / points_form_unit;
  const double dy = std::abs(static_cast<double>(word(word(slot + 1) + 1) & coordinate) -
                             static_cast<double>(word(word(slot + 2) + 1) & coordinate));
  const double of_vertex = rounding + std::max(p.error, q.error) / points_form_unit;
  EndBound bound;
  bound.at = second ? 1 : 0;
  bound.x = of_vertex;
  bound.y = rounding;
  if (code == 1) return bound;
  const std::uint32_t junction = word(slot + 3) + 4 * code + 1;
  const Value n = form(junction, angle);
  const Value d = form(junction + 2, angle);
  const auto part = [](const Value& of, const Value& whole) {
    return whole.value == 0 ? 0 : std::clamp(of.value / whole.value, 0.0, 1.0);
  };
  bound.junction = true;
  bound.at = part(n, d);
  const double moved = std::abs(part(form(junction, of_picture), form(junction + 2, of_picture)) - bound.at);
  const double certain = std::abs(d.value) - d.error;
  bound.along = certain <= 0 ? 1 : std::min(1.0, (n.error + d.error) / certain + fraction_error + moved);
  // Both vertices are rounded, and points between them are rounded again.
  bound.x = of_vertex + rounding + dx * bound.along;
  bound.y = 2 * rounding + dy * bound.along;
  return bound;
}

std::vector<PieceBound> Precision::pieces(std::span<const std::uint32_t> states, std::uint32_t angle,
                                          double of_picture) const {
  const double turn = radians(angle);
  std::vector<PieceBound> bounds;
  const std::uint32_t slots = word(model_base(tape_.memory) + 6);
  const std::uint32_t places = word(model_base(tape_.memory) + 5);
  const std::uint32_t forms = word(model_base(tape_.memory) + 4) + 1;
  for (std::uint32_t k = 0; k < states.size(); ++k) {
    if (states[k] == 0) continue;
    const std::uint32_t slot = slots + 4 * k;
    PieceBound& piece = bounds.emplace_back();
    piece.slot = k;
    const auto x = [&](std::uint32_t field) { return form(forms + (word(slot + field) - places), turn).value / points_form_unit; };
    const auto y = [&](std::uint32_t field) { return static_cast<double>(word(word(slot + field) + 1) & 01777U); };
    piece.length = std::hypot(x(2) - x(1), y(2) - y(1));
    piece.ends[0] = end(slot, states[k] >> 12U, false, turn, of_picture);
    piece.ends[1] = end(slot, states[k] >> 6U & 077U, true, turn, of_picture);
    piece.may_be_missing =
        piece.ends[1].junction && piece.ends[1].at - piece.ends[1].along <= piece.ends[0].at + piece.ends[0].along;
  }
  return bounds;
}

double picture_bound(std::span<const PieceBound> pieces) {
  double ends = 0;
  double missing = 0;
  for (const PieceBound& piece : pieces) {
    for (const EndBound& end : piece.ends) ends = std::max(ends, std::hypot(end.x, end.y));
    if (piece.may_be_missing)
      missing = std::max(missing, piece.length * std::min(1.0, 2 * (piece.ends[0].along + piece.ends[1].along)));
  }
  return ends + missing + corner_error;
}

double flash_bound() { return std::hypot(vector_wander, flash_step); }

}  // namespace sightline::programs::turn
