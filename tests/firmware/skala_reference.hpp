// firmware/i8080/skala/SPECIFICATION.md in plain C++, for the tests of the program's routines: sequential, with signed numbers,
// without devices and time. It shares only the specification with the program.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sightline::skala_test {

enum class Mode : std::uint8_t { draw, test, mask, plot, surface, rim };
enum class PenMove : std::uint8_t { step, up, down };

struct PlotterStep {
  PenMove kind = PenMove::step;
  int x = 0;
  int y = 0;
  friend bool operator==(const PlotterStep&, const PlotterStep&) = default;
};

class Reference {
 public:
  Reference() { reset_state(); }

  void run(std::span<const std::uint8_t> bytes) {
    std::size_t at = 0;
    auto next = [&] { return static_cast<int>(bytes[at++]); };
    auto count = [&] {
      const int n = next();
      return n == 0 ? 256 : n;
    };
    while (at < bytes.size()) {
      switch (next()) {
        case 0x00: lift(); return;
        case 0x01: {
          const int x = next();
          move(x, next());
          break;
        }
        case 0x02: {
          const int x = next();
          line(x, next(), visible_ ? Mode::draw : Mode::plot);
          break;
        }
        case 0x03: {
          const int x = next();
          line(x, next(), visible_ ? Mode::test : Mode::plot);
          break;
        }
        case 0x04: {
          const int x = next();
          line(x, next(), Mode::mask);
          break;
        }
        case 0x05: colour_ = next() & 7; break;
        case 0x06: commit(); break;
        case 0x07: reset(); break;
        case 0x08: {
          const int x = next();
          const int n = count();
          curve(x, n, bytes.subspan(at));
          at += static_cast<std::size_t>(n);
          break;
        }
        case 0x09: {
          const int n = count();
          surface(n, bytes.subspan(at));
          at += static_cast<std::size_t>(3 * n);
          break;
        }
        case 0x0A: {
          const int d = next();
          device_ = d & 0x7F;
          visible_ = (d & 0x80) == 0;
          break;
        }
        case 0x0B: {
          const int x = next();
          const int y = next();
          rim(x, y, next() & 7);
          break;
        }
        case 0x0C: silhouette_ = next() & 7; break;
        case 0x0D: outline(); break;
        case 0x0E: {
          const int x = next();
          const int n = count();
          std::fill_n(previous_level.begin() + x, n, 0);
          break;
        }
        default: return;
      }
    }
  }

  std::array<std::uint8_t, 65536> picture{};  // [y * 256 + x]
  std::vector<PlotterStep> steps;
  std::array<int, 256> top{}, bottom{}, previous_row{}, previous_level{}, raised_low{}, lowered_high{};
  std::uint64_t walked = 0;
  std::uint64_t lit = 0;  // dots written

 private:
  [[nodiscard]] bool plotter() const { return device_ >= 2; }
  static std::size_t column(int x) { return static_cast<std::size_t>(x); }

  void reset_state() {
    top.fill(0);
    bottom.fill(255);
    previous_level.fill(0);
    raised_low.fill(0);
    lowered_high.fill(255);
    pending_.reset();
    x_ = y_ = 0;
    fresh_ = true;
    colour_ = 7;
    silhouette_ = 0;
    shaded_column_ = -1;
    level_ = 0;
  }
  void reset() {
    reset_state();
    if (plotter()) {
      lift();
      run_.clear();
    } else {
      picture.fill(0);
    }
  }
  void move(int x, int y) {
    if (x != x_ || y != y_) begin(x, y);
  }
  void begin(int x, int y) {
    x_ = x;
    y_ = y;
    fresh_ = true;
    shaded_column_ = -1;
    run_.clear();
  }
  void commit() {
    if (visible_) fold();
    shaded_column_ = -1;
  }

