#include "host/scene/heights/read_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"
#include "host/scene/heights/interpolate.hpp"

namespace sightline::scene {
namespace {

// Places of heights along one axis, each once, ascending. Places that differ by less than 10^-9 of the whole extent are equal: files
// write them with different rounding.
class Places {
 public:
  // `values` are finite and not empty.
  explicit Places(std::vector<double> values) {
    constexpr double same_place = 1e-9;
    std::sort(values.begin(), values.end());
    // Halves, because a difference may exceed the largest double.
    const double extent = values.back() / 2 - values.front() / 2;
    for (const double value : values)
      if (places_.empty() || value / 2 - places_.back() / 2 > same_place * extent) places_.push_back(value);
  }

  [[nodiscard]] const std::vector<double>& all() const { return places_; }
  [[nodiscard]] std::size_t count() const { return places_.size(); }
  [[nodiscard]] Interval domain() const { return {places_.front(), places_.back()}; }
  // The index of the place of this value, which is one of those that the constructor had.
  [[nodiscard]] std::size_t index(double value) const {
    return static_cast<std::size_t>(std::upper_bound(places_.begin(), places_.end(), value) - places_.begin()) - 1;
  }

 private:
  std::vector<double> places_;
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The column whose name is one of these, in any case; "height (m)" is height.
std::optional<std::size_t> column_called(const HeightText& text, std::initializer_list<std::string_view> names) {
  const auto without_unit = [](const std::string& heading) {
    const std::size_t unit = heading.find_first_of("([");
    const bool has_unit = unit != std::string::npos && base::without_blanks(heading.substr(0, unit)) != "";
    return base::lower_case(
        base::without_blanks(has_unit ? std::string_view(heading).substr(0, unit) : std::string_view(heading)));
  };
  const auto& headings = text.heading.names;
  for (const std::string_view name : names)
    for (std::size_t i = 0; i < headings.size(); ++i)
      if (base::lower_case(headings[i]) == name || without_unit(headings[i]) == name) return i;
  return std::nullopt;
}

std::string names_of(const HeightText& text) {
  return text.heading.table ? std::string() : base::joined(text.heading.names, ", ");
}

class Points {
 public:
  Points(const HeightText& text, const PointColumns& columns, bool guessed, const GridFileOptions& options,
         std::string_view source)
      : text_(text), columns_(columns), guessed_(guessed), options_(options), source_(source) {}

  // A grid if the points form one, else a net if they are in blocks. Blocks along which both x and y change are curves, even if all
  // points lie on a grid.
  base::Result<HeightSurface> surface() {
    if (auto error = why_no_points()) return *error;
    if (options_.triangulate) return triangulated();
    if (!in_blocks()) return grid_surface();
    auto curves = net();
    if (curves && turns()) return HeightSurface(std::move(*curves));
    auto read = grid_surface();
    if (read) return read;
    if (curves) return HeightSurface(std::move(*curves));
    return std::move(curves.error());
  }

 private:
  base::Result<HeightSurface> grid_surface() {
    auto read = grid();
    if (!read) return std::move(read.error());
    return HeightSurface(std::move(*read));
  }
  // Is there a block along which both x and y change?
  bool turns() {
    const Places x(values(0));
    const Places y(values(1));
    const HeightLine* first = nullptr;
    bool x_changes = false;
    bool y_changes = false;
    for (const HeightLine& line : text_.lines) {
      if (first == nullptr || line.after_blank) {
        first = &line;
        x_changes = y_changes = false;
      }
      x_changes = x_changes || x.index(value(line, 0)) != x.index(value(*first, 0));
      y_changes = y_changes || y.index(value(line, 1)) != y.index(value(*first, 1));
      if (x_changes && y_changes) return true;
    }
    return false;
  }
  base::Result<HeightGrid> grid() {
    const Places x(values(0));
    const Places y(values(1));
    for (const auto& [places, axis] : {std::pair{&x, std::size_t{0}}, std::pair{&y, std::size_t{1}}})
      if (auto error = why_no_axis(*places, axis)) return *error;
    if (std::uint64_t{x.count()} * y.count() > 4 * std::uint64_t{text_.lines.size()}) return no_grid(x, y);
    HeightGrid grid{*positions_of(x.all()),
                    *positions_of(y.all()),
                    std::vector<double>(x.count() * y.count(), nan),
                    x.domain(),
                    y.domain(),
                    {},
                    {},
                    {}};
    std::vector<const HeightLine*> first(grid.heights.size(), nullptr);
    std::size_t repeated = 0;
    for (const HeightLine& line : text_.lines) {
      const std::size_t place = y.index(value(line, 1)) * x.count() + x.index(value(line, 0));
      const double height = height_of(line);
      if (first[place] == nullptr) {
        first[place] = &line;
        grid.heights[place] = height;
      } else if (grid.heights[place] == height || (std::isnan(grid.heights[place]) && std::isnan(height))) {
        ++repeated;
      } else {
        return two_heights(*first[place], line);
      }
    }
    if (3 * with_neighbours(first, x.count()) < text_.lines.size() - repeated) return no_grid(x, y);
    grid.names = names();
    grid.note = note_of(grid, text_.lines.size() - repeated, repeated);
    return grid;
  }

