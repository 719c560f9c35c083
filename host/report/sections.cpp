#include "host/report/sections.hpp"

#include <stdexcept>

#include "host/report/experiments/jones_accuracy.hpp"
#include "host/report/experiments/jones_unseen.hpp"
#include "host/report/experiments/jones_views.hpp"
#include "host/report/experiments/skala_accuracy.hpp"
#include "host/report/experiments/skala_pictures.hpp"

namespace sightline::report {

namespace {

// Of data/ID.json: a chapter that is not moved yet. Once its line is chapter("ID", part, &function), and its experiments
// are lines of report_experiments (and no more of experiments.cpp), its file in data/ goes. The opening page comes back
// when all of them are moved.
Chapter old(std::string id, int part) {
  return {std::move(id), part, {}, {}};
}

}  // namespace

const void* Results::find(std::type_index type) const {
  const auto found = data_.find(type);
  if (found == data_.end()) throw std::logic_error(std::string("no experiment was run that gives ") + type.name());
  return found->second.get();
}

const std::vector<Part>& report_parts() {
  static const std::vector<Part> parts{{1, "Timing against the papers"},
                                       {2, "Accuracy against time"},
                                       {3, "Hard cases"},
                                       {4, "Resource usage"},
                                       {5, "Cross-check"}};
  return parts;
}

const std::vector<Experiment>& report_experiments() {
  static const std::vector<Experiment> experiments{
      experiment(&jones_numbers),
      experiment(&skala_accuracy),
      experiment(&jones_accuracy),
      experiment(&jones_views),
      experiment(&skala_pictures),
      experiment(&jones_unseen, true),
  };
  return experiments;
}

const std::vector<SectionPlan>& report_sections() {
  static const std::vector<SectionPlan> sections{
      {"jones", "Jones 1971: cells and portals on a PDP-7", "jones",
       {chapter("jones-timing", 1, &jones_timing),
        chapter("jones-accuracy", 2, &jones_accuracy_chapter),
        chapter("jones-needs", 4, &jones_needs),
        chapter("jones-unseen", 4, &jones_unseen_chapter)}},
      {"skala", "Skala 1985: slices of a surface on an 8080", "skala",
       {chapter("skala-timing", 1, &skala_timing),
        chapter("skala-accuracy", 2, &skala_accuracy_chapter),
        chapter("skala-needs", 4, &skala_needs)}},
      {"montani-re", "Montani and Re 1985: faces as stripes", "montani_re",
       {old("montani-re-timing", 1),
        old("montani-re-8080", 1),
        old("montani-re-accuracy", 2)}},
      {"willis", "Willis 1977: distance as priority", "willis",
       {old("willis-timing", 1),
        old("willis-flight", 1),
        old("willis-accuracy", 2)}},
      {"plantinga", "Plantinga, Seales and Dyer 1990: a rotating scene", "plantinga",
       {old("plantinga-timing", 1),
        old("plantinga-pdp7", 1),
        old("plantinga-accuracy", 2)}},
      {"cases", "Hard cases: inputs that break programs of this kind", "",
       {old("hard-cases", 3)}},
      {"agreement", "Cross-check: every method against every other", "",
       {old("cross-check", 5)}},
      {"about", "About this report", "",
       {old("about", 0)}},
  };
  return sections;
}

}  // namespace sightline::report
