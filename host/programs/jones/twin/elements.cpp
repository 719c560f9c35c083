#include "host/programs/jones/twin/elements.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace sightline::programs::jones {

RingBound::RingBound(Axis plane, std::int32_t plane_coordinate, std::int32_t bound_factor,
                     std::int32_t largest)
    : plane_(plane),
      bound_factor_(bound_factor),
      largest_(largest),
      nearest_(plane == Axis::z ? near_z : depth_inside(std::abs(plane_coordinate), bound_factor)) {}

SpacePoint RingBound::into_bound(SpacePoint corner) const {
  corner.z = std::max(corner.z, nearest_);
  const std::int32_t limit = bound(bound_factor_, corner.z, largest_);
  corner.x = std::clamp(corner.x, -limit, limit);
  corner.y = std::clamp(corner.y, -limit, limit);
  return corner;
}

std::optional<SpacePoint> RingBound::bend(const SpaceSegment& vector) const {
  const std::int32_t along = plane_ == Axis::x ? vector.p.y : vector.p.x;
  const std::int32_t depth = depth_inside(std::abs(along), bound_factor_);
  const std::int32_t from = into_bound(vector.p).z;
  const std::int32_t to = into_bound(vector.q).z;
  if (depth <= std::min(from, to) || depth >= std::max(from, to)) return std::nullopt;
  return SpacePoint{vector.p.x, vector.p.y, depth};
}

namespace {

using core::Word18;

constexpr Word18 first_word{0010117};  // parameter: pen off, scale 0, intensity 7
constexpr Word18 stop{0003000};        // parameter: stop, interrupt
constexpr Word18 next_point{0020000};  // parameter: next mode point
constexpr std::uint32_t point_y = 0220000;
constexpr std::uint32_t point_x_lit = 0102000;  // next mode vector
constexpr std::uint32_t vector_lit = 0200000;
constexpr std::uint32_t vector_down = 0100000;
constexpr std::uint32_t vector_left = 0000200;
constexpr Word18 escape{0400000};
constexpr unsigned vector_dy_shift = 8;
constexpr std::int32_t longest_vector = 127;

std::uint32_t bits(std::int32_t magnitude) {
  return static_cast<std::uint32_t>(magnitude);
}

[[maybe_unused]] bool on_screen(ScreenPoint p) {
  return 0 <= p.x && p.x <= 1023 && 0 <= p.y && p.y <= 1023;
}

}  // namespace

DisplayFile::DisplayFile(std::size_t capacity, bool joining, bool truncate)
    : capacity_(capacity), joining_(joining), number_(machine_word_bits, machine_fraction_bits, truncate) {
  words_.push_back(first_word);
}

DisplayFile::Outcome DisplayFile::add(ScreenPoint a, ScreenPoint b, Operations& operations) {
  assert(on_screen(a) && on_screen(b));
  if (a == b) return Outcome::no_length;
  const std::int32_t dx = b.x - a.x;
  const std::int32_t dy = b.y - a.y;
  const std::int32_t count = (std::max(std::abs(dx), std::abs(dy)) + longest_vector - 1) / longest_vector;
  const bool joined = joining_ && beam_ == a;
  const std::size_t needed = static_cast<std::size_t>(count) + (joined ? 0 : 3);
  if (words_.size() + needed + 1 > capacity_) return Outcome::full;
  if (joined) {
    words_.back() = words_.back() & ~escape;
  } else {
    words_.push_back(next_point);
    words_.push_back(Word18(point_y + bits(a.y)));
    words_.push_back(Word18(point_x_lit + bits(a.x)));
  }
  add_vectors(dx, dy, count, operations);
  beam_ = b;
  return Outcome::drawn;
}

void DisplayFile::add_vectors(std::int32_t dx, std::int32_t dy, std::int32_t count, Operations& operations) {
  const std::uint32_t lit = vector_lit | (dy < 0 ? vector_down : 0) | (dx < 0 ? vector_left : 0);
  ScreenPoint done;
  const auto partial = [&](std::int32_t i, std::int32_t whole) {
    ++operations.display.muldivs;
    return number_.muldiv(i, std::abs(whole), count).value();
  };
  for (std::int32_t i = 1; i <= count; ++i) {
    const ScreenPoint sum{partial(i, dx), partial(i, dy)};
    const std::int32_t mx = sum.x - done.x;
    const std::int32_t my = sum.y - done.y;
    assert(0 <= mx && mx <= longest_vector && 0 <= my && my <= longest_vector);
    words_.push_back(Word18(lit | bits(my) << vector_dy_shift | bits(mx)));
    done = sum;
  }
  words_.back() = words_.back() | escape;
}

std::vector<Word18> DisplayFile::finish() && {
  words_.push_back(stop);
  return std::move(words_);
}

}  // namespace sightline::programs::jones
