#include "host/programs/skala/twin/drawing.hpp"

namespace sightline::programs::skala {

namespace {

[[nodiscard]] Point point_of(std::span<const std::uint8_t> arguments) {
  return {arguments[0], arguments[1]};
}

[[nodiscard]] std::uint8_t three_bits(std::uint8_t value) {
  return value & 7U;
}

}  // namespace

TwinDrawing::TwinDrawing(TwinPicture& picture, const Equipment& equipment)
    : picture_(picture),
      equipment_(equipment),
      masks_(picture.columns, equipment.direct_masks),
      pen_(picture.moves, picture.counts) {}

bool TwinDrawing::obey(const ReceivedCommand& received) {
  const auto arguments = received.arguments;
  switch (received.command) {
    case Command::end:
      pen_.end_run();
      pen_.lift();
      break;
    case Command::move: move_to(point_of(arguments)); break;
    case Command::draw: line_to(point_of(arguments), Mode::draw); break;
    case Command::test_draw: line_to(point_of(arguments), Mode::test); break;
    case Command::mask: line_to(point_of(arguments), Mode::mask); break;
    case Command::colour: colour_ = three_bits(arguments[0]); break;
    case Command::commit: commit(); break;
    case Command::reset: reset(); break;
    case Command::curve: curve(arguments); break;
    case Command::surface: surface(arguments); break;
    case Command::device: return select_device(arguments[0]);
    case Command::rim: rim(point_of(arguments), three_bits(arguments[2])); break;
    case Command::silhouette: silhouette_ = three_bits(arguments[0]); break;
    case Command::outline: outline(); break;
    case Command::gap: gap(arguments); break;
  }
  return true;
}

bool TwinDrawing::select_device(std::uint8_t argument) {
  const std::uint8_t number = argument & 3U;
  const auto device = static_cast<Device>(number);
  if (!equipment_.present[number] && device != Device::minigraf) return false;
  device_ = device;
  visibility_ = (argument & no_visibility) == 0;
  return true;
}

void TwinDrawing::reset() {
  masks_.reset();
  picture_.columns.previous_level.fill(0);
  at_ = {};
  fresh_ = true;
  shaded_column_.reset();
  level_ = 0;
  colour_ = 7;
  silhouette_ = 0;
  if (on_raster()) {
    picture_.rasters[device_ == Device::alt256 ? 1 : 0].fill(0);
  } else {
    pen_.end_run();
    pen_.lift();
  }
}

void TwinDrawing::move_to(Point point) {
  if (point != at_) set_down(point);
}

void TwinDrawing::set_down(Point point) {
  at_ = point;
  fresh_ = true;
  shaded_column_.reset();
  pen_.end_run();
}

void TwinDrawing::line_to(Point point, Mode mode, std::uint8_t level) {
  mode = effective(mode);
  if (mode == Mode::travel) {
    if (point != at_) pen_.end_run();
  } else {
    if (fresh_) step(at_, mode);
    LevelRamp ramp(level_, level, line_steps(at_, point));
    walk_line(at_, point, [&](Point next) {
      level_ = ramp.next();
      step(next, mode);
    });
  }
  at_ = point;
  fresh_ = mode == Mode::mask || mode == Mode::travel;
  level_ = level;
}

void TwinDrawing::curve(std::span<const std::uint8_t> arguments) {
  std::uint8_t x = arguments[0];
  const auto heights = arguments.subspan(2);
  move_to({x, heights[0]});
  for (const std::uint8_t y : heights) line_to({x++, y}, Mode::draw);
}

// Ends a slice. The next slice enters its first shaded column anew, with or without visibility.
void TwinDrawing::commit() {
  shaded_column_.reset();
  if (visibility_) plot_folds(masks_.fold());
}

void TwinDrawing::outline() {
  if (!visibility_) return;
  plot_folds(masks_.fold());
  for (int first = 0; first < 256; ++first) {
    if (!masks_.visited(static_cast<std::uint8_t>(first))) continue;
    int last = first;
    while (last < 255 && masks_.visited(static_cast<std::uint8_t>(last + 1))) ++last;
    outline_run(first, last);
    first = last;
  }
}

// Draws along the top of the visited columns first..last and back along the bottom.
void TwinDrawing::outline_run(int first, int last) {
  const auto point = [](int x, const std::array<std::uint8_t, 256>& mask) {
    return Point{static_cast<std::uint8_t>(x), mask[static_cast<std::size_t>(x)]};
  };
  const Columns& columns = picture_.columns;
  set_down(point(first, columns.mask_top));
  for (int x = first + 1; x <= last; ++x) line_to(point(x, columns.mask_top), Mode::plain);
  for (int x = last; x >= first; --x) line_to(point(x, columns.mask_bottom), Mode::plain);
  line_to(point(first, columns.mask_top), Mode::plain);
}

TwinDrawing::Mode TwinDrawing::effective(Mode mode) const {
  if ((mode == Mode::surface || mode == Mode::rim) && !on_raster()) mode = Mode::draw;
  if (visibility_) return mode;
  if (mode == Mode::mask) return Mode::travel;
  return mode == Mode::draw || mode == Mode::test ? Mode::plain : mode;
}

void TwinDrawing::step(Point point, Mode mode) {
  ++picture_.counts.points_walked;
  switch (mode) {
    case Mode::draw:
      ink(visible_to_draw(point), point);
      plot_folds(masks_.touch(point));
      break;
    case Mode::test: ink(masks_.outside_with_slack(point), point); break;
    case Mode::mask:
      ink(false, point);
      plot_folds(masks_.touch(point));
      break;
    case Mode::plain: ink(true, point); break;
    case Mode::surface: shade(point, true); break;
    case Mode::rim: shade(point, false); break;
    case Mode::travel: break;
  }
}

// A lowered pen continues along the border of the strip: lifting it for every point that only touches the horizon would
// turn close curves into dots.
bool TwinDrawing::visible_to_draw(Point point) const {
  if (masks_.outside(point)) return true;
  return !on_raster() && pen_.in_run() && masks_.on_border(point);
}

void TwinDrawing::ink(bool visible, Point point) {
  if (on_raster()) {
    if (visible) plot(point, colour_);
  } else if (visible) {
    ++picture_.counts.points_plotted;
    pen_.visible(point);
  } else {
    pen_.end_run();
  }
}

void TwinDrawing::plot(Point point, std::uint8_t colour) {
  ++picture_.counts.points_plotted;
  picture_.rasters[device_ == Device::alt256 ? 1 : 0].set(point.x, point.y, colour);
}

void TwinDrawing::plot_folds(const FoldLines& lines) {
  if (silhouette_ == 0 || !on_raster()) return;
  if (lines.top) plot_fold(*lines.top);
  if (lines.bottom) plot_fold(*lines.bottom);
}

void TwinDrawing::plot_fold(const FoldLine& line) {
  const int step = line.to < line.from ? -1 : 1;
  for (int y = line.from; y != line.to + step; y += step)
    plot({line.x, static_cast<std::uint8_t>(y)}, silhouette_);
}

void PlotterPen::visible(Point point) {
  if (run_points_ == 0) {
    remembered_ = point;
    run_points_ = 1;
    return;
  }
  if (run_points_ == 1) {
    put_down_at(remembered_);
    run_points_ = 2;
  }
  step_towards(point);
}

void PlotterPen::lift() {
  if (!down_) return;
  down_ = false;
  ++counts_.pen_lifts;
  moves_.push_back({PlotterAction::pen_up, at_.x, at_.y, false});
}

void PlotterPen::put_down_at(Point point) {
  if (down_ && at_ == point) return;
  lift();
  while (at_ != point) step_towards(point);
  down_ = true;
  moves_.push_back({PlotterAction::pen_down, at_.x, at_.y, true});
}

void PlotterPen::step_towards(Point point) {
  at_.x = static_cast<std::uint8_t>(at_.x + sign_of(point.x - at_.x));
  at_.y = static_cast<std::uint8_t>(at_.y + sign_of(point.y - at_.y));
  ++(down_ ? counts_.steps_pen_down : counts_.steps_pen_up);
  moves_.push_back({PlotterAction::step, at_.x, at_.y, down_});
}

// The shaded surface: levels along a slice, and between the slice and the one before it. Source:
// firmware/i8080/skala/SPECIFICATION.md section 6.

void TwinDrawing::surface(std::span<const std::uint8_t> arguments) {
  auto vertices = arguments.subspan(1);
  move_to({vertices[0], vertices[1]});
  level_ = vertices[2] & 7U;
  for (vertices = vertices.subspan(3); !vertices.empty(); vertices = vertices.subspan(3))
    line_to({vertices[0], vertices[1]}, Mode::surface, vertices[2] & 7U);
}

// A chain that begins with a rim steps its first vertex at once. If it were left to the next command, as for MOVE, a second
// rim vertex would find the pen fresh again and no rim would ever be drawn.
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

}  // namespace sightline::programs::skala
