#include "host/app/commands/skala_demo.hpp"

#include <fmt/core.h>

#include "host/app/command.hpp"
#include "host/base/json.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::app {

namespace {

using base::Json;
using algorithms::skala::Subject;

constexpr std::string_view plotted_function = "rogers";

programs::skala::Outcome run_program(const scene::HeightFunction& function, Subject subject, programs::skala::Device device,
                               const std::string& directory, std::string_view suffix) {
  SkalaRequest request;
  request.name = function.name;
  programs::skala::Order& order = request.order;
  order.grid = scene::sample(function, subject == Subject::contours ? scene::GridSize{33, 33} : scene::GridSize{33, 60});
  order.view.subject = subject;
  order.view.silhouette = subject == Subject::contours;
  order.view.rotation = 30;
  order.device = device;
  order.time_plain = subject == Subject::lines && device == programs::skala::Device::ef9365;
  order.check = true;
  programs::skala::Outcome outcome = value_of(programs::skala::run(order), request.name);
  write_skala_pictures({directory, fmt::format("{}-{}", function.name, suffix), usual_palette(subject)}, request, outcome);
  return outcome;
}

double seconds(const programs::skala::Outcome& outcome) {
  return core::in_seconds(outcome.picture.drawing);
}

Json json_of(const programs::skala::Outcome& outcome) {
  return {{"t_states", outcome.picture.drawing.count()},
          {"seconds", seconds(outcome)},
          {"visibility_cost_per_cent", outcome.visibility_cost()},
          {"points_walked", outcome.points_walked},
          {"points_lit", outcome.points_lit}};
}

}  // namespace

SkalaDemo run_skala_demo(const std::string& directory) {
  SkalaDemo demo;
  for (const scene::HeightFunction& function : scene::height_functions().first(scene::figure_functions)) {
    const auto raster = [&](Subject picture, std::string_view suffix) {
      return run_program(function, picture, programs::skala::Device::ef9365, directory, suffix);
    };
    demo.rows.push_back({std::string(function.name), raster(Subject::lines, "lines"),
                         raster(Subject::surface, "surface"),
                         raster(Subject::contours, "contours")});
  }
  demo.plotted = plotted_function;
  demo.plot = run_program(*scene::height_function(plotted_function), Subject::lines,
                    programs::skala::Device::calcomp, directory, "calcomp");
  return demo;
}

std::string skala_demo_table(const SkalaDemo& demo) {
  std::string text = fmt::format("{:<11}{:>10}{:>13}{:>10}{:>10}{:>12}{:>12}\n", "function", "lines s",
                                 "visibility", "walked", "lit", "surface s", "contours s");
  for (const SkalaDemoRow& row : demo.rows) {
    text += fmt::format(
        "{:<11}{:>10.3f}{:>13}{:>10}{:>10}{:>12.3f}{:>12.3f}\n", row.function, seconds(row.lines),
        row.lines.visibility_cost() ? fmt::format("{:+.1f} %", *row.lines.visibility_cost()) : "none",
        row.lines.points_walked, row.lines.points_lit, seconds(row.surface), seconds(row.contours));
  }
  text +=
      "Seconds of the emulated 8080 at 3 MHz, 60 slices of 33 points rotated 30 degrees (contours 33 by 33); "
      "the\n"
      "paper: about 2 s, about 15 % for the visibility.\n";
  const programs::skala::PlotterWork& work = demo.plot.plotter;
  text += fmt::format("{} on the CalComp 565: {:.0f} s, {} steps, {} pen lifts.\n", demo.plotted,
                      core::in_seconds(work.time), work.steps_pen_down + work.steps_pen_up, work.pen_lifts);
  return text;
}

void add_skala_demo(Json& document, const SkalaDemo& demo) {
  document["skala"] = Json::array();
  for (const SkalaDemoRow& row : demo.rows) {
    document["skala"].push_back({{"function", row.function},
                                 {"lines", json_of(row.lines)},
                                 {"surface", json_of(row.surface)},
                                 {"contours", json_of(row.contours)}});
  }
  const programs::skala::PlotterWork& work = demo.plot.plotter;
  document["skala_plot"] = {{"function", demo.plotted},
                            {"device", "CalComp 565"},
                            {"seconds", core::in_seconds(work.time)},
                            {"pen_lifts", work.pen_lifts},
                            {"steps_pen_down", work.steps_pen_down},
                            {"steps_pen_up", work.steps_pen_up}};
}

}  // namespace sightline::app
