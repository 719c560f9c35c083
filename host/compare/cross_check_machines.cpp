// See cross_check_machines.hpp.
#include "host/compare/cross_check_machines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "host/compare/height_methods.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/algorithms/skala/draw.hpp"
#include "host/compare/device_raster.hpp"
#include "host/compare/lines.hpp"
#include "host/compare/jones_precision/precision.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/picture/dots_and_lines.hpp"
#include "host/picture/line_metrics_parts.hpp"

namespace sightline::compare {
namespace {

namespace jones = programs::jones;
namespace skala = programs::skala;
using picture::PixelGrid;
using picture::PixelPoint;
using picture::PixelSegment;

// Builds a verdict from distances: each must be within its bound.
class Distances {
 public:
  void add(std::string what, double found, double bound) {
    verdict_.agrees = verdict_.agrees && found <= bound;
    verdict_.text += fmt::format("{}{} {:.3g} of {:.3g}", verdict_.text.empty() ? "" : ", ", what, found, bound);
    verdict_.distances.push_back({std::move(what), found, bound});
  }
  void fail(const std::string& text) {
    verdict_.agrees = false;
    verdict_.text += (verdict_.text.empty() ? "" : ", ") + text;
  }
  [[nodiscard]] ViewVerdict take() { return std::move(verdict_); }

 private:
  ViewVerdict verdict_{true, "points", {}, {}};
};

// --- Jones

constexpr int most_on_machine = 3;
constexpr std::array bits_of_longer_words{4, 6, 8};
constexpr int longer_word = 24;
constexpr double screen_centre = 512;

// Lines between points, from the pieces after clipping.
std::vector<PixelSegment> on_points(const jones::TwinView& view, int fraction_bits) {
  const jones::ShortWords number(jones::machine_word_bits, fraction_bits);
  const auto place = [&number](const jones::ScreenPoint& p) {
    return PixelPoint{number.point(p.x) + screen_centre, number.point(p.y) + screen_centre};
  };
  std::vector<PixelSegment> lines;
  for (const jones::Piece& piece : view.pieces) lines.push_back({place(piece.line.a), place(piece.line.b)});
  return lines;
}

JonesPicture picture_of(const CommonScene& scene, const geometry::Point& eye, int fraction_bits) {
  JonesPicture made;
  made.words.fraction_bits = fraction_bits;
  made.bound = jones_line_bound(jones_piece_bound(*scene.cells, eye, made.words), made.words);
  return made;
}

// The visible lines of a picture of the scene's wires on the screen of the Type 340.
std::vector<PixelSegment> on_screen(const CommonScene& scene, const CrossCheckView& view, const picture::LinePicture& lines) {
  const auto chosen = scene.matter->lines_at(view.camera.eye);
  return visible_segments(ImageLines(lines, scene.scene, view.camera, type340_frame(), &chosen).lines());
}

// --- Skala

// Dots with ink that have an adjacent dot without.
std::vector<PixelSegment> border_of(const PixelGrid& dots) {
  const auto inked = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < dots.width && row < dots.height && dots.at(column, row) != 0;
  };
  std::vector<PixelSegment> border;
  for (int row = 0; row < dots.height; ++row) {
    for (int column = 0; column < dots.width; ++column) {
      const PixelPoint place{static_cast<double>(column), static_cast<double>(row)};
      if (inked(column, row) &&
          !(inked(column - 1, row) && inked(column + 1, row) && inked(column, row - 1) && inked(column, row + 1)))
        border.push_back({place, place});
    }
  }
  return border;
}

// Distances between ink and lines. Devices with the same ink are measured once.
class InkDistances {
 public:
  // `bounds_times` multiplies the bounds.
  void add(Distances& to, const SkalaInk& ink, const std::vector<PixelSegment>& lines, double bounds_times) {
    auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& k) {
      return k.lines == &lines && shows_lines(*k.ink) == shows_lines(ink) &&
             skala::is_raster(k.ink->device) == skala::is_raster(ink.device) && k.ink->dots == ink.dots;
    });
    const InkBounds bounds = ink_bounds(ink);
    if (known == known_.end()) {
      const double of_ink = picture::directed_hausdorff_distance(shows_lines(ink) ? ink.ink : border_of(ink.dots), lines).greatest;
      known = known_.insert(known_.end(), {&ink, &lines, of_ink, bounds.of_lines ? picture::directed_hausdorff_distance(lines, ink.ink).greatest : 0});
    }
    to.add(name_of(ink) + (shows_lines(ink) ? ": ink" : ": border"), known->of_ink, bounds.of_ink * bounds_times);
    if (bounds.of_lines) to.add(name_of(ink) + ": lines", known->of_lines, *bounds.of_lines * bounds_times);
  }

 private:
  struct Known {
    const SkalaInk* ink;
    const std::vector<PixelSegment>* lines;
    double of_ink;
    double of_lines;
  };
  std::vector<Known> known_;
};

