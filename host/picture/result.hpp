// A value, or why there is none: what every reader and writer of picture files answers. Errors name the file,
// the place in it, what was found and what was expected, so that a person can mend the file without reading
// code.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace sightline::picture {

struct FileError {
  std::string file;      // as the user named it
  std::string place;     // "line 3", "byte 41"; empty: the file as a whole
  std::string found;     // what is there, or the system's reason
  std::string expected;  // empty: nothing to add

  // One line without a line end: "FILE: PLACE: FOUND, expected EXPECTED".
  [[nodiscard]] std::string message() const {
    std::string text = file;
    if (!place.empty()) text += ": " + place;
    text += ": " + found;
    if (!expected.empty()) text += ", expected " + expected;
    return text;
  }
};

struct Done {};

template <typename Value>
class [[nodiscard]] Result {
 public:
  Result(Value value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(FileError error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] explicit operator bool() const { return state_.index() == 0; }
  // Only for a Result that is true, and false, respectively.
  [[nodiscard]] const Value& operator*() const { return *std::get_if<0>(&state_); }
  [[nodiscard]] Value& operator*() { return *std::get_if<0>(&state_); }
  [[nodiscard]] const Value* operator->() const { return std::get_if<0>(&state_); }
  [[nodiscard]] Value* operator->() { return std::get_if<0>(&state_); }
  [[nodiscard]] const FileError& error() const { return *std::get_if<1>(&state_); }

 private:
  std::variant<Value, FileError> state_;
};

}  // namespace sightline::picture
