#include "host/harness/jones_twin_mask.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace sightline::harness::jones {
namespace {

constexpr std::int32_t word_max = 131071;

// A result that must fit one word.
std::int32_t word(std::int64_t value) {
  assert(-word_max - 1 <= value && value <= word_max);
  return static_cast<std::int32_t>(value);
}

// A result that must fit two words.
std::int64_t double_word(std::int64_t value) {
  assert(-(std::int64_t{1} << 35) <= value && value < (std::int64_t{1} << 35));
  return value;
}

std::int64_t product(std::int32_t a, std::int32_t b, Work& work) {
  ++work.products;
  return double_word(std::int64_t{word(a)} * word(b));
}

// A clip line: one side of the box of a mask, or one of its sloped edges.
struct BoxLine {
  std::int32_t ScreenPoint::*axis;
  std::int32_t value;
  bool low;
};
struct SlopedLine {
  ScreenPoint a, b;
};

std::array<BoxLine, 4> box_lines(const Mask& m) {
  return {BoxLine{&ScreenPoint::x, m.xlo, true}, BoxLine{&ScreenPoint::x, m.xhi, false},
          BoxLine{&ScreenPoint::y, m.ylo, true}, BoxLine{&ScreenPoint::y, m.yhi, false}};
}

std::int64_t distance(const BoxLine& line, ScreenPoint p, Work&) {
  const std::int32_t along = p.*line.axis;
  return word(line.low ? std::int64_t{along} - line.value : std::int64_t{line.value} - along);
}

std::int64_t distance(const SlopedLine& line, ScreenPoint p, Work& work) {
  const std::int64_t left = product(line.b.x - line.a.x, p.y - line.a.y, work);
  const std::int64_t right = product(line.b.y - line.a.y, p.x - line.a.x, work);
  return double_word(left - right);
}

// from + the share num/den of the way to `to`, 0 <= num <= den: never overflows.
std::int32_t between(std::int32_t from, std::int32_t to, std::int32_t num, std::int32_t den, Work& work) {
  const std::int32_t way = word(std::int64_t{to} - from);
  ++work.muldivs;
  const auto step = muldiv(std::abs(way), num, den);
  assert(step.has_value() && *step <= std::abs(way));
  return from + (way < 0 ? -*step : *step);
}

struct Share {
  std::int32_t num, den;
};
Share share_of(std::int64_t dp, std::int64_t dq) {
  std::int64_t num = std::abs(dp);
  std::int64_t den = double_word(num + std::abs(dq));
  while (den >= std::int64_t{1} << 17) {
    num >>= 1;
    den >>= 1;
  }
  return {word(num), word(den)};
}

ScreenPoint cross(const BoxLine& line, ScreenPoint p, ScreenPoint q, std::int64_t dp, std::int64_t dq,
                  Work& work) {
  const Share share = share_of(dp, dq);
  const auto other = line.axis == &ScreenPoint::x ? &ScreenPoint::y : &ScreenPoint::x;
  ScreenPoint point;
  point.*line.axis = line.value;
  point.*other = between(p.*other, q.*other, share.num, share.den, work);
  return point;
}

ScreenPoint cross(const SlopedLine&, ScreenPoint p, ScreenPoint q, std::int64_t dp, std::int64_t dq,
                  Work& work) {
  const Share share = share_of(dp, dq);
  return {between(p.x, q.x, share.num, share.den, work), between(p.y, q.y, share.num, share.den, work)};
}

// False if nothing of the line is on the inner side.
template <class ClipLine>
bool clip_at(const ClipLine& at, ScreenSegment& line, Work& work) {
  const std::int64_t da = distance(at, line.a, work);
  const std::int64_t db = distance(at, line.b, work);
  if (da < 0 && db < 0) return false;
  if (da < 0) {
    line.a = cross(at, line.a, line.b, da, db, work);
  } else if (db < 0) {
    line.b = cross(at, line.a, line.b, da, db, work);
  }
  return true;
}

// False if the polygon has too many vertices.
template <class ClipLine>
bool clip_at(const ClipLine& at, PolygonBuilder& polygon, Work& work) {
  const PolygonBuilder before = polygon;
  const auto points = before.points();
  polygon = PolygonBuilder();
  const std::int64_t first = distance(at, points.front(), work);
  std::int64_t dp = first;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool last = i + 1 == points.size();
    const ScreenPoint q = last ? points.front() : points[i + 1];
    const std::int64_t dq = last ? first : distance(at, q, work);
    if (dp >= 0 && !polygon.append(points[i])) return false;
    if ((dp >= 0) != (dq >= 0) && !polygon.append(cross(at, points[i], q, dp, dq, work))) return false;
    dp = dq;
  }
  polygon.close();
  return true;
}

