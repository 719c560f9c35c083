// See cross_check_faces.hpp.
#include "host/compare/cross_check_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/face_raster.hpp"

namespace sightline::compare {

namespace {

using picture::PixelGrid;
using picture::PixelPoint;

struct PixelBounds {
  PixelPoint low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  PixelPoint high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void take(const PixelPoint& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

// A tile of the picture has its own scene: the faces that may be visible there, one per body.
constexpr int tile = 16;
constexpr double certainly_beside = 1;  // pixels: more than the rounding of a place

// A face that extends behind the eye may be visible anywhere in the picture.
constexpr PixelPoint anywhere{std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};

struct NumberedFace {
  const scene::PolyFace* face = nullptr;
  PixelBounds bounds;
};

std::vector<NumberedFace> faces_of(const CommonScene& scene, const CrossCheckView& view) {
  std::vector<NumberedFace> faces;
  for (const scene::PolyBody& body : scene.scene.bodies) {
    for (const scene::PolyFace& face : body.faces) {
      NumberedFace numbered{&face, {}};
      for (const scene::VertexIndex v : face.outline) {
        const scene::PolyPoint& p = scene.scene.vertices[v];
        numbered.bounds.take(view.has_place(p) ? view.place(p) : anywhere);
        if (!view.has_place(p)) numbered.bounds.take({-anywhere.x, -anywhere.y});
      }
      faces.push_back(numbered);
    }
  }
  return faces;
}

// Paints facets, as triangles in pixels, over the picture.
void paint(PixelGrid& grid, const std::array<PixelPoint, 3>& corners, std::uint32_t value) {
  PixelBounds bounds;
  for (const PixelPoint& p : corners) bounds.take(p);
  const auto side = [](const PixelPoint& a, const PixelPoint& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  };
  const auto [a, b, c] = corners;
  const double turn = side(a, b, c.x, c.y) < 0 ? -1 : 1;
  const int last_row = std::min(grid.height - 1, static_cast<int>(std::floor(bounds.high.y)));
  const int last_column = std::min(grid.width - 1, static_cast<int>(std::floor(bounds.high.x)));
  for (int row = std::max(0, static_cast<int>(std::ceil(bounds.low.y))); row <= last_row; ++row) {
    for (int column = std::max(0, static_cast<int>(std::ceil(bounds.low.x))); column <= last_column;
         ++column) {
      const double x = column;
      const double y = row;
      if (turn * side(a, b, x, y) >= 0 && turn * side(b, c, x, y) >= 0 && turn * side(c, a, x, y) >= 0)
        grid.set(column, row, value);
    }
  }
}

// A drawing of heights fills a square; the view's picture is not distorted.
class FromSquare {
 public:
  FromSquare(const CommonScene& scene, const CrossCheckView& view) {
    for (const scene::PolyPoint& p : scene.scene.vertices) bounds_.take(view.place(p));
  }
  [[nodiscard]] PixelPoint pixel(const picture::DrawingPoint& p) const {
    const auto between = [](double low, double high, double part) { return low + (high - low) * part; };
    constexpr double extent = 255;
    return {between(bounds_.low.x, bounds_.high.x, static_cast<double>(p.x) / extent),
            between(bounds_.low.y, bounds_.high.y, static_cast<double>(p.y) / extent)};
  }

 private:
  PixelBounds bounds_;
};

bool near(const PixelPoint& a, const PixelPoint& b) {
  constexpr double rounding = 0.01;  // pixels; Skala's grid is finer
  return std::abs(a.x - b.x) < rounding && std::abs(a.y - b.y) < rounding;
}

}  // namespace

PixelGrid nearest_faces(const CommonScene& scene, const CrossCheckView& view) {
  const std::vector<NumberedFace> faces = faces_of(scene, view);
  PixelGrid grid(view.size, view.size);
  scene::PolyScene seen{{}, scene.scene.vertices, {}, view.camera, 1, {}};
  std::vector<std::uint32_t> numbers;
  for (int top = 0; top < view.size; top += tile) {
    for (int left = 0; left < view.size; left += tile) {
      seen.bodies.clear();
      numbers.assign(1, 0);
      for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const auto& [low, high] = faces[f].bounds;
        if (high.x < left - certainly_beside || low.x > left + tile + certainly_beside ||
            high.y < top - certainly_beside || low.y > top + tile + certainly_beside)
          continue;
        seen.bodies.push_back({{}, true, {*faces[f].face}});
        numbers.push_back(f + 1);
      }
      const PixelGrid part = algorithms::oracle::nearest_faces(
          seen, std::min(tile, view.size - left), std::min(tile, view.size - top),
          [&](int column, int row) { return view.sight(left + column, top + row); });
      for (int row = 0; row < part.height; ++row)
        for (int column = 0; column < part.width; ++column)
          grid.set(left + column, top + row, numbers[part.at(column, row)]);
    }
  }
  return grid;
}

PixelGrid surface_faces(const registry::HeightAlgorithm& algorithm, const CommonScene& scene,
                        const CrossCheckView& view) {
  const picture::VectorDrawing drawing = algorithm.draw(*scene.heights, scene.height_view);
  const FromSquare from_square(scene, view);
  const auto& faces = scene.scene.bodies.front().faces;
  std::vector<PixelPoint> places;
  for (const scene::PolyPoint& p : scene.scene.vertices) places.push_back(view.place(p));
  PixelGrid grid(view.size, view.size);
  // Facets come in the order of cells, from the last to the first, without those that are not visible. A cell is one
  // facet of four corners or, if folded, its far triangle and its near one.
  const std::size_t cells = faces.size() / 2;
  std::size_t cell = cells;
  const auto corners_of_cell = [&](const std::vector<PixelPoint>& corners) {
    return std::all_of(corners.begin(), corners.end(), [&](const PixelPoint& corner) {
      const auto is_corner = [&](scene::VertexIndex v) { return near(places[v], corner); };
      const auto& first = faces[2 * cell].outline;
      const auto& second = faces[2 * cell + 1].outline;
      return std::any_of(first.begin(), first.end(), is_corner) ||
             std::any_of(second.begin(), second.end(), is_corner);
    });
  };
  for (const picture::DrawingFacet& facet : drawing.facets) {
    std::vector<PixelPoint> corners;
    for (std::size_t i = 0; i < facet.count; ++i)
      corners.push_back(from_square.pixel(drawing.points[facet.first + i]));
    const bool folded = corners.size() == 3;
    const bool second_of_folded = folded && cell < cells && corners_of_cell(corners);
    while (!second_of_folded && cell-- > 0 && !corners_of_cell(corners)) {
    }
    if (cell >= cells) return {};
    const auto near_triangle = static_cast<std::uint32_t>(2 * cell + 1);
    paint(grid, {corners[0], corners[1], corners[2]}, second_of_folded ? near_triangle : near_triangle + 1);
    if (!folded) paint(grid, {corners[0], corners[2], corners[3]}, near_triangle);
  }
  return grid;
}

}  // namespace sightline::compare
