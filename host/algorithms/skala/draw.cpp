#include "host/algorithms/skala/draw.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/skala/facing.hpp"
#include "host/algorithms/skala/surface.hpp"
#include "host/algorithms/skala/walk.hpp"
#include "host/picture/height_colours.hpp"

namespace sightline::algorithms::skala {
namespace {

// Contour colours are used cyclically from the lowest level.
constexpr std::array<picture::Colour, 6> contour_colours{
    {{31, 95, 191}, {0, 140, 149}, {46, 139, 87}, {190, 140, 0}, {214, 96, 20}, {178, 34, 52}}};

std::vector<double> contour_levels(scene::Interval range, const View& view) {
  std::vector<double> levels = view.level_heights;
  const int count = view.levels;
  if (!levels.empty()) return levels;
  if (!(range.high > range.low)) return levels;
  for (int k = 1; k <= std::clamp(count, 0, 255); ++k) {
    const double part = static_cast<double>(k) / (std::clamp(count, 0, 255) + 1);
    levels.push_back(range.low * (1 - part) + range.high * part);
  }
  return levels;
}

// The line colours of the surfaces.
constexpr std::array<picture::Colour, 4> surface_colours{{{0, 0, 0}, {190, 60, 20}, {31, 95, 191}, {46, 139, 87}}};

void name_layers(picture::VectorDrawing& drawing, const std::vector<double>& levels, bool row_is_slice, std::size_t surface) {
  const picture::Colour colour = surface_colour(surface);
  const std::string of = surface == 0 ? "" : fmt::format(", surface {}", surface + 1);
  drawing.layers.push_back({(row_is_slice ? "lines along x" : "lines along z") + of, colour});
  drawing.layers.push_back({(row_is_slice ? "lines along z" : "lines along x") + of, colour});
  drawing.layers.push_back({"rims" + of, {96, 96, 96}});
  drawing.layers.push_back({"silhouette" + of, {150, 0, 110}});
  for (std::size_t k = 0; k < levels.size(); ++k)
    drawing.layers.push_back(
        {fmt::format("contour {:.6g}", levels[k]) + of, contour_colours[k % contour_colours.size()]});
}

void measure_heights(Walk& order, const scene::HeightGrid& grid) {
  const Surface& surface = *order.surface;
  order.heights.reserve(grid.heights.size());
  order.bands.reserve(grid.heights.size());
  for (std::size_t row = 0; row < surface.rows(); ++row)
    for (std::size_t column = 0; column < surface.columns(); ++column) {
      const double height = grid.heights[surface.height_index(row, column)];
      order.heights.push_back(height);
      const auto above = std::upper_bound(order.levels.begin(), order.levels.end(), height);
      order.bands.push_back(static_cast<std::uint8_t>(above - order.levels.begin()));
    }
}

// The colours of cells: by height, or as greys by the slope along x of the data, which is the first component of the unit
// normal (Skala 1985, section 4).
class Shading {
 public:
  Shading(const scene::HeightGrid& grid, Colouring colouring) : grid_(grid), colouring_(colouring) {
    const double half = grid.range.high / 2 - grid.range.low / 2;
    scale_ = half > 0 && std::isfinite(1 / half) ? 1 / half : 0;
  }
  // The colour of the cell with these least indices.
  [[nodiscard]] picture::Colour colour(std::size_t point, std::size_t slice) const {
    if (colouring_ == Colouring::heights) return colour_of_height(point, slice);
    const std::uint8_t shade = grey(point, slice);
    return {shade, shade, shade};
  }

