#include "host/app/commands/skala_report.hpp"

#include <fmt/core.h>

#include "host/base/json.hpp"

namespace sightline::app {

namespace {

using base::Json;

std::string megahertz(core::ClockRate clock) {
  return fmt::format("{:g} MHz", static_cast<double>(clock.hertz) / 1e6);
}

std::string_view link_name(programs::skala::Link link) {
  return link == programs::skala::Link::serial ? "serial" : "parallel";
}

// Whether the paper gives times for such a picture. It gives one for all pictures on a raster display, and no number of slices.
bool has_times_in_paper(const programs::skala::Order& order) {
  return is_raster(order.device) && order.view.visibility;
}

std::string plotter_lines(const programs::skala::Order& order, const programs::skala::Outcome& outcome) {
  if (is_raster(order.device)) return {};
  const programs::skala::PlotterWork& work = outcome.plotter;
  return fmt::format(
      "pen lifts        {}\nplotter          {:.1f} s: {} steps with the pen down, {} with the pen up\n",
      work.pen_lifts, core::in_seconds(work.time), work.steps_pen_down, work.steps_pen_up);
}

// The program tests once for the EF9365 board; a missing answer is normal.
bool is_test_for_board(const programs::skala::Unanswered& port) {
  constexpr std::uint8_t ef9365_status = 0x40;
  return port.port == ef9365_status && port.reads == 1 && port.writes == 0;
}

std::string port_lines(const programs::skala::Outcome& outcome) {
  std::string text;
  for (const programs::skala::Unanswered& port : outcome.picture.unanswered)
    if (!is_test_for_board(port))
      text += fmt::format("unanswered       port {:02X}: reads {}, writes {}\n", port.port, port.reads,
                          port.writes);
  return text;
}

Json machine_of(const programs::skala::Order& order, const programs::skala::Outcome& outcome) {
  Json machine{{"device", std::string(name_of(order.device))},
               {"link", std::string(link_name(order.link))},
               {"clock_hz", order.clock.hertz}};
  machine["unanswered_ports"] = Json::array();
  for (const programs::skala::Unanswered& port : outcome.picture.unanswered)
    machine["unanswered_ports"].push_back(
        {{"port", port.port}, {"reads", port.reads}, {"writes", port.writes}});
  return machine;
}

}  // namespace

std::string skala_summary(const SkalaRequest& request, const programs::skala::Outcome& outcome,
                          const std::vector<std::string>& pictures) {
  const programs::skala::Order& order = request.order;
  const programs::skala::MachinePicture& picture = outcome.picture;
  std::string text = fmt::format(
      "{}, {}{}: {} slices of {} points, rotated {:g}, elevation {:g}\n"
      "machine          8080 at {}, {}, {} link\n",
      request.name, name_of(order.view.subject), order.view.visibility ? "" : " without the visibility test",
      order.grid.slices(), order.grid.points(), order.view.rotation, order.view.elevation,
      megahertz(order.clock), name_of(order.device), link_name(order.link));
  const auto seconds_of = [&](core::TStates time) { return core::in_seconds(time, order.clock); };
  text += fmt::format("drawing          {} T-states, {:.3f} s at {}{}\n", picture.drawing.count(),
                      seconds_of(picture.drawing), megahertz(order.clock),
                      has_times_in_paper(order) ? " (the paper: about 2 s)" : "");
  text += fmt::format("with receipt     {} T-states, {:.3f} s: {} bytes of commands in {} block{}\n",
                      picture.total.count(), seconds_of(picture.total), outcome.bytes, picture.blocks,
                      picture.blocks == 1 ? "" : "s");
  if (const auto cost = outcome.visibility_cost()) {
    text += fmt::format("visibility       {:+.1f} per cent of the time without{}\n", *cost,
                        has_times_in_paper(order) ? " (the paper: about 15)" : "");
  }
  text +=
      fmt::format("points walked    {}\npoints lit       {}\n", outcome.points_walked, outcome.points_lit);
  if (outcome.wrong_dots) {
    const programs::skala::WrongDots& wrong = *outcome.wrong_dots;
    text += fmt::format("wrong dots       {}: {} missing, {} extra, without the temporary masks\n", wrong.missing + wrong.extra,
                        wrong.missing, wrong.extra);
  }
  if (picture.dots_not_shown > 0)
    text += fmt::format("not shown        {} dots in the rows above 239\n", picture.dots_not_shown);
  text += plotter_lines(order, outcome) + port_lines(outcome);
  for (const std::string& path : pictures) text += fmt::format("picture          {}\n", path);
  return text;
}

std::string skala_document(const SkalaRequest& request, const programs::skala::Outcome& outcome,
                           const std::vector<std::string>& pictures) {
  const programs::skala::Order& order = request.order;
  const programs::skala::MachinePicture& picture = outcome.picture;
  Json document{{"schema", "sightline/skala/1"},
                {"function", request.name},
                {"picture", std::string(name_of(order.view.subject))},
                {"slices", order.grid.slices()},
                {"points", order.grid.points()},
                {"rotation", order.view.rotation},
                {"elevation", order.view.elevation},
                {"zoom", order.view.zoom},
                {"visibility", order.view.visibility},
                {"machine", machine_of(order, outcome)},
                {"status", std::string(text_of(picture.status))},
                {"t_states", picture.drawing.count()},
                {"seconds", core::in_seconds(picture.drawing, order.clock)},
                {"total_t_states", picture.total.count()},
                {"instructions", picture.instructions},
                {"command_bytes", outcome.bytes},
                {"blocks", picture.blocks},
                {"points_walked", outcome.points_walked},
                {"points_lit", outcome.points_lit},
                {"dots_not_shown", picture.dots_not_shown}};
  document["visibility_cost_per_cent"] = outcome.visibility_cost();
  if (!is_raster(order.device)) {
    document["plotter"] = {{"seconds", core::in_seconds(outcome.plotter.time)},
                           {"pen_lifts", outcome.plotter.pen_lifts},
                           {"steps_pen_down", outcome.plotter.steps_pen_down},
                           {"steps_pen_up", outcome.plotter.steps_pen_up}};
  }
  if (order.direct_masks) document["direct_masks"] = true;
  if (outcome.wrong_dots) document["wrong_dots"] = {{"missing", outcome.wrong_dots->missing}, {"extra", outcome.wrong_dots->extra}};
  document["pictures"] = pictures;
  // Names of functions and files come from the user: bytes that are not UTF-8 are replaced.
  return document.dump(2) + "\n";
}

}  // namespace sightline::app
