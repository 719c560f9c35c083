// Directives that enclose lines: conditionals, macros, repeats. A body is kept as text with the position of each line.
#include <algorithm>
#include <utility>

#include "tools/asm/i8080/pass.hpp"

namespace sightline::assembler {
namespace {

constexpr std::size_t most_frames = 256;

bool opens_definition(Directive directive) {
  return directive == Directive::macro || directive == Directive::rept || directive == Directive::irp ||
         directive == Directive::irpc;
}

// `;;` begins a comment that is not copied into expansions.
std::string_view without_private_comment(std::string_view text) {
  const std::size_t at = start_of_comment(text, 0);
  return text.substr(at).starts_with(";;") ? text.substr(0, at) : text;
}

// In the radix, with a leading 0 if the first digit is above 9, so that it can be read again.
std::string in_radix(unsigned value, unsigned radix) {
  std::string digits;
  do {
    digits.insert(digits.begin(), "0123456789ABCDEF"[value % radix]);
    value /= radix;
  } while (value != 0);
  return digits.front() > '9' ? "0" + digits : digits;
}

const char* name_of(Directive directive) {
  return directive == Directive::rept ? "REPT" : directive == Directive::irp ? "IRP" : "IRPC";
}

}  // namespace

// Conditionals

void I8080Pass::conditional(Directive directive, const Head& head) {
  if (directive == Directive::else_ || directive == Directive::endif) {
    if (conditionals_.size() <= frames_.back()->conditionals)
      return error(head.operation_at, quoted(head.word), "an IF before it, in the same file or macro");
    Conditional& open = conditionals_.back();
    if (directive == Directive::endif) return conditionals_.pop_back();
    if (open.had_else) return error(head.operation_at, "a second ELSE", "ENDIF");
    open.had_else = true;
    open.active = open.parent_active && !open.taken;
    return;
  }
  Conditional opened;
  opened.parent_active = active();
  opened.opened = place(head.operation_at);
  opened.taken = opened.parent_active && condition(directive);
  opened.active = opened.taken;
  conditionals_.push_back(opened);
}

// A condition with an error is false.
bool I8080Pass::condition(Directive directive) {
  if (directive == Directive::if_first_pass || directive == Directive::if_second_pass) {
    // IF1 is true in the layout passes, IF2 in the pass that makes the bytes.
    return expect_end() && engine_.final() == (directive == Directive::if_second_pass);
  }
  if (directive == Directive::if_ || directive == Directive::if_zero) {
    const std::size_t at = token_.column;
    const auto read = expression();
    if (!read || !expect_end()) return false;
    // As in ASM and MAC, a name that is defined further down is 0 in the first pass. Later passes use its value.
    if (!read->known) engine_.await_value();
    const std::uint32_t value = read->bits;
    const bool odd = (value & 1U) != 0;
    if (odd != (value != 0) && rules_.if_takes_bit_zero) {
      const std::string dialect(i8080_dialect_names[static_cast<std::size_t>(rules_.dialect)]);
      warning(at, "value " + std::to_string(value) + " of IF, of which only bit 0 is tested with --dialect " + dialect, "0 or an odd value");
    } else if (odd != (value != 0) && rules_.dialect == I8080Dialect::common) {
      warning(at, "value " + std::to_string(value) + " of IF",
              "0, an odd value or --dialect: it is true here; mac and intel test bit 0 alone");
    }
    return (rules_.if_takes_bit_zero ? odd : value != 0) == (directive == Directive::if_);
  }
  if (directive == Directive::if_defined || directive == Directive::if_not_defined) {
    if (token_.kind != I8080TokenKind::name) {
      unexpected("a name");
      return false;
    }
    const Symbol* const found = engine_.find(token_.value);
    const bool defined = engine_.means_external(token_.value) ||
                         (found != nullptr && (engine_.is_defined(*found) || found->kind == SymbolKind::define));
    return defined == (directive == Directive::if_defined);
  }
  const Arguments arguments = arguments_of(statement_.text, token_.column);
  const auto text = [&](std::size_t i) {
    return i < arguments.list.size() ? arguments.list[i].text : std::string();
  };
  switch (directive) {
    case Directive::if_blank: return text(0).empty();
    case Directive::if_not_blank: return !text(0).empty();
    case Directive::if_same: return text(0) == text(1);
    default: return text(0) != text(1);
  }
}

// Definitions

std::optional<std::vector<std::string>> I8080Pass::names_list(std::string_view what) {
  std::vector<std::string> names;
  while (!at_end()) {
    if (token_.kind != I8080TokenKind::name) {
      unexpected(std::string(what));
      return std::nullopt;
    }
    names.push_back(token_.value);
    advance();
    if (at_end()) break;
    if (!expect_comma()) return std::nullopt;
  }
  return names;
}

Arguments I8080Pass::arguments_of(std::string_view text, std::size_t at) {
  Arguments arguments = split_arguments(text, at, rules_);
  if (rules_.dialect == I8080Dialect::common && arguments.bang != std::string_view::npos) {
    warning(arguments.bang, "'!' in an argument",
            "--dialect: it is an ordinary character here; m80 and intel take the next character literally");
  }
  return arguments;
}

void I8080Pass::define_macro(const Head& head) {
  Definition definition;
  definition.macro.name = std::string(head.label);
  definition.macro.defined = place(0);
  const Word* const reserved = find_word(key_of(head.label, rules_));
  if (head.label.empty()) {
    error(head.operation_at, "MACRO without a name", "NAME before it");
  } else if (reserved != nullptr) {
    error(head.label_at, quoted(head.label), "a name that is not reserved");
    definition.macro.name.clear();
  }
  definition.macro.parameters = names_list("the name of a parameter").value_or(std::vector<std::string>());
  begin_definition(std::move(definition));
}

void I8080Pass::repeat(Directive directive) {
  Definition definition;
  definition.kind = directive;
  definition.macro.name = name_of(directive);
  if (directive == Directive::rept) {
    definition.iterations = constant_value("a count").value_or(0);
    expect_end();
    return begin_definition(std::move(definition));
  }
  if (token_.kind != I8080TokenKind::name) {
    unexpected("the name of a parameter");
    return begin_definition(std::move(definition));
  }
  definition.macro.parameters.push_back(token_.value);
  advance();
  if (token_.is(',')) {
    Arguments given = arguments_of(statement_.text, token_.column + 1);
    if (given.unclosed != std::string_view::npos) error(given.unclosed, "'<' without '>'", "'>'");
    const std::string text = given.list.empty() ? std::string() : given.list.front().text;
    if (directive == Directive::irpc) {
      for (const char c : text) definition.rows.push_back({std::string(1, c)});
    } else {
      // Without brackets the arguments themselves are the list.
      if (given.list.size() < 2) given = split_arguments(text, 0, rules_);
      for (const Argument& argument : given.list) definition.rows.push_back({argument.text});
    }
    if (definition.rows.empty() && (directive != Directive::irpc || rules_.empty_irpc_is_one)) definition.rows.push_back({""});
  } else {
    unexpected("',' and what the parameter stands for");
  }
  definition.iterations = definition.rows.size();
  begin_definition(std::move(definition));
}

void I8080Pass::begin_definition(Definition definition) {
  definition.frames = frames_.size();
  definition.opened = place(0);
  definition_ = std::move(definition);
}

void I8080Pass::collect() {
  if (const auto parsed = head()) {
    const Word* const found = word(parsed->operation, WordKind::directive);
    const Directive directive = found == nullptr ? Directive::ignored : found->directive;
    if (opens_definition(directive)) ++definition_->depth;
    if (directive == Directive::endm && --definition_->depth == 0) {
      if (!parsed->label.empty()) definition_->body.lines.push_back({std::string(parsed->label) + ":", place(parsed->label_at)});
      return end_definition();
    }
    if (directive == Directive::local && definition_->depth == 1) {
      read_operands(parsed->operands);
      const auto names = names_list("a local name").value_or(std::vector<std::string>());
      auto& locals = definition_->body.locals;
      locals.insert(locals.end(), names.begin(), names.end());
      return;
    }
  }
  collect_line();
}

// A statement after `!` is indented, because it did not begin in column 1.
void I8080Pass::collect_line() {
  const std::string indent = statement_.begins_line ? "" : " ";
  Position at = place(0);
  at.column -= indent.size();
  definition_->body.lines.push_back({indent + std::string(without_private_comment(statement_.text)), at});
}

void I8080Pass::end_definition() {
  Definition definition = std::move(*definition_);
  definition_.reset();
  auto body = std::make_shared<const Body>(std::move(definition.body));
  if (definition.kind == Directive::macro) {
    definition.macro.body = std::move(body);
    const std::string key = key_of(definition.macro.name, rules_);
    if (!key.empty()) macros_.insert_or_assign(key, std::move(definition.macro));
    return;
  }
  push(std::make_unique<I8080Frame>(definition.macro.name, definition.opened, std::move(body),
                                    std::move(definition.macro.parameters), std::move(definition.rows),
                                    definition.iterations, rules_));
}

// Expansions

void I8080Pass::call(const Macro& macro, std::size_t operands) {
  const Arguments arguments = arguments_of(statement_.text, operands);
  if (arguments.unclosed != std::string_view::npos)
    return error(arguments.unclosed, "'<' without '>'", "'>'");
  std::vector<std::string> texts = argument_texts(arguments);
  const std::size_t most = macro.parameters.size();
  if (texts.size() > most) {
    warning(arguments.list[most].column, std::to_string(texts.size()) + " arguments",
            "at most " + std::to_string(most) + " for " + macro.name);
  }
  texts.resize(most);
  push(std::make_unique<I8080Frame>(macro.name, place(0), macro.body, macro.parameters,
                                    std::vector<std::vector<std::string>>{std::move(texts)}, 1, rules_));
}

std::vector<std::string> I8080Pass::argument_texts(const Arguments& arguments) {
  std::vector<std::string> texts;
  for (const Argument& argument : arguments.list) {
    if (!argument.evaluate) {
      texts.push_back(argument.text);
      continue;
    }
    read_operands(argument.column);
    const auto value = constant_value("a value");
    if (value && !token_.is(',')) expect_end();
    texts.push_back(in_radix(value.value_or(0), radix_));
  }
  return texts;
}

void I8080Pass::exit_macro() {
  const auto innermost =
      std::find_if(frames_.rbegin(), frames_.rend(), [](const auto& frame) { return frame->is_expansion(); });
  if (innermost == frames_.rend()) return error(0, "EXITM", "it inside a macro or repeat");
  for (auto frame = frames_.rbegin(); frame != innermost + 1; ++frame) (*frame)->finish();
  conditionals_.resize((*innermost)->conditionals);
}

void I8080Pass::push(std::unique_ptr<I8080Frame> frame) {
  if (frames_.size() >= most_frames) {
    error(0, "more than " + std::to_string(most_frames) + " macros and files inside each other",
          "a recursion that ends");
    engine_.stop();
    return;
  }
  frame->conditionals = conditionals_.size();
  frames_.push_back(std::move(frame));
}

}  // namespace sightline::assembler
