// The table of how fast and how wrong each method is (host/compare/answer.hpp), for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/answer.hpp"

namespace sightline::app {

// A row in words, of many views the median and the greatest; empty: nothing is known of it.
struct AnswerCells {
  std::string rounding;  // empty: nothing is rounded
  std::string emulated;
  std::string host;
  std::string wrong;
  std::string greatest;
  std::string far;  // farther than a point: how much; of many views of how many it is nothing
  std::string chord;  // of a sampled function
  std::string read;
  std::string paper;
};
[[nodiscard]] AnswerCells answer_cells(const compare::AnswerRow& row);

// Rows of one scene below each other, under its name unless that is the only one; of many views the median and the greatest.
[[nodiscard]] std::string answer_text(const std::vector<compare::AnswerRow>& rows);

// One object a row.
[[nodiscard]] base::Json answer_json(const std::vector<compare::AnswerRow>& rows);

}  // namespace sightline::app
