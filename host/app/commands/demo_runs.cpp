#include "host/app/commands/demo_runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

#include "host/algorithms/registry/turns.hpp"
#include "host/app/commands/jones_pictures.hpp"
#include "host/app/commands/turn_sheet.hpp"
#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/value_of.hpp"
#include "host/picture/apng.hpp"
#include "host/programs/jones/known_walks.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {
namespace {

namespace jones = programs::jones;
using base::Json;

JonesRow run_scene(const std::string& name, const scene::CellScene& scene, bool eae, const std::string& directory) {
  jones::Order order;
  if (eae) order.photograph = photograph_time;  // without the EAE the pictures are the same
  order.check = true;
  const jones::Outcome outcome = value_of(jones::run(scene, {.eae = eae}, order), name);
  if (eae) write_jones_pictures(directory, file_stem(scene.name), title_of(scene.name, eae), outcome);
  return {name, eae, scene.cells.size(), outcome.core_words, outcome.views.front(), outcome.refreshes_per_second()};
}

}  // namespace

std::vector<JonesRow> run_jones_demo(const std::string& directory) {
  std::vector<JonesRow> rows;
  for (const std::string_view name : scene::builtin_scene_names()) {
    const scene::CellScene scene = load_cells(std::string(name));
    for (const bool eae : {true, false}) rows.push_back(run_scene(std::string(name), scene, eae, directory));
  }
  return rows;
}

std::string jones_table(const std::vector<JonesRow>& rows) {
  std::string text = fmt::format("{:<11}{:<5}{:>10}{:>10}{:>10}{:>16}{:>12}\n", "scene", "EAE", "seconds", "cells", "segments",
                                 "words of core", "refreshes/s");
  for (const JonesRow& row : rows) {
    text += fmt::format("{:<11}{:<5}{:>10.3f}{:>10}{:>10}{:>16}{:>12.1f}\n", row.scene, row.eae ? "yes" : "no",
                        core::in_seconds(row.view.time), fmt::format("{}/{}", row.view.distinct_cells, row.cells), row.view.pieces,
                        fmt::format("{}/{}", row.words, programs::jones::core_words), row.refreshes);
  }
  text += "Seconds of the emulated machine for the first view, while the display does not yet take cycles; the paper: \"a few seconds\".\n";
  return text;
}

void add_jones_rows(Json& document, const std::vector<JonesRow>& rows) {
  document["views"] = Json::array();
  for (const JonesRow& row : rows) {
    document["views"].push_back({{"scene", row.scene},
                                 {"eae", row.eae},
                                 {"status", jones::name(row.view.status)},
                                 {"emulated_ns", row.view.time.count()},
                                 {"cells_read", row.view.distinct_cells},
                                 {"cells", row.cells},
                                 {"segments", row.view.pieces},
                                 {"core_words_used", row.words},
                                 {"refreshes_per_second", row.refreshes}});
  }
}

std::string walk_stem(const std::string& scene, bool rotation) { return file_stem(scene) + (rotation ? "-turned-walk" : "-walk"); }

std::vector<WalkRow> run_walks(const std::string& directory) {
  std::vector<WalkRow> rows;
  std::vector<jones::KnownWalk> walks(jones::known_walks.begin(), jones::known_walks.end());
  walks.insert(walks.end(), jones::known_turned_walks.begin(), jones::known_turned_walks.end());
  for (const jones::KnownWalk& known : walks) {
    const std::string name(known.scene);
    const scene::CellScene scene = load_cells(name);
    for (const bool eae : {true, false}) {
      jones::Order order;
      order.walk = value_of(jones::read_walk(known.steps), name);
      if (eae) order.photograph = photograph_time;
      order.check = true;
      const bool rotation = jones::has_turn(order.walk);
      const jones::Outcome outcome = value_of(jones::run(scene, {.eae = eae, .walk = true, .rotation = rotation}, order), name);
      if (eae) write_jones_pictures(directory, walk_stem(scene.name, rotation), title_of(scene.name, eae) + ", after a walk", outcome);
      WalkRow& row = rows.emplace_back(WalkRow{name, rotation, eae, outcome.views.size(), 0, scene.cells.size(), 0, 0, outcome.core_words});
      std::set<std::size_t> entered;
      for (const jones::View& view : outcome.views) {
        entered.insert(view.cell);
        row.mean_s += core::in_seconds(view.time) / static_cast<double>(row.views);
        row.worst_s = std::max(row.worst_s, core::in_seconds(view.time));
      }
      row.entered = entered.size();
    }
  }
  return rows;
}

