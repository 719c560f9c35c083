// Jones's program in every arithmetic, from six eyes a scene: how wrong and how long.
//
// Two experiments: jones-accuracy gives machine, limits and named, jones-numbers gives numbers.
//
//   machine  a build of the program on the PDP-7 each: 0 to 3 fraction bits, rounded or truncated; display_*: the same
//            pieces between the whole points of the display. Times are means of a view.
//   numbers  in C++: 0 to 8 fraction bits in words of 36 (study fractions), words of 12 to 36 bits, each with the most
//            fraction bits with which every view is complete (words), float and double (floating), and the exact
//            algorithms, whose error is 0 because their pictures are the oracle's, piece for piece (exact)
//   named    every piece of the machine's builds that is wrong by more than 20 pixels
#include <fmt/core.h>

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/guests/jones/precision/study.hpp"
#include "host/report/experiments/clock.hpp"
#include "host/report/experiments/experiments.hpp"
#include "host/report/experiments/jones_pictures.hpp"
#include "host/scene/cells/from_cell_scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::report {

namespace {

namespace jones = guests::jones;

constexpr int most_machine_fraction = 3;  // fraction bits
constexpr std::array tried_lengths{12, 14, 16, 18, 20, 22, 24, 28, 32, 36};

// An error below this is numerical noise: the measure is computed in double precision.
constexpr double noise_floor = 1e-9;

double told(double error) {
  return error < noise_floor ? 0 : error;
}

void add_error(NamedValues& row, const PictureError& error, bool displayed = false) {
  const auto add = [&](std::string_view key, std::string_view display_key, double value) {
    row.emplace_back(displayed ? display_key : key, value);
  };
  add("l_sym_per_cent", "display_l_sym_per_cent", told(error.symmetric_per_cent()));
  add("l_miss_px", "display_l_miss_px", error.missing);
  add("l_extra_px", "display_l_extra_px", error.extra);
  add("l_extra_far_px", "display_l_extra_far_px", error.extra_far);
  add("h_px", "display_h_px", told(error.hausdorff));
  add("wvr", "display_wvr", error.wrong_visibility.rate);
  add("wvr_low", "display_wvr_low", error.wrong_visibility.low);
  add("wvr_high", "display_wvr_high", error.wrong_visibility.high);
}

std::string_view rounding(const jones::Precision& precision) {
  return precision.truncate ? "truncated" : "rounded";
}

std::string place_of(const geometry::Point& p) {
  return fmt::format("({}, {}, {})", p[0], p[1], p[2]);
}

// The most fraction bits with which every view is complete; 0 if none are.
int most_complete(const SceneViews& views, int word_bits) {
  for (int f = jones::most_fraction_bits; f > 0; --f) {
    const jones::Precision precision{jones::NumberKind::fixed_point, word_bits, f, false};
    bool complete = true;
    for (std::size_t view = 0; view < views.size() && complete; ++view)
      complete = run_twin(views, view, precision).status == jones::Status::complete;
    if (complete) return f;
  }
  return 0;
}

// What draws a scene exactly.
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

  // Nothing for an eye in a solid.
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
        throw Failure(ErrorKind::differs,
                      fmt::format("{}, view {}: internal error: an exact algorithm does not draw what the oracle finds",
                                  name, view + 1));
    }
  }
};