  // Each block is a curve, with as many points as the first one.
  base::Result<SurfaceNet> net() {
    SurfaceNet net;
    std::size_t length = 0;
    const HeightLine* begin = nullptr;
    const auto end_curve = [&](std::size_t end_line) -> std::optional<base::Error> {
      if (net.curves == 0) net.points = length;
      ++net.curves;
      if (length == net.points && length >= 2) return std::nullopt;
      return base::Error{source_, place_of(end_line, 1),
                         "block " + std::to_string(net.curves) + " of " + count_of(length, "point"),
                         length < 2 ? "two points or more in each block" : std::to_string(net.points) + " as in the first block",
                         "points of a surface are a grid of columns and rows, or blocks of equal length between blank lines; "
                         "others need --triangulate"};
    };
    for (const HeightLine& line : text_.lines) {
      if (begin != nullptr && line.after_blank) {
        if (auto error = end_curve(begin->number)) return *error;
        length = 0;
      }
      if (length == 0) begin = &line;
      ++length;
      net.vertices.push_back({value(line, 0), value(line, 1), height_of(line)});
    }
    if (auto error = end_curve(begin->number)) return *error;
    net.names = names();
    net.note = "read as a net of " + count_of(net.curves, "curve") + " of " + count_of(net.points, "point");
    if (const std::string left_out = columns_left_out(); guessed_ && !left_out.empty()) net.note += ", " + left_out;
    return net;
  }

  base::Result<HeightSurface> triangulated() {
    std::vector<ScatteredPoint> points;
    points.reserve(text_.lines.size());
    for (const HeightLine& line : text_.lines) {
      const double height = height_of(line);
      if (std::isfinite(height)) points.push_back({value(line, 0), value(line, 1), height});
    }
    std::vector<const HeightLine*> lines;
    for (const HeightLine& line : text_.lines) lines.push_back(&line);
    std::stable_sort(lines.begin(), lines.end(),
                     [this](const HeightLine* a, const HeightLine* b) { return place(*a) < place(*b); });
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const double before = height_of(*lines[i - 1]);
      const double height = height_of(*lines[i]);
      if (place(*lines[i - 1]) == place(*lines[i]) && before != height && std::isfinite(before) && std::isfinite(height))
        return two_heights(*lines[i - 1], *lines[i]);
    }
    auto grid = interpolated(points, *options_.triangulate, source_);
    if (!grid) return std::move(grid.error());
    grid->names = names();
    return HeightSurface(std::move(*grid));
  }

