// See wrong_stretches.hpp.
#include "host/compare/wrong_stretches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace sightline::compare {
namespace {

namespace oracle = algorithms::oracle;
using oracle::ScreenSegment;

constexpr double rounding_allowed = 1e-6;  // points: pieces this near to each other touch

// The plane through the eye and a line, in lowest terms: lines with one plane coincide in the image.
using SightPlane = std::array<std::int64_t, 3>;

std::optional<SightPlane> plane_of(const AxisLine& line, const geometry::Point& eye) {
  const auto [u, v] = geometry::other_axes(line.axis);
  const std::int64_t at_u = std::int64_t{line.cross[0]} - eye[u];
  const std::int64_t at_v = std::int64_t{line.cross[1]} - eye[v];
  std::int64_t common = std::gcd(at_u, at_v);
  if (common == 0) return std::nullopt;
  if (at_u < 0 || (at_u == 0 && at_v > 0)) common = -common;
  SightPlane plane{};
  plane[u] = -at_v / common;
  plane[v] = at_u / common;
  // The sign of the first nonzero number does not depend on the axis of the line.
  if (plane < SightPlane{})
    for (std::int64_t& n : plane) n = -n;
  return plane;
}

// The image of all lines in one plane.
class ImageLine {
 public:
  ImageLine(const SightPlane& plane, const oracle::Window& window) {
    const auto a = static_cast<double>(plane[0]), b = static_cast<double>(plane[1]);
    const double c = static_cast<double>(plane[2]) * window.scale;
    const double size = std::hypot(a, b);
    dx_ = b / size;
    dy_ = -a / size;
    x_ = window.centre[0] - a * c / (size * size);
    y_ = window.centre[1] - b * c / (size * size);
  }
  [[nodiscard]] double along(double x, double y) const { return (x - x_) * dx_ + (y - y_) * dy_; }
  [[nodiscard]] ScreenSegment segment(double from, double to) const {
    return {x_ + from * dx_, y_ + from * dy_, x_ + to * dx_, y_ + to * dy_};
  }

