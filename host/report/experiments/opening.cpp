#include "host/report/experiments/opening.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "host/compare/height_devices.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/papers.hpp"
#include "host/compare/scenes.hpp"
#include "host/compare/variants.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/model/aim_camera.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::report {

namespace {

using compare::AnswerRow;
using compare::Spread;

constexpr std::string_view cells_in_plot = "roberts";
constexpr std::size_t boxes = 20;
constexpr std::size_t turned_boxes = 8;
constexpr scene::PolyPoint turned_direction{1, 0, 2};
constexpr std::array<std::string_view, 2> functions{"sinc", "cosr"};
constexpr std::string_view function_in_plot = "sinc";
constexpr int rotation = 30;  // degrees, of functions

template <class Value>
Value done(base::Result<Value> result, base::ErrorKind kind = base::ErrorKind::program_failed) {
  if (!result) throw base::error_of(kind, result.error().message());
  return std::move(*result);
}

// Collects the rows of scenes and of methods from comparisons.
class RowCollector {
 public:
  void add(const std::string& scene, std::vector<compare::MethodView> views) {
    by_scene_.add(scene, 0, views);
    for (compare::MethodView& view : views) view.read = view.of_all = std::nullopt;  // of different scenes
    by_method_.add("", number_++, views);
  }
  void finish(OpeningAnswer& answer) const {
    answer.rows = by_scene_.rows();
    answer.methods = by_method_.rows();
  }

