// Directives of a single statement: data, location, symbols, files. i8080/blocks.cpp has those that enclose lines.
#include <algorithm>
#include <utility>

#include "tools/asm/i8080/pass.hpp"

namespace sightline::assembler {
namespace {

constexpr std::uint8_t last_character_mark = 0x80;

// A name in INCLUDE is relative to the file it is in.
std::string path_beside(std::string_view including, std::string_view name) {
  const std::size_t slash = including.find_last_of("/\\");
  if (slash == std::string_view::npos || name.starts_with('/')) return std::string(name);
  return std::string(including.substr(0, slash + 1)) + std::string(name);
}

std::vector<std::string> candidate_names(std::string_view name, bool library) {
  std::vector<std::string> names{std::string(name)};
  const std::string lower = lower_case(name);
  if (library && name.find('.') == std::string_view::npos) {
    const std::string as_written(name);
    names = {as_written + ".LIB", as_written + ".lib", lower + ".lib", as_written};
  }
  names.push_back(lower);
  return names;
}

}  // namespace

void I8080Pass::directive(Directive directive, const Head& head) {
  switch (directive) {
    case Directive::org: return origin();
    case Directive::equ: return equate(head, SymbolKind::constant);
    case Directive::set: return equate(head, SymbolKind::assigned);
    case Directive::db: return data_bytes(false);
    case Directive::dc: return data_bytes(true);
    case Directive::dw: return data_words();
    case Directive::ds: return space();
    case Directive::end: return end_of_program();
    case Directive::macro: return define_macro(head);
    case Directive::endm: return error(head.operation_at, "ENDM", "a MACRO, REPT, IRP or IRPC before it");
    case Directive::local: return error(head.operation_at, "LOCAL", "it inside a macro");
    case Directive::rept:
    case Directive::irp:
    case Directive::irpc: return repeat(directive);
    case Directive::exitm: return exit_macro();
    case Directive::include: return include(false);
    case Directive::maclib: return include(true);
    case Directive::external: return externals();
    case Directive::public_: return publics();
    case Directive::cpu: return processor();
    case Directive::z80:
      return error(head.operation_at, quoted(head.word), "8080 source with Intel's mnemonics");
    case Directive::radix: return radix();
    case Directive::phase:
    case Directive::dephase: return phase(head);
    case Directive::comment: return comment(head);
    case Directive::common: return common();
    case Directive::segment: return enter_segment(head.operation);
    case Directive::title:
    case Directive::ignored: return;
    default: return conditional(directive, head);
  }
}

void I8080Pass::equate(const Head& head, SymbolKind kind) {
  if (head.label.empty())
    return error(head.operation_at, quoted(head.word) + " without a name", "NAME before it");
  const auto value = expression();
  if (!value) return;
  if (!expect_end()) return;
  enter(head.label, head.label_at, kind, *value);
  shown_value_ = value->bits;
  shown_equated_ = true;
}

void I8080Pass::data_bytes(bool mark_last) {
  do {
    if (token_.is(',')) advance();
    if (data_string(mark_last)) continue;
    const std::size_t at = token_.column;
    const auto value = expression();
    emit(value ? byte_of(*value, at).value_or(0) : std::uint8_t{0});
    if (!value) return;
  } while (token_.is(','));
  expect_end();
}

// A string alone between commas is data; a string in an expression is not.
bool I8080Pass::data_string(bool mark_last) {
  if (token_.kind != I8080TokenKind::string) return false;
  const I8080Token after = I8080Lexer(lexer_).next();
  if (after.kind != I8080TokenKind::end && !after.is(',')) return false;
  const std::string& text = token_.value;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(text[i]);
    emit(mark_last && i + 1 == text.size() ? static_cast<std::uint8_t>(byte | last_character_mark) : byte);
  }
  advance();
  return true;
}

void I8080Pass::data_words() {
  do {
    if (token_.is(',')) advance();
    const auto value = expression();
    const std::uint32_t word = value ? value->bits : 0;
    emit(static_cast<std::uint8_t>(word));
    emit(static_cast<std::uint8_t>(word >> 8));
    if (!value) return;
  } while (token_.is(','));
  expect_end();
}

// Without a fill byte the bytes stay undefined: they do not appear in a HEX file. They may run past FFFF, as in ASM and MAC:
// values begin again at 0, but a byte there needs an ORG.
void I8080Pass::space() {
  const auto size = constant_value("a size");
  if (!size) return;
  shown_value_ = statement_location_ % memory_end;
  if (token_.is(',')) {
    advance();
    const std::size_t fill_at = token_.column;
    const auto fill = expression();
    const std::uint8_t byte = fill ? byte_of(*fill, fill_at).value_or(0) : std::uint8_t{0};
    count_lines(*size / hexadecimal_bytes.cells_a_row);
    for (std::uint32_t i = 0; i < *size && !reported_overflow_ && !engine_.stopped(); ++i) emit(byte);
    if (!fill) return;
  } else {
    location_ += *size;
    if (location_ >= memory_end) location_ = memory_end + location_ % memory_end;
  }
  expect_end();
}

void I8080Pass::origin() {
  const auto address = constant_value("an address");
  if (!address || !expect_end()) return;
  if (phase_ != 0) return error(0, "ORG", ".DEPHASE before it");
  leave_common();
  // Other segments may continue at the location of this one.
  const std::size_t counter = counter_of_[segment_];
  counters_[counter] = location_;
  const bool shared = std::any_of(counter_of_.begin(), counter_of_.end(), [&](const auto& each) {
    return each.first != segment_ && each.second == counter;
  });
  if (shared) {
    counter_of_[segment_] = counters_.size();
    counters_.push_back(*address);
  }
  location_ = *address;
  reported_overflow_ = false;
  shown_value_ = *address;
}

