#include "host/algorithms/skala/floor_contours.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "host/algorithms/skala/facing.hpp"
#include "host/algorithms/skala/pen.hpp"

namespace sightline::algorithms::skala {
namespace {

class FloorMap {
 public:
  FloorMap(const scene::HeightGrid& grid, const Surface& surface, const FloorContours& contours, const Coverage* coverage)
      : grid_(grid), surface_(surface), contours_(contours), coverage_(coverage) {}

  void trace(Sheet& sheet) {
    for (std::size_t row = 0; row + 1 < surface_.rows(); ++row)
      for (std::size_t column = 0; column + 1 < surface_.columns(); ++column) {
        if (!cell_defined(surface_, row, column)) continue;
        const Place near{row, column};
        const Place beside{row, column + 1};
        const Place behind{row + 1, column};
        const Place far{row + 1, column + 1};
        triangle({near, beside, behind});
        triangle({far, behind, beside});
      }
    stitcher_.finish(sheet);
  }

 private:
  struct Place {
    std::size_t row = 0;
    std::size_t column = 0;
  };

  void triangle(const std::array<Place, 3>& corners) {
    std::array<double, 3> heights{};
    for (std::size_t i = 0; i < 3; ++i) heights[i] = grid_.heights[surface_.height_index(corners[i].row, corners[i].column)];
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const auto first = std::upper_bound(contours_.levels.begin(), contours_.levels.end(), *low);
    for (auto level = first; level != contours_.levels.end() && *level <= *high; ++level) {
      std::array<Vertex, 2> ends{};
      std::array<Joint, 2> joints{};
      std::size_t found = 0;
      for (std::size_t i = 0; i < 3 && found < 2; ++i) {
        const std::size_t next = (i + 1) % 3;
        if ((heights[i] >= *level) == (heights[next] >= *level)) continue;
        ends[found] = crossing(corners[i], corners[next], *level);
        joints[found++] = joint(id(corners[i]), id(corners[next]));
      }
      if (found == 2) piece(static_cast<std::uint32_t>(level - contours_.levels.begin()), ends, joints);
    }
  }

  void piece(std::uint32_t level, const std::array<Vertex, 2>& ends, const std::array<Joint, 2>& joints) {
    const auto at = [&](double t) {
      if (t == 0) return ends[0];
      if (t == 1) return ends[1];
      return Vertex{static_cast<float>(ends[0].x + t * (double{ends[1].x} - double{ends[0].x})),
                    static_cast<float>(ends[0].y + t * (double{ends[1].y} - double{ends[0].y}))};
    };
    std::vector<Piece> seen;
    if (coverage_ == nullptr) {
      seen.push_back({ends[0], ends[1]});
    } else {
      for (const LinePart& part : coverage_->visible(ends[0], ends[1])) seen.push_back({at(part.from), at(part.to)});
    }
    stitcher_.add(contours_.first_layer + level, ends[0], ends[1], seen, joints[0], joints[1]);
  }

  // Gives the same result for both directions of the edge.
  [[nodiscard]] Vertex crossing(Place a, Place b, double level) const {
    if (id(b) < id(a)) std::swap(a, b);
    const double low = grid_.heights[surface_.height_index(a.row, a.column)];
    const double high = grid_.heights[surface_.height_index(b.row, b.column)];
    double t = (level / 2 - low / 2) / (high / 2 - low / 2);
    if (!(t >= 0 && t <= 1)) t = 0.5;
    const auto [ax, az] = along(a);
    const auto [bx, bz] = along(b);
    return surface_.place(ax + t * (bx - ax), az + t * (bz - az), contours_.floor);
  }
  [[nodiscard]] std::array<double, 2> along(Place place) const {
    const std::size_t index = surface_.height_index(place.row, place.column);
    return {grid_.x[index % grid_.points()], grid_.z[index / grid_.points()]};
  }

  [[nodiscard]] std::size_t id(Place place) const { return place.row * surface_.columns() + place.column; }
  [[nodiscard]] Joint joint(std::size_t a, std::size_t b) const {
    const std::size_t first = std::min(a, b);
    const std::size_t step = std::max(a, b) - first;
    const bool along_row = step == 1 && (first + 1) % surface_.columns() != 0;
    return 1 + 3 * Joint{first} + (along_row ? 0U : step == surface_.columns() ? 1U : 2U);
  }

  const scene::HeightGrid& grid_;
  const Surface& surface_;
  const FloorContours& contours_;
  const Coverage* coverage_;
  Stitcher stitcher_;
};

}  // namespace

void add_floor_contours(const scene::HeightGrid& grid, const Surface& surface, const FloorContours& contours, const Coverage* coverage,
                        int columns, picture::VectorDrawing& drawing) {
  Sheet sheet(drawing, columns);
  FloorMap(grid, surface, contours, coverage).trace(sheet);
}

}  // namespace sightline::algorithms::skala
