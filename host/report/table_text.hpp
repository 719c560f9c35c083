// A table as text for other programs.
#pragma once

#include <string>

#include "host/report/document.hpp"

namespace sightline::report {

// RFC 4180: a line of the columns' keys, then the rows, lines ended by CR LF; fields that hold a comma, a
// quotation mark or a line end are quoted. Real numbers in the shortest form that reads back as the same
// value; nothing is an empty field, and so is a number that is not finite.
[[nodiscard]] std::string csv_text(const Table& table);

// One document: {"schema": "sightline/table/1", "id", "title", "columns": [{"key", "title", "unit"}...],
// "rows": [{key: value...}...], "notes"}, indented by two, with a line end behind it. A judgement is
// {"good", "text"}. What is no UTF-8 is shown as far as it can be.
[[nodiscard]] std::string json_text(const Table& table);

// A cell as people read it, in the page: plain text.
[[nodiscard]] std::string shown_text(const Cell& cell);

}  // namespace sightline::report
