// Step files of the CalComp 565, sent to the emulated plotter, which must draw the drawing within a step.
#include "host/picture/step_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "emulators/devices/calcomp565.hpp"
#include "host/picture/plotter.hpp"

namespace sightline::picture {
namespace {

struct DrawnSteps final : core::StrokeTaker {
  void strokes(std::span<const core::Stroke> strokes) override {
    for (const core::Stroke& stroke : strokes) points.push_back({double(stroke.x), double(stroke.y)});
  }
  std::vector<std::array<double, 2>> points;
};

struct Plotted {
  std::vector<std::array<double, 2>> points;  // in steps
  devices::CalComp565Counts counts;
  bool ended_up = false;
};

Plotted plot_steps(const std::string& file) {
  constexpr core::ClockRate rate{3'000'000};
  DrawnSteps drawn;
  core::StrokeBuffer strokes;
  strokes.hand_to(&drawn);
  devices::CalComp565 plotter(rate, strokes);
  core::TStateInstant now{};
  EXPECT_EQ(file.back(), step_file_end);
  for (const char c : file.substr(0, file.size() - 1)) {
    plotter.write(static_cast<std::uint8_t>(c), now);
    now = plotter.busy_until();
  }
  strokes.flush();
  return {drawn.points, plotter.totals(), !plotter.pen_is_down()};
}

double distance(const std::array<double, 2>& p, const std::array<double, 2>& a, const std::array<double, 2>& b) {
  const double dx = b[0] - a[0];
  const double dy = b[1] - a[1];
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

TEST(StepFile, ThePlotterDrawsTheDrawingWithinAStep) {
  std::mt19937 random(565);
  const Paper paper{200, 180, 10, 0.2};
  VectorDrawing drawing;
  drawing.width = 90;
  drawing.height = 80;
  drawing.layers = {{"one", {}}, {"two", {}}};
  std::vector<std::array<double, 2>> corners;  // in steps from the lower end of the carriage
  for (std::uint32_t i = 0; i < 12; ++i) {
    drawing.lines.push_back({i % 2, static_cast<std::uint32_t>(drawing.points.size()), 2 + i % 3});
    for (std::uint32_t k = 0; k < 2 + i % 3; ++k) {
      const DrawingPoint p{static_cast<float>(random() % 9001) / 100, static_cast<float>(random() % 8001) / 100};
      drawing.points.push_back(p);
      corners.push_back({(10 + 2 * double{p.x}) / 0.254, (10 + 2 * double{p.y} + (279.4 - 180) / 2) / 0.254});
    }
  }
  const std::string file = step_file_of(drawing, paper);
  const Plotted back = plot_steps(file);
  EXPECT_EQ(back.counts.off_carriage + back.counts.off_paper + back.counts.unknown_codes + back.counts.commands_while_busy, 0U);
  EXPECT_EQ(back.counts.pen_lifts, 12U);
  EXPECT_TRUE(back.ended_up);
  // Every step is near a line, and every point of a line is near a step.
  for (const auto& p : back.points) {
    double nearest = 1e9;
    for (const DrawingLine& line : drawing.lines)
      for (std::uint32_t i = 1; i < line.count; ++i)
        nearest = std::min(nearest, distance(p, corners[line.first + i - 1], corners[line.first + i]));
    EXPECT_LE(nearest, 1);
  }
  for (const DrawingLine& line : drawing.lines) {
    for (std::uint32_t i = 1; i < line.count; ++i) {
      for (double t = 0; t <= 1; t += 0.05) {
        const auto& a = corners[line.first + i - 1];
        const auto& b = corners[line.first + i];
        const std::array<double, 2> at{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
        double nearest = 1e9;
        for (const auto& p : back.points) nearest = std::min(nearest, std::hypot(p[0] - at[0], p[1] - at[1]));
        EXPECT_LE(nearest, 1);
      }
    }
  }
  const StepFileTime time = step_file_time(file);
  EXPECT_EQ(time.steps, back.counts.steps);
  EXPECT_EQ(time.pen_commands, back.counts.pen_commands);
  EXPECT_NEAR(time.seconds, double(back.counts.steps) / 300 + double(back.counts.pen_commands) / 10, 1e-3);
}

TEST(StepFile, EveryDirection) {
  VectorDrawing drawing;
  drawing.width = drawing.height = 254;  // a unit is a millimetre
  drawing.layers = {{"", {}}};
  // Around a point, 3 steps in each direction.
  const Paper paper{254, 279.4, 0, 0.2};
  drawing.height = 279.4;
  for (int i = 0; i < 8; ++i) {
    constexpr std::array<int, 8> x{0, 1, 1, 1, 0, -1, -1, -1};
    constexpr std::array<int, 8> y{1, 1, 0, -1, -1, -1, 0, 1};
    const auto first = static_cast<std::uint32_t>(drawing.points.size());
    drawing.points.push_back({25.4F, 25.4F});
    drawing.points.push_back({25.4F + 0.762F * static_cast<float>(x[static_cast<std::size_t>(i)]),
                              25.4F + 0.762F * static_cast<float>(y[static_cast<std::size_t>(i)])});
    drawing.lines.push_back({0, first, 2});
  }
  const std::string file = step_file_of(drawing, paper);
  for (char code = 0; code < 8; ++code)
    EXPECT_NE(file.find("\x09" + std::string(3, code) + "\x08"), std::string::npos) << int{code};
}

TEST(StepFile, LimitsOfTheDrum) {
  const Plotter* const calcomp = find_plotter("calcomp");
  ASSERT_NE(calcomp, nullptr);
  EXPECT_EQ(calcomp->pens, 1);
  EXPECT_EQ(*least_margin(*calcomp, {5000, 200, 10, 0.2}), 0);
  EXPECT_NEAR(*least_margin(*calcomp, {210, 297, 10, 0.2}), 8.8, 1e-9);
  EXPECT_FALSE(least_margin(*calcomp, {17'000, 200, 10, 0.2}));
}

}  // namespace
}  // namespace sightline::picture
