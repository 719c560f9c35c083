// A report on disk: DIRECTORY/index.html, DIRECTORY/tables/ID.csv and ID.json.
#pragma once

#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/report/document.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

// Makes the directory and tables/ in it if they are not there and tries to write into both: what cannot be
// written is known before anything is measured. On an error, directories made here are gone again.
[[nodiscard]] base::Result<base::Done> prepare_directory(const std::string& directory);

// All files or, on an error, none new: they are put in their places when all of them are written, the page
// last. Files of an earlier report of the same names are replaced, others stay. Error bad_input: two tables
// or figures of one id, an id that is no file name, a row that is not as wide as its table. Returns the
// paths, the page first.
[[nodiscard]] base::Result<std::vector<std::string>> write_report(const Report& report,
                                                             const std::string& directory);

}  // namespace sightline::report
