// Diagnostics of an assembler: errors and warnings with their place, what was found, what was expected.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/asm/source.hpp"

namespace sightline::assembler {

enum class Severity { error, warning };

struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::string found;
  std::string expected;

  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

// "file:line:column: error: found X, expected Y"
[[nodiscard]] std::string to_string(const Diagnostic& diagnostic);

[[nodiscard]] bool any_errors(std::span<const Diagnostic> diagnostics);

}  // namespace sightline::assembler
