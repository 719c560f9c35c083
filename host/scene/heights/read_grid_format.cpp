#include "host/scene/heights/read_grid_format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/scene/heights/read_text.hpp"

namespace sightline::scene {
namespace {

constexpr double no_height = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view between_words = " \t\r\n";

struct Word {
  std::string_view text;  // empty: the file ends
  std::size_t line = 1;
  std::size_t column = 1;
};

// A file as words between blanks, whatever its lines are. The first error stays; what is read after it is 0.
class Words {
 public:
  Words(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  [[nodiscard]] const std::optional<base::Error>& error() const { return error_; }

  Word next() {
    for (; at_ < text_.size() && between_words.find(text_[at_]) != std::string_view::npos; ++at_) {
      if (text_[at_] != '\n') continue;
      ++line_;
      line_begin_ = at_ + 1;
    }
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(between_words, begin), text_.size());
    return {text_.substr(begin, at_ - begin), line_, begin - line_begin_ + 1};
  }
  [[nodiscard]] std::string_view peek() const {
    std::string_view rest = text_.substr(at_);
    return base::take_word(rest);
  }

  double number(const std::string& what) {
    if (error_) return 0;
    const Word word = next();
    const auto value = base::decimal_number(word.text);
    if (!value) fail(word, what);
    return value.value_or(0);
  }
  std::size_t count(const std::string& what, std::size_t least, std::size_t most) {
    if (error_) return 0;
    const Word word = next();
    const auto value = base::whole_number<std::size_t>(word.text, 10, least, most);
    if (!value) fail(word, what + " from " + std::to_string(least) + " to " + std::to_string(most));
    return value.value_or(0);
  }
  // Is the next word nan, with a sign or without one?
  [[nodiscard]] bool at_nan() const {
    const std::string word = base::lower_case(peek());
    return word == "nan" || word == "-nan" || word == "+nan";
  }
  bool take_nan() {
    if (!at_nan()) return false;
    static_cast<void>(next());
    return true;
  }
  // A height; `hole` says which numbers stand for none.
  template <class Hole>
  double height(const Hole& hole) {
    if (take_nan()) return no_height;
    const double value = number("a height");
    return hole(value) ? no_height : value;
  }
  void expect_end(std::size_t heights) {
    const Word word = next();
    if (!word.text.empty()) fail(word, "the end of the file after " + std::to_string(heights) + " heights");
  }
  void fail(const Word& word, const std::string& expected) {
    if (error_) return;
    constexpr std::size_t most = 24;
    std::string found = word.text.empty() ? "the end of the file" : "'";
    for (const char c : word.text.substr(0, most)) found += c >= ' ' && c <= '~' ? c : '?';
    if (!word.text.empty()) found += word.text.size() > most ? "...'" : "'";
    error_ = base::Error{source_, place_of(word.line, word.column), std::move(found), expected};
  }

