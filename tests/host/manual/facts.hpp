// The generated sections of the manual: Markdown made from the tables of the code, by name.
#pragma once

#include <string>
#include <string_view>

#include "host/base/result.hpp"

namespace sightline::manual {

// The text of the section NAME, with a line end. `root` is the repository: "source PATH" shows a file of it, "source PATH from
// WORD"
// shows the file from the line that begins with WORD. An error names a section that does not exist, a file that cannot be read,
// or a
// table's word without description.
[[nodiscard]] base::Result<std::string> section(std::string_view name, const std::string& root);

}  // namespace sightline::manual