  [[nodiscard]] double value(const HeightLine& line, std::size_t axis) const { return line.fields[columns_[axis]].value; }
  [[nodiscard]] std::array<double, 2> place(const HeightLine& line) const { return {value(line, 0), value(line, 1)}; }
  [[nodiscard]] double height_of(const HeightLine& line) const {
    const double height = value(line, 2);
    return options_.nodata && is_nodata(height, *options_.nodata) ? nan : height;
  }
  [[nodiscard]] std::array<std::string, 3> names() const {
    std::array<std::string, 3> all;
    if (text_.has_heading() && !text_.heading.table)
      for (std::size_t axis = 0; axis < 3; ++axis) all[axis] = text_.heading.names[columns_[axis]];
    return all;
  }
  [[nodiscard]] std::string columns_left_out() const {
    const std::size_t count = text_.lines.front().fields.size();
    if (count == 4) return "column 4 left out";
    return count > 4 ? "columns 4 to " + std::to_string(count) + " left out" : "";
  }
  [[nodiscard]] std::vector<double> values(std::size_t axis) const {
    std::vector<double> all;
    all.reserve(text_.lines.size());
    for (const HeightLine& line : text_.lines) all.push_back(value(line, axis));
    return all;
  }
  [[nodiscard]] std::string name(std::size_t axis) const {
    if (text_.has_heading() && !text_.heading.table) return text_.heading.names[columns_[axis]];
    return axis == 0 ? "x" : "y";
  }
  [[nodiscard]] std::string place_text(const HeightLine& line) const {
    return name(0) + " = " + shortest_text(value(line, 0)) + ", " + name(1) + " = " + shortest_text(value(line, 1));
  }
  [[nodiscard]] base::Error error_at(const HeightLine& line, std::size_t field, std::string found, std::string expected,
                                     const std::string& what_to_do = "") const {
    return {source_, place_of(line.number, line.fields[field].column), std::move(found), std::move(expected), remedy(what_to_do)};
  }
  [[nodiscard]] std::string remedy(const std::string& other) const {
    if (!guessed_ || in_blocks()) return other;
    return other + (other.empty() ? "" : "; ") + "use --layout matrix if each line is a row of heights";
  }

  [[nodiscard]] std::optional<base::Error> why_no_points() const {
    const HeightLine& first = text_.has_heading() ? text_.heading.line : text_.lines.front();
    if (auto error = unequal_lines(first, text_.lines, source_)) return error;
    if (*std::max_element(columns_.begin(), columns_.end()) >= first.fields.size())
      return base::Error{source_, "", count_of(text_.lines.size(), "line") + " of " + count_of(first.fields.size(), "field"),
                         "three or more: x, y and height"};
    for (const auto& [column, error] : text_.words)
      if (std::find(columns_.begin(), columns_.end(), column) != columns_.end()) return error;
    for (const HeightLine& line : text_.lines)
      for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
        if (!std::isfinite(value(line, axis)))
          return error_at(line, columns_[axis], "no " + name(axis), "a number; only a height may be missing");
    return std::nullopt;
  }

  [[nodiscard]] std::optional<base::Error> why_no_axis(const Places& places, std::size_t axis) const {
    if (places.count() < smallest_grid.points) {
      return base::Error{source_, "", count_of(text_.lines.size(), "point") + " with the same " + name(axis),
                         "at least two different values of " + name(axis), remedy("")};
    }
    if (positions_of(places.all())) return std::nullopt;
    return base::Error{source_, "",
                       name(axis) + " from " + shortest_text(places.domain().low) + " to " + shortest_text(places.domain().high),
                       "places that are farther apart"};
  }

  [[nodiscard]] base::Error two_heights(const HeightLine& first, const HeightLine& line) const {
    return error_at(
        line, columns_[0], "a second point at " + place_text(line) + " with the height " + shortest_text(value(line, 2)),
        "one height for each place; the first is " + shortest_text(value(first, 2)) + " in line " + std::to_string(first.number),
        "leave out one of them");
  }

  // Do blank lines separate curves, as gnuplot writes them?
  [[nodiscard]] bool in_blocks() const {
    return std::any_of(text_.lines.begin(), text_.lines.end(), [](const HeightLine& line) { return line.after_blank; });
  }
  [[nodiscard]] base::Error no_grid(const Places& x, const Places& y) const {
    return {source_, "",
            count_of(text_.lines.size(), "scattered point") + " with " + std::to_string(x.count()) + " different values of " +
                name(0) + " and " + std::to_string(y.count()) + " of " + name(1) + ", no grid of columns and rows",
            "a point at most places of a grid", remedy("use --triangulate")};
  }

  static std::size_t with_neighbours(const std::vector<const HeightLine*>& at, std::size_t width) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const bool along_x = (i % width > 0 && at[i - 1] != nullptr) || (i % width + 1 < width && at[i + 1] != nullptr);
      const bool along_y = (i >= width && at[i - width] != nullptr) || (i + width < at.size() && at[i + width] != nullptr);
      count += at[i] != nullptr && along_x && along_y ? 1 : 0;
    }
    return count;
  }

