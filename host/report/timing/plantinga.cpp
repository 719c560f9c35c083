// Numbers: H. Plantinga, W. B. Seales and C. R. Dyer, "Real-Time Hidden-Line Elimination for a Rotating
// Scene" (1990), section 5.
#include "host/report/timing/plantinga.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "host/algorithms/plantinga/table_1.hpp"
#include "host/report/plantinga_frame_times.hpp"
#include "host/report/plantinga_models.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::plantinga;

// Table 2: frames a second; image coordinates with 2, 6 and 30 degrees a frame, coordinates in space with 2
// and 30.
struct PrintedRates {
  std::array<double, 3> image;
  std::array<double, 2> space;
};
constexpr std::array<PrintedRates, 6> printed_table_2{{{{409, 346, 321}, {907, 896}},
                                                       {{456, 414, 404}, {976, 957}},
                                                       {{83, 83, 82}, {159, 159}},
                                                       {{67, 60, 58}, {122, 121}},
                                                       {{65, 63, 63}, {123, 122}},
                                                       {{19.7, 19.7, 19.6}, {40.4, 40.4}}}};

Cell count(std::size_t value) {
  return static_cast<std::int64_t>(value);
}

Table events_table() {
  Table table;
  table.id = "plantinga-table-1";
  table.title = "Plantinga, Seales and Dyer: Table 1, as printed and here";
  table.columns = {{"model", "Model", "", false},
                   {"vertices", "Vertices", "", false},
                   {"edges", "Edges", "", false},
                   {"faces", "Faces", "", false},
                   {"printed_events", "Events", "printed", false},
                   {"events", "Events", "here: changes of edges", false},
                   {"groups", "Groups", "here: different directions", false},
                   {"printed_kb", "Event data", "KB, printed", false},
                   {"kb", "Event file", "KB, here", false},
                   {"bytes_an_event", "Bytes an event", "here", false},
                   {"printed_per_edge", "Events an edge", "printed", false},
                   {"per_edge", "Events an edge", "here", false},
                   {"printed_most", "Most of an edge", "printed", false},
                   {"most", "Most of an edge", "here", false},
                   {"printed_s", "Construction", "s, printed, RS/6000-320", false},
                   {"one_core_s", "Construction", "s, one core here", true},
                   {"all_cores_s", "Construction", "s, all cores here", true},
                   {"events_found_a_second", "Events found a second", "one core here", true}};
  table.notes = {
      "Where the parts of the models stand is not in the paper, nor how they were tilted: only the numbers "
      "of vertices, edges and faces are. The models here have exactly these; they are degenerate on purpose, "
      "with edges of one height, parallel edges and parts that mirror one another, so that many events fall "
      "together: compare magnitudes, not digits. Tori and Spring leave least to choose.",
      "The paper's events are changes of single edges: events an edge times edges gives the printed events "
      "in five of six rows. In the row Grid it does not: 1383 events of 105 edges are 13.2 an edge, not "
      "16.3; either there were about 1711 events, or about 85 edges (hard case P22). A group is all that "
      "changes at one direction, held apart exactly.",
      "KB are 1024 bytes. The file here has, in each change, only the pieces that come; those that go are "
      "what was there."};
  return table;
}

Table frames_table() {
  Table table;
  table.id = "plantinga-table-2";
  table.title = "Plantinga, Seales and Dyer: Table 2, as printed and here, frames a second";
  table.columns = {{"model", "Model", "", false}};
  for (const int step : {2, 6, 30}) {
    table.columns.push_back(
        {fmt::format("printed_image_{}", step), fmt::format("2-D hardware, {}°", step), "printed", false});
    table.columns.push_back(
        {fmt::format("image_{}", step), fmt::format("2-D hardware, {}°", step), "here", true});
  }
  for (const int step : {2, 30}) {
    table.columns.push_back(
        {fmt::format("printed_space_{}", step), fmt::format("3-D hardware, {}°", step), "printed", false});
    table.columns.push_back(
        {fmt::format("space_{}", step), fmt::format("3-D hardware, {}°", step), "here", true});
  }
  table.notes = {
      "As in the paper: rotations of 360 frames, the event structure brought up to date and the image "
      "coordinates of every vector computed (2-D), or its coordinates in space (3-D); nothing drawn. Their "
      "computer was an IBM RS/6000 model 320; here it is one core of this one, medians of repeated "
      "rotations.",
      "The paper finds that the step hardly matters, because coordinates cost far more than events. On this "
      "computer it does: coordinates take a few nanoseconds a line, while what an event changes has to be "
      "found and put in place one by one."};
  return table;
}