 private:
  // The mean of its corners' heights, computed from halves because their sum may overflow.
  [[nodiscard]] picture::Colour colour_of_height(std::size_t point, std::size_t slice) const {
    double part = 0;
    for (const auto& [p, s] : {std::pair{point, slice}, std::pair{point + 1, slice}, std::pair{point, slice + 1}, std::pair{point + 1, slice + 1}})
      part += ((grid_.height(p, s) / 2 - grid_.range.low / 2) * scale_) / 4;
    // More colours than can be told apart side by side; neighbouring cells often share one.
    constexpr double steps = 128;
    return picture::height_colour(std::floor(part * steps + 0.5) / steps);
  }
  [[nodiscard]] std::uint8_t grey(std::size_t point, std::size_t slice) const {
    const double a = grid_.height(point, slice) * scale_;
    const double b = grid_.height(point + 1, slice) * scale_;
    const double c = grid_.height(point, slice + 1) * scale_;
    const double d = grid_.height(point + 1, slice + 1) * scale_;
    const double fx = ((b - a) + (d - c)) / (2 * (grid_.x[point + 1] - grid_.x[point]));
    const double fz = ((c - a) + (d - b)) / (2 * (grid_.z[slice + 1] - grid_.z[slice]));
    const double normal = -fx / std::sqrt(1 + fx * fx + fz * fz);
    if (!(std::abs(normal) <= 1)) return 145;
    return static_cast<std::uint8_t>(145 + std::floor(100 * normal + 0.5));
  }

  const scene::HeightGrid& grid_;
  Colouring colouring_;
  double scale_ = 0;
};

class Facets {
 public:
  Facets(const Surface& surface, Sheet& sheet) : surface_(surface), sheet_(sheet) {}

  // A cell that is folded along its diagonal becomes two triangles, because its outline may cross itself.
  void add(std::size_t row, std::size_t column, picture::Colour colour) {
    const Vertex& near = surface_.at(row, column);
    const Vertex& beside = surface_.at(row, column + 1);
    const Vertex& behind = surface_.at(row + 1, column);
    const Vertex& far = surface_.at(row + 1, column + 1);
    const bool folded =
        folds(side_of(surface_, row, column, Half::near), side_of(surface_, row, column, Half::far));
    if (!folded) return put({beside, far, behind, near}, colour);
    put({beside, far, behind}, colour);
    put({near, beside, behind}, colour);
  }

 private:
  void put(std::initializer_list<Vertex> corners, picture::Colour colour) {
    picture::VectorDrawing& drawing = sheet_.drawing();
    drawing.facets.push_back(
        {static_cast<std::uint32_t>(drawing.points.size()), static_cast<std::uint8_t>(corners.size()), colour});
    for (const Vertex corner : corners) drawing.points.push_back(sheet_.place(corner));
  }

  const Surface& surface_;
  Sheet& sheet_;
};

// Joins facets to areas (picture::DrawingArea): consecutive cells of a row that have the same colour and show the same
// side. An area extends under the far half of each nearer cell beside it that shows the same side. If that half shows the
// other side, the surface is folded, and the nearer cell covers the area anyway.
class Areas {
 public:
  Areas(const Surface& surface, Sheet& sheet) : surface_(surface), sheet_(sheet) {
    for (std::size_t row = 0; row + 1 < surface.rows(); ++row)
      for (std::size_t column = 0; column + 1 < surface.columns(); ++column)
        sides_.push_back({side_of(surface, row, column, Half::near), side_of(surface, row, column, Half::far)});
  }

  // Cells must be added in painting order: rows and columns descend.
  void add(std::size_t row, std::size_t column, picture::Colour colour) {
    const Side side = sides(row, column).whole();
    const bool continues = row > 0 && sides(row - 1, column).whole() == side;
    const bool follows = last_ > first_ && row == row_ && column + 1 == first_ && colour == colour_ && side == side_ && side != Side::none &&
                         continues == continues_;
    if (!follows) {
      finish();
      row_ = row;
      last_ = column + 1;
      colour_ = colour;
      side_ = side;
      continues_ = continues;
    }
    first_ = column;
  }

  void finish() {
    if (last_ > first_) side_ == Side::none ? put_folded() : put();
    first_ = last_ = 0;
  }

 private:
  struct Sides {
    Side near = Side::none;
    Side far = Side::none;
    // The side of both halves; none if they differ.
    [[nodiscard]] Side whole() const { return near == far ? near : Side::none; }
  };
  [[nodiscard]] const Sides& sides(std::size_t row, std::size_t column) const { return sides_[row * (surface_.columns() - 1) + column]; }
  [[nodiscard]] bool far_half_shows(std::size_t row, std::size_t column, Side side) const {
    return side != Side::none && sides(row, column).far == side;
  }

