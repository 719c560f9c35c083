// The lines of a text file as fields, and the numbers in them: the common part of
// the readers of OFF, OBJ and STL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

// Line by line, or field by field: comments from # to the end of the line and empty lines are passed over, a backslash at
// the end of a line joins the next one to it. Lines end with LF, CRLF or CR.
class PolyLines {
 public:
  PolyLines(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  // The next line with a field in it; false at the end of the file.
  [[nodiscard]] bool next();
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }
  // The next field, of this line or of a later one; empty at the end of the file.
  std::string_view take() { return taken_ == fields_.size() && !next() ? std::string_view() : fields_[taken_++]; }
  // The fields of this line that were not taken.
  [[nodiscard]] std::span<const std::string_view> rest() const { return std::span(fields_).subspan(taken_); }
  [[nodiscard]] bool at_first_field() const { return taken_ == 0; }
  // What follows the current line, divided into parts of about equal length, each of whole lines; a part may be empty.
  [[nodiscard]] std::vector<std::string_view> parts(std::size_t count) const;
  // Takes so many of them.
  void pass_over(std::size_t count) { taken_ += count; }
  // Error at the line last read, or at the end of the file when next() was false.
  [[nodiscard]] base::Error error(const std::string& cause) const;
  // "found X, expected WHAT"; no field is the end of the file.
  [[nodiscard]] base::Error unexpected(std::string_view found, const std::string& expected) const;

 private:
  // Adds the fields of the line at at_, and passes over it; true if the next line continues it.
  bool split_line();

  std::string_view text_;
  std::string source_;
  std::size_t at_ = 0;  // in text_, where the next line begins
  std::vector<std::string_view> fields_;
  std::size_t taken_ = 0;
  std::size_t next_number_ = 1;
  std::size_t number_ = 0;  // 0: before the first line or behind the last
};

// How many lines have fields: so often next() is true.
[[nodiscard]] std::size_t count_lines(std::string_view text);

// A coordinate: a decimal number, or NaN for all spellings of what is no finite number ("nan", "-inf", "1.#IND", "1e999").
// Empty for everything else.
[[nodiscard]] std::optional<double> coordinate_of(std::string_view field);

// What to do about a file that no program writes like this.
inline constexpr const char* export_again = "the file is damaged: export it again";

// A name as scenes have them: at most 200 characters, and "?" for what is not printable ASCII.
[[nodiscard]] std::string printable_name(std::string text);

// At most 40 characters of what a file says, without those that are not printable ASCII.
[[nodiscard]] std::string quoted_excerpt(std::string_view text);

}  // namespace sightline::scene
