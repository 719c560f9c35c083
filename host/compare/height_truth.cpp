// See height_truth.hpp.
#include "host/compare/height_truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "host/programs/skala/contours.hpp"
#include "host/programs/skala/projection.hpp"
#include "host/picture/line_metrics_parts.hpp"

namespace sightline::compare {

namespace {

using picture::DrawnPiece;
using picture::LineId;
using picture::LinePart;
using picture::PixelPoint;
using picture::PixelSegment;

constexpr LineId on_no_line = std::numeric_limits<LineId>::max();
constexpr std::uint32_t first_contour_layer = 4;  // of a native drawing: host/algorithms/skala/draw.hpp
constexpr std::size_t columns = 257;              // one more for a crossing that rounding puts beyond the last
// Smaller differences are in the last bits of a projection, in screen units and in depth.
constexpr double rounding = 1e-9;

std::size_t column_of(double x) {
  return static_cast<std::size_t>(std::clamp(x + 0.5, 0.0, static_cast<double>(columns - 1)));
}

struct ColumnRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

ColumnRange columns_of(double x0, double x1) {
  return {column_of(std::min(x0, x1)), column_of(std::max(x0, x1))};
}

// The part of a line where two linear quantities, the second a depth, are both positive.
LinePart both_positive(const LinePart& part, const std::array<double, 2>& f,
                       const std::array<double, 2>& depth) {
  double low = 0;
  double high = 1;
  const auto keep = [&](double from, double to) {
    if (from <= 0 && to <= 0) {
      high = -1;
    } else if (from < 0) {
      low = std::max(low, from / (from - to));
    } else if (to < 0) {
      high = std::min(high, from / (from - to));
    }
  };
  keep(f[0], f[1]);
  keep(depth[0] - rounding, depth[1] - rounding);
  const double length = part.high - part.low;
  return {part.low + low * length, part.low + high * length};
}

bool runs_along_x(algorithms::skala::Family family, const programs::skala::SineCosine& turn) {
  if (family == algorithms::skala::Family::automatic) return std::abs(turn.cosine) >= std::abs(turn.sine);
  return family != algorithms::skala::Family::along_z;
}

using picture::PixelGrid;
using picture::PixelPoint;

struct Corner {
  PixelPoint point;
  double depth = 0;
};
using Triangle = std::array<Corner, 3>;

double doubled_area(const PixelPoint& a, const PixelPoint& b, const PixelPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Visits every point of the screen in a triangle, its sides included, with the depth there.
template <class Visit>
void for_points(const Triangle& triangle, const Visit& visit) {
  const auto& [a, b, c] = triangle;
  const double area = doubled_area(a.point, b.point, c.point);
  if (area == 0) return;
  const auto [low_x, high_x] = std::minmax({a.point.x, b.point.x, c.point.x});
  const auto [low_y, high_y] = std::minmax({a.point.y, b.point.y, c.point.y});
  const auto first = [](double low) { return std::max(0, static_cast<int>(std::ceil(low))); };
  const auto last = [](double high) {
    return std::min(programs::skala::raster_side - 1, static_cast<int>(std::floor(high)));
  };
  for (int y = first(low_y); y <= last(high_y); ++y) {
    for (int x = first(low_x); x <= last(high_x); ++x) {
      const PixelPoint p{static_cast<double>(x), static_cast<double>(y)};
      const double to_a = doubled_area(b.point, c.point, p) / area;
      const double to_b = doubled_area(c.point, a.point, p) / area;
      const double to_c = 1 - to_a - to_b;
      if (to_a < 0 || to_b < 0 || to_c < 0) continue;
      visit(x, y, to_a * a.depth + to_b * b.depth + to_c * c.depth);
    }
  }
}

// The two triangles of the cell with this least corner.
std::array<Triangle, 2> halves_of(const programs::skala::Projection& projection, bool rising, std::size_t point,
                                  std::size_t slice) {
  const auto at = [&](std::size_t p, std::size_t s) {
    const programs::skala::Vertex& vertex = projection.at(p, s);
    return Corner{{vertex.x, vertex.y}, vertex.depth};
  };
  const std::size_t low = rising ? point : point + 1;
  const std::size_t high = rising ? point + 1 : point;
  const Corner one = at(low, slice);
  const Corner other = at(high, slice + 1);
  return {Triangle{one, other, at(high, slice)}, Triangle{one, other, at(low, slice + 1)}};
}

// Numbers of cells by the centres of their outlines and of their halves.
class CellsByMiddle {
 public:
  CellsByMiddle(const programs::skala::Projection& projection, bool rising) {
    std::uint32_t number = 0;
    for (std::size_t slice = 0; slice + 1 < projection.slices(); ++slice) {
      for (std::size_t point = 0; point + 1 < projection.points(); ++point) {
        ++number;
        const auto halves = halves_of(projection, rising, point, slice);
        for (const Triangle& half : halves)
          add((half[0].point.x + half[1].point.x + half[2].point.x) / 3,
              (half[0].point.y + half[1].point.y + half[2].point.y) / 3, number);
        add((halves[0][0].point.x + halves[0][1].point.x + halves[0][2].point.x + halves[1][2].point.x) / 4,
            (halves[0][0].point.y + halves[0][1].point.y + halves[0][2].point.y + halves[1][2].point.y) / 4,
            number);
      }
    }
    none_ = number + 1;
    std::sort(middles_.begin(), middles_.end(), [](const Middle& a, const Middle& b) {
      return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.number < b.number;
    });
  }

  [[nodiscard]] std::uint32_t number_at(double x, double y) const {
    auto middle = std::lower_bound(middles_.begin(), middles_.end(), x - same_place,
                                   [](const Middle& m, double low) { return m.x < low; });
    std::uint32_t best = none_;
    double nearest = same_place;
    for (; middle != middles_.end() && middle->x <= x + same_place; ++middle) {
      const double away = std::hypot(middle->x - x, middle->y - y);
      if (away >= nearest) continue;
      nearest = away;
      best = middle->number;
    }
    return best;
  }

 private:
  struct Middle {
    double x = 0;
    double y = 0;
    std::uint32_t number = 0;
  };
  void add(double x, double y, std::uint32_t number) { middles_.push_back({x, y, number}); }

  std::vector<Middle> middles_;
  std::uint32_t none_ = 0;
};

}  // namespace

bool rising_diagonals(const programs::skala::SineCosine& turn) {
  const bool greater_x_nearer = turn.sine > 0 || (turn.sine == 0 && turn.cosine < 0);
  const bool greater_z_nearer = turn.cosine < 0 || (turn.cosine == 0 && turn.sine < 0);
  return greater_x_nearer != greater_z_nearer;
}

HeightLines::HeightLines(const scene::HeightGrid& grid, const algorithms::skala::View& view, double grazing)
    : grazing_(std::max(grazing, rounding)), hiding_in_(columns), lines_in_(columns) {
  const programs::skala::Projection projection(grid, view);
  std::vector<LevelEdge> inked = add_sides(projection, view);
  if (view.subject == algorithms::skala::Subject::contours) {
    const auto contours =
        add_halves(grid, projection, programs::skala::contour_levels(grid.range, view.levels));
    inked.insert(inked.end(), contours.begin(), contours.end());
  }
  for (std::uint32_t i = 0; i < hiding_.size(); ++i) {
    const auto [first, last] = columns_of(hiding_[i].a.point.x, hiding_[i].b.point.x);
    for (std::size_t column = first; column <= last; ++column) hiding_in_[column].push_back(i);
  }
  for (const LevelEdge& line : inked) add_line(line);
}

HeightLines::Ends HeightLines::ends_of(const programs::skala::Vertex& vertex) {
  return {{vertex.x, vertex.y}, vertex.depth};
}

std::vector<HeightLines::LevelEdge> HeightLines::add_sides(const programs::skala::Projection& projection,
                                                           const algorithms::skala::View& view) {
  const bool contours = view.subject == algorithms::skala::Subject::contours;
  const bool both = contours || view.family == algorithms::skala::Family::both;
  const bool along_x = runs_along_x(view.family, projection.rotation());
  const std::size_t last_point = projection.points() - 1;
  const std::size_t last_slice = projection.slices() - 1;
  std::vector<LevelEdge> inked;
  const auto add = [&](const Side& side, bool slice, bool rim) {
    const Edge edge{ends_of(projection.at(side[0].point, side[0].slice)), ends_of(projection.at(side[1].point, side[1].slice))};
    if (slice || rim) hiding_.push_back(edge);
    if (rim || (slice && !contours)) inked.push_back({edge, 0, side});
  };
  for (std::size_t slice = 0; slice <= last_slice; ++slice) {
    for (std::size_t point = 0; point <= last_point; ++point) {
      const programs::skala::GridIndex here{point, slice};
      if (point < last_point) add({here, {point + 1, slice}}, both || along_x, slice % last_slice == 0);
      if (slice < last_slice) add({here, {point, slice + 1}}, both || !along_x, point % last_point == 0);
    }
  }
  return inked;
}

std::vector<HeightLines::LevelEdge> HeightLines::add_halves(const scene::HeightGrid& grid,
                                                            const programs::skala::Projection& projection,
                                                            const std::vector<double>& levels) {
  const bool rising = rising_diagonals(projection.rotation());
  std::vector<LevelEdge> inked;
  for (std::size_t slice = 0; slice + 1 < projection.slices(); ++slice) {
    for (std::size_t point = 0; point + 1 < projection.points(); ++point) {
      const programs::skala::GridIndex one{rising ? point : point + 1, slice};
      const programs::skala::GridIndex other{rising ? point + 1 : point, slice + 1};
      hiding_.push_back(
          {ends_of(projection.at(one.point, one.slice)), ends_of(projection.at(other.point, other.slice))});
      for (const programs::skala::GridIndex apex : {programs::skala::GridIndex{other.point, one.slice},
                                                  programs::skala::GridIndex{one.point, other.slice}}) {
        for (std::uint32_t k = 0; k < levels.size(); ++k) {
          const auto crossing =
              programs::skala::contour_crossing(grid, projection, {apex, one, other}, levels[k]);
          if (!crossing.crossed) continue;
          inked.push_back({{ends_of(crossing.piece.from), ends_of(crossing.piece.to)}, k + 1});
        }
      }
    }
  }
  return inked;
}

void HeightLines::add_line(const LevelEdge& inked) {
  const auto& [edge, level, side] = inked;
  if (std::hypot(edge.b.point.x - edge.a.point.x, edge.b.point.y - edge.a.point.y) < same_place / 2) return;
  const auto number = static_cast<std::uint32_t>(lines_.size());
  lines_.push_back({number, {edge.a.point, edge.b.point}, {{0, 1}}, seen_of(edge)});
  levels_.push_back(level);
  sides_.push_back(side);
  const auto [first, last] = columns_of(edge.a.point.x, edge.b.point.x);
  for (std::size_t column = first; column <= last; ++column) lines_in_[column].push_back(number);
}

// Accumulates the parts of a line that are below and above nearer lines.
class HeightLines::Hidden {
 public:
  Hidden(const Edge& line, double grazing)
      : line_(line),
        grazing_(grazing),
        extent_(line.b.point.x - line.a.point.x),
        upright_(std::abs(extent_) < rounding) {}

