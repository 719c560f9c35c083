#include "host/report/make_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "host/base/parallel.hpp"
#include "host/report/layout.hpp"
#include "host/report/plot.hpp"

namespace sightline::report {

namespace {

// What the work gives, or the failure that it throws.
template <class Work>
auto caught(const Work& work) -> Outcome<decltype(work())> {
  try {
    return work();
  } catch (const Failure& failure) {
    return failure.error();
  }
}

using Experiments = std::vector<const Experiment*>;

Experiments experiments_named(const std::set<std::string>& names) {
  Experiments chosen;
  for (const Experiment& experiment : all_experiments())
    if (names.empty() || names.contains(std::string(experiment.name))) chosen.push_back(&experiment);
  for (const std::string& name : names) {
    if (std::any_of(chosen.begin(), chosen.end(), [&](const Experiment* known) { return known->name == name; })) continue;
    throw Failure(ErrorKind::bad_input, fmt::format("a data file takes records of \"{}\": found no such experiment", name));
  }
  return chosen;
}

// On `jobs` processors; results in the order of the experiments. `alone`: what they leave to be done alone.
using Alone = std::vector<std::function<void(Results&)>>;
void run(const Experiments& experiments, unsigned jobs, const Context& context, Results& results, Alone& alone) {
  std::vector<Alone> of_each(experiments.size());
  base::OrderedWork<Records> work;
  work.last = experiments.size();
  work.jobs = jobs;
  work.make = [&](std::uint64_t i) {
    Context here = context;
    here.alone = [&of_each, name = std::string(experiments[i]->name), i](std::function<void(Records&)> timed) {
      of_each[i].emplace_back([name, timed = std::move(timed)](Results& of_all) { timed(of_all.at(name)); });
    };
    return experiments[i]->run(here);
  };
  work.take = [&](std::uint64_t i, Records records) { results[std::string(experiments[i]->name)] = std::move(records); };
  work.go_on = [] { return true; };
  base::run_in_order(work);
  for (Alone& works : of_each) std::move(works.begin(), works.end(), std::back_inserter(alone));
}

Results run_all(const std::set<std::string>& names, const Context& told) {
  // Several experiments may tell of their progress at once.
  std::mutex mutex;
  Context context = told;
  context.progress = [&](std::string_view step) {
    const std::lock_guard lock(mutex);
    told.progress(step);
  };
  const auto takes_times = [&](const Experiment* experiment) { return experiment->host_times && context.host_times; };
  Experiments together = experiments_named(names);
  const auto alone_from = std::stable_partition(together.begin(), together.end(),
                                                [&](const Experiment* experiment) { return !takes_times(experiment); });
  const Experiments timed(alone_from, together.end());
  together.erase(alone_from, together.end());
  Results results;
  Alone alone;
  run(together, context.jobs, context, results, alone);
  run(timed, 1, context, results, alone);
  for (const auto& work : alone) work(results);
  return results;
}

Figure drawn(const Plot& plot) {
  auto figure = draw_plot(plot);
  if (!figure) throw Failure(std::move(figure.error()));
  return *std::move(figure);
}

bool is_chosen(int part, std::span<const int> numbers) {
  return numbers.empty() || std::find(numbers.begin(), numbers.end(), part) != numbers.end();
}

std::set<std::string> experiments_of(const Layout& layout, std::span<const int> numbers) {
  std::set<std::string> names;
  for (const SectionLayout& section : layout.sections)
    for (const auto& [chapter, part] : section.chapters)
      if (is_chosen(part, numbers))
        for (const std::string& name : layout.chapters.at(chapter).experiments()) names.insert(name);
  return names;
}

Report written(const Layout& layout, std::span<const int> numbers, const Results& results, const Context& context) {
  Report report{layout.title, {}, layout.introduction, {}};
  if (!context.host_times) report.introduction.push_back(layout.without_host_times);
  struct Place {
    std::size_t section;
    const std::string* chapter;
    int part;
  };
  std::vector<Place> chapters;
  for (const SectionLayout& layout_of : layout.sections) {
    const std::size_t first = chapters.size();
    for (const auto& [name, part] : layout_of.chapters)
      if (is_chosen(part, numbers)) chapters.push_back({report.sections.size(), &name, part});
    if (chapters.size() == first) continue;
    Section& section = report.sections.emplace_back(Section{layout_of.id, layout_of.title, {}});
    if (!layout_of.paper.empty()) section.blocks.emplace_back(Paragraph{layout.paper(layout_of.paper)->citation() + "."});
  }
  // Plots are drawn by another program, which takes most of the time.
  base::OrderedWork<std::vector<Block>> work;
  work.last = chapters.size();
  work.jobs = context.jobs;
  work.make = [&](std::uint64_t i) {
    return render(layout.chapters.at(*chapters[i].chapter), layout, results, {context.host_times, drawn});
  };
  work.take = [&](std::uint64_t i, std::vector<Block> blocks) {
    const Place& place = chapters[i];
    std::vector<Block>& all = report.sections[place.section].blocks;
    // Chapters of one part follow each other under its title.
    const bool begins = i == 0 || chapters[i - 1].section != place.section || chapters[i - 1].part != place.part;
    if (begins && place.part != 0) all.emplace_back(Heading{layout.part(place.part)->title, *place.chapter});
    all.insert(all.end(), std::make_move_iterator(blocks.begin()), std::make_move_iterator(blocks.end()));
  };
  work.go_on = [] { return true; };
  base::run_in_order(work);
  return report;
}

}  // namespace

Outcome<std::vector<PartLayout>> all_parts() {
  return caught([] { return read_layout(layout_files()).parts; });
}

Outcome<Report> make_report(std::span<const int> parts, const Context& context) {
  return caught([&] {
    const Layout layout = read_layout(layout_files());
    const std::set<std::string> names = experiments_of(layout, parts);
    return written(layout, parts, names.empty() ? Results() : run_all(names, context), context);
  });
}

Outcome<Report> report_of(std::span<const int> parts, const Results& results, const Context& context) {
  return caught([&] { return written(read_layout(layout_files()), parts, results, context); });
}

Outcome<Results> run_experiments(std::vector<std::string> names, const Context& context) {
  return caught([&] { return run_all({names.begin(), names.end()}, context); });
}

}  // namespace sightline::report
