#include "host/report/experiments/plantinga_turns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/table_1.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::plantinga;
using Job = std::function<void()>;

constexpr int frames_in_a_turn = 360;
constexpr double degree = std::numbers::pi / 180;
constexpr std::size_t side = 1024;  // pixels

// The cheapest display: one pixel per step along a line's longer side.
class Canvas {
 public:
  explicit Canvas(const native::RotationModel& model) : pixels_(side * side) {
    double reach = 1;
    for (const auto& v : model.vertices()) {
      reach = std::max(
          {reach, std::hypot(static_cast<double>(v[0]), static_cast<double>(v[2])), std::abs(static_cast<double>(v[1]))});
    }
    scale_ = 0.49 * static_cast<double>(side) / reach;
  }

  void draw(const std::vector<native::ImageLine>& lines) {
    for (const native::ImageLine& line : lines) {
      const double dx = (line.u1 - line.u0) * scale_;
      const double dy = (line.v1 - line.v0) * scale_;
      const int steps = static_cast<int>(std::max(std::abs(dx), std::abs(dy))) + 1;
      double x = static_cast<double>(side) / 2 + line.u0 * scale_;
      double y = static_cast<double>(side) / 2 + line.v0 * scale_;
      for (int i = 0; i <= steps; ++i, x += dx / steps, y += dy / steps)
        pixels_[(static_cast<std::size_t>(y) % side) * side + static_cast<std::size_t>(x) % side] = 255;
    }
  }

 private:
  std::vector<std::uint8_t> pixels_;
  double scale_ = 1;
};

// The common data of all jobs on one model. A list that was just made or read fits its graph, so no step fails.
class Turntable {
 public:
  Turntable(const native::RotationModel& model, const native::EventList& list) : graph_(list), frame_(model), canvas_(model) {}

  void turn() { static_cast<void>(graph_.turn_to(angle_)); }
  void image() {
    turn();
    frame_.visible(graph_, angle_, lines_);
  }
  void space() {
    turn();
    frame_.visible_in_space(graph_, angle_, space_lines_);
  }
  void wire() { frame_.wire(angle_, lines_); }
  void image_drawn() {
    image();
    canvas_.draw(lines_);
  }
  void wire_drawn() {
    wire();
    canvas_.draw(lines_);
  }
  void step_forward() { static_cast<void>(graph_.step_forward()); }

  // 360 frames.
  [[nodiscard]] Job rotation(double step, void (Turntable::*frame)()) {
    return [this, step, frame] {
      for (int i = 0; i < frames_in_a_turn; ++i) {
        angle_ = std::remainder(angle_ + step * degree, 2 * std::numbers::pi);
        (this->*frame)();
      }
    };
  }

 private:
  native::EdgeStructureGraph graph_;
  native::FrameMaker frame_;
  Canvas canvas_;
  double angle_ = 0;
  std::vector<native::ImageLine> lines_;
  std::vector<native::SpaceLine> space_lines_;
};

TurnModel turn_model(const StudiedModel& studied) {
  const auto row = native::table_1_row(studied.name, studied.model, studied.list, 0);
  return {.model = studied.name,
          .vertices = row.vertices,
          .edges = row.edges,
          .faces = row.faces,
          .events = row.events,
          .groups = row.directions,
          .kb = row.kilobytes,
          .per_edge = row.events_per_edge,
          .most = row.most_events_per_edge,
          .times = studied.times,
          .from_cache = studied.from_cache};
}