  // Section 3. `level` is for surfaces (section 6).
  void line(int x, int y, Mode mode, int level = 0) {
    if (mode == Mode::mask && !visible_) {
      if (x != x_ || y != y_) run_.clear();
      x_ = x;
      y_ = y;
      fresh_ = true;
      return;
    }
    if (fresh_) {
      step(x_, y_, mode);
      fresh_ = false;
    }
    const int u = std::abs(x - x_), v = std::abs(y - y_);
    const int length = std::max(u, v), minor = std::min(u, v), levels = std::abs(level - level_);
    int e = x >= x_ ? -((length + 1) >> 1) : -((length >> 1) + 1);
    int g = -((length + 1) >> 1);
    const int dx = x > x_ ? 1 : -1, dy = y > y_ ? 1 : -1, di = level > level_ ? 1 : -1;
    for (int i = 0; i < length; ++i) {
      e += minor;
      if (e >= 0) {
        (u >= v ? y_ : x_) += u >= v ? dy : dx;
        e -= length;
      }
      (u >= v ? x_ : y_) += u >= v ? dx : dy;
      if (mode == Mode::surface || mode == Mode::rim) {
        for (g += levels; g >= 0; g -= length) level_ += di;
      }
      step(x_, y_, mode);
    }
    if (mode == Mode::mask) fresh_ = true;
    if (mode == Mode::surface || mode == Mode::rim) level_ = level;
  }
  void curve(int x, int n, std::span<const std::uint8_t> rows) {
    move(x, rows[0]);
    for (int i = 0; i < n; ++i)
      line(x + i, rows[static_cast<std::size_t>(i)], visible_ ? Mode::draw : Mode::plot);
  }

  // Section 4.
  void step(int x, int y, Mode mode) {
    ++walked;
    const int t = top[column(x)], b = bottom[column(x)];
    bool seen = y > t || y < b;
    switch (mode) {
      case Mode::plot: show(x, y, colour_); return;
      case Mode::mask:
        run_.clear();
        touch(x, y);
        return;
      case Mode::test:
        seen = y >= std::max(t - 1, 0) || y <= std::min(b + 1, 255);
        for (const int beside : {x - 1, x + 1})
          if (visited(beside)) seen = seen || y >= top[column(beside)] || y <= bottom[column(beside)];
        break;
      default:
        if (plotter() && !run_.empty()) seen = seen || y == t || y == b;
        if (!visible_) seen = true;
        break;
    }
    if ((mode == Mode::surface || mode == Mode::rim) && !plotter()) {
      shade(x, y, seen, mode == Mode::surface);
    } else if (seen) {
      show(x, y, colour_);
    } else {
      run_.clear();
    }
    if (mode != Mode::test && visible_) touch(x, y);
  }
  void touch(int x, int y) {
    if (pending_ && pending_->x == x) {
      pending_->low = std::min(pending_->low, y);
      pending_->high = std::max(pending_->high, y);
      return;
    }
    fold();
    pending_ = Pending{x, y, y};
  }
  void fold() {
    if (!pending_) return;
    const auto [x, low, high] = *pending_;
    pending_.reset();
    int &t = top[column(x)], &b = bottom[column(x)], &lt = raised_low[column(x)],
        &hb = lowered_high[column(x)];
    if (t == 0 && b == 255) {
      t = high;
      b = low;
      return;
    }
    if (high > t) {
      t = high;
      lt = low;
    } else if (high + 1 < lt) {
      fold_top(x);
      lt = 0;
    }
    if (low < b) {
      b = low;
      hb = high;
    } else if (low > hb + 1) {
      fold_bottom(x);
      hb = 255;
    }
  }
  // Section 7.
  [[nodiscard]] bool visited(int x) const { return x >= 0 && x < 256 && top[column(x)] >= bottom[column(x)]; }
  void fold_top(int x) {
    if (silhouette_ == 0 || plotter()) return;
    int least = top[column(x)];
    if (visited(x - 1) && visited(x + 1))
      least = std::min(top[column(x - 1)], top[column(x + 1)]);
    else if (visited(x - 1))
      least = top[column(x - 1)];
    else if (visited(x + 1))
      least = top[column(x + 1)];
    for (int y = top[column(x)]; y >= std::min(top[column(x)], least + 1); --y) dot(x, y, silhouette_);
  }
  void fold_bottom(int x) {
    if (silhouette_ == 0 || plotter()) return;
    int most = bottom[column(x)];
    if (visited(x - 1) && visited(x + 1))
      most = std::max(bottom[column(x - 1)], bottom[column(x + 1)]);
    else if (visited(x - 1))
      most = bottom[column(x - 1)];
    else if (visited(x + 1))
      most = bottom[column(x + 1)];
    for (int y = bottom[column(x)]; y <= std::max(bottom[column(x)], most - 1); ++y) dot(x, y, silhouette_);
  }

