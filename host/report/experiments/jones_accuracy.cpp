#include "host/report/experiments/jones_accuracy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/base/text.hpp"
#include "host/compare/jones_precision/study.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::report {

namespace {

namespace jones = programs::jones;
namespace jones_precision = compare::jones_precision;

constexpr int most_machine_fraction = 3;  // fraction bits
constexpr std::array tried_lengths{12, 14, 16, 18, 20, 22, 24, 28, 32, 36};

// A smaller error is numerical noise: the measure is computed in double precision.
constexpr double noise_floor = 1e-9;

double without_noise(double error) {
  return error < noise_floor ? 0 : error;
}

double wrong_per_cent(const PictureError& error) {
  return without_noise(error.symmetric_per_cent());
}
double farthest(const PictureError& error) {
  return without_noise(error.hausdorff);
}

std::string place_of(const geometry::Point& p) {
  return fmt::format("({}, {}, {})", p[0], p[1], p[2]);
}

// The most fraction bits with which every view is complete; 0 if there is no such number.
int most_complete(const SceneViews& views, int word_bits) {
  for (int f = jones_precision::most_fraction_bits; f > 0; --f) {
    const jones_precision::Precision precision{jones_precision::NumberKind::fixed_point, word_bits, f, false};
    bool complete = true;
    for (std::size_t view = 0; view < views.size() && complete; ++view)
      complete = run_twin(views, view, precision).status == jones::Status::complete;
    if (complete) return f;
  }
  return 0;
}

// Draws a scene exactly.
struct ExactScene {
  scene::PolyScene polyhedra;
  scene::CellComplex complex;
  algorithms::jones::PreparedComplex prepared;
  algorithms::jones::Walker walker;
  algorithms::exact::EdgeMesh mesh;
  std::vector<scene::PolyCamera> cameras;

  explicit ExactScene(const SceneViews& views)
      : polyhedra(scene::poly_scene_of(views.scene())),
        complex(scene::complex_of(views.scene(), polyhedra)),
        prepared(complex),
        walker(prepared),
        mesh(algorithms::exact::make_edge_mesh(polyhedra)) {
    for (std::size_t i = 0; i < views.size(); ++i) {
      cameras.push_back(polyhedra.camera);
      cameras.back().eye = views.eye(i);
    }
  }

  // Empty for an eye in a solid.
  [[nodiscard]] std::optional<picture::LinePicture> by_jones(std::size_t view) {
    auto seen = walker.visible_edges(cameras[view]);
    if (!seen) return std::nullopt;
    return std::move(seen->picture);
  }
  [[nodiscard]] picture::LinePicture by_edges(std::size_t view) const {
    return algorithms::exact::visible_edges(mesh, cameras[view]);
  }
  [[nodiscard]] picture::LinePicture by_oracle(std::size_t view) const {
    return algorithms::oracle::visible_edges(polyhedra, cameras[view]);
  }

