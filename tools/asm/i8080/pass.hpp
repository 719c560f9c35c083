// One reading of all 8080 sources. Layout passes compute the value of every symbol; they are repeated while an
// EQU with a forward reference changes a value. Then a last pass makes the bytes, and only that pass
// reports diagnostics.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "tools/asm/i8080.hpp"
#include "tools/asm/i8080/input.hpp"
#include "tools/asm/i8080/lexer.hpp"
#include "tools/asm/i8080/macro.hpp"
#include "tools/asm/i8080/vocabulary.hpp"

namespace sightline::assembler {

inline constexpr std::size_t listing_bytes_a_row = 4;
inline constexpr std::uint32_t memory_end = 0x10000;

struct I8080Entry {
  std::string name;  // as first written
  I8080SymbolKind kind = I8080SymbolKind::label;
  std::optional<std::uint16_t> value;  // nothing while unknown
  Position defined;
  int defined_in_pass = 0;  // the last pass that met its definition
  bool forward = false;     // its value rests on one that is defined further down
  bool pattern = false;     // as of I8080Value
  bool external = false;
};

// A source that has PUBLIC or EXTRN (also `name::` and `name##`) beside other sources: its names are its own but for these.
struct I8080Module {
  bool declares = false;
  std::set<std::string> shared;  // folded
};

// What passes hand on to each other, and at the end the outcome.
struct I8080Program {
  Vocabulary vocabulary;
  std::unordered_map<std::string, I8080Entry> symbols;  // by folded name; of a module's own names as I8080Pass::scoped()
  std::vector<I8080Module> modules;                     // of the sources
  bool modules_known = false;  // the first pass has found which there are; until then names are those of all sources
  std::deque<SourceFile> files;                         // sources, then what was included
  std::map<std::string, std::optional<std::size_t>>
      included;                     // path -> its place in `files`; nothing: cannot be read
  std::size_t unknown_equates = 0;  // in the last pass
  bool values_moved = false;        // in the last pass, against the one before
  image::ByteImage image;
  std::vector<ListingLine> listing;
  std::vector<Diagnostic> diagnostics;
};

// A value of an expression; `known` is false while it rests on a symbol not met yet.
struct I8080Value {
  std::uint32_t bits = 0;
  bool known = true;
  bool forward = false;  // not the same at its place in every pass: unfit for ORG and others that need a value in pass 1
  bool pattern = false;  // made by NOT: as a byte, FF above it is no overflow
};

class I8080Pass {
 public:
  I8080Pass(const I8080Options& options, I8080Program& program, int number, bool final)
      : options_(options), rules_(rules_of(options.dialect)), program_(program), number_(number), final_(final) {}

  void run(std::size_t sources);

 private:
  struct Conditional {
    bool active = false;
    bool parent_active = true;
    bool taken = false;  // the condition was true
    bool had_else = false;
    Position opened;
  };
  // The statement's label and operation; `operands` is where the rest begins.
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
    std::size_t depth = 1;   // of definitions inside it
    std::size_t frames = 0;  // open where it began
    Position opened;
  };

  // Lines, symbols and bytes (pass.cpp)
  bool next_line();
  void end_of_frame();
  void count_lines(std::size_t more);
  void begin_row();
  // `any_word`: also one that the language has, but not an operator before its operand.
  void enter(std::string_view name, std::size_t at, I8080SymbolKind kind, const I8080Value& value, bool any_word = false);
  // Where a name of the source that is read is among the symbols.
  [[nodiscard]] std::string scoped(const std::string& name) const;
  void share(const std::string& name);
  [[nodiscard]] std::string where_else(const std::string& name) const;
  void doubt_publics();
  void emit(std::uint8_t byte);
  void end_statement(I8080Frame& frame);

