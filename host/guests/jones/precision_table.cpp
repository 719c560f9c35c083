#include "host/guests/jones/precision_table.hpp"

#include <algorithm>
#include <utility>

#include "host/algorithms/oracle/matter.hpp"
#include "host/base/result.hpp"
#include "host/guests/jones/precision_guest.hpp"
#include "host/guests/jones/program.hpp"
#include "host/guests/jones/views.hpp"
#include "host/scene/read/cell_scene.hpp"

namespace sightline::guests::jones {
namespace {

namespace oracle = algorithms::oracle;

// The program shows everything from the plane z = 1 on.
oracle::Window exact_window() {
  oracle::Window window;
  window.near = near_z;
  return window;
}

std::vector<DrawnLine> drawn_lines(const std::vector<std::optional<SceneLine>>& lines,
                                   const std::vector<PrecisePiece>& pieces) {
  std::vector<DrawnLine> drawn;
  for (const PrecisePiece& piece : pieces) {
    if (const auto& line = lines.at(piece.vector_address)) drawn.push_back({*line, piece.line});
  }
  return drawn;
}

std::uint64_t sum_of(const Operations& operations, std::uint64_t Work::*count) {
  std::uint64_t sum = 0;
  for (const Work* work : {&operations.projection, &operations.line_box, &operations.line_sloped,
                           &operations.mask_box, &operations.mask_sloped, &operations.mask_area})
    sum += work->*count;
  return sum;
}

std::vector<core::Word18> image_of(const Program& program) {
  std::vector<core::Word18> words(core_words);
  for (const auto& [address, word] : program.core) words.at(address) = word;
  return words;
}

}  // namespace

bool ArithmeticError::complete() const {
  return std::all_of(statuses.begin(), statuses.end(), [](Status s) { return s == Status::complete; });
}

base::Result<PrecisionStudy> PrecisionStudy::of(const scene::CellScene& scene,
                                                std::span<const geometry::Point> eyes) {
  const auto matter = oracle::Matter::of(scene);
  if (!matter) return base::Error{"", "", "found a scene with too many grid units for the exact reference"};
  const auto lines = matter->real_lines();
  PrecisionStudy study;
  study.scene_ = scene;
  for (const geometry::Point& eye : eyes) {
    auto in_core = scene_in_core(scene, eye);
    if (!in_core) return std::move(in_core.error());
    study.views_.push_back(
        {eye, std::move(*in_core), oracle::visible_lines(*matter, lines, eye, exact_window())});
  }
  return study;
}

PreciseView PrecisionStudy::run(const View& view, const Precision& precision) const {
  return run_precisely(view.in_core.core, 0, default_parameters(view.in_core.core, 0), precision);
}

void PrecisionStudy::add(ArithmeticError& sum, std::size_t view, Status status,
                         const std::vector<DrawnLine>& drawn) const {
  const LineError error =
      line_error(views_[view].truth, drawn, views_[view].eye, exact_window(), named_from_points);
  sum.visible += error.visible;
  sum.missing += error.missing;
  sum.extra += error.extra;
  sum.longest = std::max(sum.longest, error.longest);
  for (const WrongStretch& stretch : error.wrong) sum.named.push_back({view, stretch});
  sum.statuses.push_back(status);
}

Measured PrecisionStudy::measure(const Precision& precision) const {
  Measured measured;
  measured.precision = precision;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const PreciseView view = run(views_[i], precision);
    add(measured.clipped, i, view.status, drawn_lines(views_[i].in_core.lines, view.pieces));
    measured.muldivs += sum_of(view.counts.operations, &Work::muldivs);
    measured.products += sum_of(view.counts.operations, &Work::products);
    measured.largest_coordinate = std::max(measured.largest_coordinate, view.counts.largest_coordinate);
  }
  return measured;
}

base::Result<Measured> PrecisionStudy::measure_on_machine(int fraction_bits, bool truncate, bool eae) const {
  Measured measured;
  measured.precision.fraction_bits = fraction_bits;
  measured.precision.truncate = truncate;
  measured.displayed.emplace();
  ProgramOptions options;
  options.eae = eae;
  options.fraction_bits = static_cast<std::uint32_t>(fraction_bits);
  options.truncate = truncate;
  const ShortWords number(machine_word_bits, fraction_bits, truncate);
  for (std::size_t i = 0; i < views_.size(); ++i) {
    options.tape.view = views_[i].eye;
    auto assembled = assemble_program(scene_, options);
    if (!assembled) return std::move(assembled.error());
    const auto& program = *assembled;
    const auto lines = lines_by_address(program.scene, image_of(program));
    const GuestPieces pieces = run_for_pieces(program, eae);
    const Window window;
    std::vector<DrawnLine> clipped, displayed;
    for (std::size_t n = 0; n < pieces.clipped.size(); ++n) {
      const auto& line = lines.at(pieces.clipped[n].vector_address);
      if (!line) continue;
      const ScreenSegment& at = pieces.clipped[n].line;
      clipped.push_back({*line,
                         {number.points(at.a.x) + window.centre_x, number.points(at.a.y) + window.centre_y,
                          number.points(at.b.x) + window.centre_x, number.points(at.b.y) + window.centre_y}});
      if (!pieces.clipped[n].drawn) continue;
      const auto point = [](std::int32_t place) { return static_cast<double>(place); };
      const ScreenSegment& shown = pieces.on_display[n];
      displayed.push_back({*line, {point(shown.a.x), point(shown.a.y), point(shown.b.x), point(shown.b.y)}});
    }
    add(measured.clipped, i, pieces.status, clipped);
    add(*measured.displayed, i, pieces.status, displayed);
  }
  return measured;
}

std::optional<int> PrecisionStudy::shortest_complete_word(int fraction_bits, bool truncate) const {
  for (int bits = shortest_word; bits <= longest_word; ++bits) {
    const Precision precision{NumberKind::fixed_point, bits, fraction_bits, truncate};
    const auto complete = [&](const View& view) { return run(view, precision).status == Status::complete; };
    if (std::all_of(views_.begin(), views_.end(), complete)) return bits;
  }
  return std::nullopt;
}

ErrorTable measure_error_table(bool eae) {
  ErrorTable table;
  for (int f = 0; f <= 3; ++f)
    table.columns.push_back({NumberKind::fixed_point, machine_word_bits, f, false});
  for (const int f : {0, 2}) table.columns.push_back({NumberKind::fixed_point, machine_word_bits, f, true});
  for (const SixViews& views : six_views) {
    const auto scene = scene::load_cell_scene(std::string(views.scene));
    ErrorTableRow row{std::string(views.scene), {views.eyes.begin(), views.eyes.end()}, {}};
    const auto study = PrecisionStudy::of(*scene, views.eyes);
    for (const Precision& column : table.columns) {
      auto cell = study->measure_on_machine(column.fraction_bits, column.truncate, eae);
      row.cells.push_back(std::move(*cell));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace sightline::guests::jones