void I8080Pass::end_of_program() {
  if (!at_end()) {
    const std::size_t at = token_.column;
    const auto start = expression();
    if (start && expect_end() && engine_.final()) {
      if (program_.start && *program_.start != start->bits) warning(at, "a second start address", "one");
      program_.start = static_cast<std::uint16_t>(start->bits);
    }
  }
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
    (*frame)->finish();
    if (!(*frame)->is_expansion()) return;
  }
}

void I8080Pass::include(bool library) {
  const std::size_t at = std::min(token_.column, statement_.text.size());
  std::string_view name = statement_.text.substr(at, start_of_comment(statement_.text, at) - at);
  while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
  const std::string_view ends = "''\"\"<>";
  for (std::size_t i = 0; i < ends.size() && name.size() > 1; i += 2) {
    if (name.front() == ends[i] && name.back() == ends[i + 1]) name = name.substr(1, name.size() - 2);
  }
  if (name.empty()) return error(at, "no name", "the name of a file");
  const auto in_file =
      std::find_if(frames_.rbegin(), frames_.rend(), [](const auto& f) { return !f->is_expansion(); });
  const std::string& including = engine_.file((*in_file)->file()).name;
  for (const std::string& written : candidate_names(name, library)) {
    const auto file = engine_.include(path_beside(including, written), options_.include);
    if (!file) continue;
    for (const auto& frame : frames_) {
      if (!frame->is_expansion() && frame->file() == *file)
        return error(at, quoted(name) + ", which is being read", "a file that does not include itself");
    }
    push(std::make_unique<I8080Frame>(*file, engine_.file(*file).text, rules_));
    return;
  }
  error(at, quoted(name) + ", which cannot be read", "a file beside " + including);
}

void I8080Pass::externals() {
  const auto names = names_list("a name");
  if (!names) return;
  for (const std::string& name : *names) engine_.declare(name, true);  // defined in another source of this program, or never used
}

void I8080Pass::publics() {
  const std::size_t at = token_.column;
  const auto names = names_list("a name");
  if (!names) return;
  for (const std::string& name : *names) {
    engine_.declare(name, false);
    publics_.emplace_back(name, place(at));
  }
}

// .RADIX n: n itself is decimal.
void I8080Pass::radix() {
  const std::size_t at = std::min(token_.column, statement_.text.size());
  lexer_ = I8080Lexer(statement_.text, at, rules_);
  advance();
  if (token_.kind != I8080TokenKind::number || token_.number < 2 || token_.number > 16)
    return unexpected("a radix of 2 to 16, decimal");
  radix_ = token_.number;
  advance();
  expect_end();
}

// .PHASE address: labels and `$` have the values of a program at that address; the bytes stay where they are.
void I8080Pass::phase(const Head& head) {
  if (head.operation == ".dephase") {
    phase_ = 0;
    expect_end();
    return;
  }
  const auto address = constant_value("an address");
  if (!address || !expect_end()) return;
  phase_ = (std::uint32_t{*address} - location_) & 0xFFFFU;
}

// .COMMENT *...*: the comment ends at the second occurrence of its first character.
void I8080Pass::comment(const Head& head) {
  const std::string_view text = statement_.text;
  const std::size_t at = skip_blanks(text, head.operands);
  if (at >= text.size()) return error(head.operation_at, ".COMMENT without a sign", "`.COMMENT *`, and `*` again at its end");
  if (text.find(text[at], at + 1) != std::string_view::npos) return;
  comment_end_ = text[at];
  comment_begun_ = place(head.operation_at);
}

// COMMON /NAME/: the bytes up to the next segment share the addresses of the first block of that name.
void I8080Pass::common() {
  leave_common();
  std::string_view text = statement_.text.substr(std::min(token_.column, statement_.text.size()));
  text = text.substr(0, start_of_comment(text, 0));
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  if (text.size() < 2 || text.front() != '/' || text.back() != '/') return unexpected("/NAME/");
  block_opened_ = place(token_.column);
  open_block_ = folded(text.substr(1, text.size() - 2));
  const auto [block, first] = blocks_.try_emplace(*open_block_, Block{location_, 0});
  if (first) return;
  behind_block_ = location_;
  location_ = block->second.begins;
}

void I8080Pass::enter_segment(const std::string& name) {
  leave_common();
  if (phase_ != 0) return error(0, quoted(name), ".DEPHASE before it");
  const std::size_t before = counter_of_[segment_];
  counters_[before] = location_;
  location_ = counters_[counter_of_.try_emplace(name, before).first->second];
  segment_ = name;
}

void I8080Pass::leave_common() {
  if (!open_block_) return;
  Block& block = blocks_[*open_block_];
  const std::uint32_t size = (location_ - block.begins) % memory_end;  // DS may have run past FFFF
  if (behind_block_) {
    if (size > block.size) {
      report(Severity::error, block_opened_, std::to_string(size) + " bytes of COMMON /" + *open_block_ + "/",
          "at most the " + std::to_string(block.size) + " of its first block");
    }
    location_ = *behind_block_;
  } else {
    block.size = size;
  }
  behind_block_.reset();
  open_block_.reset();
}

void I8080Pass::processor() {
  if (token_.text != "8080" && !token_.is_name("i8080")) unexpected("8080");
}

}  // namespace sightline::assembler