  void hide_behind(const Edge& edge) {
    const double width = edge.b.point.x - edge.a.point.x;
    const double x = line_.a.point.x;
    if (upright_ && std::abs(width) < rounding) {
      if (std::abs(edge.a.point.x - x) > rounding) return;
      hide_behind({0, 1}, edge.a, edge.a);
      hide_behind({0, 1}, edge.b, edge.b);
    } else if (upright_) {
      const double place = (x - edge.a.point.x) / width;
      if (place >= 0 && place <= 1) hide_behind({0, 1}, on(edge, place), on(edge, place));
    } else if (std::abs(width) >= rounding) {
      const double from = (edge.a.point.x - x) / extent_;
      const double to = (edge.b.point.x - x) / extent_;
      const LinePart part{std::max(0.0, std::min(from, to)), std::min(1.0, std::max(from, to))};
      const auto opposite = [&](double place) {
        return on(edge, (x + place * extent_ - edge.a.point.x) / width);
      };
      hide_behind(part, opposite(part.low), opposite(part.high));
    }
  }

  [[nodiscard]] picture::LineParts visible_parts() && {
    return picture::without(
        {{0, 1}}, picture::common(picture::united(std::move(below_)), picture::united(std::move(above_))));
  }

 private:
  static Ends on(const Edge& edge, double place) {
    return {{edge.a.point.x + place * (edge.b.point.x - edge.a.point.x),
             edge.a.point.y + place * (edge.b.point.y - edge.a.point.y)},
            edge.a.depth + place * (edge.b.depth - edge.a.depth)};
  }
  // Hides the part of the line behind an occluder that is at `begin` and `end` where `part` begins and ends; the
  // occluder may not be nearer.
  void hide_behind(const LinePart& part, const Ends& begin, const Ends& end) {
    if (!(part.low < part.high)) return;
    const Ends here = on(line_, part.low);
    const Ends there = on(line_, part.high);
    const std::array above{begin.point.y - here.point.y, end.point.y - there.point.y};
    const std::array nearer{here.depth - begin.depth, there.depth - end.depth};
    const LinePart under = both_positive(part, {above[0] - grazing_, above[1] - grazing_}, nearer);
    if (under.low < under.high) below_.push_back(under);
    const LinePart over = both_positive(part, {-above[0] - grazing_, -above[1] - grazing_}, nearer);
    if (over.low < over.high) above_.push_back(over);
  }

