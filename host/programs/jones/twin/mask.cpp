#include "host/programs/jones/twin/mask.hpp"

#include <cassert>

namespace sightline::programs::jones {

template <class Number>
auto MaskClip<Number>::box_lines(const BasicMask<Coordinate>& m) -> std::array<BoxLine, 4> {
  return {BoxLine{&Point::x, m.xlo, true}, BoxLine{&Point::x, m.xhi, false}, BoxLine{&Point::y, m.ylo, true},
          BoxLine{&Point::y, m.yhi, false}};
}

template <class Number>
auto MaskClip<Number>::product(Coordinate a, Coordinate b, Work& work) -> Distance {
  ++work.products;
  return number_.double_word(Distance{a} * b);
}

template <class Number>
auto MaskClip<Number>::distance(const BoxLine& line, Point p, Work&) -> Distance {
  const Coordinate along = p.*line.axis;
  return line.low ? difference(along, line.value) : difference(line.value, along);
}

template <class Number>
auto MaskClip<Number>::distance(const SlopedLine& line, Point p, Work& work) -> Distance {
  const Distance left = product(difference(line.b.x, line.a.x), difference(p.y, line.a.y), work);
  const Distance right = product(difference(line.b.y, line.a.y), difference(p.x, line.a.x), work);
  return number_.double_word(left - right);
}

// from + the share of the difference to `to`: cannot overflow.
template <class Number>
auto MaskClip<Number>::between(Coordinate from, Coordinate to, Share<Coordinate> share, Work& work)
    -> Coordinate {
  const Coordinate way = difference(to, from);
  ++work.muldivs;
  const auto step = number_.muldiv(way < 0 ? -way : way, share.num, share.den);
  assert(step.has_value());
  return number_.word(Distance{from} + (way < 0 ? -*step : *step));
}

template <class Number>
auto MaskClip<Number>::cross(const BoxLine& line, Point p, Point q, Distance dp, Distance dq, Work& work)
    -> Point {
  const auto other = line.axis == &Point::x ? &Point::y : &Point::x;
  Point point;
  point.*line.axis = line.value;
  point.*other = between(p.*other, q.*other, number_.share_of(dp, dq), work);
  return point;
}

template <class Number>
auto MaskClip<Number>::cross(const SlopedLine&, Point p, Point q, Distance dp, Distance dq, Work& work)
    -> Point {
  const auto share = number_.share_of(dp, dq);
  return {between(p.x, q.x, share, work), between(p.y, q.y, share, work)};
}

template <class Number>
template <class ClipLine>
bool MaskClip<Number>::clip_at(const ClipLine& at, BasicScreenSegment<Coordinate>& line, Work& work) {
  const Distance da = distance(at, line.a, work);
  const Distance db = distance(at, line.b, work);
  if (da < 0 && db < 0) return false;
  if (da < 0) {
    line.a = cross(at, line.a, line.b, da, db, work);
  } else if (db < 0) {
    line.b = cross(at, line.a, line.b, da, db, work);
  }
  return true;
}

template <class Number>
template <class ClipLine>
MaskOutcome MaskClip<Number>::clip_at(const ClipLine& at, BasicPolygonBuilder<Coordinate>& polygon,
                                      Work& work) {
  const BasicPolygonBuilder<Coordinate> before = polygon;
  const auto points = before.points();
  polygon = {};
  const Distance first = distance(at, points.front(), work);
  Distance dp = first;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool last = i + 1 == points.size();
    const Point q = last ? points.front() : points[i + 1];
    const Distance dq = last ? first : distance(at, q, work);
    if (dp >= 0 && !polygon.append(points[i])) return MaskOutcome::too_many_vertices;
    if ((dp >= 0) != (dq >= 0) && !polygon.append(cross(at, points[i], q, dp, dq, work)))
      return MaskOutcome::too_many_vertices;
    dp = dq;
  }
  polygon.close();
  return polygon.points().size() < 3 ? MaskOutcome::empty : MaskOutcome::visible;
}

template <class Number>
auto MaskClip<Number>::doubled_area(std::span<const Point> ring) -> Distance {
  Distance sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    sum =
        number_.double_word(sum + distance(SlopedLine{ring[0], ring[i]}, ring[i + 1], operations_.mask_area));
  }
  return sum;
}

template <class Number>
auto MaskClip<Number>::clip2(const BasicMask<Coordinate>& mask, const BasicScreenSegment<Coordinate>& line)
    -> std::optional<BasicScreenSegment<Coordinate>> {
  BasicScreenSegment<Coordinate> piece = line;
  for (const BoxLine& at : box_lines(mask)) {
    if (!clip_at(at, piece, operations_.line_box)) return std::nullopt;
  }
  const auto ring = mask.ring();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const SlopedLine at{ring[i], ring[(i + 1) % ring.size()]};
    if (is_sloped(at.a, at.b) && !clip_at(at, piece, operations_.line_sloped)) return std::nullopt;
  }
  if (piece.a == piece.b) return std::nullopt;
  return piece;
}

template <class Number>
auto MaskClip<Number>::intersect(const BasicMask<Coordinate>& mask, std::span<const Point> ring)
    -> BasicIntersection<Coordinate> {
  assert(ring.size() >= 3 && ring.size() <= max_mask_vertices);
  const BasicMask<Coordinate> opening = mask_around(ring);
  if (opening.xhi <= mask.xlo || opening.xlo >= mask.xhi || opening.yhi <= mask.ylo ||
      opening.ylo >= mask.yhi)
    return {};
  BasicPolygonBuilder<Coordinate> polygon;
  for (const Point p : ring) {
    if (!polygon.append(p)) return {MaskOutcome::too_many_vertices, {}};
  }
  for (const BoxLine& at : box_lines(mask)) {
    const auto outcome = clip_at(at, polygon, operations_.mask_box);
    if (outcome != MaskOutcome::visible) return {outcome, {}};
  }
  const auto edges = mask.ring();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const SlopedLine at{edges[i], edges[(i + 1) % edges.size()]};
    if (!is_sloped(at.a, at.b)) continue;
    const auto outcome = clip_at(at, polygon, operations_.mask_sloped);
    if (outcome != MaskOutcome::visible) return {outcome, {}};
  }
  if constexpr (requires { number_.convex_masks(); }) {
    if (number_.convex_masks()) polygon.drop_hollow_corners();
  }
  const BasicMask<Coordinate> result = mask_around(polygon.points());
  if (result.xlo == result.xhi || result.ylo == result.yhi) return {};
  if (sloped_edges(result) > 0 && doubled_area(result.ring()) <= 0) return {};
  return {MaskOutcome::visible, result};
}

template class MaskClip<ShortWords>;
template class MaskClip<LongWords>;
template class MaskClip<MixedWords>;
template class MaskClip<SingleFloat>;
template class MaskClip<DoubleFloat>;

std::optional<ScreenSegment> clip2(const Mask& mask, const ScreenSegment& line, Operations& operations) {
  ShortWords number;
  return MaskClip(number, operations).clip2(mask, line);
}

Intersection intersect(const Mask& mask, std::span<const ScreenPoint> ring, Operations& operations) {
  ShortWords number;
  return MaskClip(number, operations).intersect(mask, ring);
}

}  // namespace sightline::programs::jones
