#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/demo_comparison.hpp"
#include "host/app/commands/flight_session.hpp"
#include "host/app/commands/jones_session.hpp"
#include "host/app/commands/skala_demo.hpp"
#include "host/app/commands/stripes_demo.hpp"
#include "host/app/commands/turn_session.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/json.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::app {

namespace {

namespace jones = guests::jones;
using base::Json;

struct DemoArguments {
  std::string directory = "out";
  bool json = false;
};

struct Row {
  std::string scene;
  bool eae = false;
  std::size_t cells = 0;
  std::uint32_t words = 0;
  jones::GuestView view;
  double refreshes = 0;
};

Row run_scene(const std::string& name, const scene::CellScene& scene, bool eae,
              const std::string& directory) {
  jones::ProgramOptions program_options;
  program_options.eae = eae;
  const jones::Session session = session_of(scene, name, program_options);
  jones::GuestOptions options;
  if (eae) options.photograph = photograph_time;  // the pictures are the same without
  const jones::CheckedRun checked = session.run(options);
  const jones::GuestRun& run = checked.guest;
  if (run.timed_out) throw Failure(ExitCode::guest_failed, name + ": the program did not complete two views");
  require_twin(checked, name);
  if (eae) {
    write_jones_pictures(directory, file_stem(scene.name), title_of(scene.name, eae), run);
  }
  return {name,
          eae,
          session.program().scene.cell_addresses.size(),
          session.program().words_used,
          run.views.back(),
          refreshes_per_second(run)};
}

std::string table_of(const std::vector<Row>& rows) {
  std::string text = "Jones 1971 on the PDP-7 with a Type 340 display\n";
  text += fmt::format("{:<11}{:<5}{:>10}{:>10}{:>10}{:>16}{:>12}\n", "scene", "EAE", "seconds", "cells",
                      "segments", "words of core", "refreshes/s");
  for (const Row& row : rows) {
    text += fmt::format("{:<11}{:<5}{:>10.3f}{:>10}{:>10}{:>16}{:>12.1f}\n", row.scene,
                        row.eae ? "yes" : "no", seconds(row.view.time),
                        fmt::format("{}/{}", row.view.distinct_cells, row.cells), row.view.pieces,
                        fmt::format("{}/{}", row.words, guests::jones::core_words), row.refreshes);
  }
  text += "Seconds of the emulated machine for the second view; the paper: \"a few seconds\".\n";
  return text;
}

Json document_of(const std::vector<Row>& rows, const std::string& directory) {
  Json document{{"schema", "sightline/demo/1"}, {"pictures", directory}};
  document["views"] = Json::array();
  for (const Row& row : rows) {
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
  return document;
}

// A solid turning, with the EAE and without.
struct TurnRow {
  std::string model;
  bool eae = false;
  std::uint32_t edges = 0;
  TurnMeasure measure;
};

std::vector<TurnRow> run_turns() {
  std::vector<TurnRow> rows;
  for (const char* model : {"roberts", "boxes-8"}) {
    const guests::turn::Tape tape = turn_tape(load_scene(model).scene, model, false);
    for (const bool eae : {true, false})
      rows.push_back({model, eae, tape.edges, measure_turn(guests::turn::Session(tape, eae), model, 0, false)});
  }
  return rows;
}

std::string turn_table(const std::vector<TurnRow>& rows) {
  std::string text = fmt::format("{:<11}{:<5}{:>7}{:>14}{:>9}{:>16}{:>22}\n", "model", "EAE", "edges", "frames/s mean", "worst",
                                 "wire frames/s", "cost against wire");
  for (const TurnRow& row : rows) {
    const auto& hidden = row.measure.hidden.summary;
    text += fmt::format("{:<11}{:<5}{:>7}{:>14.1f}{:>9.1f}{:>16.1f}{:>22.2f}\n", row.model, row.eae ? "yes" : "no", row.edges,
                        hidden.frames_per_second_mean, hidden.frames_per_second_worst,
                        row.measure.wire.summary.frames_per_second_mean, row.measure.cost_against_wire_frame());
  }
  text += "One turn in 8 seconds. Jones, 1971: continuous motion \"has not been possible\"; the claim of 1990: no more than the wire frame.\n";
  return text;
}

void add_turns(Json& document, const std::vector<TurnRow>& rows) {
  document["turns"] = Json::array();
  for (const TurnRow& row : rows) {
    const auto& hidden = row.measure.hidden.summary;
    document["turns"].push_back({{"model", row.model},
                                 {"eae", row.eae},
                                 {"edges", row.edges},
                                 {"frames_per_second_mean", hidden.frames_per_second_mean},
                                 {"frames_per_second_worst", hidden.frames_per_second_worst},
                                 {"wire_frames_per_second_mean", row.measure.wire.summary.frames_per_second_mean},
                                 {"cost_against_wire_frame", row.measure.cost_against_wire_frame()}});
  }
}

// Flights with the priority display.
struct FlightRow {
  std::string scene;
  int bits = 8;
  guests::flight::FlightSummary summary;
};

std::vector<FlightRow> run_flights() {
  namespace flight = guests::flight;
  std::vector<FlightRow> rows;
  const flight::Session session;
  for (const auto& [name, plan] : {std::pair("town-10", false), std::pair("prisms-25", true)}) {
    const PlannedFlight planned = planned_flight(load_scene(name).scene, name, plan, 60, {});
    for (const auto& [precision, bits] : {std::pair(flight::Precision::bits_8, 8), std::pair(flight::Precision::bits_16, 16)}) {
      const auto run = checked_flight(session, planned, flight::pack(planned.model, planned.path, precision), name, {});
      rows.push_back({name, bits, run.summary});
    }
  }
  return rows;
}

std::string demo_flight_table(const std::vector<FlightRow>& rows) {
  std::string text = fmt::format("{:<11}{:>5}{:>8}{:>15}{:>8}{:>16}{:>16}\n", "scene", "bits", "pieces", "frames/s mean", "worst", "T-states mean",
                                 "wrong orders");
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

// Why visibility does not cost the paper's 15 %: what the test adds to a point, and how many points it hides.
std::string visibility_line(const SkalaDemo& demo) {
  struct Cost {
    std::string function;
    double plain = 0;  // T-states a point without the test
    double added = 0;
    double hidden = 0;  // per cent of the points
  };
  std::vector<Cost> costs;
  for (const SkalaDemoRow& row : demo.rows) {
    if (!row.lines.visibility_cost || row.lines.points_walked == 0) continue;
    const auto points = static_cast<double>(row.lines.points_walked);
    const double with = static_cast<double>(row.lines.picture.drawing.count()) / points;
    const double plain = with / (1 + *row.lines.visibility_cost / 100);
    costs.push_back({row.function, plain, with - plain, 100 - 100 * static_cast<double>(row.lines.points_lit) / points});
  }
  if (costs.empty()) return {};
  const auto by_added = [](const Cost& a, const Cost& b) { return a.added < b.added; };
  const auto [least, most] = std::minmax_element(costs.begin(), costs.end(), by_added);
  return fmt::format(
      "Why not 15 %: the test adds {:.0f} T-states to the {:.0f} of a point of {} ({:.0f} % are hidden, not drawn), {:.0f} to the {:.0f} "
      "of {} ({:.0f} %).\n",
      least->added, least->plain, least->function, least->hidden, most->added, most->plain, most->function, most->hidden);
}

ExitCode run_demo(const DemoArguments& arguments) {
  std::vector<Row> rows;
  for (const std::string_view name : scene::builtin_scene_names()) {
    const scene::CellScene scene = load_cells(std::string(name));
    for (const bool eae : {true, false})
      rows.push_back(run_scene(std::string(name), scene, eae, arguments.directory));
  }
  const std::vector<TurnRow> turns = run_turns();
  const std::vector<FlightRow> flights = run_flights();
  const SkalaDemo skala = run_skala_demo(arguments.directory);
  const std::vector<StripesDemoRow> stripes = run_stripes_demo(arguments.directory);
  const DemoComparison comparison = compare_for_demo();
  if (arguments.json) {
    Json document = document_of(rows, arguments.directory);
    add_turns(document, turns);
    add_flights(document, flights);
    add_skala_demo(document, skala);
    add_stripes_demo(document, stripes);
    add_demo_comparison(document, comparison);
    // The folder's name comes from the user: what is no UTF-8 is shown as far as it can be.
    print_json(document);
  } else {
    write_stdout(table_of(rows));
    write_stdout("\nA solid turning on the PDP-7, after Plantinga, Seales and Dyer 1990\n" + turn_table(turns));
    write_stdout("\nA flight on the 8080 with the priority display, after Willis 1977\n" + demo_flight_table(flights));
    write_stdout("\nSkala 1985 on the 8080 with an EF9365 raster board\n" + skala_demo_table(skala) + visibility_line(skala));
    write_stdout("\nMontani and Re 1985 on the 8080: scenes in stripes\n" + stripes_demo_table(stripes));
    write_stdout("\nBoth compared with their oracles, and the native algorithms beside them\n" +
                 demo_comparison_table(comparison));
    write_stdout(
        fmt::format("\nPictures are in {}/: SCENE-phosphor.png the screen, SCENE.png every point, SCENE.svg "
                    "for drawing\nprograms; FUNCTION-lines.png, -surface.png, -contours.png, "
                    "{}-calcomp.hpgl for plotters. The whole story: sightline report.\n",
                    arguments.directory, skala.plotted));
  }
  ExitCode code = ExitCode::ok;
  for (const Row& row : rows) {
    if (row.view.status == jones::Status::complete) continue;
    complain(fmt::format("{}: the view stopped: {}", row.scene, jones::name(row.view.status)));
    code = ExitCode::guest_failed;
  }
  if (!comparison.agrees()) {
    complain("an exact algorithm is not exact, or a guest is not its twin: see above");
    code = ExitCode::differs;
  }
  return code;
}

}  // namespace

void add_demo_command(const Command& program) {
  const Command command = program.add_command("demo", help_page("demo"));
  const auto arguments = std::make_shared<DemoArguments>();
  command.option("-o,--output", arguments->directory, "Folder for the pictures").default_value().value("DIR");
  command.flag("--json", arguments->json, "One JSON document instead of the table");
  command.run([arguments] { return run_demo(*arguments); });
}

}  // namespace sightline::app
