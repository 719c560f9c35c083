// The engine of all assemblers: what they do alike, whatever the language.
//
// A language is a lexer, a grammar of expressions and its directives. It reads the sources once for each pass and tells the
// engine what it finds: names with their values, numbered places, words or bytes, mistakes. The engine repeats the passes until
// the layout settles; diagnostics and the contents of memory are those of the last pass.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tools/asm/assembly.hpp"

namespace sightline::assembler {

struct Symbol {
  std::string name;  // as first written
  SymbolKind kind = SymbolKind::undefined;
  // Nothing while it is unknown. Up to its first definition in a pass the value is that at the end of the pass before.
  std::optional<std::uint32_t> value;
  std::optional<std::uint32_t> before;  // at the end of the pass before
  int form = 0;                         // set by the language
  int defined_in_pass = 0;              // the last pass that read a definition
  Position defined;                     // its first definition in that pass; until there is one, its first use
  bool was_permanent = false;           // a definition replaced a symbol of the machine
  bool set_again = false;               // the language noticed a second definition
};

// Places with a number instead of a name, in the order in which a pass reaches them: literal pools, the labels 0: to 9: of Bell's
// assembler.
class Places {
 public:
  void add(std::uint32_t place);
  // Change what the next place and the last place are, up to the next `add`.
  void set_next(std::uint32_t place) { next_ = place; }
  void set_last(std::uint32_t place) { last_ = place; }
  // The next place: what set_next gave, or else the value that `add` will give, as the pass before found it.
  [[nodiscard]] std::optional<std::uint32_t> next() const;
  [[nodiscard]] std::optional<std::uint32_t> last() const { return last_; }

 private:
  friend class Engine;
  // Ends a pass. True if the places differ from those of the pass before.
  bool end_pass();

  std::vector<std::uint32_t> now_;
  std::vector<std::uint32_t> before_;
  std::optional<std::uint32_t> next_;
  std::optional<std::uint32_t> last_;
};

// How numbers are written.
struct Radix {
  unsigned base = 8;  // 8 or 16
  unsigned value_digits = 6;
  unsigned address_digits = 5;
  unsigned cell_digits = 6;     // of a word or byte in the listing
  std::size_t cells_a_row = 1;  // most cells in a row of the listing

  [[nodiscard]] std::string text(std::uint32_t value, unsigned digits) const;
};
inline constexpr Radix octal_words{};
inline constexpr Radix hexadecimal_bytes{16, 4, 4, 2, 4};

// A source line in the listing, and how much of it is shown.
struct ListedLine {
  std::optional<std::size_t> row;  // nothing without a listing
  bool filled = false;             // the row has an address
  bool of_source = true;           // else cells have no source line
  std::size_t last = 0;            // the row with the latest cells
  std::size_t cells = 0;           // of the statement in that row; 0: a new statement begins
};

class Engine {
 public:
  Engine(std::span<const SourceFile> sources, const Naming& naming, const Radix& radix);

  // --- Passes

  // Calls `read` for each pass, and before the first `enter_names`, which enters the names of the machine and of the command
  // line. If a source declares names, the engine begins again with names that are local to their sources.
  void run(const std::function<void()>& enter_names, const std::function<void()>& read);
  // The last pass: it makes the program.
  [[nodiscard]] bool final() const { return final_; }
  // The layout of this pass depends on a value that is not known yet.
  void await_value() { awaits_value_ = true; }
  // After too many errors, or at the language's request: the pass ends and reports nothing more.
  void stop() { stopped_ = true; }
  [[nodiscard]] bool stopped() const { return stopped_; }

  // --- Files

  [[nodiscard]] std::size_t sources() const { return sources_; }
  // A source, or an included file.
  [[nodiscard]] const SourceFile& file(std::size_t index) const { return files_[index]; }
  // The source that is read from here on, with the files that it includes.
  void begin_source(std::size_t index) {
    source_ = index;
    unlisted_ = files_[index].text;
    listed_ = 0;
  }
  // The index of an included file; nothing if it cannot be read. Each file is read once for all passes.
  [[nodiscard]] std::optional<std::size_t> include(const std::string& path, const IncludeReader& reader);
  // "FILE:LINE" or "the command line"
  [[nodiscard]] std::string where(const Position& at) const;

  // --- Names. Keys are those of Naming::key. In a source that declares names, all others are local to it.

