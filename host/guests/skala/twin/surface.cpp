// The shaded surface: levels along a slice, and from the slice down or up to the one before it. Source:
// firmware/i8080/skala/SPECIFICATION.md section 6.
#include "host/guests/skala/twin/drawing.hpp"

namespace sightline::guests::skala {

void TwinDrawing::surface(std::span<const std::uint8_t> arguments) {
  auto vertices = arguments.subspan(1);
  move_to({vertices[0], vertices[1]});
  level_ = vertices[2] & 7U;
  for (vertices = vertices.subspan(3); !vertices.empty(); vertices = vertices.subspan(3))
    line_to({vertices[0], vertices[1]}, Mode::surface, vertices[2] & 7U);
}

// A chain that begins with a rim makes the step of its first vertex at once: if it were left to what follows,
// as for MOVE, a second rim vertex would find the pen fresh again and no rim would ever be drawn.
void TwinDrawing::rim(Point point, std::uint8_t level) {
  if (fresh_) {
    move_to(point);
    level_ = level;
  }
  line_to(point, Mode::rim, level);
}

void TwinDrawing::gap(std::span<const std::uint8_t> arguments) {
  const int first = arguments[0];
  const int count = count_of(arguments[1]);
  for (int x = first; x < first + count; ++x)
    picture_.columns.previous_level[static_cast<std::size_t>(x)] = 0;
}

void TwinDrawing::shade(Point point, bool may_fill) {
  Columns& columns = picture_.columns;
  const bool visible = !visibility_ || masks_.outside(point);
  const bool entered = shaded_column_ != point.x;
  shaded_column_ = point.x;
  if (visible && entered && may_fill && columns.previous_level[point.x] > 0)
    fill(point, columns.previous_y[point.x], columns.previous_level[point.x]);
  else if (visible)
    plot(point, level_);
  columns.previous_y[point.x] = point.y;
  columns.previous_level[point.x] = level_;
  if (visibility_) plot_folds(masks_.touch(point));
}

void TwinDrawing::fill(Point from, std::uint8_t to_y, std::uint8_t to_level) {
  plot(from, level_);
  const Point to{from.x, to_y};
  const int towards = sign_of(to.y - from.y);
  LevelRamp ramp(level_, to_level, line_steps(from, to));
  while (from != to) {
    from.y = static_cast<std::uint8_t>(from.y + towards);
    const std::uint8_t level = ramp.next();
    if (from == to || (visibility_ && !masks_.outside(from))) return;
    plot(from, level);
  }
}

}  // namespace sightline::guests::skala
