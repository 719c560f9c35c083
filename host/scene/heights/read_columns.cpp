#include "host/scene/heights/read_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/result.hpp"

namespace sightline::scene {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// Places nearer to each other than this part of all are one, written with different rounding.
constexpr double same_place = 1e-9;

std::string in_small(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return small;
}

base::Error error_at(std::string_view source, const HeightLine& line, std::size_t field, std::string found, std::string expected) {
  const std::size_t column = field < line.fields.size() ? line.fields[field].column : line.end;
  return {std::string(source), place_of(line.number, column), std::move(found), std::move(expected)};
}

// The column whose name is one of these.
std::optional<std::size_t> column_called(const HeightText& text, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    const auto found = std::find_if(text.heading.names.begin(), text.heading.names.end(),
                                    [name](const std::string& heading) { return in_small(heading) == name; });
    if (found != text.heading.names.end()) return static_cast<std::size_t>(found - text.heading.names.begin());
  }
  return std::nullopt;
}

std::optional<PointColumns> columns_called(const HeightText& text) {
  const auto x = column_called(text, {"x"});
  const auto y = column_called(text, {"y"});
  const auto z = column_called(text, {"z"});
  const auto height = column_called(text, {"h", "height", "heights", "value", "elevation", "elev", "altitude", "f"});
  if (x && y && (z || height)) return PointColumns{*x, *y, z ? *z : *height};
  if (x && y && text.heading.names.size() == 3) return PointColumns{*x, *y, 3 - *x - *y};
  if (x && z && height) return PointColumns{*x, *z, *height};
  const auto longitude = column_called(text, {"lon", "long", "lng", "longitude", "easting"});
  const auto latitude = column_called(text, {"lat", "latitude", "northing"});
  if (longitude && latitude && (height || z)) return PointColumns{*longitude, *latitude, height ? *height : *z};
  return std::nullopt;
}

// Places along one axis, each once, ascending.
class Places {
 public:
  explicit Places(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double extent = values.back() / 2 - values.front() / 2;
    for (const double value : values)
      if (places_.empty() || value / 2 - places_.back() / 2 > same_place * extent) places_.push_back(value);
  }
  [[nodiscard]] const std::vector<double>& all() const { return places_; }
  [[nodiscard]] Interval domain() const { return {places_.front(), places_.back()}; }
  [[nodiscard]] std::size_t index(double value) const {
    return static_cast<std::size_t>(std::upper_bound(places_.begin(), places_.end(), value) - places_.begin()) - 1;
  }

 private:
  std::vector<double> places_;
};

// In [-1, 1]; nullopt if two of them come to the same.
std::optional<std::vector<double>> positions_of(const std::vector<double>& ascending) {
  const Interval domain{ascending.front(), ascending.back()};
  if (!(domain.high / 2 - domain.low / 2 >= std::numeric_limits<double>::min())) return std::nullopt;
  std::vector<double> positions = normalised(ascending, domain);
  if (std::adjacent_find(positions.begin(), positions.end()) != positions.end()) return std::nullopt;
  return positions;
}

class Scattered {
 public:
  Scattered(const HeightText& text, const PointColumns& columns, std::string_view source)
      : text_(text), columns_(columns), source_(source) {}

  base::Result<HeightGrid> grid() {
    for (const HeightLine& line : text_.lines)
      if (auto error = wrong(line)) return *error;
    const Places x(values(columns_[0]));
    const Places y(values(columns_[1]));
    for (const auto& [places, axis] : {std::pair{&x, 0}, std::pair{&y, 1}})
      if (auto error = refused(*places, name(static_cast<std::size_t>(axis)))) return *error;
    const std::size_t all = x.all().size() * y.all().size();
    // Points anywhere, in general position, have as many places along either axis as there are points.
    if (text_.lines.size() * 4 < all) {
      return base::Error{source_, "", std::to_string(text_.lines.size()) + " points on a grid of " + std::to_string(x.all().size()) + " by " +
                                          std::to_string(y.all().size()) + " places",
                         "points on a grid, a quarter of its places or more"};
    }
    HeightGrid grid{*positions_of(x.all()), *positions_of(y.all()), std::vector<double>(all, nan), x.domain(), y.domain(), {}, {}};
    std::vector<const HeightLine*> first(all, nullptr);
    for (const HeightLine& line : text_.lines) {
      const std::size_t place = y.index(value(line, 1)) * x.all().size() + x.index(value(line, 0));
      if (first[place] != nullptr) {
        return error_at(source_, line, columns_[0], "a second point at " + name(0) + " = " + shortest_text(value(line, 0)) + ", " + name(1) + " = " +
                                                        shortest_text(value(line, 1)),
                        "one point for each place; the first is in line " + std::to_string(first[place]->number));
      }
      first[place] = &line;
      grid.heights[place] = value(line, 2);
    }
    if (text_.has_heading() && !text_.heading.table)
      for (std::size_t axis = 0; axis < 3; ++axis) grid.names[axis] = text_.heading.names[columns_[axis]];
    return grid;
  }

