// Splits a statement into label, operation and operands and executes it as a directive, a macro call or an instruction. The
// first word may be a label without a colon; the languages differ in how to tell.
#include <algorithm>
#include <string>

#include "tools/asm/i8080/pass.hpp"

namespace sightline::assembler {

void I8080Pass::statement() {
  I8080Frame& frame = *frames_.back();
  statement_location_ = location_;
  made_bytes_ = false;
  frame.listed.cells = 0;
  shown_value_.reset();
  shown_equated_ = reported_overlap_ = false;
  if (comment_end_ && in_comment()) return;
  if (rules_.dialect == I8080Dialect::common) warn_about_bang_in_comment();
  if (definition_) return collect();
  if (statement_.begins_line && statement_.text.starts_with('$') && is_control(statement_.text)) return control_line();
  const auto parsed = head();
  if (!parsed) return;
  if (active()) {
    execute(*parsed);
  } else if (const Word* found = word(parsed->operation, WordKind::directive);
             found != nullptr && found->directive >= Directive::if_ && found->directive <= Directive::endif) {
    conditional(found->directive, *parsed);
  }
  end_statement(frame);
}

const Word* I8080Pass::word(const std::string& name, WordKind kind) const {
  const Word* found = find_word(name);
  return found != nullptr && found->kind == kind ? found : nullptr;
}

// `$` in column 1 begins a listing control. Where `$` may begin a name, only the controls that MACRO-80 has are controls.
bool I8080Pass::is_control(std::string_view text) const {
  if (!rules_.dollar_in_names) return true;
  const std::size_t from = skip_blanks(text, 1);
  const std::string name = folded(text.substr(from, end_of_name(text, from) - from));
  return name == "eject" || name == "title" || name == "include";
}

// Lines between .COMMENT and its second sign.
bool I8080Pass::in_comment() {
  const std::size_t end = statement_.text.find(*comment_end_);
  if (end != std::string_view::npos) comment_end_.reset();
  return true;
}

// Warns of `!` in a comment before a possible statement.
void I8080Pass::warn_about_bang_in_comment() {
  if (!engine_.final() || statement_.text.find('!') == std::string_view::npos) return;
  const std::string_view text = statement_.text;
  for (std::size_t at = text.find('!', start_of_comment(text, 0)); at != std::string_view::npos; at = text.find('!', at + 1)) {
    const std::size_t from = skip_blanks(text, at + 1);
    const std::size_t end = end_of_name(text, from);
    if (end == from) continue;
    const bool label = end < text.size() && text[end] == ':';
    if (!label && !is_operation(folded(text.substr(from, end - from)))) continue;
    return warning(at, "'!' in a comment before " + quoted(text.substr(from, end - from)),
                   "--dialect: mac begins a statement there");
  }
}

// Of Intel's controls only INCLUDE affects the program: ignoring it with the others would lose the file.
void I8080Pass::control_line() {
  if (!active()) return;
  const std::string_view text = statement_.text.substr(0, start_of_comment(statement_.text, 0));
  const std::size_t name_ends = end_of_name(text, 1);
  if (name_ends > 1 && name_ends < text.size() && text[name_ends] == ':') {
    return error(0, "label " + quoted(text.substr(0, name_ends + 1)),
                 "one that does not begin with `$`, which --dialect m80 has");
  }
  for (std::size_t at = 1; at < text.size();) {
    const std::size_t end = end_of_name(text, at);
    const std::string name = folded(text.substr(at, end - at));
    if (name == "include" || name == "ic")
      return error(at, "the control " + quoted(text.substr(at, end - at)), "the directive INCLUDE");
    at = text[at] == '(' ? std::min(text.find(')', at), text.size()) : std::max(end, at + 1);
  }
}

// Nothing for an empty statement, a comment, and the control lines of Intel's and Digital Research's assemblers.
std::optional<I8080Pass::Head> I8080Pass::head() {
  const std::string_view text = statement_.text;
  if (statement_.begins_line && !text.empty() && (text[0] == '*' || (text[0] == '$' && is_control(text))))
    return std::nullopt;
  std::size_t at = skip_blanks(text, 0);
  const std::size_t line_number = at;
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
  if (at < text.size() && !is_blank(text[at])) at = line_number;
  const bool first_column = statement_.begins_line && (at == 0 || at > line_number);
  at = skip_blanks(text, at);
  if (at >= text.size() || text[at] == ';') return std::nullopt;

  Head result;
  const std::size_t end = end_of_name(text, at, rules_);
  const std::string_view first = text.substr(at, end - at);
  const std::size_t next = skip_blanks(text, end);
  const auto operation = [&](std::size_t from) {
    const std::size_t to = end_of_name(text, from, rules_);
    result.word = text.substr(from, to - from);
    result.operation = key_of(result.word, rules_);
    result.operation_at = from;
    result.operands = to;
  };
  const auto label = [&](std::size_t from) {
    result.label = first;
    result.label_at = at;
    operation(skip_blanks(text, from));
  };
  if (end > at && next < text.size() && text[next] == ':') {
    result.colon = true;
    result.two_colons = next + 1 < text.size() && text[next + 1] == ':';
    label(next + (result.two_colons ? 2 : 1));
    return result;
  }
  const std::string second = key_of(text.substr(next, end_of_name(text, next) - next), rules_);
  const Word* const after = word(second, WordKind::directive);
  const Word* const itself = word(key_of(first, rules_), WordKind::directive);
  const bool is_title = itself != nullptr && itself->directive == Directive::title && !first_column;
  if (end > at && after != nullptr && !is_title &&
      (after->directive == Directive::equ || after->directive == Directive::set ||
       after->directive == Directive::macro)) {
    label(next);
    return result;
  }
  operation(at);
  if (first_column && end > at && (!is_operation(result.operation) || is_label_before(itself, second)))
    label(next);
  return result;
}

bool I8080Pass::is_operation(const std::string& name) const {
  return macros_.contains(name) || word(name, WordKind::mnemonic) != nullptr ||
         word(name, WordKind::directive) != nullptr;
}

// CP/M's ASM does not know the directives that have no effect here: in ENTRY LXI H,0 the first word is a label.
bool I8080Pass::is_label_before(const Word* first, const std::string& second) const {
  if (first == nullptr || (first->directive != Directive::ignored && first->directive != Directive::title &&
                           first->directive != Directive::public_))
    return false;
  if (word(second, WordKind::mnemonic) != nullptr) return true;
  const Word* const data = word(second, WordKind::directive);
  return data != nullptr && (data->directive == Directive::db || data->directive == Directive::dw ||
                             data->directive == Directive::ds || data->directive == Directive::dc);
}

void I8080Pass::execute(const Head& head) {
  const Word* const known = find_word(head.operation);
  const auto macro = macros_.find(head.operation);
  const bool is_directive = known != nullptr && known->kind == WordKind::directive && macro == macros_.end();
  const bool names_something =
      is_directive && (known->directive == Directive::equ || known->directive == Directive::set ||
                       known->directive == Directive::macro);
  if (head.two_colons) engine_.declare(key_of(head.label, rules_), false);
  if (!head.label.empty() && !names_something) define_label(head);
  if (macro != macros_.end()) return call(Macro(macro->second), head.operands);
  read_operands(head.operands);
  if (is_directive) return directive(known->directive, head);
  if (known != nullptr && known->kind == WordKind::mnemonic) return instruction(known->rows);
  if (head.operation.empty()) {
    if (at_end()) return;
    return unexpected(head.label.empty() ? "a label, an instruction, a directive or a comment"
                                         : "an instruction or a directive");
  }
  error(head.operation_at, quoted(head.word), "an instruction, a directive or a macro");
}

void I8080Pass::define_label(const Head& head) {
  const std::uint32_t value = (statement_location_ + phase_) & 0xFFFFU;
  enter(head.label, head.label_at, SymbolKind::label, {value, true, false, false}, head.colon);
  shown_value_ = value;
}

}  // namespace sightline::assembler
