// The table of how fast and how wrong each method is (host/compare/answer.hpp), for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/compare/answer.hpp"

namespace sightline::app {

// Rows of one scene below each other, under its name unless that is the only one; of many views the median and the greatest.
[[nodiscard]] std::string answer_text(const std::vector<compare::AnswerRow>& rows);

// With the unit that suits it: "1.50 s", "12.3 ms", "7 us".
[[nodiscard]] std::string time_text(double seconds);

// One object a row.
[[nodiscard]] base::Json answer_json(const std::vector<compare::AnswerRow>& rows);

}  // namespace sightline::app
