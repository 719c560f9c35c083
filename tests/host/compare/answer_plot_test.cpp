// The plot of time against error: fronts by hand, positions on logarithmic axes, labels without overlap, escaped texts.
#include "host/compare/answer_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/algorithms/registry/faces.hpp"
#include "host/compare/variants.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::compare {
namespace {

PlotPoint point(double seconds, double wrong, std::string label = "", std::string series = "a") {
  return {PlotPanel::emulated, std::move(series), std::move(label), seconds, wrong};
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

struct Place {
  double x = 0;
  double y = 0;
};

// The positions of the marks, in their order.
std::vector<Place> marks_of(const std::string& svg) {
  const std::regex mark("transform=\"translate\\(([0-9.]+) ([0-9.]+)\\)\" d=");
  std::vector<Place> places;
  for (auto at = std::sregex_iterator(svg.begin(), svg.end(), mark); at != std::sregex_iterator(); ++at)
    places.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
  return places;
}

TEST(Front, HasThePointsThatNoOtherDominates) {
  //                                       0            1            2            3            4              5
  const std::vector<PlotPoint> series{point(1, 5), point(2, 4), point(3, 4), point(2, 1), point(0.5, 9), point(4, 0)};
  // From the fastest on, each point more accurate than all before: 4, 0, 3 (as fast as 1 and more accurate), 5. 2 is slower than
  // 1 and not
  // more accurate.
  EXPECT_EQ(front_of(series), (std::vector<std::size_t>{4, 0, 3, 5}));
  EXPECT_EQ(front_of({point(1, 1), point(1, 1)}), (std::vector<std::size_t>{0})) << "of equal points the first";
  EXPECT_TRUE(front_of({}).empty());
}

TEST(Front, IsFilledAndJoined) {
  const std::string svg = panel_svg({point(1, 5), point(2, 4), point(3, 4), point(2, 1)}, PlotPanel::emulated);
  EXPECT_EQ(count_of(svg, "<path class=\"f0\""), 2U) << "1 s and 5 %, 2 s and 1 %";
  EXPECT_EQ(count_of(svg, "<path class=\"h0\""), 2U);
  EXPECT_EQ(count_of(svg, "<polyline"), 1U);
}

TEST(Medians, AreOfEachSetting) {
  const auto medians = medians_of({point(1, 9, "x"), point(7, 2, "y"), point(3, 1, "x"), point(2, 4, "x"), point(9, 8, "y")});
  ASSERT_EQ(medians.size(), 2U);
  EXPECT_EQ(medians[0].label, "x");
  EXPECT_EQ(medians[0].seconds, 2) << "of 1, 2, 3";
  EXPECT_EQ(medians[0].wrong_percent, 4) << "of 1, 4, 9";
  EXPECT_EQ(medians[1].seconds, 7) << "the lower of 7, 9";
  EXPECT_EQ(medians[1].wrong_percent, 2);
}

TEST(Plot, AxesAreLogarithmic) {
  const auto marks = marks_of(panel_svg({point(0.01, 10), point(0.1, 1), point(1, 0.1), point(1, 0)}, PlotPanel::emulated));
  ASSERT_EQ(marks.size(), 4U);
  EXPECT_NEAR(marks[1].x - marks[0].x, marks[2].x - marks[1].x, 0.11);
  EXPECT_GT(marks[1].x - marks[0].x, 20);
  EXPECT_NEAR(marks[1].y - marks[0].y, marks[2].y - marks[1].y, 0.11);
  EXPECT_GT(marks[1].y - marks[0].y, 20) << "less wrong is lower";
  EXPECT_NEAR(marks[3].x, marks[2].x, 0.11);
  EXPECT_GT(marks[3].y, marks[2].y + 8) << "error 0: in the strip at the bottom";
}

TEST(Plot, LabelsDoNotLieOnEachOtherOrOnMarks) {
  std::vector<PlotPoint> points;
  for (int i = 0; i < 30; ++i)
    points.push_back(
        point(1 + 0.3 * (i % 6), 2 + 0.5 * (i / 6), "setting " + std::to_string(i), "series " + std::to_string(i % 5)));
  for (int i = 0; i < 6; ++i) points.push_back(point(1 + 0.01 * i, 0, "", "exact " + std::to_string(i)));
  const std::string svg = panel_svg(points, PlotPanel::emulated);
  struct Box {
    double left, right, top, bottom;
  };
  std::vector<Box> boxes;
  const std::regex label("<text class=\"(e |m )?(b )?c[0-9]\" x=\"([0-9.]+)\" y=\"([0-9.]+)\">([^<]*)</text>");
  for (auto at = std::sregex_iterator(svg.begin(), svg.end(), label); at != std::sregex_iterator(); ++at) {
    const double width =
        6.5 * static_cast<double>((*at)[5].length());  // 13 units high: narrow letters, so that touching texts are found
    const double x = std::stod((*at)[3]) - ((*at)[1] == "e " ? width : (*at)[1] == "m " ? width / 2 : 0);
    const double base = std::stod((*at)[4]);
    boxes.push_back({x, x + width, base - 9, base + 2});
  }
  EXPECT_GT(boxes.size(), 10U);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Box& a = boxes[i];
      const Box& b = boxes[j];
      EXPECT_FALSE(a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) << i << " lies on " << j;
    }
    for (const Place& mark : marks_of(svg)) {
      const bool on =
          mark.x > boxes[i].left - 3 && mark.x < boxes[i].right + 3 && mark.y > boxes[i].top - 3 && mark.y < boxes[i].bottom + 3;
      EXPECT_FALSE(on) << "label " << i << " at " << boxes[i].left << ", " << boxes[i].top;
    }
  }
}

