#include "host/programs/skala/picture.hpp"

#include <algorithm>
#include <cstdlib>

#include "emulators/devices/calcomp565.hpp"
#include "host/programs/skala/commands.hpp"

namespace sightline::programs::skala {

namespace {

// Follows the pen of the stream.
class Walk {
 public:
  [[nodiscard]] std::uint64_t points() const { return points_; }

  void restart() {
    x_ = 0;
    y_ = 0;
    fresh_ = true;
  }
  void move(int x, int y) {
    if (x == x_ && y == y_) return;
    x_ = x;
    y_ = y;
    fresh_ = true;
  }
  // `hides_only`: the next line steps its last point again.
  void line(int x, int y, bool hides_only = false) {
    points_ += (fresh_ ? 1U : 0U) + static_cast<std::uint64_t>(std::max(std::abs(x - x_), std::abs(y - y_)));
    x_ = x;
    y_ = y;
    fresh_ = hides_only;
  }
  // If nothing is hidden, lines that only hide are movements.
  void jump(int x, int y) {
    x_ = x;
    y_ = y;
    fresh_ = true;
  }
  // If a chain begins with a rim, it begins at the rim's first vertex.
  void rim(int x, int y) {
    if (fresh_) move(x, y);
    line(x, y);
  }

 private:
  std::uint64_t points_ = 0;
  int x_ = 0;
  int y_ = 0;
  bool fresh_ = true;  // the pen's current point has not been stepped
};

// Along the top of each run of visited columns, and back along its bottom.
void walk_outline(const Columns& columns, Walk& walk) {
  const auto visited = [&columns](std::size_t x) { return columns.mask_top[x] != 0 || columns.mask_bottom[x] != 255; };
  for (std::size_t first = 0; first < 256; ++first) {
    if (!visited(first)) continue;
    std::size_t last = first;
    while (last < 255 && visited(last + 1)) ++last;
    const auto column = [](std::size_t x) { return static_cast<int>(x); };
    walk.jump(column(first), columns.mask_top[first]);
    for (std::size_t x = first + 1; x <= last; ++x) walk.line(column(x), columns.mask_top[x]);
    for (std::size_t x = last + 1; x > first; --x) walk.line(column(x - 1), columns.mask_bottom[x - 1]);
    walk.line(column(first), columns.mask_top[first]);
    first = last;
  }
}

}  // namespace

std::uint64_t points_walked(std::span<const std::uint8_t> stream, const Columns& columns) {
  Walk walk;
  bool visibility = true;
  while (!stream.empty()) {
    const auto row = find_command(stream[0]);
    if (!row) break;
    const auto leading = static_cast<std::size_t>(row->leading_arguments);
    if (stream.size() < 1 + leading) break;
    const auto arguments = stream.subspan(1);
    std::size_t length = 1 + leading;
    if (row->bytes_per_item != 0) length += static_cast<std::size_t>(count_of(arguments[leading - 1]) * row->bytes_per_item);
    if (stream.size() < length) break;
    const auto items = stream.subspan(1 + leading, length - 1 - leading);
    switch (row->command) {
      case Command::device: visibility = (arguments[0] & no_visibility) == 0; break;
      case Command::reset: walk.restart(); break;
      case Command::move: walk.move(arguments[0], arguments[1]); break;
      case Command::draw:
      case Command::test_draw: walk.line(arguments[0], arguments[1]); break;
      case Command::mask:
        if (visibility) {
          walk.line(arguments[0], arguments[1], true);
        } else {
          walk.jump(arguments[0], arguments[1]);
        }
        break;
      case Command::rim: walk.rim(arguments[0], arguments[1]); break;
      case Command::curve: {
        int x = arguments[0];
        walk.move(x, items[0]);
        for (const std::uint8_t y : items) walk.line(x++, y);
        break;
      }
      case Command::surface:
        walk.move(items[0], items[1]);
        for (std::size_t i = 3; i < items.size(); i += 3) walk.line(items[i], items[i + 1]);
        break;
      case Command::outline:
        if (visibility) walk_outline(columns, walk);
        break;
      default: break;
    }
    stream = stream.subspan(length);
  }
  return walk.points();
}

PlotterWork plotter_work(std::span<const PlotterMove> moves) {
  PlotterWork work;
  for (const PlotterMove& move : moves) {
    if (move.action == PlotterAction::step) {
      ++(move.pen_down ? work.steps_pen_down : work.steps_pen_up);
      work.time += devices::calcomp565::step;
    } else {
      work.pen_lifts += move.action == PlotterAction::pen_up ? 1 : 0;
      work.time += devices::calcomp565::pen;
    }
  }
  return work;
}

std::vector<picture::PenPath> pen_paths(std::span<const PlotterMove> moves) {
  std::vector<picture::PenPath> paths;
  for (const PlotterMove& move : moves) {
    if (move.action == PlotterAction::pen_down) paths.push_back({{{move.x, move.y}}});
    if (move.action == PlotterAction::step && move.pen_down && !paths.empty())
      picture::extend(paths.back(), {move.x, move.y});
  }
  return paths;
}

}  // namespace sightline::programs::skala
