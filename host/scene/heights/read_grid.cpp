#include "host/scene/heights/read_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"
#include "host/scene/heights/grid_formats.hpp"
#include "host/scene/heights/read_points.hpp"
#include "host/scene/heights/read_table.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {
namespace {

base::Error error_in(std::string_view source, std::string place, std::string found, std::string expected) {
  return {std::string(source), std::move(place), std::move(found), std::move(expected)};
}

// The most columns of a file that is taken for points by its number of lines: x y z, an intensity, a colour.
constexpr std::size_t most_point_columns = 7;

base::Result<HeightGrid> read_matrix(const HeightText& text, bool guessed, std::string_view source) {
  const HeightLine& first = text.lines.front();
  const std::size_t points = first.fields.size();
  if (auto error = unequal_lines(first, text.lines, source)) return *error;
  const std::size_t slices = text.lines.size();
  if (slices < smallest_grid.slices || points < smallest_grid.points)
    return error_in(source, "", count_of(slices, "line") + " of " + count_of(points, "field"), "at least two of two");
  HeightGrid grid;
  for (const HeightLine& line : text.lines)
    for (const HeightField& field : line.fields) grid.heights.push_back(field.value);
  grid.x = even_positions(points);
  grid.z = even_positions(slices);
  grid.domain_x = {0, static_cast<double>(points - 1)};
  grid.domain_z = {0, static_cast<double>(slices - 1)};
  if (!guessed) return grid;
  grid.note = "read as a matrix of " + count_of(slices, "row") + " and " + count_of(points, "column");
  // A long list of points has so few columns.
  if (points >= 3 && points <= most_point_columns && slices > points) grid.note += "; if they are x y z, use --layout points";
  return grid;
}

base::Result<HeightGrid> read_as_table(const HeightLine& first, std::span<const HeightLine> others, bool guessed,
                                       std::string_view source) {
  auto grid = read_table(first, others, source);
  if (grid && guessed) {
    grid->note = "read as a table of " + count_of(grid->slices(), "row") + " and " + count_of(grid->points(), "column") +
                 ", with its places in the first line and column";
  }
  return grid;
}

// Whether blank lines separate blocks, the first of which has two lines or more.
bool in_blocks(const HeightText& text) {
  if (text.lines.size() < 2 || text.lines[1].after_blank) return false;
  return std::any_of(text.lines.begin(), text.lines.end(), [](const HeightLine& line) { return line.after_blank; });
}

// Whether lines of a few numbers are points: there are many of them, or blank lines separate blocks.
bool has_few_columns(const HeightText& text) {
  const std::size_t columns = text.lines.front().fields.size();
  const std::size_t lines = text.lines.size();
  if (columns < 3) return false;
  return in_blocks(text) || (columns <= most_point_columns && lines > (columns == 3 ? 3 : 3 * columns));
}

// One height a line, slices between blank lines.
base::Result<HeightGrid> read_column(const HeightText& text, std::string_view source) {
  HeightGrid grid;
  std::size_t points = 0;
  std::size_t slices = 0;
  std::size_t length = 0;
  const auto end_slice = [&](const HeightLine& last) -> std::optional<base::Error> {
    if (slices == 0) points = length;
    ++slices;
    if (length == points && length >= smallest_grid.points) return std::nullopt;
    return error_in(source, place_of(last.number, 1), "slice " + std::to_string(slices) + " of " + count_of(length, "height"),
                    slices == 1 ? "two or more between blank lines" : std::to_string(points) + " as in the first one");
  };
  for (const HeightLine& line : text.lines) {
    if (line.after_blank) {
      if (auto error = end_slice(line)) return *error;
      length = 0;
    }
    grid.heights.push_back(line.fields.front().value);
    ++length;
  }
  if (auto error = end_slice(text.lines.back())) return *error;
  grid.x = even_positions(points);
  grid.z = even_positions(slices);
  grid.domain_x = {0, static_cast<double>(points - 1)};
  grid.domain_z = {0, static_cast<double>(slices - 1)};
  grid.note = "read as " + count_of(slices, "slice") + " of " + count_of(points, "height") + ", one a line";
  return grid;
}

base::Result<HeightSurface> surface_of(base::Result<HeightGrid> grid) {
  if (!grid) return std::move(grid.error());
  return HeightSurface(std::move(*grid));
}

constexpr PointColumns first_columns{0, 1, 2};

// Makes the first line of a table an ordinary line again.
void join_first_line(HeightText& text) {
  if (!text.heading.table) return;
  text.lines.insert(text.lines.begin(), std::move(text.heading.line));
  text.heading = {};
}

base::Result<HeightSurface> read_by_content(HeightText& text, const GridFileOptions& options, std::string_view source) {
  if (text.heading.table) {
    if (!text.words.empty()) return text.words.front().second;
    const bool corner_is_named = !text.heading.names.front().empty();
    if (corner_is_named || is_table(text.heading.line, text.lines))
      return surface_of(read_as_table(text.heading.line, text.lines, !corner_is_named, source));
    // A matrix whose first height is missing.
    join_first_line(text);
  }
  const auto named = columns_of_heading(text, source);
  if (!named) return named.error();
  if (*named) return read_points(text, **named, false, options, source);
  const auto unequal = unequal_lines(text.lines.front(), text.lines, source);
  const bool points = repeats_as_grid(text) || has_few_columns(text);
  if (!text.words.empty()) {
    // Such as the types of points that gnuplot's "set table" writes behind them.
    const auto is_behind = [](const auto& word) { return word.first > first_columns[2]; };
    const bool behind = std::all_of(text.words.begin(), text.words.end(), is_behind);
    if (behind && !unequal && points) return read_points(text, first_columns, true, options, source);
    return text.words.front().second;
  }
  if (unequal) return *unequal;
  const std::span<const HeightLine> others = std::span<const HeightLine>(text.lines).subspan(1);
  if (!text.has_heading() && is_table(text.lines.front(), others))
    return surface_of(read_as_table(text.lines.front(), others, true, source));
  if (points) return read_points(text, first_columns, true, options, source);
  if (text.lines.front().fields.size() == 1 && in_blocks(text)) return surface_of(read_column(text, source));
  auto grid = read_matrix(text, true, source);
  if (grid && !text.has_heading() && has_places(text.lines.front(), others))
    grid->note += "; if its first line and column are places, use --layout table";
  return surface_of(std::move(grid));
}

base::Result<HeightSurface> read_layout(HeightText& text, std::string_view source, const GridFileOptions& options) {
  const bool numbers_only = options.layout == GridLayout::matrix || options.layout == GridLayout::table;
  if (numbers_only && !text.words.empty()) return text.words.front().second;
  if (options.layout == GridLayout::matrix) {
    join_first_line(text);
    return surface_of(read_matrix(text, false, source));
  }
  if (options.layout == GridLayout::table) {
    if (!text.heading.table) {
      text.heading.line = text.lines.front();
      text.lines.erase(text.lines.begin());
    }
    if (text.lines.empty())
      return error_in(source, "", "one line of numbers", "a line of places along x and two or more below it");
    return surface_of(read_table(text.heading.line, text.lines, source));
  }
  const bool points = options.layout == GridLayout::points || !options.columns.empty() || options.triangulate;
  if (!points) return read_by_content(text, options, source);
  if (text.heading.table && text.heading.names.front().empty()) join_first_line(text);
  if (!options.columns.empty()) {
    const auto columns = columns_named(text, options.columns, source);
    if (!columns) return columns.error();
    return read_points(text, *columns, false, options, source);
  }
  const auto named = columns_of_heading(text, source);
  if (!named) return named.error();
  return read_points(text, named->value_or(first_columns), false, options, source);
}

base::Result<HeightSurface> read_any(std::string_view bytes, std::string_view source, const GridFileOptions& options) {
  const std::string_view text = base::without_byte_order_mark(bytes);
  if (const GridFormat* const format = grid_format_of(text, source)) {
    if (options.columns.empty() && options.layout == GridLayout::by_content && !options.triangulate)
      return surface_of(format->read(text, source));
    return base::Error{std::string(source), "", std::string(format->name) + ", whose layout is known", "a file of numbers",
                       "leave out --layout, --xyz and --triangulate"};
  }
  if (const std::string_view format = unread_format_of(bytes); !format.empty())
    return base::Error{std::string(source), "", std::string(format), "a grid of heights",
                       "save it as text in UTF-8, such as CSV, or as an ESRI ASCII grid"};
  auto lines = read_height_text(text, source);
  if (!lines) return lines.error();
  return read_layout(*lines, source, options);
}

// "4th"
std::string ordinal(std::size_t number) {
  const std::size_t last = number % 10;
  const bool teen = number / 10 % 10 == 1;
  return std::to_string(number) + (teen || last == 0 || last > 3 ? "th" : last == 1 ? "st" : last == 2 ? "nd" : "rd");
}

// "every 4th point of 3601 x 3601, 901 x 901"
void add_thinning_note(std::string& note, std::size_t step, GridSize before, GridSize after) {
  const auto size_text = [](GridSize size) { return std::to_string(size.points) + " x " + std::to_string(size.slices); };
  note += (note.empty() ? "" : "; ") + std::string("every ") + ordinal(step) + " point of " + size_text(before) + " is taken, a grid of " + size_text(after);
}

GridSize size_of(const HeightGrid& grid) { return {grid.points(), grid.slices()}; }
GridSize size_of(const SurfaceNet& net) { return {net.points, net.curves}; }

template <class Surface>
std::optional<base::Error> make_smaller(Surface& surface, const GridFileOptions& options, std::string_view source) {
  const auto thin_by = [&surface](std::size_t step) {
    const GridSize before = size_of(surface);
    surface = thinned(surface, step);
    add_thinning_note(surface.note, step, before, size_of(surface));
  };
  if (options.thin && *options.thin > 1) thin_by(*options.thin);
  const GridSize size = size_of(surface);
  if (size.points <= largest_grid.points && size.slices <= largest_grid.slices) return std::nullopt;
  const std::size_t most = largest_grid.points;
  const std::size_t step = (std::max(size.points, size.slices) + most - 1) / most * options.thin.value_or(1);
  if (!options.thin && options.thin_to_fit) {
    thin_by(step);
    return std::nullopt;
  }
  return base::Error{std::string(source), "", count_of(size.slices, "slice") + " of " + count_of(size.points, "point"),
                     "at most 1024 of 1024",
                     "--thin " + std::to_string(step) + " takes every " + ordinal(step) + " point"};
}

// Makes holes of the heights that a person named with --nodata.
void remove_nodata(HeightGrid& grid, double nodata) {
  const auto is_none = [nodata](double height) { return is_nodata(height, nodata); };
  std::replace_if(grid.heights.begin(), grid.heights.end(), is_none, std::numeric_limits<double>::quiet_NaN());
}

std::optional<base::Error> file_error(const std::string& file) {
  const base::FileStatus status = base::file_status(file);
  if (status.kind == base::FileStatus::Kind::none) return error_in(file, "", "no such file", "");
  if (status.kind == base::FileStatus::Kind::other) return error_in(file, "", "something else, such as a directory", "a file");
  if (!status.error.empty()) return error_in(file, "", status.error, "a file that can be read");
  if (status.size > largest_grid_file) return error_in(file, "", "a file of more than 128 MiB", "at most that");
  return std::nullopt;
}

base::Result<HeightGrid> grid_only(base::Result<HeightSurface> surface, std::string_view source) {
  if (!surface) return std::move(surface.error());
  if (auto* const grid = std::get_if<HeightGrid>(&*surface)) return std::move(*grid);
  const SurfaceNet& net = std::get<SurfaceNet>(*surface);
  return base::Error{std::string(source), "",
                     count_of(net.curves, "block") + " of points that form no grid: a parametric surface",
                     "heights over a grid: in each block x or y is the same", "sightline draw skala draws it"};
}

}  // namespace