TEST(Plot, EscapesTexts) {
  const auto svg = plot_svg({point(1, 2, "<script>", "a & \"b\"")}, "<title> & more");
  ASSERT_TRUE(svg);
  EXPECT_EQ(svg->find("<script"), std::string::npos);
  EXPECT_NE(svg->find("&lt;script&gt;"), std::string::npos);
  EXPECT_NE(svg->find("a &amp; "), std::string::npos);
  EXPECT_NE(svg->find("&lt;title&gt; &amp; more"), std::string::npos);
}

TEST(Plot, WithoutPointsIsAnErrorAndAnEmptyPanelSaysSo) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto nothing = plot_svg({point(0, 1), point(none, 1), point(1, none), point(1, -1)}, "t");
  ASSERT_FALSE(nothing);
  EXPECT_TRUE(nothing.error().message().starts_with("nothing to plot: ")) << nothing.error().message();
  EXPECT_NE(panel_svg({point(1, 1)}, PlotPanel::host).find("No times of this computer were measured."), std::string::npos);
  EXPECT_TRUE(plot_svg({point(1, 0)}, "t")) << "one exact method";
}

// --- The points of a scene

std::vector<PlotPoint> of_series(const std::vector<PlotPoint>& points, const std::string& series) {
  std::vector<PlotPoint> found;
  for (const PlotPoint& point : points)
    if (point.series == series) found.push_back(point);
  return found;
}

TEST(Variants, OfASceneOfCellsAreTheBitsWithTheEaeAndWithout) {
  const scene::CellScene house = scene::builtin_scene("house");
  CompareOptions options;
  options.faces = false;
  const auto comparison = compare_cell_scene(house, options);
  ASSERT_TRUE(comparison) << comparison.error().message();
  const auto points = variants_of(house, options, *comparison);
  const auto with = of_series(points, "jones-pdp7 with EAE");
  const auto without = of_series(points, "jones-pdp7 without EAE");
  ASSERT_EQ(with.size(), 4U);
  ASSERT_EQ(without.size(), 4U);
  for (std::size_t bits = 0; bits < 4; ++bits) {
    EXPECT_EQ(with[bits].label, std::to_string(bits) + (bits == 1 ? " bit" : " bits"));
    EXPECT_LT(with[bits].seconds, without[bits].seconds) << "the EAE only saves time";
    EXPECT_EQ(with[bits].wrong_percent, without[bits].wrong_percent);
  }
  // The comparison uses the default setting.
  EXPECT_EQ(with[3].seconds, core::in_seconds(comparison->guest->time));
  for (const PlotPoint& point : points)
    EXPECT_EQ(point.panel, PlotPanel::emulated) << point.series << ": no times of this computer";
}

TEST(Variants, OfPolyhedraAreStripesAndEvents) {
  const auto scene = scene::generate_scene("boxes", 8);
  ASSERT_TRUE(scene);
  const scene::PolyCamera camera = algorithms::plantinga::camera_of({1, 2});
  CompareOptions options;
  options.host_times = true;
  options.methods = {"plantinga", "montani-re"};
  const auto comparison = compare_poly_scene(*scene, camera, options);
  ASSERT_TRUE(comparison) << comparison.error().message();
  const auto points = variants_of(*scene, options, *comparison);
  EXPECT_EQ(of_series(points, "montani-re stripes").size(), static_cast<std::size_t>(std::count_if(registry::stripe_thicknesses.begin(), registry::stripe_thicknesses.end(),
                                                 [](double thickness) { return thickness >= 1; })));
  const auto events = of_series(points, "plantinga events");
  ASSERT_EQ(events.size(), 5U);
  EXPECT_EQ(events.front().label, "0 degrees");
  EXPECT_EQ(events.front().wrong_percent, 0) << "no error between exact events";
  EXPECT_GT(events.back().wrong_percent, 0) << "events 10 degrees late";
  for (const PlotPoint& point : points) EXPECT_GT(point.seconds, 0) << point.series;
  // A method that was not compared has no settings in the plot.
  options.methods = {"exact"};
  const auto exact = compare_poly_scene(*scene, camera, options);
  ASSERT_TRUE(exact);
  EXPECT_EQ(variants_of(*scene, options, *exact).size(), 1U);
}

}  // namespace
}  // namespace sightline::compare