Table wire_table() {
  Table table;
  table.id = "plantinga-wire-frame";
  table.title = "Plantinga, Seales and Dyer: a frame without hidden lines beside the wire frame";
  table.columns = {{"model", "Model", "", false},
                   {"wire_us", "Wire frame", "us, positions", true},
                   {"visible_us", "Visible lines", "us, positions", true},
                   {"steps_us", "of it events", "us", true},
                   {"ratio", "Visible to wire", "times", true},
                   {"wire_drawn_us", "Wire frame drawn", "us", true},
                   {"visible_drawn_us", "Visible lines drawn", "us", true},
                   {"ratio_drawn", "Visible to wire, drawn", "times", true},
                   {"events_a_second", "Groups stepped over", "a second", true}};
  table.notes = {
      "The claim: once the events are known, a frame costs about as much as drawing the wire frame. Frames 2 "
      "degrees apart; drawn is positions and one pixel a step of every line, 1024 by 1024, without any "
      "display hardware. The claim holds where lines are drawn: fewer lines are drawn than the wire frame "
      "has."};
  return table;
}

void add_events_row(Table& table, const StudiedModel& studied, const native::Table1Row& printed) {
  const StudyTimes times = studied.times.value_or(StudyTimes{});
  const auto here = native::table_1_row(printed.model, studied.model, studied.list, times.all_cores_s);
  table.rows.push_back(
      {std::string(printed.model), count(here.vertices), count(here.edges), count(here.faces),
       count(printed.events), count(here.events), count(here.directions), Real{printed.kilobytes, 0},
       Real{here.kilobytes, 1}, Real{here.kilobytes * 1024 / static_cast<double>(here.events), 1},
       Real{printed.events_per_edge, 1}, Real{here.events_per_edge, 1}, count(printed.most_events_per_edge),
       count(here.most_events_per_edge), Real{printed.seconds, 0}, Real{times.one_core_s, 3},
       Real{times.all_cores_s, 3}, Real{static_cast<double>(here.events) / times.one_core_s, 0}});
}

void add_frame_rows(Table& rates, Table& wire, std::string_view model, const PrintedRates& printed,
                    const PlantingaFrameTimes& times) {
  std::vector<Cell> row{std::string(model)};
  const auto add = [&row](double said, double nanoseconds) {
    row.emplace_back(Real{said, said < 100 ? 1 : 0});
    row.emplace_back(Real{1e9 / nanoseconds, 0});
  };
  for (std::size_t i = 0; i < printed.image.size(); ++i) add(printed.image[i], times.image[i]);
  for (std::size_t i = 0; i < printed.space.size(); ++i) add(printed.space[i], times.space[i]);
  rates.rows.push_back(std::move(row));
  wire.rows.push_back({std::string(model), Real{times.wire / 1000, 2}, Real{times.image[0] / 1000, 2},
                       Real{times.steps / 1000, 2}, Real{times.image[0] / times.wire, 2},
                       Real{times.wire_drawn / 1000, 1}, Real{times.drawn / 1000, 1},
                       Real{times.drawn / times.wire_drawn, 2}, Real{1e9 / times.an_event, 0}});
}

}  // namespace

Outcome<std::vector<Block>> timing_of_plantinga(const Context& context) {
  Table events = events_table();
  Table rates = frames_table();
  Table wire = wire_table();
  const auto printed = native::printed_table_1();
  bool from_cache = false;
  const auto names = plantinga_models_of(context);
  for (std::size_t i = 0; i < names.size(); ++i) {
    context.progress(fmt::format("events of {}", names[i]));
    const auto outcome = study_model(context, names[i]);
    if (!outcome) return outcome.error();
    const auto& studied = *outcome;
    from_cache = from_cache || studied.from_cache;
    add_events_row(events, studied, printed[i]);
    if (!context.host_times) continue;
    context.progress(fmt::format("frames of {}", names[i]));
    add_frame_rows(rates, wire, printed[i].model, printed_table_2[i],
                   measure_frames(studied, context.full ? 15 : 5));
  }
  if (!context.full)
    events.notes.emplace_back("Spring takes longer to prepare than the rest together: with --full.");
  if (from_cache && context.host_times)
    events.notes.emplace_back(
        "Events were kept from an earlier report, and so was the time of their construction.");
  std::vector<Block> blocks;
  blocks.emplace_back(std::move(events));
  if (!context.host_times) return blocks;
  blocks.emplace_back(std::move(rates));
  blocks.emplace_back(std::move(wire));
  return blocks;
}

}  // namespace sightline::harness::report