  void put() {
    const bool next_continues = first_ > 0 && sides(row_, first_ - 1).whole() == side_ && (!continues_ || sides(row_ - 1, first_ - 1).whole() == side_);
    const std::size_t from = next_continues ? first_ - 1 : first_;
    corners_.clear();
    for (std::size_t column = last_ + 1; column-- > from;) corners_.push_back(surface_.at(row_ + 1, column));
    if (!next_continues && first_ > 0 && far_half_shows(row_, first_ - 1, side_)) corners_.push_back(surface_.at(row_ + 1, first_ - 1));
    corners_.push_back(surface_.at(row_, from));
    if (continues_) {
      for (std::size_t column = from; column <= last_; ++column) corners_.push_back(surface_.at(row_ - 1, column));
      corners_.push_back(surface_.at(row_, last_));
    } else {
      for (std::size_t column = from; column < last_; ++column) under(column, side_);
    }
    put_corners();
  }
  // Appends the outline from (row, column) to the next column, extended under the nearer cell.
  void under(std::size_t column, Side side) {
    if (row_ > 0 && far_half_shows(row_ - 1, column, side)) corners_.push_back(surface_.at(row_ - 1, column + 1));
    corners_.push_back(surface_.at(row_, column + 1));
  }
  // Adds a cell that is folded along its diagonal.
  void put_folded() {
    const Vertex& beside = surface_.at(row_, first_ + 1);
    const Vertex& behind = surface_.at(row_ + 1, first_);
    corners_ = {beside, surface_.at(row_ + 1, first_ + 1), behind};
    put_corners();
    const Side side = sides(row_, first_).near;
    corners_ = {behind};
    if (first_ > 0 && far_half_shows(row_, first_ - 1, side)) corners_.push_back(surface_.at(row_ + 1, first_ - 1));
    corners_.push_back(surface_.at(row_, first_));
    under(first_, side);
    put_corners();
  }
  void put_corners() {
    picture::VectorDrawing& drawing = sheet_.drawing();
    const auto first = static_cast<std::uint32_t>(drawing.points.size());
    places_.clear();
    for (const Vertex corner : corners_) places_.push_back(sheet_.place(corner));
    // Of nearly collinear corners only the first and the last are kept. Adjacent areas overlap, so no gaps appear.
    constexpr std::size_t most_left_out = 24;
    for (std::size_t at = 0; at < places_.size();) {
      drawing.points.push_back(places_[at]);
      std::size_t next = at + 1;
      while (next < places_.size() && next - at <= most_left_out && in_line(at, next + 1)) ++next;
      at = next;
    }
    drawing.areas.push_back({first, static_cast<std::uint32_t>(drawing.points.size()) - first, colour_});
  }
  // Whether all places between two are near the line between them. The second may be the first one again.
  [[nodiscard]] bool in_line(std::size_t from, std::size_t to) const {
    constexpr double near = 0.004;  // of 255 units: 3 micrometres on a page
    const picture::DrawingPoint a = places_[from];
    const picture::DrawingPoint b = places_[to % places_.size()];
    const double ux = double{b.x} - a.x;
    const double uy = double{b.y} - a.y;
    const double square = ux * ux + uy * uy;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double vx = double{places_[i].x} - a.x;
      const double vy = double{places_[i].y} - a.y;
      const double along = ux * vx + uy * vy;
      const double across = ux * vy - uy * vx;
      if (along < 0 || along > square || across * across > near * near * square) return false;
    }
    return true;
  }

