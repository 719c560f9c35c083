#include "host/programs/jones/twin/rotation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace sightline::programs::jones {

namespace {

constexpr std::int64_t one = 1 << 16;

// A double word of 36 bits.
std::int64_t wrapped_double(std::int64_t value) {
  constexpr std::int64_t wrap = std::int64_t{1} << 36;
  const std::int64_t low = value & (wrap - 1);
  return low >= wrap / 2 ? low - wrap : low;
}

std::int32_t sine_of(std::int32_t degrees) {
  const std::int32_t turn = whole_turn(degrees);
  const std::int32_t half = turn % 180;
  const auto sine = static_cast<std::int32_t>(std::lround(65536 * std::sin(std::min(half, 180 - half) * std::numbers::pi / 180)));
  return turn < 180 ? sine : -sine;
}

std::int32_t with_sign(std::int64_t sign, std::int32_t value) { return sign < 0 ? -value : value; }

}  // namespace

std::int32_t whole_turn(std::int32_t degrees) { return (degrees % 360 + 360) % 360; }

Direction direction_of(std::int32_t degrees) { return {sine_of(whole_turn(degrees) + 90), sine_of(degrees)}; }

std::array<std::int32_t, 2> TurnedSteps::take(const Direction& direction, std::int32_t right, std::int32_t ahead) {
  const std::array<std::int64_t, 2> sums{rest_[0] + std::int64_t{right} * direction.cosine + std::int64_t{ahead} * direction.sine,
                                         rest_[1] - std::int64_t{right} * direction.sine + std::int64_t{ahead} * direction.cosine};
  std::array<std::int32_t, 2> steps{};
  for (std::size_t n = 0; n < 2; ++n) {
    steps[n] = static_cast<std::int32_t>(sums[n] >> 16);
    rest_[n] = sums[n] & (one - 1);
  }
  return steps;
}

RotatedView::RotatedView(const Direction& direction, const Window& window, const ShortWords& number)
    : direction_(direction), number_(number), bound_(window.bound_factor * window.width_scale), shift_(std::countr_zero(static_cast<unsigned>(window.bound_factor))) {}

TurnedPlace RotatedView::moved(TurnedPlace place, Axis axis, std::int32_t units) const {
  if (axis == Axis::y) return place;
  const std::int64_t x = axis == Axis::x ? direction_.cosine : -direction_.sine;
  const std::int64_t z = axis == Axis::x ? direction_.sine : direction_.cosine;
  return {wrapped_double(place.x + units * x), wrapped_double(place.z + units * z)};
}

RotatedView::Quotient RotatedView::quotient(std::int64_t t, std::int64_t d) const {
  if (t > d) return {bound_, true};
  const int excess = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(d))) - 17;
  const auto single = [&](std::int64_t value) { return static_cast<std::int32_t>(excess >= 0 ? value >> excess : value << -excess); };
  return {*number_.muldiv(single(t), bound_, single(d)), false};
}

std::optional<SeenCorner> RotatedView::corner(const TurnedPlace& place, std::int32_t y) const {
  const std::int64_t most = std::int64_t{1} << (34 - shift_);
  if (place.z < -most || place.z >= most) return std::nullopt;
  const std::int64_t d = place.z * (std::int64_t{1} << shift_);
  SeenCorner corner;
  if (place.x > d) corner.beyond |= beyond_right;
  if (place.x < -d) corner.beyond |= beyond_left;
  if (corner.beyond == beyond_none && d == 0) corner.beyond = beyond_both;
  if (corner.beyond != beyond_none) return corner;
  const Quotient down = quotient(std::abs(std::int64_t{y}) * one, d);
  corner.place = {with_sign(place.x, quotient(std::abs(place.x), d).value), with_sign(y, down.value)};
  corner.drawn_back = down.drawn_back;
  return corner;
}

std::optional<SeenLevel> RotatedView::level(Axis axis, const SpacePoint& at, const SeenCorner& a, const SeenCorner& b) const {
  if ((a.beyond & b.beyond) != 0) return std::nullopt;
  const Line line = axis == Axis::x ? Line{at.z, at.y, direction_.cosine, -direction_.sine} : Line{at.x, at.y, direction_.sine, direction_.cosine};
  const auto from = moved_to_side(line, a, b);
  const auto to = moved_to_side(line, b, a);
  if (!from || !to) return std::nullopt;
  SeenLevel seen{*from, *to, {}};
  if (seen.a.drawn_back != seen.b.drawn_back && line.beta != 0) seen.bend = bend(line);
  return seen;
}

std::optional<SeenCorner> RotatedView::moved_to_side(const Line& line, const SeenCorner& end, const SeenCorner& other) const {
  if (end.beyond == beyond_none) return end;
  if (line.w == 0) {
    if (other.beyond != beyond_none || line.y == 0) return std::nullopt;
    return SeenCorner{beyond_eye, {other.place.x, with_sign(line.y, bound_)}, true};
  }
  unsigned side = end.beyond;
  if (side == beyond_both) side = (line.w < 0) == (line.beta < 0) ? beyond_right : beyond_left;
  const std::int32_t sigma = side == beyond_right ? 1 : -1;
  if (((line.alpha >> shift_) + sigma * line.beta < 0) != (line.w < 0)) return std::nullopt;
  const std::int64_t y = std::abs(std::int64_t{line.y});
  const std::int64_t t = ((y * line.alpha) >> shift_) + sigma * y * line.beta;
  const Quotient down = quotient(std::abs(t), std::abs(std::int64_t{line.w}) * one);
  return SeenCorner{side, {sigma * bound_, with_sign(line.y, down.value)}, down.drawn_back};
}

ScreenPoint RotatedView::bend(const Line& line) const {
  const std::int64_t y = std::abs(std::int64_t{line.y});
  const std::int64_t q = line.w * one - ((y * line.alpha) >> shift_);
  const Quotient across = quotient(std::abs(q), y * std::abs(line.beta));
  return {with_sign((q < 0) == (line.beta < 0) ? 1 : -1, across.value), with_sign(line.y, bound_)};
}

ScreenPoint RotatedView::bound_corner(unsigned side, std::int32_t y) const {
  return {side == beyond_right ? bound_ : -bound_, with_sign(y, bound_)};
}

}  // namespace sightline::programs::jones
