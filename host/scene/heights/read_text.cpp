#include "host/scene/heights/read_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"

namespace sightline::scene {
namespace {

// A line of a table begins with its place.
constexpr std::size_t most_fields = largest_file_grid.points + 1;
// The largest grid as points of eight columns: x y z and five more.
constexpr std::size_t most_numbers = 8 * largest_grid.points * largest_grid.slices;
constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// As spreadsheets and statistics programs write a missing value.
bool is_missing(std::string_view field) {
  constexpr std::array<std::string_view, 5> words{"nan", "-nan", "na", "n/a", "null"};
  return field.empty() || std::any_of(words.begin(), words.end(), [lower = base::lower_case(field)](std::string_view word) { return lower == word; });
}

// A field as messages show it: short, without control characters.
std::string shown(std::string_view field) {
  constexpr std::size_t most = 24;
  std::string text = "'";
  for (const char c : field.substr(0, most)) text += c == '\t' ? ' ' : c >= ' ' && c <= '~' ? c : '?';
  return text + (field.size() > most ? "...'" : "'");
}

// Text without line end and comment.
struct RawLine {
  std::string_view text;
  std::size_t number = 1;
  bool after_blank = false;
};

// The position where a comment begins: at #, or at % if that is the first character. npos: there is none.
std::size_t comment_of(std::string_view line) {
  const std::size_t first = line.find_first_not_of(blanks);
  return first != std::string_view::npos && line[first] == '%' ? first : line.find('#');
}

// The lines that are not empty.
std::vector<RawLine> raw_lines(std::string_view text) {
  std::vector<RawLine> lines;
  bool blank = false;
  const char line_end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find(line_end), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::size_t comment = comment_of(line);
    line = line.substr(0, comment);
    if (trimmed(line).empty()) {
      blank = blank || comment == std::string_view::npos;
      continue;
    }
    lines.push_back({line, number, blank && !lines.empty()});
    blank = false;
  }
  return lines;
}

// Whether tabs separate fields: every line has the same number of tabs, and no blank stands between two fields. If every line begins
// with a blank or a tab, that is indentation.
bool tabs_separate(const std::vector<RawLine>& lines) {
  const auto tabs = [](std::string_view text) { return std::count(text.begin(), text.end(), '\t'); };
  const auto first = tabs(lines.front().text);
  bool indented = true;
  for (const RawLine& line : lines) {
    if (tabs(line.text) != first) return false;
    indented = indented && (line.text.front() == '\t' || line.text.front() == ' ');
    std::string_view rest = line.text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\t'), rest.size());
      if (trimmed(rest.substr(0, end)).find(' ') != std::string_view::npos) return false;
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return first > 0 && !indented;
}

// The separator of the whole file: ';' if some line has it, else ',', else a tab, else a blank.
char separator_of(const std::vector<RawLine>& lines) {
  for (const char separator : {';', ','})
    if (std::any_of(lines.begin(), lines.end(), [separator](const RawLine& line) { return line.text.find(separator) != std::string_view::npos; }))
      return separator;
  return tabs_separate(lines) ? '\t' : ' ';
}

struct RawField {
  std::string_view text;
  std::size_t column = 1;
};

class LineReader {
 public:
  LineReader(const std::vector<RawLine>& lines, std::string_view source) : source_(source), separator_(separator_of(lines)) {
    const auto ends = [this](const RawLine& line) { return ends_with_separator(line.text); };
    separator_ends_line_ = separated() && std::all_of(lines.begin(), lines.end(), ends);
  }

  [[nodiscard]] const base::Error& error() const { return *error_; }

  // A line of numbers and words. The first word of each column is added to `words`. False: error() says what is wrong.
  bool read(const RawLine& line, HeightLine& result, std::vector<std::pair<std::size_t, base::Error>>& words) {
    if (!split(line)) return false;
    result = {{}, line.number, line.text.size() + 1, line.after_blank};
    for (const RawField& field : fields_) {
      const auto value = number(field.text);
      if (!value) {
        const std::size_t index = result.fields.size();
        if (index >= has_word_.size()) has_word_.resize(index + 1);
        if (!has_word_[index]) words.emplace_back(index, base::Error{source_, place_of(line.number, field.column), shown(field.text), expected_for(field.text)});
        has_word_[index] = true;
      }
      result.fields.push_back({value.value_or(std::numeric_limits<double>::quiet_NaN()), field.column});
    }
    return true;
  }

  // The first line as a heading: names only, or a corner that is no number before numbers. False: it is none.
  bool read_heading(const RawLine& line, HeightHeading& heading) {
    if (!split(line) || fields_.empty()) return false;
    std::size_t names = 0;
    std::size_t numbers = 0;
    for (const RawField& field : fields_) {
      const bool word = !number(field.text);
      if (word && !printable(field.text)) return false;
      names += word ? 1 : 0;
      numbers += !word && !is_missing(field.text) ? 1 : 0;
    }
    const std::string_view corner = fields_.front().text;
    heading.table = fields_.size() >= 3 && numbers + 1 == fields_.size() && (names == 1 ? !number(corner) : corner.empty());
    if (!heading.table && (names == 0 || numbers > 0)) return false;
    heading.line = {{}, line.number, line.text.size() + 1, false};
    for (const RawField& field : fields_) {
      heading.line.fields.push_back({number(field.text).value_or(std::numeric_limits<double>::quiet_NaN()), field.column});
      if (heading.names.empty() || !heading.table) heading.names.emplace_back(field.text);
    }
    return true;
  }

 private:
  // With commas as separators, two numbers in one field show that the commas were decimal: 1,5 2,5 is split into 1 and 5 2 and 5.
  [[nodiscard]] std::string expected_for(std::string_view field) const {
    if (separator_ == ',' && field.find_first_of(blanks) != std::string_view::npos && numbers_only(field))
      return "one number between two commas; where fractions have a comma, semicolons must separate the numbers";
    return separator_ != ';' && field.find(',') != std::string_view::npos ? "a finite number with a decimal point" : "a finite number or nan";
  }
  static bool numbers_only(std::string_view field) {
    return field.find_first_not_of("0123456789+-.eE \t") == std::string_view::npos;
  }

  [[nodiscard]] bool separated() const { return separator_ != ' '; }
  [[nodiscard]] bool ends_with_separator(std::string_view text) const {
    const std::size_t last = separator_ == '\t' ? text.find_last_not_of(' ') : text.find_last_not_of(blanks);
    return last != std::string_view::npos && text[last] == separator_;
  }

  bool split(const RawLine& line) {
    fields_.clear();
    const std::string_view text = line.text;
    std::size_t begin = 0;
    while (begin <= text.size()) {
      if (!separated()) {
        begin = text.find_first_not_of(blanks, begin);
        if (begin == std::string_view::npos) break;
      }
      const std::size_t from = begin + skipped(text.substr(begin));
      std::size_t end = from;
      const bool quoted = from < text.size() && text[from] == '"';
      if (quoted) {
        end = text.find('"', from + 1);
        if (end == std::string_view::npos) return fail(line.number, from + 1, "a quotation mark without its second", "one on the same line");
      }
      end = std::min(separated() ? text.find(separator_, end) : text.find_first_of(blanks, end), text.size());
      std::string_view field = trimmed(text.substr(begin, end - begin));
      std::size_t column = field.empty() ? begin + 1 : static_cast<std::size_t>(field.data() - text.data()) + 1;
      if (quoted && field.size() >= 2 && field.back() == '"') {
        field = trimmed(field.substr(1, field.size() - 2));
        ++column;
      }
      if (separator_ends_line_ && end == text.size() && field.empty()) break;
      if (fields_.size() == most_fields) return fail(line.number, column, "more than " + std::to_string(most_fields) + " fields", "at most that");
      fields_.push_back({field, column});
      begin = end + 1;
    }
    return true;
  }

  static std::size_t skipped(std::string_view text) { return std::min(text.find_first_not_of(blanks), text.size()); }

  // NaN if the field is missing.
  std::optional<double> number(std::string_view field) {
    if (is_missing(field)) return std::numeric_limits<double>::quiet_NaN();
    const auto value = base::decimal_number(field);
    if (value || separator_ != ';') return value;
    // If semicolons separate the fields, a comma is a decimal comma.
    if (std::count(field.begin(), field.end(), ',') != 1 || field.find('.') != std::string_view::npos) return std::nullopt;
    decimal_ = field;
    std::replace(decimal_.begin(), decimal_.end(), ',', '.');
    return base::decimal_number(decimal_);
  }

  static bool printable(std::string_view text) {
    return std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
  }

  bool fail(std::size_t line, std::size_t column, std::string found, std::string expected) {
    error_ = base::Error{source_, place_of(line, column), std::move(found), std::move(expected)};
    return false;
  }

  std::string source_;
  char separator_;
  bool separator_ends_line_ = false;  // of every line
  std::vector<RawField> fields_;
  std::vector<bool> has_word_;  // by column
  std::string decimal_;
  std::optional<base::Error> error_;
};

}  // namespace

std::string place_of(std::size_t line, std::size_t column) {
  return std::to_string(line) + ":" + std::to_string(column);
}

std::string count_of(std::size_t n, std::string_view what) {
  return std::to_string(n) + " " + std::string(what) + (n == 1 ? "" : "s");
}

std::optional<base::Error> unequal_lines(const HeightLine& first, std::span<const HeightLine> lines, std::string_view source) {
  const std::size_t expected = first.fields.size();
  for (const HeightLine& line : lines) {
    const std::size_t count = line.fields.size();
    if (count == expected) continue;
    const std::size_t column = count > expected ? line.fields[expected].column : line.end;
    return base::Error{std::string(source), place_of(line.number, column), count_of(count, "field"),
                       std::to_string(expected) + " as in line " + std::to_string(first.number)};
  }
  return std::nullopt;
}

base::Result<HeightText> read_height_text(std::string_view text, std::string_view source) {
  const std::vector<RawLine> lines = raw_lines(text);
  const base::Error nothing{std::string(source), "", "no line of numbers", "at least two"};
  if (lines.empty()) return nothing;
  LineReader reader(lines, source);
  HeightText result;
  std::size_t numbers = 0;
  for (const RawLine& line : lines) {
    if (&line == &lines.front() && reader.read_heading(line, result.heading)) continue;
    HeightLine fields;
    if (!reader.read(line, fields, result.words)) return reader.error();
    numbers += fields.fields.size();
    if (numbers > most_numbers + std::min(lines.size(), largest_file_grid.slices + 1)) {
      return base::Error{std::string(source), place_of(line.number, 1), "more than " + std::to_string(most_numbers) + " numbers", "at most that",
                         "thin the file, or save it in a grid format, such as an ESRI ASCII grid, and use --thin"};
    }
    result.lines.push_back(std::move(fields));
  }
  if (result.lines.empty()) return nothing;
  // Blank lines between a heading and the first line do not separate blocks.
  result.lines.front().after_blank = false;
  return result;
}

}  // namespace sightline::scene
