// The files `sightline asm` is given by name, whatever the machine: each output is a file of its own.
#pragma once

#include <string>
#include <vector>

namespace sightline::app {

// Failure usage if two of -o, --listing and --symbols are one file or both standard output, or if one of them
// is a source. Empty names are outputs not asked for. What is no regular file (/dev/null) may serve often.
void refuse_clashing_files(const std::vector<std::string>& sources, const std::string& output,
                           const std::string& listing, const std::string& symbols);

}  // namespace sightline::app
