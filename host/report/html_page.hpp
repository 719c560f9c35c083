// Writes a report as one self-contained HTML page: style and pictures are inside, there are no scripts, and nothing
// is loaded. It follows the reader's choice of light or dark, prints, and links every table to its CSV and JSON files
// next to the page (tables/ID.csv, tables/ID.json).
#pragma once

#include <string>
#include <string_view>

#include "host/base/file.hpp"
#include "host/report/document.hpp"

namespace sightline::report {

[[nodiscard]] std::string html_page(const Report& report);

// Replaces & < > " ' by references. Characters that HTML does not allow (controls except tab and line ends) and
// invalid UTF-8 become U+FFFD.
[[nodiscard]] std::string escape_html(std::string_view text);

// "data:TYPE;base64,...".
[[nodiscard]] std::string data_uri(std::string_view media_type, const base::Bytes& bytes);

}  // namespace sightline::report
