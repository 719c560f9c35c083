#include "tools/asm/i8080/input.hpp"

#include <algorithm>
#include <utility>

#include "tools/asm/i8080/lexer.hpp"

namespace sightline::assembler {

I8080Frame::I8080Frame(std::string name, Position called, std::shared_ptr<const Body> body,
                       std::vector<std::string> names, std::vector<std::vector<std::string>> rows,
                       std::size_t iterations, const I8080Rules& rules)
    : rules_(&rules),
      name_(std::move(name)),
      called_(called),
      body_(std::move(body)),
      names_(std::move(names)),
      rows_(std::move(rows)),
      iterations_(iterations),
      next_(body_->lines.size()) {
  names_.insert(names_.end(), body_->locals.begin(), body_->locals.end());
}

bool I8080Frame::next_file_line() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line_ = rest_.substr(0, end);
  if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++line_number_;
  return true;
}

void I8080Frame::expand(const BodyLine& line) {
  body_place_ = line.at;
  expanded_ = replace_names(line.text, names_, texts_, *rules_);
  line_ = expanded_.text;
}

std::optional<I8080Statement> I8080Frame::next_statement() {
  if (cursor_ > line_.size()) return std::nullopt;
  const bool begins_line = cursor_ == 0;
  // MAC ends a comment at `!`, but a line with `*` in column 1 only at its end (MAC, section 2).
  const bool comment = begins_line && !line_.empty() && (line_[0] == '*' || (line_[0] == '$' && !rules_->dollar_in_names));
  const std::size_t end = comment ? line_.size() : end_of_statement(line_, cursor_, unclosed_, *rules_);
  const I8080Statement statement{line_.substr(cursor_, end - cursor_), cursor_, begins_line};
  cursor_ = end + 1;
  return statement;
}

Position I8080Frame::place(std::size_t offset) const {
  if (!body_) return {file_, line_number_, offset + 1};
  return {body_place_.file, body_place_.line, body_place_.column + expanded_.origin_of(offset)};
}

void I8080Frame::finish() {
  rest_ = {};
  cursor_ = line_.size() + 1;
  iterations_ = 0;
  if (body_) next_ = body_->lines.size();
}

}  // namespace sightline::assembler
