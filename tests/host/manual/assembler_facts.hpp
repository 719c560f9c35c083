// Sections on the assemblers: their words, and rejected sources with the messages.
#pragma once

#include <string>

#include "host/base/result.hpp"

namespace sightline::manual {

[[nodiscard]] base::Result<std::string> pdp7_refused();
[[nodiscard]] base::Result<std::string> bell_refused();  // of the dialect of Bell Laboratories
[[nodiscard]] base::Result<std::string> i8080_refused();
// The differences between the dialects of 8080 sources.
[[nodiscard]] std::string i8080_dialects();
// Read from the source of the assembler, because its tables are not in a header. An error names a word without description.
[[nodiscard]] base::Result<std::string> pdp7_pseudo_operations(const std::string& source);
[[nodiscard]] base::Result<std::string> i8080_directives(const std::string& source);

}  // namespace sightline::manual
