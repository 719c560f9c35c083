#include "host/report/speed_error/speed_error.hpp"

#include <iterator>
#include <utility>

#include "host/guests/jones/precision/study.hpp"
#include "host/report/plot.hpp"
#include "host/report/speed_error/jones.hpp"
#include "host/report/speed_error/jones_blocks.hpp"
#include "host/report/speed_error/montani_re.hpp"
#include "host/report/speed_error/plantinga.hpp"
#include "host/report/speed_error/published.hpp"
#include "host/report/speed_error/skala.hpp"
#include "host/report/speed_error/skala_blocks.hpp"
#include "host/report/speed_error/willis.hpp"

namespace sightline::harness::report {

namespace {

void append(Section& section, std::vector<Block> blocks) {
  section.blocks.insert(section.blocks.end(), std::make_move_iterator(blocks.begin()),
                        std::make_move_iterator(blocks.end()));
}

}  // namespace

Outcome<Section> speed_against_error(const Context& context) {
  if (auto missing = gnuplot_missing()) return std::move(*missing);
  Section section{"speed-error", "Speed against error", {}};
  section.blocks.emplace_back(Paragraph{
      "What the short words and coarse rasters of their time cost the two programs in truth, and what they "
      "bought in time. To the left of every plot is less error, below is less time. Both axes are "
      "logarithmic; an error of exactly 0 has no place there and stands at a mark named 0. Seconds of the "
      "emulated machines and times of this computer are in figures of their own."});
  section.blocks.emplace_back(Heading{"Jones"});
  section.blocks.emplace_back(Paragraph{
      "Six views a scene, against exact visibility. L_sym is the length that is drawn and not visible or "
      "visible and not drawn, in terms of the visible; of L_extra(>1 px) only counts what is farther than a "
      "pixel from every visible line, which is what a person sees. H is the greatest distance between what "
      "is drawn and what is visible, WVR the share of random points on all lines, a pixel or more from any "
      "end, that are wrongly seen or hidden."});
  auto jones = measure_jones(context);
  if (!jones) return std::move(jones.error());
  auto jones_blocks = jones_error_blocks(*jones);
  if (!jones_blocks) return std::move(jones_blocks.error());
  append(section, std::move(*jones_blocks));
  context.progress("the error table on the PDP-7");
  append(section, published_error_blocks(guests::jones::measure_error_table()));

  section.blocks.emplace_back(Heading{"Skala"});
  section.blocks.emplace_back(Paragraph{
      "Pictures of three functions turned by 30 degrees, held against the native program with 16384 columns "
      "of masks, 64 to a dot of the 8080's raster. PMR is the share of the raster's dots that differ, H the "
      "greatest distance between the dots or lines of the two pictures."});
  const auto skala = measure_skala(context);
  if (!skala) return skala.error();
  auto skala_blocks = skala_error_blocks(*skala);
  if (!skala_blocks) return std::move(skala_blocks.error());
  append(section, std::move(*skala_blocks));

  section.blocks.emplace_back(Heading{"Montani and Re"});
  auto montani_re = montani_re_error_part(context);
  if (!montani_re) return std::move(montani_re.error());
  append(section, std::move(*montani_re));

  section.blocks.emplace_back(Heading{"Willis"});
  section.blocks.emplace_back(
      Paragraph{"Surfaces in the order of their distances, each cut as often as the limit allows until no "
                "two are in each other's boundary, held against the nearest face on every sight line."});
  auto willis_blocks = willis_error_blocks(measure_willis(context));
  if (!willis_blocks) return std::move(willis_blocks.error());
  append(section, std::move(*willis_blocks));

  section.blocks.emplace_back(Heading{"Plantinga, Seales and Dyer"});
  section.blocks.emplace_back(
      Paragraph{"Models that turn, held against hidden-line removal from scratch at random angles. TOPO is "
                "the share of angles at which any edge has other pieces or other ends than it should, WVR "
                "the share of the length of all edges in the image that is wrongly seen or hidden."});
  const auto plantinga = measure_plantinga(context);
  if (!plantinga) return plantinga.error();
  auto plantinga_blocks = plantinga_error_blocks(*plantinga);
  if (!plantinga_blocks) return std::move(plantinga_blocks.error());
  append(section, std::move(*plantinga_blocks));
  return section;
}

}  // namespace sightline::harness::report
