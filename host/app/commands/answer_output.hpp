// Prints the table of the speed and the error of each method (host/compare/answer.hpp) as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/answer.hpp"

namespace sightline::app {

// The cells of a row as text; for several views the median and the greatest value. Empty: not measured.
struct AnswerCells {
  std::string rounding;  // empty: nothing is rounded
  std::string emulated;
  std::string host;
  std::string wrong;
  std::string greatest;
  std::string far;  // the part farther than a point from the reference; for several views, in how many it is 0
  std::string chord;  // only for a sampled function
  std::string read;
  std::string paper;
};
[[nodiscard]] AnswerCells answer_cells(const compare::AnswerRow& row);

// The rows of each scene, under its name if there are several scenes; for several views the median and the greatest value.
[[nodiscard]] std::string answer_text(const std::vector<compare::AnswerRow>& rows);

// One object per row.
[[nodiscard]] base::Json answer_json(const std::vector<compare::AnswerRow>& rows);

}  // namespace sightline::app
