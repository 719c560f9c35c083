// The contents of host/compare/papers.json: each paper, its claims with their places in it, its printed tables.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/rows.hpp"

namespace sightline::report {

struct PaperClaim {
  std::string place;  // section, table, figure
  std::string says;
  bool has_figure = false;
  Range<double> figure = {};
  std::string unit;
};

struct Paper {
  std::string id;
  std::vector<std::string> authors;
  int year = 0;
  std::string title;
  std::string published_in;
  std::map<std::string, PaperClaim, std::less<>> claims;

  // C. B. Jones, "A new approach ...", The Computer Journal 14(3), 1971.
  [[nodiscard]] std::string citation() const;
};

struct PrintedTable {
  std::vector<std::string> keys;
  std::vector<std::vector<Cell>> rows;

  // Throw base::Error (bad_input) for an unknown key, and for a cell of another kind.
  [[nodiscard]] const Cell& cell(std::size_t row, std::string_view key) const;
  [[nodiscard]] double number(std::size_t row, std::string_view key) const;
  [[nodiscard]] const std::string& text(std::size_t row, std::string_view key) const;
};

class Papers {
 public:
  // Throws base::Error (bad_input) with the place if the text is not such a document.
  explicit Papers(std::string_view json);
  // The papers built into the program.
  [[nodiscard]] static const Papers& built_in();

  [[nodiscard]] const std::vector<Paper>& all() const { return papers_; }
  // These throw base::Error (bad_input) for an unknown name.
  [[nodiscard]] const Paper& paper(std::string_view id) const;
  [[nodiscard]] const PaperClaim& claim(std::string_view name) const;  // "jones.core"
  [[nodiscard]] const PrintedTable& table(std::string_view name) const;

 private:
  std::vector<Paper> papers_;
  std::map<std::string, PrintedTable, std::less<>> tables_;
};

}  // namespace sightline::report
