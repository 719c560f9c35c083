// What was wrong with an image file, and where: the only way a reader or a writer here fails.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace sightline::image {

struct Error {
  std::string file;
  std::string
      place;  // "byte 17" for a tape (from 0), "3:12" (line:column, from 1) for a text, empty for the whole
  std::string found;
  std::string expected;
};

// "file:place: error: found X, expected Y"
[[nodiscard]] std::string to_string(const Error& error);

// A value or an error. `if (result)` asks for the value; reading the other one throws std::bad_variant_access.
template <class T>
class Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::move(error)) {}

  [[nodiscard]] explicit operator bool() const { return std::holds_alternative<T>(content_); }
  [[nodiscard]] const T& value() const { return std::get<T>(content_); }
  [[nodiscard]] const Error& error() const { return std::get<Error>(content_); }

 private:
  std::variant<T, Error> content_;
};

// Digits in octal with leading zeros.
[[nodiscard]] std::string octal(std::uint32_t value, unsigned digits);

}  // namespace sightline::image
