// What `sightline asm` does for every machine: reads the sources and definitions, says what the assembler
// found, writes the outputs, each a file of its own.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/app/command.hpp"
#include "host/base/file.hpp"
#include "host/base/result.hpp"
#include "tools/asm/diagnostic.hpp"
#include "tools/asm/source.hpp"

namespace sightline::app {

// Empty names are outputs not asked for.
struct AsmFiles {
  std::vector<std::string> sources;
  std::string output;
  std::string listing;
  std::string symbols;
};

// Failure usage if two of -o, --listing and --symbols are one file or both standard output, or if one of them
// is a source. What is no regular file (/dev/null) may serve often.
void refuse_clashing_files(const AsmFiles& files);

// In order, with the names that messages have. Failure io.
[[nodiscard]] std::vector<assembler::SourceFile> read_sources(const AsmFiles& files);

// Each -D NAME=VALUE by the reader of the machine's numbers. Failure usage with its "found X, expected Y".
template <class Define>
[[nodiscard]] std::vector<Define> read_defines(const std::vector<std::string>& texts,
                                               base::Result<Define> (*parse)(std::string_view)) {
  std::vector<Define> defines;
  for (const std::string& text : texts) {
    auto define = parse(text);
    if (!define) throw Failure(ExitCode::usage, fmt::format("-D {}: {}", text, define.error().message()));
    defines.push_back(std::move(*define));
  }
  return defines;
}

// On standard error, a line each. Failure bad_input if one is an error.
void report_diagnostics(std::span<const assembler::Diagnostic> diagnostics);

// Those of the three that were asked for; all appear or none. Failure io.
void write_asm_files(const AsmFiles& files, const base::Bytes& program, std::string_view listing,
                     std::string_view symbols);

}  // namespace sightline::app
