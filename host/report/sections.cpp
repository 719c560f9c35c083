#include "host/report/sections.hpp"

#include <stdexcept>

#include "host/report/experiments/comparison.hpp"
#include "host/report/experiments/cross_check.hpp"
#include "host/report/experiments/hard_cases.hpp"
#include "host/report/experiments/jones_accuracy.hpp"
#include "host/report/experiments/jones_unseen.hpp"
#include "host/report/experiments/jones_views.hpp"
#include "host/report/experiments/jones_walk.hpp"
#include "host/report/experiments/montani_re_8080.hpp"
#include "host/report/experiments/montani_re_greys.hpp"
#include "host/report/experiments/montani_re_growth.hpp"
#include "host/report/experiments/montani_re_stripes.hpp"
#include "host/report/experiments/montani_re_tables.hpp"
#include "host/report/experiments/opening.hpp"
#include "host/report/experiments/overview.hpp"
#include "host/report/experiments/plantinga_accuracy.hpp"
#include "host/report/experiments/plantinga_growth.hpp"
#include "host/report/experiments/plantinga_pdp7.hpp"
#include "host/report/experiments/plantinga_turns.hpp"
#include "host/report/experiments/skala_accuracy.hpp"
#include "host/report/experiments/skala_pictures.hpp"
#include "host/report/experiments/skala_wishes.hpp"
#include "host/report/experiments/willis_facing.hpp"
#include "host/report/experiments/willis_flight.hpp"
#include "host/report/experiments/willis_order.hpp"
#include "host/report/experiments/willis_times.hpp"

namespace sightline::report {

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
      experiment(&compare_all, true),
      experiment(&opening_answer, true),
      experiment(&jones_numbers),
      experiment(&hard_cases),
      experiment(&skala_accuracy),
      experiment(&jones_accuracy),
      experiment(&willis_order),
      experiment(&willis_flight),
      experiment(&willis_facing),
      experiment(&cross_check),
      experiment(&jones_views),
      experiment(&jones_walks),
      experiment(&plantinga_accuracy),
      experiment(&plantinga_pdp7),
      experiment(&plantinga_growth, true),
      experiment(&skala_pictures),
      experiment(&skala_wishes),
      experiment(&montani_re_8080),
      experiment(&montani_re_greys),
      experiment(&montani_re_tables),
      experiment(&plantinga_turns, true),
      experiment(&jones_unseen, true),
      experiment(&montani_re_growth, true),
      experiment(&montani_re_stripes, true),
      experiment(&willis_times, true),
  };
  return experiments;
}

const std::vector<SectionPlan>& report_sections() {
  static const std::vector<SectionPlan> sections{
      {"opening", "The answer: how fast, how wrong, against what?", "",
       {chapter("opening", 0, &opening)}},
      {"overview", "Which lines can the eye see?", "",
       {chapter("overview", 0, &overview_question),
        chapter("method-jones", 0, &method_jones),
        chapter("method-willis", 0, &method_willis),
        chapter("method-montani-re", 0, &method_montani_re),
        chapter("method-skala", 0, &method_skala),
        chapter("method-plantinga", 0, &method_plantinga),
        chapter("finding-view-time", 0, &finding_view_time),
        chapter("finding-pdp7-turn", 0, &finding_pdp7_turn),
        chapter("finding-8080-stripes", 0, &finding_8080_stripes),
        chapter("finding-flight", 0, &finding_flight),
        chapter("finding-word-length", 0, &finding_word_length),
        chapter("finding-visibility-cost", 0, &finding_visibility_cost),
        chapter("finding-hard-cases", 0, &finding_hard_cases),
        chapter("finding-growth", 0, &finding_growth),
        chapter("finding-unseen", 0, &finding_unseen),
        chapter("finding-normals", 0, &finding_normals),
        chapter("finding-events", 0, &finding_events),
        chapter("finding-agreement", 0, &finding_agreement)}},
      {"jones", "Jones 1971: cells and portals on a PDP-7", "jones",
       {chapter("jones-timing", 1, &jones_timing),
        chapter("jones-walking", 1, &jones_walk_chapter),
        chapter("jones-accuracy", 2, &jones_accuracy_chapter),
        chapter("jones-needs", 4, &jones_needs),
        chapter("jones-unseen", 4, &jones_unseen_chapter)}},
      {"skala", "Skala 1985: slices of a surface on an 8080", "skala",
       {chapter("skala-timing", 1, &skala_timing),
        chapter("skala-accuracy", 2, &skala_accuracy_chapter),
        chapter("skala-smooth", 2, &skala_smooth_chapter),
        chapter("skala-needs", 4, &skala_needs)}},
      {"montani-re", "Montani and Re 1985: faces as stripes", "montani_re",
       {chapter("montani-re-timing", 1, &montani_re_timing),
        chapter("montani-re-8080", 1, &montani_re_8080_chapter),
        chapter("montani-re-greys", 1, &montani_re_greys_chapter),
        chapter("montani-re-accuracy", 2, &montani_re_accuracy)}},
      {"willis", "Willis 1977: distance as priority", "willis",
       {chapter("willis-timing", 1, &willis_timing),
        chapter("willis-flight", 1, &willis_flight_chapter),
        chapter("willis-facing", 1, &willis_facing_chapter),
        chapter("willis-accuracy", 2, &willis_accuracy)}},
      {"plantinga", "Plantinga, Seales and Dyer 1990: a rotating scene", "plantinga",
       {chapter("plantinga-timing", 1, &plantinga_timing),
        chapter("plantinga-pdp7", 1, &plantinga_pdp7_chapter),
        chapter("plantinga-accuracy", 2, &plantinga_accuracy_chapter),
        chapter("plantinga-growth", 4, &plantinga_growth_chapter)}},
      {"comparison-of-methods", "Comparison: all methods on many objects from many viewpoints", "",
       {chapter("comparison-chapter", 2, &comparison_chapter)}},
      {"cases", "Hard cases: inputs that break programs of this kind", "",
       {chapter("hard-cases", 3, &hard_cases_chapter)}},
      {"agreement", "Cross-check: methods compared in pairs", "",
       {chapter("cross-check", 5, &cross_check_chapter)}},
      {"about", "About this report", "",
       {chapter("about", 0, &about)}},
  };
  return sections;
}

}  // namespace sightline::report