 private:
  std::string_view text_;
  std::string source_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_begin_ = 0;
  std::optional<base::Error> error_;
};

// `rising`: the file's first row has the least y. The heights are those of the file in its order.
base::Result<HeightGrid> even_grid(const Words& words, std::string_view source, Interval x, Interval y, std::size_t points, std::size_t slices,
                                   std::vector<double> heights, bool rising) {
  if (words.error()) return *words.error();
  for (const Interval& domain : {x, y}) {
    const double half = domain.high / 2 - domain.low / 2;
    if (std::isfinite(half) && half >= std::numeric_limits<double>::min()) continue;
    return base::Error{std::string(source), "", "places from " + shortest_text(domain.low) + " to " + shortest_text(domain.high),
                       "places that rise, of finite numbers"};
  }
  if (!rising) {
    std::vector<double> reversed;
    reversed.reserve(heights.size());
    for (std::size_t row = slices; row-- > 0;)
      for (std::size_t point = 0; point < points; ++point) reversed.push_back(heights[row * points + point]);
    heights = std::move(reversed);
  }
  return HeightGrid{even_positions(points), even_positions(slices), std::move(heights), x, y, {}, {}, {}};
}

template <class Hole>
std::vector<double> heights_of(Words& words, std::size_t count, const Hole& hole) {
  std::vector<double> heights;
  while (heights.size() < count && !words.error()) heights.push_back(words.height(hole));
  words.expect_end(count);
  return heights;
}

// Keys and values in any order; then the rows, the northernmost first. Places are the middles of cells.
base::Result<HeightGrid> read_esri(std::string_view text, std::string_view source) {
  constexpr std::array<std::string_view, 10> keys{"ncols",     "nrows",    "xllcorner", "xllcenter", "yllcorner",
                                                  "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};
  enum Key : std::size_t { ncols, nrows, xllcorner, xllcenter, yllcorner, yllcenter, cellsize, dx, dy, nodata };
  std::array<std::optional<double>, keys.size()> values{};
  Words words(text, source);
  while (!words.error() && !words.peek().empty() && !words.at_nan() && !base::decimal_number(words.peek())) {
    const Word word = words.next();
    const std::string key = base::lower_case(word.text);
    const auto known = std::find(keys.begin(), keys.end(), key);
    if (known == keys.end()) {
      words.fail(word, "a key of an ESRI ASCII grid, such as ncols, or a height");
      break;
    }
    const auto index = static_cast<std::size_t>(known - keys.begin());
    if (values[index]) words.fail(word, "each key once");
    if (index == nodata && words.take_nan()) {
      values[index] = no_height;
      continue;
    }
    values[index] = index <= nrows ? static_cast<double>(words.count("a number", smallest_grid.points, largest_grid.points))
                                   : words.number("the value of " + key);
  }
  if (words.error()) return *words.error();
  const auto missing = [source](const std::string& what) {
    return base::Error{std::string(source), "", "an ESRI ASCII grid without " + what,
                       "its header before the heights: ncols, nrows, xllcorner, yllcorner, cellsize"};
  };
  if (!values[ncols] || !values[nrows]) return missing(values[ncols] ? "nrows" : "ncols");
  if (!values[xllcorner] && !values[xllcenter]) return missing("xllcorner");
  if (!values[yllcorner] && !values[yllcenter]) return missing("yllcorner");
  const auto step_x = values[dx] ? values[dx] : values[cellsize];
  const auto step_y = values[dy] ? values[dy] : values[cellsize];
  if (!step_x || !step_y) return missing("cellsize");
  const auto places = [](std::optional<double> corner, std::optional<double> center, double step, double count) {
    const double low = center ? *center : *corner + step / 2;
    return Interval{low, low + (count - 1) * step};
  };
  const auto points = static_cast<std::size_t>(*values[ncols]);
  const auto slices = static_cast<std::size_t>(*values[nrows]);
  constexpr double usual_nodata = -9999;
  const double none = values[nodata].value_or(usual_nodata);
  auto heights = heights_of(words, points * slices, [none](double height) { return height == none; });
  return even_grid(words, source, places(values[xllcorner], values[xllcenter], *step_x, *values[ncols]),
                   places(values[yllcorner], values[yllcenter], *step_y, *values[nrows]), points, slices, std::move(heights), false);
}

// DSAA, columns and rows, least and greatest x, y and height; then the rows, the southernmost first.
base::Result<HeightGrid> read_surfer(std::string_view text, std::string_view source) {
  constexpr double blanked = 1.70141e38;
  Words words(text, source);
  static_cast<void>(words.next());
  const std::size_t points = words.count("a number of columns", smallest_grid.points, largest_grid.points);
  const std::size_t slices = words.count("a number of rows", smallest_grid.slices, largest_grid.slices);
  const auto interval = [&words](const std::string& of) {
    const double low = words.number("the least " + of);
    return Interval{low, words.number("the greatest " + of)};
  };
  const Interval x = interval("x");
  const Interval y = interval("y");
  static_cast<void>(interval("height"));
  auto heights = heights_of(words, points * slices, [](double height) { return height >= blanked; });
  return even_grid(words, source, x, y, points, slices, std::move(heights), true);
}

}  // namespace

GridFormatReader grid_format_of(std::string_view text) {
  const std::string first = base::lower_case(base::take_word(text));
  const bool number_follows = base::decimal_number(base::take_word(text)).has_value();
  if (first == "dsaa") return read_surfer;
  if (number_follows && (first == "ncols" || first == "nrows")) return read_esri;
  return nullptr;
}

std::string_view foreign_format_of(std::string_view text) {
  using namespace std::string_view_literals;
  struct Format {
    std::string_view beginning;
    std::string_view name;
  };
  constexpr std::array<Format, 16> formats{{{"DSBB"sv, "a binary Surfer grid"sv},
                                            {"DSRB"sv, "a binary Surfer grid"sv},
                                            {"CDF\x01"sv, "a NetCDF file"sv},
                                            {"CDF\x02"sv, "a NetCDF file"sv},
                                            {"\x89HDF"sv, "an HDF5 or NetCDF file"sv},
                                            {"II*\0"sv, "a TIFF image"sv},
                                            {"MM\0*"sv, "a TIFF image"sv},
                                            {"\x89PNG"sv, "a PNG image"sv},
                                            {"\xFF\xD8\xFF"sv, "a JPEG image"sv},
                                            {"GIF8"sv, "a GIF image"sv},
                                            {"%PDF"sv, "a PDF document"sv},
                                            {"\x1F\x8B"sv, "a file compressed by gzip"sv},
                                            {"PK\x03\x04"sv, "a zip archive, such as a spreadsheet"sv},
                                            {"\xFF\xFE"sv, "text in UTF-16"sv},
                                            {"\xFE\xFF"sv, "text in UTF-16"sv},
                                            {"north:"sv, "a GRASS ASCII grid"sv}}};
  for (const Format& format : formats)
    if (text.substr(0, format.beginning.size()) == format.beginning) return format.name;
  return {};
}

std::string_view unread_format_of(std::string_view text) {
  if (const std::string_view format = foreign_format_of(text); !format.empty()) return format;
  const std::string_view first = base::without_blanks(text).substr(0, 1);
  if (first == "{" || first == "[") return "a list in brackets, such as JSON";
  if (text.find('\0') != std::string_view::npos) return "binary data";
  return {};
}

}  // namespace sightline::scene
