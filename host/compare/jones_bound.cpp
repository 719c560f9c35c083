// See jones_bound.hpp.
#include "host/compare/jones_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "host/programs/jones/encode.hpp"
#include "host/programs/jones/twin/elements.hpp"
#include "host/programs/turn/precision.hpp"
#include "host/picture/line_metrics.hpp"

namespace sightline::compare {
namespace {

namespace jones = programs::jones;
using picture::PixelPoint;

constexpr double half = 0.5;                        // the error of a rounded unit
constexpr double corner = 1 / std::numbers::sqrt2;  // the error of a point with both coordinates rounded
// The error of a projected coordinate in a turned view: half a unit as before; the quotient's 17 bits, at most 2^15 / 2^16; and
// the length of the direction, whose cosine and sine are rounded to 2^-16, at most 2^14 * sqrt(2) / 2^16.
constexpr double turned = 1.36;
constexpr double on_line = 1e-6;                    // units: shorter distances count as 0
constexpr double no_area = 1e-6;

// A straight line of the image, from one end to the other, and the greatest error of its computed ends.
struct Side {
  PixelPoint along;              // its direction, of length 1
  std::array<double, 2> away{};  // the errors at its beginning and its end, in units
  bool of_window = false;

  [[nodiscard]] bool is_sloped() const { return along.x != 0 && along.y != 0; }
  // The component at right angles to the line of a rounding by half a unit in these coordinates.
  [[nodiscard]] double across(bool x, bool y) const { return half * ((x ? std::abs(along.y) : 0) + (y ? std::abs(along.x) : 0)); }
  [[nodiscard]] double away_at(double share) const { return std::abs(1 - share) * away[0] + std::abs(share) * away[1]; }
};

double length_of(const PixelPoint& a, const PixelPoint& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}
double sine_of(const Side& a, const Side& b) {
  return std::abs(a.along.x * b.along.y - a.along.y * b.along.x);
}
double cosine_of(const Side& a, const Side& b) {
  return std::abs(a.along.x * b.along.x + a.along.y * b.along.y);
}

// A projected line: both ends are rounded.
Side project_side(const PixelPoint& a, const PixelPoint& b) {
  const double length = length_of(a, b);
  Side side{{(b.x - a.x) / length, (b.y - a.y) / length}, {}, false};
  side.away.fill(side.across(true, true));
  return side;
}

struct ClipCorner {
  PixelPoint place;
  Side next;  // to the next corner
};
using Polygon = std::vector<ClipCorner>;  // counter-clockwise

// A clip line; its left side is kept.
struct ClipLine {
  PixelPoint at;
  Side side;
  double length = 0;  // of the side; 0: a side of the bounding box

  [[nodiscard]] double distance(const PixelPoint& p) const { return side.along.x * (p.y - at.y) - side.along.y * (p.x - at.x); }
  [[nodiscard]] bool holds(const PixelPoint& p) const { return distance(p) >= -on_line; }
  // The error of the computed clip line at p.
  [[nodiscard]] double away(const PixelPoint& p) const {
    return length > 0 ? side.away_at((side.along.x * (p.x - at.x) + side.along.y * (p.y - at.y)) / length) : side.away[0];
  }
};

// The bounding box first, then the sloped sides, as in the program.
std::vector<ClipLine> clip_lines(const Polygon& mask) {
  std::vector<ClipLine> lines;
  constexpr std::array<PixelPoint, 4> ways{{{0, -1}, {0, 1}, {1, 0}, {-1, 0}}};  // x >= xlo, x <= xhi, y >= ylo, y <= yhi
  for (const PixelPoint& way : ways) {
    ClipLine line{mask.front().place, {way, {}, false}, 0};
    for (const ClipCorner& c : mask)
      if (line.distance(c.place) < 0) line.at = c.place;
    // The error of a collinear side, or else that of a corner.
    double away = corner;
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const Side& side = mask[i].next;
      if (std::abs(line.distance(mask[i].place)) > on_line ||
          std::abs(line.distance(mask[(i + 1) % mask.size()].place)) > on_line)
        continue;
      away = std::max(side.away[0], side.away[1]);
      line.side.of_window = side.of_window;
    }
    line.side.away.fill(away);
    lines.push_back(line);
  }
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i].next.is_sloped())
      lines.push_back({mask[i].place, mask[i].next, length_of(mask[i].place, mask[(i + 1) % mask.size()].place)});
  return lines;
}

