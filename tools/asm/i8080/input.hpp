// The sources of the lines of an 8080 assembly: files, and the expansions of macros and repeats inside them,
// stacked.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/asm/i8080/macro.hpp"
#include "tools/asm/source.hpp"

namespace sightline::assembler {

struct I8080Statement {
  std::string_view text;
  std::size_t offset = 0;  // in its line
  bool begins_line = false;
};

// One open file or expansion. Lines are fetched one by one, statements cut off them one by one, so that what
// follows a macro call on its line comes after the expansion.
class I8080Frame {
 public:
  // A file. `text` and the rules must outlive the frame.
  I8080Frame(std::size_t file, std::string_view text, const I8080Rules& rules) : rules_(&rules), file_(file), rest_(text) {}
  // An expansion: the body `iterations` times. In each the row of texts with its number stands for `names`
  // (there are no rows if there are no names), and texts of its own for the local names.
  I8080Frame(std::string name, Position called, std::shared_ptr<const Body> body,
             std::vector<std::string> names, std::vector<std::vector<std::string>> rows,
             std::size_t iterations, const I8080Rules& rules);

  // The next line, or false at the end. `new_local` makes a name that is nowhere else.
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
  // Where a character of the current line was written.
  [[nodiscard]] Position place(std::size_t offset) const;
  [[nodiscard]] bool is_expansion() const { return body_ != nullptr; }
  [[nodiscard]] std::size_t file() const { return file_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Position called() const { return called_; }
  // Reads no further line, and no further statement of this one.
  void finish();

  std::size_t conditionals = 0;    // open when this was entered
  std::optional<std::size_t> row;  // of the listing, for the current line
  bool row_filled = false;

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
  std::size_t cursor_ = 1;  // behind the end: no line yet
  std::string unclosed_;    // of this line, see end_of_statement
  Expansion expanded_;
  Position body_place_;
};

}  // namespace sightline::assembler
