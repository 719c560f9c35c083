// Where the lines of an 8080 assembly come from: a stack of files and of the expansions of macros and repeats.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/asm/i8080/macro.hpp"
#include "tools/asm/engine.hpp"

namespace sightline::assembler {

struct I8080Statement {
  std::string_view text;
  std::size_t offset = 0;  // in its line
  bool begins_line = false;
};

// One open file or expansion. It is read line by line and each line statement by statement, so that the statements
// after a macro call follow its expansion.
class I8080Frame {
 public:
  // A file. `text` and the rules must outlive the frame.
  I8080Frame(std::size_t file, std::string_view text, const I8080Rules& rules) : rules_(&rules), file_(file), rest_(text) {}
  // An expansion: the body `iterations` times. Iteration i replaces `names` by the texts of row i
  // (no rows if there are no names), and the local names by unique ones.
  I8080Frame(std::string name, Position called, std::shared_ptr<const Body> body,
             std::vector<std::string> names, std::vector<std::vector<std::string>> rows,
             std::size_t iterations, const I8080Rules& rules);

  // Reads the next line; false at the end. `new_local` makes a unique name.
  template <class NewLocal>
  bool next_line(NewLocal&& new_local) {
    cursor_ = 0;
    unclosed_.clear();
    if (!body_) return next_file_line();
    if (next_ == body_->lines.size()) {
      if (iteration_ >= iterations_ || body_->lines.empty()) return false;
      texts_ = rows_.empty() ? std::vector<std::string>() : rows_[iteration_];
      for (std::size_t i = 0; i < body_->locals.size(); ++i) texts_.push_back(new_local());
      ++iteration_;
      next_ = 0;
    }
    expand(body_->lines[next_++]);
    return true;
  }
  [[nodiscard]] std::optional<I8080Statement> next_statement();

  [[nodiscard]] std::string_view line() const { return line_; }
  // Where the character at `offset` of the current line was written.
  [[nodiscard]] Position place(std::size_t offset) const;
  [[nodiscard]] bool is_expansion() const { return body_ != nullptr; }
  [[nodiscard]] std::size_t file() const { return file_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Position called() const { return called_; }
  // Reads no further line and no further statement of this line.
  void finish();

  std::size_t conditionals = 0;    // open when this frame was entered
  ListedLine listed;               // the current line

 private:
  bool next_file_line();
  void expand(const BodyLine& line);

  const I8080Rules* rules_;
  std::size_t file_ = 0;
  std::string_view rest_;
  std::size_t line_number_ = 0;
  std::string name_;
  Position called_;
  std::shared_ptr<const Body> body_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
  std::size_t iterations_ = 0;
  std::size_t iteration_ = 0;
  std::size_t next_ = 0;
  std::vector<std::string> texts_;  // of this iteration, in the order of names_
  std::string_view line_;
  std::size_t cursor_ = 1;  // past the end: no line yet
  std::string unclosed_;    // of this line, see end_of_statement
  Expansion expanded_;
  Position body_place_;
};

}  // namespace sightline::assembler