  // Section 6.
  void surface(int n, std::span<const std::uint8_t> vertices) {
    move(vertices[0], vertices[1]);
    level_ = vertices[2] & 7;
    for (std::size_t i = 1; i < static_cast<std::size_t>(n); ++i)
      line(vertices[3 * i], vertices[3 * i + 1], Mode::surface, vertices[3 * i + 2] & 7);
  }
  void rim(int x, int y, int level) {
    if (fresh_) {
      move(x, y);
      level_ = level;
    }
    line(x, y, Mode::rim, level);
  }
  void shade(int x, int y, bool seen, bool filling) {
    const bool first = shaded_column_ != x;
    shaded_column_ = x;
    if (seen && first && filling && previous_level[column(x)] > 0)
      fill(x, y);
    else if (seen)
      dot(x, y, level_);
    previous_row[column(x)] = y;
    previous_level[column(x)] = level_;
  }
  void fill(int x, int y) {
    const int goal = previous_row[column(x)], goal_level = previous_level[column(x)];
    const int n = std::abs(y - goal), levels = std::abs(goal_level - level_);
    int level = level_, g = -((n + 1) >> 1);
    dot(x, y, level);
    for (int i = 0; i < n; ++i) {
      y += goal > y ? 1 : -1;
      for (g += levels; g >= 0; g -= n) level += goal_level > level_ ? 1 : -1;
      if (y == goal || (visible_ && bottom[column(x)] <= y && y <= top[column(x)])) return;
      dot(x, y, level);
    }
  }

  // Section 7.
  void outline() {
    if (!visible_) return;
    fold();
    for (int a = 0; a < 256; ++a) {
      if (!visited(a)) continue;
      int b = a;
      while (visited(b + 1)) ++b;
      begin(a, top[column(a)]);
      for (int x = a; x <= b; ++x) line(x, top[column(x)], Mode::plot);
      for (int x = b; x >= a; --x) line(x, bottom[column(x)], Mode::plot);
      line(a, top[column(a)], Mode::plot);
      a = b;
    }
  }

  // Sections 5 and 8.
  void dot(int x, int y, int value) {
    picture[static_cast<std::size_t>(y) * 256 + static_cast<std::size_t>(x)] =
        static_cast<std::uint8_t>(value);
    ++lit;
  }
  void show(int x, int y, int value) {
    if (!plotter()) return dot(x, y, value);
    run_.emplace_back(x, y);
    if (run_.size() == 1) return;
    if (run_.size() == 2 && !(down_ && pen_ == run_[0])) {
      lift();
      travel(run_[0]);
      down_ = true;
      steps.push_back({PenMove::down, pen_.first, pen_.second});
    }
    travel({x, y});
  }
  void lift() {
    if (!down_) return;
    down_ = false;
    steps.push_back({PenMove::up, pen_.first, pen_.second});
  }
  void travel(std::pair<int, int> to) {
    auto sign = [](int d) { return (d > 0) - (d < 0); };
    while (pen_ != to) {
      pen_.first += sign(to.first - pen_.first);
      pen_.second += sign(to.second - pen_.second);
      steps.push_back({PenMove::step, pen_.first, pen_.second});
    }
  }

  struct Pending {
    int x, low, high;
  };
  std::optional<Pending> pending_;
  int x_ = 0, y_ = 0, colour_ = 7, silhouette_ = 0, device_ = 0, level_ = 0;
  int shaded_column_ = -1;
  bool fresh_ = true, visible_ = true, down_ = false;
  std::vector<std::pair<int, int>> run_;  // the current run of visible points
  std::pair<int, int> pen_{0, 0};
};

}  // namespace sightline::skala_test
