// One pass over all 8080 sources.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "tools/asm/engine.hpp"
#include "tools/asm/i8080.hpp"
#include "tools/asm/i8080/input.hpp"
#include "tools/asm/i8080/lexer.hpp"
#include "tools/asm/i8080/macro.hpp"
#include "tools/asm/i8080/vocabulary.hpp"

namespace sightline::assembler {

inline constexpr std::uint32_t memory_end = 0x10000;

// Bits of Symbol::form.
inline constexpr int forward_form = 1;  // as in I8080Value
inline constexpr int pattern_form = 2;

struct I8080Program {
  I8080Program(std::span<const SourceFile> sources, const Naming& naming) : engine(sources, naming, hexadecimal_bytes) {}

  Engine engine;
  std::optional<std::uint16_t> start;
};

// A value of an expression; `known` is false while it depends on an undefined symbol.
struct I8080Value {
  std::uint32_t bits = 0;
  bool known = true;
  bool forward = false;  // may differ between passes: unfit for ORG and others that need the value in pass 1
  bool pattern = false;  // made by NOT: FF in the high byte is no overflow of a byte
};

class I8080Pass {
 public:
  I8080Pass(const I8080Options& options, I8080Program& program)
      : options_(options), rules_(rules_of(options.dialect)), program_(program), engine_(program.engine) {}

  void run();

 private:
  struct Conditional {
    bool active = false;
    bool parent_active = true;
    bool taken = false;  // the condition was true
    bool had_else = false;
    Position opened;
  };
  // The statement's label and operation; `operands` is where the operands begin.
  struct Head {
    std::string_view label;
    std::size_t label_at = 0;
    bool colon = false;
    bool two_colons = false;
    std::string_view word;
    std::string operation;  // folded
    std::size_t operation_at = 0;
    std::size_t operands = 0;
  };
  // A macro or repeat whose body is being read.
  struct Definition {
    Directive kind = Directive::macro;
    Macro macro;
    std::vector<std::vector<std::string>> rows;
    std::size_t iterations = 0;
    Body body;
    std::size_t depth = 1;   // of nested definitions
    std::size_t frames = 0;  // open where it began
    Position opened;
  };

  // Lines, symbols and bytes (pass.cpp)
  bool next_line();
  void end_of_frame();
  void count_lines(std::size_t more);
  // `any_word`: also a word of the language, but not a prefix operator.
  void enter(std::string_view name, std::size_t at, SymbolKind kind, const I8080Value& value, bool any_word = false);
  [[nodiscard]] std::string suggest_declaration(const std::string& name) const;
  void warn_about_undefined_publics();
  void emit(std::uint8_t byte);
  void end_statement(I8080Frame& frame);

  // Statements (statement.cpp)
  void statement();
  void control_line();
  [[nodiscard]] bool is_control(std::string_view text) const;
  [[nodiscard]] bool in_comment();
  void warn_about_bang_in_comment();
  [[nodiscard]] std::optional<Head> head();
  [[nodiscard]] const Word* word(const std::string& name, WordKind kind) const;
  [[nodiscard]] bool is_operation(const std::string& name) const;
  [[nodiscard]] bool is_label_before(const Word* first, const std::string& second) const;
  void execute(const Head& head);
  void define_label(const Head& head);
  [[nodiscard]] bool active() const { return conditionals_.empty() || conditionals_.back().active; }

  // Directives (directives.cpp)
  void directive(Directive directive, const Head& head);
  void equate(const Head& head, SymbolKind kind);
  void data_bytes(bool mark_last);
  bool data_string(bool mark_last);
  void data_words();
  void space();
  void origin();
  void end_of_program();
  void include(bool library);
  void externals();
  void publics();
  void processor();
  void radix();
  void phase(const Head& head);
  void comment(const Head& head);
  void common();
  void leave_common();
  void enter_segment(const std::string& name);

  // Blocks (blocks.cpp)
  void conditional(Directive directive, const Head& head);
  [[nodiscard]] bool condition(Directive directive);
  void define_macro(const Head& head);
  void repeat(Directive directive);
  void begin_definition(Definition definition);
  void collect();
  void collect_line();
  void end_definition();
  void call(const Macro& macro, std::size_t operands);
  void exit_macro();
  [[nodiscard]] std::optional<std::vector<std::string>> names_list(std::string_view what);
  [[nodiscard]] Arguments arguments_of(std::string_view text, std::size_t at);
  [[nodiscard]] std::vector<std::string> argument_texts(const Arguments& arguments);
  void push(std::unique_ptr<I8080Frame> frame);