TurnFrames turn_frames(const StudiedModel& studied, int rounds) {
  Turntable table(studied.model, studied.list);
  const std::array<std::pair<double TurnFrames::*, Job>, 10> jobs{{
      {&TurnFrames::image_2_ns, table.rotation(2, &Turntable::image)},
      {&TurnFrames::image_6_ns, table.rotation(6, &Turntable::image)},
      {&TurnFrames::image_30_ns, table.rotation(30, &Turntable::image)},
      {&TurnFrames::space_2_ns, table.rotation(2, &Turntable::space)},
      {&TurnFrames::space_30_ns, table.rotation(30, &Turntable::space)},
      {&TurnFrames::steps_ns, table.rotation(2, &Turntable::turn)},
      {&TurnFrames::wire_ns, table.rotation(2, &Turntable::wire)},
      {&TurnFrames::image_drawn_ns, table.rotation(2, &Turntable::image_drawn)},
      {&TurnFrames::wire_drawn_ns, table.rotation(2, &Turntable::wire_drawn)},
      {&TurnFrames::event_ns, table.rotation(0, &Turntable::step_forward)},
  }};
  std::vector<Job> work;
  for (const auto& [member, job] : jobs) work.push_back(job);
  const auto times = median_nanoseconds(work, rounds);
  TurnFrames row;
  row.model = studied.name;
  for (std::size_t i = 0; i < jobs.size(); ++i) row.*jobs[i].first = times[i] / frames_in_a_turn;
  return row;
}

double frame_nanoseconds(const native::RotationModel& model, const native::EventList& list, double step, int rounds) {
  Turntable table(model, list);
  const std::array jobs{table.rotation(step, &Turntable::image)};
  return median_nanoseconds(jobs, rounds).front() / frames_in_a_turn;
}

void add_tolerances(std::vector<ToleranceTimes>& rows, const StudiedModel& studied, int rounds) {
  for (const double degrees : plantinga_tolerances) {
    native::BuildOptions options;
    options.tolerance = degrees * degree;
    const auto begun = std::chrono::steady_clock::now();
    const auto list = *native::build_event_list(studied.model, options);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    rows.push_back({studied.name, degrees, taken.count(), frame_nanoseconds(studied.model, list, 2, rounds)});
  }
}

void add_steps(std::vector<StepTimes>& rows, const StudiedModel& studied, int rounds) {
  for (const double degrees : plantinga_steps)
    rows.push_back({studied.name, degrees, frame_nanoseconds(studied.model, studied.list, degrees, rounds)});
}

TurnBaseline baseline_of(const StudiedModel& studied) {
  native::FrameMaker frame(studied.model);
  std::vector<native::ImageLine> lines;
  const std::array<Job, 2> jobs{[&] {
                                  for (int i = 0; i < frames_in_a_turn; ++i) frame.wire(i * degree, lines);
                                },
                                [&] {
                                  static_cast<void>(native::visible_edges(studied.model, {3, 5}));
                                }};
  const auto times = median_nanoseconds(jobs, 9);
  return {studied.name, times[0] / frames_in_a_turn, times[1]};
}

// A row of the paper's Table 1.
struct PrintedModel {
  std::string model;
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t events = 0;
  double kb = 0;
  double per_edge = 0;
  std::size_t most = 0;
  double construction_s = 0;

  [[nodiscard]] double events_an_edge() const { return static_cast<double>(events) / static_cast<double>(edges); }
  // Except for rounding.
  [[nodiscard]] bool agrees_with_itself() const { return std::abs(events_an_edge() - per_edge) <= 0.0501; }
  [[nodiscard]] bool has_numbers_of(const TurnModel& here) const {
    return vertices == here.vertices && edges == here.edges && faces == here.faces;
  }
};

struct PrintedTable1 {
  explicit PrintedTable1(const Papers& papers) {
    const PrintedTable& table = papers.table("plantinga_table_1");
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const auto count = [&](std::string_view key) { return static_cast<std::size_t>(table.number(i, key)); };
      rows.push_back({table.text(i, "model"), count("vertices"), count("edges"), count("faces"), count("events"),
                      table.number(i, "kb"), table.number(i, "per_edge"), count("most"), table.number(i, "construction_s")});
    }
  }
  [[nodiscard]] const PrintedModel& of(const std::string& model) const { return only(rows, equals(&PrintedModel::model, model)); }
  // A column with the value from the row of the same model.
  template <class T>
  [[nodiscard]] auto column(T PrintedModel::*member) const {
    return [this, member](const TurnModel& here) { return of(here.model).*member; };
  }

  std::vector<PrintedModel> rows;
};