class Bound {
 public:
  Bound(const scene::CellScene& scene, const geometry::Point& eye, const JonesWords& words, const std::optional<jones::Direction>& direction)
      : scene_(scene),
        eye_(eye),
        direction_(direction),
        window_(jones::window_of(jones::Pass::mono, 512, words.fraction_bits, words.word_bits)),
        share_(std::ldexp(1.0, 2 - words.word_bits)) {
    const auto at = [](std::int32_t x, std::int32_t y) { return PixelPoint{static_cast<double>(x), static_cast<double>(y)}; };
    Polygon mask{{at(window_.xlo, window_.ylo), {}},
                 {at(window_.xhi, window_.ylo), {}},
                 {at(window_.xhi, window_.yhi), {}},
                 {at(window_.xlo, window_.yhi), {}}};
    for (std::size_t i = 0; i < 4; ++i) {
      mask[i].next = project_side(mask[i].place, mask[(i + 1) % 4].place);
      mask[i].next.away = {0, 0};
      mask[i].next.of_window = true;
    }
    const auto view = jones::viewpoint(scene, eye);
    if (view) visit(view->cell, mask, scene.openings.size(), 1);
  }

  [[nodiscard]] double units() const { return greatest_; }

 private:
  [[nodiscard]] jones::SpacePoint to_camera(const geometry::Point& p) const {
    return {p[0] - eye_[0], p[1] - eye_[1], p[2] - eye_[2]};
  }
  [[nodiscard]] PixelPoint project(const jones::SpacePoint& p) const {
    return {static_cast<double>(p.x) * window_.width_scale / p.z, static_cast<double>(p.y) * window_.width_scale / p.z};
  }

  void visit(std::size_t number, const Polygon& mask, std::size_t entry, std::size_t depth) {
    const scene::Cell& cell = scene_.cells[number];
    const std::vector<ClipLine> clip = clip_lines(mask);
    for (const scene::Line& line : cell.lines) draw(to_camera(line.from), to_camera(line.to), clip);
    for (std::size_t o = 0; o < scene_.openings.size(); ++o) {
      const scene::Opening& opening = scene_.openings[o];
      if (o == entry || (opening.cells[0] != number && opening.cells[1] != number)) continue;
      const bool upwards = opening.cells[0] == number;
      geometry::Point at = opening.ring.front();
      for (const scene::RingVector& vector : opening.vectors) {
        geometry::Point to = at;
        to[vector.axis] += vector.magnitude;
        if (vector.actual) draw(to_camera(at), to_camera(to), clip);
        at = to;
      }
      const std::size_t axis = opening.place.axis;
      const std::int32_t ahead = opening.place.at - eye_[axis];
      if (axis == 2 && !direction_ ? !upwards || ahead < 1 : upwards ? ahead <= 0 : ahead >= 0) continue;
      Polygon through = outline(opening, ahead);
      for (const ClipLine& line : clip) cut(through, line);
      if (through.size() >= 3 && area(through) > no_area && depth < scene_.cells.size())
        visit(opening.cells[upwards ? 1 : 0], through, o, depth + 1);
    }
  }

  // The ring on the screen, clipped to the box.
  [[nodiscard]] Polygon outline(const scene::Opening& opening, std::int32_t ahead) const {
    if (direction_) return turned_outline(opening);
    const jones::RingBound bound(jones::Axis{static_cast<std::uint8_t>(opening.place.axis + 1)}, ahead, window_.bound_factor);
    std::vector<PixelPoint> places;
    const auto add = [&](const jones::SpacePoint& p) { places.push_back(project(p)); };
    geometry::Point at = opening.ring.front();
    for (const scene::RingVector& vector : opening.vectors) {
      geometry::Point to = at;
      to[vector.axis] += vector.magnitude;
      add(bound.into_bound(to_camera(at)));
      const auto bend = vector.axis == 2 ? bound.bend({to_camera(at), to_camera(to)}) : std::nullopt;
      if (bend) add(*bend);
      at = to;
    }
    return polygon_of(places);
  }

