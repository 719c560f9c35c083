// Writes a report to disk: DIRECTORY/index.html, DIRECTORY/tables/ID.csv and ID.json.
#pragma once

#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/report/document.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

// Creates the directory and tables/ in it if they do not exist and tries to write into both, so that errors are found
// before anything is measured. On an error, directories created here are removed again.
[[nodiscard]] base::Result<base::Done> prepare_directory(const std::string& directory);

// Writes all files or, on an error, none: they are moved to their places when all are written, the page last. Files
// of an earlier report with the same names are replaced, others stay. Error bad_input: two tables or figures with one
// id, an id that is no file name, a row that is not as long as its table has columns. Returns the paths, the page
// first.
[[nodiscard]] base::Result<std::vector<std::string>> write_report(const Report& report,
                                                             const std::string& directory);

}  // namespace sightline::report