std::string walk_table(const std::vector<WalkRow>& rows) {
  std::string text = fmt::format("{:<11}{:<7}{:<5}{:>7}{:>16}{:>14}{:>14}{:>16}\n", "scene", "turns", "EAE", "views", "cells entered", "seconds mean", "worst", "words of core");
  for (const WalkRow& row : rows) {
    text += fmt::format("{:<11}{:<7}{:<5}{:>7}{:>16}{:>14.3f}{:>14.3f}{:>16}\n", row.scene, row.rotation ? "yes" : "no", row.eae ? "yes" : "no", row.views, fmt::format("{}/{}", row.entered, row.cells),
                        row.mean_s, row.worst_s, fmt::format("{}/{}", row.words, jones::core_words));
  }
  text += "The program finds the cell of the camera by the planes of the cells and follows it through portals; Jones, 1971: \"ideally there would be complete freedom of movement of the viewpoint\". In a longer build the view also turns about the vertical.\n";
  return text;
}

void add_walks(Json& document, const std::vector<WalkRow>& rows) {
  document["walks"] = Json::array();
  for (const WalkRow& row : rows) {
    document["walks"].push_back({{"scene", row.scene},
                                 {"rotation", row.rotation},
                                 {"eae", row.eae},
                                 {"views", row.views},
                                 {"cells_entered", row.entered},
                                 {"cells", row.cells},
                                 {"seconds_mean", row.mean_s},
                                 {"seconds_worst", row.worst_s},
                                 {"core_words_used", row.words}});
  }
}

std::vector<TurnRow> run_turns() {
  std::vector<TurnRow> rows;
  for (const char* model : {"roberts", "boxes-8"}) {
    const auto tape = value_of(programs::turn::make_tape(load_scene(model).scene, programs::turn::Memory::words_8k), model);
    for (const bool eae : {true, false})
      rows.push_back({model, eae, tape.edges, value_of(programs::turn::run(tape, {.eae = eae, .check = true}), model)});
  }
  return rows;
}

std::string turn_table(const std::vector<TurnRow>& rows) {
  std::string text = fmt::format("{:<11}{:<5}{:>7}{:>14}{:>9}{:>16}{:>22}\n", "model", "EAE", "edges", "frames/s mean", "worst",
                                 "wire frames/s", "of a wire frame's time");
  for (const TurnRow& row : rows) {
    const auto& hidden = row.outcome.hidden.summary;
    text += fmt::format("{:<11}{:<5}{:>7}{:>14.1f}{:>9.1f}{:>16.1f}{:>22.2f}\n", row.model, row.eae ? "yes" : "no", row.edges,
                        hidden.frames_per_second_mean, hidden.frames_per_second_worst,
                        row.outcome.wire.summary.frames_per_second_mean, row.outcome.cost_against_wire_frame());
  }
  text +=
      "Mean and worst of a full turn in 8 seconds. Jones, 1971: continuous motion \"has not been possible\"; the claim of 1990: no more than the wire "
      "frame.\n";
  return text;
}

void add_turns(Json& document, const std::vector<TurnRow>& rows) {
  document["turns"] = Json::array();
  for (const TurnRow& row : rows) {
    const auto& hidden = row.outcome.hidden.summary;
    document["turns"].push_back({{"model", row.model},
                                 {"eae", row.eae},
                                 {"edges", row.edges},
                                 {"frames_per_second_mean", hidden.frames_per_second_mean},
                                 {"frames_per_second_worst", hidden.frames_per_second_worst},
                                 {"wire_frames_per_second_mean", row.outcome.wire.summary.frames_per_second_mean},
                                 {"cost_against_wire_frame", row.outcome.cost_against_wire_frame()}});
  }
}

namespace {

double length_of(const std::vector<registry::TurnLine>& lines) {
  double length = 0;
  for (const registry::TurnLine& line : lines) length += std::hypot(line.u1 - line.u0, line.v1 - line.v0);
  return length;
}

// A turn about the middle of the scene.
CircleRow run_circle(const std::string& directory, const std::string& model, const std::string& name, const std::string& view, registry::EyeCircle circle) {
  constexpr int frames = 60;
  constexpr int pixels = 320;
  const scene::PolyScene scene = load_scene(model).scene;
  const scene::PolyPoint middle = scene::bounds_of(scene).middle();
  circle.about = {middle[0], middle[1], middle[2]};
  CircleRow row{model, view, fmt::format("{}-{}.apng", file_stem(model), name)};
  const registry::TurnOptions options{.circle = circle};
  const auto turn = value_of(registry::find_turn_method("plantinga")->prepare(scene, options), model);
  const auto scratch = value_of(registry::find_turn_method("exact")->prepare(scene, options), model);
  for (const registry::TurnCount& count : turn.counts) {
    if (count.name == "edges") row.edges = count.value;
    if (count.name == "events") row.events = count.value;
  }
  const TurnSheet sheet(scene, pixels, circle);
  picture::ApngWriter apng({1, 15});
  std::vector<registry::TurnLine> lines;
  std::vector<registry::TurnLine> exact;
  for (; row.frames < frames; ++row.frames) {
    // Not at whole quarters of a turn, where faces are seen edge-on.
    const double angle = 2 * std::numbers::pi * (row.frames + 0.5) / frames;
    turn.visible(angle, lines);
    scratch.visible(angle, exact);
    // The exact method draws from an eye on the grid of the scene.
    const double allowed = 1e-3 * length_of(exact);
    row.right += std::abs(length_of(lines) - length_of(exact)) <= allowed ? 1 : 0;
    base::value_of(apng.add(sheet.image_of(lines)), row.file);
  }
  Output output((std::filesystem::path(directory) / row.file).string());
  output.write(base::value_of(apng.finish(), row.file));
  output.commit();
  return row;
}

}  // namespace

