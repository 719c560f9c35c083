// One pass over all sources. Layout passes compute every symbol and the number of literals in each pool. They are
// repeated until nothing changes (a forward reference inside a literal needs a third pass). One more pass then makes the
// words and reports diagnostics, so that each is reported once.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/asm/diagnostic.hpp"
#include "tools/asm/pdp7.hpp"
#include "tools/asm/pdp7/lexer.hpp"
#include "tools/asm/pdp7/value.hpp"
#include "tools/asm/symbol_table.hpp"

namespace sightline::assembler {

struct EmittedWord {
  Position at;
  std::uint32_t address = 0;
  std::uint32_t word = 0;
  std::string generated_source;  // the source of a literal or variable; empty for a word of the source
};

// State handed from pass to pass; at the end, the result.
struct Pdp7Program {
  SymbolTable symbols{6};
  std::vector<std::uint32_t> pool_bases;  // address of each literal pool, in the order of placement
  std::vector<EmittedWord> words;
  std::vector<std::pair<Position, Diagnostic>> diagnostics;
  // For the dialect of Bell Laboratories only (bell.hpp): all definitions of 0: to 9:, and the value of `..`.
  std::array<std::vector<std::uint32_t>, 10> relative_labels;
  std::optional<std::uint32_t> base;
  std::optional<std::uint32_t> start;
  std::set<std::string> externals;  // keys of the names that EXTERNAL declares
  // A source with EXTERNAL or INTERNAL, assembled with other sources: only the names that it declares are visible to them.
  struct Module {
    bool declares = false;
    std::set<std::string> shared;  // keys
  };
  std::vector<Module> modules;  // of the sources
  bool modules_known = false;   // set by the first pass, in which names are common to all sources
};

class Pdp7Pass {
 public:
  Pdp7Pass(std::span<const SourceFile> sources, const Options& options, Pdp7Program& program, int number,
           bool final);

  void run();

 private:
  struct Literal {
    std::uint32_t word = 0;
    bool known = true;
  };

  // Statements
  void read_file(std::size_t index);
  void statement();
  bool pseudo_operation();  // true if the statement was a pseudo-operation
  void end_statement();
  void define_tag(Token name, std::uint32_t value, int form);
  [[nodiscard]] bool assign(Token name);  // true if it was a tag: more of the statement may follow
  void text();
  void conditional(bool when_zero);
  void skip_block(const Position& opened);
  void end_of_file();
  void next_tape();
  void declare(bool external);
  void report_undefined_declarations();
  void place_literals(const Position& at);
  void place_variables(const Position& at);
  void emit(std::uint32_t word, const Position& at, std::string generated_source = {});

  // Expressions
  [[nodiscard]] std::optional<Value> expression();
  [[nodiscard]] std::optional<Value> term();
  [[nodiscard]] std::optional<Value> primary();
  [[nodiscard]] std::optional<Value> number();
  [[nodiscard]] std::optional<Value> symbol();
  [[nodiscard]] std::optional<Value> literal();
  [[nodiscard]] bool starts_a_term() const;
  [[nodiscard]] std::uint32_t literal_index(std::uint32_t word, bool known);
  [[nodiscard]] std::uint32_t word_of(const Value& value, const Position& at);
  [[nodiscard]] std::optional<std::uint32_t> address_of(const Value& value, const Position& at,
                                                        std::string_view what, const char* hint = "");
  void mark_variable(Symbol& symbol, const Token& at);

  // Tokens and messages
  void advance() { token_ = lexer_.next(); }
  [[nodiscard]] Token following() const;
  [[nodiscard]] bool at_end_of_statement() const;
  void skip_statement();
  Symbol& look_up(const Token& name);
  [[nodiscard]] bool is_own(std::string_view name);
  // What the message shows as found here; names the dialect to which the construct belongs, if not this one.
  [[nodiscard]] std::string found_here() const;
  void error(const Position& at, std::string found, std::string expected);
  void warning(const Position& at, std::string found, std::string expected);
  void report(Severity severity, const Position& at, std::string found, std::string expected);
  void remark(const Position& at, std::span<const Remark> remarks);

  std::span<const SourceFile> sources_;
  const Options& options_;
  Pdp7Program& program_;
  int number_;
  bool final_;
  Arithmetic arithmetic_;
  Pdp7Lexer lexer_{"", 0};
  Token token_;
  std::size_t source_ = 0;  // the source being read
  std::uint32_t location_ = 0;
  bool location_by_origin_ = true;
  bool decimal_ = false;
  bool file_ended_ = false;
  bool statement_follows_ = false;  // after a condition, without an end of statement
  bool in_condition_ = false;
  int nesting_ = 0;               // of literals
  std::vector<Position> blocks_;  // open conditionals of this file
  std::vector<Literal> pool_;     // in order of first use
  std::map<std::uint32_t, std::uint32_t> pool_index_;
  std::size_t pools_placed_ = 0;
  std::set<std::string> pending_variables_;
  std::set<std::string> placed_variables_;
  std::map<std::uint32_t, Position> occupied_;
  std::set<std::string> clashes_;
  std::vector<std::pair<Token, bool>> declared_;  // of EXTERNAL (true) and INTERNAL
};

// The full name of the pseudo-operation that `word` abbreviates, or nothing. It needs at least the first six characters,
// and the rest must match: VARIABLE is VARIABLES, but VARIABLE2 is a symbol.
[[nodiscard]] std::string_view pseudo_operation_named(std::string_view word);

// A token as a message shows it.
[[nodiscard]] std::string describe(const Token& token);

}  // namespace sightline::assembler
