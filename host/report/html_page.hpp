// A report as one HTML page that needs nothing else: style and pictures are inside, there are no scripts, and
// nothing is fetched. It follows the reader's choice of light or dark, prints, and links from every table to
// its CSV and JSON files (tables/ID.csv, tables/ID.json), which lie beside it.
#pragma once

#include <string>
#include <string_view>

#include "host/base/file.hpp"
#include "host/report/document.hpp"

namespace sightline::report {

[[nodiscard]] std::string html_page(const Report& report);

// & < > " ' as references; characters HTML cannot hold (controls but tab and line ends) and what is no UTF-8
// as U+FFFD.
[[nodiscard]] std::string html_escaped(std::string_view text);

// "data:TYPE;base64,...".
[[nodiscard]] std::string data_uri(std::string_view media_type, const base::Bytes& bytes);

}  // namespace sightline::report
