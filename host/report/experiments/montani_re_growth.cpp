#include "host/report/experiments/montani_re_growth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <string_view>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/algorithms/montani_re/visible_edges.hpp"
#include "host/algorithms/montani_re/visible_regions.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/montani_re_stripes.hpp"
#include "host/report/experiments/montani_re_tables.hpp"
#include "host/report/page.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::report {

namespace {

namespace native = algorithms::montani_re;

constexpr std::int32_t raster = 1024;
constexpr std::size_t long_scene = 10000;  // one view takes seconds

// A frame around all faces.
native::StripeFrame frame_of(const native::FaceSet& set, const scene::PolyCamera& camera) {
  std::array<double, 2> low{1e300, 1e300};
  std::array<double, 2> high{-1e300, -1e300};
  for (const native::Face& face : set.faces) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], face.low[axis].approximate);
      high[axis] = std::max(high[axis], face.high[axis].approximate);
    }
  }
  native::StripeFrame frame{{}, {}, raster, raster};
  const auto unit = native::pixels_per_unit(camera, 1);
  const double size = std::max((high[0] - low[0]) * unit[0], (high[1] - low[1]) * unit[1]);
  frame.scale = native::pixels_per_unit(camera, raster / size);
  for (std::size_t axis = 0; axis < 2; ++axis) frame.centre[axis] = -low[axis] * frame.scale[axis];
  return frame;
}

struct StripesView {
  std::size_t faces = 0;
  native::RegionCounts counts;
  native::StripeRaster picture;
};

// Relations and list, then the raster.
StripesView stripes_of(const scene::PolyScene& scene) {
  const auto faces = native::faces_of(scene, scene.camera);
  const native::ListedFaces listed = native::listed_faces(*faces);
  return {faces->faces.size(), listed.counts,
          native::raster_by_difference(faces->image, listed.list, listed.faces, frame_of(*faces, scene.camera), 16)};
}

GrowthView view_of(std::string_view family, std::size_t size, const scene::PolyScene& scene, int rounds) {
  const StripesView view = stripes_of(scene);
  std::uint64_t pairs = 0;
  for (std::size_t test = 2; test < view.counts.decided_by.size(); ++test) pairs += view.counts.decided_by[test];
  GrowthView row{.family = std::string(family),
                 .size = size,
                 .faces = view.faces,
                 .y_complexity = 2 * static_cast<double>(pairs) / static_cast<double>(view.faces),
                 .pairs = pairs,
                 .relations = view.counts.relations,
                 .sides_seen = view.picture.sides,
                 .silhouette_sides = view.picture.silhouette_sides};
  if (rounds == 0) return row;
  const std::array<std::function<void()>, 3> jobs{[&scene] { (void)native::visible_edges(scene, scene.camera); },
                                                  [&scene] { (void)stripes_of(scene); },
                                                  [&scene] { (void)algorithms::exact::visible_edges(scene, scene.camera); }};
  const auto times = median_nanoseconds(jobs, size < long_scene ? rounds : 1);
  row.exact_build_ms = times[0] / 1e6;
  row.stripes_ms = times[1] / 1e6;
  row.exact_ms = times[2] / 1e6;
  return row;
}

GrowthExponents exponents_of(std::span<const GrowthView> views) {
  const auto faces = [](const GrowthView& view) { return static_cast<double>(view.faces); };
  const auto pairs = [](const GrowthView& view) { return static_cast<double>(view.pairs); };
  const auto exact_build = [](const GrowthView& view) { return view.exact_build_ms; };
  const auto exponent = [views](const auto& over, const auto& value) {
    std::vector<std::pair<double, double>> points;
    for (const GrowthView& view : views)
      if (const std::optional<double> y = value(view)) points.emplace_back(over(view), *y);
    return growth_exponent(points, 2);
  };
  return {.family = views.front().family,
          .from_faces = views.front().faces,
          .to_faces = views.back().faces,
          .pairs = exponent(faces, pairs),
          .relations = exponent(faces, [](const GrowthView& view) { return static_cast<double>(view.relations); }),
          .exact_build = exponent(faces, exact_build),
          .stripes = exponent(faces, [](const GrowthView& view) { return view.stripes_ms; }),
          .exact = exponent(faces, [](const GrowthView& view) { return view.exact_ms; }),
          .exact_build_over_pairs = exponent(pairs, exact_build)};
}

