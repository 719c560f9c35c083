// Reference: hidden-line removal from scratch, exact, at random angles of which the list of events knows nothing.
#include "host/report/experiments/plantinga_accuracy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/event_file.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/report/experiments/plantinga_models.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::plantinga;
using native::EdgeIndex;
using native::EdgeStructure;

constexpr double degree = std::numbers::pi / 180;

// Visible parts of an edge, from 0 to 1.
using Parts = std::vector<std::pair<double, double>>;

double length(const Parts& parts) {
  double sum = 0;
  for (const auto& [low, high] : parts) sum += high - low;
  return sum;
}

double in_common(const Parts& a, const Parts& b) {
  double sum = 0;
  for (const auto& [low, high] : a)
    for (const auto& [other_low, other_high] : b)
      sum += std::max(0.0, std::min(high, other_high) - std::max(low, other_low));
  return sum;
}

// A structure as parts, ends placed at the frame's angle.
Parts parts_of(const native::FrameMaker& frame, EdgeIndex edge, const EdgeStructure& structure) {
  Parts parts;
  for (const native::Piece& piece : structure) {
    const double low = frame.parameter_of(edge, piece.low);
    const double high = frame.parameter_of(edge, piece.high);
    if (low < high) parts.emplace_back(low, high);
  }
  return parts;
}

// What hidden-line removal from scratch gives at one angle.
struct ExactView {
  double angle = 0;
  std::vector<EdgeStructure> structures;
  std::vector<Parts> parts;
  std::vector<double> lengths;  // of edges in the image
};

std::vector<ExactView> exact_views(const native::RotationModel& model, int count) {
  std::vector<std::vector<native::Occluder>> occluders;
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) occluders.push_back(model.occluders_of(edge));
  std::mt19937 random(1990);
  native::FrameMaker frame(model);
  std::vector<ExactView> views;
  for (int i = 0; i < count; ++i) {
    const double wanted = 2 * std::numbers::pi * (static_cast<double>(random()) / 0x1p32 - 0.5);
    constexpr double scale = 0x1p20;
    const native::Sight sight{std::llround(scale * std::sin(wanted)), std::llround(scale * std::cos(wanted))};
    ExactView view;
    view.angle = std::atan2(static_cast<double>(sight.x), static_cast<double>(sight.z));
    frame.place(view.angle);
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      const native::Segment s = model.segment(edge);
      const auto u = [&](const native::Vector3& p) {
        return static_cast<double>(p[0]) * std::cos(view.angle) - static_cast<double>(p[2]) * std::sin(view.angle);
      };
      view.lengths.push_back(std::hypot(u(s.to) - u(s.from), static_cast<double>(s.to[1] - s.from[1])));
      view.structures.push_back(native::structure_at(model, edge, occluders[edge], sight));
      view.parts.push_back(parts_of(frame, edge, view.structures.back()));
    }
    views.push_back(std::move(view));
  }
  return views;
}

double hidden_percent(const std::vector<ExactView>& views) {
  double seen = 0;
  double all = 0;
  for (const ExactView& view : views) {
    for (std::size_t edge = 0; edge < view.parts.size(); ++edge) {
      seen += view.lengths[edge] * length(view.parts[edge]);
      all += view.lengths[edge];
    }
  }
  return 100 * (1 - seen / all);
}

// Groups of events spread evenly and independently: the share of angles with one between them and the last
// multiple of an angle.
double expected_percent(std::size_t groups, double degrees) {
  const double each = static_cast<double>(groups) * degrees / 360;
  return each > 0 ? 100 * (1 - (1 - std::exp(-each)) / each) : 0;
}

// shown: the frame that is shown at an angle is that of which angle.
TurnErrors errors_of(const StudiedModel& studied, const native::EventList& list, const std::vector<ExactView>& views,
                      double degrees, const std::function<double(double)>& shown) {
  native::EdgeStructureGraph graph(list);
  native::FrameMaker frame(studied.model);
  std::size_t wrong = 0;
  double wrong_length = 0;
  double all_length = 0;
  for (const ExactView& view : views) {
    const double angle = shown(view.angle);
    static_cast<void>(graph.turn_to(angle));
    frame.place(angle);
    bool same = true;
    for (EdgeIndex edge = 0; edge < studied.model.edges().size(); ++edge) {
      const EdgeStructure structure = graph.structure_of(edge);
      same = same && structure == view.structures[edge];
      const Parts parts = parts_of(frame, edge, structure);
      const Parts& seen = view.parts[edge];
      wrong_length += view.lengths[edge] * (length(parts) + length(seen) - 2 * in_common(parts, seen));
      all_length += view.lengths[edge];
    }
    wrong += same ? 0 : 1;
  }
  // Equal places from different sums differ in their last bits.
  const double share = wrong_length / all_length;
  return {studied.name, degrees, 100 * static_cast<double>(wrong) / static_cast<double>(views.size()),
          expected_percent(studied.list.events.size(), degrees), share < 1e-12 ? 0 : 100 * share};
}

}  // namespace

PlantingaAccuracy measure_plantinga_accuracy(const Context& context) {
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
      measured.tolerances.push_back({errors_of(studied, list, views, degrees, [](double angle) { return angle; }), list.events.size(),
                                     static_cast<double>(native::encode_events(list).size()) / 1024});
    }
    context.progress(fmt::format("{}: steps from frame to frame", name));
    for (const double degrees : plantinga_steps) {
      const double step = degrees * degree;
      measured.steps.push_back(errors_of(studied, studied.list, views, degrees,
                                         [step](double angle) { return std::floor(angle / step) * step; }));
    }
    measured.hidden.push_back({studied.name, views.size(), hidden_percent(views)});
  }
  return measured;
}

}  // namespace sightline::report