  const Surface& surface_;
  Sheet& sheet_;
  std::vector<Sides> sides_;
  std::vector<Vertex> corners_;
  std::vector<picture::DrawingPoint> places_;  // positions of the corners
  // The current area: cells of one row, none unless last_ > first_.
  std::size_t row_ = 0;
  std::size_t first_ = 0;
  std::size_t last_ = 0;
  picture::Colour colour_;
  Side side_ = Side::none;
  bool continues_ = false;  // the area is continued in the nearer row
};

void add_facets(const scene::HeightGrid& grid, const Surface& surface, const WalkResult& walked, const View& view,
                picture::VectorDrawing& drawing) {
  if (surface.rows() < 2 || surface.columns() < 2) return;
  Sheet sheet(drawing, std::clamp(view.columns, fewest_columns, most_columns));
  Facets facets(surface, sheet);
  Areas areas(surface, sheet);
  const Shading shading(grid, view.colouring);
  const std::size_t columns = surface.columns() - 1;
  for (std::size_t row = surface.rows() - 1; row-- > 0;)
    for (std::size_t column = columns; column-- > 0;) {
      if (!walked.seen[row * columns + column] || !cell_defined(surface, row, column)) continue;
      const std::size_t a = surface.height_index(row, column);
      const std::size_t b = surface.height_index(row + 1, column + 1);
      const picture::Colour colour = shading.colour(std::min(a % grid.points(), b % grid.points()),
                                                    std::min(a / grid.points(), b / grid.points()));
      facets.add(row, column, colour);
      areas.add(row, column, colour);
    }
  areas.finish();
}

template <class Walking>
picture::VectorDrawing draw_by(const scene::HeightGrid& grid, const View& asked, const Walking& walking) {
  View view = asked;
  view.family = resolved_family(asked);
  // For cells, no family of slices is chosen.
  const Family rows = view.subject == Subject::lines ? view.family : Family::along_x;
  picture::VectorDrawing drawing;
  drawing.width = drawing.height = picture_extent;
  const Surface surface(grid, view, rows);
  Walk order{&surface, &view, {}, {}, {}};
  if (view.subject == Subject::contours) {
    order.levels = contour_levels(grid.range, view);
    measure_heights(order, grid);
  }
  name_layers(drawing, order.levels, rows != Family::along_z, 0);
  if (grid.heights.empty()) return drawing;
  // About the number of points in a picture of slices; unused reserved memory costs nothing.
  drawing.points.reserve(grid.heights.size());
  const WalkResult walked = walking(order, drawing);
  if (view.subject == Subject::surface) add_facets(grid, surface, walked, view, drawing);
  // On a net, the silhouette is drawn like the lines of the net.
  if (view.subject == Subject::surface) drawing.layers[silhouettes].colour = drawing.layers[along_rows].colour;
  return drawing;
}

// Paints the cells of all surfaces from far to near; at the same place, the one on the eye's side last. If surfaces pass
// through each other within a cell, the uppermost surface of each part of the cell is painted again.
class MultiSurfaceFacets {
 public:
  MultiSurfaceFacets(std::span<const scene::HeightGrid> grids, const std::vector<Surface>& surfaces, const std::vector<Walk>& orders,
                 const std::vector<WalkResult>& walked, const View& view, picture::VectorDrawing& drawing)
      : grid_(grids[0]),
        surfaces_(surfaces),
        orders_(orders),
        walked_(walked),
        any_(surfaces.front()),
        sheet_(drawing, std::clamp(view.columns, fewest_columns, most_columns)),
        towards_eye_(any_.to_eye()[2] >= 0 ? 1 : -1) {
    for (std::size_t i = 0; i < grids.size(); ++i) {
      facets_.emplace_back(surfaces[i], sheet_);
      areas_.emplace_back(surfaces[i], sheet_);
      shadings_.emplace_back(grids[i], view.colouring);
    }
  }

  void add() {
    if (any_.rows() < 2 || any_.columns() < 2) return;
    for (std::size_t row = any_.rows() - 1; row-- > 0;)
      for (std::size_t column = any_.columns() - 1; column-- > 0;) cell(row, column);
  }

