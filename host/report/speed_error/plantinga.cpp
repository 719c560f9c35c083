#include "host/report/speed_error/plantinga.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/event_file.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/report/plantinga_frame_times.hpp"
#include "host/report/plantinga_models.hpp"
#include "host/report/experiments/clock.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::plantinga;
using native::EdgeIndex;
using native::EdgeStructure;

constexpr double degree = std::numbers::pi / 180;
constexpr std::array tried_tolerances{0.0, 0.001, 0.01, 0.1, 1.0};
constexpr std::array step_degrees{0.01, 0.1, 1.0, 3.0, 10.0, 30.0};

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

// A structure as parts, ends placed at one angle.
class Placed {
 public:
  explicit Placed(const native::RotationModel& model) : frame_(model) {}

  void place(double angle) { frame_.place(angle); }
  [[nodiscard]] Parts parts_of(EdgeIndex edge, const EdgeStructure& structure) const {
    Parts parts;
    for (const native::Piece& piece : structure) {
      const double low = frame_.parameter_of(edge, piece.low);
      const double high = frame_.parameter_of(edge, piece.high);
      if (low < high) parts.emplace_back(low, high);
    }
    return parts;
  }

 private:
  native::FrameMaker frame_;
};

// What is true at one angle.
struct Truth {
  double angle = 0;
  std::vector<EdgeStructure> structures;
  std::vector<Parts> parts;
  std::vector<double> lengths;  // of edges in the image
};

std::vector<Truth> truths_of(const native::RotationModel& model, int count) {
  std::vector<std::vector<native::Occluder>> occluders;
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) occluders.push_back(model.occluders_of(edge));
  std::mt19937 random(1990);
  Placed placed(model);
  std::vector<Truth> truths;
  for (int i = 0; i < count; ++i) {
    const double wanted = 2 * std::numbers::pi * (static_cast<double>(random()) / 0x1p32 - 0.5);
    constexpr double scale = 0x1p20;
    const native::Sight sight{std::llround(scale * std::sin(wanted)), std::llround(scale * std::cos(wanted))};
    Truth truth;
    truth.angle = std::atan2(static_cast<double>(sight.x), static_cast<double>(sight.z));
    placed.place(truth.angle);
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      const native::Segment s = model.segment(edge);
      const auto u = [&](const native::Vector3& p) {
        return static_cast<double>(p[0]) * std::cos(truth.angle) -
               static_cast<double>(p[2]) * std::sin(truth.angle);
      };
      truth.lengths.push_back(std::hypot(u(s.to) - u(s.from), static_cast<double>(s.to[1] - s.from[1])));
      truth.structures.push_back(native::structure_at(model, edge, occluders[edge], sight));
      truth.parts.push_back(placed.parts_of(edge, truth.structures.back()));
    }
    truths.push_back(std::move(truth));
  }
  return truths;
}

// held: the frame that is shown at an angle is that of which angle.
void compare(const native::RotationModel& model, const native::EventList& list,
             const std::vector<Truth>& truths, const std::function<double(double)>& held,
             PlantingaPoint& point) {
  native::EdgeStructureGraph graph(list);
  Placed placed(model);
  std::size_t wrong = 0;
  double wrong_length = 0;
  double all_length = 0;
  for (const Truth& truth : truths) {
    const double angle = held(truth.angle);
    static_cast<void>(graph.turn_to(angle));
    placed.place(angle);
    bool same = true;
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
      const EdgeStructure structure = graph.structure_of(edge);
      same = same && structure == truth.structures[edge];
      const Parts shown = placed.parts_of(edge, structure);
      const Parts& seen = truth.parts[edge];
      wrong_length += truth.lengths[edge] * (length(shown) + length(seen) - 2 * in_common(shown, seen));
      all_length += truth.lengths[edge];
    }
    wrong += same ? 0 : 1;
  }
  point.wrong_views = static_cast<double>(wrong) / static_cast<double>(truths.size());
  // Equal places from different sums differ in their last bits.
  const double share = wrong_length / all_length;
  point.wrong_length = share < 1e-12 ? 0 : share;
}

