// Plots: the scripts for gnuplot, and that it draws them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "host/report/plot.hpp"

namespace sightline::report {
namespace {

Plot sample_plot() {
  Plot plot;
  plot.id = "plot";
  plot.title = "Time against error";
  plot.x = {"error", "px", true};
  plot.y = {"time `touch here`", "s", true};
  plot.curves = {{"the \"house\" & <co>'s", {{0, 0.5, "exact"}, {0.02, 0.1, "24 bits"}, {3, 0.05}}},
                 {"lost", {{-1, 1}, {std::numeric_limits<double>::quiet_NaN(), 1}}}};
  return plot;
}

TEST(ReportPlot, PutsZeroADecadeBelowTheLeastError) {
  const std::string script = gnuplot_script(sample_plot());
  EXPECT_NE(script.find("set xtics add (\"0\" 0.001"), std::string::npos) << script;
  EXPECT_EQ(script.find("set ytics add"), std::string::npos);
  EXPECT_NE(script.find("set xlabel 'error [px]'"), std::string::npos);
}

TEST(ReportPlot, OmitsPointsThatALogarithmicAxisCannotShow) {
  const std::string script = gnuplot_script(sample_plot());
  EXPECT_NE(script.find("$curve1 << END_OF_CURVE\nEND_OF_CURVE\n"), std::string::npos) << script;
  EXPECT_EQ(script.find("plot $curve1"), std::string::npos);
}

// The style of a curve without its colour.
std::string marks_of_curve(const std::string& script, std::size_t curve) {
  const std::string command = "$curve" + std::to_string(curve) + " using 1:2 with ";
  const std::size_t from = script.find(command) + command.size();
  std::string marks = script.substr(from, script.find("title", from) - from);
  const std::size_t colour = marks.find("rgb \"");
  return marks.erase(colour, marks.find('"', colour + 5) + 1 - colour);
}

TEST(ReportPlot, CurvesDifferWithoutColour) {
  Plot plot = sample_plot();
  const Curve curve = plot.curves.front();
  plot.curves.assign(9, curve);
  for (const bool marked : {true, false}) {
    for (Curve& lines : plot.curves) lines.points_marked = marked;
    const std::string script = gnuplot_script(plot);
    for (std::size_t a = 0; a < 9; ++a) {
      for (std::size_t b = marked || a < 5 ? 0 : a - 4; b < a; ++b)
        EXPECT_NE(marks_of_curve(script, a), marks_of_curve(script, b)) << a << ' ' << b;
    }
  }
  plot.curves[1].line = false;
  EXPECT_EQ(marks_of_curve(gnuplot_script(plot), 1).find("dt"), std::string::npos) << "points have no dashes";
}

TEST(ReportPlot, LongNamesLeaveRoomForThePlot) {
  Plot plot = sample_plot();
  EXPECT_NE(gnuplot_script(plot).find("set key outside right"), std::string::npos);
  plot.curves[0].name = "a town of turned houses, seen in plan";
  EXPECT_NE(gnuplot_script(plot).find("set key outside bottom"), std::string::npos);
}

TEST(ReportPlot, IsDrawnTheSameTwiceAndRunsNothingElse) {
  const auto first = draw_plot(sample_plot());
  const auto second = draw_plot(sample_plot());
  ASSERT_TRUE(first) << first.error().message();
  const auto& figure = *first;
  EXPECT_EQ(figure.media_type, "image/svg+xml");
  EXPECT_EQ(figure.bytes, second->bytes);
  const std::string svg(figure.bytes.begin(), figure.bytes.end());
  EXPECT_NE(svg.find("`touch here`"), std::string::npos);
  EXPECT_NE(svg.find("the \"house\" &amp; &lt;co>'s"), std::string::npos) << svg;
  EXPECT_NE(svg.find("24 bits"), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

// The renderer omits such plots; a defect there must not give an empty picture.
TEST(ReportPlot, WithoutAPointIsAnError) {
  Plot plot = sample_plot();
  plot.curves.erase(plot.curves.begin());
  const auto drawn = draw_plot(plot);
  ASSERT_FALSE(drawn);
  EXPECT_EQ(drawn.error().kind, base::ErrorKind::io);
  EXPECT_NE(drawn.error().message().find("plot: gnuplot drew nothing"), std::string::npos) << drawn.error().message();
}

TEST(ReportPlot, AMissingGnuplotIsReported) {
  const char* const path = std::getenv("PATH");
  const std::string kept = path == nullptr ? "" : path;
  ASSERT_EQ(setenv("PATH", "/nonexistent", 1), 0);
  const auto missing = gnuplot_missing();
  const auto drawn = draw_plot(sample_plot());
  ASSERT_EQ(setenv("PATH", kept.c_str(), 1), 0);
  ASSERT_TRUE(missing);
  EXPECT_EQ(missing->kind, base::ErrorKind::io);
  EXPECT_EQ(drawn.error().kind, base::ErrorKind::io);
  EXPECT_NE(missing->message().find("gnuplot-nox"), std::string::npos);
  EXPECT_FALSE(gnuplot_missing());
}

}  // namespace
}  // namespace sightline::report
