// The program `sightline-report`, which `sightline report` executes: writes the measurements and comparisons of all
// algorithms as one page and its tables. It reads the command line that was given to `sightline`.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "host/app/command_line.hpp"
#include "host/report/make_report.hpp"
#include "host/report/plot.hpp"
#include "host/report/write_report.hpp"

namespace {

namespace report = sightline::report;
using sightline::app::Command;
using sightline::app::ExitCode;

struct ReportArguments {
  std::string directory = "report";
  std::string cache;
  std::vector<int> parts;
  bool full = false;
  bool no_host_times = false;
  bool quiet = false;
};

void check_parts(const std::vector<int>& numbers) {
  const auto& all = report::report_parts();
  for (const int number : numbers) {
    if (std::any_of(all.begin(), all.end(), [&](const auto& part) { return part.number == number; })) continue;
    std::string there;
    for (const report::Part& part : all) there += fmt::format("{}{}", there.empty() ? "" : ", ", part.number);
    throw sightline::base::usage_error(fmt::format("--part: found {}, expected one of {}", number, there));
  }
}

// Shows progress in one line on a terminal, rewritten for each step; shows nothing elsewhere.
class StepLine {
 public:
  explicit StepLine(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}
  ~StepLine() {
    if (shown_) fmt::print(stderr, "\r\033[K");
  }
  StepLine(const StepLine&) = delete;
  StepLine& operator=(const StepLine&) = delete;

  void show(std::string_view step) const {
    if (!shown_) return;
    fmt::print(stderr, "\r\033[K{}", step);
    static_cast<void>(std::fflush(stderr));
  }

 private:
  bool shown_;
};

ExitCode run_report(const ReportArguments& arguments) {
  check_parts(arguments.parts);
  sightline::base::value_of(report::prepare_directory(arguments.directory));
  if (const auto error = report::gnuplot_missing()) throw *error;
  report::Report made;
  {
    const StepLine line(arguments.quiet);
    report::Context context;
    context.full = arguments.full;
    context.host_times = !arguments.no_host_times;
    context.cache = arguments.cache.empty() ? arguments.directory + "/cache" : arguments.cache;
    context.jobs = std::max(1U, std::thread::hardware_concurrency());
    context.progress = [&line](std::string_view step) { line.show(step); };
    made = sightline::base::value_of(report::make_report(arguments.parts, context));
  }
  made.version = SIGHTLINE_VERSION;
  const auto paths = sightline::base::value_of(report::write_report(made, arguments.directory));
  sightline::app::write_stdout(fmt::format("{}\n", paths.front()));
  if (!arguments.quiet && paths.size() > 1)
    fmt::print(stderr, "and {} tables as CSV and JSON in {}/tables/\n", paths.size() / 2,
               arguments.directory);
  return ExitCode::ok;
}

void add_report_command(const Command& app) {
  const Command command = app.add_command("report", sightline::app::help_page("report"));
  const auto arguments = std::make_shared<ReportArguments>();
  command.option("-o,--output", arguments->directory, "Folder for the report").default_value().value("DIR");
  std::string parts;
  for (const report::Part& part : report::report_parts())
    parts += fmt::format("{}{} {}", parts.empty() ? "" : "; ", part.number, part.title);
  command.option("--part", arguments->parts, "Only this part: " + parts).value("N").one_at_a_time();
  command
      .option("--cache", arguments->cache,
              "Folder that stores events of rotating scenes for the next report; unusable files are replaced")
      .default_value("cache in the report's folder")
      .value("DIR");
  command.flag("--full", arguments->full, "Measure longer, for more accurate figures");
  command.flag("--no-host-times", arguments->no_host_times,
               "Leave out times of this computer: the same bytes in every run");
  command.flag("-q,--quiet", arguments->quiet, "No progress and no summary");
  command.run([arguments] { return run_report(*arguments); });
}

}  // namespace

int main(int argc, char** argv) {
  return sightline::app::run_command_line(argc, argv, {sightline::app::help_page("sightline").summary, ""},
                                          add_report_command);
}