base::Result<HeightSurface> read_height_surface(std::string_view bytes, std::string_view source, const GridFileOptions& options) {
  auto result = read_any(bytes, source, options);
  if (!result) return result;
  if (auto* const net = std::get_if<SurfaceNet>(&*result)) {
    if (auto error = make_smaller(*net, options, source)) return *error;
    return result;
  }
  HeightGrid& grid = std::get<HeightGrid>(*result);
  if (options.nodata) remove_nodata(grid, *options.nodata);
  if (auto error = make_smaller(grid, options, source)) return *error;
  if (!anywhere_finite(grid.heights)) return error_in(source, "", "a grid without any defined height", "at least one");
  grid.range = finite_range(grid.heights);
  return result;
}

base::Result<HeightGrid> read_height_grid(std::string_view bytes, std::string_view source, const GridFileOptions& options) {
  return grid_only(read_height_surface(bytes, source, options), source);
}

base::Result<HeightSurface> load_height_surface(const std::string& file, const GridFileOptions& options) {
  if (auto error = file_error(file)) return *error;
  const auto bytes = base::read_file(file);
  if (!bytes) return error_in(file, "", "a file that cannot be read", "");
  return read_height_surface({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, file, options);
}

base::Result<HeightGrid> load_height_grid(const std::string& file, const GridFileOptions& options) {
  return grid_only(load_height_surface(file, options), file);
}

}  // namespace sightline::scene
