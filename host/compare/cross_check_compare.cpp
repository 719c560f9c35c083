// See cross_check_compare.hpp.
#include "host/compare/cross_check_compare.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "host/picture/line_picture_image.hpp"

namespace sightline::compare {

namespace {

using picture::LinePicture;
using picture::LinePiece;
using picture::PixelGrid;
using picture::PixelPoint;
using picture::PixelSegment;

std::string span_of(const LinePiece& piece) {
  const auto fraction = [](const geometry::Rational& s) {
    return s.denominator() == 1 ? fmt::format("{}", s.numerator())
                                : fmt::format("{}/{}", s.numerator(), s.denominator());
  };
  return fraction(piece.low) + " to " + fraction(piece.high);
}

std::string first_difference(const NamedLines& a, const NamedLines& b) {
  const auto& p = a.lines->pieces;
  const auto& q = b.lines->pieces;
  const auto [i, j] = std::mismatch(p.begin(), p.end(), q.begin(), q.end());
  const bool only_b = i == p.end() || (j != q.end() && j->edge < i->edge);
  const picture::LineEdge edge = only_b ? j->edge : i->edge;
  const auto piece_text = [&edge](auto piece, auto end) {
    return piece != end && piece->edge == edge ? "s = " + span_of(*piece) : std::string("nothing more");
  };
  return fmt::format("edge {}-{}: {} draws {}, {} {}", edge.from, edge.to, a.name, piece_text(i, p.end()), b.name,
                     piece_text(j, q.end()));
}

// The first piece of a whose image is not completely in the other's.
std::optional<std::string> first_outside(const NamedLines& a, const picture::ImageSet& other,
                                         std::string_view other_name, const scene::PolyScene& scene,
                                         const scene::PolyCamera& camera) {
  for (const LinePiece& piece : a.lines->pieces) {
    for (const picture::ImageSegment& part :
         picture::image_set(LinePicture{{piece}}, scene, camera).segments) {
      const bool covered =
          std::any_of(other.segments.begin(), other.segments.end(), [&](const picture::ImageSegment& whole) {
            return whole.line == part.line && picture::compare(whole.low, part.low) <= 0 &&
                   picture::compare(whole.high, part.high) >= 0;
          });
      if (!covered)
        return fmt::format("edge {}-{}: {} draws s = {}, {} not all of it", piece.edge.from, piece.edge.to,
                           a.name, span_of(piece), other_name);
    }
  }
  return std::nullopt;
}

// Edges in pixels, hidden or not.
std::vector<PixelSegment> projected_edges(const CommonScene& scene, const CrossCheckView& view) {
  std::vector<PixelSegment> segments;
  for (const picture::LineEdge& edge : picture::edges_of(scene.scene)) {
    const auto segment = view.place(scene.scene.vertices[edge.from], scene.scene.vertices[edge.to]);
    if (segment) segments.push_back(*segment);
  }
  return segments;
}

std::string face_name(const CommonScene& scene, std::uint32_t value) {
  if (value == 0) return "nothing";
  std::uint32_t face = value - 1;
  for (const scene::PolyBody& body : scene.scene.bodies) {
    if (face < body.faces.size()) return fmt::format("face {} of {}", face, body.name);
    face -= static_cast<std::uint32_t>(body.faces.size());
  }
  return "no face of the scene";
}

std::string pixel_difference(const CommonScene& scene, const NamedFaces& a, const NamedFaces& b,
                             std::size_t index) {
  const auto width = static_cast<std::size_t>(a.faces->width);
  return fmt::format("pixel ({}, {}): {} shows {}, {} {}", index % width, index / width, a.name,
                     face_name(scene, a.faces->values[index]), b.name,
                     face_name(scene, b.faces->values[index]));
}

// Whether this is a boundary pixel as defined in pixel_metrics.hpp.
bool at_edge(const std::vector<PixelSegment>& edges, const PixelGrid& grid, std::size_t index) {
  const auto width = static_cast<std::size_t>(grid.width);
  const PixelPoint p{static_cast<double>(index % width), static_cast<double>(index / width)};
  return std::any_of(edges.begin(), edges.end(), [&p](const PixelSegment& s) {
    const double dx = s.b.x - s.a.x;
    const double dy = s.b.y - s.a.y;
    const double along = (p.x - s.a.x) * dx + (p.y - s.a.y) * dy;
    const double t = std::clamp(along / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(s.a.x + t * dx - p.x, s.a.y + t * dy - p.y) <= 0.75;
  });
}

// Points along the lines of a view, indexed by place.
class DrawnPoints {
 public:
  struct Point {
    PixelPoint place;
    std::uint32_t piece = 0;
  };

  // Lines are accurate to within `error` pixels.
  DrawnPoints(int size, const std::vector<PixelSegment>& lines, double error = 0)
      : size_(size), reach_(1 + error), buckets_(static_cast<std::size_t>(size_ * size_)) {
    std::uint32_t number = 0;
    for (const PixelSegment& line : lines) add(line, number++);
  }

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  // The greatest distance, in pixels, of a line from a change of face.
  [[nodiscard]] double reach() const { return reach_; }
  template <class Test>
  [[nodiscard]] bool any_near(const PixelPoint& p, double distance, Test&& test) const {
    const int reach = static_cast<int>(std::ceil(distance)) + 1;
    const int column = static_cast<int>(std::floor(p.x));
    const int row = static_cast<int>(std::floor(p.y));
    for (int r = std::max(0, row - reach); r <= std::min(size_ - 1, row + reach); ++r)
      for (int c = std::max(0, column - reach); c <= std::min(size_ - 1, column + reach); ++c)
        for (const std::uint32_t i : buckets_[static_cast<std::size_t>(r * size_ + c)])
          if (std::hypot(points_[i].place.x - p.x, points_[i].place.y - p.y) <= distance && test(points_[i]))
            return true;
    return false;
  }
  // Whether a point is away from the border, with no other line within twice the reach.
  [[nodiscard]] bool is_isolated(const Point& point) const {
    const double border = 2 * reach_;
    const auto& [x, y] = point.place;
    if (x < border || y < border || x > size_ - 1 - border || y > size_ - 1 - border) return false;
    return !any_near(point.place, border, [&](const Point& other) { return other.piece != point.piece; });
  }

 private:
  static constexpr double spacing = 0.25;

  void add(const PixelSegment& s, std::uint32_t piece) {
    const double length = std::hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    const int steps = static_cast<int>(std::ceil(length / spacing)) + 1;
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const PixelPoint p{s.a.x + t * (s.b.x - s.a.x), s.a.y + t * (s.b.y - s.a.y)};
      if (p.x < 0 || p.y < 0 || p.x >= size_ || p.y >= size_) continue;
      const auto bucket = static_cast<std::size_t>(static_cast<int>(p.y) * size_ + static_cast<int>(p.x));
      buckets_[bucket].push_back(static_cast<std::uint32_t>(points_.size()));
      points_.push_back({p, piece});
    }
  }

  int size_;
  double reach_;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::vector<Point> points_;
};

// The distance of a point from the segment between the centres of two adjacent pixels.
double from_step(const PixelPoint& p, int column, int row, bool upwards) {
  const double along = upwards ? p.y - row : p.x - column;
  const double aside = upwards ? p.x - column : p.y - row;
  return std::hypot(along - std::clamp(along, 0.0, 1.0), aside);
}

bool changes_near(const PixelGrid& faces, const PixelPoint& p, double distance) {
  const int column = static_cast<int>(std::floor(p.x));
  const int row = static_cast<int>(std::floor(p.y));
  const int reach = static_cast<int>(std::ceil(distance)) + 1;
  for (int r = std::max(0, row - reach); r <= std::min(faces.height - 2, row + reach); ++r)
    for (int c = std::max(0, column - reach); c <= std::min(faces.width - 2, column + reach); ++c)
      for (const bool upwards : {false, true})
        if (faces.at(c, r) != faces.at(c + (upwards ? 0 : 1), r + (upwards ? 1 : 0)) &&
            from_step(p, c, r, upwards) <= distance)
          return true;
  return false;
}

// Counts checks and failures, and stores the first failure.
struct Failures {
  std::uint64_t all = 0;
  std::uint64_t failed = 0;
  PixelPoint first;

