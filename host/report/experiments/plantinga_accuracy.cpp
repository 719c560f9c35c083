// Reference: exact hidden-line removal from scratch, at random angles that are independent of the list of events.
#include "host/report/experiments/plantinga_accuracy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/event_file.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/compare/turn_error.hpp"
#include "host/report/experiments/plantinga_models.hpp"
#include "host/report/experiments/plantinga_turns.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::plantinga;

constexpr double degree = std::numbers::pi / 180;

std::vector<compare::ExactFrame> exact_views(const native::RotationModel& model, int count) {
  std::mt19937 random(1990);
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(2 * std::numbers::pi * (static_cast<double>(random()) / 0x1p32 - 0.5));
  return compare::exact_frames(model, angles);
}

double hidden_percent(const std::vector<compare::ExactFrame>& views) {
  double seen = 0;
  double all = 0;
  for (const compare::ExactFrame& view : views) {
    for (std::size_t edge = 0; edge < view.parts.size(); ++edge) {
      seen += view.lengths[edge] * compare::length_of(view.parts[edge]);
      all += view.lengths[edge];
    }
  }
  return 100 * (1 - seen / all);
}

// The share of angles with an event group between them and the previous multiple of `degrees`, for groups that are
// distributed evenly and independently.
double expected_percent(std::size_t groups, double degrees) {
  const double each = static_cast<double>(groups) * degrees / 360;
  return each > 0 ? 100 * (1 - (1 - std::exp(-each)) / each) : 0;
}

// shown: gives the angle of the frame that is shown at an angle.
TurnErrors errors_of(const StudiedModel& studied, const native::EventList& list, const std::vector<compare::ExactFrame>& views,
                     double degrees, const std::function<double(double)>& shown) {
  const compare::TurnError error = compare::turn_error(studied.model, list, views, shown);
  // Equal positions computed in different ways differ in their last bits.
  const double share = error.wrong_length / error.all_length;
  return {studied.name, degrees, 100 * static_cast<double>(error.wrong_frames) / static_cast<double>(views.size()),
          expected_percent(studied.list.events.size(), degrees), share < 1e-12 ? 0 : 100 * share};
}

// The x axis of a plot, and the error of a model's wire frame on it.
struct ErrorMeasure {
  std::string key;
  double TurnErrors::*value;
  std::string title;
  std::function<double(const std::string& model)> wire_frame;
};

template <class Row>
const Row& of(const std::vector<Row>& rows, std::string_view model, double degrees) {
  return only(rows, [&](const Row& row) { return row.model == model && row.degrees == degrees; });
}

std::string degrees_of(const TurnErrors& errors) {
  return text_of(errors.degrees) + "°";
}

void add_file_plot(Page& page, const std::vector<ToleranceErrors>& tolerances, const ErrorMeasure& error) {
  const auto kb = [&](std::string_view model, double degrees) { return of(tolerances, model, degrees).file_kb; };
  const auto kb_shown = [&](std::string_view model, double degrees) { return text_of(kb(model, degrees), 1); };
  Plot plot;
  plot.id = fmt::format("plantinga-tolerance-{}-file", error.key);
  plot.title = "Plantinga, Seales and Dyer: angle tolerance, size of the event file: " + error.title;
  plot.caption = "Events within one multiple of the tolerance are joined, and changes that cancel are dropped. " +
                 Page::claim(kb("squares", 1) < kb("squares", 0) && kb("squares", 0.001) > kb("squares", 0),
                             "But a multiple of the tolerance is a longer number than the exact direction of most events: only "
                             "large tolerances make the file smaller, small ones make it larger.") +
                 fmt::format(
                     " The file of squares has {} KB with exact directions, {} KB at 0.001 degrees and {} KB at 1 degree; that "
                     "of grid {}, {} and {} KB.",
                     kb_shown("squares", 0), kb_shown("squares", 0.001), kb_shown("squares", 1), kb_shown("grid", 0),
                     kb_shown("grid", 0.001), kb_shown("grid", 1));
  plot.alternative = "Log-log plot of the size of the event file against the error, one curve for each model.";
  plot.x = {error.title, "%"};
  plot.y = {"event file", "KB"};
  add_curves(plot, tolerances, &ToleranceErrors::model, error.value, &ToleranceErrors::file_kb, {.label = &degrees_of});
  page.plot(std::move(plot));
}

