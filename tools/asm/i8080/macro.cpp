#include "tools/asm/i8080/macro.hpp"

#include <algorithm>
#include <optional>

#include "tools/asm/i8080/lexer.hpp"

namespace sightline::assembler {
namespace {

// Where the comment begins; a semicolon after the literal sign does not begin one.
std::size_t end_of_arguments(std::string_view text, std::size_t at, char literal) {
  std::size_t end = start_of_comment(text, at);
  while (end < text.size() && end > at && text[end - 1] == literal) end = start_of_comment(text, end + 1);
  return end;
}

class ArgumentSplitter {
 public:
  ArgumentSplitter(std::string_view text, std::size_t at, const I8080Rules& rules)
      : literal_(rules.literal), pairs_are_one_(rules.arguments_are_scanned), capitals_(rules.arguments_are_capitals), blanks_end_(rules.blanks_separate_arguments), text_(text.substr(0, end_of_arguments(text, at, literal_))), at_(skip_blanks(text_, at)) {}

  Arguments split() {
    if (at_ >= text_.size()) return {};
    Arguments arguments;
    while (true) {
      arguments.list.push_back(argument());
      arguments.bang = bang_;
      if (unclosed_ != std::string_view::npos) arguments.unclosed = unclosed_;
      if (at_ >= text_.size() || (blanks_end_ && skip_blanks(text_, at_) >= text_.size())) return arguments;
      ++at_;  // the comma or blank
    }
  }

 private:
  Argument argument() {
    at_ = skip_blanks(text_, at_);
    Argument argument;
    argument.column = at_;
    if (at_ < text_.size() && text_[at_] == '%') {
      argument.evaluate = true;
      argument.column = ++at_;
    }
    std::size_t kept = 0;  // length up to which blanks are not trimmed
    while (at_ < text_.size() && text_[at_] != ',') {
      const char c = text_[at_];
      if (blanks_end_ && is_blank(c) && !argument.evaluate) break;
      if (c == '<' && !argument.evaluate) {
        bracketed(argument.text);
        kept = argument.text.size();
      } else if (c == literal_ && at_ + 1 < text_.size()) {
        argument.text += letter(text_[at_ + 1]);
        at_ += 2;
        kept = argument.text.size();
      } else if (c == '\'' || c == '"') {
        string(argument.text);
      } else {
        note_bang();
        argument.text += letter(c);
        ++at_;
      }
    }
    while (argument.text.size() > kept && is_blank(argument.text.back())) argument.text.pop_back();
    return argument;
  }

  void bracketed(std::string& text) {
    const std::size_t opened = at_++;
    bool in_string = false;  // as the rules count pairs of apostrophes
    bool keeps_letters = false;
    for (std::size_t depth = 1; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '>' && --depth == 0) {
        ++at_;
        return;
      }
      if (c == '<') ++depth;
      if (c == '\'') keeps_letters = !keeps_letters;
      if (blanks_end_ && (c == '\'' || c == '"')) {
        string(text);
        --at_;
        continue;
      }
      if (c == '\'' && depth == 1 && pairs_are_one_) {
        const bool again = at_ + 1 < text_.size() && text_[at_ + 1] == '\'';
        const bool empty = again && !in_string && (at_ + 2 >= text_.size() || text_[at_ + 2] != '\'');
        if (empty) text += c;
        if (empty || (again && in_string)) {
          ++at_;
        } else {
          in_string = !in_string;
        }
      }
      // Inside inner brackets the sign is kept for the macro that receives them.
      if (c == literal_ && at_ + 1 < text_.size()) {
        if (depth > 1) text += c;
        ++at_;
      } else {
        note_bang();
      }
      text += keeps_letters ? text_[at_] : letter(text_[at_]);
    }
    unclosed_ = opened;
  }

  void string(std::string& text) {
    const std::size_t end = end_of_string(text_, at_);
    const std::size_t length = end == std::string_view::npos ? 1 : end - at_;
    const std::string_view written = text_.substr(at_, length);
    at_ += length;
    if (!pairs_are_one_ || length < 3 || written.front() != '\'') {
      text += written;
      return;
    }
    // MAC turns two apostrophes into one at each call; the string keeps its quotes.
    text += '\'';
    for (std::size_t i = 1; i + 1 < length; ++i) {
      text += written[i];
      if (written[i] == '\'') ++i;
    }
    text += '\'';
  }

  [[nodiscard]] char letter(char c) const {
    return capitals_ && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }

  void note_bang() {
    if (text_[at_] == '!' && bang_ == std::string_view::npos) bang_ = at_;
  }