  // Instructions (instruction.cpp)
  void instruction(const Mnemonic& rows);
  [[nodiscard]] std::optional<std::uint8_t> field(i8080::Operand operand);
  [[nodiscard]] std::optional<std::uint8_t> opcode_value(const Mnemonic& rows);

  // Expressions (expression.cpp). Afterwards token_ is the first token after the expression.
  [[nodiscard]] std::optional<I8080Value> expression();
  [[nodiscard]] std::optional<I8080Value> level(int precedence);
  [[nodiscard]] std::optional<I8080Value> prefix(Operator operation, int precedence);
  [[nodiscard]] bool go_deeper();
  [[nodiscard]] std::optional<I8080Value> primary();
  [[nodiscard]] std::optional<I8080Value> name_value();
  [[nodiscard]] const Symbol* label_of(const std::string& key) const;
  [[nodiscard]] std::optional<I8080Value> combine(Operator operation, const I8080Value& a,
                                                  const I8080Value& b, std::size_t at);
  [[nodiscard]] std::optional<Operator> operation_of_token() const;
  // An expression whose value must be the same in every pass.
  [[nodiscard]] std::optional<std::uint16_t> constant_value(std::string_view what);
  [[nodiscard]] std::optional<std::uint8_t> byte_of(const I8080Value& value, std::size_t at);

  // Tokens and messages (pass.cpp)
  void read_operands(std::size_t at);
  void advance() { token_ = lexer_.next(); }
  [[nodiscard]] bool at_end() const { return token_.kind == I8080TokenKind::end; }
  bool expect_end();
  bool expect_comma();  // and reads on
  void unexpected(std::string expected);
  [[nodiscard]] std::string shown_token() const;
  [[nodiscard]] Position place(std::size_t at) const;
  void error(std::size_t at, std::string found, std::string expected);
  void warning(std::size_t at, std::string found, std::string expected);
  void report(Severity severity, const Position& at, std::string found, std::string expected);
  [[nodiscard]] std::string where_from() const;

  const I8080Options& options_;
  const I8080Rules& rules_;
  I8080Program& program_;
  Engine& engine_;
  std::vector<std::unique_ptr<I8080Frame>> frames_;
  std::vector<Conditional> conditionals_;
  std::unordered_map<std::string, Macro> macros_;
  std::optional<Definition> definition_;
  I8080Statement statement_;
  I8080Lexer lexer_;
  I8080Token token_;
  std::uint32_t location_ = 0;
  std::uint32_t statement_location_ = 0;
  std::uint32_t phase_ = 0;  // .PHASE: added to locations used as values
  bool after_operator_ = false;  // the next operand of an expression follows an operator
  unsigned radix_ = 10;
  std::optional<char> comment_end_;  // the character that ends .COMMENT, while one is open
  Position comment_begun_;
  // A segment has a location of its own from its first ORG on; until then it shares that of the segment before which it was
  // entered.
  std::string segment_ = "cseg";
  std::map<std::string, std::size_t> counter_of_{{"cseg", 0}};
  std::vector<std::uint32_t> counters_{0};  // of segments that are not current: where they continue
  // COMMON blocks: where each begins and how long the longest is; the open block, and where the program continues after it.
  struct Block {
    std::uint32_t begins = 0;
    std::uint32_t size = 0;
  };
  std::map<std::string, Block> blocks_;
  std::optional<std::string> open_block_;
  Position block_opened_;
  std::optional<std::uint32_t> behind_block_;
  bool made_bytes_ = false;                   // in this statement
  std::optional<std::uint32_t> shown_value_;  // of a statement without bytes, for the listing
  bool shown_equated_ = false;                // shown_value_ is from EQU or SET
  bool reported_overflow_ = false;                // since the last ORG
  bool reported_overlap_ = false;                 // in this statement
  std::vector<std::pair<std::string, Position>> publics_;  // keys
  std::size_t lines_ = 0;
  std::size_t locals_ = 0;
  int nesting_ = 0;  // of an expression
};

}  // namespace sightline::assembler
