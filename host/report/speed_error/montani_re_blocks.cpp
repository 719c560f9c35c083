#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "host/report/montani_re_growth.hpp"
#include "host/report/speed_error/montani_re.hpp"
#include "host/report/speed_error/plot.hpp"

namespace sightline::harness::report {

namespace {

struct Measure {
  std::string_view key;
  std::string_view title;
  std::string_view unit;
  double (*of)(const MontaniRePoint&);
};
constexpr std::array<Measure, 3> measures{{{"l", "length missing and extra, L_sym(>1 px)", "% of the visible",
                                            [](const MontaniRePoint& p) { return p.symmetric(); }},
                                           {"pmr", "pixels that differ, PMR", "% of the raster",
                                            [](const MontaniRePoint& p) { return p.mismatch(); }},
                                           {"h", "distance of all but one sample in a thousand, H", "pixels",
                                            [](const MontaniRePoint& p) { return p.usual; }}}};

bool timed(const std::vector<MontaniReCurve>& curves) {
  return !curves.empty() && curves.front().points.front().host_ns > 0;
}

Plot plot_of(const std::vector<MontaniReCurve>& curves, const Measure& measure, bool host_time) {
  Plot plot;
  plot.id = fmt::format("montani-re-{}-{}", measure.key, host_time ? "host" : "sides");
  plot.title = fmt::format("Montani and Re, stripes and exact: {} against {}", host_time ? "time" : "sides",
                           measure.title);
  plot.caption =
      host_time ? "A view: relations, list and raster (exact: pieces of edges). Medians of interleaved "
                  "repetitions, of this computer."
                : "Sides of all that is seen: what the differences work on. The exact build's are those of "
                  "its own trapezoids, which do not depend on pixels.";
  plot.alternative =
      fmt::format("Log-log plot of {} against {}, one curve a scene: thinner stripes err less and cost more.",
                  host_time ? "time" : "sides", measure.title);
  plot.host_time = host_time;
  plot.x = {std::string(measure.title), std::string(measure.unit), true, {}};
  plot.y =
      host_time ? Axis{fmt::format("a view, {}", host_title), "ms", true, {}} : Axis{"sides", "", true, {}};
  Curve exact{"exact build", {}, false};
  for (const MontaniReCurve& of : curves) {
    Curve curve{of.scene, {}};
    for (const MontaniRePoint& point : of.points) {
      const double y = host_time ? point.host_ns / 1e6 : static_cast<double>(point.sides);
      if (point.thickness > 0) {
        curve.points.push_back(
            {measure.of(point), y, &of == &curves.front() ? fmt::format("h {}", point.thickness) : ""});
      } else {
        exact.points.push_back({measure.of(point), y, of.scene});
      }
    }
    plot.curves.push_back(std::move(curve));
  }
  plot.curves.push_back(std::move(exact));
  return plot;
}

Table points_table(const std::vector<MontaniReCurve>& curves, const MontaniReMeasure& order) {
  Table table;
  table.id = "montani-re-speed-error";
  table.title = "Montani and Re: stripes of every thickness";
  table.columns = {{"scene", "Scene", "", false},
                   {"thickness", "h", "pixels", false},
                   {"missing", "L_miss(>1 px)", "% of the visible", false},
                   {"extra", "L_extra(>1 px)", "% of the visible", false},
                   {"pmr_edges", "PMR on edges", "% of the raster", false},
                   {"pmr_inside", "PMR inside", "% of the raster", false},
                   {"h", "H", "pixels", false},
                   {"h_usual", "H, all but 1 in 1000", "pixels", false},
                   {"sides", "Sides seen", "", false},
                   {"host_ms", "A view", "ms", true}};
  for (const MontaniReCurve& curve : curves) {
    for (const MontaniRePoint& point : curve.points) {
      table.rows.push_back(
          {curve.scene, point.thickness > 0 ? Cell(Real{point.thickness}) : Cell(std::string("exact")),
           Real{point.missing, 3}, Real{point.extra, 3}, Real{point.on_edges, 4}, Real{point.inside, 4},
           Real{point.hausdorff, 3}, Real{point.usual, 3}, static_cast<std::int64_t>(point.sides),
           point.host_ns > 0 ? Cell(Real{point.host_ns / 1e6}) : Cell()});
    }
  }
  table.notes = {fmt::format(
      "Generated scenes in perspective, all of their faces on {0} x {0} pixels. Lines are compared as sets "
      "of points with those of exact: stripes are drawn as boundaries of what is seen, whose sides do not "
      "say whose edge they are. PMR on edges is of pixels within 0.75 pixels of any edge, seen or hidden. H "
      "is large where a face lower than half a stripe is lost, or a corner that moved past another shows or "
      "hides what it should not. Lines between stripes of a pixel are lines between pixels, so that a level "
      "edge lights the right rows; those of thinner stripes also run through the middles of pixels, where an "
      "edge that is moved onto them takes a row it should not: hence a PMR of the town that does not fall "
      "from 1 to 1/2.",
      order.raster)};
  return table;
}

// Over the thicknesses, not the exact build; empty of fewer than three that are not 0.
Cell exponent(const MontaniReCurve& curve, double (*of)(const MontaniRePoint&)) {
  std::vector<std::pair<double, double>> points;
  for (const MontaniRePoint& point : curve.points) {
    if (point.thickness > 0 && of(point) > 0) points.emplace_back(point.thickness, of(point));
  }
  Cell cell;
  if (points.size() >= 3) cell = Real{growth_exponent(points), 2};
  return cell;
}

Table exponents_table(const std::vector<MontaniReCurve>& curves) {
  Table table;
  table.id = "montani-re-thickness-exponents";
  table.title = "Montani and Re: exponents over the thickness h of stripes";
  table.columns = {{"scene", "Scene", "", false},
                   {"faces", "Faces", "", false},
                   {"l_sym", "L_sym(>1 px)", "", false},
                   {"pmr", "PMR", "", false},
                   {"h_usual", "H, all but 1 in 1000", "", false},
                   {"sides", "Sides seen", "", false},
                   {"host", "Time of a view", "", true}};
  for (const MontaniReCurve& curve : curves) {
    table.rows.push_back(
        {curve.scene, static_cast<std::int64_t>(curve.faces), exponent(curve, measures[0].of),
         exponent(curve, measures[1].of), exponent(curve, measures[2].of),
         exponent(curve, [](const MontaniRePoint& p) { return static_cast<double>(p.sides); }),
         exponent(curve, [](const MontaniRePoint& p) { return p.host_ns; })});
  }
  table.notes = {
      "Expected: error as h (exponent 1), sides and time as 1/h (exponent -1). Least squares of logarithms "
      "from 8 to 1/4 pixels; errors of 0 are left out, and fewer than three others give no exponent: L_sym, "
      "which leaves out what is within a pixel, is 0 as soon as stripes are two pixels or less. Time has a "
      "part that does not depend on h, relations and list."};
  return table;
}

}  // namespace

Outcome<std::vector<Block>> montani_re_error_blocks(const std::vector<MontaniReCurve>& curves,
                                                    const MontaniReMeasure& order) {
  std::vector<Block> blocks;
  blocks.emplace_back(
      Paragraph{"Corners are moved to the nearest line between stripes, edges are straight between them; so "
                "nothing should be farther than half a stripe from its place. L_miss and L_extra are of what "
                "is farther than a pixel from the other picture, in terms of all that is visible; PMR is the "
                "share of pixels that show another face than the exact sight line through their middle "
                "meets; H is the greatest distance between the lines of the pictures."});
  for (const bool host_time : {false, true}) {
    if (host_time && !timed(curves)) continue;
    for (const Measure& measure : measures) {
      if (!host_time && measure.key == "l") continue;
      if (auto error = add_figure(blocks, plot_of(curves, measure, host_time))) return std::move(*error);
    }
  }
  blocks.emplace_back(points_table(curves, order));
  blocks.emplace_back(exponents_table(curves));
  return blocks;
}

Outcome<std::vector<Block>> montani_re_error_part(const Context& context) {
  MontaniReMeasure order;
  if (context.full) {
    order.scene_size = 50;
    order.raster = 512;
    order.rounds = 9;
  }
  if (!context.host_times) order.rounds = 0;
  return montani_re_error_blocks(measure_montani_re(order, context), order);
}

}  // namespace sightline::harness::report
