// What every assembler takes and returns: source texts, diagnostics with their place, symbols, the listing.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::assembler {

struct SourceFile {
  std::string name;  // as messages show it
  std::string text;
};

// A position in one of the files. Lines and columns count from 1, columns in bytes (a tab is one). Line 0 is outside all
// files: a symbol of the machine or of the command line.
struct Position {
  std::size_t file = 0;
  std::size_t line = 0;
  std::size_t column = 0;

  friend auto operator<=>(const Position&, const Position&) = default;
};

// Returns the text of a file, or nothing if it cannot be read.
using IncludeReader = std::function<std::optional<std::string>(const std::string& path)>;

// A symbol of the command line. Its value wins over those that the source gives it.
struct Define {
  std::string name;
  std::uint32_t value = 0;
};

enum class Severity : std::uint8_t { error, warning };

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

// Addresses and code are already text, in the radix of the machine: the columns are as wide as the widest entry.
struct ListingLine {
  std::string address;  // empty if the line assembles to no word
  std::string code;
  std::string source;           // the source line, or the literal or variable for which the assembler adds a word
  std::string file = {};        // the source file; empty if the word comes from no source line
  std::size_t line_number = 0;  // the line in that file, from 1

  friend bool operator==(const ListingLine&, const ListingLine&) = default;
};

[[nodiscard]] std::string write_listing(std::span<const ListingLine> lines);

enum class SymbolKind : std::uint8_t {
  undefined,  // used, not yet defined
  permanent,  // of the machine
  define,     // from the command line
  label,      // the address of a word or byte
  constant,   // has one value
  assigned,   // may be assigned several values
  variable,   // a word that the assembler reserves
};

// A symbol of the program; permanent symbols are not listed.
struct ProgramSymbol {
  std::string name;  // as first written
  std::uint32_t value = 0;
  SymbolKind kind = SymbolKind::label;
  std::string file;  // empty for a symbol of the command line
  std::size_t line = 0;
  std::size_t column = 0;
};

// How a language compares names.
struct Naming {
  std::size_t significant = std::string_view::npos;  // only so many characters of a name count
  std::string_view in_words = {};                    // that number, for a warning about names that differ only after them
  bool any_case = true;
  bool dollar_counts = true;  // else `$` is ignored

  // Two names with the same key are the same symbol.
  [[nodiscard]] std::string key(std::string_view name) const;
  // Symbols are listed in the order of these texts.
  [[nodiscard]] std::string order(std::string_view name) const;
};

// The result of an assembly but for the program itself.
struct AssemblyReport {
  Naming naming;
  std::vector<ProgramSymbol> symbols;  // in alphabetical order
  std::vector<ListingLine> listing;
  std::vector<Diagnostic> diagnostics;

  [[nodiscard]] bool ok() const { return !any_errors(diagnostics); }
  // Compares names as the language does.
  [[nodiscard]] std::optional<std::uint32_t> value_of(std::string_view name) const;
};

[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace sightline::assembler