  // Statements (statement.cpp)
  void statement();
  void control_line();
  [[nodiscard]] bool is_control(std::string_view text) const;
  [[nodiscard]] bool in_comment();
  void doubt_comment();
  [[nodiscard]] std::optional<Head> head();
  [[nodiscard]] const Word* word(const std::string& name, WordKind kind) const;
  [[nodiscard]] bool is_operation(const std::string& name) const;
  [[nodiscard]] bool is_label_before(const Word* first, const std::string& second) const;
  void execute(const Head& head);
  void define_label(const Head& head);
  [[nodiscard]] bool active() const { return conditionals_.empty() || conditionals_.back().active; }

  // Directives (directives.cpp)
  void directive(Directive directive, const Head& head);
  void equate(const Head& head, I8080SymbolKind kind);
  void data_bytes(bool mark_last);
  bool data_string(bool mark_last);
  void data_words();
  void space();
  void origin();
  void end_of_program();
  void include(bool library);
  [[nodiscard]] std::optional<std::size_t> read_included(const std::string& path);
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

  // Expressions (expression.cpp). The token read is the first one behind the expression.
  [[nodiscard]] std::optional<I8080Value> expression();
  [[nodiscard]] std::optional<I8080Value> level(int precedence);
  [[nodiscard]] std::optional<I8080Value> prefix(Operator operation, int precedence);
  [[nodiscard]] bool go_deeper();
  [[nodiscard]] std::optional<I8080Value> primary();
  [[nodiscard]] std::optional<I8080Value> name_value();
  [[nodiscard]] const I8080Entry* label_of(const std::string& key) const;
  [[nodiscard]] std::optional<I8080Value> combine(Operator operation, const I8080Value& a,
                                                  const I8080Value& b, std::size_t at);
  [[nodiscard]] std::optional<Operator> operation_of_token() const;
  // One that has to be the same in every pass.
  [[nodiscard]] std::optional<std::uint16_t> settled(std::string_view what);
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
  void say(Severity severity, const Position& at, std::string found, std::string expected);
  [[nodiscard]] std::string where_from() const;

  const I8080Options& options_;
  const I8080Rules& rules_;
  I8080Program& program_;
  int number_;
  bool final_;
  std::vector<std::unique_ptr<I8080Frame>> frames_;
  std::vector<Conditional> conditionals_;
  std::unordered_map<std::string, Macro> macros_;
  std::optional<Definition> definition_;
  I8080Statement statement_;
  I8080Lexer lexer_;
  I8080Token token_;
  std::uint32_t location_ = 0;
  std::uint32_t statement_location_ = 0;
  std::uint32_t phase_ = 0;  // added to them where they are values
  bool behind_operator_ = false;  // the next operand of an expression follows one
  unsigned radix_ = 10;
  std::optional<char> comment_end_;  // of .COMMENT, whose end is to come
  Position comment_begun_;
  // Each segment has a location of its own from its first ORG on; until then it shares that of the segment before which it was entered.
  std::string segment_ = "cseg";
  std::map<std::string, std::size_t> counter_of_{{"cseg", 0}};
  std::vector<std::uint32_t> counters_{0};  // of those that are not current: where they go on
  // COMMON blocks: where each begins and how long the longest is; the one that is open, and where the program goes on behind it.
  struct Block {
    std::uint32_t begins = 0;
    std::uint32_t size = 0;
  };
  std::map<std::string, Block> blocks_;
  std::optional<std::string> open_block_;
  Position block_opened_;
  std::optional<std::uint32_t> behind_block_;
  std::vector<std::uint8_t> bytes_;           // of this statement
  std::optional<std::uint32_t> shown_value_;  // of a statement without bytes, for the listing
  bool shown_equated_ = false;                // ... by EQU or SET
  bool said_phase_ = false;                   // the first is the cause of all others
  bool said_overflow_ = false;                // since the last ORG
  bool said_overlap_ = false;                 // in this statement
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  std::size_t source_ = 0;  // that is read, with what it includes
  struct Public {
    std::string name;  // folded
    Position at;
    std::size_t source;
  };
  std::vector<Public> publics_;
  std::size_t lines_ = 0;
  std::size_t locals_ = 0;
  int nesting_ = 0;  // of an expression
  bool stopped_ = false;
};

}  // namespace sightline::assembler