void add_frame_plot(Page& page, const std::vector<ToleranceErrors>& tolerances, const PlantingaTurns& times,
                    const ErrorMeasure& error) {
  const auto frame_ns = [&](std::string_view model, double degrees) { return of(times.tolerances, model, degrees).frame_ns; };
  const auto slower = [&](std::string_view model) { return text_of(frame_ns(model, 1) / frame_ns(model, 0), 2); };
  const auto from_scratch = [&](std::string_view model) {
    return text_of(only(times.baselines, equals(&TurnBaseline::model, model)).scratch_ns / frame_ns(model, 0), 0);
  };
  Plot plot;
  plot.id = fmt::format("plantinga-tolerance-{}-host", error.key);
  plot.title = "Plantinga, Seales and Dyer: angle tolerance, time of a frame: " + error.title;
  plot.caption = fmt::format(
      "Frames 2 degrees apart, positions only; the exact list is at the left, at 0. At a tolerance of 1 degree a frame takes {} "
      "times as long as with exact directions for squares, {} times for grid; from scratch {} and {} times.",
      slower("squares"), slower("grid"), from_scratch("squares"), from_scratch("grid"));
  plot.alternative =
      "Log plot of the time of a frame against its error, one curve for each model, with hidden-line removal from scratch and "
      "the wire frame.";
  plot.x = {error.title, "%"};
  plot.y = {"a frame, time on this computer", "ns"};
  add_curves(plot, tolerances, &ToleranceErrors::model, error.value,
             [&](const ToleranceErrors& e) { return frame_ns(e.model, e.degrees); }, {.label = &degrees_of});
  add_curves(
      plot, times.baselines, [](const TurnBaseline& b) { return b.model + ", wire frame"; },
      [&](const TurnBaseline& b) { return error.wire_frame(b.model); }, &TurnBaseline::wire_ns, {.line = false});
  add_curves(
      plot, times.baselines, [](const TurnBaseline& b) { return b.model + ", from scratch"; },
      [](const TurnBaseline&) { return 0.0; }, &TurnBaseline::scratch_ns, {.line = false});
  page.plot(std::move(plot));
}

void add_tolerances_table(Page& page, const PlantingaAccuracy& measured, const PlantingaTurns& times) {
  const double exact = greatest(where(measured.tolerances, equals(&ToleranceErrors::degrees, 0.0)), &ToleranceErrors::topo_per_cent);
  const auto time_of = [&](const ToleranceErrors& e) -> const ToleranceTimes& {
    return of(times.tolerances, e.model, e.degrees);
  };
  page.table("plantinga-speed-error-tolerance", "Plantinga, Seales and Dyer: angle tolerance", measured.tolerances,
             {{"model", "Model", &ToleranceErrors::model},
              {"degrees", "Tolerance", "degrees", &ToleranceErrors::degrees},
              {"topo_per_cent", "Views with a wrong structure", "% of random angles", &ToleranceErrors::topo_per_cent},
              {"expected_per_cent", "Expected", "%", &ToleranceErrors::expected_per_cent},
              {"wvr_per_cent", "Wrong visibility", "% of length", &ToleranceErrors::wvr_per_cent},
              {"groups", "Groups of events", &ToleranceErrors::groups},
              {"file_kb", "Event file", "KB", &ToleranceErrors::file_kb, 1},
              {"prepare_s", "Preprocessing", "s, all cores", [&](const ToleranceErrors& e) { return time_of(e).prepare_s; }, 3,
               host_time},
              {"frame_ns", "A frame", "ns", [&](const ToleranceErrors& e) { return time_of(e).frame_ns; }, 0, host_time}},
             {.notes = {"A tolerance moves every event up to its next multiple: late by half of it on average. The expected "
                        "share of wrong views is computed from the number of groups, assuming an even distribution: groups x "
                        "tolerance / 720 if that is small, and never more than groups x tolerance / 360. " +
                            page.claim(exact == 0, "At tolerance 0 no view is wrong.", text_of(exact) + " % are wrong"),
                        "Positions are computed at the exact angle, so a line with the right ends is in the right place."}});
}

