// See height_cells.hpp.
#include "host/compare/height_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "host/compare/height_lines.hpp"
#include "host/guests/skala/projection.hpp"

namespace sightline::compare {
namespace {

using picture::PixelGrid;
using picture::PixelPoint;

struct Corner {
  PixelPoint point;
  double depth = 0;
};
using Triangle = std::array<Corner, 3>;

double turn(const PixelPoint& a, const PixelPoint& b, const PixelPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Every point of the screen in a triangle, its sides included, with the depth there.
template <class Visit>
void for_points(const Triangle& triangle, const Visit& visit) {
  const auto& [a, b, c] = triangle;
  const double area = turn(a.point, b.point, c.point);
  if (area == 0) return;
  const auto [low_x, high_x] = std::minmax({a.point.x, b.point.x, c.point.x});
  const auto [low_y, high_y] = std::minmax({a.point.y, b.point.y, c.point.y});
  const auto first = [](double low) { return std::max(0, static_cast<int>(std::ceil(low))); };
  const auto last = [](double high) {
    return std::min(guests::skala::raster_side - 1, static_cast<int>(std::floor(high)));
  };
  for (int y = first(low_y); y <= last(high_y); ++y) {
    for (int x = first(low_x); x <= last(high_x); ++x) {
      const PixelPoint p{static_cast<double>(x), static_cast<double>(y)};
      const double to_a = turn(b.point, c.point, p) / area;
      const double to_b = turn(c.point, a.point, p) / area;
      const double to_c = 1 - to_a - to_b;
      if (to_a < 0 || to_b < 0 || to_c < 0) continue;
      visit(x, y, to_a * a.depth + to_b * b.depth + to_c * c.depth);
    }
  }
}

// The two triangles of the cell whose least corner this is.
std::array<Triangle, 2> halves_of(const guests::skala::Projection& projection, bool rising, std::size_t point,
                                  std::size_t slice) {
  const auto at = [&](std::size_t p, std::size_t s) {
    const guests::skala::Vertex& vertex = projection.at(p, s);
    return Corner{{vertex.x, vertex.y}, vertex.depth};
  };
  const std::size_t low = rising ? point : point + 1;
  const std::size_t high = rising ? point + 1 : point;
  const Corner one = at(low, slice);
  const Corner other = at(high, slice + 1);
  return {Triangle{one, other, at(high, slice)}, Triangle{one, other, at(low, slice + 1)}};
}

// Numbers of cells by the middles of their outlines and of their halves.
class CellsByMiddle {
 public:
  CellsByMiddle(const guests::skala::Projection& projection, bool rising) {
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

PixelGrid nearest_cells(const scene::HeightGrid& grid, const guests::skala::View& view) {
  const guests::skala::Projection projection(grid, view);
  const bool rising = rising_diagonals(projection.rotation());
  PixelGrid cells(guests::skala::raster_side, guests::skala::raster_side);
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

PixelGrid painted_cells(const scene::HeightGrid& grid, const guests::skala::View& view,
                        const picture::VectorDrawing& drawing) {
  const guests::skala::Projection projection(grid, view);
  const CellsByMiddle cells(projection, rising_diagonals(projection.rotation()));
  PixelGrid painted(guests::skala::raster_side, guests::skala::raster_side);
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