// One scene in C++: rows, and the jobs that time them.
class Numbers {
 public:
  Numbers(const jones::SixViews& six, RowSet& rows) : views_(six), exact_(views_) {
    exact_.check(views_.name());
    for (const bool truncate : {false, true})
      for (int f = 0; f <= jones::most_fraction_bits; ++f)
        add(rows, "fractions", {jones::NumberKind::fixed_point, jones::longest_word, f, truncate});
    for (const int bits : tried_lengths)
      add(rows, "words", {jones::NumberKind::fixed_point, bits, most_complete(views_, bits), false});
    for (const auto kind : {jones::NumberKind::single_float, jones::NumberKind::double_float}) add(rows, "floating", {kind});
    add_exact(rows, "Jones, exact", [this](std::size_t i) { (void)exact_.by_jones(i); });
    add_exact(rows, "exact visible edges", [this](std::size_t i) { (void)exact_.by_edges(i); });
    add_exact(rows, "oracle", [this](std::size_t i) { (void)exact_.by_oracle(i); });
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;

  // Interleaved over all arithmetic of the scene, six views a job.
  void take_times(RowSet& rows, int rounds) {
    const auto times = median_nanoseconds(jobs_, rounds);
    for (std::size_t i = 0; i < times.size(); ++i)
      rows.set(timed_[i], "view_us", times[i] / static_cast<double>(views_.size()) / 1000);
  }

 private:
  void add(RowSet& rows, std::string_view study, const jones::Precision& precision) {
    const bool fixed = precision.kind == jones::NumberKind::fixed_point;
    const PictureError error = measure_twin(views_, precision);
    NamedValues row{{"scene", views_.name()},
                    {"study", study},
                    {"arithmetic", name(precision)},
                    {"word_bits", fixed ? Value(precision.word_bits) : Value()},
                    {"fraction_bits", fixed ? Value(precision.fraction_bits) : Value()},
                    {"rounding", fixed ? Value(rounding(precision)) : Value()},
                    {"incomplete_views", error.incomplete}};
    add_error(row, error);
    later(rows, std::move(row), [this, precision](std::size_t i) { (void)run_twin(views_, i, precision); });
  }

  void add_exact(RowSet& rows, std::string_view name, std::function<void(std::size_t)> view) {
    NamedValues row{{"scene", views_.name()}, {"study", "exact"}, {"arithmetic", name}, {"word_bits", {}},
                    {"fraction_bits", {}},    {"rounding", {}},   {"incomplete_views", 0}};
    add_error(row, {});
    later(rows, std::move(row), std::move(view));
  }

  void later(RowSet& rows, NamedValues row, std::function<void(std::size_t)> view) {
    row.emplace_back().first = "view_us";  // no value yet
    rows.add(row);
    timed_.push_back(rows.size() - 1);
    jobs_.emplace_back([this, view = std::move(view)] {
      for (std::size_t i = 0; i < views_.size(); ++i) view(i);
    });
  }

  SceneViews views_;
  ExactScene exact_;
  std::vector<std::size_t> timed_;  // rows
  std::vector<std::function<void()>> jobs_;
};

void add_named(RowSet& named, const SceneViews& views, const jones::PrecisionStudy& study,
               const jones::Precision& precision) {
  // The twin's pieces are the machine's, word for word.
  for (const jones::NamedStretch& piece : study.measure(precision).clipped.named)
    named.add({{"scene", views.name()},
               {"arithmetic", name(precision)},
               {"eye", place_of(views.eye(piece.view))},
               {"wrong", piece.stretch.extra ? "drawn, not visible" : "visible, not drawn"},
               {"length_px", piece.stretch.length},
               {"from", place_of(piece.stretch.line.from)},
               {"to", place_of(piece.stretch.line.to)}});
}

void add_machine(Records& records, const SceneViews& views, const jones::SixViews& six) {
  const auto study = jones::PrecisionStudy::of(views.scene(), six.eyes);
  if (!study) throw Failure(ErrorKind::bad_input, fmt::format("{}: {}", views.name(), study.error().message()));
  for (const bool truncate : {false, true}) {
    for (int f = 0; f <= most_machine_fraction; ++f) {
      const jones::Precision precision{jones::NumberKind::fixed_point, jones::machine_word_bits, f, truncate};
      const MachineBuild build = measure_build(views, precision);
      NamedValues row{{"scene", views.name()},
                      {"fraction_bits", f},
                      {"rounding", rounding(precision)},
                      {"eae_view_s", build.eae_s},
                      {"view_s", build.plain_s},
                      {"eae_gain", build.plain_s / build.eae_s}};
      add_error(row, build.clipped);
      add_error(row, build.displayed, true);
      records["machine"].add(row);
      add_named(records["named"], views, *study, precision);
    }
  }
}

}  // namespace

Records jones_accuracy(const Context& context) {
  Records records;
  records["named"] = RowSet({"scene", "arithmetic", "eye", "wrong", "length_px", "from", "to"});
  records["limits"].add({{"named_from_px", jones::named_from_points}});
  for (const jones::SixViews& six : jones::six_views) {
    context.progress(fmt::format("{} on the PDP-7 in every arithmetic", six.scene));
    add_machine(records, SceneViews(six), six);
  }
  return records;
}

Records jones_numbers(const Context& context) {
  Records records;
  for (const jones::SixViews& six : jones::six_views) {
    context.progress(fmt::format("{} in C++ in every arithmetic", six.scene));
    const auto numbers = std::make_shared<Numbers>(six, records["numbers"]);
    if (!context.host_times) continue;
    context.alone([numbers, rounds = context.full ? 61 : 9](Records& made) { numbers->take_times(made["numbers"], rounds); });
  }
  return records;
}

}  // namespace sightline::report
