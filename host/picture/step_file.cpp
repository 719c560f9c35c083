#include "host/picture/step_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "emulators/devices/calcomp565.hpp"

namespace sightline::picture {
namespace {

namespace calcomp = devices::calcomp565;

class StepPen {
 public:
  // Takes the steps nearest to the straight line, including both ends.
  void go_to(std::int64_t x, std::int64_t y) {
    const std::int64_t across = x - x_;
    const std::int64_t up = y - y_;
    const std::int64_t count = std::max(std::abs(across), std::abs(up));
    for (std::int64_t i = 1; i <= count; ++i)
      step(rounded(across * i, count) - rounded(across * (i - 1), count),
           rounded(up * i, count) - rounded(up * (i - 1), count));
    x_ = x;
    y_ = y;
  }
  void lower() { put(down_, true, calcomp::pen_down); }
  void lift() { put(down_, false, calcomp::pen_up); }
  [[nodiscard]] std::string finish() && { return std::move(bytes_) + step_file_end; }

 private:
  // Rounds to the nearest integer, halves away from 0.
  static std::int64_t rounded(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t doubled = 2 * std::abs(numerator) + denominator;
    const std::int64_t whole = doubled / (2 * denominator);
    return numerator < 0 ? -whole : whole;
  }
  void step(std::int64_t across, std::int64_t up) {
    // Clockwise from +y, as in the plotter.
    constexpr std::array<std::array<char, 3>, 3> codes{{{5, 6, 7}, {4, -1, 0}, {3, 2, 1}}};
    bytes_ += codes[static_cast<std::size_t>(across + 1)][static_cast<std::size_t>(up + 1)];
  }
  void put(bool& state, bool wanted, std::uint8_t code) {
    if (state == wanted) return;
    state = wanted;
    bytes_ += static_cast<char>(code);
  }

  std::string bytes_;
  std::int64_t x_ = 0;
  std::int64_t y_ = 0;
  bool down_ = false;
};

}  // namespace

std::string step_file_of(const VectorDrawing& drawing, const Paper& paper) {
  const double across = (paper.width - 2 * paper.margin) / drawing.width;
  const double up = (paper.height - 2 * paper.margin) / drawing.height;
  const double shift = (calcomp::carriage_steps * calcomp_step - paper.height) / 2;
  const auto steps = [](double millimetres) { return static_cast<std::int64_t>(std::floor(millimetres / calcomp_step + 0.5)); };
  StepPen pen;
  const auto go = [&](const DrawingPoint& p) {
    const std::int64_t y = steps(paper.margin + double{p.y} * up + shift);
    pen.go_to(std::max<std::int64_t>(steps(paper.margin + double{p.x} * across), 0),
              std::clamp<std::int64_t>(y, 0, calcomp::carriage_steps));
  };
  for (std::uint32_t layer = 0; layer < drawing.layers.size(); ++layer) {
    for (const DrawingLine& line : drawing.lines) {
      if (line.layer != layer || line.count == 0) continue;
      pen.lift();
      go(drawing.points[line.first]);
      pen.lower();
      for (std::uint32_t i = 1; i < line.count; ++i) go(drawing.points[line.first + i]);
    }
  }
  pen.lift();
  return std::move(pen).finish();
}

StepFileTime step_file_time(std::string_view file) {
  StepFileTime time;
  for (const char c : file) {
    const auto code = static_cast<std::uint8_t>(c);
    time.steps += code < calcomp::pen_up ? 1U : 0U;
    time.pen_commands += code == calcomp::pen_up || code == calcomp::pen_down ? 1U : 0U;
  }
  const auto seconds = [](core::Duration each, std::size_t count) {
    return static_cast<double>(each.count()) * 1e-9 * static_cast<double>(count);
  };
  time.seconds = seconds(calcomp::step, time.steps) + seconds(calcomp::pen, time.pen_commands);
  return time;
}

}  // namespace sightline::picture
