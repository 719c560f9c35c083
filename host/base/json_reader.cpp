#include "host/base/json_reader.hpp"

#include <algorithm>

namespace sightline::base {

void JsonReader::fail(const std::string& place, std::string complaint) {
  if (!error_) error_ = Error{.file = file_, .place = place, .found = std::move(complaint)};
}

void JsonReader::expected(const std::string& what, const Json& found, const std::string& place) {
  fail(place, "expected " + what + ", found " + describe(found));
}

const Json* JsonReader::field(const Json& object, const char* name, const std::string& place) {
  const Json* const found = optional_field(object, name, place);
  if (found == nullptr) fail(place, std::string("expected a field \"") + name + "\", found none");
  return found;
}

const Json* JsonReader::optional_field(const Json& object, const char* name, const std::string& place) {
  if (failed()) return nullptr;
  if (object.is_object()) return object.find(name);
  expected("an object", object, place);
  return nullptr;
}

bool JsonReader::array(const Json& value, const std::string& place, std::optional<std::size_t> size) {
  if (failed()) return false;
  if (value.is_array() && (!size || value.size() == *size)) return true;
  expected(size ? "an array of " + std::to_string(*size) : "an array", value, place);
  return false;
}

std::int64_t JsonReader::integer(const Json& value, const std::string& place, std::int64_t low,
                                 std::int64_t high) {
  if (failed()) return low;
  const std::optional<std::int64_t> integer = value.integer();
  if (integer && *integer >= low && *integer <= high) return *integer;
  expected("an integer " + std::to_string(low) + ".." + std::to_string(high), value, place);
  return low;
}

bool JsonReader::boolean(const Json& value, const std::string& place) {
  if (failed()) return false;
  const std::optional<bool> boolean = value.boolean();
  if (!boolean) expected("true or false", value, place);
  return boolean.value_or(false);
}

std::string JsonReader::name(const Json& value, const std::string& place, std::size_t least,
                             std::size_t most) {
  if (failed()) return {};
  const std::string* const text = value.text();
  const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
  if (text != nullptr && text->size() >= least && text->size() <= most &&
      std::all_of(text->begin(), text->end(), printable))
    return *text;
  const std::string length = (least == 0 ? "up to " : std::to_string(least) + " to ") + std::to_string(most);
  expected("a string of " + length + " printable ASCII characters", value, place);
  return {};
}

}  // namespace sightline::base