void add_claims(Page& page, const MontaniReGrowth& growth, const std::vector<FaceCycle>& cycles) {
  const GrowthView& first = growth.views.front();
  const auto sizes = range_of(growth.views, &GrowthView::size);
  const auto largest = where(growth.views, equals(&GrowthView::size, sizes.greatest));
  const auto share = [](auto part, auto whole) { return text_of(100 * static_cast<double>(part) / static_cast<double>(whole), 0); };
  const auto relations = sum(largest, &GrowthView::relations);
  const auto pairs = sum(largest, &GrowthView::pairs);
  const FaceCycle& cycle = cycles.front();
  const FaceCycle& figure_10 = cycles.back();
  std::vector<ClaimRow> rows{
      {.claim = "montani_re.memory",
       .here = {as_cell(first.silhouette_sides), as_cell(first.sides_seen)},
       .condition = fmt::format("{} {}, stripes of a pixel on 1024 x 1024: the last silhouette; all visible parts of all faces",
                                first.family, first.size),
       .comparison = fmt::format("the silhouette has {} % of all sides; no number is given to compare: that needs the number of "
                                 "sides kept for a scene whose faces are known. Secondary storage is not modelled",
                                 share(first.silhouette_sides, first.sides_seen))},
      {.claim = "montani_re.linear",
       .here = least_and_greatest(growth.exponents, &GrowthExponents::pairs),
       .places = 2,
       .condition = "boxes and towns, growing to all sides",
       .comparison = greatest(growth.exponents, &GrowthExponents::pairs) <= 1.1 ? "almost linear"
                                                                                : "not for these scenes, where Y grows with N"}};
  if (page.host_times())
    rows.push_back({.claim = "montani_re.product",
                    .here = least_and_greatest(growth.exponents, &GrowthExponents::exact_build_over_pairs),
                    .places = 2,
                    .condition = "exact build, boxes and towns, time on this computer",
                    .comparison = greatest(growth.exponents, &GrowthExponents::exact_build_over_pairs) <= 1.1
                                      ? "no faster growth than the paper's"
                                      : "faster growth than the paper's"});
  rows.insert(
      rows.end(),
      {{.claim = "montani_re.tests",
        .here = {as_cell(relations), as_cell(pairs)},
        .condition = "the largest boxes and town together: relations; pairs that overlap in X, which tests 2 to 6 decide",
        .comparison = share(relations, pairs) + " % of these pairs have a relation"},
       {.claim = "montani_re.cycles",
        .here = one_figure(cycle.faces),
        .condition = cycle.what,
        .comparison =
            cycle.right ? fmt::format("solved by {} subtraction: the picture is the oracle's", cycle.cuts) : "not solved"},
       {.claim = "montani_re.figure_10",
        .here = one_figure(figure_10.faces),
        .condition = figure_10.what,
        .comparison = figure_10.right
                          ? fmt::format("solved here by cutting off {} parts: the picture is the oracle's", figure_10.parts)
                          : "not solved"},
       {.claim = "montani_re.thickness",
        .here = {as_cell(16.0 / stripe_units.back()), as_cell(16.0 / stripe_units.front())},
        .condition = "see Accuracy against time",
        .comparison = "what it costs is measured there"},
       {.claim = "montani_re.nothing",
        .comparison = "cannot be compared: needs a scene, a computer and a time, which a program listing or a later paper of the "
                      "authors may give"}});
  page.claims("montani-re-paper", "Montani and Re 1985: what it says of work and size", rows);
}

}  // namespace

std::optional<double> growth_exponent(const std::vector<std::pair<double, double>>& all, std::size_t fewest) {
  std::vector<std::pair<double, double>> points;
  std::copy_if(all.begin(), all.end(), std::back_inserter(points), [](const auto& point) { return point.second > 0; });
  if (points.size() < fewest) return std::nullopt;
  double x_mean = 0;
  double y_mean = 0;
  const auto count = static_cast<double>(points.size());
  for (const auto& [x, y] : points) {
    x_mean += std::log(x) / count;
    y_mean += std::log(y) / count;
  }
  double covariance = 0;
  double variance = 0;
  for (const auto& [x, y] : points) {
    covariance += (std::log(x) - x_mean) * (std::log(y) - y_mean);
    variance += (std::log(x) - x_mean) * (std::log(x) - x_mean);
  }
  return variance > 0 ? covariance / variance : 0;
}

