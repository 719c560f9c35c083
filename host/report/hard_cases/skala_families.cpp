// Two lines, the farther one steeper, cross: there the farther one should appear. Slopes differ by 1 / d, so
// that half a row of rounding is d / 2 columns.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "host/algorithms/skala/draw.hpp"
#include "host/guests/skala/guest.hpp"
#include "host/guests/skala/program.hpp"
#include "host/guests/skala/stream.hpp"
#include "host/guests/skala/twin/twin.hpp"
#include "host/report/hard_cases/skala.hpp"

namespace sightline::harness::report {

namespace {

using scene::HeightGrid;

constexpr double last = 255;

HeightGrid grid_of(std::size_t points, std::vector<double> heights) {
  const std::size_t slices = heights.size() / points;
  HeightGrid grid{
      scene::even_positions(points), scene::even_positions(slices), std::move(heights), {}, {}, {}};
  grid.range = scene::finite_range(grid.heights);
  return grid;
}

double near_height(double x) {
  return 100 + x / last;
}

// A floor, the nearer line, the farther line, and a ceiling, so that a height is a row; seen level. The lines
// cross at x = d.
HeightGrid crossing(int d) {
  return grid_of(2, {0, 0, 100, 101, 99, 100 + last / d, last, last});
}

guests::skala::View level_view() {
  guests::skala::View view;
  view.family = guests::skala::Family::along_x;
  view.elevation = 0;
  return view;
}

// The first column where something is lit above the nearer line and below the ceiling.
double first_above(const core::Raster& raster) {
  for (int x = 0; x <= static_cast<int>(last); ++x) {
    const int row = static_cast<int>(std::floor(near_height(x) + 0.5));
    for (int y = row + 1; y < static_cast<int>(last); ++y) {
      if (raster.at(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)) != 0) return x;
    }
  }
  return last;
}

// Where the line that ends above the nearer one at the right begins.
double first_above(const picture::VectorDrawing& drawing) {
  for (const picture::DrawingLine& line : drawing.lines) {
    const picture::DrawingPoint from = drawing.points[line.first];
    const picture::DrawingPoint to = drawing.points[line.first + line.count - 1];
    if (double{to.x} > last - 1 && to.y > near_height(last) && double{to.y} < last - 1e-3) return from.x;
  }
  return last;
}

double native_place(const HeightGrid& grid, int columns) {
  algorithms::skala::View view;
  view.family = algorithms::skala::Family::along_x;
  view.elevation = 0;
  view.rims = false;
  view.columns = columns;
  return first_above(algorithms::skala::draw(grid, view));
}

struct Curve {
  std::string build;
  std::vector<double> errors;  // columns of the board, by parameter
};

// The first parameter whose error is above a limit: of so many columns, or of the parameter itself.
Cell failure(const Curve& curve, const std::vector<int>& parameters, std::optional<double> limit) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (curve.errors[i] > limit.value_or(parameters[i])) return Cell(std::int64_t{parameters[i]});
  }
  return Cell(std::string("none"));
}

}  // namespace

Outcome<Table> skala_families(const Context& context) {
  context.progress("hard case S11: first failures");
  const std::vector<int> parameters{2, 4, 8, 16, 32, 64, 128};
  const guests::skala::Program program = guests::skala::assemble_program();
  std::vector<Curve> curves{{"program on the 8080", {}}, {"twin", {}}};
  const std::vector<int> masks{algorithms::skala::fewest_columns, 256, 1024, 4096,
                               algorithms::skala::most_columns};
  for (const int columns : masks)
    curves.push_back({fmt::format("native Skala, masks of {} columns", columns), {}});
  for (const int d : parameters) {
    const HeightGrid grid = crossing(d);
    const auto stream = guests::skala::stream_of(grid, level_view());
    const double exact = d;
    const auto add = [&](std::size_t curve, double place) {
      curves[curve].errors.push_back(std::abs(place - exact));
    };
    add(0, first_above(guests::skala::run_guest(program, stream).raster));
    add(1, first_above(guests::skala::run_twin(stream).raster(guests::skala::Device::ef9365)));
    for (std::size_t i = 0; i < masks.size(); ++i) add(2 + i, native_place(grid, masks[i]));
  }
  Table table;
  table.id = "hard-cases-skala-first-failures";
  table.title = "Skala: how far from the exact crossing a farther line appears";
  table.columns = {{"case", "Case", "", false}, {"build", "Build", "", false}};
  for (const int d : parameters)
    table.columns.push_back({fmt::format("d{}_columns", d), fmt::format("d = {}", d), "columns", false});
  table.columns.push_back({"off_by_a_column", "First off by more than a column", "d", false});
  table.columns.push_back({"off_by_bound", "First beyond the bound of d columns", "d", false});
  for (std::size_t c = 0; c < curves.size(); ++c) {
    std::vector<Cell> row{std::string(c < 2 ? "S11" : "S11, S14"), curves[c].build};
    for (const double error : curves[c].errors) row.emplace_back(Real{error, 2});
    row.push_back(failure(curves[c], parameters, 1));
    row.push_back(failure(curves[c], parameters, std::nullopt));
    table.rows.push_back(std::move(row));
  }
  table.notes = {
      "Slices: 0 0, then 100 101, then 99 and 100 + 255/d, then 255 255, seen level: heights are rows. The "
      "second and the third cross in column d, at slopes that differ by 1/d. On a raster of whole rows the "
      "farther line appears where it is a row above the nearer: off by up to d columns. The program's raster "
      "has 256 columns and byte arithmetic, so that a wider one cannot be asked of it; native masks reach "
      "16384."};
  return table;
}

}  // namespace sightline::harness::report
