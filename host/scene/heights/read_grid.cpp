#include "host/scene/heights/read_grid.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "host/scene/heights/read_columns.hpp"
#include "host/scene/heights/read_points.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {
namespace {

base::Error error_in(std::string_view source, std::string place, std::string found, std::string expected) {
  return {std::string(source), std::move(place), std::move(found), std::move(expected)};
}

std::string count_of(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

base::Result<HeightGrid> read_matrix(const HeightText& text, std::string_view source) {
  const HeightLine& first = text.lines.front();
  const std::size_t points = first.fields.size();
  HeightGrid grid;
  for (const HeightLine& line : text.lines) {
    const std::size_t count = line.fields.size();
    if (count == points) {
      for (const HeightField& field : line.fields) grid.heights.push_back(field.value);
      continue;
    }
    const std::size_t column = count > points ? line.fields[points].column : line.end;
    return error_in(source, place_of(line.number, column), count_of(count, "field"),
                    std::to_string(points) + " as in line " + std::to_string(first.number));
  }
  const std::size_t slices = text.lines.size();
  if (slices < smallest_grid.slices || points < smallest_grid.points) {
    return error_in(source, "", count_of(slices, "line") + " of " + count_of(points, "field"),
                    "at least two of two");
  }
  grid.x = even_positions(points);
  grid.z = even_positions(slices);
  grid.domain_x = {0, static_cast<double>(points - 1)};
  grid.domain_z = {0, static_cast<double>(slices - 1)};
  return grid;
}

// With the form it is in.
base::Result<HeightGrid> read_form(HeightText& text, std::string_view source, const GridFileOptions& options) {
  if (!options.columns.empty()) {
    const auto columns = columns_named(text, options.columns, source);
    if (!columns) return columns.error();
    return read_scattered(text, *columns, source);
  }
  const bool corner_is_named = text.has_heading() && !text.heading.names.front().empty();
  if (text.heading.table && (corner_is_named || is_table(text))) return read_table(text, source);
  if (text.heading.table) {
    // A matrix whose first height is missing.
    text.lines.insert(text.lines.begin(), text.heading.line);
    text.heading = {};
  }
  if (is_point_data(text)) return read_points(text, source);
  if (const auto columns = columns_by_content(text)) return read_scattered(text, *columns, source);
  return read_matrix(text, source);
}

}  // namespace

base::Result<HeightGrid> read_height_grid(std::string_view text, std::string_view source, const GridFileOptions& options) {
  auto lines = read_height_text(text, source);
  if (!lines) return lines.error();
  auto result = read_form(*lines, source, options);
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
