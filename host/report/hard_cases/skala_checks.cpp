#include "host/report/hard_cases/skala_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "host/guests/skala/projection.hpp"

namespace sightline::harness::report {

namespace {

using algorithms::oracle::RasterDot;
using picture::PixelGrid;
using picture::VectorDrawing;
using scene::HeightGrid;

// Dots of a chain of vertices on the screen.
std::vector<RasterDot> dots_between(const std::vector<guests::skala::Vertex>& vertices) {
  std::vector<RasterDot> dots;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    const auto some = algorithms::oracle::segment_dots(vertices[i].column, vertices[i].row,
                                                       vertices[i + 1].column, vertices[i + 1].row);
    dots.insert(dots.end(), some.begin(), some.end());
  }
  return dots;
}

std::vector<RasterDot> slice_dots(const HeightGrid& grid, const guests::skala::View& view,
                                  std::size_t slice) {
  const guests::skala::Projection projection(grid, view);
  std::vector<guests::skala::Vertex> vertices;
  for (std::size_t i = 0; i < grid.points(); ++i) vertices.push_back(projection.at(i, slice));
  return dots_between(vertices);
}

std::size_t lit(const PixelGrid& dots) {
  return static_cast<std::size_t>(std::count(dots.values.begin(), dots.values.end(), 1U));
}

Complaint all_lit(const std::vector<RasterDot>& expected, const PixelGrid& dots) {
  const auto dark = std::count_if(expected.begin(), expected.end(), [&](const RasterDot& dot) {
    const bool on_screen = dot.x >= 0 && dot.x < dots.width && dot.y >= 0 && dot.y < dots.height;
    return on_screen && dots.at(dot.x, dot.y) == 0;
  });
  if (dark == 0) return std::nullopt;
  return fmt::format("{} dots dark that must be lit", dark);
}

Complaint expect_lines(const VectorDrawing& drawing, std::uint32_t layer, std::size_t expected) {
  const auto count = std::count_if(drawing.lines.begin(), drawing.lines.end(),
                                   [layer](const picture::DrawingLine& line) { return line.layer == layer; });
  if (static_cast<std::size_t>(count) == expected) return std::nullopt;
  return fmt::format("{} lines in layer {}, not {}", count, layer, expected);
}

}  // namespace

Complaint near_slice_lit(const HeightGrid& grid, const guests::skala::View& view, const PixelGrid& dots) {
  return all_lit(slice_dots(grid, view, 0), dots);
}

Complaint near_slice_only(const HeightGrid& grid, const guests::skala::View& view, const PixelGrid& dots) {
  const auto expected = slice_dots(grid, view, 0);
  if (auto dark = all_lit(expected, dots)) return dark;
  PixelGrid slice(dots.width, dots.height);
  for (const RasterDot& dot : expected) slice.set(dot.x, dot.y, 1);
  if (slice == dots) return std::nullopt;
  return fmt::format("{} dots beside the first slice", lit(dots) - lit(slice));
}

Complaint every_slice_lit(const HeightGrid& grid, const guests::skala::View& view, const PixelGrid& dots) {
  for (std::size_t slice = 0; slice < grid.slices(); ++slice) {
    if (auto dark = all_lit(slice_dots(grid, view, slice), dots)) return dark;
  }
  return std::nullopt;
}

Complaint whole_net_lit(const HeightGrid& grid, const guests::skala::View& view, const PixelGrid& dots) {
  const guests::skala::Projection projection(grid, view);
  for (std::size_t i = 0; i < grid.points(); ++i) {
    std::vector<guests::skala::Vertex> vertices;
    for (std::size_t slice = 0; slice < grid.slices(); ++slice) vertices.push_back(projection.at(i, slice));
    if (auto dark = all_lit(dots_between(vertices), dots)) return dark;
  }
  return every_slice_lit(grid, view, dots);
}

Complaint one_row(const HeightGrid&, const guests::skala::View&, const PixelGrid& dots) {
  const auto row = static_cast<std::size_t>(dots.width);
  for (std::size_t from = 0; from < dots.values.size(); from += row) {
    const auto begin = dots.values.begin() + static_cast<std::ptrdiff_t>(from);
    if (std::count(begin, begin + dots.width, 1U) == dots.width && lit(dots) == row) return std::nullopt;
  }
  return fmt::format("{} dots, not one row of {}", lit(dots), row);
}

// The far slice in the middle of the gap between two islands.
Complaint far_slice_in_gap(const HeightGrid& grid, const guests::skala::View& view, const PixelGrid& dots) {
  auto expected = slice_dots(grid, view, 1);
  std::erase_if(expected, [](const RasterDot& dot) { return dot.x < 100 || dot.x > 155; });
  return all_lit(expected, dots);
}

Complaint bottom_lit(const HeightGrid&, const guests::skala::View&, const PixelGrid& dots) {
  for (int x = 0; x < dots.width; ++x) {
    if (dots.at(x, 0) != 0) return std::nullopt;
  }
  return "nothing in the bottom row";
}

Complaint first_line_whole(const HeightGrid& grid, const VectorDrawing& drawing) {
  if (!drawing.lines.empty() && drawing.lines.front().count == grid.points()) return std::nullopt;
  return "the first slice is not one line";
}

Complaint ink_of_one_row(const HeightGrid&, const VectorDrawing& drawing) {
  double ink = 0;
  for (const picture::DrawingLine& line : drawing.lines) {
    for (std::uint32_t i = 1; i < line.count; ++i)
      ink +=
          std::abs(double{drawing.points[line.first + i].x} - double{drawing.points[line.first + i - 1].x});
  }
  if (ink > 254 && ink < 255.5) return std::nullopt;
  return fmt::format("ink of {:.1f}, not of one row", ink);
}

Complaint one_line(const HeightGrid& grid, const VectorDrawing& drawing) {
  if (auto wrong = expect_lines(drawing, 0, 1)) return wrong;
  return first_line_whole(grid, drawing);
}

Complaint line_a_slice(const HeightGrid& grid, const VectorDrawing& drawing) {
  return expect_lines(drawing, 0, grid.slices());
}

Complaint line_a_slice_and_point(const HeightGrid& grid, const VectorDrawing& drawing) {
  if (auto wrong = line_a_slice(grid, drawing)) return wrong;
  return expect_lines(drawing, 1, grid.points());
}

Complaint line_through_gap(const HeightGrid&, const VectorDrawing& drawing) {
  for (const picture::DrawingLine& line : drawing.lines) {
    if (drawing.points[line.first].x < 120 && drawing.points[line.first + line.count - 1].x > 130)
      return std::nullopt;
  }
  return "no line through the gap";
}

Complaint reaches_bottom(const HeightGrid&, const VectorDrawing& drawing) {
  for (const picture::DrawingPoint& point : drawing.points) {
    if (point.y == 0) return std::nullopt;
  }
  return "nothing reaches the bottom";
}

Complaint line_a_level(const HeightGrid&, const VectorDrawing& drawing) {
  constexpr std::uint32_t first_contour = 4;
  for (std::uint32_t level = 0; level < 3; ++level) {
    if (auto wrong = expect_lines(drawing, first_contour + level, 1)) return wrong;
  }
  return std::nullopt;
}

}  // namespace sightline::harness::report
