#include "host/report/speed_error/jones_blocks.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/report/speed_error/plot.hpp"

namespace sightline::harness::report {

namespace {

using Scenes = std::vector<JonesMeasured>;

// An error below this is the measure's own: it is computed in double precision.
constexpr double least_told = 1e-9;

struct Measure {
  std::string_view key;
  std::string_view title;
  std::string_view unit;
  double (*of)(const PictureError& error);
};
constexpr std::array<Measure, 3> measures{
    {{"lsym", "wrong length, L_sym", "% of the visible length",
      [](const PictureError& e) { return e.symmetric_per_cent(); }},
     {"h", "greatest distance, H", "pixels", [](const PictureError& e) { return e.hausdorff; }},
     {"wvr", "wrong visibility, WVR", "share of random points",
      [](const PictureError& e) { return e.wrong_visibility.rate; }}}};
constexpr std::size_t lengths = 2;  // the first two; WVR tells most programs from exact ones in no point

double told(const Measure& measure, const PictureError& error) {
  const double value = measure.of(error);
  return value < least_told ? 0 : value;
}

std::string_view rounding(const guests::jones::Precision& precision) {
  return precision.truncate ? "cut off" : "rounded";
}

// --- tables

void add_columns(Table& table, std::string_view of, std::string_view title) {
  const auto key = [&](std::string_view name) { return fmt::format("{}{}", of, name); };
  const auto head = [&](std::string_view name) { return fmt::format("{}{}", name, title); };
  for (Column column :
       {Column{key("l_sym_per_cent"), head("L_sym"), "%", false},
        Column{key("l_miss_px"), head("L_miss"), "pixels", false},
        Column{key("l_extra_px"), head("L_extra"), "pixels", false},
        Column{key("l_extra_far_px"), head("L_extra(>1 px)"), "pixels", false},
        Column{key("h_px"), head("H"), "pixels", false}, Column{key("wvr"), head("WVR"), "", false},
        Column{key("wvr_low"), head("WVR"), "95 % from", false},
        Column{key("wvr_high"), head("WVR"), "95 % to", false}})
    table.columns.push_back(std::move(column));
}

void add_cells(std::vector<Cell>& row, const PictureError& error) {
  for (const double value :
       {error.symmetric_per_cent(), error.missing, error.extra, error.extra_far, error.hausdorff,
        error.wrong_visibility.rate, error.wrong_visibility.low, error.wrong_visibility.high})
    row.emplace_back(Real{value});
}

Cell time_cell(const std::optional<double>& ns) {
  return ns ? Cell(Real{*ns / 1000, 1}) : Cell();
}

void add_twin(Table& table, const std::string& scene, const Twin& twin) {
  const bool fixed = twin.precision.kind == guests::jones::NumberKind::fixed_point;
  const auto count = [fixed](int value) { return fixed ? Cell(std::int64_t{value}) : Cell(); };
  std::vector<Cell> row{scene,
                        name(twin.precision),
                        count(twin.precision.word_bits),
                        count(twin.precision.fraction_bits),
                        fixed ? Cell(std::string(rounding(twin.precision))) : Cell(),
                        static_cast<std::int64_t>(twin.error.incomplete)};
  add_cells(row, twin.error);
  row.push_back(time_cell(twin.view_ns));
  table.rows.push_back(std::move(row));
}

// --- plots

Plot plot_of(const Measure& measure, std::string_view id, std::string_view title, bool host_time) {
  Plot plot;
  plot.id = fmt::format("jones-{}-{}", id, measure.key);
  plot.title = fmt::format("{}: {}", title, symbol_of(measure.title));
  plot.host_time = host_time;
  plot.x = {std::string(measure.title), std::string(measure.unit), true, {}};
  plot.y = host_time ? Axis{fmt::format("a view, {}", host_title), "us", true, {}}
                     : Axis{fmt::format("a view, {}", emulated_title), "s", true, {}};
  return plot;
}

std::string bits(const guests::jones::Precision& precision) {
  return fmt::format("f={}", precision.fraction_bits);
}

// Names of points are written where they are asked for: at one curve, for all.
Curve machine_curve(const JonesMeasured& scene, const Measure& measure, bool eae, bool truncate, bool named) {
  Curve curve;
  curve.name = fmt::format("{}, {}{}", scene.scene, eae ? "EAE" : "no EAE", truncate ? ", cut off" : "");
  for (const MachineBuild& build : scene.machine) {
    if (build.precision.truncate != truncate) continue;
    curve.points.push_back({told(measure, build.clipped), eae ? build.eae_s : build.plain_s,
                            named ? bits(build.precision) : ""});
  }
  return curve;
}

bool named_scene(const JonesMeasured& scene) {
  return scene.scene == "street4";  // the slowest: above the others
}

Plot equipment_plot(const Scenes& scenes, const Measure& measure) {
  Plot plot = plot_of(measure, "machine", "Jones on the PDP-7: 0 to 3 fraction bits, rounded", false);
  plot.caption =
      "Fraction bits of the screen's coordinates, left to right from 3 to 0 as at the topmost curve. Each "
      "halves the error and costs nearly nothing; the EAE, which multiplies and divides, makes a view two to "
      "three times as fast and the same. No display on the machine; pieces as they leave the clip; six views "
      "a scene.";
  plot.alternative =
      "Log-log plot, one nearly level curve a scene and machine: the error falls with fraction bits while "
      "the time stays; the curves without the EAE lie above those with it.";
  for (const bool eae : {true, false}) {
    for (const JonesMeasured& scene : scenes)
      plot.curves.push_back(machine_curve(scene, measure, eae, false, !eae && named_scene(scene)));
  }
  return plot;
}

Plot rounding_plot(const Scenes& scenes, const Measure& measure) {
  Plot plot = plot_of(measure, "rounding", "Jones on the PDP-7 with the EAE: rounded or cut off", false);
  plot.caption =
      "Quotients and points of the screen rounded, or cut off, 0 to 3 fraction bits. Cutting off saves next "
      "to no time and costs a bit. A point at the mark 0 has no error of this kind.";
  plot.alternative =
      "Log-log plot: at the same time of a view, the programs that cut off have about twice the error of "
      "those that round.";
  for (const bool truncate : {false, true}) {
    for (const JonesMeasured& scene : scenes)
      plot.curves.push_back(machine_curve(scene, measure, true, truncate, truncate && named_scene(scene)));
  }
  return plot;
}

Curve twin_curve(const JonesMeasured& scene, const Measure& measure, const std::vector<Twin>& twins,
                 bool word_lengths) {
  Curve curve;
  curve.name = scene.scene;
  const bool named = named_scene(scene);
  const auto add = [&](double error, const std::optional<double>& ns, const std::string& label) {
    if (ns) curve.points.push_back({error, *ns / 1000, named ? label : ""});
  };
  for (const Twin& twin : twins) {
    if (twin.precision.truncate) continue;
    const bool last = word_lengths ? twin.precision.word_bits == 20 : true;
    const bool first = word_lengths && twin.precision.word_bits < 20;
    const std::string label =
        word_lengths ? fmt::format("{}", twin.precision.word_bits) : bits(twin.precision);
    add(told(measure, twin.error), twin.view_ns, first || last ? label : "");
  }
  for (const Twin& twin : scene.floating) add(told(measure, twin.error), twin.view_ns, name(twin.precision));
  add(0, scene.exact.front().view_ns, "exact");
  return curve;
}

Plot numbers_plot(const Scenes& scenes, const Measure& measure, bool word_lengths) {
  Plot plot = word_lengths ? plot_of(measure, "words",
                                     "Jones in C++: words of 12 to 36 bits, float, double, exact", true)
                           : plot_of(measure, "fractions",
                                     "Jones in C++: 0 to 8 fraction bits in 36, float, double, exact", true);
  plot.caption =
      word_lengths
          ? "Each word with the most fraction bits, up to 8, with which it holds every view: 2 bits more a "
            "word, 2 fraction bits more. Street4 does not fit 12 bits at all: its views end at once, far "
            "right. From 20 bits on the fraction is the limit, and points coincide."
          : "The same search in fixed point with 0 to 8 fraction bits, in floating point, and in the native "
            "program, which is exact: its error is 0, at the mark on the axis. What double leaves is below "
            "what can be measured, and stands there too.";
  plot.caption.text += " Times are medians of interleaved repetitions, of this computer.";
  plot.alternative =
      "Log-log plot, one curve a scene: time hardly changes with precision; floating point is not slower "
      "than fixed point, and the exact program is the fastest.";
  for (const JonesMeasured& scene : scenes)
    plot.curves.push_back(
        twin_curve(scene, measure, word_lengths ? scene.words : scene.fractions, word_lengths));
  return plot;
}

bool timed(const Scenes& scenes) {
  return !scenes.empty() && scenes.front().exact.front().view_ns.has_value();
}

}  // namespace

Table machine_error_table(const Scenes& scenes) {
  Table table;
  table.id = "jones-speed-error-machine";
  table.title = "Jones on the PDP-7: speed and error of every build";
  table.columns = {{"scene", "Scene", "", false},
                   {"fraction_bits", "Fraction bits", "", false},
                   {"rounding", "Points", "", false},
                   {"eae_view_s", "View with EAE", "s, mean", false},
                   {"view_s", "View without", "s, mean", false}};
  add_columns(table, "", "");
  add_columns(table, "display_", ", display");
  for (const JonesMeasured& scene : scenes) {
    for (const MachineBuild& build : scene.machine) {
      std::vector<Cell> row{scene.scene, std::int64_t{build.precision.fraction_bits},
                            std::string(rounding(build.precision)), Real{build.eae_s, 4},
                            Real{build.plain_s, 4}};
      add_cells(row, build.clipped);
      add_cells(row, build.displayed);
      table.rows.push_back(std::move(row));
    }
  }
  table.notes = {
      "Lengths over six views of each scene, in pixels of the 1024 raster; H is the greatest of the six. "
      "First after the clip, with the fraction of a point; then the same pieces between the whole points of "
      "the display, which is what one saw. L_extra(>1 px) is 0 or next to it everywhere: what is drawn and "
      "hidden falls, within a pixel, on lines that are visible, so it has no plot."};
  return table;
}

Table twin_error_table(const Scenes& scenes) {
  Table table;
  table.id = "jones-speed-error-numbers";
  table.title = "Jones in C++: speed and error of every kind of number";
  table.columns = {
      {"scene", "Scene", "", false},        {"arithmetic", "Arithmetic", "", false},
      {"word_bits", "Word", "bits", false}, {"fraction_bits", "Fraction", "bits", false},
      {"rounding", "Points", "", false},    {"incomplete_views", "Views not completed", "of 6", false}};
  add_columns(table, "", "");
  table.columns.push_back({"view_us", "View", "us, mean", true});
  for (const JonesMeasured& scene : scenes) {
    for (const auto* const twins : {&scene.fractions, &scene.words, &scene.floating}) {
      for (const Twin& twin : *twins) add_twin(table, scene.scene, twin);
    }
    for (const ExactProgram& exact : scene.exact) {
      std::vector<Cell> row{scene.scene, exact.name, {}, {}, {}, std::int64_t{0}};
      for (int i = 0; i < 6; ++i) row.emplace_back(Real{0});
      row.emplace_back();
      row.emplace_back();
      row.push_back(time_cell(exact.view_ns));
      table.rows.push_back(std::move(row));
    }
  }
  table.notes = {
      "A view that meets a number its word cannot hold ends there, and counts with what it drew until then. "
      "The exact programs draw what the oracle finds, piece for piece: an error of 0, not a small one."};
  return table;
}

Outcome<std::vector<Block>> jones_error_blocks(const Scenes& scenes) {
  std::vector<Block> blocks;
  for (const Measure& measure : std::span(measures).first(lengths)) {
    if (auto error = add_figure(blocks, equipment_plot(scenes, measure))) return std::move(*error);
  }
  for (const Measure& measure : measures) {
    if (auto error = add_figure(blocks, rounding_plot(scenes, measure))) return std::move(*error);
  }
  blocks.emplace_back(machine_error_table(scenes));
  if (timed(scenes)) {
    for (const bool word_lengths : {false, true}) {
      for (const Measure& measure : std::span(measures).first(lengths)) {
        if (auto error = add_figure(blocks, numbers_plot(scenes, measure, word_lengths)))
          return std::move(*error);
      }
    }
  }
  blocks.emplace_back(twin_error_table(scenes));
  return blocks;
}

}  // namespace sightline::harness::report