 private:
  compare::Answer by_scene_;
  compare::Answer by_method_;
  std::uint64_t number_ = 0;
};

void add_cells(const compare::CompareOptions& options, RowCollector& collector, OpeningAnswer& answer) {
  for (const std::string_view name : scene::builtin_scene_names()) {
    const scene::CellScene scene = done(scene::load_cell_scene(std::string(name)), base::ErrorKind::bad_input);
    const compare::SceneComparison comparison = done(compare::compare_cell_scene(scene, options));
    collector.add(std::string(name), method_views(comparison));
    ++answer.scenes;
    if (name != cells_in_plot) continue;
    for (compare::PlotPoint& point : compare::variants_of(scene, options, comparison))
      answer.plotted.push_back(std::move(point));
  }
}

scene::PolyCamera parallel_camera(const scene::PolyScene& scene) {
  return scene::aimed_camera(scene::frame_of(scene.camera), scene::bounds_of(scene).middle(),
                             turned_direction, false);
}

void add_polyhedra(const compare::CompareOptions& options, RowCollector& collector, OpeningAnswer& answer) {
  const scene::PolyScene many = scene::generate_boxes(boxes);
  collector.add(fmt::format("boxes-{}", boxes),
                method_views(done(compare::compare_poly_scene(many, many.camera, options))));
  const scene::PolyScene turned = scene::generate_boxes(turned_boxes);
  const compare::SceneComparison comparison =
      done(compare::compare_poly_scene(turned, parallel_camera(turned), options));
  collector.add(fmt::format("boxes-{}, parallel", turned_boxes), method_views(comparison));
  answer.scenes += 2;
  // The other methods are in the plot by the scene of cells.
  for (compare::PlotPoint& point : compare::variants_of(turned, options, comparison))
    if (point.series.starts_with("plantinga") || point.series == compare::turn_name)
      answer.plotted.push_back(std::move(point));
}

void add_functions(bool host_times, RowCollector& collector, OpeningAnswer& answer) {
  algorithms::skala::View view;
  view.rotation = rotation;
  for (const std::string_view name : functions) {
    const auto function = scene::height_function(name);
    if (!function) throw base::bad_input(fmt::format("found no function {}", name));
    const scene::HeightGrid grid = sample(*function, {33, 60});
    compare::HeightComparison comparison = compare::compare_heights(
        grid, view, [](std::string_view) {}, {}, host_times);
    comparison.devices = compare::compare_devices(grid, view);
    collector.add(std::string(name), method_views(comparison));
    ++answer.functions;
    if (name != function_in_plot) continue;
    for (compare::PlotPoint& point : compare::variants_of(comparison))
      answer.plotted.push_back(std::move(point));
  }
}

// The author of a method, and its machine. Methods that are not listed here, twins and other devices, are only in the
// whole table.
struct KnownMethod {
  std::string_view method;
  std::string_view picture;
  std::string_view what;
};
constexpr std::array<KnownMethod, 12> known_methods{
    {{compare::jones_pdp7_name, "lines", "Jones 1971 on the PDP-7"},
     {"turn-pdp7", "lines", "Plantinga and others 1990 on the PDP-7"},
     {"skala-8080", "dots", "Skala 1985 on the 8080"},
     {"willis-8080", "faces", "Willis 1977 on the 8080"},
     {"stripes-8080", "faces", "Montani and Re 1985 on the 8080"},
     {"exact", "lines", "a method of today, exact"},
     {"jones", "lines", "Jones 1971, exact"},
     {"montani-re", "lines", "Montani and Re 1985, exact"},
     {"plantinga", "lines", "Plantinga and others 1990, exact"},
     {"skala", "lines", "Skala 1985 without rounding"},
     {"montani-re", "faces", "Montani and Re 1985, stripes of a pixel"},
     {"willis", "faces", "Willis 1977"}}};

struct MethodRow {
  const AnswerRow* row;
  std::string_view what;
};

std::vector<MethodRow> shown_methods(const OpeningAnswer& answer) {
  std::vector<MethodRow> rows;
  for (const KnownMethod& known : known_methods)
    for (const AnswerRow& row : answer.methods)
      if (row.method == known.method && row.picture == known.picture) rows.push_back({&row, known.what});
  return rows;
}

std::optional<double> median(const std::optional<Spread>& spread) {
  return spread ? std::optional(spread->median) : std::nullopt;
}
std::optional<double> most(const std::optional<Spread>& spread, double unit = 1) {
  return spread ? std::optional(spread->greatest * unit) : std::nullopt;
}

constexpr double microseconds = 1e6;  // per second

// "0.06 to 0.96 s" over the scenes of a method.
std::string emulated_range(const OpeningAnswer& answer, std::string_view method) {
  const auto range = range_of(where(answer.rows, equals(&AnswerRow::method, method)),
                              [](const AnswerRow& row) { return most(row.emulated_seconds); });
  return fmt::format("{} to {} s", text_of(range.least, 2), text_of(range.greatest, 2));
}

bool exact_lines(const AnswerRow& row) {
  return row.exact && row.picture == "lines";
}

CheckedText how_fast(const Page& page, const OpeningAnswer& answer) {
  std::string text = fmt::format(
      "A view takes Jones's program {} on the PDP-7 (the paper: {}) and Skala's {} on the 8080 ({})",
      emulated_range(answer, compare::jones_pdp7_name), compare::paper_figure(compare::jones_pdp7_name, "lines"),
      emulated_range(answer, "skala-8080"), compare::paper_figure("skala-8080", "dots"));
  if (page.host_times()) {
    const auto here = range_of(where(answer.rows, equals(&AnswerRow::method, "exact")),
                               [](const AnswerRow& row) { return most(row.host_seconds, microseconds); });
    text += fmt::format("; the exact method takes this computer {} to {} us", text_of(here.least, 0),
                        text_of(here.greatest, 0));
  }
  return text + ".";
}

CheckedText how_wrong(const Page& page, const OpeningAnswer& answer) {
  const auto jones = where(answer.rows, equals(&AnswerRow::method, compare::jones_pdp7_name));
  const double farthest = greatest(jones, [](const AnswerRow& row) { return most(row.greatest); });
  const auto exact = where(answer.rows, exact_lines);
  return fmt::format(
             "On the PDP-7's screen at most {} % of the visible length is wrong, at most {} points from its "
             "place; of Skala's dots "
             "at most {} %; ",
             text_of(greatest(jones, [](const AnswerRow& row) { return row.wrong_percent.greatest; }), 1),
             text_of(farthest, 1),
             text_of(greatest(where(answer.rows, equals(&AnswerRow::method, "skala-8080")),
                            [](const AnswerRow& row) { return row.wrong_percent.greatest; }),
                   1)) +
         page.claim(std::all_of(exact.begin(), exact.end(),
                                [](const AnswerRow& row) { return row.right == row.views; }),
                    "nothing is wrong with the exact methods.");
}

CheckedText against_what(const Page& page, const OpeningAnswer& answer) {
  return page.claim(
      std::all_of(answer.rows.begin(), answer.rows.end(),
                  [](const AnswerRow& row) { return row.defect.empty(); }),
      fmt::format("Pictures of {} scenes are compared with those of an exact program that shares no code with the methods, "
                  "pictures of {} functions with unrounded lines. Each program on a machine produces, word for word, the "
                  "output of the same program in C++.",
                  answer.scenes, answer.functions));
}

void table_of_methods(Page& page, const OpeningAnswer& answer) {
  using Row = MethodRow;
  page.table(
      "answer-methods", "A view by each method", shown_methods(answer),
      {{"method", "Method",
        [](const Row& row) {
          return row.row->picture == "faces" && row.row->method == "montani-re" ? "montani-re, faces"
                                                                                : row.row->method;
        }},
       {"what", "Whose", &Row::what},
       {"emulated_s", "Emulated", "s, median",
        [](const Row& row) { return median(row.row->emulated_seconds); }},
       {"emulated_most_s", "Emulated", "s, most",
        [](const Row& row) { return most(row.row->emulated_seconds); }},
       {"host_us", "Here", "us, median",
        [](const Row& row) {
          return row.row->host_seconds ? std::optional(row.row->host_seconds->median * microseconds)
                                       : std::nullopt;
        },
        Real::as_needed, host_time},
       {"host_most_us", "Here", "us, most",
        [](const Row& row) { return most(row.row->host_seconds, microseconds); }, Real::as_needed, host_time},
       {"wrong_percent", "Wrong", "%, median", [](const Row& row) { return row.row->wrong_percent.median; },
        3},
       {"wrong_most_percent", "Wrong", "%, most",
        [](const Row& row) { return row.row->wrong_percent.greatest; }, 3},
       {"greatest", "Farthest", "points", [](const Row& row) { return most(row.row->greatest); }, 2},
       {"views", "Views", [](const Row& row) { return row.row->views; }},
       {"right", "Right", "none beyond a point", [](const Row& row) { return row.row->right; }},
       {"paper", "The paper says", [](const Row& row) { return compare::paper_figure(row.row->method, row.row->picture); }}},
      {{"One view of each scene that the method can take. Wrong: missing and extra lines together, in per cent of the visible "
        "length. A picture is right if it is exact, or if no part of it is farther than a point from the reference. The same "
        "programs in C++, other devices and the stripes on a plotter are in the table by scene."}});
}

void table_of_scenes(Page& page, const OpeningAnswer& answer) {
  using Row = AnswerRow;
  page.table(
      "answer", "A view by each method and scene", answer.rows,
      {{"scene", "Scene", &Row::scene},
       {"method", "Method", &Row::method},
       {"picture", "Picture", &Row::picture},
       {"emulated_s", "Emulated", "s", [](const Row& row) { return most(row.emulated_seconds); }},
       {"host_us", "Here", "us", [](const Row& row) { return most(row.host_seconds, microseconds); },
        Real::as_needed, host_time},
       {"wrong", "Wrong", "in its unit", [](const Row& row) { return row.wrong.greatest; }, 2},
       {"unit", "Unit", &Row::unit},
       {"wrong_percent", "Wrong", "% of what is seen",
        [](const Row& row) { return row.wrong_percent.greatest; }, 3},
       {"greatest", "Farthest", "points", [](const Row& row) { return most(row.greatest); }, 2},
       {"far", "Beyond a point", "in its unit", [](const Row& row) { return row.far.greatest; }, 2},
       {"rounding", "Rounding", &Row::rounding},
       {"read", "Read", [](const Row& row) { return most(row.read); }, 0},
       {"of_all", "Of all", &Row::of_all},
       {"what", "Of what", &Row::what},
       {"paper", "The paper says", [](const Row& row) { return compare::paper_figure(row.method, row.picture); }}},
      {{fmt::format("Default views; boxes-{} in parallel projection along {},{},{}, as Plantinga's events need; functions "
                    "rotated {} degrees. `sightline compare` makes the same rows for any scene.",
                    turned_boxes, turned_direction[0], turned_direction[1], turned_direction[2], rotation)},
       true});
}

}  // namespace

