// A table in Markdown.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace sightline::manual {

class Table {
 public:
  Table(std::initializer_list<std::string> headings) {
    row(headings);
    for (std::size_t i = 0; i < headings.size(); ++i) text_ += "|---";
    text_ += "|\n";
  }
  void row(const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) {
      text_ += "| ";
      for (const char c : cell) text_ += c == '|' ? "\\|" : std::string(1, c);
      text_ += ' ';
    }
    text_ += "|\n";
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

[[nodiscard]] inline std::string code(std::string_view text) { return "`" + std::string(text) + "`"; }

}  // namespace sightline::manual
