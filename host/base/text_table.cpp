#include "host/base/text_table.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace sightline::base {
namespace {

constexpr std::string_view gap = "  ";

std::string pad(std::string_view cell, std::size_t wanted, bool left) {
  const std::string padding(wanted > cell.size() ? wanted - cell.size() : 0, ' ');
  return left ? std::string(cell) + padding : padding + std::string(cell);
}

void end_line(std::string& text, std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  (text += line) += '\n';
}

std::string_view without_indent(std::string_view cell) {
  cell.remove_prefix(std::min(cell.find_first_not_of(' '), cell.size()));
  return cell;
}

}  // namespace

void TextTable::row(std::initializer_list<std::string_view> cells) {
  row(std::vector<std::string>(cells.begin(), cells.end()));
}

void TextTable::row(const std::vector<std::string>& cells) {
  lines_.push_back({cells, ""});
}

void TextTable::line(std::string_view text) {
  lines_.push_back({{}, std::string(text)});
}

std::string TextTable::text() const {
  std::string text;
  for (const Line& each : lines_) {
    std::string line = each.text;
    for (std::size_t column = 0; column < each.cells.size(); ++column)
      line += pad(each.cells[column], static_cast<std::size_t>(std::abs(widths_[column])), widths_[column] < 0);
    end_line(text, line);
  }
  return text;
}

std::string TextTable::text_within(std::size_t width, const std::vector<std::size_t>& least) const {
  const std::string whole = text();
  std::size_t longest = 0;
  std::vector<std::size_t> widths(widths_.size());
  std::string_view rest = whole;
  for (const Line& each : lines_) {
    const std::size_t end = rest.find('\n');
    if (!each.cells.empty()) longest = std::max(longest, end);
    rest.remove_prefix(end + 1);
    for (std::size_t column = 0; column < each.cells.size(); ++column)
      widths[column] = std::max(widths[column], without_indent(each.cells[column]).size());
  }
  if (longest <= width) return whole;
  const auto needed = [&widths] {
    std::size_t sum = 0;
    for (const std::size_t each : widths) sum += each == 0 ? 0 : each + gap.size();
    return sum - std::min(sum, gap.size());
  };
  std::string left_out;
  for (const std::size_t column : least) {
    if (needed() <= width) break;
    if (std::exchange(widths[column], 0) == 0) continue;
    left_out += left_out.empty() ? "" : ", ";
    left_out += without_indent(lines_.front().cells[column]);
  }
  std::string text;
  for (const Line& each : lines_) {
    std::string line = each.text;
    for (std::size_t column = 0; column < each.cells.size(); ++column) {
      if (widths[column] == 0) continue;
      if (!line.empty()) line += gap;
      line += pad(without_indent(each.cells[column]), widths[column], widths_[column] <= 0);
    }
    end_line(text, line);
  }
  if (!left_out.empty()) end_line(text, "left out, for a wider terminal: " + left_out);
  return text;
}

}  // namespace sightline::base
