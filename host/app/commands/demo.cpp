// `sightline demo`: runs both machines on all built-in scenes and functions; prints about ten lines and writes a page.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/demo_page.hpp"
#include "host/app/outputs.hpp"
#include "host/base/parallel.hpp"
#include "host/base/progress.hpp"
#include "host/base/threads.hpp"

namespace sightline::app {

namespace {

using base::Json;

struct DemoArguments {
  std::string directory = "out";
  bool no_host_times = false;
  bool json = false;
};

// The runs of the emulated machines are independent of each other. Times of this computer are measured after them.
DemoResults run_parts(const DemoArguments& arguments) {
  DemoResults results;
  const std::vector<std::function<void()>> parts{[&] { results.jones = run_jones_demo(arguments.directory); },
                                                 [&] { results.skala = run_skala_demo(arguments.directory); },
                                                 [&] { results.walks = run_walks(arguments.directory); },
                                                 [&] { results.turns = run_turns(); }, [&] { results.circles = run_circles(arguments.directory); },
                                                 [&] { results.flights = run_flights(); },
                                                 [&] { results.stripes = run_stripes_demo(arguments.directory); }};
  base::OrderedWork<bool> work;
  work.last = parts.size();
  work.jobs = std::min(base::available_threads(), static_cast<unsigned>(parts.size()));
  work.make = [&parts](std::uint64_t part) {
    parts[part]();
    return true;
  };
  work.take = [](std::uint64_t, bool) {};
  work.go_on = [] { return true; };
  std::optional<base::ProgressClock> clock(std::in_place, "step 1 of 2, the programs on both machines");
  base::run_in_order(work);
  clock.emplace("step 2 of 2, the same views by all methods, compared");
  results.answer = answer_for_demo(!arguments.no_host_times);
  return results;
}

std::vector<std::pair<std::string, std::string>> tables_of(const DemoResults& results) {
  return {{"Jones 1971 on the PDP-7 with a Type 340 display", jones_table(results.jones)},
          {"A walk from cell to cell on the PDP-7, which Jones 1971 left out", walk_table(results.walks)},
          {"A solid turning on the PDP-7, after Plantinga, Seales and Dyer 1990", turn_table(results.turns)},
          {"A solid turning about other axes and in perspective, on this computer", circle_table(results.circles)},
          {"A flight on the 8080 with the priority display, after Willis 1977", demo_flight_table(results.flights)},
          {"Skala 1985 on the 8080 with an EF9365 raster board", skala_demo_table(results.skala)},
          {"Montani and Re 1985 on the 8080: scenes in stripes", stripes_demo_table(results.stripes)}};
}

std::string write_page(const std::string& directory, const DemoResults& results) {
  const DemoPage page{answers_of(results), verdicts_of(results), demo_galleries(directory, results), tables_of(results)};
  const std::string path = (std::filesystem::path(directory) / "index.html").string();
  Output output(path);
  output.write(demo_page(page, results.answer));
  output.commit();
  return path;
}

Json document_of(const DemoArguments& arguments, const DemoResults& results, const std::string& page) {
  // The name of the folder comes from the user: bytes that are not UTF-8 are replaced.
  Json document{{"schema", "sightline/demo/2"}, {"pictures", arguments.directory}, {"page", page}};
  document["verdicts"] = Json::array();
  for (const Verdict& verdict : verdicts_of(results))
    document["verdicts"].push_back(
        {{"subject", verdict.subject}, {"text", verdict.text}, {"verdict", verdict.verdict}, {"right", verdict.right}});
  add_jones_rows(document, results.jones);
  add_walks(document, results.walks);
  add_turns(document, results.turns);
  add_circles(document, results.circles);
  add_flights(document, results.flights);
  add_skala_demo(document, results.skala);
  add_stripes_demo(document, results.stripes);
  add_demo_answer(document, results.answer);
  return document;
}

ExitCode run_demo(const DemoArguments& arguments) {
  const DemoResults results = run_parts(arguments);
  const std::string page = write_page(arguments.directory, results);
  if (arguments.json) {
    print_json(document_of(arguments, results, page));
  } else {
    for (const Verdict& verdict : verdicts_of(results))
      write_stdout(
          fmt::format("{}: {}{}{}\n", verdict.subject, verdict.text, verdict.verdict.empty() ? "" : ": ", verdict.verdict));
    write_stdout(fmt::format("Right: along the lines nothing is missing or extra more than a point of the screen away from what is visible; how far points lie beside a line does not count. The table, the plot and the pictures: {}{}\n", page,
                             report_program() ? "; every experiment on the five papers: sightline report" : ""));
  }
  ExitCode code = ExitCode::ok;
  for (const JonesRow& row : results.jones) {
    if (row.view.status == programs::jones::Status::complete) continue;
    print_message(fmt::format("{}: the view stopped: {}", row.scene, programs::jones::name(row.view.status)));
    code = ExitCode::guest_failed;
  }
  const bool circles = std::all_of(results.circles.begin(), results.circles.end(), [](const CircleRow& row) { return row.right == row.frames; });
  if (!results.answer.agrees() || !circles) {
    print_message("an exact algorithm is not exact, or a program on its machine differs from the same program in C++: see above");
    code = ExitCode::differs;
  }
  return code;
}

}  // namespace

void add_demo_command(const Command& program) {
  const Command command = program.add_command("demo", help_page("demo"));
  const auto arguments = std::make_shared<DemoArguments>();
  command.option("-o,--output", arguments->directory, "Folder for the page and the pictures").default_value().value("DIR");
  command.flag("--no-host-times", arguments->no_host_times, "Omit times of this computer: the same bytes in every run");
  command.flag("--json", arguments->json, "One JSON document instead of the lines");
  command.run([arguments] { return run_demo(*arguments); });
}

}  // namespace sightline::app