void add_step_plot(Page& page, const std::vector<TurnErrors>& steps, const PlantingaTurns& times) {
  const auto wrong = [&](double degrees) {
    return greatest(where(steps, equals(&TurnErrors::degrees, degrees)), &TurnErrors::wvr_per_cent);
  };
  Plot plot;
  plot.id = "plantinga-step-wvr-host";
  plot.title = "Plantinga, Seales and Dyer: a frame is shown until the next, time of a full turn";
  plot.caption = fmt::format(
      "Between two frames the first of them is shown. Its lines are compared with those of hidden-line removal from scratch, "
      "at equal positions on the edges. A step of 30 degrees is wrong in {} % of the length at most, one of 0.01 degrees in {} "
      "%.",
      text_of(wrong(30), 1), text_of(wrong(0.01), 3));
  plot.alternative = "Log-log plot of the time of a full turn against the error, one curve for each model.";
  plot.x = {"wrong visibility", "%"};
  plot.y = {"a full turn, time on this computer", "us"};
  add_curves(plot, steps, &TurnErrors::model, &TurnErrors::wvr_per_cent,
             [&](const TurnErrors& e) { return 0.36 * of(times.steps, e.model, e.degrees).frame_ns / e.degrees; },
             {.label = &degrees_of});
  page.plot(std::move(plot));
}

}  // namespace

PlantingaAccuracy plantinga_accuracy(const Context& context) {
  Context untimed = context;
  untimed.host_times = false;
  PlantingaAccuracy measured;
  for (const std::string_view name : plantinga_turned_models(context)) {
    context.progress(fmt::format("{}: exact views at random angles", name));
    const StudiedModel studied = study_model(untimed, name);
    const auto views = exact_views(studied.model, context.full ? 2000 : 500);
    context.progress(fmt::format("{}: angle tolerances", name));
    for (const double degrees : plantinga_tolerances) {
      native::BuildOptions options;
      options.tolerance = degrees * degree;
      const auto list = *native::build_event_list(studied.model, options);
      measured.tolerances.push_back({errors_of(studied, list, views, degrees, [](double angle) { return angle; }),
                                     list.events.size(), static_cast<double>(native::encode_events(list).size()) / 1024});
    }
    context.progress(fmt::format("{}: steps from frame to frame", name));
    for (const double degrees : plantinga_steps) {
      const double step = degrees * degree;
      measured.steps.push_back(
          errors_of(studied, studied.list, views, degrees, [step](double angle) { return std::floor(angle / step) * step; }));
    }
    measured.hidden.push_back({studied.name, views.size(), hidden_percent(views)});
  }
  return measured;
}

void plantinga_accuracy_chapter(Page& page, const PlantingaAccuracy& measured, const PlantingaTurns& times) {
  page.paragraph(fmt::format(
      "Models that turn, compared with hidden-line removal from scratch at {} random angles. The measures are: views with a "
      "wrong structure, the share of angles at which any edge has other visible pieces or other ends than it should; and wrong "
      "visibility, the share of the length of all edges in the image that is wrongly visible or hidden.",
      text_of(greatest(measured.hidden, &HiddenShare::views))));
  const ErrorMeasure structure{"topo", &TurnErrors::topo_per_cent, "views with a wrong structure",
                               [](const std::string&) { return 100.0; }};
  const ErrorMeasure visibility{"wvr", &TurnErrors::wvr_per_cent, "wrong visibility", [&](const std::string& model) {
                                  return only(measured.hidden, equals(&HiddenShare::model, model)).hidden_per_cent;
                                }};
  for (const ErrorMeasure& error : {structure, visibility}) add_file_plot(page, measured.tolerances, error);
  if (page.host_times())
    for (const ErrorMeasure& error : {structure, visibility}) add_frame_plot(page, measured.tolerances, times, error);
  add_tolerances_table(page, measured, times);
  if (page.host_times()) add_step_plot(page, measured.steps, times);
  page.table("plantinga-speed-error-step", "Plantinga, Seales and Dyer: degrees from frame to frame", measured.steps,
             {{"model", "Model", &TurnErrors::model},
              {"degrees", "Step", "degrees", &TurnErrors::degrees},
              {"topo_per_cent", "Views with a wrong structure", "% of random angles", &TurnErrors::topo_per_cent},
              {"expected_per_cent", "Expected", "%", &TurnErrors::expected_per_cent},
              {"wvr_per_cent", "Wrong visibility", "% of length", &TurnErrors::wvr_per_cent},
              {"frame_ns", "A frame", "ns", [&](const TurnErrors& e) { return of(times.steps, e.model, e.degrees).frame_ns; }, 0,
               host_time}});
}

}  // namespace sightline::report
