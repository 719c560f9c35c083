// Reads the values of a JSON document and reports the place of the first one that is not as expected.
//
// A reader remembers the first error and its place ("openings[3].rect"). After it every read returns a default value
// and checks nothing; the caller checks failed() once, at the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "host/base/json.hpp"

namespace sightline::base {

class JsonReader {
 public:
  // `file`: the document's name in errors
  explicit JsonReader(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] const Error& error() const { return *error_; }

  void fail(const std::string& place, std::string complaint);
  // "expected WHAT, found VALUE"
  void expected(const std::string& what, const Json& found, const std::string& place);

  // The value of a member. If `object` has no such member or is no object: an error, and null.
  [[nodiscard]] const Json* field(const Json& object, const char* name, const std::string& place);
  // The same, but a missing member is no error.
  [[nodiscard]] const Json* optional_field(const Json& object, const char* name, const std::string& place);

  // Whether it is an array (of `size` elements, if given); an error if not.
  bool array(const Json& value, const std::string& place, std::optional<std::size_t> size = std::nullopt);
  std::int64_t integer(const Json& value, const std::string& place, std::int64_t low, std::int64_t high);
  bool boolean(const Json& value, const std::string& place);
  // A string of `least` to `most` printable ASCII characters.
  std::string name(const Json& value, const std::string& place, std::size_t least, std::size_t most);

  // Calls read(element, place of the element) for each element of an array, until one is not as expected.
  template <class Read>
  void each(const Json& value, const std::string& place, const Read& read) {
    if (!array(value, place)) return;
    for (std::size_t i = 0; i < value.size() && !failed(); ++i) read(value[i], indexed(place, i));
  }

 private:
  std::string file_;
  std::optional<Error> error_;
};

}  // namespace sightline::base