  [[nodiscard]] const Naming& naming() const { return naming_; }
  [[nodiscard]] Symbol* find(const std::string& key);
  // Makes an undefined symbol if there is none.
  Symbol& symbol(const std::string& key, std::string_view written);
  // The same. Warns if the name differs from that of the symbol where the language does not count it.
  Symbol& look_up(std::string_view written, const Position& at);
  // The symbol that is local to a source, or without a source the one common to all.
  [[nodiscard]] const Symbol* find_in(const std::string& key, std::optional<std::size_t> source) const;
  // Enters a symbol of the machine or of the command line.
  void enter(std::string_view name, std::uint32_t value, SymbolKind kind, int form = 0);
  // Gives a symbol its value from here on.
  void define(Symbol& symbol, SymbolKind kind, std::optional<std::uint32_t> value, const Position& at, int form = 0);
  // Whether this pass has read a definition.
  [[nodiscard]] bool is_defined(const Symbol& symbol) const { return symbol.defined_in_pass == pass_; }
  [[nodiscard]] auto& symbols() { return symbols_; }  // by their key in the table
  [[nodiscard]] std::string table_key(const std::string& key) const;

  // This source shares a name with other sources. An external one is defined in another.
  void declare(const std::string& key, bool external);
  [[nodiscard]] bool is_external(const std::string& key) const { return externals_.contains(key); }
  // Whether the name means, in this source, a name that a source declares as external.
  [[nodiscard]] bool means_external(const std::string& key) const { return is_external(key) && table_key(key) == key; }
  [[nodiscard]] bool names_are_local() const { return names_are_local_; }
  [[nodiscard]] bool is_declared(const std::string& key) const { return modules_[source_].shared.contains(key); }
  [[nodiscard]] bool declares() const { return modules_[source_].declares; }

  [[nodiscard]] Places& places(std::size_t series) { return places_[series]; }

  // --- Memory, which the last pass fills

  // Puts a value at an address and into the listing. Returns where the cell got its first value, if it has one; the later value
  // replaces it. `note` is the source of a cell that no source line has: of a literal or variable.
  std::optional<Position> put(std::uint32_t address, std::uint32_t value, const Position& at, ListedLine& line, std::string note = {});
  template <class Take>
  void for_each_cell(Take&& take) const {
    for (std::size_t address = 0; address < memory_.size(); ++address)
      if (memory_[address].line != 0) take(static_cast<std::uint32_t>(address), memory_[address].value);
  }

  // --- The listing, of the last pass only

  [[nodiscard]] ListedLine add_line(std::string text);
  // Adds the lines of the current source up to a position, and returns that line. Behind the end it is no source line.
  ListedLine& line_at(const Position& at);
  // An address, or the value of an EQU, in a line that has no cells.
  void show(ListedLine& line, std::uint32_t value, bool equated, const Position& at);

  // --- Diagnostics, of the last pass only

  void report(Severity severity, const Position& at, std::string found, std::string expected);
  void error(const Position& at, std::string found, std::string expected) {
    report(Severity::error, at, std::move(found), std::move(expected));
  }
  void warning(const Position& at, std::string found, std::string expected) {
    report(Severity::warning, at, std::move(found), std::move(expected));
  }

  // --- Results

  // By place: in the order of the sources, else in that of the reports.
  void finish(AssemblyReport& report, bool by_place);

 private:
  struct Module {
    bool declares = false;
    std::set<std::string> shared;  // keys
  };
  struct Cell {
    std::uint32_t value = 0;
    std::uint32_t file = 0;  // of the first value
    std::uint32_t line = 0;  // 0: no value
  };

  void read_once(const std::function<void()>& read);
  [[nodiscard]] bool end_layout_pass();
  [[nodiscard]] bool end_places();
  void report_unsettled(bool settled);

  ListingLine& begin_row(ListedLine& line, std::uint32_t address, const Position& at);

  Naming naming_;
  Radix radix_;
  std::size_t sources_;
  std::deque<SourceFile> files_;  // sources, then included files
  std::map<std::string, std::optional<std::size_t>> included_;  // by path
  std::size_t source_ = 0;
  int pass_ = 0;
  bool final_ = false;
  bool awaits_value_ = false;
  bool stopped_ = false;
  std::unordered_map<std::string, Symbol> symbols_;
  std::vector<Module> modules_;  // of the sources
  bool names_are_local_ = false;
  std::set<std::string> externals_;
  std::set<std::string> clashes_;
  std::array<Places, 10> places_;
  std::vector<Cell> memory_;  // up to the highest address with a value
  std::vector<ListingLine> listing_;
  ListedLine line_;           // of line_at
  std::string_view unlisted_;  // the rest of the current source
  std::size_t listed_ = 0;     // its lines in the listing
  std::vector<std::pair<Position, Diagnostic>> diagnostics_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
};

// A text in quotes, shortened for a message; bytes that are no printing ASCII as \NNN.
[[nodiscard]] std::string in_quotes(std::string_view text);

// One line `name value` per symbol.
[[nodiscard]] std::string write_symbols(std::span<const ProgramSymbol> symbols, const Radix& radix);

}  // namespace sightline::assembler
