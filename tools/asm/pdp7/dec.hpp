// One pass over all sources in DEC's language.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/asm/pdp7.hpp"
#include "tools/asm/pdp7/lexer.hpp"
#include "tools/asm/pdp7/program.hpp"
#include "tools/asm/pdp7/value.hpp"

namespace sightline::assembler {

class DecPass {
 public:
  DecPass(const Options& options, Pdp7Program& program)
      : options_(options), program_(program), engine_(program.engine), arithmetic_(options.twos_complement, program.engine) {}

  void run();

 private:
  // Statements
  void read_file(std::size_t index);
  void statement();
  bool pseudo_operation();  // true if the statement was a pseudo-operation
  void end_statement();
  void define_tag(const Token& name, std::optional<std::uint32_t> value, int form = 0);
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
  [[nodiscard]] std::uint32_t literal_index(std::optional<std::uint32_t> word);
  [[nodiscard]] std::uint32_t word_of(const Value& value, const Position& at) const { return arithmetic_.word(value, location_, at); }
  [[nodiscard]] std::optional<std::uint32_t> address_of(const Value& value, const Position& at,
                                                        std::string_view what, const char* hint = "");
  void mark_variable(Symbol& symbol, const Token& name);

  // Tokens and messages
  void advance() { token_ = lexer_.next(); }
  [[nodiscard]] Token following() const;
  [[nodiscard]] bool at_end_of_statement() const;
  void skip_statement();
  Symbol& look_up(const Token& name) { return engine_.look_up(name.text, name.at); }
  // What the message shows as found here; names the dialect to which the construct belongs, if not this one.
  [[nodiscard]] std::string found_here() const;
  void error(const Position& at, std::string found, std::string expected) {
    engine_.error(at, std::move(found), std::move(expected));
  }

  const Options& options_;
  Pdp7Program& program_;
  Engine& engine_;
  Arithmetic arithmetic_;
  DecLexer lexer_{"", 0};
  Token token_;
  std::uint32_t location_ = 0;
  bool location_by_origin_ = true;
  bool decimal_ = false;
  bool file_ended_ = false;
  bool statement_follows_ = false;  // after a condition, without an end of statement
  bool in_condition_ = false;
  int nesting_ = 0;               // of literals
  std::vector<Position> blocks_;  // open conditionals of this file
  std::vector<std::uint32_t> pool_;  // the literals in order of first use
  std::map<std::uint32_t, std::uint32_t> pool_index_;
  std::set<std::string> pending_variables_;
  std::set<std::string> placed_variables_;
  std::vector<std::pair<Token, bool>> declared_;  // of EXTERNAL (true) and INTERNAL
};

// The full name of the pseudo-operation that `word` abbreviates, or nothing. It needs at least the first six characters,
// and the rest must match: VARIABLE is VARIABLES, but VARIABLE2 is a symbol.
[[nodiscard]] std::string_view pseudo_operation_named(std::string_view word);

// A token as a message shows it.
[[nodiscard]] std::string describe(const Token& token);

}  // namespace sightline::assembler
