// Reads the values of a JSON document and says where one is not as expected.
//
// A reader remembers the first error and its place ("openings[3].rect"). After it every read returns a
// default and the rest of the document is passed over, so that a caller checks failed() once, at its end.
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

  // The value of a member; null if `object` has none, which is an error, or is no object.
  [[nodiscard]] const Json* field(const Json& object, const char* name, const std::string& place);
  // The same, where a member may be missing.
  [[nodiscard]] const Json* optional_field(const Json& object, const char* name, const std::string& place);

  // Whether it is an array, of `size` elements if given.
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
