#include "host/scene/heights/read_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"
#include "host/scene/heights/read_grid_format.hpp"
#include "host/scene/heights/read_points.hpp"
#include "host/scene/heights/read_table.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {
namespace {

base::Error error_in(std::string_view source, std::string place, std::string found, std::string expected) {
  return {std::string(source), std::move(place), std::move(found), std::move(expected)};
}

// Of files that are taken for points because they have few columns: x y z, an intensity, a colour.
constexpr std::size_t most_point_columns = 7;

base::Result<HeightGrid> read_matrix(const HeightText& text, bool guessed, std::string_view source) {
  const HeightLine& first = text.lines.front();
  const std::size_t points = first.fields.size();
  if (auto error = unequal_lines(first, text.lines, source)) return *error;
  if (points > largest_grid.points)
    return error_in(source, place_of(first.number, first.fields[largest_grid.points].column), "more than 1024 fields", "at most 1024");
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
  // As long lists of points have.
  if (points >= 3 && points <= most_point_columns && slices > points) grid.note += "; if they are x y z, use --layout points";
  return grid;
}

base::Result<HeightGrid> read_as_table(const HeightLine& first, std::span<const HeightLine> others, bool guessed, std::string_view source) {
  auto grid = read_table(first, others, source);
  if (grid && guessed) {
    grid->note = "read as a table of " + count_of(grid->slices(), "row") + " and " + count_of(grid->points(), "column") +
                 ", with its places in the first line and column";
  }
  return grid;
}

// Are there so few columns for so many lines that these are points, be they on a grid or not?
bool has_few_columns(const HeightText& text) {
  const std::size_t columns = text.lines.front().fields.size();
  const std::size_t lines = text.lines.size();
  if (columns < 3 || columns > most_point_columns) return false;
  if (columns > 3 || lines < 3 || lines > 3 * columns) return lines > 3 * columns;
  if (std::any_of(text.lines.begin(), text.lines.end(), [](const HeightLine& line) { return line.after_blank; })) return true;
  if (lines == 3) return false;
  // The values of x and of y in order.
  std::array<std::vector<double>, 2> places;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const HeightLine& line : text.lines) places[axis].push_back(line.fields[axis].value);
    if (!std::all_of(places[axis].begin(), places[axis].end(), [](double place) { return std::isfinite(place); })) return false;
    std::sort(places[axis].begin(), places[axis].end());
  }
  const auto constant = [](const std::vector<double>& values) { return values.front() == values.back(); };
  const auto repeats = [](const std::vector<double>& values) { return std::adjacent_find(values.begin(), values.end()) != values.end(); };
  return !(constant(places[0]) && repeats(places[1])) && !(constant(places[1]) && repeats(places[0]));
}

constexpr PointColumns first_columns{0, 1, 2};

// The first line of a table becomes one of the others again.
void join_first_line(HeightText& text) {
  if (!text.heading.table) return;
  text.lines.insert(text.lines.begin(), std::move(text.heading.line));
  text.heading = {};
}

base::Result<HeightGrid> read_by_content(HeightText& text, std::string_view source) {
  if (text.heading.table) {
    if (!text.words.empty()) return text.words.front().second;
    const bool corner_is_named = !text.heading.names.front().empty();
    if (corner_is_named || is_table(text.heading.line, text.lines))
      return read_as_table(text.heading.line, text.lines, !corner_is_named, source);
    // A matrix whose first height is missing.
    join_first_line(text);
  }
  const auto named = columns_of_heading(text, source);
  if (!named) return named.error();
  if (*named) return read_points(text, **named, false, source);
  const auto unequal = unequal_lines(text.lines.front(), text.lines, source);
  if (!text.words.empty()) {
    // Such as the types of points that gnuplot's "set table" writes behind them.
    const auto is_behind = [](const auto& word) { return word.first > first_columns[2]; };
    const bool behind = std::all_of(text.words.begin(), text.words.end(), is_behind);
    if (behind && !unequal && (repeats_as_grid(text) || has_few_columns(text))) return read_points(text, first_columns, true, source);
    return text.words.front().second;
  }
  if (unequal) return *unequal;
  const std::span<const HeightLine> others = std::span<const HeightLine>(text.lines).subspan(1);
  if (!text.has_heading() && is_table(text.lines.front(), others)) return read_as_table(text.lines.front(), others, true, source);
  if (repeats_as_grid(text) || has_few_columns(text)) return read_points(text, first_columns, true, source);
  auto grid = read_matrix(text, true, source);
  if (grid && !text.has_heading() && has_places(text.lines.front(), others))
    grid->note += "; if its first line and column are places, use --layout table";
  return grid;
}