std::vector<PixelSegment> lines_of(const picture::VectorDrawing& drawing) {
  std::vector<PixelSegment> lines;
  for (const picture::DrawingLine& line : drawing.lines) {
    const auto place = [&](std::uint32_t i) {
      return PixelPoint{drawing.points[line.first + i].x, drawing.points[line.first + i].y};
    };
    for (std::uint32_t i = 0; i < std::max(line.count, 2U) - 1; ++i)
      lines.push_back({place(i), place(std::min(i + 1, line.count - 1))});
  }
  return lines;
}

}  // namespace

base::Result<std::vector<JonesPicture>> jones_on_pdp7(const CommonScene& scene, const CrossCheckView& view, bool eae) {
  std::vector<JonesPicture> builds;
  for (int bits = 0; bits <= most_on_machine; ++bits) {
    const auto prepared = jones::Prepared::of(*scene.cells, {eae, static_cast<std::uint32_t>(bits), false});
    if (!prepared) return prepared.error();
    jones::Order order;
    order.eye = view.camera.eye;
    order.views = 1;
    const auto outcome = prepared->run(order);
    if (!outcome) return outcome.error();
    const auto twin = prepared->twin(order);
    if (!twin) return twin.error();
    const jones::View& shown = outcome->view();
    if (const std::string difference = jones::difference_of(shown, *twin); !difference.empty())
      return base::bad_input(fmt::format("{} fraction bits: the program differs from its twin: {}", bits, difference));
    if (shown.status != jones::Status::complete)
      return base::bad_input(fmt::format("{} fraction bits: the view ends with {}", bits, jones::name(shown.status)));
    JonesPicture& made = builds.emplace_back(picture_of(scene, view.camera.eye, bits));
    made.display_file = shown.display_file;
    made.lines = on_points(*twin, bits);
    made.flashes = picture::dot_segments(points_of(outcome->pass));
    made.flash_bound = jones_flash_bound(made.bound);
  }
  return builds;
}

base::Result<std::vector<JonesPicture>> jones_twins(const CommonScene& scene, const CrossCheckView& view) {
  const geometry::Point& eye = view.camera.eye;
  const auto in_core = jones_precision::scene_in_core(*scene.cells, eye);
  if (!in_core) return in_core.error();
  std::vector<JonesPicture> builds;
  jones::Parameters parameters = jones::default_parameters(in_core->core, 0);
  for (int bits = 0; bits <= most_on_machine; ++bits) {
    parameters.fraction_bits = bits;
    const jones::TwinView shown = jones::run_twin(in_core->core, 0, parameters);
    if (shown.status != jones::Status::complete)
      return base::bad_input(fmt::format("{} fraction bits: the view ends with {}", bits, jones::name(shown.status)));
    builds.push_back({{jones::machine_word_bits, bits}, shown.display_file, {}, 0, {}, 0});
  }
  for (const int bits : bits_of_longer_words) {
    JonesPicture& made = builds.emplace_back();
    made.words = {longer_word, bits};
    made.bound = jones_piece_bound(*scene.cells, eye, made.words);
    jones_precision::Precision precision;
    precision.word_bits = longer_word;
    precision.fraction_bits = bits;
    const jones_precision::PreciseView shown = jones_precision::run_precisely(in_core->core, 0, parameters, precision);
    if (shown.status != jones::Status::complete)
      return base::bad_input(fmt::format("{} fraction bits: the view ends with {}", bits, jones::name(shown.status)));
    for (const jones_precision::PrecisePiece& piece : shown.pieces)
      made.lines.push_back({{piece.line.x0, piece.line.y0}, {piece.line.x1, piece.line.y1}});
  }
  return builds;
}

