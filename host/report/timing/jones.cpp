// Numbers: C. B. Jones, "A new approach to the 'hidden line' problem", The Computer Journal 14(3), 1971.
#include "host/report/timing/jones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/report/guest_runs.hpp"
#include "host/report/timing/paper_numbers.hpp"

namespace sightline::harness::report {

namespace {

using Runs = std::vector<std::pair<JonesOrder, JonesRun>>;

double view_seconds(const JonesRun& run) {
  return seconds(run.view().time);
}

template <class Value>
std::pair<double, double> range_of(const Runs& runs, Value&& value) {
  double least = value(runs.front().second);
  double greatest = least;
  for (const auto& [order, run] : runs) {
    least = std::min(least, value(run));
    greatest = std::max(greatest, value(run));
  }
  return {least, greatest};
}

const JonesRun& run_of(const Runs& runs, std::string_view scene, bool eae) {
  return std::find_if(runs.begin(), runs.end(),
                      [&](const auto& run) { return run.first.scene == scene && run.first.eae == eae; })
      ->second;
}

constexpr int places = 3;
constexpr const char* all_views = "second default view of each of five scenes, with and without EAE";

std::vector<PaperNumber> times(const Runs& runs, const JonesRun& pair) {
  const auto [fastest, slowest] = range_of(runs, view_seconds);
  const double roberts_eae = view_seconds(run_of(runs, "roberts", true));
  const double roberts = view_seconds(run_of(runs, "roberts", false));
  const auto seconds_long =
      std::count_if(runs.begin(), runs.end(), [](const auto& run) { return view_seconds(run.second) >= 1; });
  const auto smooth = std::count_if(runs.begin(), runs.end(),
                                    [](const auto& run) { return view_seconds(run.second) <= 1.0 / 16; });
  return {
      {"abstract", "\"views which were generated in a few seconds\"", Real{fastest, places},
       Real{slowest, places}, "s", all_views,
       fmt::format(
           "the same order: {} of {} take a second or more. Whether his machine had the EAE is not said",
           seconds_long, runs.size())},
      {"performance", "\"of the order of a few seconds for some objects which have been tried\"",
       Real{fastest, places}, Real{slowest, places}, "s", all_views, "as above"},
      {"Figs. 8-10, 13",
       "photographs that \"show the computing time in seconds for each view\"",
       {},
       {},
       "s",
       "",
       "cannot be compared: the times are in the photographs, which cannot be read in the copy at hand, and "
       "the coordinates of the objects are not given"},
      {"Figs. 11, 12", "likewise, of an object after Roberts (1963)", Real{roberts_eae, places},
       Real{roberts, places}, "s", "roberts, with and without EAE",
       "cannot be compared to the digit: the times cannot be read in the copy at hand, and roberts is made "
       "after the description, not from his data"},
      {"performance", "Roberts's own program, \"several minutes ... on the then dedicated TX-2\"",
       Real{roberts_eae, places}, Real{roberts, places}, "s", "roberts, with and without EAE",
       "cannot be compared: another program on another machine, from hearsay (\"believed\")"},
      {"performance", "\"sixteen frames per second\", not reached", Real{1 / slowest, 1},
       Real{1 / fastest, 1}, "views/s", all_views,
       fmt::format("{} of {} views are computed that fast; the others are not, as he says", smooth,
                   runs.size())},
      {"Fig. 14",
       "a stereoscopic pair, \"two views\"; no time given",
       {},
       Real{view_seconds(pair), places},
       "s",
       "roberts as a pair, with EAE",
       fmt::format("cannot be compared: no time is given. Here a pair takes {:.2f} times one view",
                   view_seconds(pair) / roberts_eae)},
  };
}

std::vector<PaperNumber> sizes(const Runs& runs) {
  const auto [fewest, most] =
      range_of(runs, [](const JonesRun& run) { return static_cast<double>(run.program.words_used); });
  const JonesRun& house = run_of(runs, "house", true);
  const JonesRun& street = run_of(runs, "street4", true);
  std::size_t opening_words = 0;
  for (const scene::Opening& opening : street.scene.openings) opening_words += 6 + opening.vectors.size();
  const auto count = [](auto value) { return static_cast<std::int64_t>(value); };
  return {
      {"implementation", "\"8192 18-bit words of core storage\"", count(fewest), count(most), "words",
       "program, scene, stack and two display files of all runs", "all fit, with no word to give away"},
      {"implementation",
       "\"cycle time of 1.75 microseconds\"",
       {},
       Real{1.75, 2},
       "us",
       "the emulated PDP-7",
       "the same machine"},
      {"implementation", "\"a DEC type 340 CRT display\"",
       Real{seconds(house.guest.refresh_period) * 1000, 2},
       Real{seconds(street.guest.refresh_period) * 1000, 2}, "ms", "one refresh of house and of street4",
       "cannot be compared: no refresh time is given"},
      {"Fig. 2",
       "a house plan of three rooms",
       {},
       count(house.program.scene.cell_addresses.size()),
       "cells",
       "house",
       "the same three rooms; their measures are not given"},
      {"Fig. 6", "an opening-element of six words and one for each vector", count(opening_words),
       count(street.program.scene.opening_words), "words", "street4: counted by the figure, and as assembled",
       "the same layout, two words of cells, three of the origin, one of the count"},
      {"Fig. 6",
       "a cell-element of four words, one for each vector, one for each opening",
       {},
       count(street.program.scene.cell_words),
       "words",
       "street4",
       "the same layout"},
      {"controls", "\"eight sense switches\"", {}, count(8), "switches", "AC switches 0 to 7", "the same"},
      {"lists",
       "the number of cells, openings and lines of the objects in Figs. 8-13",
       {},
       {},
       "",
       "",
       "cannot be compared: not given"},
  };
}

Table views_table(const Runs& runs) {
  Table table;
  table.id = "jones-views";
  table.title = "Jones: computing time of the default views";
  table.columns = {{"scene", "Scene", "", false},
                   {"eae", "EAE", "", false},
                   {"first_view_s", "First view", "s", false},
                   {"second_view_s", "Second view", "s", false},
                   {"views_per_s", "Rate", "views/s", false},
                   {"instructions", "Instructions", "", false},
                   {"lines_clipped", "Lines clipped", "", false},
                   {"pieces", "Pieces drawn", "", false},
                   {"refreshes_per_s", "Refresh", "1/s", false}};
  for (const auto& [order, run] : runs) {
    const guests::jones::GuestView& view = run.view();
    const double period = seconds(run.guest.refresh_period);
    table.rows.push_back(
        {order.scene, std::string(order.eae ? "yes" : "no"),
         Real{seconds(run.guest.views.front().time), places}, Real{view_seconds(run), places},
         Real{1 / view_seconds(run), 1}, static_cast<std::int64_t>(view.instructions),
         static_cast<std::int64_t>(view.lines_clipped), static_cast<std::int64_t>(view.pieces),
         period > 0 ? Cell(Real{1 / period, 1}) : Cell()});
  }
  table.notes = {
      "Seconds of the emulated PDP-7, from the start of the search to the moment the new display file is put "
      "in the place of the old. During the first view the display is dark; during the second it shows the "
      "first and takes cycles from the processor. In every run the display file is, word for word, the one "
      "the native twin makes."};
  return table;
}

Outcome<Gallery> screens(const Runs& runs, bool phosphor) {
  Gallery gallery{phosphor ? "jones-phosphor" : "jones-screens",
                  phosphor ? "Jones: the screen, photographed" : "Jones: the pictures, point by point",
                  {}};
  for (const auto& [order, run] : runs) {
    if (!order.eae) continue;
    auto png = phosphor ? phosphor_png(run) : crisp_png(run);
    if (!png) return std::move(png.error());
    const double plain = view_seconds(run_of(runs, order.scene, false));
    gallery.figures.push_back(
        {fmt::format("{}-{}", phosphor ? "phosphor" : "screen", order.scene), order.scene,
         fmt::format("{:.3f} s, without EAE {:.3f} s", view_seconds(run), plain),
         fmt::format("Hidden-line drawing of the scene {} on the Type 340, {} pieces of lines{}", order.scene,
                     run.view().pieces, phosphor ? ", as the glowing screen shows it" : ""),
         "image/png", std::move(*png), false, false});
  }
  return gallery;
}

}  // namespace

Outcome<std::vector<Block>> timing_of_jones(const Context& context) {
  auto made = run_all_jones(context, true);
  if (!made) return std::move(made.error());
  const Runs runs = std::move(*made);
  const auto pair = run_jones({"roberts", true, true, false});
  if (!pair) return pair.error();
  std::vector<Block> blocks;
  blocks.emplace_back(
      paper_table("jones-paper-times", "Jones 1971: every number for time", times(runs, *pair)));
  blocks.emplace_back(paper_table("jones-paper-sizes", "Jones 1971: every number for size", sizes(runs)));
  blocks.emplace_back(views_table(runs));
  for (const bool phosphor : {true, false}) {
    context.progress(phosphor ? "the photographs" : "the pictures");
    auto gallery = screens(runs, phosphor);
    if (!gallery) return std::move(gallery.error());
    blocks.emplace_back(std::move(*gallery));
  }
  return blocks;
}

}  // namespace sightline::harness::report
