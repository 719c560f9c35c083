// Several views on one sheet; see hidden_lines.hpp.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "host/hidden_lines/hidden_lines.hpp"
#include "host/picture/camera_view.hpp"

namespace sightline::hidden_lines {
namespace {

using Place = std::array<double, 2>;

struct Cell {
  int column = 0;
  int row = 0;  // upwards
};

// ISO 5456-2. Oblique views lie in the corner to the right, one after the other.
Cell cell_of(Side side, bool first_angle, int& free_column) {
  const int sign = first_angle ? -1 : 1;
  switch (side) {
    case Side::front: return {0, 0};
    case Side::right: return {sign, 0};
    case Side::left: return {-sign, 0};
    case Side::back: return {2, 0};
    case Side::top: return {0, sign};
    case Side::bottom: return {0, -sign};
    case Side::free: break;
  }
  return {free_column++, sign};
}

// How far the image of a scene reaches from the place of its middle.
struct Extent {
  Place before{};  // to the left, and down
  Place after{};
};

// Rows or columns that have a view: how much room each needs on both sides of its line, in units of the scene.
struct Line {
  double before = 0;
  double after = 0;
};

}  // namespace

SheetLayout::SheetLayout(const scene::PolyScene& scene, std::span<const SheetView> views, const picture::DrawingField& field,
                         bool first_angle, double gap)
    : field_(field) {
  const scene::PolyBounds bounds = scene::bounds_of(scene);
  const geometry::RealVector middle{(double(bounds.low[0]) + bounds.high[0]) / 2, (double(bounds.low[1]) + bounds.high[1]) / 2,
                                    (double(bounds.low[2]) + bounds.high[2]) / 2};
  std::vector<Cell> cells;
  std::array<std::map<int, Line>, 2> lines;  // columns and rows
  int free_column = 1;
  for (const SheetView& view : views) {
    const picture::CameraView seen(view.camera);
    const picture::SeenPoint centre = seen.at(middle);
    Extent extent;
    for (const scene::PolyPoint& vertex : scene.vertices) {
      const picture::SeenPoint at = seen.at(vertex);
      for (std::size_t a = 0; a < 2; ++a) {
        extent.before[a] = std::max(extent.before[a], centre[a] - at[a]);
        extent.after[a] = std::max(extent.after[a], at[a] - centre[a]);
      }
    }
    in_image_.push_back({centre[0], centre[1]});
    cells.push_back(cell_of(view.side, first_angle, free_column));
    for (std::size_t a = 0; a < 2; ++a) {
      Line& line = lines[a][a == 0 ? cells.back().column : cells.back().row];
      line.before = std::max(line.before, extent.before[a]);
      line.after = std::max(line.after, extent.after[a]);
    }
  }
  const Place size{field.width, field.height};
  Place needed{};  // by the views, in units of the scene
  Place step{};    // from one to the next, in units of the field
  Place gaps{};    // all of these
  double scale = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < 2; ++a) {
    for (const auto& [number, line] : lines[a]) needed[a] += line.before + line.after;
    // The gaps take at most half of the field.
    const auto between = static_cast<double>(lines[a].size()) - 1;
    if (between > 0) step[a] = std::min(gap, size[a] / 2 / between);
    gaps[a] = step[a] * between;
    if (needed[a] > 0) scale = std::min(scale, (size[a] - gaps[a]) / needed[a]);
  }
  if (!field_.scale) field_.scale = scale < std::numeric_limits<double>::infinity() ? scale : 1;
  // The views together lie in the middle of the field.
  std::array<std::map<int, double>, 2> places;
  for (std::size_t a = 0; a < 2; ++a) {
    double at = (size[a] - needed[a] * *field_.scale - gaps[a]) / 2;
    for (const auto& [number, line] : lines[a]) {
      places[a][number] = at + line.before * *field_.scale;
      at += (line.before + line.after) * *field_.scale + step[a];
    }
  }
  for (const Cell& cell : cells) on_sheet_.push_back({places[0][cell.column], places[1][cell.row]});
}

picture::VectorDrawing SheetLayout::sheet(std::span<Drawing> drawings) const {
  picture::VectorDrawing sheet;
  sheet.width = field_.width;
  sheet.height = field_.height;
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    const picture::VectorDrawing& drawing = drawings[i].picture;
    Place shift{};
    for (std::size_t a = 0; a < 2; ++a) shift[a] = on_sheet_[i][a] - (in_image_[i][a] - drawings[i].window.low[a]) * *field_.scale;
    std::vector<std::uint32_t> layers;
    for (const picture::DrawingLayer& layer : drawing.layers) {
      auto same = std::find_if(sheet.layers.begin(), sheet.layers.end(), [&](const picture::DrawingLayer& l) {
        return l.label == layer.label && l.colour == layer.colour && l.dash == layer.dash;
      });
      if (same == sheet.layers.end()) same = sheet.layers.insert(same, layer);
      layers.push_back(static_cast<std::uint32_t>(same - sheet.layers.begin()));
    }
    const auto first = static_cast<std::uint32_t>(sheet.points.size());
    for (const picture::DrawingPoint& point : drawing.points)
      sheet.points.push_back({static_cast<float>(point.x + shift[0]), static_cast<float>(point.y + shift[1])});
    for (const picture::DrawingLine& line : drawing.lines) sheet.lines.push_back({layers[line.layer], first + line.first, line.count});
    for (Stroke& stroke : drawings[i].strokes) {
      for (std::size_t a = 0; a < 2; ++a) {
        stroke.from[a] += shift[a];
        stroke.to[a] += shift[a];
      }
    }
  }
  return sheet;
}

}  // namespace sightline::hidden_lines