 private:
  double x_ = 0, y_ = 0, dx_ = 1, dy_ = 0;
};

struct Part {
  double low = 0;
  double high = 0;
};

// The part of s, from 0 to 1, within the distance of t; empty if low > high.
Part part_near(const ScreenSegment& s, const ScreenSegment& t, double distance) {
  Part part{2, -1};
  const double sx = s.x1 - s.x0, sy = s.y1 - s.y0;
  const double square = sx * sx + sy * sy;
  const auto add = [&part](double low, double high) {
    part.low = std::min(part.low, std::max(low, 0.0));
    part.high = std::max(part.high, std::min(high, 1.0));
  };
  // The discs around the ends of t.
  for (const auto& [x, y] : {std::pair{t.x0, t.y0}, std::pair{t.x1, t.y1}}) {
    const double px = s.x0 - x, py = s.y0 - y;
    const double half = px * sx + py * sy;
    const double rest = half * half - square * (px * px + py * py - distance * distance);
    if (rest < 0) continue;
    const double root = std::sqrt(rest);
    if ((-half + root) >= 0 && (-half - root) <= square)
      add((-half - root) / square, (-half + root) / square);
  }
  // The rectangle along t: two strips.
  const double tx = t.x1 - t.x0, ty = t.y1 - t.y0;
  const double length = std::hypot(tx, ty);
  if (length == 0) return part;
  double low = 0, high = 1;
  const auto keep = [&low, &high](double from, double step, double least, double most) {
    if (step == 0) {
      if (from < least || from > most) high = -1;
      return;
    }
    const double a = (least - from) / step, b = (most - from) / step;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  };
  keep(((s.x0 - t.x0) * tx + (s.y0 - t.y0) * ty) / length, (sx * tx + sy * ty) / length, 0, length);
  keep(((s.x0 - t.x0) * -ty + (s.y0 - t.y0) * tx) / length, (sx * -ty + sy * tx) / length, -distance,
       distance);
  if (low <= high) add(low, high);
  return part;
}

// The parts of s farther than the distance from all others.
std::vector<Part> parts_alone(const ScreenSegment& s, const std::vector<ImagePiece>& others,
                              double distance) {
  const double length = std::hypot(s.x1 - s.x0, s.y1 - s.y0);
  if (length == 0) return {};
  std::vector<Part> near;
  for (const ImagePiece& other : others) {
    if (std::max(other.at.x0, other.at.x1) + distance < std::min(s.x0, s.x1) ||
        std::min(other.at.x0, other.at.x1) - distance > std::max(s.x0, s.x1) ||
        std::max(other.at.y0, other.at.y1) + distance < std::min(s.y0, s.y1) ||
        std::min(other.at.y0, other.at.y1) - distance > std::max(s.y0, s.y1))
      continue;
    const Part part = part_near(s, other.at, distance);
    if (part.low <= part.high) near.push_back(part);
  }
  std::sort(near.begin(), near.end(), [](const Part& a, const Part& b) { return a.low < b.low; });
  std::vector<Part> alone;
  double reached = 0;
  const auto gap = [&](double to) {
    if ((to - reached) * length > rounding_allowed) alone.push_back({reached, to});
  };
  for (const Part& part : near) {
    gap(part.low);
    reached = std::max(reached, part.high);
  }
  gap(1);
  return alone;
}

// Stretches on one image line.
struct OnLine {
  double low = 0;
  double high = 0;
  AxisLine line;
};
using ByPlane = std::map<SightPlane, std::vector<OnLine>>;

// Joins stretches that overlap or touch.
void unite(std::vector<OnLine>& stretches) {
  std::sort(stretches.begin(), stretches.end(), [](const OnLine& a, const OnLine& b) {
    return std::tie(a.low, a.high, a.line.axis, a.line.cross) <
           std::tie(b.low, b.high, b.line.axis, b.line.cross);
  });
  std::vector<OnLine> united;
  for (const OnLine& stretch : stretches) {
    if (united.empty() || stretch.low > united.back().high + rounding_allowed)
      united.push_back(stretch);
    else
      united.back().high = std::max(united.back().high, stretch.high);
  }
  stretches = std::move(united);
}

// `parts` gives the parts of a piece that count.
template <class Parts>
ByPlane by_plane(const std::vector<ImagePiece>& pieces, const geometry::Point& eye,
                 const oracle::Window& window, const Parts& parts) {
  ByPlane planes;
  for (const ImagePiece& piece : pieces) {
    const auto plane = plane_of(piece.line, eye);
    if (!plane) continue;
    const ImageLine image(*plane, window);
    const ScreenSegment& at = piece.at;
    for (const Part& part : parts(at)) {
      const auto place = [&](double t) {
        return image.along(at.x0 + t * (at.x1 - at.x0), at.y0 + t * (at.y1 - at.y0));
      };
      const auto [low, high] = std::minmax({place(part.low), place(part.high)});
      planes[*plane].push_back({low, high, piece.line});
    }
  }
  for (auto& [plane, stretches] : planes) unite(stretches);
  return planes;
}

void add_wrong(const std::vector<ImagePiece>& pieces, const std::vector<ImagePiece>& others, bool extra,
               double distance, const geometry::Point& eye, const oracle::Window& window,
               WrongStretches& wrong) {
  const ByPlane planes = by_plane(pieces, eye, window,
                                  [&](const ScreenSegment& at) { return parts_alone(at, others, distance); });
  for (const auto& [plane, stretches] : planes) {
    const ImageLine image(plane, window);
    for (const OnLine& stretch : stretches) {
      const double length = stretch.high - stretch.low;
      if (length < least_wrong_stretch) continue;
      (extra ? wrong.extra : wrong.missing) += length;
      wrong.stretches.push_back({stretch.line, extra, length, image.segment(stretch.low, stretch.high)});
    }
  }
}

}  // namespace

std::vector<ImagePiece> image_pieces(const std::vector<oracle::VisibleLine>& visible,
                                     const geometry::Point& eye, const oracle::Window& window) {
  std::vector<ImagePiece> pieces;
  for (const oracle::VisibleLine& seen : visible) {
    const std::size_t axis = seen.p[0] != seen.q[0] ? 0 : seen.p[1] != seen.q[1] ? 1 : 2;
    const auto [u, v] = geometry::other_axes(axis);
    for (const ScreenSegment& at : oracle::on_screen({seen}, eye, window))
      pieces.push_back({{axis, {seen.p[u], seen.p[v]}}, at});
  }
  return pieces;
}

WrongStretches wrong_stretches(const std::vector<ImagePiece>& truth, const std::vector<ImagePiece>& drawn,
                               double distance, const geometry::Point& eye, const oracle::Window& window) {
  WrongStretches wrong;
  for (const auto& [plane, stretches] : by_plane(truth, eye, window, [](const ScreenSegment&) {
         return std::vector<Part>{{0, 1}};
       }))
    for (const OnLine& stretch : stretches) wrong.true_length += stretch.high - stretch.low;
  add_wrong(truth, drawn, false, distance, eye, window, wrong);
  add_wrong(drawn, truth, true, distance, eye, window, wrong);
  return wrong;
}

}  // namespace sightline::compare
