#include "host/scene/heights/read_text.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>

#include "host/base/number.hpp"
#include "host/base/result.hpp"

namespace sightline::scene {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
// Of the largest grid as points, x y z each.
constexpr std::size_t most_numbers = 3 * largest_grid.points * largest_grid.slices;
constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_nan(std::string_view field) {
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  constexpr std::string_view word = "nan";
  return std::equal(field.begin(), field.end(), word.begin(), word.end(), same);
}

// What a message can show of a field: short, and no control characters.
std::string shown(std::string_view field) {
  constexpr std::size_t most = 24;
  std::string text = "'";
  for (const char c : field.substr(0, most)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (field.size() > most ? "...'" : "'");
}

// The separator of the whole file: ';' if it occurs outside comments, else ',', else a blank.
char separator_of(std::string_view text) {
  char separator = ' ';
  bool comment = false;
  for (const char c : text) {
    comment = c == '\n' ? false : comment || c == '#';
    if (comment) continue;
    if (c == ';') return ';';
    if (c == ',') separator = ',';
  }
  return separator;
}

class LineReader {
 public:
  LineReader(std::string_view text, std::string_view source)
      : source_(source), separator_(separator_of(text)) {}

  // Of a line without comment and line end. False: error() says what is wrong.
  bool read(std::string_view line, HeightLine& result) {
    result.end = line.size() + 1;
    std::size_t begin = 0;
    while (begin <= line.size()) {
      if (separator_ == ' ') {
        begin = line.find_first_not_of(blanks, begin);
        if (begin == std::string_view::npos) break;
      }
      const std::size_t found =
          separator_ == ' ' ? line.find_first_of(blanks, begin) : line.find(separator_, begin);
      const std::size_t end = std::min(found, line.size());
      if (!field(line, begin, end, result)) return false;
      begin = end + 1;
    }
    return true;
  }

  [[nodiscard]] bool separated() const { return separator_ != ' '; }
  [[nodiscard]] const base::Error& error() const { return *error_; }

 private:
  bool field(std::string_view line, std::size_t begin, std::size_t end, HeightLine& result) {
    const std::string_view text = trimmed(line.substr(begin, end - begin));
    const std::size_t column =
        text.empty() ? begin + 1 : static_cast<std::size_t>(text.data() - line.data()) + 1;
    if (result.fields.size() == largest_grid.points)
      return fail(result.number, column, "more than 1024 fields", "at most 1024");
    if (text.empty())
      return fail(result.number, column, "an empty field", "a number, or nan where there is none");
    if (is_nan(text)) {
      result.fields.push_back({std::numeric_limits<double>::quiet_NaN(), column});
      return true;
    }
    const auto value = base::decimal_number(text);
    if (!value) {
      const bool comma = text.find(',') != std::string_view::npos;
      return fail(result.number, column, shown(text),
                  comma ? "a finite number with a decimal point" : "a finite number or nan");
    }
    result.fields.push_back({*value, column});
    return true;
  }

  bool fail(std::size_t line, std::size_t column, std::string found, std::string expected) {
    error_ = base::Error{source_, place_of(line, column), std::move(found), std::move(expected)};
    return false;
  }

  std::string source_;
  char separator_;
  std::optional<base::Error> error_;
};

}  // namespace

std::string place_of(std::size_t line, std::size_t column) {
  return std::to_string(line) + ":" + std::to_string(column);
}

base::Result<HeightText> read_height_text(std::string_view text, std::string_view source) {
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) text.remove_prefix(byte_order_mark.size());
  LineReader reader(text, source);
  HeightText result;
  result.separated = reader.separated();
  bool blank = false;
  std::size_t numbers = 0;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::size_t comment = line.find('#');
    line = line.substr(0, comment);
    if (trimmed(line).empty()) {
      blank = blank || comment == std::string_view::npos;
      continue;
    }
    HeightLine fields{{}, number, 1, blank && !result.lines.empty()};
    blank = false;
    if (!reader.read(line, fields)) return reader.error();
    numbers += fields.fields.size();
    if (numbers > most_numbers) {
      return base::Error{std::string(source), place_of(number, 1), "more numbers than the largest grid has",
                         "at most 1024 slices of 1024 points"};
    }
    result.lines.push_back(std::move(fields));
  }
  if (result.lines.empty()) return base::Error{std::string(source), "", "no line of numbers", "at least two"};
  return result;
}

}  // namespace sightline::scene