  char literal_;
  bool pairs_are_one_;
  bool capitals_;
  bool blanks_end_;
  std::string_view text_;
  std::size_t at_;
  std::size_t bang_ = std::string_view::npos;
  std::size_t unclosed_ = std::string_view::npos;
};

class Replacer {
 public:
  Replacer(std::string_view line, const std::vector<std::string>& names,
           const std::vector<std::string>& texts, const I8080Rules& rules)
      : line_(line), names_(names), texts_(texts), rules_(rules) {}

  Expansion replace() {
    while (at_ < line_.size() && expansion_.text.size() <= longest_line) {
      const char c = line_[at_];
      if (quote_ == 0 && c == ';') {
        copy(line_.size());
      } else if (rules_.arguments_are_scanned && quote_ == 0 && c == rules_.literal && at_ + 1 < line_.size() &&
                 begins_name(line_[at_ + 1])) {
        copy(end_of_name(line_, at_ + 1));
      } else if (begins_name(c)) {
        name();
      } else if (continues_name(c)) {
        copy(end_of_number());
      } else {
        if (c == quote_) {
          quote_ = 0;
        } else if (quote_ == 0 && (c == '\'' || c == '"')) {
          quote_ = c;
        }
        copy(at_ + 1);
      }
    }
    return std::move(expansion_);
  }

 private:
  // A letter inside a number (0FFH, 1$0000B) does not begin a name.
  [[nodiscard]] std::size_t end_of_number() const {
    std::size_t end = at_;
    while (end < line_.size() && continues_name(line_[end])) ++end;
    return end;
  }

  void copy(std::size_t end) {
    expansion_.text += line_.substr(at_, end - at_);
    at_ = end;
  }

  void name() {
    const std::size_t end = end_of_name(line_, at_);
    const bool joined_before = at_ > 0 && line_[at_ - 1] == '&';
    const bool joined_after = end < line_.size() && line_[end] == '&';
    const bool may_be = quote_ == 0 || joined_before || joined_after;
    const std::string_view written = line_.substr(at_, end - at_);
    // MAC folds only letters outside strings, so `&x` in a string is not its parameter X.
    const bool folds = quote_ == 0 || !rules_.arguments_are_capitals ||
                       std::none_of(written.begin(), written.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    const auto found =
        may_be && folds ? std::find(names_.begin(), names_.end(), key_of(written, rules_)) : names_.end();
    if (found == names_.end()) return copy(end);
    if (joined_before && dropped_ != at_) expansion_.text.pop_back();
    expansion_.origins.emplace_back(expansion_.text.size(), at_);
    expansion_.text += text_for(static_cast<std::size_t>(found - names_.begin()));
    at_ = joined_after ? end + 1 : end;
    if (joined_after) dropped_ = at_;
    expansion_.origins.emplace_back(expansion_.text.size(), at_);
  }

  // MAC scans the replacement text again and replaces the other parameters in it.
  [[nodiscard]] std::string text_for(std::size_t number) const {
    if (!rules_.arguments_are_scanned) return texts_[number];
    std::vector<std::string> others = names_;
    others[number].clear();
    const bool none_left = std::all_of(others.begin(), others.end(), [](const std::string& name) { return name.empty(); });
    if (none_left || texts_[number].size() > longest_line) return texts_[number];
    return Replacer(texts_[number], others, texts_, rules_).replace().text;
  }

  std::string_view line_;
  const std::vector<std::string>& names_;
  const std::vector<std::string>& texts_;
  const I8080Rules& rules_;
  std::size_t at_ = 0;
  std::size_t dropped_ = std::string_view::npos;  // the `&` before this offset has been removed
  char quote_ = 0;
  Expansion expansion_;
};

}  // namespace

Arguments split_arguments(std::string_view text, std::size_t from, const I8080Rules& rules) {
  return ArgumentSplitter(text, from, rules).split();
}

// All offsets inside a replacement map to the start of the name.
std::size_t Expansion::origin_of(std::size_t offset) const {
  std::pair<std::size_t, std::size_t> before{0, 0};
  bool inside = false;
  for (std::size_t i = 0; i < origins.size() && origins[i].first <= offset; ++i) {
    before = origins[i];
    inside = i % 2 == 0;
  }
  return inside ? before.second : before.second + (offset - before.first);
}

Expansion replace_names(std::string_view line, const std::vector<std::string>& names,
                        const std::vector<std::string>& texts, const I8080Rules& rules) {
  return Replacer(line, names, texts, rules).replace();
}

}  // namespace sightline::assembler