  void check(const std::string& name) {
    for (std::size_t view = 0; view < cameras.size(); ++view) {
      const picture::LinePicture reference = by_oracle(view);
      if (by_jones(view) != reference || by_edges(view) != reference)
        throw base::difference(fmt::format("{}, view {}: internal error: an exact algorithm does not draw what the oracle finds",
                                  name, view + 1));
    }
  }
};

// One scene in C++: rows, and the jobs that time them. `numbers` outlives this object.
class Numbers {
 public:
  Numbers(const jones_precision::SixViews& six, std::vector<JonesNumber>& numbers) : views_(six), exact_(views_), numbers_(numbers) {
    exact_.check(views_.name());
    for (const bool truncate : {false, true})
      for (int f = 0; f <= jones_precision::most_fraction_bits; ++f)
        add("fractions", {jones_precision::NumberKind::fixed_point, jones_precision::longest_word, f, truncate});
    for (const int bits : tried_lengths)
      add("words", {jones_precision::NumberKind::fixed_point, bits, most_complete(views_, bits), false});
    for (const auto kind : {jones_precision::NumberKind::single_float, jones_precision::NumberKind::double_float}) add("floating", {kind});
    add_exact("Jones, exact", [this](std::size_t i) { (void)exact_.by_jones(i); });
    add_exact("exact visible edges", [this](std::size_t i) { (void)exact_.by_edges(i); });
    add_exact("oracle", [this](std::size_t i) { (void)exact_.by_oracle(i); });
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;

  // Interleaved over all arithmetics of the scene, six views per job.
  void take_times(int rounds) {
    const auto times = median_nanoseconds(jobs_, rounds);
    for (std::size_t i = 0; i < times.size(); ++i)
      numbers_[timed_[i]].view_us = times[i] / static_cast<double>(views_.size()) / 1000;
  }

 private:
  void add(std::string study, const jones_precision::Precision& precision) {
    JonesNumber number{views_.name(), std::move(study), name(precision), {}, {}, {}, measure_twin(views_, precision), {}};
    if (precision.kind == jones_precision::NumberKind::fixed_point) {
      number.word_bits = precision.word_bits;
      number.fraction_bits = precision.fraction_bits;
      number.rounded = !precision.truncate;
    }
    later(std::move(number), [this, precision](std::size_t i) { (void)run_twin(views_, i, precision); });
  }

  void add_exact(std::string name, std::function<void(std::size_t)> view) {
    later({views_.name(), "exact", std::move(name), {}, {}, {}, {}, {}}, std::move(view));
  }

  void later(JonesNumber number, std::function<void(std::size_t)> view) {
    numbers_.push_back(std::move(number));
    timed_.push_back(numbers_.size() - 1);
    jobs_.emplace_back([this, view = std::move(view)] {
      for (std::size_t i = 0; i < views_.size(); ++i) view(i);
    });
  }

  SceneViews views_;
  ExactScene exact_;
  std::vector<JonesNumber>& numbers_;
  std::vector<std::size_t> timed_;  // rows
  std::vector<std::function<void()>> jobs_;
};

void add_wrong_pieces(std::vector<JonesWrongPiece>& pieces, const SceneViews& views, const jones_precision::PrecisionStudy& study,
                      const jones_precision::Precision& precision) {
  // The twin's pieces equal the machine's, word for word.
  for (const jones_precision::NamedStretch& piece : study.measure(precision).clipped.named)
    pieces.push_back({views.name(), name(precision), place_of(views.eye(piece.view)), piece.stretch.extra, piece.stretch.length,
                      place_of(piece.stretch.line.from), place_of(piece.stretch.line.to)});
}

void add_builds(JonesAccuracy& made, const SceneViews& views, const jones_precision::SixViews& six) {
  const auto study = jones_precision::PrecisionStudy::of(views.scene(), six.eyes);
  if (!study) throw base::bad_input(fmt::format("{}: {}", views.name(), study.error().message()));
  for (const bool truncate : {false, true}) {
    for (int f = 0; f <= most_machine_fraction; ++f) {
      const jones_precision::Precision precision{jones_precision::NumberKind::fixed_point, jones::machine_word_bits, f, truncate};
      const MachineBuild build = measure_build(views, precision);
      made.builds.push_back({views.name(), f, !truncate, build.eae_s, build.plain_s, build.clipped, build.displayed});
      add_wrong_pieces(made.wrong_pieces, views, *study, precision);
    }
  }
}

// The chapter.

using Build = JonesBuild;
using Number = JonesNumber;
using ErrorOf = double (*)(const PictureError&);

// An error shown in plots.
struct Measure {
  std::string key;
  std::string title;
  std::string unit;
  ErrorOf of;
};

const std::array<Measure, 3>& measures() {
  static const std::array<Measure, 3> all{Measure{"lsym", "wrong length", "% of the visible length", &wrong_per_cent},
                                          Measure{"h", "greatest distance", "pixels", &farthest},
                                          Measure{"wvr", "wrong visibility", "share of random points",
                                                  [](const PictureError& e) { return e.wrong_visibility.rate; }}};
  return all;
}

std::string_view points_of(bool rounded) {
  return rounded ? "rounded" : "truncated";
}

// The number of fraction bits labels the points of one scene.
CurveParts<Build> fraction_labels() {
  return {[](const Build& build) { return build.scene == "street4" ? fmt::format("f={}", build.fraction_bits) : std::string(); }};
}

// The ratio of the wrong lengths of two builds.
double times_wrong(const Build& of, const Build& to, PictureError Build::*which = &Build::computed) {
  return wrong_per_cent(of.*which) / wrong_per_cent(to.*which);
}

// "7.5 (house), ...": for each scene, the ratio of the wrong length without fraction bits to that with the most.
std::string gains_by_scene(const JonesAccuracy& machine, PictureError Build::*which) {
  std::vector<std::string> gains;
  for (const jones_precision::SixViews& six : jones_precision::six_views) {
    const double gain = times_wrong(machine.build(six.scene, 0), machine.build(six.scene, most_machine_fraction), which);
    gains.push_back(fmt::format("{} ({})", text_of(gain, 1), six.scene));
  }
  return base::joined(gains, ", ");
}

// The gains of one more fraction bit, over all scenes.
std::vector<double> gains_of_a_bit(const JonesAccuracy& machine) {
  std::vector<double> gains;
  for (const jones_precision::SixViews& six : jones_precision::six_views)
    for (int f = 0; f < most_machine_fraction; ++f)
      gains.push_back(times_wrong(machine.build(six.scene, f), machine.build(six.scene, f + 1)));
  return gains;
}

Plot machine_plot(const std::string& id, const std::string& title, const std::string& caption, const std::string& curves,
                  const Measure& measure) {
  return {id,
          fmt::format("{}: {}", title, measure.title),
          caption,
          "Log-log plot of the time of a view against its error, one curve for each scene, " + curves + ".",
          {measure.title, measure.unit},
          {"a view, time on the emulated machine", "s"}};
}

void machine_plots(Page& page, const JonesAccuracy& machine) {
  const Build& street0 = machine.build("street4", 0);
  const Build& street3 = machine.build("street4", 3);
  const auto rounded = where(machine.builds, equals(&Build::rounded, true));
  const auto truncated = where(machine.builds, equals(&Build::rounded, false));
  const auto gain = range_of(machine.builds, &Build::eae_gain);
  const std::vector<double> of_a_bit = gains_of_a_bit(machine);
  const std::string of_bits = fmt::format(
      "Fraction bits of the screen's coordinates, from 3 at the left to 0 at the right, as labelled on the topmost curve. "
      "Ratio of the wrong length with 0 bits to that with 3: {}; each additional bit divides it by {} to {}. A view of street4 "
      "with the EAE takes {} % longer with 3 bits. The EAE, which multiplies and divides, makes a view {} to {} times as fast; "
      "the pieces are the same. No display on the machine; pieces after clipping; six views of each scene.",
      gains_by_scene(machine, &Build::computed), text_of(*std::min_element(of_a_bit.begin(), of_a_bit.end()), 1),
      text_of(*std::max_element(of_a_bit.begin(), of_a_bit.end()), 1),
      text_of(100 * (street3.eae_view_s - street0.eae_view_s) / street0.eae_view_s, 1), text_of(gain.least, 1),
      text_of(gain.greatest, 1));
  for (std::size_t i = 0; i < 2; ++i) {
    const Measure& measure = measures()[i];
    const auto error = [of = measure.of](const Build& build) { return of(build.computed); };
    Plot plot = machine_plot("jones-machine-" + measure.key, "Jones on the PDP-7: 0 to 3 fraction bits, rounded", of_bits,
                             "with the EAE and without", measure);
    add_curves(plot, rounded, [](const Build& build) { return build.scene + ", EAE"; }, error, &Build::eae_view_s);
    add_curves(
        plot, rounded, [](const Build& build) { return build.scene + ", no EAE"; }, error, &Build::view_s, fraction_labels());
    page.plot(std::move(plot));
  }
  const Build& street_cut = machine.build("street4", 0, false);
  const std::string of_rounding = fmt::format(
      "Quotients and points of the screen rounded or truncated, 0 to 3 fraction bits. Truncated without fraction bits, the "
      "wrong length of street4 is {} times and that of house {} times that of rounded points, and a view of street4 takes {} % "
      "less time. A point at the mark 0 has no such error.",
      text_of(times_wrong(street_cut, street0), 1),
      text_of(times_wrong(machine.build("house", 0, false), machine.build("house", 0)), 1),
      text_of(100 * (street0.eae_view_s - street_cut.eae_view_s) / street0.eae_view_s, 1));
  for (const Measure& measure : measures()) {
    const auto error = [of = measure.of](const Build& build) { return of(build.computed); };
    Plot plot = machine_plot("jones-rounding-" + measure.key, "Jones on the PDP-7 with the EAE: rounded or truncated",
                             of_rounding, "rounded and truncated", measure);
    add_curves(plot, rounded, &Build::scene, error, &Build::eae_view_s);
    add_curves(plot, truncated, [](const Build& build) { return build.scene + ", truncated"; }, error, &Build::eae_view_s,
               fraction_labels());
    page.plot(std::move(plot));
  }
}

// A column for each build.
void error_table(Page& page, const JonesAccuracy& machine, std::string id, std::string_view of, PictureError Build::*which) {
  page.table(
      std::move(id), fmt::format("Jones on the PDP-7: wrong length {}, six views of each scene", of), machine.builds,
      {{"scene", "Scene", &Build::scene}},
      {{fmt::format("Rounded: ratio of the wrong length with 0 fraction bits to that with 3: {}.",
                    gains_by_scene(machine, which))}},
      Pivot<Build>{
          [](const Build& build) { return fmt::format("{}_f{}", build.rounded ? "round" : "cut", build.fraction_bits); },
          [](const Build& build) { return fmt::format("{}, {} fraction bits", points_of(build.rounded), build.fraction_bits); },
          "% of the visible", [which](const Build& build) { return as_cell(wrong_per_cent(build.*which), 3); }});
}

// The measures of an error, for rows of any kind.
template <class Row, class Of>
void add_error_columns(std::vector<RowColumn<Row>>& columns, Of error_of, const std::string& key = "",
                       const std::string& title = "") {
  const auto add = [&](const char* name, const char* what, const char* unit, auto value) {
    columns.emplace_back(key + name, what + title, unit, [=](const Row& row) { return value(error_of(row)); });
  };
  add("l_sym_per_cent", "Wrong length", "%", &wrong_per_cent);
  add("l_miss_px", "Missing length", "pixels", [](const PictureError& error) { return error.missing; });
  add("l_extra_px", "Extra length", "pixels", [](const PictureError& error) { return error.extra; });
  add("l_extra_far_px", "Extra length farther than 1 pixel", "pixels", [](const PictureError& error) { return error.extra_far; });
  add("h_px", "Greatest distance", "pixels", &farthest);
  add("wvr", "Wrong visibility", "", [](const PictureError& error) { return error.wrong_visibility.rate; });
  add("wvr_low", "Wrong visibility", "95 % from", [](const PictureError& error) { return error.wrong_visibility.low; });
  add("wvr_high", "Wrong visibility", "95 % to", [](const PictureError& error) { return error.wrong_visibility.high; });
}

void machine_table(Page& page, const JonesAccuracy& machine) {
  std::vector<RowColumn<Build>> columns{{"scene", "Scene", &Build::scene},
                                        {"fraction_bits", "Fraction bits", &Build::fraction_bits},
                                        {"rounding", "Points", [](const Build& build) { return points_of(build.rounded); }},
                                        {"eae_view_s", "View with EAE", "s, mean", &Build::eae_view_s, 4},
                                        {"view_s", "View without", "s, mean", &Build::view_s, 4},
                                        {"eae_gain", "EAE gains", "times", &Build::eae_gain, 2}};
  add_error_columns(columns, [](const Build& build) -> const PictureError& { return build.computed; });
  add_error_columns(columns, [](const Build& build) -> const PictureError& { return build.displayed; }, "display_", ", display");
  const double far = std::max(greatest(machine.builds, [](const Build& build) { return build.computed.extra_far; }),
                              greatest(machine.builds, [](const Build& build) { return build.displayed.extra_far; }));
  page.table("jones-speed-error-machine", "Jones on the PDP-7: accuracy and time of every build", machine.builds, columns,
             {{"Lengths over six views of each scene, in pixels of the 1024 raster; the greatest distance is that of all six. "
               "First after clipping, with the fraction of a point; then the same pieces between the points of the display, as "
               "a user saw them.",
               page.claim(far <= 1, fmt::format("Hidden lines that are drawn coincide, within a pixel, with visible lines: "
                                                "extra length farther than a pixel is at most {} pixels.",
                                                text_of(far, 2)))},
              true});
}

void wrong_pieces_table(Page& page, const JonesAccuracy& machine) {
  using Piece = JonesWrongPiece;
  const auto& pieces = machine.wrong_pieces;
  page.table("jones-named-pieces",
             fmt::format("Jones: every piece wrong by more than {} pixels", text_of(jones_precision::named_from_points, 0)), pieces,
             {{"scene", "Scene", &Piece::scene},
              {"arithmetic", "Arithmetic", &Piece::arithmetic},
              {"eye", "Eye", &Piece::eye},
              {"wrong", "Wrong",
               [](const Piece& piece) { return std::string(piece.extra ? "drawn, not visible" : "visible, not drawn"); }},
              {"length_px", "Length", "pixels", &Piece::length_px, 1},
              {"from", "On the line from", &Piece::from},
              {"to", "to", &Piece::to}},
             {{pieces.empty() ? CheckedText("There is none.")
                              : page.claim(count(pieces, equals(&Piece::extra, false)) == 0,
                                           "All are drawn and not visible: a line of a farther wall is hidden by a fraction of a "
                                           "pixel, and rounded it lies on the edge of the mask, which is closed.")}});
}

void native_plot(Page& page, const JonesNumbers& native, const Measure& measure, std::string_view study, const std::string& title,
                 const std::string& caption, std::function<std::string(const Number&)> label) {
  Plot plot{fmt::format("jones-{}-{}", study, measure.key),
            fmt::format("Jones in C++: {}, float, double, exact: {}", title, measure.title),
            caption + " Times are medians of interleaved repetitions, of this computer.",
            "Log-log plot of the time of a view against its error, one curve for each scene.",
            {measure.title, measure.unit},
            {"a view, time on this computer", "us"}};
  const auto drawn = where(native.numbers, [study](const Number& number) {
    return (number.study == study && number.rounded == true) || number.study == "floating" || number.arithmetic == "Jones, exact";
  });
  add_curves(
      plot, drawn, &Number::scene, [of = measure.of](const Number& number) { return of(number.error); }, &Number::view_us,
      {[label = std::move(label)](const Number& number) { return number.scene == "street4" ? label(number) : std::string(); }});
  page.plot(std::move(plot));
}

void native_plots(Page& page, const JonesNumbers& native) {
  for (std::size_t i = 0; i < 2; ++i)
    native_plot(page, native, measures()[i], "fractions", "0 to 8 fraction bits in 36",
                "The same search in fixed point with 0 to 8 fraction bits in words of 36, in floating point, and in the native "
                "program, which is exact: its error is 0, at the mark on the axis. The error of double is below the numerical "
                "noise floor of the measure and is plotted there, too.",
                [](const Number& number) {
                  return number.study == "fractions" ? fmt::format("f={}", *number.fraction_bits) : number.arithmetic;
                });
  const Number& shortest = only(native.numbers, [](const Number& number) {
    return number.study == "words" && number.scene == "street4" && number.word_bits == tried_lengths.front();
  });
  for (std::size_t i = 0; i < 2; ++i)
    native_plot(page, native, measures()[i], "words", "words of 12 to 36 bits",
                fmt::format("Each word has the most fraction bits, up to 8, with which every view is complete. {} of 6 views "
                            "of street4 do not fit 12 bits and end early.",
                            shortest.error.incomplete),
                [](const Number& number) {
                  if (number.word_bits && *number.word_bits > 20) return std::string();
                  return number.study == "words" ? fmt::format("{}", *number.word_bits) : number.arithmetic;
                });
}

void native_table(Page& page, const JonesNumbers& native) {
  std::vector<RowColumn<Number>> columns{
      {"scene", "Scene", &Number::scene},
      {"arithmetic", "Arithmetic", &Number::arithmetic},
      {"word_bits", "Word", "bits", &Number::word_bits},
      {"fraction_bits", "Fraction", "bits", &Number::fraction_bits},
      {"rounding", "Points",
       [](const Number& number) { return number.rounded ? Cell(std::string(points_of(*number.rounded))) : Cell(); }},
      {"incomplete_views", "Views not completed", "of 6", [](const Number& number) { return number.error.incomplete; }}};
  add_error_columns(columns, [](const Number& number) -> const PictureError& { return number.error; });
  columns.emplace_back("view_us", "View", "us, mean", &Number::view_us, 1, host_time);
  page.table("jones-speed-error-numbers", "Jones in C++: accuracy and time of every kind of number", native.numbers, columns,
             {{"A view with a number that does not fit its word ends there and counts with the lines drawn until then. An "
               "exact program must draw the oracle's picture, piece for piece, or the report ends with an error."},
              true});
}

}  // namespace

const JonesBuild& JonesAccuracy::build(std::string_view scene, int fraction_bits, bool rounded) const {
  return only(builds, [=](const JonesBuild& build) {
    return build.scene == scene && build.fraction_bits == fraction_bits && build.rounded == rounded;
  });
}

JonesAccuracy jones_accuracy(const Context& context) {
  JonesAccuracy made;
  for (const jones_precision::SixViews& six : jones_precision::six_views) {
    context.progress(fmt::format("{} on the PDP-7 in every arithmetic", six.scene));
    add_builds(made, SceneViews(six), six);
  }
  return made;
}

void jones_numbers(const Context& context, JonesNumbers& made) {
  for (const jones_precision::SixViews& six : jones_precision::six_views) {
    context.progress(fmt::format("{} in C++ in every arithmetic", six.scene));
    const auto numbers = std::make_shared<Numbers>(six, made.numbers);
    if (context.host_times) context.when_alone([numbers, rounds = context.full ? 61 : 9] { numbers->take_times(rounds); });
  }
}

void jones_accuracy_chapter(Page& page, const JonesAccuracy& machine, const JonesNumbers& native) {
  page.paragraph(
      "Six views of each scene are compared with exact visibility. The measures are: missing length, which is visible and not "
      "drawn; extra length, which is drawn and not visible; wrong length, their sum in per cent of the visible length; extra "
      "length farther than a pixel from every visible line, which is what a person notices; the greatest distance between the "
      "drawn and the visible lines; and wrong visibility, the share of random points on all lines, a pixel or more from any "
      "end, that are wrongly visible or hidden. In the plots less error is to the left and less time is below. Both axes are "
      "logarithmic; an error of exactly 0 is at a mark labelled 0. Fraction bits are the bits of a word after the binary "
      "point; f=2 means two of them. Six views are too few for rare errors: `sightline atlas street4 --views 4000` finds the "
      "views that are wrong by more than a point, and why.");
  machine_plots(page, machine);
  error_table(page, machine, "jones-error-table", "after clipping, with the fraction of a point", &Build::computed);
  error_table(page, machine, "jones-error-display", "between the whole points of the display", &Build::displayed);
  machine_table(page, machine);
  wrong_pieces_table(page, machine);
  if (page.host_times()) native_plots(page, native);
  native_table(page, native);
}

}  // namespace sightline::report
