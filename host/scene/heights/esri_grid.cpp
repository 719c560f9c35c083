// ASCII grids of ESRI (.asc): keys and values in any order, then the rows from north to south.
//
// Source: Esri, ArcGIS documentation, "Esri ASCII raster format". A height belongs to the middle of its cell: half a cell from
// xllcorner, at xllcenter. GDAL's keys dx and dy instead of cellsize, and its nan for a hole, are read, too.
#include "host/scene/heights/grid_formats.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/scene/heights/grid_words.hpp"

namespace sightline::scene {
namespace {

constexpr std::array<std::string_view, 10> keys{"ncols",     "nrows",    "xllcorner", "xllcenter", "yllcorner",
                                                "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};
enum Key : std::size_t { ncols, nrows, xllcorner, xllcenter, yllcorner, yllcenter, cellsize, dx, dy, nodata };
using Header = std::array<std::optional<double>, keys.size()>;

Header read_header(GridWords& words) {
  Header values{};
  while (!words.error() && !words.peek().empty() && !words.at_nan() && !base::decimal_number(words.peek())) {
    const GridWord word = words.next();
    const std::string key = base::lower_case(word.text);
    const auto known = std::find(keys.begin(), keys.end(), key);
    if (known == keys.end()) {
      words.fail(word, "a key of an ESRI ASCII grid, such as ncols, or a height");
      break;
    }
    const auto index = static_cast<std::size_t>(known - keys.begin());
    if (values[index]) words.fail(word, "each key once");
    if (index == nodata && words.take_nan()) {
      values[index] = std::numeric_limits<double>::quiet_NaN();
    } else if (index <= nrows) {
      values[index] = static_cast<double>(words.count("a number", smallest_grid.points, largest_file_grid.points));
    } else {
      const bool distance = index == cellsize || index == dx || index == dy;
      const GridWord value = words.next();
      const auto number = base::decimal_number(value.text);
      if (!number || (distance && !(*number > 0))) words.fail(value, "the value of " + key + (distance ? ", above 0" : ""));
      values[index] = number;
    }
  }
  return values;
}

// Where the first and the last of `count` cells have their middles.
Interval middles(std::optional<double> corner, std::optional<double> center, double step, double count) {
  const double low = center ? *center : *corner + step / 2;
  return {low, low + (count - 1) * step};
}

}  // namespace

bool is_esri_grid(std::string_view bytes, std::string_view /*source*/) {
  const std::string_view beginning = base::without_blanks(bytes.substr(0, 1000));
  std::string_view line = beginning.substr(0, beginning.find_first_of("\r\n"));
  const std::string first = base::lower_case(base::take_word(line));
  const bool two_words = !line.empty() && line.find_first_of(" \t") == std::string_view::npos;
  if (first == keys[ncols] || first == keys[nrows]) return two_words;
  // Two names of columns are a heading of numbers: dx dy.
  return two_words && std::find(keys.begin(), keys.end(), first) != keys.end() && base::decimal_number(line);
}

base::Result<HeightGrid> read_esri_grid(std::string_view bytes, std::string_view source) {
  GridWords words(bytes, source);
  const Header header = read_header(words);
  if (words.error()) return *words.error();
  const auto missing = [source](const std::string& what) {
    return base::Error{std::string(source), "", "an ESRI ASCII grid without " + what,
                       "its header before the heights: ncols, nrows, xllcorner, yllcorner, cellsize"};
  };
  if (!header[ncols] || !header[nrows]) return missing(header[ncols] ? "nrows" : "ncols");
  if (!header[xllcorner] && !header[xllcenter]) return missing("xllcorner");
  if (!header[yllcorner] && !header[yllcenter]) return missing("yllcorner");
  const auto step_x = header[dx] ? header[dx] : header[cellsize];
  const auto step_y = header[dy] ? header[dy] : header[cellsize];
  if (!step_x || !step_y) return missing("cellsize");
  const Interval x = middles(header[xllcorner], header[xllcenter], *step_x, *header[ncols]);
  const Interval y = middles(header[yllcorner], header[yllcenter], *step_y, *header[nrows]);
  const auto points = static_cast<std::size_t>(*header[ncols]);
  const auto slices = static_cast<std::size_t>(*header[nrows]);
  constexpr double usual_nodata = -9999;
  const double none = header[nodata].value_or(usual_nodata);
  auto heights = words.heights(points * slices, [none](double height) { return is_nodata(height, none); });
  if (words.error()) return *words.error();
  return even_grid({x, y}, {points, slices}, std::move(heights), RowOrder::north_first, source);
}

}  // namespace sightline::scene
