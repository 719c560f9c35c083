// What readers of JSON say of text that is not as expected.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::scene {

// `what` is the text of the library's exception, "[...] parse error at line L, column C: cause". The place is
// line and column.
[[nodiscard]] base::Error json_syntax_error(std::string_view source, std::string_view what);

// "openings[3]"
[[nodiscard]] std::string indexed(std::string_view place, std::size_t i);

// A value in few words. A template, so that only those who read JSON compile the library.
template <class Json>
[[nodiscard]] std::string describe_json(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  if (value.is_string()) return "a string";
  return value.dump();
}

}  // namespace sightline::scene
