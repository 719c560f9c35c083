#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "host/report/speed_error/plantinga.hpp"
#include "host/report/speed_error/plot.hpp"

namespace sightline::harness::report {

namespace {

struct Measure {
  std::string_view key;
  std::string_view title;
  double PlantingaPoint::*value;
};
constexpr std::array<Measure, 2> measures{
    {{"topo", "views with any wrong structure, TOPO", &PlantingaPoint::wrong_views},
     {"wvr", "length wrongly seen or hidden, WVR", &PlantingaPoint::wrong_length}}};

bool timed(const std::vector<PlantingaCurve>& curves) {
  return !curves.empty() && curves.front().wire_ns.has_value();
}

std::string label(double degrees) {
  return fmt::format("{}°", degrees);
}

// The wire frame is wrong in all that is hidden, and in every view.
void add_baselines(Plot& plot, const PlantingaCurve& of, const Measure& measure, double frames) {
  const double wire = measure.key == "topo" ? 1 : of.hidden_length;
  plot.curves.push_back(
      {fmt::format("{}, wire frame", of.model), {{100 * wire, frames * *of.wire_ns, ""}}, false});
  plot.curves.push_back(
      {fmt::format("{}, from scratch", of.model), {{0, frames * *of.scratch_ns, ""}}, false});
}

Plot tolerance_plot(const std::vector<PlantingaCurve>& curves, const Measure& measure) {
  Plot plot;
  plot.id = fmt::format("plantinga-tolerance-{}-host", measure.key);
  plot.title = fmt::format("Plantinga, Seales and Dyer: angle tolerance, time of a frame: {}",
                           symbol_of(measure.title));
  plot.caption =
      "Frames 2 degrees apart, positions only; the exact list is at the left, at 0. A tolerance joins events "
      "and saves hardly any time in a frame: most of it goes into positions.";
  plot.alternative =
      "Log plot of the time of a frame against its error: curves are nearly level, hidden-line removal from "
      "scratch lies far above them, the wire frame below.";
  plot.host_time = true;
  plot.x = {std::string(measure.title), "%", true, {}};
  plot.y = {fmt::format("a frame, {}", host_title), "ns", true, {}};
  for (const PlantingaCurve& of : curves) {
    Curve curve{of.model, {}};
    for (const PlantingaPoint& point : of.tolerances)
      curve.points.push_back({100 * (point.*measure.value), *point.frame_ns, label(point.degrees)});
    plot.curves.push_back(std::move(curve));
    add_baselines(plot, of, measure, 1);
  }
  return plot;
}

Plot file_plot(const std::vector<PlantingaCurve>& curves, const Measure& measure) {
  Plot plot;
  plot.id = fmt::format("plantinga-tolerance-{}-file", measure.key);
  plot.title = fmt::format("Plantinga, Seales and Dyer: angle tolerance, size of the event file: {}",
                           symbol_of(measure.title));
  plot.caption =
      "Events that fall into one multiple of the tolerance are one, and changes that cancel go. But a "
      "multiple of the tolerance is a longer number than most events' own directions: only large tolerances "
      "save room, small ones cost it.";
  plot.alternative =
      "Log-log plot of the size of the event file against the error: it grows with the least tolerance and "
      "falls with greater ones.";
  plot.x = {std::string(measure.title), "%", true, {}};
  plot.y = {"event file", "KB", true, {}};
  for (const PlantingaCurve& of : curves) {
    Curve curve{of.model, {}};
    for (const PlantingaPoint& point : of.tolerances)
      curve.points.push_back({100 * (point.*measure.value), point.file_kb, label(point.degrees)});
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Plot step_plot(const std::vector<PlantingaCurve>& curves, const Measure& measure) {
  Plot plot;
  plot.id = fmt::format("plantinga-step-{}-host", measure.key);
  plot.title = "Plantinga, Seales and Dyer: a frame stands until the next, time of a full turn";
  plot.caption =
      "What is shown between two frames is the first of them; its lines are compared with what is true, at "
      "equal places of the edges. Fewer frames, less time, more that is wrong meanwhile.";
  plot.alternative =
      "Log-log plot of the time of a full turn against the error: the more degrees from frame to frame, the "
      "less time and the more error.";
  plot.host_time = true;
  plot.x = {std::string(measure.title), "%", true, {}};
  plot.y = {fmt::format("a full turn, {}", host_title), "us", true, {}};
  for (const PlantingaCurve& of : curves) {
    Curve curve{of.model, {}};
    for (const PlantingaPoint& point : of.steps) {
      curve.points.push_back(
          {100 * (point.*measure.value), *point.frame_ns * 360 / point.degrees / 1000, label(point.degrees)});
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Table table_of(const std::vector<PlantingaCurve>& curves, bool of_steps) {
  Table table;
  table.id = of_steps ? "plantinga-speed-error-step" : "plantinga-speed-error-tolerance";
  table.title = fmt::format("Plantinga, Seales and Dyer: {}",
                            of_steps ? "degrees from frame to frame" : "angle tolerance");
  table.columns = {{"model", "Model", "", false},
                   {"degrees", of_steps ? "Step" : "Tolerance", "degrees", false},
                   {"topo_per_cent", "Wrong views, TOPO", "% of random angles", false},
                   {"expected_per_cent", "Expected", "%", false},
                   {"wvr_per_cent", "WVR", "% of length", false}};
  if (!of_steps) {
    table.columns.push_back({"groups", "Groups of events", "", false});
    table.columns.push_back({"file_kb", "Event file", "KB", false});
    table.columns.push_back({"prepare_s", "Preprocessing", "s, all cores", true});
  }
  table.columns.push_back({"frame_ns", "A frame", "ns", true});
  for (const PlantingaCurve& curve : curves) {
    for (const PlantingaPoint& point : of_steps ? curve.steps : curve.tolerances) {
      std::vector<Cell> row{curve.model, Real{point.degrees}, Real{100 * point.wrong_views},
                            Real{100 * point.expected}, Real{100 * point.wrong_length}};
      if (!of_steps) {
        row.emplace_back(static_cast<std::int64_t>(point.groups));
        row.emplace_back(Real{point.file_kb, 1});
        row.push_back(point.prepare_s ? Cell(Real{*point.prepare_s, 3}) : Cell());
      }
      row.push_back(point.frame_ns ? Cell(Real{*point.frame_ns, 0}) : Cell());
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace

Outcome<std::vector<Block>> plantinga_error_blocks(const std::vector<PlantingaCurve>& curves) {
  std::vector<Block> blocks;
  const bool host = timed(curves);
  for (const Measure& measure : measures) {
    if (auto error = add_figure(blocks, file_plot(curves, measure))) return std::move(*error);
    if (!host) continue;
    if (auto error = add_figure(blocks, tolerance_plot(curves, measure))) return std::move(*error);
  }
  Table tolerances = table_of(curves, false);
  tolerances.notes = {
      "A tolerance moves every event up to its next multiple: late by half of it on average. The expected "
      "share of wrong views follows from the number of groups alone, as if they were spread evenly: groups x "
      "tolerance / 720 where that is small, and never more than groups x tolerance / 360. At tolerance 0 no "
      "view is wrong.",
      "Positions are computed at the true angle, so that a line with the right ends is in the right place."};
  blocks.emplace_back(std::move(tolerances));
  if (host) {
    if (auto error = add_figure(blocks, step_plot(curves, measures.back()))) return std::move(*error);
  }
  blocks.emplace_back(table_of(curves, true));
  return blocks;
}

}  // namespace sightline::harness::report