void add_table_1(Page& page, const PlantingaTurns& turns, const PrintedTable1& printed) {
  const std::vector<TurnModel>& models = turns.models;
  const std::size_t same = count(models, [&](const TurnModel& m) { return printed.of(m.model).has_numbers_of(m); });
  const PrintedModel& grid = printed.of("grid");
  std::vector<CheckedText> notes{
      "The paper gives the numbers of vertices, edges and faces of its models, but not the positions and directions of their "
      "parts; an exact comparison would need their coordinates. The models here have the same numbers" +
          page.claim(same == models.size(), ", all of them", fmt::format("{} of {} have them", same, models.size())) +
          ". They are degenerate on purpose, with edges of one height, parallel edges and mirrored parts, so that many events "
          "coincide. Compare magnitudes, not digits. Tori and Spring are the most similar to the paper's.",
      fmt::format("The paper's events are changes of single edges: events per edge times edges is the printed number of events "
                  "in {} of {} rows. In the row Grid, {} events of {} edges are {} per edge, printed {} (hard case P22). A "
                  "group is all changes at one direction; directions are compared exactly.",
                  count(printed.rows, &PrintedModel::agrees_with_itself), printed.rows.size(), text_of(grid.events),
                  text_of(grid.edges), text_of(grid.events_an_edge(), 1), text_of(grid.per_edge, 1)),
      fmt::format("KB are 1024 bytes. A change in the file here stores only the pieces that appear; those that disappear are "
                  "known. {}",
                  models.size() < printed.rows.size()
                      ? "Spring takes longer to prepare than the other models together; --full includes it."
                      : "")};
  if (page.host_times())
    notes.emplace_back(count(models, &TurnModel::from_cache) > 0
                           ? "Events and the times of their construction are from an earlier report."
                           : "Times of construction are wall-clock times.");
  const auto construction = [](double StudyTimes::*member) {
    return [member](const TurnModel& m) { return m.times ? std::optional((*m.times).*member) : std::nullopt; };
  };
  page.table("plantinga-table-1", "Plantinga, Seales and Dyer: Table 1, as printed and here", models,
             {{"model", "Model", &TurnModel::model},
              {"vertices", "Vertices", &TurnModel::vertices},
              {"edges", "Edges", &TurnModel::edges},
              {"faces", "Faces", &TurnModel::faces},
              {"printed_events", "Events", "printed", printed.column(&PrintedModel::events)},
              {"events", "Events", "here: changes of edges", &TurnModel::events},
              {"groups", "Groups", "here: different directions", &TurnModel::groups},
              {"printed_kb", "Event data", "KB, printed", printed.column(&PrintedModel::kb), 0},
              {"kb", "Event file", "KB, here", &TurnModel::kb, 1},
              {"bytes_an_event", "Bytes an event", "here",
               [](const TurnModel& m) { return 1024 * m.kb / static_cast<double>(m.events); }, 1},
              {"printed_per_edge", "Events an edge", "printed", printed.column(&PrintedModel::per_edge), 1},
              {"per_edge", "Events an edge", "here", &TurnModel::per_edge, 1},
              {"printed_most", "Most of an edge", "printed", printed.column(&PrintedModel::most)},
              {"most", "Most of an edge", "here", &TurnModel::most},
              {"printed_s", "Construction", "s, printed, RS/6000-320", printed.column(&PrintedModel::construction_s), 0},
              {"one_core_s", "Construction", "s, one core here", construction(&StudyTimes::one_core_s), 3, host_time},
              {"all_cores_s", "Construction", "s, all cores here", construction(&StudyTimes::all_cores_s), 3, host_time},
              {"events_found_a_second", "Events found a second", "one core here",
               [](const TurnModel& m) {
                 return m.times ? std::optional(static_cast<double>(m.events) / m.times->one_core_s) : std::nullopt;
               },
               0, host_time}},
             {.notes = std::move(notes)});
}