ViewVerdict compare_pictures(const CommonScene& scene, const CrossCheckView& view, const NamedJones& a, const NamedLines& b) {
  const auto exact = on_screen(scene, view, *b.lines);
  // There are many flashes, so only the first algorithm is compared with them; the others are compared with the
  // first.
  const bool with_flashes = b.name == registry::line_algorithms().front().name;
  Distances distances;
  for (const JonesPicture& build : *a.builds) {
    if (build.lines.empty()) continue;
    const std::string bits = fmt::format("f={}", build.words.fraction_bits);
    distances.add(bits, picture::hausdorff_distance(build.lines, exact).greatest, build.bound);
    if (!build.flashes.empty() && with_flashes) distances.add(bits + " lit", picture::hausdorff_distance(build.flashes, exact).greatest, build.flash_bound);
  }
  return distances.take();
}

ViewVerdict compare_pictures(const NamedJones& a, const NamedJones& b) {
  std::size_t words = 0;
  for (const JonesPicture& of_a : *a.builds) {
    for (const JonesPicture& of_b : *b.builds) {
      if (!(of_a.words == of_b.words) || of_a.display_file.empty()) continue;
      if (of_a.display_file != of_b.display_file)
        return {false,
                "words",
                fmt::format("{} fraction bits: {} and {} have different display files", of_a.words.fraction_bits, a.name, b.name),
                {}};
      words += of_a.display_file.size();
    }
  }
  return {words > 0, "words", fmt::format("{} display words equal", words), {}};
}

ViewVerdict compare_with_oracle(const CommonScene& scene, const NamedInk& a) {
  const algorithms::skala::View asked = program_view(scene);
  std::map<algorithms::skala::Subject, PixelGrid> oracle;
  std::map<algorithms::skala::Subject, std::vector<PixelSegment>> unrounded;
  for (const algorithms::skala::Subject kind : {algorithms::skala::Subject::lines, algorithms::skala::Subject::surface, algorithms::skala::Subject::contours}) {
    algorithms::skala::View view = asked;
    view.subject = kind;
    oracle[kind] = oracle_dots(*scene.heights, view, kind == algorithms::skala::Subject::contours);
    if (kind != algorithms::skala::Subject::surface) unrounded[kind] = unrounded_ink(*scene.heights, asked, kind);
  }
  Distances distances;
  InkDistances measured;
  for (const SkalaInk& ink : *a.pictures) {
    const std::string name = name_of(ink);
    if (skala::is_raster(ink.device) && ink.dots != oracle[ink.kind]) {
      distances.fail(name + ": its dots differ from the column oracle's");
      continue;
    }
    measured.add(distances, ink, unrounded[ink.kind == algorithms::skala::Subject::contours ? ink.kind : algorithms::skala::Subject::lines], 1);
  }
  return distances.take();
}

ViewVerdict compare_with_native(const CommonScene& scene, const NamedInk& a) {
  algorithms::skala::View view = scene.height_view;
  view.subject = algorithms::skala::Subject::lines;
  const auto lines = lines_of(algorithms::skala::draw(*scene.heights, view));
  // Its masks have columns, too, but finer ones.
  const double finer = 1 + 256.0 / view.columns;
  Distances distances;
  InkDistances measured;
  for (const SkalaInk& ink : *a.pictures)
    if (ink.kind != algorithms::skala::Subject::contours) measured.add(distances, ink, lines, finer);
  return distances.take();
}

algorithms::skala::View program_view(const CommonScene& scene) {
  algorithms::skala::View view = scene.height_view;
  view.levels = 4;
  return view;
}

}  // namespace sightline::compare