  void count(bool holds, const PixelPoint& place) {
    ++all;
    if (!holds && failed++ == 0) first = place;
  }
};

Failures lines_without_change(const DrawnPoints& points, const PixelGrid& faces) {
  Failures failures;
  for (const DrawnPoints::Point& point : points.points())
    if (points.is_isolated(point)) failures.count(changes_near(faces, point.place, points.reach()), point.place);
  return failures;
}

Failures changes_without_line(const DrawnPoints& points, const PixelGrid& faces) {
  Failures failures;
  for (int row = 0; row + 1 < faces.height; ++row) {
    for (int column = 0; column + 1 < faces.width; ++column) {
      for (const bool upwards : {false, true}) {
        if (faces.at(column, row) == faces.at(column + (upwards ? 0 : 1), row + (upwards ? 1 : 0))) continue;
        const PixelPoint middle{column + (upwards ? 0 : 0.5), row + (upwards ? 0.5 : 0)};
        failures.count(points.any_near(middle, points.reach(), [](const DrawnPoints::Point&) { return true; }), middle);
      }
    }
  }
  return failures;
}

ViewVerdict lines_on_pixels(std::string_view name, const DrawnPoints& points, const NamedFaces& b) {
  constexpr std::string_view how = "lines on pixels";
  const Failures lines = lines_without_change(points, *b.faces);
  const Failures changes = changes_without_line(points, *b.faces);
  if (lines.all == 0 || changes.all == 0) return {false, how, "there is nothing to compare"};
  std::string text = fmt::format("{} of {} changes of face have no line, {} of {} isolated points have no change",
                                 changes.failed, changes.all, lines.failed, lines.all);
  if (changes.failed > 0)
    text += fmt::format("; {} changes at pixel ({}, {}), where {} draws nothing", b.name, changes.first.x,
                        changes.first.y, name);
  if (lines.failed > 0)
    text += fmt::format("; {} draws at pixel ({:.1f}, {:.1f}), where {} does not change", name,
                        lines.first.x, lines.first.y, b.name);
  return {lines.failed == 0 && changes.failed == 0, how, std::move(text)};
}

}  // namespace

ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view, const NamedLines& a,
                             const NamedLines& b) {
  if (*a.lines == *b.lines) return {true, "pieces", fmt::format("{} pieces equal", a.lines->pieces.size())};
  if (!a.same_by_image && !b.same_by_image) return {false, "pieces", first_difference(a, b)};
  const auto image_a = image_set(*a.lines, scene.scene, view.camera);
  const auto image_b = image_set(*b.lines, scene.scene, view.camera);
  if (image_a == image_b)
    return {true, "image", fmt::format("{} lines of the image equal", image_a.segments.size())};
  auto text = first_outside(a, image_b, b.name, scene.scene, view.camera);
  if (!text) text = first_outside(b, image_a, a.name, scene.scene, view.camera);
  return {false, "image", text.value_or("the same pieces make different images")};
}

ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view, const NamedFaces& a,
                             const NamedFaces& b) {
  for (const NamedFaces& picture : {a, b})
    if (picture.faces->width != view.size || picture.faces->height != view.size)
      return {false, "pixels", fmt::format("{} has no picture of this size", picture.name)};
  const auto edges = projected_edges(scene, view);
  const auto metrics = picture::pixel_metrics(*a.faces, *b.faces, edges);
  std::string text = fmt::format("{} of {} pixels inside faces differ, {} of {} at edges",
                                 metrics.different_inside, metrics.pixels - metrics.boundary_pixels,
                                 metrics.different_on_boundary, metrics.boundary_pixels);
  if (metrics.lit == 0) return {false, "pixels", fmt::format("{} shows no face", a.name)};
  if (metrics.different_inside == 0) return {true, "pixels", std::move(text)};
  for (std::size_t i = 0; i < a.faces->values.size(); ++i)
    if (a.faces->values[i] != b.faces->values[i] && !at_edge(edges, *a.faces, i))
      return {false, "pixels", text + "; " + pixel_difference(scene, a, b, i)};
  return {false, "pixels", std::move(text)};
}

ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view, const NamedLines& a,
                             const NamedFaces& b) {
  if (b.faces->width != view.size || b.faces->height != view.size)
    return {false, "lines on pixels", fmt::format("{} has no picture of this size", b.name)};
  std::vector<PixelSegment> lines;
  for (const LinePiece& piece : a.lines->pieces) {
    const auto segment = view.place(scene.scene.vertices[piece.edge.from], scene.scene.vertices[piece.edge.to],
                                    {piece.low.to_double(), piece.high.to_double()});
    if (segment) lines.push_back(*segment);
  }
  return lines_on_pixels(a.name, DrawnPoints(view.size, lines), b);
}

ViewVerdict compare_pictures(const NamedScreen& a, const NamedFaces& b) {
  if (b.faces->width != b.faces->height)
    return {false, "lines on pixels", fmt::format("{} has no square picture", b.name)};
  return lines_on_pixels(a.name, DrawnPoints(b.faces->width, a.screen->in_view, a.screen->bound_in_view), b);
}

ViewVerdict compare_pictures(const NamedScreen& a, const NamedScreenLines& b) {
  constexpr std::string_view how = "points";
  const TurnPicture& turn = a.screen->turn;
  const picture::HausdorffDistance distance = picture::hausdorff_distance(turn.lines, *b.on_screen);
  std::string text = fmt::format("{} pieces, lines within {:.2f} points of the display, explained {:.2f}", turn.pieces.size(),
                                 distance.greatest, turn.bound);
  if (!b.named.same_by_image)
    if (const std::string difference = structure_difference(turn, *b.named.lines); !difference.empty())
      return {false, how, text + "; " + difference};
  return {distance.greatest <= turn.bound, how, std::move(text)};
}

}  // namespace sightline::compare
