// The options of a call by their names, which are those of the members in C++ (host/bindings/cpp/hidden_lines.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/bindings/cpp/hidden_lines.hpp"

namespace sightline::npm {

// A value of JavaScript: of the kinds of values that an option can have, or a description of another one.
struct Value {
  enum class Type : std::uint8_t { number, truth, text, point, other };

  Type type = Type::other;
  Point numbers{};   // a truth is 0 or 1
  std::string text;
};

enum class Call : std::uint8_t { load, draw, file };

class Options {
 public:
  LoadOptions load;
  Camera camera;
  DrawOptions draw;
  FileOptions file;

  // Sets an option of a call. Error usage: it has no option of this name, or the value is of another kind.
  [[nodiscard]] base::Result<base::Done> set(Call call, std::string_view name, const Value& value);

  // The given members of `draw` as a text: with equal texts, views can share what is prepared.
  [[nodiscard]] const std::string& draw_text() const { return draw_text_; }

 private:
  std::string draw_text_;
};

}  // namespace sightline::npm