// The row of a model in the paper's Table 2, in frames per second.
std::size_t row_of(const PrintedTable& table_2, std::string_view model) {
  for (std::size_t i = 0; i < table_2.rows.size(); ++i)
    if (table_2.text(i, "model") == model) return i;
  throw std::logic_error(fmt::format("Table 2 has no row {}", model));
}

void add_table_2(Page& page, const std::vector<TurnFrames>& frames) {
  const PrintedTable& table_2 = page.papers().table("plantinga_table_2");
  const auto printed = [&table_2](std::string_view key) {
    return [&table_2, key](const TurnFrames& f) { return table_2.cell(row_of(table_2, f.model), key); };
  };
  const auto here = [](double TurnFrames::*ns) { return [ns](const TurnFrames& f) { return 1e9 / (f.*ns); }; };
  page.table(
      "plantinga-table-2", "Plantinga, Seales and Dyer: Table 2, as printed and here, frames a second", frames,
      {{"model", "Model", &TurnFrames::model},
       {"printed_image_2", "2-D hardware, 2°", "printed", printed("image_2")},
       {"image_2", "2-D hardware, 2°", "here", here(&TurnFrames::image_2_ns), 0},
       {"printed_image_6", "2-D hardware, 6°", "printed", printed("image_6")},
       {"image_6", "2-D hardware, 6°", "here", here(&TurnFrames::image_6_ns), 0},
       {"printed_image_30", "2-D hardware, 30°", "printed", printed("image_30")},
       {"image_30", "2-D hardware, 30°", "here", here(&TurnFrames::image_30_ns), 0},
       {"printed_space_2", "3-D hardware, 2°", "printed", printed("space_2")},
       {"space_2", "3-D hardware, 2°", "here", here(&TurnFrames::space_2_ns), 0},
       {"printed_space_30", "3-D hardware, 30°", "printed", printed("space_30")},
       {"space_30", "3-D hardware, 30°", "here", here(&TurnFrames::space_30_ns), 0}},
      {.notes = {"As in the paper: rotations of 360 frames, the event structure brought up to date and the image coordinates of "
                 "every vector computed (2-D), or its coordinates in space (3-D); nothing drawn. Their computer was an IBM "
                 "RS/6000 model 320; here it is one core of this computer, medians of repeated rotations."}});
}

// Checks the claim that a frame is about as fast as the wire frame, from ratios of both.
std::string within_limit(const std::vector<TurnFrames>& frames, double (TurnFrames::*ratio)() const) {
  const std::size_t slow = count(frames, [ratio](const TurnFrames& f) { return (f.*ratio)() > 1.5; });
  return slow == 0 ? "the claim holds"
                   : fmt::format("the claim does not hold for {} of {} models (limit 1.5 times)", slow, frames.size());
}