// Groups spread evenly and independently: the share of angles with one between them and the last multiple.
double expected_wrong(std::size_t groups, double degrees) {
  const double each = static_cast<double>(groups) * degrees / 360;
  return each > 0 ? 1 - (1 - std::exp(-each)) / each : 0;
}

PlantingaPoint tolerance_point(const Context& context, const StudiedModel& studied,
                               const std::vector<Truth>& truths, double degrees) {
  native::BuildOptions options;
  options.tolerance = degrees * degree;
  const auto begun = std::chrono::steady_clock::now();
  const auto list = *native::build_event_list(studied.model, options);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
  PlantingaPoint point;
  point.degrees = degrees;
  compare(
      studied.model, list, truths, [](double angle) { return angle; }, point);
  point.expected = expected_wrong(studied.list.events.size(), degrees);
  point.groups = list.events.size();
  point.file_kb = static_cast<double>(native::encode_events(list).size()) / 1024;
  if (!context.host_times) return point;
  point.prepare_s = taken.count();
  point.frame_ns = frame_nanoseconds(studied.model, list, 2, context.full ? 31 : 9);
  return point;
}

PlantingaPoint step_point(const Context& context, const StudiedModel& studied,
                          const std::vector<Truth>& truths, double degrees) {
  PlantingaPoint point;
  point.degrees = degrees;
  const double step = degrees * degree;
  compare(
      studied.model, studied.list, truths, [step](double angle) { return std::floor(angle / step) * step; },
      point);
  point.expected = expected_wrong(studied.list.events.size(), degrees);
  point.groups = studied.list.events.size();
  if (context.host_times)
    point.frame_ns = frame_nanoseconds(studied.model, studied.list, degrees, context.full ? 31 : 9);
  return point;
}

void add_baselines(const Context& context, const StudiedModel& studied, const std::vector<Truth>& truths,
                   PlantingaCurve& curve) {
  double seen = 0;
  double all = 0;
  for (const Truth& truth : truths) {
    for (std::size_t edge = 0; edge < truth.parts.size(); ++edge) {
      seen += truth.lengths[edge] * length(truth.parts[edge]);
      all += truth.lengths[edge];
    }
  }
  curve.hidden_length = 1 - seen / all;
  if (!context.host_times) return;
  native::FrameMaker frame(studied.model);
  std::vector<native::ImageLine> lines;
  const std::vector<std::function<void()>> jobs{
      [&] {
        for (int i = 0; i < 360; ++i) frame.wire(i * degree, lines);
      },
      [&] {
        static_cast<void>(native::visible_edges(studied.model, {3, 5}));
      }};
  const auto times = median_nanoseconds(jobs, 9);
  curve.wire_ns = times[0] / 360;
  curve.scratch_ns = times[1];
}

}  // namespace

Outcome<std::vector<PlantingaCurve>> measure_plantinga(const Context& context) {
  std::vector<std::string_view> names{"squares", "grid"};
  if (context.full) names.insert(names.end(), {"objects", "tori"});
  Context untimed = context;
  untimed.host_times = false;
  std::vector<PlantingaCurve> curves;
  for (const std::string_view name : names) {
    context.progress(fmt::format("{}: angle tolerances", name));
    const auto outcome = study_model(untimed, name);
    if (!outcome) return outcome.error();
    const auto& studied = *outcome;
    const auto truths = truths_of(studied.model, context.full ? 2000 : 500);
    PlantingaCurve curve;
    curve.model = name;
    for (const double tolerance : tried_tolerances)
      curve.tolerances.push_back(tolerance_point(context, studied, truths, tolerance));
    context.progress(fmt::format("{}: steps from frame to frame", name));
    for (const double step : step_degrees) curve.steps.push_back(step_point(context, studied, truths, step));
    add_baselines(context, studied, truths, curve);
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace sightline::harness::report