  [[nodiscard]] Polygon polygon_of(const std::vector<PixelPoint>& places) const {
    Polygon polygon;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (length_of(places[i], places[(i + 1) % places.size()]) > on_line) polygon.push_back({places[i], {}});
    if (area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
    for (std::size_t i = 0; i < polygon.size(); ++i)
      polygon[i].next = projected(polygon[i].place, polygon[(i + 1) % polygon.size()].place);
    return polygon;
  }

  // A projected line with the error of its ends.
  [[nodiscard]] Side projected(const PixelPoint& a, const PixelPoint& b) const {
    Side side = project_side(a, b);
    if (direction_)
      for (double& away : side.away) away *= turned / half;
    return side;
  }

  // From the eye, as the turned view looks.
  struct TurnedPoint {
    double x = 0, y = 0, z = 0;
  };
  [[nodiscard]] TurnedPoint turn(const jones::SpacePoint& p) const {
    const double c = std::ldexp(direction_->cosine, -16), s = std::ldexp(direction_->sine, -16);
    return {p.x * c - p.z * s, static_cast<double>(p.y), p.x * s + p.z * c};
  }
  // Not negative before the four sides of the bound.
  [[nodiscard]] std::array<double, 4> depths(const TurnedPoint& p) const {
    const double far = window_.bound_factor * p.z;
    return {far - p.x, far + p.x, far - p.y, far + p.y};
  }
  static TurnedPoint between(const TurnedPoint& p, const TurnedPoint& q, double share) {
    return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y), p.z + share * (q.z - p.z)};
  }
  [[nodiscard]] PixelPoint project(const TurnedPoint& p) const { return {p.x * window_.width_scale / p.z, p.y * window_.width_scale / p.z}; }

  [[nodiscard]] Polygon turned_outline(const scene::Opening& opening) const {
    std::vector<TurnedPoint> ring;
    geometry::Point at = opening.ring.front();
    for (const scene::RingVector& vector : opening.vectors) {
      ring.push_back(turn(to_camera(at)));
      at[vector.axis] += vector.magnitude;
    }
    for (std::size_t side = 0; side < 4; ++side) {
      std::vector<TurnedPoint> left;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const TurnedPoint& p = ring[i];
        const TurnedPoint& q = ring[(i + 1) % ring.size()];
        const double dp = depths(p)[side], dq = depths(q)[side];
        if (dp >= 0) left.push_back(p);
        if ((dp >= 0) != (dq >= 0)) left.push_back(between(p, q, dp / (dp - dq)));
      }
      ring = std::move(left);
    }
    std::vector<PixelPoint> places;
    for (const TurnedPoint& p : ring)
      if (p.z > 0) places.push_back(project(p));
    return polygon_of(places);
  }

  // The ends on the screen of what the bound leaves of a line.
  [[nodiscard]] std::optional<std::array<PixelPoint, 2>> turned_ends(const jones::SpacePoint& from, const jones::SpacePoint& to) const {
    const TurnedPoint p = turn(from), q = turn(to);
    double low = 0, high = 1;
    const auto dp = depths(p), dq = depths(q);
    for (std::size_t side = 0; side < 4; ++side) {
      if (dp[side] < 0 && dq[side] < 0) return std::nullopt;
      if (dp[side] < 0) low = std::max(low, dp[side] / (dp[side] - dq[side]));
      if (dq[side] < 0) high = std::min(high, dp[side] / (dp[side] - dq[side]));
    }
    const TurnedPoint a = between(p, q, low), b = between(p, q, high);
    if (low >= high || a.z <= 0 || b.z <= 0) return std::nullopt;
    return std::array{project(a), project(b)};
  }
  [[nodiscard]] std::optional<std::array<PixelPoint, 2>> level_ends(const jones::SpacePoint& from, const jones::SpacePoint& to) const {
    const jones::Axis axis = from.x != to.x ? jones::Axis::x : from.y != to.y ? jones::Axis::y : jones::Axis::z;
    const auto inside = jones::seg3({from, to}, axis, window_.bound_factor);
    if (!inside) return std::nullopt;
    return std::array{project(inside->p), project(inside->q)};
  }

  static double area(const Polygon& polygon) {
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PixelPoint& p = polygon[i].place;
      const PixelPoint& q = polygon[(i + 1) % polygon.size()].place;
      doubled += p.x * q.y - p.y * q.x;
    }
    return doubled / 2;
  }

  // The point where a line from p to q is cut, and the bounds of its error.
  struct Cut {
    PixelPoint place;
    double of_line = 0;  // distance from the line that is cut
    double of_clip = 0;  // distance from the exact clip line
    double along = 0;    // along the line that is cut
  };
  [[nodiscard]] Cut cut_at(const ClipLine& clip, const Side& side, const PixelPoint& p, const PixelPoint& q) const {
    const double dp = clip.distance(p);
    const double share = dp / (dp - clip.distance(q));
    Cut cut;
    cut.place = {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
    const bool box = clip.length == 0;
    // A coordinate that both ends share is kept; one of a side of the box is its value.
    const bool x = side.along.x != 0 && (!box || clip.side.along.y == 0);
    const bool y = side.along.y != 0 && (!box || clip.side.along.x == 0);
    const double lost = box ? 0 : share_ * length_of(p, q);
    const double before = side.away_at(share);
    const double clip_away = clip.away(cut.place);
    cut.of_line = before + side.across(x, y);
    cut.of_clip = clip_away + clip.side.across(x, y) + lost * sine_of(side, clip.side);
    const double rounded_along = half * ((x ? std::abs(side.along.x) : 0) + (y ? std::abs(side.along.y) : 0));
    cut.along = (clip_away + before * cosine_of(side, clip.side)) / sine_of(side, clip.side) + rounded_along + lost;
    return cut;
  }

  void cut(Polygon& polygon, const ClipLine& clip) const {
    Polygon left;
    std::optional<std::size_t> closing;  // the side on the clip line, which begins where the polygon leaves
    double entered = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ClipCorner& p = polygon[i];
      const ClipCorner& q = polygon[(i + 1) % polygon.size()];
      const bool holds_p = clip.holds(p.place);
      if (holds_p) left.push_back(p);
      if (holds_p == clip.holds(q.place)) continue;
      const Cut at = cut_at(clip, p.next, p.place, q.place);
      if (holds_p) {
        left.back().next.away[1] = at.of_line;
        closing = left.size();
        left.push_back({at.place, clip.side});
        left.back().next.away = {at.of_clip, at.of_clip};
      } else {
        left.push_back({at.place, p.next});
        left.back().next.away[0] = at.of_line;
        entered = at.of_clip;
      }
    }
    // A point on a side of the box stays there.
    if (closing && clip.length > 0) left[*closing].next.away[1] = entered;
    if (closing && clip.length == 0) left[*closing].next.away = clip.side.away;
    polygon = std::move(left);
  }

  // Where a mask ends at the window its side has no line. A sloped side that meets the window there is no window's side.
  [[nodiscard]] bool is_on_window(const PixelPoint& p) const {
    const auto at = [](double a, std::int32_t side) { return std::abs(a - side) <= on_line; };
    return at(p.x, window_.xlo) || at(p.x, window_.xhi) || at(p.y, window_.ylo) || at(p.y, window_.yhi);
  }

  void draw(const jones::SpacePoint& from, const jones::SpacePoint& to, const std::vector<ClipLine>& clip) {
    const auto left = direction_ ? turned_ends(from, to) : level_ends(from, to);
    if (!left) return;
    std::array<PixelPoint, 2> ends = *left;
    if (length_of(ends[0], ends[1]) <= on_line) return;
    Side side = projected(ends[0], ends[1]);
    std::array<double, 2> end_away;
    end_away.fill(direction_ ? turned * std::numbers::sqrt2 : corner);
    for (const ClipLine& line : clip) {
      const std::array<bool, 2> holds{line.holds(ends[0]), line.holds(ends[1])};
      if (!holds[0] && !holds[1]) return;
      if (holds[0] == holds[1]) continue;
      const std::size_t end = holds[0] ? 1 : 0;
      const Cut at = cut_at(line, side, ends[0], ends[1]);
      const double drawn_there = line.side.of_window || is_on_window(at.place) ? std::numeric_limits<double>::infinity() : at.of_clip + at.of_line + corner;
      ends[end] = at.place;
      side.away[end] = at.of_line;
      end_away[end] = std::min(std::hypot(at.of_line, at.along), drawn_there);
    }
    for (const std::size_t end : {0U, 1U}) greatest_ = std::max({greatest_, side.away[end], end_away[end]});
  }

  const scene::CellScene& scene_;
  geometry::Point eye_;
  std::optional<jones::Direction> direction_;
  jones::Window window_;
  double share_;
  double greatest_ = 0;
};

}  // namespace

double jones_piece_bound(const scene::CellScene& scene, const geometry::Point& eye, const JonesWords& words, const std::optional<programs::jones::Direction>& direction) {
  return std::ldexp(Bound(scene, eye, words, direction).units(), -words.fraction_bits);
}

double jones_line_bound(double piece_bound, const JonesWords& words) {
  return words.fraction_bits == 0 ? piece_bound : piece_bound + corner;
}

double jones_flash_bound(double line_bound) {
  return line_bound + corner + programs::turn::flash_bound();
}

}  // namespace sightline::compare
