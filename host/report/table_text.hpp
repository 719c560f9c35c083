// A table as text for other programs.
#pragma once

#include <string>

#include "host/report/document.hpp"

namespace sightline::report {

// RFC 4180: a line of the columns' keys, then the rows, with lines ended by CR LF. Fields with a comma, a quotation
// mark or a line end are quoted. Real numbers are in the shortest form that reads back as the same value. An empty
// cell and a number that is not finite are empty fields.
[[nodiscard]] std::string csv_text(const Table& table);

// One document: {"schema": "sightline/table/1", "id", "title", "columns": [{"key", "title", "unit"}...], "rows":
// [{key: value...}...], "notes"}, indented by two, with a final line end. A verdict is {"good", "text"}. Invalid
// UTF-8 is replaced.
[[nodiscard]] std::string json_text(const Table& table);

// A cell as plain text for the page.
[[nodiscard]] std::string cell_text(const Cell& cell);

}  // namespace sightline::report
