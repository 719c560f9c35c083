#include "host/base/text_table.hpp"

#include <cstdlib>

namespace sightline::base {

void TextTable::row(std::initializer_list<std::string_view> cells) {
  row(std::vector<std::string>(cells.begin(), cells.end()));
}

void TextTable::row(const std::vector<std::string>& cells) {
  std::string line;
  std::size_t column = 0;
  for (const std::string& cell : cells) {
    const int width = widths_[column++];
    const auto wanted = static_cast<std::size_t>(std::abs(width));
    const std::string padding(wanted > cell.size() ? wanted - cell.size() : 0, ' ');
    if (width > 0) line += padding;
    line += cell;
    if (width < 0) line += padding;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  (text_ += line) += '\n';
}

void TextTable::line(std::string_view text) {
  (text_ += text) += '\n';
}

}  // namespace sightline::base