MontaniReGrowth montani_re_growth(const Context& context) {
  std::vector<std::size_t> sizes{100, 300, 1000};
  if (context.full) sizes.push_back(long_scene);
  const int timed = context.full ? 5 : 3;
  MontaniReGrowth growth;
  for (const std::string_view family : {"boxes", "town"}) {
    for (const std::size_t size : sizes) {
      context.progress(fmt::format("views of {} {}", family, size));
      growth.views.push_back(view_of(family, size, *scene::generate_scene(family, size), context.host_times ? timed : 0));
    }
    growth.exponents.push_back(exponents_of(std::span(growth.views).last(sizes.size())));
  }
  return growth;
}

void montani_re_timing(Page& page, const MontaniReGrowth& growth, const MontaniReTables& tables) {
  add_claims(page, growth, tables.cycles);
  montani_re_printed_tables(page, tables);
  std::vector<CheckedText> notes{
      "Generated scenes from their own camera, in perspective, on 1024 x 1024 pixels. Only faces that take part are counted: "
      "of solids, those that face the eye. Tests 2 to 6 decide the pairs that overlap in X."};
  if (page.host_times())
    notes.emplace_back(
        "A view includes all steps: faces, sort, relations, list, differences, and output as pieces of edges (exact build, "
        "exact) or as pixels. Times are the processor's, medians of interleaved repetitions (scenes of 10000: one), of this "
        "computer.");
  page.table("montani-re-growth", "Montani and Re: views of scenes of increasing size", growth.views,
             {{"family", "Scenes", &GrowthView::family},
              {"size", "Size", &GrowthView::size},
              {"faces", "Faces, N", &GrowthView::faces},
              {"y_complexity", "Faces a face overlaps in X, Y", &GrowthView::y_complexity},
              {"pairs", "Pairs of these, N Y / 2", &GrowthView::pairs},
              {"relations", "Relations", &GrowthView::relations},
              {"sides_seen", "Sides seen", "stripes of a pixel", &GrowthView::sides_seen},
              {"silhouette_sides", "Sides of the last silhouette", "stripes of a pixel", &GrowthView::silhouette_sides},
              {"exact_build_ms", "Exact build", "ms", &GrowthView::exact_build_ms, Real::as_needed, host_time},
              {"stripes_ms", "Stripes of a pixel", "ms", &GrowthView::stripes_ms, Real::as_needed, host_time},
              {"exact_ms", "exact", "ms", &GrowthView::exact_ms, Real::as_needed, host_time}},
             {.notes = std::move(notes)});
  const auto pairs = least(growth.exponents, &GrowthExponents::pairs);
  page.table(
      "montani-re-exponents", "Montani and Re: exponents of growth with the number of faces", growth.exponents,
      {{"family", "Scenes", &GrowthExponents::family},
       {"from_faces", "From", "faces", &GrowthExponents::from_faces},
       {"to_faces", "To", "faces", &GrowthExponents::to_faces},
       {"pairs", "N Y, the paper's claim", &GrowthExponents::pairs},
       {"relations", "Relations", &GrowthExponents::relations},
       {"exact_build", "Exact build, time", &GrowthExponents::exact_build, Real::as_needed, host_time},
       {"stripes", "Stripes of a pixel, time", &GrowthExponents::stripes, Real::as_needed, host_time},
       {"exact", "exact, time", &GrowthExponents::exact, Real::as_needed, host_time},
       {"exact_build_over_pairs", "Exact build, time over N Y", &GrowthExponents::exact_build_over_pairs, Real::as_needed,
        host_time}},
      {.notes = {
           "The paper claims work linear in N Y, which it calls almost linear in N: that holds if Y is constant. " +
           page.claim(pairs > 1.1,
                      "In these scenes the number of faces that a face overlaps in X grows with N, so N Y grows faster than N.",
                      "the least exponent of N Y is " + text_of(pairs)) +
           " Least squares of logarithms over the sizes of the table above."}});
}

}  // namespace sightline::report