 private:
  void cell(std::size_t row, std::size_t column) {
    turns_.clear();
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      if (!walked_[i].seen[row * (any_.columns() - 1) + column] || !cell_defined(surfaces_[i], row, column)) continue;
      double sum = 0;
      for (const std::size_t corner : corners(row, column)) sum += orders_[i].heights[corner];
      turns_.push_back({sum * towards_eye_, i});
    }
    std::sort(turns_.begin(), turns_.end());
    const std::size_t a = any_.height_index(row, column);
    const std::size_t b = any_.height_index(row + 1, column + 1);
    const std::size_t points = grid_.points();
    colours_.assign(surfaces_.size(), {});
    for (const auto& [sum, i] : turns_) {
      colours_[i] = shadings_[i].colour(std::min(a % points, b % points), std::min(a / points, b / points));
      facets_[i].add(row, column, colours_[i]);
      areas_[i].add(row, column, colours_[i]);
      areas_[i].finish();
    }
    if (!pass(row, column)) return;
    const auto [near, beside, behind, far] = corners(row, column);
    uppermost({far, behind, beside});
    uppermost({near, beside, behind});
  }

  [[nodiscard]] std::array<std::size_t, 4> corners(std::size_t row, std::size_t column) const {
    const std::size_t near = row * any_.columns() + column;
    return {near, near + 1, near + any_.columns(), near + any_.columns() + 1};
  }
  // Whether two of the surfaces seen in the cell pass through each other there.
  [[nodiscard]] bool pass(std::size_t row, std::size_t column) const {
    for (std::size_t i = 0; i < turns_.size(); ++i)
      for (std::size_t j = i + 1; j < turns_.size(); ++j) {
        bool above = false;
        bool below = false;
        for (const std::size_t corner : corners(row, column)) {
          const double difference = difference_at(turns_[i].second, turns_[j].second, corner);
          above = above || difference > 0;
          below = below || difference < 0;
        }
        if (above && below) return true;
      }
    return false;
  }
  [[nodiscard]] double difference_at(std::size_t i, std::size_t j, std::size_t corner) const {
    return orders_[i].heights[corner] - orders_[j].heights[corner];
  }

  using Weights = std::array<double, 3>;  // of the corners of a triangle
  using Part = std::vector<Weights>;

  // Cuts parts of a triangle where a quantity given at its corners changes sign.
  static std::vector<Part> cut(const std::vector<Part>& parts, const std::array<double, 3>& at) {
    std::vector<Part> result;
    const auto value = [&at](const Weights& w) { return w[0] * at[0] + w[1] * at[1] + w[2] * at[2]; };
    for (const Part& part : parts) {
      for (const double side : {1.0, -1.0}) {
        Part piece;
        for (std::size_t i = 0; i < part.size(); ++i) {
          const Weights& p = part[i];
          const Weights& q = part[(i + 1) % part.size()];
          const double from = side * value(p);
          const double to = side * value(q);
          if (from >= 0) piece.push_back(p);
          if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
            const double t = from / (from - to);
            piece.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])});
          }
        }
        if (piece.size() > 2) result.push_back(std::move(piece));
      }
    }
    return result;
  }

  void uppermost(const std::array<std::size_t, 3>& triangle) {
    std::vector<Part> parts{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (std::size_t i = 0; i < turns_.size(); ++i)
      for (std::size_t j = i + 1; j < turns_.size(); ++j) {
        std::array<double, 3> differences{};
        for (std::size_t k = 0; k < 3; ++k) differences[k] = difference_at(turns_[i].second, turns_[j].second, triangle[k]);
        parts = cut(parts, differences);
      }
    std::vector<std::pair<double, const Part*>> order;
    for (const Part& part : parts) order.emplace_back(nearness(triangle, middle(part)), &part);
    std::sort(order.begin(), order.end());
    for (const auto& [near, part] : order) {
      const Weights at = middle(*part);
      std::size_t top = turns_[0].second;
      for (const auto& [sum, i] : turns_) {
        double lead = 0;
        for (std::size_t k = 0; k < 3; ++k) lead += at[k] * difference_at(i, top, triangle[k]);
        if (lead * towards_eye_ > 0) top = i;
      }
      put(triangle, *part, top);
    }
  }
  [[nodiscard]] static Weights middle(const Part& part) {
    Weights sum{};
    for (const Weights& w : part)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += w[k] / static_cast<double>(part.size());
    return sum;
  }
  // How far a point of the plan is towards the eye.
  [[nodiscard]] double nearness(const std::array<std::size_t, 3>& triangle, const Weights& at) const {
    const auto eye = any_.to_eye();
    double near = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t index = any_.height_index(triangle[k] / any_.columns(), triangle[k] % any_.columns());
      near += at[k] * (eye[0] * grid_.x[index % grid_.points()] + eye[1] * grid_.z[index / grid_.points()]);
    }
    return near;
  }
  void put(const std::array<std::size_t, 3>& triangle, const Part& part, std::size_t surface) {
    picture::VectorDrawing& drawing = sheet_.drawing();
    const auto place = [&](const Weights& w) {
      Vertex at{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex& corner = surfaces_[surface].at(triangle[k] / any_.columns(), triangle[k] % any_.columns());
        at.x += static_cast<float>(w[k]) * corner.x;
        at.y += static_cast<float>(w[k]) * corner.y;
      }
      return sheet_.place(at);
    };
    const picture::Colour colour = colours_[surface];
    drawing.areas.push_back({static_cast<std::uint32_t>(drawing.points.size()), static_cast<std::uint32_t>(part.size()), colour});
    for (const Weights& w : part) drawing.points.push_back(place(w));
    for (std::size_t i = 2; i < part.size(); ++i) {
      drawing.facets.push_back({static_cast<std::uint32_t>(drawing.points.size()), 3, colour});
      for (const std::size_t k : {std::size_t{0}, i - 1, i}) drawing.points.push_back(place(part[k]));
    }
  }

  const scene::HeightGrid& grid_;  // the first; all have the same coordinates
  const std::vector<Surface>& surfaces_;
  const std::vector<Walk>& orders_;
  const std::vector<WalkResult>& walked_;
  const Surface& any_;
  Sheet sheet_;
  double towards_eye_;  // 1 if greater heights are nearer to the eye, else -1
  std::vector<Facets> facets_;
  std::vector<Areas> areas_;
  std::vector<Shading> shadings_;
  std::vector<std::pair<double, std::size_t>> turns_;  // surfaces seen in the cell, uppermost last
  std::vector<picture::Colour> colours_;               // of each surface in the cell
};

}  // namespace

