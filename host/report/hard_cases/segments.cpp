#include "host/report/hard_cases/segments.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>

#include "host/geometry/integer.hpp"
#include "host/geometry/interval_set.hpp"

namespace sightline::harness::report {

namespace {

using geometry::Rational;
using scene::PolyPoint;

bool on_line(const SceneSegment& segment, const PolyPoint& point) {
  const auto& [from, to] = segment;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    if (std::int64_t{to[a] - from[a]} * (point[b] - from[b]) !=
        std::int64_t{to[b] - from[b]} * (point[a] - from[a]))
      return false;
  }
  return true;
}

std::size_t longest_axis(const SceneSegment& segment) {
  std::size_t longest = 0;
  for (std::size_t a = 1; a < 3; ++a) {
    if (std::abs(segment.second[a] - segment.first[a]) >
        std::abs(segment.second[longest] - segment.first[longest]))
      longest = a;
  }
  return longest;
}

// The coordinate from + s (to - from); nothing if the fraction is too long to be held.
std::optional<Rational> coordinate(std::int64_t from, std::int64_t to, const Rational& s) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const geometry::Int128 numerator =
      geometry::Int128{from} * s.denominator() + geometry::Int128{to - from} * s.numerator();
  if (numerator > most || numerator < -most) return std::nullopt;
  return Rational(static_cast<std::int64_t>(numerator), s.denominator());
}

}  // namespace

SegmentSeen seen_of(const SceneSegment& segment, const picture::LinePicture& picture,
                    const scene::PolyScene& scene) {
  const std::size_t axis = longest_axis(segment);
  const auto [low, high] = std::minmax(segment.first[axis], segment.second[axis]);
  geometry::IntervalSet seen;
  for (const picture::LinePiece& piece : picture.pieces) {
    const PolyPoint& from = scene.vertices[piece.edge.from];
    const PolyPoint& to = scene.vertices[piece.edge.to];
    if (!on_line(segment, from) || !on_line(segment, to)) continue;
    auto a = coordinate(from[axis], to[axis], piece.low);
    auto b = coordinate(from[axis], to[axis], piece.high);
    if (!a || !b) return SegmentSeen::in_part;
    if (*b < *a) std::swap(a, b);
    seen.unite(*a, *b);
  }
  seen.intersect(low, high);
  if (seen.empty()) return SegmentSeen::nothing;
  return seen == geometry::IntervalSet(low, high) ? SegmentSeen::whole : SegmentSeen::in_part;
}

}  // namespace sightline::harness::report