 private:
  [[nodiscard]] double value(const HeightLine& line, std::size_t axis) const { return line.fields[columns_[axis]].value; }
  [[nodiscard]] std::vector<double> values(std::size_t column) const {
    std::vector<double> all;
    all.reserve(text_.lines.size());
    for (const HeightLine& line : text_.lines) all.push_back(line.fields[column].value);
    return all;
  }
  [[nodiscard]] std::string name(std::size_t axis) const {
    if (text_.has_heading() && !text_.heading.table) return text_.heading.names[columns_[axis]];
    return axis == 0 ? "x" : "y";
  }

  [[nodiscard]] std::optional<base::Error> wrong(const HeightLine& line) const {
    const std::size_t expected = text_.has_heading() ? text_.heading.line.fields.size() : text_.lines.front().fields.size();
    if (line.fields.size() != expected || *std::max_element(columns_.begin(), columns_.end()) >= expected) {
      return error_at(source_, line, expected, std::to_string(line.fields.size()) + " fields",
                      std::to_string(expected) + " as in line " +
                          std::to_string(text_.has_heading() ? text_.heading.line.number : text_.lines.front().number));
    }
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
      if (!std::isfinite(value(line, axis))) return error_at(source_, line, columns_[axis], "no " + name(axis), "a number; only a height may be missing");
    return std::nullopt;
  }

  [[nodiscard]] std::optional<base::Error> refused(const Places& places, const std::string& name) const {
    const std::size_t count = places.all().size();
    if (count > largest_grid.points) {
      return base::Error{source_, "", std::to_string(count) + " different values of " + name,
                         "at most 1024, of points that lie on a grid"};
    }
    if (count < smallest_grid.points) return base::Error{source_, "", "one value of " + name + " on every line", "at least two"};
    if (!positions_of(places.all()))
      return base::Error{source_, "", name + " from " + shortest_text(places.domain().low) + " to " + shortest_text(places.domain().high), "places that are farther apart"};
    return std::nullopt;
  }

  const HeightText& text_;
  const PointColumns& columns_;
  std::string source_;
};

bool strictly_monotone(const std::vector<double>& values) {
  const auto step = [falling = values.size() > 1 && values[0] > values[1]](double a, double b) { return !(falling ? b < a : b > a); };
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }) &&
         std::adjacent_find(values.begin(), values.end(), step) == values.end();
}

std::vector<double> places_across(const HeightText& text) {
  std::vector<double> places;
  for (std::size_t i = 1; i < text.heading.line.fields.size(); ++i) places.push_back(text.heading.line.fields[i].value);
  return places;
}

std::vector<double> places_down(const HeightText& text) {
  std::vector<double> places;
  for (const HeightLine& line : text.lines) places.push_back(line.fields.front().value);
  return places;
}

}  // namespace