std::vector<CircleRow> run_circles(const std::string& directory) {
  // Eyes far enough that a step of the grid is a small angle.
  return {run_circle(directory, "roberts", "axis", "about 1,3,0", {.axis = {1, 3, 0}, .eye = {0, 0, 1 << 20}}),
          run_circle(directory, "roberts", "perspective", "from above, in perspective", {.eye = {0, 300, 900}, .perspective = true})};
}

std::string circle_table(const std::vector<CircleRow>& rows) {
  std::string text = fmt::format("{:<11}{:<30}{:>7}{:>8}{:>8}{:>20}\n", "model", "turn", "edges", "events", "frames", "visible length right");
  for (const CircleRow& row : rows)
    text += fmt::format("{:<11}{:<30}{:>7}{:>8}{:>8}{:>20}\n", row.model, row.view, row.edges, row.events, row.frames, fmt::format("{}/{}", row.right, row.frames));
  text += "The paper turns scenes about one axis in parallel projection, and has a sentence each for other rotations and perspective. `sightline spin --axis --elevation --distance` makes such turns.\n";
  return text;
}

void add_circles(Json& document, const std::vector<CircleRow>& rows) {
  document["circles"] = Json::array();
  for (const CircleRow& row : rows)
    document["circles"].push_back({{"model", row.model}, {"turn", row.view}, {"edges", row.edges}, {"events", row.events}, {"frames", row.frames}, {"right", row.right}});
}

std::vector<FlightRow> run_flights() {
  namespace flight = programs::flight;
  std::vector<FlightRow> rows;
  for (const auto& [name, plan] : {std::pair("town-10", false), std::pair("prisms-25", true)}) {
    const flight::Plan planned = value_of(flight::plan_flight(load_scene(name).scene, plan, 60), name);
    for (const auto& [precision, bits] : {std::pair(flight::Precision::bits_8, 8), std::pair(flight::Precision::bits_16, 16)}) {
      const auto run = value_of(flight::run({.model = planned.model, .path = planned.path, .precision = precision, .check = true}), name);
      rows.push_back({name, bits, run.summary});
    }
  }
  return rows;
}

std::string demo_flight_table(const std::vector<FlightRow>& rows) {
  std::string text = fmt::format("{:<11}{:>5}{:>8}{:>15}{:>8}{:>16}{:>16}\n", "scene", "bits", "pieces", "frames/s mean", "worst",
                                 "T-states mean", "wrong orders");
  for (const FlightRow& row : rows) {
    text += fmt::format("{:<11}{:>5}{:>8}{:>15.1f}{:>8.1f}{:>16.0f}{:>16}\n", row.scene, row.bits, row.summary.pieces,
                        row.summary.frames_per_second_mean, row.summary.frames_per_second_worst, row.summary.t_states_mean,
                        fmt::format("{}/{}", row.summary.wrong_orders, row.summary.pairs));
  }
  text += "The display takes 25 frames a second, which is what the paper wants.\n";
  return text;
}

void add_flights(Json& document, const std::vector<FlightRow>& rows) {
  document["flights"] = Json::array();
  for (const FlightRow& row : rows) {
    document["flights"].push_back({{"scene", row.scene},
                                   {"bits", row.bits},
                                   {"pieces", row.summary.pieces},
                                   {"frames_per_second_mean", row.summary.frames_per_second_mean},
                                   {"frames_per_second_worst", row.summary.frames_per_second_worst},
                                   {"t_states_mean", row.summary.t_states_mean},
                                   {"pairs", row.summary.pairs},
                                   {"wrong_orders", row.summary.wrong_orders}});
  }
}

}  // namespace sightline::app