void add_claims(Page& page, const PlantingaTurns& turns) {
  const std::vector<TurnModel>& models = turns.models;
  const double limit = page.paper_figure("plantinga.events_per_edge").least;
  const std::size_t more = count(models, [limit](const TurnModel& m) { return m.per_edge >= limit; });
  std::vector<ClaimRow> rows{
      {.claim = "plantinga.events_per_edge",
       .here = least_and_greatest(models, &TurnModel::per_edge),
       .places = 1,
       .condition = fmt::format("changes of edges for each edge, {} models", models.size()),
       .comparison = more == 0 ? "less here as well" : fmt::format("more here for {} of {} models", more, models.size())}};
  if (page.host_times()) {
    const PrintedTable& table_2 = page.papers().table("plantinga_table_2");
    const auto printed_ratio = [&table_2](std::string_view model) {
      const std::size_t row = row_of(table_2, model);
      return table_2.number(row, "image_2") / table_2.number(row, "image_30");
    };
    rows.push_back({.claim = "plantinga.step",
                    .here = least_and_greatest(turns.frames, &TurnFrames::step_ratio),
                    .places = 2,
                    .condition = "a frame after 30 degrees to one after 2 degrees, image coordinates",
                    .comparison = fmt::format("by Table 2 {} times for squares, {} for tori. {}",
                                              text_of(printed_ratio("squares"), 2), text_of(printed_ratio("tori"), 2),
                                              greatest(turns.frames, &TurnFrames::step_ratio) > printed_ratio("squares")
                                                  ? "On this computer the step matters more: coordinates take a few "
                                                    "nanoseconds per line, while events are applied one by one."
                                                  : "No more here.")});
    rows.push_back({.claim = "plantinga.wire",
                    .here = least_and_greatest(turns.frames, &TurnFrames::ratio),
                    .places = 2,
                    .condition = "positions only, 2 degrees apart, visible lines to wire frame",
                    .comparison = within_limit(turns.frames, &TurnFrames::ratio)});
    rows.push_back({.claim = "plantinga.wire",
                    .here = least_and_greatest(turns.frames, &TurnFrames::ratio_drawn),
                    .places = 2,
                    .condition = "the same, every line drawn pixel by pixel on 1024 by 1024",
                    .comparison = within_limit(turns.frames, &TurnFrames::ratio_drawn)});
  }
  page.claims("plantinga-claims", "Plantinga, Seales and Dyer 1990: their conclusions", rows);
}

}  // namespace

PlantingaTurns plantinga_turns(const Context& context) {
  PlantingaTurns measured;
  const auto turned = plantinga_turned_models(context);
  for (const std::string_view name : plantinga_models_of(context)) {
    context.progress(fmt::format("events of {}", name));
    const StudiedModel studied = study_model(context, name);
    measured.models.push_back(turn_model(studied));
    if (!context.host_times) continue;
    context.progress(fmt::format("frames of {}", name));
    measured.frames.push_back(turn_frames(studied, context.full ? 15 : 5));
    if (std::find(turned.begin(), turned.end(), name) == turned.end()) continue;
    const int rounds = context.full ? 31 : 9;
    add_tolerances(measured.tolerances, studied, rounds);
    add_steps(measured.steps, studied, rounds);
    measured.baselines.push_back(baseline_of(studied));
  }
  return measured;
}

void plantinga_timing(Page& page, const PlantingaTurns& turns) {
  const PrintedTable1 printed(page.papers());
  add_table_1(page, turns, printed);
  if (page.host_times()) add_table_2(page, turns.frames);
  add_claims(page, turns);
  if (!page.host_times()) return;
  const auto us = [](double TurnFrames::*ns) { return [ns](const TurnFrames& f) { return f.*ns / 1000; }; };
  page.table("plantinga-wire-frame", "Plantinga, Seales and Dyer: a frame without hidden lines beside the wire frame",
             turns.frames,
             {{"model", "Model", &TurnFrames::model},
              {"wire_us", "Wire frame", "us, positions", us(&TurnFrames::wire_ns), 2},
              {"visible_us", "Visible lines", "us, positions", us(&TurnFrames::image_2_ns), 2},
              {"steps_us", "of it events", "us", us(&TurnFrames::steps_ns), 2},
              {"ratio", "Visible to wire", "times", &TurnFrames::ratio, 2},
              {"wire_drawn_us", "Wire frame drawn", "us", us(&TurnFrames::wire_drawn_ns), 1},
              {"visible_drawn_us", "Visible lines drawn", "us", us(&TurnFrames::image_drawn_ns), 1},
              {"ratio_drawn", "Visible to wire, drawn", "times", &TurnFrames::ratio_drawn, 2},
              {"events_a_second", "Groups stepped over", "a second", [](const TurnFrames& f) { return 1e9 / f.event_ns; }, 0}},
             {.notes = {"Frames 2 degrees apart. Drawn is positions and one pixel a step of every line, 1024 by 1024, without "
                        "any display hardware."}});
}

}  // namespace sightline::report
