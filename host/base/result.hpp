// The one error type of host/ and tools/: a Result is a value, or the Error that says why there is none. An Error names
// the file, the place in it, what was found there, what would be accepted and what to do.
//
// The interface is a part of tl::expected's and C++23 std::expected's. Neither is used: tl/expected.hpp includes
// <functional>, which makes each source 21,500 lines longer than <variant> does (g++ 12).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace sightline::base {

// The format of a message.
enum class MessageStyle : std::uint8_t {
  plain,     // "FILE: PLACE: FOUND, expected EXPECTED; REMEDY"
  position,  // "FILE:PLACE: found FOUND, expected EXPECTED; REMEDY": PLACE is a line and column
  compiler,  // "FILE:PLACE: error: found FOUND, expected EXPECTED; REMEDY": what editors recognise
};

// The kind of failure. It determines the exit code of a command (host/app/command.hpp).
enum class ErrorKind : std::uint8_t {
  bad_input,       // a file, a scene or a request is wrong
  usage,           // an option or argument is wrong
  program_failed,  // the program on an emulated machine did not finish correctly
  differs,         // results that must be equal differ
  io,              // something cannot be read, written or started
  cancelled,       // ended early, as its caller wished
};

// Any text may be empty; a message omits empty texts. Commands and experiments throw an Error; all others return it in a Result.
struct Error {
  std::string file = {};      // file, scene or option, as the user named it
  std::string place = {};     // "line 3", "byte 41", "openings[3].rect", "3:12" (line:column, from 1)
  std::string found = {};     // what was found, or the whole complaint
  std::string expected = {};  // what would be accepted
  std::string remedy = {};    // what to do about it
  std::string excerpt = {};   // lines of the input that point at the place, shown below the message
  ErrorKind kind = ErrorKind::bad_input;

  // Without a line end. One line unless there is an excerpt.
  [[nodiscard]] std::string message(MessageStyle style = MessageStyle::plain) const;

  friend bool operator==(const Error&, const Error&) = default;
};

// An Error that consists of one complaint: "the eye is inside a solid".
[[nodiscard]] inline Error error_of(ErrorKind kind, std::string_view complaint) {
  return {.found = std::string(complaint), .kind = kind};
}
[[nodiscard]] inline Error bad_input(std::string_view complaint) { return error_of(ErrorKind::bad_input, complaint); }
[[nodiscard]] inline Error usage_error(std::string_view complaint) { return error_of(ErrorKind::usage, complaint); }
[[nodiscard]] inline Error program_failed(std::string_view complaint) { return error_of(ErrorKind::program_failed, complaint); }
[[nodiscard]] inline Error difference(std::string_view complaint) { return error_of(ErrorKind::differs, complaint); }
[[nodiscard]] inline Error io_error(std::string_view complaint) { return error_of(ErrorKind::io, complaint); }

// Reports a defect of this program where no error can be returned. Throws std::logic_error; aborts if the program is compiled
// without exceptions.
[[noreturn]] void give_up(const std::string& fault);

// The value of a Result that only says that work succeeded: a file was written, a check passed.
struct Done {
  friend bool operator==(Done, Done) = default;
};

// `if (result)`: it is a value. Reading the value of an error, or the error of a value, is a defect of the caller and throws
// std::bad_variant_access. E is Error, or a list of errors for checks that continue after the first one.
template <class T, class E = Error>
class [[nodiscard]] Result {
 public:
  using value_type = T;
  using error_type = E;

  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(E error) : state_(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool has_value() const { return state_.index() == 0; }
  [[nodiscard]] explicit operator bool() const { return has_value(); }

  [[nodiscard]] const T& operator*() const& { return std::get<0>(state_); }
  [[nodiscard]] T& operator*() & { return std::get<0>(state_); }
  [[nodiscard]] T&& operator*() && { return std::get<0>(std::move(state_)); }
  [[nodiscard]] const T& value() const& { return **this; }
  [[nodiscard]] T& value() & { return **this; }
  [[nodiscard]] T&& value() && { return *std::move(*this); }
  [[nodiscard]] const T* operator->() const { return &std::get<0>(state_); }
  [[nodiscard]] T* operator->() { return &std::get<0>(state_); }

  [[nodiscard]] const E& error() const& { return std::get<1>(state_); }
  [[nodiscard]] E& error() & { return std::get<1>(state_); }
  [[nodiscard]] E&& error() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, E> state_;
};

}  // namespace sightline::base
