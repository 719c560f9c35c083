#include "host/report/make_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "host/report/layout.hpp"
#include "host/report/plot.hpp"
#include "host/report/render.hpp"

namespace sightline::report {

namespace {

const Experiment& experiment_named(std::string_view name) {
  const auto all = all_experiments();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Experiment& known) { return known.name == name; });
  if (found == all.end())
    throw Failure(ErrorKind::bad_input, fmt::format("found experiment \"{}\" in a data file, but not among those of this program", name));
  return *found;
}

Figure drawn(const Plot& plot) {
  auto figure = draw_plot(plot);
  if (!figure) throw Failure(std::move(figure.error()));
  return *std::move(figure);
}

}  // namespace

Outcome<std::vector<Block>> make_chapter(std::string_view name, const Context& context) {
  try {
    const Layout layout = read_layout(layout_files());
    const Chapter& chapter = layout.chapters.find(name)->second;
    Results results;
    for (const std::string& experiment : chapter.experiments())
      results[experiment] = experiment_named(experiment).run(context);
    return render(chapter, layout, results, {context.host_times, drawn});
  } catch (const Failure& failure) {
    return failure.error();
  }
}

}  // namespace sightline::report
