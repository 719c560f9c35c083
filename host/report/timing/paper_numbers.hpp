// One number a paper gives, and what there is here to put beside it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/report/report.hpp"

namespace sightline::harness::report {

struct PaperNumber {
  std::string place;  // "abstract", "Fig. 8"
  std::string says;   // in its words
  Cell least;         // here: one number, or the least and the greatest
  Cell greatest;
  std::string unit;
  std::string condition;   // what is measured here, on what
  std::string comparison;  // what follows, or "cannot be compared: ..." and why
};

[[nodiscard]] inline Table paper_table(std::string id, std::string title, std::vector<PaperNumber> numbers) {
  Table table;
  table.id = std::move(id);
  table.title = std::move(title);
  table.columns = {{"place", "In the paper", "", false},
                   {"says", "It says", "", false},
                   {"here_least", "Here", "least", false},
                   {"here_greatest", "Here", "greatest", false},
                   {"unit", "Unit", "", false},
                   {"condition", "Condition here", "", false},
                   {"comparison", "Comparison", "", false}};
  for (PaperNumber& number : numbers) {
    table.rows.push_back({std::move(number.place), std::move(number.says), std::move(number.least),
                          std::move(number.greatest), std::move(number.unit), std::move(number.condition),
                          std::move(number.comparison)});
  }
  return table;
}

}  // namespace sightline::harness::report