void set_box(Mask& mask) {
  const auto ring = mask.ring();
  const auto [left, right] =
      std::minmax_element(ring.begin(), ring.end(), [](auto a, auto b) { return a.x < b.x; });
  const auto [low, high] =
      std::minmax_element(ring.begin(), ring.end(), [](auto a, auto b) { return a.y < b.y; });
  mask.xlo = left->x;
  mask.xhi = right->x;
  mask.ylo = low->y;
  mask.yhi = high->y;
}

Mask mask_of(std::span<const ScreenPoint> ring) {
  Mask mask;
  mask.count = static_cast<int>(ring.size());
  std::copy(ring.begin(), ring.end(), mask.vertices.begin());
  set_box(mask);
  return mask;
}

std::int64_t doubled_area(std::span<const ScreenPoint> ring, Work& work) {
  std::int64_t sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    sum = double_word(sum + distance(SlopedLine{ring[0], ring[i]}, ring[i + 1], work));
  }
  return sum;
}

bool boxes_overlap(const Mask& a, const Mask& b) {
  return a.xhi > b.xlo && a.xlo < b.xhi && a.yhi > b.ylo && a.ylo < b.yhi;
}

}  // namespace

int sloped_edges(const Mask& mask) {
  const auto ring = mask.ring();
  int count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) count += is_sloped(ring[i], ring[(i + 1) % ring.size()]);
  return count;
}

Mask mask_of(const Window& w) {
  return mask_of(std::array{ScreenPoint{w.xlo, w.ylo}, ScreenPoint{w.xhi, w.ylo}, ScreenPoint{w.xhi, w.yhi},
                            ScreenPoint{w.xlo, w.yhi}});
}

std::optional<ScreenSegment> clip2(const Mask& mask, const ScreenSegment& line, Operations& operations) {
  ScreenSegment piece = line;
  for (const BoxLine& at : box_lines(mask)) {
    if (!clip_at(at, piece, operations.line_box)) return std::nullopt;
  }
  const auto ring = mask.ring();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const SlopedLine at{ring[i], ring[(i + 1) % ring.size()]};
    if (is_sloped(at.a, at.b) && !clip_at(at, piece, operations.line_sloped)) return std::nullopt;
  }
  if (piece.a == piece.b) return std::nullopt;
  return piece;
}

bool PolygonBuilder::append(ScreenPoint point) {
  if (count_ > 0 && points_[static_cast<std::size_t>(count_ - 1)] == point) return true;
  if (count_ == static_cast<int>(points_.size())) return false;
  points_[static_cast<std::size_t>(count_++)] = point;
  return true;
}

void PolygonBuilder::close() {
  if (count_ > 1 && points_[static_cast<std::size_t>(count_ - 1)] == points_.front()) --count_;
}

void PolygonBuilder::reverse() {
  std::reverse(points_.begin(), points_.begin() + count_);
}

Intersection intersect(const Mask& mask, std::span<const ScreenPoint> ring, Operations& operations) {
  constexpr Intersection too_many{MaskOutcome::too_many_vertices, {}};
  assert(ring.size() >= 3 && ring.size() <= max_mask_vertices);
  if (!boxes_overlap(mask_of(ring), mask)) return {};
  PolygonBuilder polygon;
  for (const ScreenPoint p : ring) {
    if (!polygon.append(p)) return too_many;
  }
  const auto clip = [&](const auto& at, Work& work) {
    const bool fits = clip_at(at, polygon, work);
    return !fits                         ? MaskOutcome::too_many_vertices
           : polygon.points().size() < 3 ? MaskOutcome::empty
                                         : MaskOutcome::visible;
  };
  for (const BoxLine& at : box_lines(mask)) {
    const auto outcome = clip(at, operations.mask_box);
    if (outcome != MaskOutcome::visible) return {outcome, {}};
  }
  const auto edges = mask.ring();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const SlopedLine at{edges[i], edges[(i + 1) % edges.size()]};
    if (!is_sloped(at.a, at.b)) continue;
    const auto outcome = clip(at, operations.mask_sloped);
    if (outcome != MaskOutcome::visible) return {outcome, {}};
  }
  const Mask result = mask_of(polygon.points());
  if (result.xlo == result.xhi || result.ylo == result.yhi) return {};
  if (sloped_edges(result) > 0 && doubled_area(result.ring(), operations.mask_area) <= 0) return {};
  return {MaskOutcome::visible, result};
}

}  // namespace sightline::harness::jones