base::Result<PointColumns> columns_named(const HeightText& text, const std::vector<std::string>& names, std::string_view source) {
  const std::size_t count = text.has_heading() ? text.heading.line.fields.size() : text.lines.front().fields.size();
  PointColumns columns{};
  std::string known;
  if (!text.heading.table)
    for (const std::string& name : text.heading.names) known += (known.empty() ? "" : ", ") + name;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string wanted = in_small(names[axis]);
    const auto named = text.heading.table ? std::nullopt : column_called(text, {std::string_view(wanted)});
    const auto number = base::whole_number<std::size_t>(names[axis], 10, 1, count);
    if (!named && !number) {
      return base::Error{std::string(source), "", "no column " + names[axis],
                         known.empty() ? "a number from 1 to " + std::to_string(count) : "one of " + known + ", or a number from 1 to " + std::to_string(count)};
    }
    columns[axis] = named ? *named : *number - 1;
  }
  return columns;
}

std::optional<PointColumns> columns_by_content(const HeightText& text) {
  if (text.heading.table) return std::nullopt;
  if (text.has_heading()) {
    if (auto columns = columns_called(text)) return columns;
    if (text.heading.names.size() != 3) return std::nullopt;
  }
  std::vector<double> x;
  std::vector<double> y;
  for (const HeightLine& line : text.lines) {
    if (line.fields.size() != 3 || !std::isfinite(line.fields[0].value) || !std::isfinite(line.fields[1].value)) return std::nullopt;
    x.push_back(line.fields[0].value);
    y.push_back(line.fields[1].value);
  }
  const Places columns(std::move(x));
  const Places rows(std::move(y));
  // No place twice, and at least half of the grid's.
  const std::size_t all = columns.all().size() * rows.all().size();
  if (columns.all().size() < 2 || rows.all().size() < 2 || text.lines.size() > all || 2 * text.lines.size() < all || text.lines.size() < 4)
    return std::nullopt;
  std::vector<bool> taken(all);
  for (const HeightLine& line : text.lines) {
    const std::size_t place = rows.index(line.fields[1].value) * columns.all().size() + columns.index(line.fields[0].value);
    if (taken[place]) return std::nullopt;
    taken[place] = true;
  }
  return PointColumns{0, 1, 2};
}

base::Result<HeightGrid> read_scattered(const HeightText& text, const PointColumns& columns, std::string_view source) {
  return Scattered(text, columns, source).grid();
}

bool is_table(const HeightText& text) {
  if (!text.heading.table) return false;
  return strictly_monotone(places_across(text)) && strictly_monotone(places_down(text));
}

base::Result<HeightGrid> read_table(const HeightText& text, std::string_view source) {
  const std::size_t count = text.heading.line.fields.size();
  for (const HeightLine& line : text.lines) {
    if (line.fields.size() == count) continue;
    return error_at(source, line, count, std::to_string(line.fields.size()) + " fields",
                    std::to_string(count) + " as in line " + std::to_string(text.heading.line.number));
  }
  std::vector<double> x = places_across(text);
  std::vector<double> z = places_down(text);
  const std::string expected = "places that rise or fall from one to the next";
  if (!strictly_monotone(x)) return error_at(source, text.heading.line, 1, "a first line of places that do not rise or fall", expected);
  if (!strictly_monotone(z)) return error_at(source, text.lines.front(), 0, "a first column of places that do not rise or fall", expected);
  if (x.size() < smallest_grid.points || z.size() < smallest_grid.slices) {
    return base::Error{std::string(source), "", std::to_string(z.size()) + " lines of " + std::to_string(x.size()) + " heights", "at least two of two"};
  }
  const bool x_falls = x.front() > x.back();
  const bool z_falls = z.front() > z.back();
  if (x_falls) std::reverse(x.begin(), x.end());
  if (z_falls) std::reverse(z.begin(), z.end());
  const auto positions_x = positions_of(x);
  const auto positions_z = positions_of(z);
  if (!positions_x || !positions_z) return base::Error{std::string(source), "", "places that are too close to each other", "places that are farther apart"};
  HeightGrid grid{*positions_x, *positions_z, {}, {x.front(), x.back()}, {z.front(), z.back()}, {}, {}};
  for (std::size_t slice = 0; slice < z.size(); ++slice) {
    const HeightLine& line = text.lines[z_falls ? z.size() - 1 - slice : slice];
    for (std::size_t point = 0; point < x.size(); ++point)
      grid.heights.push_back(line.fields[1 + (x_falls ? x.size() - 1 - point : point)].value);
  }
  return grid;
}

}  // namespace sightline::scene