  const Edge& line_;
  double grazing_;
  double extent_;
  bool upright_;
  picture::LineParts below_;
  picture::LineParts above_;
};

std::vector<LinePart> HeightLines::seen_of(const Edge& line) const {
  Hidden hidden(line, grazing_);
  const auto [first, last] = columns_of(line.a.point.x, line.b.point.x);
  for (std::size_t column = first; column <= last; ++column) {
    for (const std::uint32_t number : hiding_in_[column]) {
      const Edge& edge = hiding_[number];
      // Each pair once: in the first column that both have.
      if (column == std::max(first, columns_of(edge.a.point.x, edge.b.point.x).first))
        hidden.hide_behind(edge);
    }
  }
  return std::move(hidden).visible_parts();
}

LineId HeightLines::line_at(const PixelSegment& piece, std::uint32_t level) const {
  LineId best = on_no_line;
  double nearest = same_place;
  for (const std::uint32_t number : lines_in_[column_of((piece.a.x + piece.b.x) / 2)]) {
    if (levels_[number] != level) continue;
    const PixelSegment& image = lines_[number].image;
    const double away = std::max(picture::distance(piece.a, image), picture::distance(piece.b, image));
    if (away >= nearest) continue;
    nearest = away;
    best = number;
  }
  return best;
}

std::vector<DrawnPiece> HeightLines::pieces_of(const picture::VectorDrawing& drawing) const {
  std::vector<DrawnPiece> pieces;
  for (const picture::DrawingLine& line : drawing.lines) {
    const std::uint32_t level = line.layer < first_contour_layer ? 0 : line.layer - first_contour_layer + 1;
    for (std::uint32_t i = 0; i + 1 < line.count; ++i) {
      const auto point = [&](std::uint32_t corner) {
        const picture::DrawingPoint& p = drawing.points[line.first + corner];
        return PixelPoint{p.x, p.y};
      };
      const PixelSegment piece{point(i), point(i + 1)};
      pieces.push_back({line_at(piece, level), piece});
    }
  }
  return pieces;
}

PixelGrid nearest_cells(const scene::HeightGrid& grid, const algorithms::skala::View& view) {
  const programs::skala::Projection projection(grid, view);
  const bool rising = rising_diagonals(projection.rotation());
  PixelGrid cells(programs::skala::raster_side, programs::skala::raster_side);
  std::vector<double> depths(cells.values.size(), std::numeric_limits<double>::infinity());
  std::uint32_t number = 0;
  for (std::size_t slice = 0; slice + 1 < projection.slices(); ++slice) {
    for (std::size_t point = 0; point + 1 < projection.points(); ++point) {
      ++number;
      for (const Triangle& half : halves_of(projection, rising, point, slice)) {
        for_points(half, [&](int x, int y, double depth) {
          double& nearest = depths[cells.index(x, y)];
          if (depth >= nearest) return;
          nearest = depth;
          cells.set(x, y, number);
        });
      }
    }
  }
  return cells;
}

PixelGrid painted_cells(const scene::HeightGrid& grid, const algorithms::skala::View& view,
                        const picture::VectorDrawing& drawing) {
  const programs::skala::Projection projection(grid, view);
  const CellsByMiddle cells(projection, rising_diagonals(projection.rotation()));
  PixelGrid painted(programs::skala::raster_side, programs::skala::raster_side);
  for (const picture::DrawingFacet& facet : drawing.facets) {
    std::array<Corner, 4> corners{};
    double x = 0;
    double y = 0;
    for (std::uint32_t i = 0; i < facet.count; ++i) {
      const picture::DrawingPoint& p = drawing.points[facet.first + i];
      corners[i] = {{p.x, p.y}, 0};
      x += p.x;
      y += p.y;
    }
    const std::uint32_t number = cells.number_at(x / facet.count, y / facet.count);
    const auto paint = [&](int column, int row, double) { painted.set(column, row, number); };
    for_points({corners[0], corners[1], corners[2]}, paint);
    if (facet.count == 4) for_points({corners[0], corners[2], corners[3]}, paint);
  }
  return painted;
}

}  // namespace sightline::compare
