#include "host/report/timing/papers.hpp"

#include <array>
#include <functional>
#include <iterator>
#include <utility>

#include "host/report/make_report.hpp"
#include "host/report/timing/jones.hpp"
#include "host/report/timing/montani_re.hpp"
#include "host/report/timing/plantinga.hpp"
#include "host/report/timing/willis.hpp"

namespace sightline::harness::report {

Outcome<Section> timing_against_papers(const Context& context) {
  Section section{"timing", "Timing against the papers", {}};
  section.blocks.emplace_back(Paragraph{
      "Every number that the papers give for time or size, beside the same number of the program here. "
      "Times of Jones and Skala are of the emulated machines: they follow from cycle counts, depend on no "
      "clock of this computer, and come out the same in every run. Where a number cannot be compared, the "
      "table says why."});
  const auto skala = [](const Context& of) { return make_chapter("skala-timing", of); };
  const std::array<std::function<Outcome<std::vector<Block>>(const Context&)>, 5> papers{
      &timing_of_jones, skala, &timing_of_montani_re, &timing_of_plantinga, &timing_of_willis};
  for (const auto& paper : papers) {
    auto blocks = paper(context);
    if (!blocks) return std::move(blocks.error());
    auto& made = *blocks;
    section.blocks.insert(section.blocks.end(), std::make_move_iterator(made.begin()),
                          std::make_move_iterator(made.end()));
  }
  return section;
}

}  // namespace sightline::harness::report