base::Result<HeightGrid> read_layout(HeightText& text, std::string_view source, const GridFileOptions& options) {
  const bool numbers_only = options.layout == GridLayout::matrix || options.layout == GridLayout::table;
  if (numbers_only && !text.words.empty()) return text.words.front().second;
  if (options.layout == GridLayout::matrix) {
    join_first_line(text);
    return read_matrix(text, false, source);
  }
  if (options.layout == GridLayout::table) {
    if (!text.heading.table) {
      text.heading.line = text.lines.front();
      text.lines.erase(text.lines.begin());
    }
    if (text.lines.empty()) return error_in(source, "", "one line of numbers", "a line of places along x and two or more below it");
    return read_table(text.heading.line, text.lines, source);
  }
  if (options.layout == GridLayout::by_content && options.columns.empty()) return read_by_content(text, source);
  if (text.heading.table && text.heading.names.front().empty()) join_first_line(text);
  if (!options.columns.empty()) {
    const auto columns = columns_named(text, options.columns, source);
    if (!columns) return columns.error();
    return read_points(text, *columns, false, source);
  }
  const auto named = columns_of_heading(text, source);
  if (!named) return named.error();
  return read_points(text, named->value_or(first_columns), false, source);
}

base::Result<HeightGrid> read_any(std::string_view text, std::string_view source, const GridFileOptions& options) {
  if (const std::string_view format = unread_format_of(text); !format.empty())
    return base::Error{std::string(source), "", std::string(format), "a text of heights",
                       "save it as text in UTF-8, such as CSV, or as an ESRI ASCII grid"};
  text = base::without_byte_order_mark(text);
  if (const GridFormatReader read = grid_format_of(text)) {
    if (options.columns.empty() && options.layout == GridLayout::by_content) return read(text, source);
    return base::Error{std::string(source), "", "an ASCII grid of ESRI or Surfer, whose layout is known", "a file of numbers",
                       "leave out --layout and --xyz"};
  }
  auto lines = read_height_text(text, source);
  if (!lines) return lines.error();
  return read_layout(*lines, source, options);
}

}  // namespace

base::Result<HeightGrid> read_height_grid(std::string_view text, std::string_view source, const GridFileOptions& options) {
  auto result = read_any(text, source, options);
  if (!result) return result;
  HeightGrid& grid = *result;
  if (grid.slices() > largest_grid.slices || grid.points() > largest_grid.points) {
    return error_in(source, "",
                    std::to_string(grid.slices()) + " slices of " + std::to_string(grid.points()) + " points",
                    "at most 1024 of 1024");
  }
  if (!anywhere_finite(grid.heights))
    return error_in(source, "", "a grid without any defined height", "at least one");
  grid.range = finite_range(grid.heights);
  return result;
}

base::Result<HeightGrid> load_height_grid(const std::string& file, const GridFileOptions& options) {
  const base::FileStatus status = base::file_status(file);
  if (status.kind == base::FileStatus::Kind::none) return error_in(file, "", "no such file", "");
  if (status.kind == base::FileStatus::Kind::other)
    return error_in(file, "", "something else, such as a directory", "a file");
  if (!status.error.empty()) return error_in(file, "", status.error, "a file that can be read");
  if (status.size > largest_grid_file) return error_in(file, "", "a file of more than 64 MiB", "at most that");
  const auto bytes = base::read_file(file);
  if (!bytes) return error_in(file, "", "a file that cannot be read", "");
  return read_height_grid(std::string(bytes->begin(), bytes->end()), file, options);
}

}  // namespace sightline::scene