picture::Colour surface_colour(std::size_t surface) {
  return surface_colours[surface % surface_colours.size()];
}

picture::VectorDrawing draw(std::span<const scene::HeightGrid> grids, const View& asked) {
  if (grids.size() == 1) return draw(grids[0], asked);
  View view = asked;
  view.family = resolved_family(asked);
  const Family rows = view.subject == Subject::lines ? view.family : Family::along_x;
  picture::VectorDrawing drawing;
  drawing.width = drawing.height = picture_extent;
  std::vector<Surface> surfaces;
  for (const scene::HeightGrid& grid : grids) surfaces.emplace_back(grid, view, rows, grids);
  std::vector<Walk> orders;
  for (std::size_t i = 0; i < grids.size(); ++i) {
    Walk& order = orders.emplace_back(Walk{&surfaces[i], &view, {}, {}, {}});
    if (view.subject == Subject::contours) order.levels = contour_levels(grids[i].range, view);
    measure_heights(order, grids[i]);
    order.first_layer = static_cast<std::uint32_t>(drawing.layers.size());
    name_layers(drawing, order.levels, rows != Family::along_z, i);
  }
  const auto meetings = static_cast<std::uint32_t>(drawing.layers.size());
  drawing.layers.push_back({"intersections", {150, 0, 110}});
  const std::vector<WalkResult> walked = walk(orders, drawing, meetings);
  if (view.subject == Subject::surface) MultiSurfaceFacets(grids, surfaces, orders, walked, view, drawing).add();
  return drawing;
}

picture::VectorDrawing draw(const scene::HeightGrid& grid, const View& view) {
  return draw_by(grid, view, [](const Walk& order, picture::VectorDrawing& drawing) { return walk(order, drawing); });
}

picture::VectorDrawing draw(const scene::HeightGrid& grid, const View& view, Trace& trace) {
  return draw_by(grid, view, [&trace](const Walk& order, picture::VectorDrawing& drawing) { return walk(order, drawing, trace); });
}

}  // namespace sightline::algorithms::skala