  [[nodiscard]] std::string note_of(const HeightGrid& grid, std::size_t taken, std::size_t repeated) const {
    std::string note;
    if (guessed_) {
      note = "read as x y z in columns, a grid of " + std::to_string(grid.points()) + " x " + std::to_string(grid.slices());
      if (const std::string left_out = columns_left_out(); !left_out.empty()) note += ", " + left_out;
      if (taken < grid.heights.size()) note += ", " + count_of(grid.heights.size() - taken, "place") + " without a point";
    }
    if (repeated > 0) note += (note.empty() ? "" : ", ") + count_of(repeated, "repeated point") + " left out";
    return note;
  }

  const HeightText& text_;
  const PointColumns& columns_;
  bool guessed_;
  const GridFileOptions& options_;
  std::string source_;
};

}  // namespace

base::Result<PointColumns> columns_named(const HeightText& text, const std::vector<std::string>& names, std::string_view source) {
  const std::size_t count = text.has_heading() ? text.heading.line.fields.size() : text.lines.front().fields.size();
  PointColumns columns{};
  const std::string known = names_of(text);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string wanted = base::lower_case(names[axis]);
    const auto named = text.heading.table ? std::nullopt : column_called(text, {std::string_view(wanted)});
    const auto number = base::whole_number<std::size_t>(names[axis], 10, 1, count);
    if (!named && !number) {
      return base::Error{std::string(source), "", "no column " + names[axis],
                         (known.empty() ? "" : "one of " + known + ", or ") + "a number from 1 to " + std::to_string(count)};
    }
    columns[axis] = named ? *named : *number - 1;
  }
  return columns;
}

base::Result<std::optional<PointColumns>> columns_of_heading(const HeightText& text, std::string_view source) {
  std::optional<PointColumns> columns;
  if (!text.has_heading() || text.heading.table) return columns;
  auto x = column_called(text, {"x"});
  auto y = column_called(text, {"y"});
  auto height = column_called(text, {"h", "height", "heights", "value", "elevation", "elev", "altitude", "depth", "f"});
  const auto z = column_called(text, {"z"});
  if (x && !y && z && height) {
    columns = PointColumns{*x, *z, *height};
    return columns;
  }
  if (x && y && z) height = z;
  if (!x || !y) {
    x = column_called(text, {"lon", "long", "lng", "longitude", "easting"});
    y = column_called(text, {"lat", "latitude", "northing"});
    if (!height) height = z;
  }
  if (!x || !y) return columns;
  if (!height && text.heading.names.size() == 3) height = 3 - *x - *y;
  if (!height) {
    const HeightLine& heading = text.heading.line;
    return base::Error{
        std::string(source), place_of(heading.number, heading.fields.front().column), "the columns " + names_of(text),
        "one called z or height",
        "use --xyz " + text.heading.names[*x] + "," + text.heading.names[*y] + ",NAME to name the column of heights"};
  }
  columns = PointColumns{*x, *y, *height};
  return columns;
}

bool repeats_as_grid(const HeightText& text) {
  std::vector<double> x;
  std::vector<double> y;
  for (const HeightLine& line : text.lines) {
    if (line.fields.size() < 3 || !std::isfinite(line.fields[0].value) || !std::isfinite(line.fields[1].value)) return false;
    x.push_back(line.fields[0].value);
    y.push_back(line.fields[1].value);
  }
  const Places columns(std::move(x));
  const Places rows(std::move(y));
  const std::size_t lines = text.lines.size();
  const std::uint64_t all = std::uint64_t{columns.count()} * rows.count();
  if (columns.count() < 2 || rows.count() < 2 || lines < 4 || all > 2 * std::uint64_t{lines}) return false;
  std::vector<bool> taken(static_cast<std::size_t>(all));
  std::size_t places = 0;
  for (const HeightLine& line : text.lines) {
    const std::size_t place = rows.index(line.fields[1].value) * columns.count() + columns.index(line.fields[0].value);
    if (!taken[place]) ++places;
    taken[place] = true;
  }
  return 2 * places >= all && 10 * (lines - places) <= lines;
}

base::Result<HeightSurface> read_points(const HeightText& text, const PointColumns& columns, bool guessed,
                                        const GridFileOptions& options, std::string_view source) {
  return Points(text, columns, guessed, options, source).surface();
}

}  // namespace sightline::scene