OpeningAnswer opening_answer(const Context& context) {
  context.progress("every method on every scene");
  OpeningAnswer answer;
  compare::CompareOptions options;
  options.host_times = context.host_times;
  RowCollector collector;
  add_cells(options, collector, answer);
  add_polyhedra(options, collector, answer);
  add_functions(context.host_times, collector, answer);
  collector.finish(answer);
  answer.of_plot = fmt::format(
      "{} from its default view; Plantinga's events and turn-pdp7 of boxes-{} in parallel projection; the "
      "function {}",
      cells_in_plot, turned_boxes, function_in_plot);
  return answer;
}

void opening(Page& page, const OpeningAnswer& answer) {
  Opening block{
      {{"How fast?", how_fast(page, answer)},
       {"How wrong?", how_wrong(page, answer)},
       {"Against what?", against_what(page, answer)}},
      {panel_svg(answer.plotted, compare::PlotPanel::emulated),
       panel_svg(answer.plotted, compare::PlotPanel::host)},
      fmt::format("Time against error, one mark per setting. A filled mark means that no other setting is both as fast and as "
                  "accurate. Shown: {}.",
                  answer.of_plot)};
  page.add(std::move(block));
  table_of_methods(page, answer);
  table_of_scenes(page, answer);
}

}  // namespace sightline::report
