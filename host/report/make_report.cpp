#include "host/report/make_report.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <mutex>
#include <set>
#include <utility>

#include "host/base/parallel.hpp"

namespace sightline::report {

namespace {

// The result of the work, or the error that it throws.
template <class Work>
auto caught(const Work& work) -> base::Result<decltype(work())> {
  try {
    return work();
  } catch (const base::Error& error) {
    return error;
  }
}

bool is_chosen(int part, std::span<const int> numbers) {
  return numbers.empty() || std::find(numbers.begin(), numbers.end(), part) != numbers.end();
}

std::vector<Experiment> experiments_of(std::span<const int> parts) {
  std::set<std::type_index> taken;
  for (const SectionPlan& section : report_sections())
    for (const Chapter& chapter : section.chapters)
      if (is_chosen(chapter.part, parts)) taken.insert(chapter.takes.begin(), chapter.takes.end());
  std::vector<Experiment> chosen;
  for (const Experiment& experiment : report_experiments())
    if (taken.contains(experiment.gives)) chosen.push_back(experiment);
  return chosen;
}

// Runs the experiments on `jobs` processors.
void run(std::span<const Experiment> experiments, unsigned jobs, const Context& context, Results& results) {
  base::OrderedWork<std::shared_ptr<void>> work;
  work.last = experiments.size();
  work.jobs = jobs;
  work.make = [&](std::uint64_t i) { return experiments[i].run(context); };
  work.take = [&](std::uint64_t i, std::shared_ptr<void> data) { results.store(experiments[i].gives, std::move(data)); };
  work.go_on = [] { return true; };
  base::run_in_order(work);
}

Results run_all(std::vector<Experiment> experiments, const Context& told) {
  // Several experiments may report progress and schedule work at the same time.
  std::mutex mutex;
  std::vector<std::function<void()>> left;
  Context context = told;
  context.progress = [&](std::string_view step) {
    const std::lock_guard lock(mutex);
    told.progress(step);
  };
  context.when_alone = [&](std::function<void()> work) {
    const std::lock_guard lock(mutex);
    left.push_back(std::move(work));
  };
  const auto timed = std::stable_partition(experiments.begin(), experiments.end(), [&](const Experiment& experiment) {
    return !(experiment.host_times && context.host_times);
  });
  Results results;
  run({experiments.begin(), timed}, context.jobs, context, results);
  run({timed, experiments.end()}, 1, context, results);
  for (const auto& work : left) work();
  return results;
}

std::vector<Block> blocks_of(const Chapter& chapter, const Results& results, const Context& context) {
  Page page(context.host_times);
  chapter.write(page, results);
  return std::move(page).blocks();
}

Report written(std::span<const int> parts, const Results& results, const Context& context) {
  Report report{"Sightline report", {}, {}, {}};
  if (!context.host_times)
    report.introduction.emplace_back("Without times of this computer: the same program writes the same bytes.");
  struct Place {
    std::size_t section;
    const Chapter* chapter;
  };
  std::vector<Place> chapters;
  for (const SectionPlan& plan : report_sections()) {
    const std::size_t first = chapters.size();
    for (const Chapter& chapter : plan.chapters)
      if (is_chosen(chapter.part, parts)) chapters.push_back({report.sections.size(), &chapter});
    if (chapters.size() == first) continue;
    Section& section = report.sections.emplace_back(Section{plan.id, plan.title, {}});
    if (!plan.paper.empty()) section.blocks.emplace_back(Paragraph{Papers::built_in().paper(plan.paper).citation() + "."});
  }
  // Plots are drawn by another program, which takes most of the time.
  base::OrderedWork<std::vector<Block>> work;
  work.last = chapters.size();
  work.jobs = context.jobs;
  work.make = [&](std::uint64_t i) { return blocks_of(*chapters[i].chapter, results, context); };
  work.take = [&](std::uint64_t i, std::vector<Block> blocks) {
    const auto& [section, chapter] = chapters[i];
    std::vector<Block>& all = report.sections[section].blocks;
    // Chapters of one part follow each other under its title.
    const bool begins = i == 0 || chapters[i - 1].section != section || chapters[i - 1].chapter->part != chapter->part;
    if (begins && chapter->part != 0)
      all.emplace_back(Heading{only(report_parts(), equals(&Part::number, chapter->part)).title, chapter->id});
    all.insert(all.end(), std::make_move_iterator(blocks.begin()), std::make_move_iterator(blocks.end()));
  };
  work.go_on = [] { return true; };
  base::run_in_order(work);
  return report;
}

}  // namespace

base::Result<Results> run_experiments(std::span<const int> parts, const Context& context) {
  return caught([&] { return run_all(experiments_of(parts), context); });
}

base::Result<Report> report_of(std::span<const int> parts, const Results& results, const Context& context) {
  return caught([&] { return written(parts, results, context); });
}

base::Result<Report> make_report(std::span<const int> parts, const Context& context) {
  return caught([&] { return written(parts, run_all(experiments_of(parts), context), context); });
}

}  // namespace sightline::report
