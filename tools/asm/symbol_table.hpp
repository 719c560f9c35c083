// Symbols by name. Upper and lower case are the same unless `any_case` is false. Only the first `significant` characters
// count: two names that agree in those are the same symbol. The table remembers how each was first written.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tools/asm/source.hpp"

namespace sightline::assembler {

enum class SymbolKind {
  undefined,  // used, not yet defined
  permanent,  // of the machine
  define,     // from the command line: overrides assignments in the source
  tag,        // name, - the address of a word
  assigned,   // name=expression
  variable,   // a word the assembler reserves
};

struct Symbol {
  std::string name;  // as first written
  SymbolKind kind = SymbolKind::undefined;
  std::optional<std::uint32_t> value;  // nothing while unknown
  int form = 0;                        // set by the assembler that uses the table
  Position defined;
  bool was_permanent = false;   // an assignment replaced a symbol of the machine
  bool several_values = false;  // assigned differing values
  bool set_again = false;       // a warning has been given
  int defined_in_pass = 0;      // the last pass that read its definition
};

class SymbolTable {
 public:
  explicit SymbolTable(std::size_t significant, bool any_case = true)
      : significant_(significant), any_case_(any_case) {}

  // Makes an undefined symbol if there is none.
  Symbol& operator[](std::string_view name);
  [[nodiscard]] const Symbol* find(std::string_view name) const;
  // The same for a name that is local to one source, separate from the name common to all.
  Symbol& own(std::string_view name, std::size_t source);
  [[nodiscard]] std::string own_key(std::string_view name, std::size_t source) const;
  // By its key, common or local.
  Symbol& at_key(const std::string& key) { return symbols_[key]; }
  // Cut to the significant characters; in lower case if case does not matter.
  [[nodiscard]] std::string key(std::string_view name) const;

  [[nodiscard]] auto begin() { return symbols_.begin(); }
  [[nodiscard]] auto end() { return symbols_.end(); }
  [[nodiscard]] auto begin() const { return symbols_.begin(); }
  [[nodiscard]] auto end() const { return symbols_.end(); }

 private:
  std::size_t significant_;
  bool any_case_;
  std::map<std::string, Symbol, std::less<>> symbols_;
};

[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace sightline::assembler
