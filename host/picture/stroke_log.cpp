// See stroke_log.hpp.
#include "host/picture/stroke_log.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"
#include "host/picture/stroke_recorders.hpp"

namespace sightline::picture {

namespace {

struct Field {
  const char* expected;
  int base;
  std::int64_t greatest;
};

constexpr std::size_t address_digits = 5;
constexpr std::size_t longest_quotation = 40;

constexpr Field time_field{"nanoseconds", 10, std::numeric_limits<std::int64_t>::max()};
constexpr Field x_field{"x from 0 to 1023", 10, screen_points - 1};
constexpr Field y_field{"y from 0 to 1023", 10, screen_points - 1};
constexpr Field intensity_field{"intensity from 0 to 7", 10, intensity_levels - 1};
constexpr Field address_field{"an address of five octal digits", 8, 077777};

// An unknown file may contain anything: quote it short and printable.
std::string quoted(std::string_view text) {
  std::string shown = "'";
  for (const char c : text.substr(0, longest_quotation)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > longest_quotation ? "...'" : "'");
}

std::optional<std::int64_t> number(std::string_view digits, const Field& field) {
  if (digits.starts_with('-')) return std::nullopt;  // of "-0"
  return base::whole_number<std::int64_t>(digits, field.base, 0, field.greatest);
}

// Reads the fields of one line from left to right and keeps the first fault.
class LineReader {
 public:
  explicit LineReader(std::string_view line) : rest_(line) {}

  std::int64_t next(const Field& field) {
    if (fault_) return 0;
    const std::size_t space = std::min(rest_.find(' '), rest_.size());
    const std::string_view digits = rest_.substr(0, space);
    const auto value = number(digits, field);
    const bool wrong_width = field.base == 8 && digits.size() != address_digits;
    if (!value || wrong_width) {
      fail(quoted(digits), field.expected);
      return 0;
    }
    at_end_ = space == rest_.size();
    rest_.remove_prefix(at_end_ ? space : space + 1);
    return *value;
  }
  void end() {
    if (!fault_ && !at_end_) fail(quoted(rest_) + " after the address", "the end of the line");
  }
  [[nodiscard]] const std::optional<base::Error>& fault() const { return fault_; }

 private:
  void fail(std::string found, std::string expected) {
    fault_ = base::Error{"", "", std::move(found), std::move(expected)};
  }

  std::string_view rest_;
  bool at_end_ = false;
  std::optional<base::Error> fault_;
};

}  // namespace

void append_stroke_line(std::string& text, const core::Stroke& stroke) {
  base::append(text, "{} {} {} {} {:05o}\n", core::nanoseconds_of(stroke.time), stroke.x, stroke.y,
               stroke.intensity, stroke.address);
}

base::Result<std::vector<core::Stroke>> parse_stroke_log(std::string_view text, const std::string& name) {
  std::vector<core::Stroke> strokes;
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::string place = fmt::format("line {}", line_number);
    const std::size_t end = text.find('\n');
    // The last number of a cut-off file may be cut off too, and would be silently wrong.
    if (end == std::string_view::npos) return base::Error{name, place, "no end of line", "a complete file"};
    LineReader line(text.substr(0, end));
    core::Stroke stroke;
    stroke.time = core::at_nanoseconds(line.next(time_field));
    stroke.x = static_cast<std::uint16_t>(line.next(x_field));
    stroke.y = static_cast<std::uint16_t>(line.next(y_field));
    stroke.intensity = static_cast<std::uint8_t>(line.next(intensity_field));
    stroke.address = static_cast<std::uint16_t>(line.next(address_field));
    line.end();
    if (line.fault()) return base::Error{name, place, line.fault()->found, line.fault()->expected};
    strokes.push_back(stroke);
    text.remove_prefix(end + 1);
  }
  return strokes;
}

}  // namespace sightline::picture
