#include "tools/asm/assembly.hpp"

#include <algorithm>

namespace sightline::assembler {

std::string to_string(const Diagnostic& diagnostic) {
  const char* severity = diagnostic.severity == Severity::error ? "error" : "warning";
  return diagnostic.file + ":" + std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) +
         ": " + severity + ": found " + diagnostic.found + ", expected " + diagnostic.expected;
}

bool any_errors(std::span<const Diagnostic> diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string write_listing(std::span<const ListingLine> lines) {
  std::size_t address_width = 0;
  std::size_t code_width = 0;
  for (const ListingLine& line : lines) {
    address_width = std::max(address_width, line.address.size());
    code_width = std::max(code_width, line.code.size());
  }
  std::string text;
  for (const ListingLine& line : lines) {
    std::string row = line.address + std::string(address_width - line.address.size() + 1, ' ');
    row += line.code + std::string(code_width - line.code.size() + 2, ' ');
    row += line.source;
    row.erase(row.find_last_not_of(" \t") + 1);
    text += row + '\n';
  }
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::string Naming::key(std::string_view name) const {
  const std::string_view part = name.substr(0, significant);
  std::string key = any_case ? lower_case(part) : std::string(part);
  if (!dollar_counts) std::erase(key, '$');
  return key;
}

std::string Naming::order(std::string_view name) const {
  std::string text = key(name);
  std::erase(text, '$');
  return text;
}

std::optional<std::uint32_t> AssemblyReport::value_of(std::string_view name) const {
  const std::string text = naming.order(name);
  const auto at = std::lower_bound(symbols.begin(), symbols.end(), text,
                                   [this](const ProgramSymbol& symbol, const std::string& t) { return naming.order(symbol.name) < t; });
  if (at == symbols.end() || naming.order(at->name) != text) return std::nullopt;
  return at->value;
}

}  // namespace sightline::assembler
